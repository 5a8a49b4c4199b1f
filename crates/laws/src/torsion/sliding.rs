//! The sliding density `b = (2/pi) E(k)/k'` outside a stick radius: twist, torque, and the limit of
//! slow reverse twist.
//!
//! With the depth `v = ln(al/c)` of the stick radius c below the contact radius al, twist and
//! torque are `(2/pi) al G(v)` and `al^4 m(v)/2`: two functions of one variable, analytic in a
//! strip of half-width pi. They are tabulated once as polynomials on intervals of length 1/4, with
//! errors below 1e-14.

use std::f64::consts::{FRAC_2_PI, PI};
use std::sync::LazyLock;

use carom_special::AxisRatio;
use carom_special::elliptic::complete;
use carom_special::quadrature::FixedRule;

use super::lubkin::{Lubkin, SLIDING_TORQUE};

/// Number of intervals in v, of length 1/4 each. Beyond them k'^3 is below rounding.
const PIECES: usize = 48;
/// The depth from which the stick area is negligible for torque and heat.
pub(super) const DEEP: f64 = LENGTH * PIECES as f64;
/// Length of an interval.
pub(super) const LENGTH: f64 = 0.25;
/// Number of coefficients of an interval: with singularities at distance pi the next one is 1e-17.
const TERMS: usize = 12;

/// Number of sums side by side.
const LANES: usize = 4;

/// The coefficients of one interval.
pub(super) type Piece = [f64; TERMS.next_multiple_of(LANES)];

struct Table {
    /// G(v)/v on the first interval, G(v) on the others.
    twist: [Piece; PIECES],
    /// Likewise m(v).
    torque: [Piece; PIECES],
}

/// Likewise p(v)/v^2 and g(v)/v^2 of [`super::heat`].
static HEAT_OF_TWIST: LazyLock<[Piece; PIECES]> =
    LazyLock::new(|| std::array::from_fn(|i| fitted(i, work_of_twist, 2)));
static HEAT_OF_GROWTH: LazyLock<[Piece; PIECES]> =
    LazyLock::new(|| std::array::from_fn(|i| fitted(i, work_of_growth, 2)));

static TABLE: LazyLock<Table> = LazyLock::new(|| Table {
    twist: std::array::from_fn(|i| fitted(i, twist_at, 1)),
    torque: std::array::from_fn(|i| fitted(i, |v| Lubkin::at_depth(v).torque(), 1)),
});

static RULE: FixedRule<16> = FixedRule::fixed();

/// `G = K - E` at the depth v, by the integral D.
fn twist_at(v: f64) -> f64 {
    -libm::expm1(-2.0 * v) * with_ratio(libm::exp(-v), complete::d)
}

/// The polynomial through the Chebyshev nodes of an interval, in powers of t from -1 to 1. On the
/// first interval the function is divided by `v^order`, its leading power.
pub(super) fn fitted(piece: usize, function: fn(f64) -> f64, order: i32) -> Piece {
    let n = TERMS as f64;
    let angle = |i: usize| PI * (i as f64 + 0.5) / n;
    let values: [f64; TERMS] = std::array::from_fn(|i| {
        let v = LENGTH * (piece as f64 + 0.5 + 0.5 * libm::cos(angle(i)));
        function(v) / if piece == 0 { v.powi(order) } else { 1.0 }
    });
    let mut powers = Piece::default();
    // T_k in powers of t, by its recurrence; the coefficients decrease faster than those grow.
    let (mut last, mut this) = ([0.0; TERMS], [0.0; TERMS]);
    this[0] = 1.0;
    for k in 0..TERMS {
        let sum: f64 =
            values.iter().enumerate().map(|(i, f)| f * libm::cos(k as f64 * angle(i))).sum();
        let coefficient = sum * if k == 0 { 1.0 } else { 2.0 } / n;
        for (power, term) in powers.iter_mut().zip(&this) {
            *power += coefficient * term;
        }
        let factor = if k == 0 { 1.0 } else { 2.0 };
        let mut next = [0.0; TERMS];
        for i in 0..TERMS {
            let shifted = if i == 0 { 0.0 } else { this[i - 1] };
            next[i] = factor * shifted - last[i];
        }
        (last, this) = (this, next);
    }
    powers
}

