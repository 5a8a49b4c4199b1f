//! The double exponential (tanh-sinh) rule of Takahasi and Mori.

use super::{Integral, QuadratureError, Tolerance, check_bounds, finite};
use std::f64::consts::{FRAC_PI_2, PI};

/// Step halvings after the first sum with step 1/2.
const LEVELS: u32 = 9;

/// Beyond this t the distance to the end of a unit interval underflows.
const REACH: f64 = 6.1;

/// A point of an interval with its distances to both ends, which are exact where the position is
/// rounded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Abscissa {
    /// The position.
    pub position: f64,
    /// The distance `position - lower`, signed as `upper - lower`.
    pub from_lower: f64,
    /// The distance `upper - position`, signed as `upper - lower`.
    pub to_upper: f64,
}

/// The integral of `function` from `lower` to `upper`; the integrand may have integrable
/// singularities at the ends.
///
/// With `x = (lower + upper)/2 + (upper - lower)/2 tanh((pi/2) sinh t)` the trapezoidal rule in t
/// converges exponentially for an integrand that is analytic inside the interval. An integrand that
/// is singular at an end other than 0 must use [`Abscissa::from_lower`] or [`Abscissa::to_upper`],
/// because the position is rounded to the end.
///
/// Source: H. Takahasi and M. Mori, Publ. RIMS Kyoto 9 (1974) 721-741.
///
/// # Errors
/// [`QuadratureError`] if a bound or the integrand is not finite, or if the tolerance is not met.
///
/// ```
/// use carom_special::quadrature::{Tolerance, tanh_sinh};
/// // int_0^1 dx/sqrt(x (1 - x)) = pi
/// let integral = tanh_sinh(0.0, 1.0, Tolerance::relative(1e-13)?, |at| {
///     1.0 / (at.from_lower * at.to_upper).sqrt()
/// })?;
/// assert!((integral.value - std::f64::consts::PI).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn tanh_sinh(
    lower: f64,
    upper: f64,
    tolerance: Tolerance,
    mut function: impl FnMut(Abscissa) -> f64,
) -> Result<Integral, QuadratureError> {
    check_bounds(lower, upper)?;
    let mut rule = Rule { lower, upper, evaluations: 0 };
    let mut step = 0.5;
    let mut sum = rule.sum(0.0, step, &mut function)?;
    let mut integral = Integral { value: sum * step, error: f64::INFINITY, evaluations: 0 };
    for _ in 0..LEVELS {
        sum += rule.sum(0.5 * step, step, &mut function)?;
        step *= 0.5;
        let value = sum * step;
        // The error of a level is about the square of the error of the previous one.
        let change = (value - integral.value).abs();
        integral = Integral { value, error: change, evaluations: rule.evaluations };
        if step < 0.2 && tolerance.allows(integral) {
            return Ok(integral);
        }
    }
    Err(QuadratureError::NotConverged { integral })
}

struct Rule {
    lower: f64,
    upper: f64,
    evaluations: usize,
}

impl Rule {
    /// The sum over t = +-(first + i step); t = 0 counts once.
    fn sum(
        &mut self,
        first: f64,
        step: f64,
        function: &mut impl FnMut(Abscissa) -> f64,
    ) -> Result<f64, QuadratureError> {
        let count = ((REACH - first) / step) as u32;
        let mut sum = 0.0;
        // From the ends inwards, so that small terms are added first.
        for i in (0..=count).rev() {
            let t = first + f64::from(i) * step;
            sum += self.pair(t, function)?;
        }
        Ok(sum)
    }

    fn pair(
        &mut self,
        t: f64,
        function: &mut impl FnMut(Abscissa) -> f64,
    ) -> Result<f64, QuadratureError> {
        let width = self.upper - self.lower;
        let decay = libm::exp(-2.0 * FRAC_PI_2 * libm::sinh(t));
        let near = decay / (1.0 + decay);
        let far = 1.0 / (1.0 + decay);
        let weight = PI * libm::cosh(t) * near * far * width;
        if near * width == 0.0 || weight == 0.0 {
            return Ok(0.0);
        }
        let (near, far) = (near * width, far * width);
        let low = Abscissa { position: self.lower + near, from_lower: near, to_upper: far };
        let mut value = self.evaluate(low, function)?;
        if t != 0.0 {
            let high = Abscissa { position: self.upper - near, from_lower: far, to_upper: near };
            value += self.evaluate(high, function)?;
        }
        Ok(value * weight)
    }

    fn evaluate(
        &mut self,
        at: Abscissa,
        function: &mut impl FnMut(Abscissa) -> f64,
    ) -> Result<f64, QuadratureError> {
        self.evaluations += 1;
        finite(function(at), at.position)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RangeError;

    fn tolerance() -> Tolerance {
        Tolerance::relative(1e-12).expect("tolerance")
    }

    #[test]
    fn end_singularities() -> Result<(), QuadratureError> {
        let log = tanh_sinh(0.0, 1.0, tolerance(), |at| libm::log(at.from_lower))?;
        assert!((log.value + 1.0).abs() < 1e-14, "{log:?}");
        let power = tanh_sinh(1.0, 3.0, tolerance(), |at| libm::pow(at.from_lower, -0.9))?;
        assert!((power.value / (10.0 * libm::pow(2.0, 0.1)) - 1.0).abs() < 1e-13, "{power:?}");
        let reverse = tanh_sinh(3.0, 1.0, tolerance(), |at| at.position * at.position)?;
        assert!((reverse.value + 26.0 / 3.0).abs() < 1e-13, "{reverse:?}");
        Ok(())
    }

    #[test]
    fn not_met_or_not_finite_is_an_error() {
        let jump = |at: Abscissa| if at.position < 0.3 { 0.0 } else { 1.0 };
        match tanh_sinh(0.0, 1.0, tolerance(), jump) {
            Err(QuadratureError::NotConverged { integral }) => {
                assert!((integral.value - 0.7).abs() < 10.0 * integral.error);
            }
            other => panic!("{other:?}"),
        }
        let pole = tanh_sinh(0.0, 1.0, tolerance(), |at| 1.0 / (at.position - 0.5));
        assert_eq!(pole, Err(QuadratureError::Undefined { position: 0.5 }));
        let bounds = tanh_sinh(0.0, f64::NAN, tolerance(), |_| 1.0);
        assert!(matches!(bounds, Err(QuadratureError::Range(RangeError { field: "upper", .. }))));
    }
}
