//! The stick radius of a contact of dissimilar bodies under normal load only.

use carom_special::elliptic::complete;
use carom_special::{AxisRatio, RangeError};

/// Goodman's stick radius c/a of a sphere or round punch pressed on a dissimilar body, assuming
/// Hertz's pressure: `1/(2 c) ln((1 + c)/(1 - c)) = (f/gamma) K(sqrt(1 - c^2))`.
///
/// ```
/// let stick = carom_laws::goodman_stick_radius(1.0)?;
/// assert!((stick - 0.9038).abs() < 1e-4);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] unless f/|gamma| is finite and positive.
pub fn goodman_stick_radius(friction_over_gamma: f64) -> Result<f64, RangeError> {
    RangeError::positive("friction over gamma", friction_over_gamma)?;
    let excess = |c: f64| {
        AxisRatio::new(c).map(|ratio| libm::atanh(c) / c - friction_over_gamma * complete::k(ratio))
    };
    let (mut low, mut high) = (f64::MIN_POSITIVE, 1.0 - f64::EPSILON);
    for _ in 0..1100 {
        // Bisection of the exponent for very small values, otherwise of the interval.
        let middle = if low < 0.01 * high { (low * high).sqrt() } else { 0.5 * (low + high) };
        if middle <= low || middle >= high {
            break;
        }
        if excess(middle)? < 0.0 { low = middle } else { high = middle }
    }
    Ok(0.5 * (low + high))
}
