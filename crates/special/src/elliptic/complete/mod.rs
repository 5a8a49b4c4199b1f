//! Complete elliptic integrals K, E, D, B, C of the axis ratio and their derivatives.
//!
//! With `Delta^2 = cos^2 t + k'^2 sin^2 t`, all taken over `t` from 0 to pi/2:
//!
//! ```text
//! K = int 1/Delta dt        D = int sin^2 t / Delta dt
//! E = int Delta dt          B = int cos^2 t / Delta dt
//!                           C = int sin^2 t cos^2 t / Delta^3 dt
//! ```
//!
//! They satisfy `K = B + D`, `E = B + k'^2 D` and `C = (D - B)/k^2`. A ratio above 1 is inverted by
//! exchanging the axes, `t -> pi/2 - t`. Below 0.41 the logarithmic series about `k' = 0` is
//! summed, above it the series about the circle after one Landen step; neither subtracts nearly
//! equal numbers. The error is at most 4 units of 2.2e-16, from the smallest subnormal to the
//! largest number. The iterations of Bulirsch and of Carlson have errors up to 5 units and fail
//! below 1e-30.

use crate::AxisRatio;

mod corner;
mod landen;

/// sqrt(2) - 1, where the two series converge equally fast: `k'^2 = ((1 - k')/(1 + k'))^2 = 0.17`.
const BORDER: f64 = std::f64::consts::SQRT_2 - 1.0;

/// C is small compared with ln(4/k') near [`BORDER`]; its series about the circle is used from here
/// on.
const BORDER_C: f64 = 0.3;

/// K, the complete integral of the first kind.
///
/// ```text
/// K(k') = int_0^(pi/2) dt / sqrt(cos^2 t + k'^2 sin^2 t)
/// ```
///
/// Decreasing; pi/2 for the circle, ln(4/k') for k' -> 0, ln(4 k')/k' for k' -> infinity.
/// Source: DLMF 19.2.8; thesis (5.13).
///
/// ```
/// use carom_special::{AxisRatio, elliptic::complete::k};
/// // The lemniscate constant: K at k^2 = 1/2 is Gamma(1/4)^2 / (4 sqrt(pi)).
/// let ratio = AxisRatio::new(0.5_f64.sqrt())?;
/// assert!((k(ratio) - 1.854_074_677_301_372).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[must_use]
pub fn k(ratio: AxisRatio) -> f64 {
    let kc = ratio.get();
    if kc > 1.0 { k_slender(1.0 / kc) / kc } else { k_slender(kc) }
}

/// E, the complete integral of the second kind.
///
/// ```text
/// E(k') = int_0^(pi/2) sqrt(cos^2 t + k'^2 sin^2 t) dt
/// ```
///
/// Increasing; 1 for k' -> 0, pi/2 for the circle, k' for k' -> infinity; 4 b E(a/b) is the
/// perimeter of the ellipse. Source: DLMF 19.2.8; thesis (5.13).
///
/// ```
/// use carom_special::{AxisRatio, elliptic::complete::e};
/// assert_eq!(e(AxisRatio::CIRCLE), std::f64::consts::FRAC_PI_2);
/// // A quarter of the perimeter of the ellipse with the semi-axes 1 and 2 is 2.42211...
/// let ratio = AxisRatio::new(0.5)?;
/// assert!((2.0 * e(ratio) - 2.422_112_055_136_919).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[must_use]
pub fn e(ratio: AxisRatio) -> f64 {
    let kc = ratio.get();
    if kc > 1.0 { kc * e_slender(1.0 / kc) } else { e_slender(kc) }
}

/// D, the associated integral (K - E)/k^2.
///
/// ```text
/// D(k') = int_0^(pi/2) sin^2 t / sqrt(cos^2 t + k'^2 sin^2 t) dt
/// ```
///
/// Decreasing; pi/4 for the circle, ln(4/k') - 1 for k' -> 0, 1/k' for k' -> infinity.
/// Source: DLMF 19.2.8; thesis (5.13).
///
/// ```
/// use carom_special::{AxisRatio, elliptic::complete::d};
/// assert_eq!(d(AxisRatio::CIRCLE), std::f64::consts::FRAC_PI_4);
/// // Where (K - E)/k^2 would have no correct digit: ln(4e20) - 1.
/// let ratio = AxisRatio::new(1e-20)?;
/// assert!((d(ratio) - 46.437_996_221_000_81).abs() < 1e-14);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[must_use]
pub fn d(ratio: AxisRatio) -> f64 {
    let kc = ratio.get();
    if kc > 1.0 { b_slender(1.0 / kc) / kc } else { d_slender(kc) }
}

/// B, the associated integral (E - k'^2 K)/k^2.
///
/// ```text
/// B(k') = int_0^(pi/2) cos^2 t / sqrt(cos^2 t + k'^2 sin^2 t) dt
/// ```
///
/// Decreasing; 1 for k' -> 0, pi/4 for the circle, (ln(4 k') - 1)/k' for k' -> infinity.
/// Source: thesis (5.13), (5.33); the B of Jahnke and Emde.
///
/// ```
/// use carom_special::{AxisRatio, elliptic::complete::{b, d, k}};
/// let ratio = AxisRatio::new(3.0)?;
/// assert!((b(ratio) + d(ratio) - k(ratio)).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[must_use]
pub fn b(ratio: AxisRatio) -> f64 {
    let kc = ratio.get();
    if kc > 1.0 { d_slender(1.0 / kc) / kc } else { b_slender(kc) }
}

