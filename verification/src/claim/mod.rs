//! Claims: statements that a measurement can refute.

mod words;

use std::panic::Location;
pub use words::{number, significant};

/// A statement about a figure and the measurement that decides it.
///
/// A claim that cannot fail (an infinite tolerance, an empty list) counts as failed, and so does
/// one without a source of its expected value.
///
/// ```
/// use carom_verification::{Claim, Tolerance};
/// let claim = Claim::close("slope at 0 is 16/3", 5.3333, 16.0 / 3.0, Tolerance::Relative(1e-4));
/// assert!(claim.ratio() < 0.1);
/// assert!(!claim.passes());
/// assert!(claim.source("(5.98)").passes());
/// assert!(!Claim::at_most("below 3 %", 0.0335, 0.03).source("page 64").passes());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// The statement, in words.
    pub statement: String,
    /// Source of the expected value: the text of the thesis, a closed form, reference values.
    pub source: String,
    /// The measurement and its expectation.
    pub check: Check,
    /// Source location of the claim.
    pub place: &'static Location<'static>,
}

/// A measurement and its expectation.
#[derive(Debug, Clone, PartialEq)]
pub enum Check {
    /// A number and its expected value.
    Close {
        /// Measured value.
        measured: f64,
        /// Expected value.
        expected: f64,
        /// Allowed difference.
        tolerance: Tolerance,
    },
    /// Many numbers, each with its expected value; the worst decides.
    AllClose {
        /// Measured and expected values.
        pairs: Vec<Pair>,
        /// Allowed difference.
        tolerance: Tolerance,
    },
    /// A number and the bound it must respect.
    Bound {
        /// Measured value.
        measured: f64,
        /// The bound; a value equal to it is allowed.
        bound: f64,
        /// The allowed side.
        side: Side,
    },
    /// Numbers that must be in an order.
    Ordered {
        /// The values, in the order in which they are compared.
        values: Vec<f64>,
        /// The order.
        order: Order,
    },
    /// A condition and the number that it depends on.
    Holds {
        /// Whether the condition holds.
        holds: bool,
        /// The number that it depends on.
        measured: f64,
    },
}

/// A measured value beside its expected one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// Measured value.
    pub measured: f64,
    /// Expected value.
    pub expected: f64,
}

impl From<(f64, f64)> for Pair {
    /// (measured, expected)
    fn from((measured, expected): (f64, f64)) -> Self {
        Self { measured, expected }
    }
}

/// Allowed difference from an expected value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Tolerance {
    /// |measured - expected| at most this.
    Absolute(f64),
    /// |measured - expected| at most this times |expected|.
    Relative(f64),
}

impl Tolerance {
    /// The allowed difference from this expected value.
    fn allowed(self, expected: f64) -> f64 {
        match self {
            Self::Absolute(tolerance) => tolerance,
            Self::Relative(tolerance) => tolerance * expected.abs(),
        }
    }

    fn ratio(self, pair: Pair) -> f64 {
        let allowed = self.allowed(pair.expected);
        let difference = (pair.measured - pair.expected).abs();
        if !(allowed.is_finite() && allowed >= 0.0 && difference.is_finite()) {
            f64::INFINITY
        } else if difference == 0.0 {
            0.0
        } else {
            difference / allowed // infinite for a zero tolerance
        }
    }
}

/// The allowed side of a bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// At most the bound.
    Below,
    /// At least the bound.
    Above,
}

/// An order of values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Each larger than the one before.
    Increasing,
    /// Each smaller than the one before.
    Decreasing,
}

impl Claim {
    /// `measured` is `expected` within `tolerance`.
    #[must_use]
    #[track_caller]
    pub fn close(
        statement: impl Into<String>,
        measured: f64,
        expected: f64,
        tolerance: Tolerance,
    ) -> Self {
        Self::new(statement, Check::Close { measured, expected, tolerance })
    }

