//! Two surfaces in contact: radii and materials of `[body_1]` and `[body_2]`, and their angle.

use super::body::read_material;
use super::error::CaseError;
use super::range::Range;
use super::section::{Numbers, Section};
use super::unit::Dimension;
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::hertz::Hertz;

const FIELDS: &[&str] = &["radii", "material"];
const RADII: &str = "two principal radii [r, r_across] (inf: straight, negative: hollow)";

/// Reads both bodies and `contact.angle`, the angle in degrees from the first principal
/// direction of body 1 to that of body 2.
///
/// # Errors
/// If a field is missing, unknown or out of range, or the surfaces make no elliptical contact.
pub(super) fn read(case: &Section<'_>, contact: &Section<'_>) -> Result<Hertz, CaseError> {
    let (radii_1, material_1) = read_surface(case, "body_1")?;
    let (radii_2, material_2) = read_surface(case, "body_2")?;
    let angle = contact.number("angle", Range::Finite.of(Dimension::Degrees))?;
    let materials = MaterialPair::new(material_1, material_2)
        .map_err(|error| case.out_of_range("body_2.material", error.value, error.allowed))?;
    let curvature = RelativeCurvature::new(radii_1, radii_2, angle.to_radians())
        .map_err(CaseError::Curvature)?;
    Hertz::new(curvature, materials)
        .map_err(|error| case.out_of_range("body_1.radii", error.value, error.allowed))
}

fn read_surface(case: &Section<'_>, name: &str) -> Result<(PrincipalRadii, Material), CaseError> {
    let body = case.section(name, FIELDS)?;
    let radii = match body.numbers("radii", Range::Radius.of(Dimension::Length)) {
        Ok(Numbers::Sweep(radii)) => radii,
        Ok(Numbers::One(radius)) => vec![radius, radius],
        Err(CaseError::Missing { field, .. }) => {
            return Err(CaseError::Missing { field, allowed: RADII });
        }
        Err(error) => return Err(error),
    };
    let [radius, across] = radii.as_slice() else {
        return Err(body.out_of_range("radii", radii.len() as f64, RADII));
    };
    let radii = PrincipalRadii::new(*radius, *across)
        .map_err(|error| body.out_of_range("radii", error.value, error.allowed))?;
    Ok((radii, read_material(&body)?))
}
