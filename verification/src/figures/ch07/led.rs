//! A contact that is shifted along a path of two directions.

use carom_laws::memory::{Lateral, VectorMemory};

/// The state after a path of normalised shifts e, from a contact pressed to ζ = `zeta`.
pub(super) fn led(
    zeta: f64,
    path: &[(f64, [f64; 2])],
) -> Result<VectorMemory, carom_special::RangeError> {
    let mut memory = VectorMemory::new();
    memory.advance(zeta, [0.0, 0.0])?;
    for &(zeta, e) in path {
        memory.advance(zeta, e)?;
    }
    Ok(memory)
}

/// A step of the given length and angle in degrees.
pub(super) fn polar(length: f64, degrees: f64) -> [f64; 2] {
    let (s, c) = degrees.to_radians().sin_cos();
    [length * c, length * s]
}

/// The distance of two pairs.
pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    a.minus(b).length()
}