    /// Every (measured, expected) pair agrees within `tolerance`.
    #[must_use]
    #[track_caller]
    pub fn all_close<P: Into<Pair>>(
        statement: impl Into<String>,
        pairs: impl IntoIterator<Item = P>,
        tolerance: Tolerance,
    ) -> Self {
        let pairs = pairs.into_iter().map(Into::into).collect();
        Self::new(statement, Check::AllClose { pairs, tolerance })
    }

    /// `measured` is at most `bound`.
    #[must_use]
    #[track_caller]
    pub fn at_most(statement: impl Into<String>, measured: f64, bound: f64) -> Self {
        Self::new(statement, Check::Bound { measured, bound, side: Side::Below })
    }

    /// `measured` is at least `bound`.
    #[must_use]
    #[track_caller]
    pub fn at_least(statement: impl Into<String>, measured: f64, bound: f64) -> Self {
        Self::new(statement, Check::Bound { measured, bound, side: Side::Above })
    }

    /// Each value is larger than the one before.
    #[must_use]
    #[track_caller]
    pub fn increasing(statement: impl Into<String>, values: impl IntoIterator<Item = f64>) -> Self {
        let values = values.into_iter().collect();
        Self::new(statement, Check::Ordered { values, order: Order::Increasing })
    }

    /// Each value is smaller than the one before.
    #[must_use]
    #[track_caller]
    pub fn decreasing(statement: impl Into<String>, values: impl IntoIterator<Item = f64>) -> Self {
        let values = values.into_iter().collect();
        Self::new(statement, Check::Ordered { values, order: Order::Decreasing })
    }

    /// A condition holds; `measured` is the number that shows it.
    #[must_use]
    #[track_caller]
    pub fn holds(statement: impl Into<String>, holds: bool, measured: f64) -> Self {
        Self::new(statement, Check::Holds { holds, measured })
    }

    #[track_caller]
    fn new(statement: impl Into<String>, check: Check) -> Self {
        let place = Location::caller();
        Self { statement: statement.into(), source: String::new(), check, place }
    }

    /// Sets the source of the expected value.
    #[must_use]
    pub fn source(mut self, source: impl Into<String>) -> Self {
        self.source = source.into();
        self
    }

    /// Whether the claim has a source and the measurement satisfies it.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.has_source() && self.ratio() <= 1.0
    }

    /// Whether the claim has a source.
    #[must_use]
    pub fn has_source(&self) -> bool {
        !self.source.trim().is_empty()
    }

    /// Deviation over tolerance: at most 1 if the claim passes, infinite if the deviation is not a
    /// number. For a bound it is the share of it that is used; for an order or a condition, 0 or
    /// infinity.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        match &self.check {
            Check::Close { measured, expected, tolerance } => {
                tolerance.ratio(Pair { measured: *measured, expected: *expected })
            }
            Check::AllClose { .. } => {
                self.worst().map_or(f64::INFINITY, |(pair, tolerance)| tolerance.ratio(pair))
            }
            Check::Bound { measured, bound, side: Side::Below } => part_used(*measured, *bound),
            Check::Bound { measured, bound, side: Side::Above } => part_used(-measured, -bound),
            Check::Ordered { values, order } => decided(is_ordered(values, *order)),
            Check::Holds { holds, measured } => decided(*holds && !measured.is_nan()),
        }
    }

    /// The worst pair of an all-close check.
    #[must_use]
    fn worst(&self) -> Option<(Pair, Tolerance)> {
        let Check::AllClose { pairs, tolerance } = &self.check else { return None };
        pairs
            .iter()
            .max_by(|a, b| tolerance.ratio(**a).total_cmp(&tolerance.ratio(**b)))
            .map(|pair| (*pair, *tolerance))
    }
}

/// The share of an upper bound that a value uses: at most 1 if the value satisfies it.
fn part_used(measured: f64, bound: f64) -> f64 {
    if !bound.is_finite() || measured.is_nan() {
        f64::INFINITY
    } else if measured <= bound {
        let used = if bound > 0.0 { measured / bound } else { bound / measured };
        if used.is_finite() { used.clamp(0.0, 1.0) } else { 0.0 }
    } else if bound > 0.0 {
        measured / bound
    } else if measured < 0.0 {
        bound / measured
    } else {
        f64::INFINITY
    }
}

