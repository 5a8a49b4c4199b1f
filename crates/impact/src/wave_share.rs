//! The share of the energy of an impact radiated by elastic waves, for its own force pulse.

use carom_halfspace::Material;
use carom_special::RangeError;

use crate::closed_form::radiation_coefficient;
use crate::normal::NormalImpact;

/// The share of the kinetic energy of approach that this pulse radiates into a half-space of a
/// body's material and density; none for rigid and infinitely heavy bodies.
///
/// For a solid sphere on its own material it is (3.2).
pub(crate) fn wave_share(material: Material, density: f64, pulse: &NormalImpact) -> Option<f64> {
    RangeError::positive("density", density).ok()?;
    Some(pulse.wave_share(radiation_coefficient(material).ok()?, density))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closed_form::wave_loss;
    use approx::assert_relative_eq;
    use carom_halfspace::MaterialPair;
    use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
    use carom_laws::hertz::Hertz;

    #[test]
    fn a_sphere_on_its_own_material_loses_the_share_of_the_closed_form() {
        for (poisson, radius, velocity) in [(0.0, 0.01, 1.0), (0.3, 0.2, 0.03), (0.5, 1.0, 7.0)] {
            let steel = Material::from_young(208e9, poisson).unwrap();
            let (density, sphere) = (7850.0, PrincipalRadii::sphere(radius).unwrap());
            let gap = RelativeCurvature::new(sphere, PrincipalRadii::PLANE, 0.0).unwrap();
            let hertz = Hertz::new(gap, MaterialPair::new(steel, steel).unwrap()).unwrap();
            let mass = density * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
            let pulse = NormalImpact::new(1.0 / mass, hertz.stiffness().c_z, velocity).unwrap();
            let share = wave_share(steel, density, &pulse).unwrap();
            let rod_speed = f64::sqrt(208e9 / density);
            let expected = wave_loss(poisson, velocity, rod_speed).unwrap();
            assert_relative_eq!(share, expected, max_relative = 1e-13);
        }
        let rigid = Material::RIGID;
        let pulse = NormalImpact::new(1.0, 1.0, 1.0).unwrap();
        assert_eq!(wave_share(rigid, 1.0, &pulse).unwrap_or(0.0), 0.0);
        assert_eq!(wave_share(rigid, f64::INFINITY, &pulse), None);
    }
}
