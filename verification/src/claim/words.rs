//! Claims in words and numbers, with as many digits as the tolerance makes sensible.

use super::{Check, Claim, Order, Pair, Side, Tolerance};
use std::fmt;

/// Digits of a measurement without tolerance.
const DIGITS: usize = 4;
/// Most digits of any number.
const MOST_DIGITS: usize = 10;
/// Digits of a tolerance.
const TOLERANCE_DIGITS: usize = 3;

impl fmt::Display for Tolerance {
    /// `± 0.07`, `± 2 %`, `± 1e-13 relative`, or `exactly`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Absolute(0.0) | Self::Relative(0.0) => f.write_str("exactly"),
            Self::Absolute(tolerance) => {
                write!(f, "± {}", significant(tolerance, TOLERANCE_DIGITS))
            }
            Self::Relative(tolerance) if (1e-3..10.0).contains(&tolerance) => {
                write!(f, "± {} %", significant(100.0 * tolerance, TOLERANCE_DIGITS))
            }
            Self::Relative(tolerance) => {
                write!(f, "± {} relative", significant(tolerance, TOLERANCE_DIGITS))
            }
        }
    }
}

impl Claim {
    /// The measurement in words and numbers, to one digit more than its tolerance.
    #[must_use]
    pub fn measured(&self) -> String {
        match &self.check {
            Check::Close { measured, expected, tolerance } => {
                fitting(*measured, tolerance.allowed(*expected), 1)
            }
            Check::Bound { measured, bound, .. } => told_apart(*measured, *bound)[0].clone(),
            Check::Holds { holds, measured } => {
                let word = if *holds { "yes" } else { "no" };
                format!("{word} ({})", significant(*measured, DIGITS))
            }
            Check::AllClose { pairs, .. } => match self.worst() {
                Some((Pair { measured, expected }, tolerance)) => {
                    let number = fitting(measured, tolerance.allowed(expected), 1);
                    format!("worst of {}: {number}", pairs.len())
                }
                None => "nothing".to_owned(),
            },
            Check::Ordered { values, .. } => match (values.first(), values.last()) {
                (Some(first), Some(last)) => {
                    let [first, last] = told_apart(*first, *last);
                    format!("{} values, {first} to {last}", values.len())
                }
                _ => "nothing".to_owned(),
            },
        }
    }

    /// The expectation in words and numbers, to the last digit of its tolerance.
    #[must_use]
    pub fn expected(&self) -> String {
        match &self.check {
            Check::Close { expected, tolerance, .. } => within(*expected, *tolerance),
            Check::AllClose { tolerance, .. } => match self.worst() {
                Some((pair, _)) => within(pair.expected, *tolerance),
                None => tolerance.to_string(),
            },
            Check::Bound { measured, bound, side } => {
                let sign = if *side == Side::Below { '≤' } else { '≥' };
                format!("{sign} {}", told_apart(*measured, *bound)[1])
            }
            Check::Ordered { order: Order::Increasing, .. } => "increasing".to_owned(),
            Check::Ordered { order: Order::Decreasing, .. } => "decreasing".to_owned(),
            Check::Holds { .. } => "yes".to_owned(),
        }
    }
}

/// `0.37 ± 0.07`
fn within(expected: f64, tolerance: Tolerance) -> String {
    match fitting(expected, tolerance.allowed(expected), 0) {
        number if tolerance.allowed(expected) == 0.0 => format!("exactly {number}"),
        number => format!("{number} {tolerance}"),
    }
}

/// A value to the last digit of its tolerance and so many more; units are always given.
fn fitting(value: f64, tolerance: f64, more: usize) -> String {
    let Some(last) = last_digit(tolerance).filter(|_| value.is_finite()) else {
        return number(value);
    };
    let decimals = match last {
        0.. => 0,
        last => last.unsigned_abs() as usize + more,
    };
    // `number` leaves out digits that carry nothing.
    number(format!("{value:.decimals$}").parse().unwrap_or(value))
}

