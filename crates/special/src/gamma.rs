//! The gamma function.

use special::Gamma;

/// The gamma function.
///
/// ```text
/// gamma(x) = int_0^inf t^(x - 1) e^(-t) dt   (x > 0),   gamma(x + 1) = x gamma(x)
/// ```
///
/// Any real `x`: NaN at negative integers (poles of changing sign), infinite with the sign of `x`
/// at +-0, infinite above 171.6, 0 for large negative x. The error is at most 5 units of 2.2e-16.
/// Source: DLMF 5.2.1.
///
/// ```
/// use carom_special::gamma::gamma;
/// assert!((gamma(0.4) - 2.218_159_543_757_688).abs() < 1e-15);
/// assert!((gamma(-0.5) + 2.0 * std::f64::consts::PI.sqrt()).abs() < 1e-15);
/// ```
#[must_use]
pub fn gamma(x: f64) -> f64 {
    Gamma::gamma(x)
}

/// 1/gamma(x), an entire function: 0 at 0, -1, -2, ...
///
/// Any real `x` above -170; 0 where gamma overflows. The error is at most 5 units of 2.2e-16.
/// Source: DLMF 5.2.1.
///
/// ```
/// use carom_special::gamma::reciprocal;
/// assert_eq!(reciprocal(-3.0), 0.0);
/// assert_eq!(reciprocal(5.0), 1.0 / 24.0);
/// ```
#[must_use]
pub fn reciprocal(x: f64) -> f64 {
    if is_pole(x) { 0.0 } else { 1.0 / gamma(x) }
}

/// ln |gamma(x)|.
///
/// Any real `x`; infinite at the poles. The error is at most 4 units of 2.2e-16 for x > 0 and 20
/// near the poles, relative where the value exceeds 1 and absolute below. Source: DLMF 5.2.1.
///
/// ```
/// use carom_special::gamma::ln_gamma;
/// assert!((ln_gamma(1e3) - 5_905.220_423_209_181).abs() < 1e-11);
/// ```
#[must_use]
pub fn ln_gamma(x: f64) -> f64 {
    Gamma::ln_gamma(x).0
}

/// Whether gamma has a pole at `x`: 0, -1, -2, ...
pub(crate) fn is_pole(x: f64) -> bool {
    x <= 0.0 && x == libm::floor(x)
}
