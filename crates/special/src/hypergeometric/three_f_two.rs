//! 3F2(s, a, b; s + 1, c; z), the integral of a power times 2F1.

use super::UnitArgument;
use super::continuation::Expansion;
use super::error::HypergeometricError;
use super::gauss::{Gauss, LARGEST_PARAMETER, Powers, trusted};
use super::series::{Sum, weighted};
use crate::RangeError;

/// Coefficients of the series in 1 - z; at 1/2 the last is below 1e-17 of the sum.
const TERMS: usize = 64;

/// Distance from 1 below which the leading power represents the rest of the integral.
const INTEGRATION_END: f64 = 1e-20;

/// The function 3F2(s, a, b; s + 1, c; .) with fixed parameters, prepared for repeated evaluation.
///
/// ```text
/// z^s 3F2(s, a, b; s + 1, c; z) = s int_0^z t^(s - 1) F(a, b; c; t) dt
/// ```
///
/// Use this form to evaluate one function at many arguments; [`three_f_two`] for a single value.
///
/// ```
/// use carom_special::hypergeometric::{ThreeFTwo, UnitArgument};
/// // With a = s + 1 only F(s, b; c; .) remains: 3F2(1, 2, 1/2; 2, 1/2; z) = -ln... = 1/(1 - z).
/// let function = ThreeFTwo::new(1.0, 2.0, 0.5, 0.5)?;
/// assert!((function.at(UnitArgument::new(0.25)?)? - 4.0 / 3.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ThreeFTwo {
    s: f64,
    gauss: Gauss,
    /// The integral from 0 to 1/2.
    half: Sum,
    end: End,
}

/// The method used between 1/2 and 1.
#[derive(Debug, Clone, PartialEq)]
enum End {
    /// A polynomial in z.
    Polynomial,
    /// The integral from 0 is `constant - y sum_n (regular_n + singular_n y^excess) y^n`.
    Powers(Box<Tail>),
    /// The excess of 2F1 is close to an integer: Taylor steps.
    Logarithmic,
}

#[derive(Debug, Clone, PartialEq)]
struct Tail {
    constant: Sum,
    regular: [f64; TERMS],
    singular: [f64; TERMS],
}

impl ThreeFTwo {
    /// Prepares the function with the parameters `s`, `a`, `b`, `c`; the second lower parameter is
    /// `s + 1`.
    ///
    /// # Errors
    /// [`RangeError`] unless `s` is above 0 and all are from -5 to 5, and `c` is not 0, -1, ...
    pub fn new(s: f64, a: f64, b: f64, c: f64) -> Result<Self, HypergeometricError> {
        let holds = s > 0.0 && s <= LARGEST_PARAMETER;
        RangeError::check("s", s, holds, "above 0, to 5")?;
        let gauss = Gauss::new(a, b, c)?;
        let half = weighted(a, b, c, 0.5, |n| 1.0 / (s + n)).scaled(libm::pow(0.5, s));
        let end = match gauss.powers() {
            Some(powers) => End::Powers(Box::new(Tail::new(s, &gauss, powers, half))),
            None if gauss.is_polynomial() => End::Polynomial,
            None => End::Logarithmic,
        };
        Ok(Self { s, gauss, half, end })
    }

    /// The value at `argument`.
    ///
    /// # Errors
    /// [`HypergeometricError`] if the value is infinite at 1, or if cancellation costs more than
    /// 1e-13 of the value (of 0.1 for smaller values).
    pub fn at(&self, argument: UnitArgument) -> Result<f64, HypergeometricError> {
        let (s, z, y) = (self.s, argument.value(), argument.complement());
        if z <= 0.5 || self.end == End::Polynomial {
            let [a, b, c] = self.gauss.parameters();
            return trusted(weighted(a, b, c, z, |n| s / (s + n)));
        }
        let excess = self.gauss.excess();
        if y == 0.0 && excess <= -1.0 {
            return Err(HypergeometricError::Divergent { excess: excess + 1.0 });
        }
        let integral = match &self.end {
            End::Powers(tail) => tail.integral(y, &self.gauss),
            End::Logarithmic | End::Polynomial => self.stepped(y),
        };
        // ln z from the complement if that is more accurate.
        let power = libm::exp(-s * libm::log1p(-y));
        trusted(integral.scaled(s * if y == 0.0 { 1.0 } else { power }))
    }

    fn stepped(&self, y: f64) -> Sum {
        let mut integral = self.half;
        let visit = |expansion: &Expansion, next: f64| {
            integral = integral.plus(step_integral(self.s, expansion, next));
        };
        let end = self.gauss.equation().carry(self.gauss.at_half(), y.max(INTEGRATION_END), visit);
        if y < INTEGRATION_END {
            // The rest of the leading power y^excess; for a regular F it is below rounding.
            let power = 1.0 + self.gauss.excess().min(0.0);
            let rest = end.value * end.y * part_above(y / end.y, power);
            integral = integral.plus(Sum { value: rest, size: rest.abs() });
        }
        integral
    }
}

