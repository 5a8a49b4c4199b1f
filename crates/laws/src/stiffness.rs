//! The stiffness coefficients of an elliptical contact in the three directions (5.25).

use carom_halfspace::MaterialPair;
use carom_special::elliptic::complete;
use carom_special::{AxisRatio, RangeError};

use crate::bounds::constant;
use crate::curvature::RelativeCurvature;

/// Stiffness coefficients: full adhesion is `dF_i = c_i sqrt(zeta) d(shift_i)` (5.30), and
/// `F_z = (2/3) c_z zeta^(3/2)` (5.27). Units force/length^(3/2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactStiffness {
    /// Along x, the direction of semi-axis a.
    pub c_x: f64,
    /// Along y, the direction of semi-axis b.
    pub c_y: f64,
    /// Along the normal.
    pub c_z: f64,
}

impl ContactStiffness {
    /// From given coefficients, for example measured ones.
    ///
    /// # Errors
    /// [`RangeError`] unless all are from 1e-60 to 1e60, and c_x and c_y from 1e-30 to 1e30 times c_z: the energies
    /// of a shift are of the order `c_z^2/c_x`.
    pub fn new(c_x: f64, c_y: f64, c_z: f64) -> Result<Self, RangeError> {
        for (field, value) in [("c_x", c_x), ("c_y", c_y), ("c_z", c_z)] {
            constant(field, value)?;
        }
        for (field, value) in [("c_x", c_x), ("c_y", c_y)] {
            let holds = (1e-30..=1e30).contains(&(value / c_z));
            RangeError::check(field, value, holds, "from 1e-30 to 1e30 times c_z")?;
        }
        Ok(Self { c_x, c_y, c_z })
    }

    /// From the axis ratio of the contact, the combined Poisson's ratio and c_z: `c_x = c_z (1 -
    /// nu)/(1 - nu delta)`, `c_y = c_z (1 - nu)/(1 - nu + nu delta)` (5.25a).
    ///
    /// # Errors
    /// [`RangeError`] unless c_z is finite and positive and nu is in (-1, 0.5].
    pub fn from_axis_ratio(c_z: f64, ratio: AxisRatio, poisson: f64) -> Result<Self, RangeError> {
        RangeError::check("poisson", poisson, poisson > -1.0 && poisson <= 0.5, "in (-1, 0.5]")?;
        let k = complete::k(ratio);
        let (delta, one_less_delta) = (complete::d(ratio) / k, complete::b(ratio) / k);
        let c_x = c_z * (1.0 - poisson) / (1.0 - poisson * delta);
        let c_y = c_z * (1.0 - poisson) / (1.0 - poisson * one_less_delta);
        Self::new(c_x, c_y, c_z)
    }

    /// For two bodies with curved surfaces, with `c_z` by (5.25b): `c_z = 2 pi sqrt(D)/(sqrt(B)
    /// K^(3/2)) G/(1 - nu)`.
    ///
    /// # Errors
    /// [`RangeError`] if a coefficient over- or underflows.
    pub fn from_curvature(
        curvature: RelativeCurvature,
        ratio: AxisRatio,
        materials: &MaterialPair,
    ) -> Result<Self, RangeError> {
        let k = complete::k(ratio);
        let modulus = materials.shear_modulus() / (1.0 - materials.poisson());
        let shape = (complete::d(ratio) / (curvature.b() * k)).sqrt() / k;
        let c_z = 2.0 * std::f64::consts::PI * shape * modulus;
        Self::from_axis_ratio(c_z, ratio, materials.poisson())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn circle_is_mindlins() {
        // (5.30): c_x sqrt(zeta) = 8 G a/(2 - nu), c_z sqrt(zeta) = 4 G a/(1 - nu).
        let nu = 0.3;
        let c = ContactStiffness::from_axis_ratio(4.0 / (1.0 - nu), AxisRatio::CIRCLE, nu).unwrap();
        assert_relative_eq!(c.c_x, 8.0 / (2.0 - nu), max_relative = 1e-15);
        assert_relative_eq!(c.c_y, c.c_x, max_relative = 1e-15);
    }

    #[test]
    fn exchanged_axes_exchange_the_coefficients() {
        let ratio = AxisRatio::new(0.2).unwrap();
        let one = ContactStiffness::from_axis_ratio(1.0, ratio, 0.4).unwrap();
        let two = ContactStiffness::from_axis_ratio(1.0, ratio.inverse(), 0.4).unwrap();
        assert_relative_eq!(one.c_x, two.c_y, max_relative = 1e-14);
        assert_relative_eq!(one.c_y, two.c_x, max_relative = 1e-14);
        assert!(one.c_x > one.c_y);
    }

    #[test]
    fn bad_coefficients_are_named() {
        assert_eq!(ContactStiffness::new(1.0, f64::NAN, 1.0).unwrap_err().field, "c_y");
        assert_eq!(ContactStiffness::new(1.0, 1.0, -1.0).unwrap_err().field, "c_z");
        let bad = ContactStiffness::from_axis_ratio(1.0, AxisRatio::CIRCLE, 0.6);
        assert_eq!(bad.unwrap_err().field, "poisson");
    }
}
