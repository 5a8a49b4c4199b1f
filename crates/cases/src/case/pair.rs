//! Two surfaces in contact: radii and materials of `[body_1]` and `[body_2]`, and their angle.

use super::error::{CaseError, CaseFault};
use super::field::{Default, Field, Form};
use super::material::{self, MATERIAL};
use super::range::Range;
use super::section::Section;
use super::unit::Dimension;
use crate::PointOrLine;
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::{CurvatureError, PrincipalRadii, RelativeCurvature};
use carom_laws::hertz::Hertz;
use carom_laws::line::LineContact;

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

pub(super) const LENGTH: Field = Field::number(
    "length",
    Range::Positive.of(Dimension::Length),
    "length of the line along which cylinders with parallel axes touch",
)
.may("the bodies touch at a point")
.such_as("0.01");

/// Reads both bodies, which touch at a point, or along a line of `contact.length`; and their smallest radius of curvature.
///
/// # Errors
/// As [`read`]; also if a length is given for bodies that touch at a point.
pub(super) fn read_any(
    case: &Section<'_>,
    contact: Option<&Section<'_>>,
) -> Result<(PointOrLine, f64), CaseError> {
    let length = contact.map_or(Ok(None), |contact| contact.maybe(&LENGTH))?;
    let Some((contact, length)) = contact.zip(length) else {
        return read(case, contact)
            .map(|pair| (PointOrLine::Point(pair.hertz), pair.smallest_radius));
    };
    let (radii_1, material_1) = read_surface(case, &BODY_1)?;
    let (radii_2, material_2) = read_surface(case, &BODY_2)?;
    let angle = contact.number(&ANGLE)?;
    let materials = MaterialPair::new(material_1, material_2)
        .map_err(|error| case.out_of_range([&BODY_2, &MATERIAL], error.value, error.allowed))?;
    // The larger coefficient A is 1/(2 R).
    let found = match RelativeCurvature::new(radii_1, radii_2, angle.to_radians()) {
        Err(CurvatureError::LineContact { a, .. }) if a > 0.0 => {
            LineContact::new(0.5 / a, length, materials)
        }
        _ => {
            let reason = "for cylinders with parallel axes, or a cylinder and a plane; these bodies do not touch along a line";
            return Err(contact.out_of_range(&LENGTH, length, reason));
        }
    };
    let line = found.map_err(|error| contact.out_of_range(&LENGTH, error.value, error.allowed))?;
    Ok((PointOrLine::Line(line), PrincipalRadii::smallest([radii_1, radii_2])))
}

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