/// The interval of an argument, and the place there from -1 to 1.
pub(super) fn interval(v: f64) -> (usize, f64) {
    let at = v / LENGTH;
    let piece = at as usize;
    (piece, 2.0 * (at - piece as f64) - 1.0)
}

/// A polynomial. Each step of Horner's scheme waits for the one before: powers that differ by multiples of
/// [`LANES`] are summed apart, side by side.
pub(super) fn horner_value(piece: &Piece, t: f64) -> f64 {
    let square = t * t;
    let fourth = square * square;
    let mut values = [0.0; LANES];
    for powers in piece.as_chunks::<LANES>().0.iter().rev() {
        for lane in 0..LANES {
            values[lane] = values[lane] * fourth + powers[lane];
        }
    }
    let [a, b, c, d] = values;
    (a + t * b) + square * (c + t * d)
}

/// A polynomial and its derivative, as [`horner_value`].
fn horner(piece: &Piece, t: f64) -> (f64, f64) {
    let square = t * t;
    let fourth = square * square;
    let (mut values, mut slopes) = ([0.0; LANES], [0.0; LANES]);
    for powers in piece.as_chunks::<LANES>().0.iter().rev() {
        for lane in 0..LANES {
            slopes[lane] = slopes[lane] * fourth + values[lane];
            values[lane] = values[lane] * fourth + powers[lane];
        }
    }
    let sum = |[a, b, c, d]: [f64; LANES]| (a + t * b) + square * (c + t * d);
    let [_, b, c, d] = values;
    let inner = b + t * (2.0 * c + t * (3.0 * d));
    (sum(values), inner + 4.0 * (t * square) * sum(slopes))
}

/// A value and its derivative in v.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sloped {
    pub(super) value: f64,
    pub(super) slope: f64,
}

/// `G(v) = K - E` and `dG/dv = E`, for v >= 0.
pub(super) fn twist_of_depth(v: f64) -> Sloped {
    if v >= DEEP {
        // K - E = L - 1 - k'^2 L/4 with L = ln(4/k') (DLMF 19.12).
        let l = v + 2.0 * std::f64::consts::LN_2;
        let rest = if v < 40.0 { 0.25 * l * libm::exp(-2.0 * v) } else { 0.0 };
        return Sloped { value: l - 1.0 - rest, slope: 1.0 };
    }
    let (piece, t) = interval(v);
    let (value, slope) = horner(&TABLE.twist[piece], t);
    let slope = 2.0 / LENGTH * slope;
    if piece == 0 {
        return Sloped { value: v * value, slope: value + v * slope };
    }
    Sloped { value, slope }
}

/// `G(v)` without its derivative.
fn twist_value(v: f64) -> f64 {
    if v >= DEEP { twist_of_depth(v).value } else { tabled::<1>(&TABLE.twist, v) }
}

/// The normalised torque `m(v)`, for v >= 0.
fn torque_of_depth(v: f64) -> f64 {
    if v >= DEEP { SLIDING_TORQUE } else { tabled::<1>(&TABLE.torque, v) }
}

/// A tabulated function with the leading power `v^ORDER`, for `0 <= v < DEEP`.
fn tabled<const ORDER: i32>(pieces: &[Piece; PIECES], v: f64) -> f64 {
    let (piece, t) = interval(v);
    let value = horner_value(&pieces[piece], t);
    if piece == 0 { v.powi(ORDER) * value } else { value }
}

/// Heat per twist, p(v) of [`super::heat`].
pub(super) fn heat_of_twist(v: f64) -> f64 {
    if v >= DEEP { 0.5 * SLIDING_TORQUE } else { tabled::<2>(&HEAT_OF_TWIST, v) }
}

