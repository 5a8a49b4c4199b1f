//! Gauss's hypergeometric function 2F1 on [0, 1].

use super::UnitArgument;
use super::continuation::{Equation, State, start};
use super::error::HypergeometricError;
use super::series::{Sum, weighted};
use crate::RangeError;
use crate::gamma::{gamma, is_pole, reciprocal};

/// The largest parameter in absolute value.
pub(super) const LARGEST_PARAMETER: f64 = 5.0;

/// If `c - a - b` is closer than this to an integer, the connection formula loses too many digits.
const NEAR_INTEGER: f64 = 0.05;

/// The specified error of a value: relative, and absolute for values below 0.1.
const SPECIFIED_ERROR: f64 = 1e-13;

/// The function 2F1(a, b; c; .) with fixed parameters, prepared for repeated evaluation.
///
/// ```text
/// F(a, b; c; x) = sum_n (a)_n (b)_n / ((c)_n n!) x^n
/// ```
///
/// Use this form to evaluate one function at many arguments; [`gauss`] for a single value.
///
/// ```
/// use carom_special::hypergeometric::{Gauss, UnitArgument};
/// // F(1/2, 1; 3/2; x^2) = artanh(x)/x
/// let function = Gauss::new(0.5, 1.0, 1.5)?;
/// let value = function.at(UnitArgument::new(0.81)?)?;
/// assert!((value - 0.9_f64.atanh() / 0.9).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gauss {
    a: f64,
    b: f64,
    c: f64,
    excess: f64,
    end: End,
}

/// The method used between 1/2 and 1.
#[derive(Debug, Clone, Copy, PartialEq)]
enum End {
    /// A polynomial in x.
    Polynomial,
    /// DLMF 15.8.4: a regular series in 1 - x and one times `(1 - x)^(c - a - b)`.
    Powers(Powers),
    /// `c - a - b` is close to an integer: Taylor steps.
    Logarithmic,
}

/// The factors of the two series in DLMF 15.8.4.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Powers {
    pub(super) regular: f64,
    pub(super) singular: f64,
}

impl Gauss {
    /// Prepares the function with the parameters `a`, `b`, `c`.
    ///
    /// # Errors
    /// [`RangeError`] unless all are finite, from -5 to 5, and `c` is not 0, -1, -2, ...
    pub fn new(a: f64, b: f64, c: f64) -> Result<Self, HypergeometricError> {
        check(a, b, c)?;
        // The function is symmetric in a and b; so is its rounding error.
        let (a, b) = (a.min(b), a.max(b));
        let excess = c - a - b;
        let end = if is_pole(a) || is_pole(b) {
            End::Polynomial
        } else if (excess - libm::round(excess)).abs() < NEAR_INTEGER {
            End::Logarithmic
        } else {
            End::Powers(Powers {
                regular: gamma(c) * gamma(excess) * reciprocal(c - a) * reciprocal(c - b),
                singular: gamma(c) * gamma(-excess) * reciprocal(a) * reciprocal(b),
            })
        };
        Ok(Self { a, b, c, excess, end })
    }

    /// The value at `argument`.
    ///
    /// # Errors
    /// [`HypergeometricError`] if the value is infinite at 1, or if cancellation costs more than
    /// 1e-13 of the value (of 0.1 for smaller values). This does not occur for the parameters of
    /// the thesis, and for fewer than one in a hundred random sets.
    pub fn at(&self, argument: UnitArgument) -> Result<f64, HypergeometricError> {
        let &Self { a, b, c, .. } = self;
        let (x, y) = (argument.value(), argument.complement());
        if x <= 0.5 || self.end == End::Polynomial {
            return trusted(weighted(a, b, c, x, |_| 1.0));
        }
        if y == 0.0 {
            return self.at_one();
        }
        match self.end {
            End::Powers(powers) => trusted(self.about_one(y, powers)),
            End::Logarithmic | End::Polynomial => trusted(self.stepped(y)),
        }
    }

    /// Gauss's sum, DLMF 15.4.20.
    fn at_one(&self) -> Result<f64, HypergeometricError> {
        let &Self { a, b, c, excess, .. } = self;
        if excess <= 0.0 {
            return Err(HypergeometricError::Divergent { excess });
        }
        let reciprocals = reciprocal(c - a) * reciprocal(c - b);
        if reciprocals == 0.0 {
            return Ok(0.0);
        }
        // The others overflow at 0.
        let value = gamma(c) * gamma(excess) * reciprocals;
        if value.is_finite() { Ok(value) } else { Err(HypergeometricError::Overflow) }
    }

    fn about_one(&self, y: f64, powers: Powers) -> Sum {
        let &Self { a, b, c, excess, .. } = self;
        let power = powers.singular * self.singular_power(y);
        let first = weighted(a, b, 1.0 - excess, y, |_| 1.0).scaled(powers.regular);
        first.plus(weighted(c - a, c - b, 1.0 + excess, y, |_| 1.0).scaled(power))
    }

