//! The torque of an elliptical contact that does not slip (5.31)-(5.35).

use std::f64::consts::PI;

use carom_halfspace::MaterialPair;
use carom_special::elliptic::complete;

use crate::ellipse::ContactEllipse;

/// Torsion under complete adhesion.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_laws::ellipse::ContactEllipse;
/// use carom_laws::torsion::adhesion::AdhesiveTorsion;
/// let body = Material::from_shear(2.0, 0.3)?; // the pair's modulus is 1
/// let torsion = AdhesiveTorsion::new(ContactEllipse::circle(1.0)?, MaterialPair::new(body, body)?);
/// assert!((torsion.stiffness() - 16.0 / 3.0).abs() < 1e-14); // (16/3) G a^3, for any nu
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AdhesiveTorsion {
    ellipse: ContactEllipse,
    along_x: f64,
    along_y: f64,
    stiffness: f64,
}

impl AdhesiveTorsion {
    /// For a contact ellipse, either semi-axis of which may be the larger one.
    #[must_use]
    pub fn new(ellipse: ContactEllipse, materials: MaterialPair) -> Self {
        let ratio = ellipse.axis_ratio();
        let (g, nu) = (materials.shear_modulus(), materials.poisson());
        let [e, d, b, c] =
            [complete::e, complete::d, complete::b, complete::c].map(|integral| integral(ratio));
        let square = ratio.get() * ratio.get(); // 1 - k^2
        let denominator = b * d - nu * c * e;
        let scale = g / (ellipse.semi_axis_a() * denominator);
        let long = ellipse.semi_axis_b();
        Self {
            ellipse,
            along_x: scale * (b - 2.0 * nu * square * c), // (5.34), T'/beta
            along_y: scale * (d - 2.0 * nu * c),          // (5.34), T''/beta
            // (5.35)
            stiffness: 2.0 * PI * g * (long * long * long) * (e - 4.0 * nu * square * c)
                / (3.0 * denominator),
        }
    }

    /// dM_z/dbeta, the inverse of (5.35).
    #[must_use]
    pub const fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// T'/beta and T''/beta of (5.34).
    #[must_use]
    pub const fn coefficients(&self) -> [f64; 2] {
        [self.along_x, self.along_y]
    }

    /// The traction (sigma_zx, sigma_zy) on body 1 under a twist, (5.32) with its sign corrected:
    /// `T' y/s`, `-T'' x/s`, `s^2 = 1 - x^2/a^2 - y^2/b^2`. Infinite on the edge, zero outside.
    #[must_use]
    pub fn traction(&self, twist: f64, x: f64, y: f64) -> [f64; 2] {
        let rest = 1.0 - self.ellipse.radius_squared(x, y);
        if rest < 0.0 {
            return [0.0; 2];
        }
        let root = rest.sqrt();
        [twist * self.along_x * y / root, -twist * self.along_y * x / root]
    }
}

/// The torque of complete sliding divided by f F_z: `(3/8) b E(k)`, in (7.65) and (10.57).
#[must_use]
pub fn sliding_torque_arm(ellipse: &ContactEllipse) -> f64 {
    0.375 * ellipse.semi_axis_b() * complete::e(ellipse.axis_ratio())
}
