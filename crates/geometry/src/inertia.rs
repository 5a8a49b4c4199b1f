//! Mass and moments of inertia.

use carom_special::RangeError;
use nalgebra::Vector3;

/// Mass and principal moments of inertia; infinite values mean that the body is fixed.
///
/// ```
/// use carom_geometry::Inertia;
/// let ball = Inertia::solid_sphere(0.2, 0.05)?;
/// assert!((ball.moments()[0] - 0.4 * 0.2 * 0.05 * 0.05).abs() < 1e-18);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inertia {
    mass: f64,
    moments: [f64; 3],
}

impl Inertia {
    /// A body that does not move.
    pub const FIXED: Self = Self { mass: f64::INFINITY, moments: [f64::INFINITY; 3] };

    /// From mass and principal moments; infinite values are allowed.
    ///
    /// # Errors
    /// [`RangeError`] unless the mass and all moments are positive and the moments satisfy the
    /// triangle inequality of every mass distribution.
    pub fn new(mass: f64, moments: [f64; 3]) -> Result<Self, RangeError> {
        RangeError::check("mass", mass, mass > 0.0, "> 0 (inf: fixed)")?;
        for moment in moments {
            RangeError::check("moment of inertia", moment, moment > 0.0, "> 0 (inf: fixed)")?;
        }
        let [a, b, c] = moments;
        let slack = 1.0 + 1e-12;
        for (one, sum) in [(a, b + c), (b, c + a), (c, a + b)] {
            let holds = one <= slack * sum;
            RangeError::check("moment of inertia", one, holds, "<= the sum of the other two")?;
        }
        Ok(Self { mass, moments })
    }

    /// A homogeneous solid sphere, theta = (2/5) m R^2.
    ///
    /// # Errors
    /// [`RangeError`] unless mass > 0 (infinity allowed) and radius is finite and positive.
    pub fn solid_sphere(mass: f64, radius: f64) -> Result<Self, RangeError> {
        Self::of_gyration(mass, radius, 0.4)
    }

    /// A thin spherical shell, theta = (2/3) m R^2.
    ///
    /// # Errors
    /// As [`Inertia::solid_sphere`].
    pub fn spherical_shell(mass: f64, radius: f64) -> Result<Self, RangeError> {
        Self::of_gyration(mass, radius, 2.0 / 3.0)
    }

    fn of_gyration(mass: f64, radius: f64, share: f64) -> Result<Self, RangeError> {
        RangeError::positive("radius", radius)?;
        Self::new(mass, [share * mass * radius * radius; 3])
    }

    /// The mass; infinite if the centre of the body is fixed.
    #[must_use]
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// The principal moments of inertia.
    #[must_use]
    pub const fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// Whether the moments are the same about all axes.
    #[must_use]
    pub fn is_isotropic(&self) -> bool {
        let [a, b, c] = self.moments;
        a == b && b == c
    }

    /// 1/m, zero for an infinite mass.
    #[must_use]
    pub fn inverse_mass(&self) -> f64 {
        1.0 / self.mass
    }

    /// theta^-1 in principal axes, zeros for infinite moments.
    #[must_use]
    pub fn inverse_moments(&self) -> Vector3<f64> {
        Vector3::from(self.moments).map(|moment| 1.0 / moment)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a lamina the moment about its normal is the sum of the other two; no body has more but by round-off.
    #[test]
    fn no_body_is_flatter_than_a_lamina() {
        let (a, b) = (0.1, 0.2);
        for turn in 0..3 {
            for (excess, holds) in [(0.0, true), (1e-13, true), (1e-10, false), (1e-3, false)] {
                let mut moments = [a, b, (a + b) * (1.0 + excess)];
                moments.rotate_right(turn);
                assert_eq!(Inertia::new(1.0, moments).is_ok(), holds, "{moments:?}");
            }
        }
    }
}