/// Heat per growth, g(v) of [`super::heat`]; constant at great depth.
pub(super) fn heat_of_growth(v: f64) -> f64 {
    let deepest = (1.0 - f64::EPSILON) * DEEP;
    tabled::<2>(&HEAT_OF_GROWTH, v.min(deepest))
}

/// `p = (6/pi) int_0^v exp(-3 u) (K - E) du` at the depth v.
fn work_of_twist(v: f64) -> f64 {
    3.0 * FRAC_2_PI * over_the_ring(v, |sliding| sliding.value)
}

/// `g = (12/pi^2) int_0^v exp(-3 u) (K - E) K du` at the depth v.
fn work_of_growth(v: f64) -> f64 {
    let both = over_the_ring(v, |sliding| sliding.value * (sliding.value + sliding.slope));
    3.0 * FRAC_2_PI * FRAC_2_PI * both
}

/// The integral of a function of `G` and `E` over the slip annulus with the weight `exp(-3 u)`.
fn over_the_ring(v: f64, function: impl Fn(Sloped) -> f64) -> f64 {
    let panels = v.ceil().max(1.0);
    let at = |i: u32| v * f64::from(i) / panels;
    (0..panels as u32)
        .map(|i| {
            RULE.integrate(at(i), at(i + 1), |u| libm::exp(-3.0 * u) * function(twist_of_depth(u)))
        })
        .sum()
}

/// `W(x) = 1 - (2/pi) [asin x - x sqrt(1 - x^2)]`: slip outside a rotated disc.
fn slip_by_disc(x: f64) -> f64 {
    1.0 - FRAC_2_PI * (libm::asin(x) - x * ((1.0 - x) * (1.0 + x)).sqrt())
}

/// `ln(al/c)`, zero outside the contact and infinite at the centre.
fn depth(c: f64, radius: f64) -> f64 {
    let ratio = c / radius;
    if ratio < 1.0 { -libm::log(ratio.max(0.0)) } else { 0.0 }
}

/// `B(c; al) = (2/pi) al (K - E)` (5.39); infinite at the centre.
pub(super) fn sliding_twist(c: f64, radius: f64) -> f64 {
    FRAC_2_PI * radius * twist_value(depth(c, radius))
}

/// `B(c; al)` and the sliding density at c, `-dB/dc = (2/pi) E al/c`.
pub(super) fn sliding_twist_and_density(c: f64, radius: f64) -> Sloped {
    let Sloped { value, slope } = twist_of_depth(depth(c, radius));
    Sloped { value: FRAC_2_PI * radius * value, slope: FRAC_2_PI * radius * slope / c }
}

/// `al^4 m(c/al)/2`, the torque of the sliding density outside c.
pub(super) fn sliding_torque(c: f64, radius: f64) -> f64 {
    half_fourth_power(radius) * torque_of_depth(depth(c, radius))
}

/// [`sliding_twist`] and [`sliding_torque`], with the depth that they share.
pub(super) fn sliding_twist_and_torque(c: f64, radius: f64) -> (f64, f64) {
    let v = depth(c, radius);
    (FRAC_2_PI * radius * twist_value(v), half_fourth_power(radius) * torque_of_depth(v))
}

fn half_fourth_power(radius: f64) -> f64 {
    let square = radius * radius;
    0.5 * (square * square)
}

/// The torque of complete sliding, `(3 pi/32) al^4`.
#[must_use]
pub fn sliding_limit(radius: f64) -> f64 {
    let square = radius * radius;
    3.0 * PI / 32.0 * (square * square)
}

pub(super) fn with_ratio(ratio: f64, integral: fn(AxisRatio) -> f64) -> f64 {
    // Ratios lie in (0, 1] except for rounding.
    AxisRatio::new(ratio.clamp(f64::MIN_POSITIVE, 1.0)).map_or(0.0, integral)
}