/// C, the associated integral (D - B)/k^2.
///
/// ```text
/// C(k') = int_0^(pi/2) sin^2 t cos^2 t / (cos^2 t + k'^2 sin^2 t)^(3/2) dt
/// ```
///
/// Decreasing; ln(4/k') - 2 for k' -> 0, pi/16 for the circle, (ln(4 k') - 2)/k'^3 for
/// k' -> infinity (0 once that underflows). Source: thesis (5.33); the C of Jahnke and Emde.
///
/// ```
/// use carom_special::{AxisRatio, elliptic::complete::c};
/// assert_eq!(c(AxisRatio::CIRCLE), std::f64::consts::PI / 16.0);
/// ```
#[must_use]
pub fn c(ratio: AxisRatio) -> f64 {
    let kc = ratio.get();
    if kc > 1.0 { c_slender(1.0 / kc) / kc / kc / kc } else { c_slender(kc) }
}

/// dK/dk' = -B/k'.
///
/// Negative; overflows to -infinity where the derivative does, below k' = 6e-309.
/// Source: DLMF 19.4.1.
///
/// ```
/// use carom_special::{AxisRatio, elliptic::complete::dk};
/// assert_eq!(dk(AxisRatio::CIRCLE), -std::f64::consts::FRAC_PI_4);
/// ```
#[must_use]
pub fn dk(ratio: AxisRatio) -> f64 {
    -b(ratio) / ratio.get()
}

/// dE/dk' = k' D.
///
/// Positive; 1 for k' -> infinity. Source: DLMF 19.4.2.
///
/// ```
/// use carom_special::{AxisRatio, elliptic::complete::de};
/// assert_eq!(de(AxisRatio::CIRCLE), std::f64::consts::FRAC_PI_4);
/// ```
#[must_use]
pub fn de(ratio: AxisRatio) -> f64 {
    let kc = ratio.get();
    if kc > 1.0 { b_slender(1.0 / kc) } else { kc * d_slender(kc) }
}

/// dB/dk' = -k' C.
///
/// Negative; by differentiation under the integral of [`b`].
///
/// ```
/// use carom_special::{AxisRatio, elliptic::complete::db};
/// assert_eq!(db(AxisRatio::CIRCLE), -std::f64::consts::PI / 16.0);
/// ```
#[must_use]
pub fn db(ratio: AxisRatio) -> f64 {
    let kc = ratio.get();
    if kc > 1.0 { -c_slender(1.0 / kc) / kc / kc } else { -kc * c_slender(kc) }
}

/// dD/dk' = -(B - k'^2 C)/k'.
///
/// Negative; overflows to -infinity where the derivative does, below k' = 6e-309. By
/// differentiation under the integral of [`d`].
///
/// ```
/// use carom_special::{AxisRatio, elliptic::complete::dd};
/// let exact = -3.0 * std::f64::consts::PI / 16.0;
/// assert!((dd(AxisRatio::CIRCLE) - exact).abs() < 1e-15);
/// ```
#[must_use]
pub fn dd(ratio: AxisRatio) -> f64 {
    let kc = ratio.get();
    if kc > 1.0 { -cos4_slender(1.0 / kc) / kc / kc } else { -cos4_slender(kc) / kc }
}

// The functions below take k' in (0, 1].

fn k_slender(kc: f64) -> f64 {
    if kc < BORDER { corner::k(kc) } else { landen::k(kc) }
}

fn e_slender(kc: f64) -> f64 {
    if kc < BORDER { corner::e(kc) } else { landen::e(kc) }
}

fn d_slender(kc: f64) -> f64 {
    if kc < BORDER { corner::d(kc) } else { landen::d(kc) }
}

fn b_slender(kc: f64) -> f64 {
    if kc < BORDER { corner::b(kc) } else { landen::b(kc) }
}

fn c_slender(kc: f64) -> f64 {
    if kc < BORDER_C { corner::c(kc) } else { landen::c(kc) }
}

/// int cos^4 t / Delta^3 dt = D - C = B - k'^2 C.
fn cos4_slender(kc: f64) -> f64 {
    if kc < BORDER { corner::cos4(kc) } else { landen::b(kc) - kc * kc * landen::c(kc) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(value: f64) -> AxisRatio {
        AxisRatio::new(value).expect("positive")
    }

    #[test]
    fn both_series_agree_at_their_border() {
        type Function = fn(f64) -> f64;
        let pairs: [(Function, Function); 5] = [
            (corner::k, landen::k),
            (corner::e, landen::e),
            (corner::d, landen::d),
            (corner::b, landen::b),
            (corner::c, landen::c),
        ];
        for (corner, landen) in pairs {
            assert!((corner(BORDER) / landen(BORDER) - 1.0).abs() < 6e-16);
        }
    }

    #[test]
    fn extremes_are_finite() {
        for kc in [f64::from_bits(1), f64::MIN_POSITIVE, 1e-300, 1e300, f64::MAX] {
            for function in [k, e, d, b, c, de, db] {
                assert!(function(ratio(kc)).is_finite(), "{kc}");
            }
        }
        assert!(dk(ratio(1e-300)).is_finite() && dd(ratio(f64::MAX)).is_finite());
    }
}
