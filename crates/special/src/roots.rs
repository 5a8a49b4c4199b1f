//! Roots of a continuous function in a bracket, and the point where a condition changes.

use std::convert::Infallible;

use crate::RangeError;

/// Greatest number of evaluations. Brent's method needs far fewer; so many bisections would
/// separate all numbers of an interval.
const MOST_EVALUATIONS: usize = 4500;

/// Number of bisections after which no number lies between the ends of any interval.
pub const ALL_DIGITS: usize = 2200;

/// An interval `lower < upper`, both finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bracket {
    lower: f64,
    upper: f64,
}

impl Bracket {
    /// The interval from `lower` to `upper`.
    ///
    /// # Errors
    /// [`RangeError`] unless both are finite, `lower < upper` and their difference is finite.
    pub fn new(lower: f64, upper: f64) -> Result<Self, RangeError> {
        RangeError::finite("lower", lower)?;
        let holds = upper > lower && (upper - lower).is_finite();
        RangeError::check("upper", upper, holds, "finite and > lower")?;
        Ok(Self { lower, upper })
    }

    /// The lower end.
    #[must_use]
    pub const fn lower(self) -> f64 {
        self.lower
    }

    /// The upper end.
    #[must_use]
    pub const fn upper(self) -> f64 {
        self.upper
    }
}

/// A root, with the last bracket.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    /// The end of the last bracket at which |function| is smaller.
    pub position: f64,
    /// The value of the function at `position`.
    pub residual: f64,
    /// The other end of the last bracket; equal to `position` at an exact zero.
    pub opposite: f64,
    /// Number of evaluations of the function.
    pub evaluations: usize,
}

/// Why no root was found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum RootError {
    /// The tolerance is negative or NaN.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The function has the same sign at both ends.
    #[error("no change of sign: the function is {at_lower} at {lower} and {at_upper} at {upper}")]
    NotBracketed {
        /// The lower end.
        lower: f64,
        /// The upper end.
        upper: f64,
        /// The function at the lower end.
        at_lower: f64,
        /// The function at the upper end.
        at_upper: f64,
    },
    /// The function is NaN somewhere in the bracket.
    #[error("the function is undefined at {position}")]
    Undefined {
        /// The point at which it is NaN.
        position: f64,
    },
    /// The bracket is still wider than required after the greatest number of evaluations.
    #[error("no convergence after {} evaluations: root near {}", best.evaluations, best.position)]
    NotConverged {
        /// The best bracket.
        best: Root,
    },
}

/// A root of `function` in `bracket` by Brent's method (inverse quadratic interpolation, secant,
/// bisection).
///
/// The root returned is within `tolerance + 2 eps |root|` of a change of sign; a tolerance of 0
/// gives full accuracy. The function may be infinite in the bracket but not NaN. Nothing is
/// allocated, and the same function gives the same bits.
///
/// Source: R. P. Brent, Algorithms for Minimization without Derivatives (1973), chapter 4.
///
/// # Errors
/// [`RootError`] if the function does not change sign over the bracket or is NaN, if the tolerance
/// is out of range, or if the iteration does not converge (with the best bracket).
///
/// ```
/// use carom_special::roots::{self, Bracket};
/// let root = roots::brent(|x| x * x - 2.0, Bracket::new(0.0, 2.0)?, 0.0)?;
/// assert!((root.position - std::f64::consts::SQRT_2).abs() < 4e-16);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn brent(
    mut function: impl FnMut(f64) -> f64,
    bracket: Bracket,
    tolerance: f64,
) -> Result<Root, RootError> {
    RangeError::check("tolerance", tolerance, tolerance >= 0.0, ">= 0")?;
    let mut search = Search::begin(&mut function, bracket)?;
    while search.evaluations < MOST_EVALUATIONS {
        search.order();
        let half = 0.5 * (search.c.x - search.b.x);
        let reach = 0.5 * tolerance + 2.0 * f64::EPSILON * search.b.x.abs();
        // The smallest positive number is the final tolerance for a root at zero.
        let reach = reach.max(f64::from_bits(1));
        if half.abs() <= reach || search.b.f == 0.0 {
            return Ok(search.best());
        }
        search.step(half, reach, &mut function)?;
    }
    Err(RootError::NotConverged { best: search.best() })
}