/// The power of ten of the last digit of a tolerance; `None` without one.
fn last_digit(tolerance: f64) -> Option<i32> {
    if tolerance == 0.0 || !tolerance.is_finite() {
        return None;
    }
    let text = format!("{tolerance:.*e}", TOLERANCE_DIGITS - 1);
    let (digits, power) = text.split_once('e')?;
    let after_point = digits.split_once('.').map_or("", |(_, after)| after);
    let after_point = after_point.trim_end_matches('0').len();
    let power: i32 = power.parse().ok()?;
    // A number has at most sixteen digits.
    Some((power - after_point as i32).max(-300))
}

/// Two numbers to four digits, or to as many as tell them apart.
fn told_apart(one: f64, other: f64) -> [String; 2] {
    let to = |digits| [one, other].map(|value| significant(value, digits));
    let differ = |digits: &usize| {
        let [one, other] = to(*digits);
        one != other
    };
    to((DIGITS..=MOST_DIGITS).find(differ).unwrap_or(DIGITS))
}

/// A number with up to ten significant digits, no trailing zeros.
#[must_use]
pub fn number(value: f64) -> String {
    significant(value, MOST_DIGITS)
}

/// A number with up to `digits` significant digits, at least one, and no trailing zeros.
#[must_use]
pub fn significant(value: f64, digits: usize) -> String {
    let places = digits.max(1) - 1;
    let rounded: f64 = format!("{value:.places$e}").parse().unwrap_or(value);
    match rounded.abs() {
        0.0 => "0".to_owned(),
        size if (1e-4..1e7).contains(&size) => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, text) in [
            (0.1 + 0.2, "0.3"),
            (16.0 / 3.0, "5.333333333"),
            (1.5e-7, "1.5e-7"),
            (-2e9, "-2e9"),
            (f64::NAN, "NaN"),
            (0.0, "0"),
        ] {
            assert_eq!(number(value), text);
        }
        assert_eq!(significant(0.370_905_995_9, 3), "0.371");
        assert_eq!(significant(17_387.3, 3), "17400");
    }

    #[test]
    fn digits_fit_the_tolerance() {
        use Tolerance::{Absolute, Relative};
        for (measured, expected, tolerance, texts) in [
            (0.441_234_5, 0.370_905_995_9, Absolute(0.07), ["0.441", "0.37 ± 0.07"]),
            (7.0, 7.0, Absolute(0.0), ["7", "exactly 7"]),
            (281.0, 280.0, Absolute(6.0), ["281", "280 ± 6"]),
            (17_380.44, 17_387.3, Absolute(60.0), ["17380", "17387 ± 60"]),
            (1.234_567, 1.25, Relative(0.02), ["1.2346", "1.25 ± 2 %"]),
            (0.123_456, 0.12, Absolute(0.0145), ["0.12346", "0.12 ± 0.0145"]),
            (1e-17, 0.0, Absolute(1e-12), ["0", "0 ± 1e-12"]),
            (
                2.0 / 3.0,
                2.0 / 3.0,
                Relative(1e-13),
                ["0.6666666667", "0.6666666667 ± 1e-13 relative"],
            ),
            (f64::NAN, 1.0, Absolute(0.1), ["NaN", "1 ± 0.1"]),
        ] {
            let claim = Claim::close("", measured, expected, tolerance);
            assert_eq!([claim.measured(), claim.expected()], texts);
        }
    }

    #[test]
    fn a_failing_claim_shows_where_it_fails() {
        let claim = Claim::close("", 1.000_8, 1.0, Tolerance::Absolute(5e-4));
        assert!(!claim.source("given").passes());
        assert_eq!(Claim::close("", 1.0008, 1.0, Tolerance::Absolute(5e-4)).measured(), "1.0008");
        let claim = Claim::at_most("", 2.000_004, 2.0);
        assert_eq!([claim.measured(), claim.expected()], ["2.000004", "≤ 2"]);
        let claim = Claim::at_least("", 2.345_678, 2.0);
        assert_eq!([claim.measured(), claim.expected()], ["2.346", "≥ 2"]);
    }

    #[test]
    fn a_condition_is_answered_in_words() {
        let claim = Claim::holds("", true, 0.993_389_282_4);
        assert_eq!([claim.measured(), claim.expected()], ["yes (0.9934)", "yes"]);
        assert_eq!(Claim::holds("", false, 2.0).measured(), "no (2)");
        let claim = Claim::increasing("", [1.0, 1.5, 2.123_456]);
        assert_eq!(claim.measured(), "3 values, 1 to 2.123");
    }
}
