//! Two surfaces in contact: radii and materials of `[body_1]` and `[body_2]`, and their angle.

use super::error::{CaseError, CaseFault};
use super::field::{Default, Field, Form};
use super::material::{self, MATERIAL};
use super::range::Range;
use super::section::Section;
use super::unit::Dimension;
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::hertz::Hertz;

const RADII: Field = Field::new(
    "radii",
    Form::Pair(Range::Radius.of(Dimension::Length)),
    "principal radii [r, r_across] (inf: straight, negative: concave); one number: both radii, a sphere or a plane",
)
.such_as("0.01");
const SURFACE: &[Field] = &[RADII, MATERIAL];
pub(super) const BODY_1: Field =
    Field::new("body_1", Form::Table(SURFACE), "the body on the side to which z points");
pub(super) const BODY_2: Field =
    Field::new("body_2", Form::Table(SURFACE), "the other body").begun(&[(&RADII, "inf")]);
pub(super) const ANGLE: Field = Field::number(
    "angle",
    Range::Finite.of(Dimension::Degrees),
    "from the first principal direction of body 1 to that of body 2",
)
.default(Default::Number(0.0));

/// Reads both bodies and `contact.angle`, the angle in degrees from the first principal
/// direction of body 1 to that of body 2; 0 without a table `[contact]`.
///
/// # Errors
/// If a field is missing, unknown or out of range, or the surfaces have no elliptical contact.
pub(super) fn read(case: &Section<'_>, contact: Option<&Section<'_>>) -> Result<Pair, CaseError> {
    let (radii_1, material_1) = read_surface(case, &BODY_1)?;
    let (radii_2, material_2) = read_surface(case, &BODY_2)?;
    let angle = contact.map_or(Ok(0.0), |contact| contact.number(&ANGLE))?;
    let materials = MaterialPair::new(material_1, material_2)
        .map_err(|error| case.out_of_range([&BODY_2, &MATERIAL], error.value, error.allowed))?;
    let curvature =
        RelativeCurvature::new(radii_1, radii_2, angle.to_radians()).map_err(|source| {
            let place = [&BODY_1, &RADII];
            let fault = CaseFault::Curvature { others: ", `body_2.radii`", source };
            fault.at(case.path(&place), case.line(place))
        })?;
    let hertz = Hertz::new(curvature, materials)
        .map_err(|error| case.out_of_range([&BODY_1, &RADII], error.value, error.allowed))?;
    Ok(Pair { hertz, smallest_radius: PrincipalRadii::smallest([radii_1, radii_2]) })
}

/// Two surfaces in contact.
pub(super) struct Pair {
    pub(super) hertz: Hertz,
    /// The smallest radius of curvature of both bodies, m, convex or concave.
    pub(super) smallest_radius: f64,
}

fn read_surface(
    case: &Section<'_>,
    field: &Field,
) -> Result<(PrincipalRadii, Material), CaseError> {
    let body = case.section(field)?;
    let [radius, across] = body.pair(&RADII)?;
    let radii = PrincipalRadii::new(radius, across)
        .map_err(|error| body.out_of_range(&RADII, error.value, error.allowed))?;
    Ok((radii, material::read(&body)?))
}