/// The greatest rate of reverse twist, relative to the receding edge, at which the slip annulus
/// keeps its sign: from 1 at the edge to 1.1023 at the centre. It follows from zero slip at the
/// edge.
pub(super) fn threshold(stick: f64) -> f64 {
    let w_stick = slip_by_disc(stick);
    if w_stick <= 1e-12 {
        return 1.0;
    }
    let integral = RULE.integrate(stick, 1.0, |s| {
        // (E - s^2 K)/(1 - s^2) is the integral B.
        FRAC_2_PI * with_ratio(s, complete::b) / s * slip_by_disc(s)
    });
    FRAC_2_PI * with_ratio(stick, complete::k) - integral / w_stick
}

/// The mean of `al^4` between two radii.
pub(super) fn mean_of_fourth_powers(a: f64, b: f64) -> f64 {
    let (square_a, square_b) = (a * a, b * b);
    0.2 * ((square_a + square_b) * (square_a + a * b) + square_b * square_b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn tables_keep_all_digits() {
        for i in 0..=26_000 {
            let v = f64::from(i) * 5e-4 + 1e-13;
            let (got, want) = (twist_of_depth(v), twist_at(v));
            assert!((got.value - want).abs() <= 1e-14 * want, "{v}: {:e} {want:e}", got.value);
            // Only the steps of Newton depend on the slope.
            let slope = with_ratio(libm::exp(-v), complete::e);
            assert!((got.slope - slope).abs() <= 1e-9, "{v}: {:e} {slope:e}", got.slope);
            let (got, want) = (torque_of_depth(v), Lubkin::at_depth(v).torque());
            assert!((got - want).abs() <= 1e-14 * want, "{v}: {got:e} {want:e}");
        }
        assert_eq!(sliding_twist(1.0, 1.0), 0.0);
        assert_eq!(sliding_twist(0.0, 1.0), f64::INFINITY);
        assert!((sliding_torque(0.0, 2.0) - sliding_limit(2.0)).abs() < 1e-15);
    }

    /// The work of friction on slip, traction times slip, by the rings outside `c` when the disc of
    /// radius c turns: `(3/2) int_c^1 rho^2 sqrt(1 - rho^2) W(c/rho) drho`.
    fn friction_on_slip(c: f64) -> f64 {
        let panels = 2 * (1.0 - libm::log(c)) as u32;
        let edge = |i: u32| libm::pow(c, 1.0 - f64::from(i) / f64::from(panels));
        (0..panels)
            .map(|i| {
                let (low, high) = (edge(i), edge(i + 1));
                // Powers 3/2 and 1/2 at the ends become even ones.
                RULE.integrate(0.0, FRAC_PI_2, |angle| {
                    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                    let rho = low + (high - low) * sin * sin;
                    let rim = (1.0 - high) + (high - low) * cos * cos;
                    let slip = slip_by_disc((c / rho).min(1.0));
                    3.0 * (high - low) * sin * cos * rho * rho * (rim * (1.0 + rho)).sqrt() * slip
                })
            })
            .sum()
    }

    #[test]
    fn heat_of_twist_is_traction_times_slip() {
        for v in [0.01, 0.3, 0.9, 2.0, 5.5, 11.0] {
            let (got, want) = (heat_of_twist(v), friction_on_slip(libm::exp(-v)));
            assert!((got - want).abs() < 2e-13 * (1.0 + want), "{v}: {got:e} {want:e}");
        }
    }

    #[test]
    fn heat_of_growth_is_traction_times_slip() {
        // Discs between stick radius and rim that turn as the sliding density grows, and that of the
        // stick radius which turns back by as much.
        for v in [0.3, 2.0, 5.5, 11.0] {
            let own = friction_on_slip(libm::exp(-v));
            let panels = 2 * (1 + v as u32);
            let rest: f64 = (0..panels)
                .map(|i| {
                    let at = |i: u32| v * f64::from(i) / f64::from(panels);
                    RULE.integrate(at(i), at(i + 1), |u| {
                        let s = libm::exp(-u);
                        FRAC_2_PI * with_ratio(s, complete::b) * (own - friction_on_slip(s))
                    })
                })
                .sum();
            let (got, want) = (heat_of_growth(v), own + rest);
            assert!((got - want).abs() < 1e-12 * (1.0 + want), "{v}: {got:e} {want:e}");
        }
    }
}
