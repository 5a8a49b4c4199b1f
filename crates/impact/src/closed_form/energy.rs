//! Kinetic energy dissipated in an impact of spheres, (9.58) to (9.60).

use carom_special::RangeError;

/// Kinetic energy dissipated in the tangential motion of two solid spheres (9.59): m1 m2/(7 (m1 +
/// m2)) (1 + R_x)(1 - R_x) v^2, with `velocity` v of the contact point.
///
/// A sphere of infinite mass is unaffected by the impact.
///
/// ```
/// use carom_impact::closed_form::tangential_energy_loss;
/// let lost = tangential_energy_loss([0.2, f64::INFINITY], 0.5, 3.0)?;
/// assert!((lost - 0.2 / 7.0 * 0.75 * 9.0).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] unless the masses are positive and not both infinite.
pub fn tangential_energy_loss(
    masses: [f64; 2],
    restitution: f64,
    velocity: f64,
) -> Result<f64, RangeError> {
    let mass = reduced_mass(masses)?;
    Ok(mass / 7.0 * (1.0 + restitution) * (1.0 - restitution) * velocity * velocity)
}

/// Kinetic energy lost in the normal motion (9.60): m1 m2/(2 (m1 + m2)) (1 + R_z)(1 - R_z) v^2.
///
/// # Errors
/// [`RangeError`] unless the masses are positive and not both infinite.
pub fn normal_energy_loss(
    masses: [f64; 2],
    restitution: f64,
    velocity: f64,
) -> Result<f64, RangeError> {
    let mass = reduced_mass(masses)?;
    Ok(0.5 * mass * (1.0 + restitution) * (1.0 - restitution) * velocity * velocity)
}

fn reduced_mass(masses: [f64; 2]) -> Result<f64, RangeError> {
    for mass in masses {
        RangeError::check("mass", mass, mass > 0.0, "positive")?;
    }
    let inverse = 1.0 / masses[0] + 1.0 / masses[1];
    RangeError::positive("inverse reduced mass", inverse)?;
    Ok(1.0 / inverse)
}