/// Bisects the interval between two points for the place where `is_before`, true at the first and
/// false at the second, changes: at most `halvings` times, while there are numbers in between.
/// Returns both ends.
///
/// ```
/// use carom_special::roots::{ALL_DIGITS, bisect};
/// let [below, above] = bisect([1.0, 2.0], ALL_DIGITS, |x| x * x < 2.0);
/// assert!(below * below < 2.0 && above == below.next_up());
/// ```
pub fn bisect(ends: [f64; 2], halvings: usize, mut is_before: impl FnMut(f64) -> bool) -> [f64; 2] {
    let Ok(ends) = try_bisect(ends, halvings, |x| Ok::<_, Infallible>(is_before(x)));
    ends
}

/// [`bisect`] with a condition that may fail.
///
/// # Errors
/// The first error returned by the condition.
pub fn try_bisect<E>(
    [mut from, mut to]: [f64; 2],
    halvings: usize,
    mut is_before: impl FnMut(f64) -> Result<bool, E>,
) -> Result<[f64; 2], E> {
    for _ in 0..halvings {
        let middle = middle(from, to);
        if middle == from || middle == to {
            break;
        }
        if is_before(middle)? { from = middle } else { to = middle }
    }
    Ok([from, to])
}

/// Half of the sum, which may overflow.
fn middle(from: f64, to: f64) -> f64 {
    let sum = from + to;
    if sum.is_finite() { 0.5 * sum } else { 0.5 * from + 0.5 * to }
}

#[derive(Clone, Copy)]
struct Point {
    x: f64,
    f: f64,
}

impl Point {
    fn at(x: f64, function: &mut impl FnMut(f64) -> f64) -> Result<Self, RootError> {
        let f = function(x);
        if f.is_nan() { Err(RootError::Undefined { position: x }) } else { Ok(Self { x, f }) }
    }
}

/// Brent's state: `b` is the best point, `a` the previous one, `c` the end opposite to `b`.
struct Search {
    a: Point,
    b: Point,
    c: Point,
    last_step: f64,
    step_before: f64,
    evaluations: usize,
}

impl Search {
    fn begin(function: &mut impl FnMut(f64) -> f64, bracket: Bracket) -> Result<Self, RootError> {
        let a = Point::at(bracket.lower, function)?;
        let b = Point::at(bracket.upper, function)?;
        if a.f.signum() == b.f.signum() && a.f != 0.0 && b.f != 0.0 {
            return Err(RootError::NotBracketed {
                lower: a.x,
                upper: b.x,
                at_lower: a.f,
                at_upper: b.f,
            });
        }
        let width = b.x - a.x;
        let mut search = Self { a, b, c: a, last_step: width, step_before: width, evaluations: 2 };
        if a.f == 0.0 {
            search.b = a;
        }
        Ok(search)
    }

    /// Exchanges the ends if needed, so that `b` is the better end of the bracket `b`, `c`.
    fn order(&mut self) {
        if (self.b.f > 0.0) == (self.c.f > 0.0) && self.c.f != 0.0 {
            self.c = self.a;
            self.last_step = self.b.x - self.a.x;
            self.step_before = self.last_step;
        }
        if self.c.f.abs() < self.b.f.abs() {
            self.a = self.b;
            self.b = self.c;
            self.c = self.a;
        }
    }

    fn step(
        &mut self,
        half: f64,
        reach: f64,
        function: &mut impl FnMut(f64) -> f64,
    ) -> Result<(), RootError> {
        match self.interpolation(half, reach) {
            Some(step) => {
                self.step_before = self.last_step;
                self.last_step = step;
            }
            None => {
                self.step_before = half;
                self.last_step = half;
            }
        }
        self.a = self.b;
        let step = if self.last_step.abs() > reach { self.last_step } else { reach.copysign(half) };
        self.b = Point::at(self.b.x + step, function)?;
        self.evaluations += 1;
        Ok(())
    }

    /// The interpolated step, if it stays well inside the bracket and the steps decrease.
    fn interpolation(&self, half: f64, reach: f64) -> Option<f64> {
        let Self { a, b, c, .. } = *self;
        let finite = a.f.is_finite() && c.f.is_finite();
        if !finite || self.step_before.abs() < reach || a.f.abs() <= b.f.abs() {
            return None;
        }
        let s = b.f / a.f;
        let (p, q) = if a.x == c.x {
            (2.0 * half * s, 1.0 - s)
        } else {
            let (t, r) = (a.f / c.f, b.f / c.f);
            let p = s * (2.0 * half * t * (t - r) - (b.x - a.x) * (r - 1.0));
            (p, (t - 1.0) * (r - 1.0) * (s - 1.0))
        };
        let (p, q) = if p > 0.0 { (p, -q) } else { (-p, q) };
        let bound = (3.0 * half * q - (reach * q).abs()).min((self.step_before * q).abs());
        (2.0 * p < bound).then(|| p / q)
    }