const fn decided(holds: bool) -> f64 {
    if holds { 0.0 } else { f64::INFINITY }
}

fn is_ordered(values: &[f64], order: Order) -> bool {
    values.len() > 1
        && values.windows(2).all(|pair| match order {
            Order::Increasing => pair[0] < pair[1],
            Order::Decreasing => pair[0] > pair[1],
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratio_is_deviation_over_tolerance() {
        let claim = Claim::close("", 1.5, 1.0, Tolerance::Absolute(2.0));
        assert_eq!(claim.ratio(), 0.25);
        let claim = Claim::close("", -3.0, -2.0, Tolerance::Relative(0.25));
        assert_eq!(claim.ratio(), 2.0);
        assert!(!claim.source("given").passes());
    }

    #[test]
    fn a_claim_needs_a_source() {
        let claim = Claim::at_most("small", 1.0, 2.0);
        assert_eq!(claim.place.line(), line!() - 1);
        assert!(!claim.passes());
        assert!(!claim.clone().source(" ").passes());
        assert!(claim.source("(5.3)").passes());
    }

    #[test]
    fn the_worst_pair_decides() {
        let pairs = [(1.0, 1.0), (2.0, 2.5), (3.0, 3.1)];
        let claim = Claim::all_close("", pairs, Tolerance::Absolute(0.4));
        assert_eq!(claim.ratio(), 0.5 / 0.4);
        assert_eq!(claim.measured(), "worst of 3: 2");
        assert_eq!(claim.expected(), "2.5 ± 0.4");
    }

    #[test]
    fn bounds_use_up_to_all_of_themselves() {
        for (measured, bound, ratio) in [
            (1.0, 2.0, 0.5),
            (2.0, 2.0, 1.0),
            (3.0, 2.0, 1.5),
            (-1.0, 2.0, 0.0),
            (-2.0, -1.0, 0.5),
            (-0.5, -1.0, 2.0),
            (0.0, -1.0, f64::INFINITY),
            (0.0, 0.0, 0.0),
            (1e-9, 0.0, f64::INFINITY),
        ] {
            assert_eq!(Claim::at_most("", measured, bound).ratio(), ratio, "{measured} {bound}");
            assert_eq!(Claim::at_least("", -measured, -bound).ratio(), ratio);
        }
    }

    #[test]
    fn orders_are_strict() {
        assert_eq!(Claim::increasing("", [1.0, 2.0, 3.0]).ratio(), 0.0);
        assert_eq!(Claim::increasing("", [1.0, 2.0, 2.0]).ratio(), f64::INFINITY);
        assert_eq!(Claim::decreasing("", [3.0, 2.0]).ratio(), 0.0);
        assert_eq!(Claim::decreasing("", [3.0, f64::NAN]).ratio(), f64::INFINITY);
    }

    #[test]
    fn what_cannot_fail_counts_as_failed() {
        let nothing: [(f64, f64); 0] = [];
        for claim in [
            Claim::close("", 1.0, 1.0, Tolerance::Absolute(f64::INFINITY)),
            Claim::close("", f64::NAN, 1.0, Tolerance::Absolute(1.0)),
            Claim::close("", f64::INFINITY, f64::INFINITY, Tolerance::Absolute(1.0)),
            Claim::all_close("", nothing, Tolerance::Absolute(1.0)),
            Claim::at_most("", 1.0, f64::INFINITY),
            Claim::at_most("", f64::NAN, 1.0),
            Claim::increasing("", [1.0]),
            Claim::holds("", true, f64::NAN),
            Claim::holds("", false, 1.0),
        ] {
            assert_eq!(claim.ratio(), f64::INFINITY, "{claim:?}");
            assert!(!claim.source("given").passes());
        }
    }
}
