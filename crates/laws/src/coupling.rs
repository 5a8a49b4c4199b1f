//! How much the coupling of normal and tangential displacements matters where a law neglects it.

use crate::friction::Friction;

/// A bound of how much the coupling of normal and tangential displacements changes R_x, the tangential coefficient of
/// restitution: `(gamma/f)^2/(4 + (gamma/f)^2) + gamma^2`, with gamma of (15.2).
///
/// It is 0 for like bodies and without friction. It was measured, not derived: in 150 impacts of spheres with
/// D_xx/D_zz from 2.5 to 5 the largest change was 0.91 of it.
///
/// ```
/// use carom_laws::coupling::coupling_bound;
/// use carom_laws::friction::Friction;
/// let bound = coupling_bound(0.2, Friction::new(0.1)?);
/// assert!((bound - 0.54).abs() < 1e-12);
/// assert_eq!(coupling_bound(0.0, Friction::new(0.1)?), 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[must_use]
pub fn coupling_bound(gamma: f64, friction: Friction) -> f64 {
    let (gamma, f) = (gamma.abs(), friction.get());
    if gamma == 0.0 || f == 0.0 {
        return 0.0;
    }
    let ratio = gamma / f;
    1.0 / (1.0 + 4.0 / (ratio * ratio)) + gamma * gamma
}