    fn best(&self) -> Root {
        let opposite = if self.b.f == 0.0 { self.b.x } else { self.c.x };
        Root { position: self.b.x, residual: self.b.f, opposite, evaluations: self.evaluations }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(function: impl FnMut(f64) -> f64, lower: f64, upper: f64) -> Root {
        brent(function, Bracket::new(lower, upper).expect("bracket"), 0.0).expect("root")
    }

    #[test]
    fn smooth_roots_to_the_last_digits() {
        type Function = fn(f64) -> f64;
        let cases: [(Function, f64, f64, f64); 5] = [
            (|x| libm::cos(x) - x, 0.0, 1.0, 0.739_085_133_215_160_6),
            (|x| x * x * x - 2.0 * x - 5.0, 2.0, 3.0, 2.094_551_481_542_326_6),
            (|x| libm::exp(x) - 1e10, 0.0, 30.0, 23.025_850_929_940_457),
            (|x| x - 1e-200, 0.0, 1.0, 1e-200),
            (|x| 1.0 / x - 3.0, 0.0, 1.0, 1.0 / 3.0),
        ];
        for (function, lower, upper, exact) in cases {
            let found = root(function, lower, upper);
            assert!((found.position / exact - 1.0).abs() < 1e-15, "{found:?}");
            assert!(found.evaluations < 100, "{found:?}");
        }
    }

    #[test]
    fn steps_poles_and_flat_roots_end() {
        assert!(root(|x| if x < 0.3 { -1.0 } else { 1.0 }, 0.0, 1.0).evaluations < 120);
        assert!(root(|x| libm::pow(x - 0.7, 9.0), 0.0, 1.0).evaluations < 300);
        let (ninth, steep) = (root(|x| libm::pow(x, 9.0), -1.0, 1.5), root(libm::cbrt, -1.0, 2.0));
        assert!(ninth.position.abs() < 1e-30 && steep.position.abs() < 1e-300);
        assert!(steep.evaluations < MOST_EVALUATIONS);
    }

    #[test]
    fn exact_zero_at_an_end() {
        assert_eq!(root(|x| x, 0.0, 1.0).position, 0.0);
        assert_eq!(root(|x| x - 1.0, 0.0, 1.0).position, 1.0);
    }

    #[test]
    fn halves_end_at_neighbours_also_downwards_and_at_zero() {
        for ends in [[3.0, -1.0], [0.0, 1.0], [-1e300, 1e300]] {
            let sign = f64::signum(ends[1] - ends[0]);
            let [before, after] = bisect(ends, ALL_DIGITS, |x| sign * (x - 0.1) < 0.0);
            let middle = 0.5 * (before + after);
            assert!(after == 0.1 && before != 0.1 && (middle == before || middle == after));
        }
        assert_eq!(bisect([0.0, 1.0], ALL_DIGITS, |_| false), [0.0, f64::from_bits(1)]);
        assert_eq!(bisect([0.0, 1.0], 3, |x| x < 0.7), [0.625, 0.75]);
        assert_eq!(try_bisect([0.0, 1.0], 3, |_| Err::<bool, _>("fails")), Err("fails"));
    }

    #[test]
    fn bisection_of_the_largest_numbers_stays_between_the_ends() {
        let ends = bisect([1.5e308, f64::MAX], ALL_DIGITS, |x| x < 1.6e308);
        assert!(ends[0] < 1.6e308 && ends[1] == 1.6e308, "{ends:?}");
    }

    #[test]
    fn bad_input_is_named() {
        assert_eq!(Bracket::new(1.0, 1.0).unwrap_err().field, "upper");
        assert_eq!(Bracket::new(f64::NAN, 1.0).unwrap_err().field, "lower");
        assert_eq!(Bracket::new(0.0, f64::INFINITY).unwrap_err().field, "upper");
        let bracket = Bracket::new(0.0, 1.0).expect("bracket");
        assert!(matches!(brent(|_| 1.0, bracket, 0.0), Err(RootError::NotBracketed { .. })));
        assert!(matches!(brent(|x| x.ln(), bracket, -1.0), Err(RootError::Range(_))));
        let undefined = |x: f64| if x > 0.4 && x < 0.9 { f64::NAN } else { x - 0.5 };
        assert!(matches!(brent(undefined, bracket, 0.0), Err(RootError::Undefined { .. })));
    }
}