    /// Taylor steps for F or `(1 - x)^(a + b - c) F` (DLMF 15.8.1), whichever is bounded.
    fn stepped(&self, y: f64) -> Sum {
        let &Self { a, b, c, excess, .. } = self;
        if excess < 0.0 {
            let bounded = Self { a: c - a, b: c - b, c, excess: -excess, end: self.end };
            return bounded.stepped(y).scaled(self.singular_power(y));
        }
        let start = self.at_half();
        let value = self.equation().carry(start, y, |_, _| ()).value;
        Sum { value, size: value.abs().max(start.size) }
    }

    /// `y^(c - a - b)`; far from 1 it would magnify the rounding error of the exponent.
    pub(super) fn singular_power(&self, y: f64) -> f64 {
        let &Self { a, b, c, excess, .. } = self;
        let (first, lost) = difference(c, a);
        let rest = lost + difference(first, b).1;
        libm::pow(y, excess) * (1.0 + rest * libm::log(y))
    }

    pub(super) const fn parameters(&self) -> [f64; 3] {
        [self.a, self.b, self.c]
    }

    pub(super) const fn excess(&self) -> f64 {
        self.excess
    }

    pub(super) const fn powers(&self) -> Option<Powers> {
        if let End::Powers(powers) = self.end { Some(powers) } else { None }
    }

    pub(super) fn is_polynomial(&self) -> bool {
        self.end == End::Polynomial
    }

    pub(super) fn equation(&self) -> Equation {
        Equation { a: self.a, b: self.b, excess: self.excess }
    }

    /// Value and derivative at 1/2.
    pub(super) fn at_half(&self) -> State {
        let &Self { a, b, c, .. } = self;
        let slope = weighted(a + 1.0, b + 1.0, c + 1.0, 0.5, |_| 1.0).scaled(a * b / c);
        start(weighted(a, b, c, 0.5, |_| 1.0), slope)
    }
}

/// 2F1(a, b; c; x), Gauss's hypergeometric function.
///
/// ```text
/// F(a, b; c; x) = sum_n (a)_n (b)_n / ((c)_n n!) x^n,   (a)_n = a (a + 1) ... (a + n - 1)
/// ```
///
/// Parameters from -5 to 5, c not 0, -1, -2, ...; x from 0 to 1, at 1 only if `c - a - b > 0` or
/// the series terminates. Up to 1/2 the series is summed. Above 1/2 its transformation to 1 - x is
/// used, or Taylor steps of its differential equation if `c - a - b` is within 0.05 of an integer.
/// The error is at most 1e-13, relative (absolute for values below 0.1); if cancellation makes it
/// larger, an error is returned.
///
/// Source: DLMF 15.2.1, 15.8.4, 15.10.1; thesis (9.9), (9.17).
///
/// # Errors
/// [`HypergeometricError`]: a parameter out of range, infinite at 1, or cancellation.
///
/// ```
/// use carom_special::hypergeometric::{UnitArgument, gauss};
/// // Half the duration of a Hertz impact, (9.8): F(1/2, 2/5; 7/5; 1).
/// let value = gauss(0.5, 0.4, 1.4, UnitArgument::ONE)?;
/// assert!((value - 1.471_637_592_162_352).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn gauss(a: f64, b: f64, c: f64, argument: UnitArgument) -> Result<f64, HypergeometricError> {
    if argument.value() <= 0.5 {
        check(a, b, c)?;
        return trusted(weighted(a, b, c, argument.value(), |_| 1.0));
    }
    Gauss::new(a, b, c)?.at(argument)
}

/// Whether the parameters are in range.
fn check(a: f64, b: f64, c: f64) -> Result<(), RangeError> {
    for (field, value) in [("a", a), ("b", b), ("c", c)] {
        RangeError::check(field, value, value.abs() <= LARGEST_PARAMETER, "from -5 to 5")?;
    }
    RangeError::check("c", c, !is_pole(c), "no pole: not 0, -1, -2, ...")?;
    Ok(())
}

/// `x - y` rounded, and its rounding error.
fn difference(x: f64, y: f64) -> (f64, f64) {
    let rounded = x - y;
    let subtracted = x - rounded;
    (rounded, (x - (rounded + subtracted)) + (subtracted - y))
}

/// The value of a sum, if cancellation has not made it inaccurate.
pub(super) fn trusted(sum: Sum) -> Result<f64, HypergeometricError> {
    let bound = f64::EPSILON * sum.size;
    if !sum.value.is_finite() {
        return Err(HypergeometricError::Overflow);
    }
    if bound > SPECIFIED_ERROR * sum.value.abs().max(0.1) {
        return Err(HypergeometricError::Cancellation { value: sum.value, bound });
    }
    Ok(sum.value)
}
