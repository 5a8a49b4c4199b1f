//! Stresses under a circular Hertz contact in cylindrical components.

use carom_halfspace::Material;
use carom_special::RangeError;

/// Stresses inside one body under a circular Hertz contact, in cylindrical components; tension is
/// positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CircularStress {
    /// Radial stress.
    pub radial: f64,
    /// Hoop stress.
    pub hoop: f64,
    /// Axial stress.
    pub axial: f64,
    /// Shear stress sigma_rz, z into the body.
    pub shear: f64,
}

impl CircularStress {
    /// The greatest shear stress, half the difference of the extreme principal stresses.
    #[must_use]
    pub fn greatest_shear(&self) -> f64 {
        let middle = 0.5 * (self.radial + self.axial);
        let half = libm::hypot(0.5 * (self.radial - self.axial), self.shear);
        let high = (middle + half).max(self.hoop);
        let low = (middle - half).min(self.hoop);
        0.5 * (high - low)
    }
}

/// The stresses at radius rho and depth z in a body under the pressure `peak sqrt(1 - rho^2/a^2)`
/// on a circle (Huber).
///
/// ```
/// use carom_halfspace::Material;
/// use carom_laws::field::circular_stress;
/// let steel = Material::from_shear(80e9, 0.3)?;
/// let stress = circular_stress(1.0, 1.0, &steel, 0.0, 0.481)?;
/// assert!((stress.greatest_shear() - 0.310).abs() < 5e-4); // 0.31 p_0 at 0.48 a
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] for a contact radius that is not positive, a coordinate that is negative or not
/// finite, or a rigid body, whose stresses are undetermined.
pub fn circular_stress(
    radius: f64,
    peak: f64,
    body: &Material,
    rho: f64,
    depth: f64,
) -> Result<CircularStress, RangeError> {
    RangeError::positive("radius", radius)?;
    RangeError::finite("peak", peak)?;
    RangeError::non_negative("rho", rho)?;
    RangeError::non_negative("depth", depth)?;
    RangeError::positive("shear_modulus", body.shear_modulus())?;
    let nu = body.poisson();
    let (r, z) = (rho / radius, depth / radius);
    let excess = r * r + z * z - 1.0;
    let root = libm::hypot(excess, 2.0 * z);
    // The ellipsoidal coordinate u, without cancellation.
    let u = if excess > 0.0 { 0.5 * (excess + root) } else { 2.0 * z * z / (root - excess) };
    // z/sqrt(u) is the cosine-like coordinate of the confocal ellipsoid: on the surface inside the
    // circle its limit is sqrt(1 - r^2).
    let w = if excess > 0.0 { z / u.sqrt() } else { (0.5 * (root - excess)).sqrt() };
    let sqrt_u = u.sqrt();
    let arc = if sqrt_u > 0.0 { sqrt_u * libm::atan(1.0 / sqrt_u) } else { 0.0 };
    // (1 - w^3)/r^2 with 1 - w^2 = r^2/(1 + u).
    let share = (1.0 + w + w * w) / ((1.0 + w) * (1.0 + u));
    // w^3 u/(u^2 + z^2) with z = w sqrt(u): w^3/(u + w^2).
    let spread = u + w * w;
    let axial = if spread > 0.0 { -w * w * w / spread } else { 0.0 };
    let third = (1.0 - 2.0 * nu) / 3.0 * share;
    let radial = third - axial + w * (u * (1.0 - nu) / (1.0 + u) + (1.0 + nu) * arc - 2.0);
    let hoop = -third - w * (2.0 * nu + u * (1.0 - nu) / (1.0 + u) - (1.0 + nu) * arc);
    let shear = if spread > 0.0 { -r * w * w * sqrt_u / (spread * (1.0 + u)) } else { 0.0 };
    Ok(CircularStress {
        radial: peak * radial,
        hoop: peak * hoop,
        axial: peak * axial,
        shear: peak * shear,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn stresses_are_in_equilibrium_and_carry_the_pressure() {
        let body = Material::from_shear(1.0, 0.3).unwrap();
        let at = |r: f64, z: f64| circular_stress(1.0, 1.0, &body, r, z).unwrap();
        for r in [0.0, 0.3, 0.9] {
            assert_relative_eq!(at(r, 0.0).axial, -(1.0_f64 - r * r).sqrt(), max_relative = 1e-14);
        }
        assert_eq!(at(1.5, 0.0).axial, 0.0);
        // On the surface outside: pure shear, radial = -hoop = (1 - 2 nu)/(3 r^2).
        assert_relative_eq!(at(1.5, 0.0).radial, 0.4 / (3.0 * 2.25), max_relative = 1e-14);
        assert_relative_eq!(at(1.5, 0.0).hoop, -0.4 / (3.0 * 2.25), max_relative = 1e-14);
        let h = 1e-5;
        for (r, z) in [(0.4, 0.3), (1.2, 0.2), (0.7, 1.5)] {
            let dr =
                |f: fn(&CircularStress) -> f64| (f(&at(r + h, z)) - f(&at(r - h, z))) / (2.0 * h);
            let dz =
                |f: fn(&CircularStress) -> f64| (f(&at(r, z + h)) - f(&at(r, z - h))) / (2.0 * h);
            let s = at(r, z);
            let radial = dr(|s| s.radial) + dz(|s| s.shear) + (s.radial - s.hoop) / r;
            let axial = dr(|s| s.shear) + dz(|s| s.axial) + s.shear / r;
            assert!(radial.abs() < 1e-8 && axial.abs() < 1e-8, "{radial:e} {axial:e}");
        }
        assert_eq!(
            circular_stress(1.0, 1.0, &Material::RIGID, 0.0, 1.0).unwrap_err().field,
            "shear_modulus"
        );
    }
}