impl Tail {
    fn new(s: f64, gauss: &Gauss, powers: Powers, half: Sum) -> Self {
        let ([a, b, c], excess) = (gauss.parameters(), gauss.excess());
        let mut regular = times_power(s, coefficients(a, b, 1.0 - excess));
        let mut singular = times_power(s, coefficients(c - a, c - b, 1.0 + excess));
        for n in 0..TERMS {
            let degree = n as f64 + 1.0;
            regular[n] *= powers.regular / degree;
            singular[n] *= powers.singular / (degree + excess);
        }
        let mut tail = Self { constant: Sum { value: 0.0, size: 0.0 }, regular, singular };
        tail.constant = half.plus(tail.integral(0.5, gauss).scaled(-1.0));
        tail
    }

    /// The integral of `t^(s - 1) F` from 0 to `1 - y`.
    fn integral(&self, y: f64, gauss: &Gauss) -> Sum {
        let regular = -y * polynomial(&self.regular, y);
        let singular = if y == 0.0 {
            0.0
        } else {
            -y * gauss.singular_power(y) * polynomial(&self.singular, y)
        };
        let size = regular.abs() + singular.abs();
        self.constant.plus(Sum { value: regular + singular, size })
    }
}

/// `int_ratio^1 t^(power - 1) dt`.
fn part_above(ratio: f64, power: f64) -> f64 {
    match (ratio > 0.0, power == 0.0) {
        (false, _) => 1.0 / power,
        (true, true) => -libm::log(ratio),
        (true, false) => -libm::expm1(power * libm::log(ratio)) / power,
    }
}

/// The coefficients of `2F1(a, b; c; y)`.
fn coefficients(a: f64, b: f64, c: f64) -> [f64; TERMS] {
    let mut list = [1.0; TERMS];
    for i in 1..TERMS {
        let n = i as f64 - 1.0;
        list[i] = list[i - 1] * (a + n) * (b + n) / ((c + n) * (n + 1.0));
    }
    list
}

/// The coefficients of `(1 - y)^(s - 1)` times the series.
fn times_power(s: f64, series: [f64; TERMS]) -> [f64; TERMS] {
    let power = coefficients(1.0 - s, 1.0, 1.0);
    let mut product = [0.0; TERMS];
    for (n, sum) in product.iter_mut().enumerate() {
        *sum = (0..=n).map(|k| series[k] * power[n - k]).sum();
    }
    product
}

fn polynomial(coefficients: &[f64], y: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * y + coefficient)
}

/// The integral of `t^(s - 1) F(t)` over one Taylor step to the distance `next` from 1.
fn step_integral(s: f64, expansion: &Expansion, next: f64) -> Sum {
    let (y, x) = (expansion.y, 1.0 - expansion.y);
    let tau = (y - next) / y;
    let scale = y * libm::pow(x, s - 1.0);
    let mut power = [1.0; super::continuation::TERMS];
    for i in 1..power.len() {
        let k = i as f64;
        power[i] = power[i - 1] * (s - k) / k * (y / x);
    }
    let mut integral = 0.0;
    for n in (0..power.len()).rev() {
        let product: f64 = (0..=n).map(|k| expansion.coefficients[k] * power[n - k]).sum();
        integral = integral * tau + product / (n as f64 + 1.0);
    }
    let value = integral * tau * scale;
    Sum { value, size: value.abs() }
}

/// 3F2(s, a, b; s + 1, c; z).
///
/// ```text
/// 3F2(s, a, b; s + 1, c; z) = sum_n (a)_n (b)_n / ((c)_n n!) s/(s + n) z^n
///                           = s z^(-s) int_0^z t^(s - 1) F(a, b; c; t) dt
/// ```
///
/// s above 0; s, a, b, c at most 5 in magnitude, c not 0, -1, -2, ...; z from 0 to 1, at 1 only if
/// `c - a - b > -1` or the series terminates. Up to 1/2 the series is summed; above, the expansion
/// of 2F1 in 1 - t is integrated term by term. The error is at most 1e-13, relative (absolute for
/// values below 0.1).
///
/// Source: DLMF 16.2.1, 15.8.4; thesis (9.20), (9.21).
///
/// # Errors
/// [`HypergeometricError`]: a parameter out of range, infinite at 1, or cancellation.
///
/// ```
/// use carom_special::hypergeometric::{UnitArgument, three_f_two};
/// // 3F2(1, 1/2, 1/2; 2, 1; m) integrates 2 K/pi over m: at m = 1 it is 4/pi.
/// let value = three_f_two(1.0, 0.5, 0.5, 1.0, UnitArgument::ONE)?;
/// assert!((value - 4.0 / std::f64::consts::PI).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn three_f_two(
    s: f64,
    a: f64,
    b: f64,
    c: f64,
    argument: UnitArgument,
) -> Result<f64, HypergeometricError> {
    ThreeFTwo::new(s, a, b, c)?.at(argument)
}
