//! The symmetric stress tensor and its invariants.

use std::ops::{Add, Mul};

use carom_special::RangeError;

/// A symmetric stress tensor; tension is positive.
///
/// ```
/// use carom_halfspace::Stress;
/// let shear = Stress { xy: 3.0, ..Stress::default() };
/// let principal = shear.principal();
/// assert!((principal.maximum - 3.0).abs() < 1e-15);
/// assert!((shear.von_mises() - 27f64.sqrt()).abs() < 1e-15);
/// assert!((shear.maximum_shear() - 3.0).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Stress {
    /// sigma_xx.
    pub xx: f64,
    /// sigma_yy.
    pub yy: f64,
    /// sigma_zz.
    pub zz: f64,
    /// sigma_xy.
    pub xy: f64,
    /// sigma_yz.
    pub yz: f64,
    /// sigma_zx.
    pub zx: f64,
}

/// The principal stresses in descending order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalStresses {
    /// The largest (most tensile).
    pub maximum: f64,
    /// The intermediate.
    pub intermediate: f64,
    /// The smallest (most compressive).
    pub minimum: f64,
}

impl Stress {
    /// The mean of the normal stresses, a third of the trace.
    #[must_use]
    pub fn mean(&self) -> f64 {
        (self.xx + self.yy + self.zz) / 3.0
    }

    /// The equivalent stress of von Mises, sqrt(3 J2).
    #[must_use]
    pub fn von_mises(&self) -> f64 {
        let Self { xx, yy, zz, xy, yz, zx } = *self;
        let (p, q, s) = (xx - yy, yy - zz, zz - xx);
        (0.5 * (p * p + q * q + s * s) + 3.0 * (xy * xy + yz * yz + zx * zx)).sqrt()
    }

    /// The maximum shear stress, half the difference of the extreme principal stresses.
    #[must_use]
    pub fn maximum_shear(&self) -> f64 {
        let principal = self.principal();
        0.5 * (principal.maximum - principal.minimum)
    }

    /// The three principal stresses, accurate to rounding of the largest component.
    ///
    /// By Jacobi rotations. The trigonometric solution of the cubic would lose half the digits if
    /// two principal stresses are nearly equal, which is common on an axis of symmetry.
    #[must_use]
    pub fn principal(&self) -> PrincipalStresses {
        let mut a =
            [[self.xx, self.xy, self.zx], [self.xy, self.yy, self.yz], [self.zx, self.yz, self.zz]];
        for _ in 0..SWEEPS {
            for (p, q) in [(0, 1), (0, 2), (1, 2)] {
                rotate(&mut a, p, q);
            }
        }
        let mut values = [a[0][0], a[1][1], a[2][2]];
        values.sort_by(|one, two| two.total_cmp(one));
        PrincipalStresses { maximum: values[0], intermediate: values[1], minimum: values[2] }
    }

    pub(crate) fn finite_at(self, field: &'static str, at: f64) -> Result<Self, RangeError> {
        let Self { xx, yy, zz, xy, yz, zx } = self;
        let finite = [xx, yy, zz, xy, yz, zx].iter().all(|s| s.is_finite());
        RangeError::check(field, at, finite, "where the stress is finite").map(|_| self)
    }
}

/// Jacobi converges quadratically; a 3 x 3 matrix is diagonal to rounding after five sweeps.
const SWEEPS: usize = 6;

/// One Jacobi rotation that annihilates the element (p, q).
fn rotate(a: &mut [[f64; 3]; 3], p: usize, q: usize) {
    let off = a[p][q];
    if off == 0.0 {
        return;
    }
    let theta = (a[q][q] - a[p][p]) / (2.0 * off);
    let t = 1.0f64.copysign(theta) / (theta.abs() + libm::hypot(theta, 1.0));
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    a[p][p] -= t * off;
    a[q][q] += t * off;
    a[p][q] = 0.0;
    a[q][p] = 0.0;
    let k = 3 - p - q;
    let (kp, kq) = (a[k][p], a[k][q]);
    a[k][p] = c * kp - s * kq;
    a[k][q] = s * kp + c * kq;
    a[p][k] = a[k][p];
    a[q][k] = a[k][q];
}

impl Add for Stress {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            xx: self.xx + other.xx,
            yy: self.yy + other.yy,
            zz: self.zz + other.zz,
            xy: self.xy + other.xy,
            yz: self.yz + other.yz,
            zx: self.zx + other.zx,
        }
    }
}

impl Mul<f64> for Stress {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self {
            xx: self.xx * factor,
            yy: self.yy * factor,
            zz: self.zz * factor,
            xy: self.xy * factor,
            yz: self.yz * factor,
            zx: self.zx * factor,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn principal_stresses_keep_the_invariants(s in prop::array::uniform6(-1.0..1.0f64)) {
            let stress = Stress { xx: s[0], yy: s[1], zz: s[2], xy: s[3], yz: s[4], zx: s[5] };
            let PrincipalStresses { maximum: a, intermediate: b, minimum: c } = stress.principal();
            prop_assert!(a >= b && b >= c);
            let second = s[0] * s[1] + s[1] * s[2] + s[2] * s[0]
                - s[3] * s[3] - s[4] * s[4] - s[5] * s[5];
            let third = s[0] * (s[1] * s[2] - s[4] * s[4]) - s[3] * (s[3] * s[2] - s[4] * s[5])
                + s[5] * (s[3] * s[4] - s[1] * s[5]);
            assert_abs_diff_eq!(a + b + c, s[0] + s[1] + s[2], epsilon = 1e-14);
            assert_abs_diff_eq!(a * b + b * c + c * a, second, epsilon = 1e-14);
            assert_abs_diff_eq!(a * b * c, third, epsilon = 1e-14);
            let mises = (0.5 * ((a - b).powi(2) + (b - c).powi(2) + (c - a).powi(2))).sqrt();
            assert_abs_diff_eq!(stress.von_mises(), mises, epsilon = 1e-14);
        }
    }

    #[test]
    fn nearly_equal_principal_stresses_keep_their_difference() {
        let (mean, small) = (1.0, 1e-9);
        let stress = Stress { xx: mean, yy: mean, zz: 5.0, xy: small, ..Stress::default() };
        let principal = stress.principal();
        let difference = principal.intermediate - principal.minimum;
        assert_abs_diff_eq!(difference, 2.0 * small, epsilon = 1e-15);
    }
}
