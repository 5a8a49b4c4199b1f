//! Ranges of the numbers in case files.

use carom_laws::friction::Friction;

/// The range of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// Finite.
    Finite,
    /// A component of a velocity or spin.
    Speed,
    /// A speed, finite and >= 0.
    NonNegativeSpeed,
    /// Finite and > 0.
    Positive,
    /// > 0; infinity is allowed.
    PositiveOrInfinite,
    /// Finite and >= 0.
    NonNegative,
    /// A coefficient of friction: 0, infinite, or of a size at which displacements over it do not overflow.
    Friction,
    /// A coefficient of friction that is finite.
    FiniteFriction,
    /// A Poisson's ratio.
    Poisson,
    /// A principal radius.
    Radius,
    /// An angle of incidence, degrees from the normal.
    Incidence,
    /// A fraction from 0 to 1.
    Part,
    /// A fraction from -1 to 1.
    SignedPart,
    /// The tolerance of a law.
    LawTolerance,
    /// The tolerance of a solution.
    SolveTolerance,
    /// The accuracy of a solution.
    Accuracy,
    /// A number of values of a sweep, at least two.
    Count,
    /// A number of items, at least one.
    Whole,
    /// A number of cells along an axis.
    Cells,
    /// A point along an axis, from 0.
    Point,
    /// A number of elements across a rolling contact.
    Elements,
    /// A number of harmonics of a Fourier series.
    Harmonics,
    /// A number of places around a ring.
    Places,
    /// An angle, degrees, up to a hundred turns.
    Around,
    /// Half of the angle of a sector, degrees.
    HalfTurn,
    /// The angle by which an arc of a meridian turns, degrees.
    Turn,
    /// The factor of a stiffness.
    Factor,
    /// The seed of a generator.
    Seed,
}

/// Largest number of values of a sweep.
const MOST: f64 = 1e6;
/// 2^53: up to it a floating-point number holds every whole number.
const MOST_SEED: f64 = 9_007_199_254_740_992.0;
/// The largest speed: its square is still finite.
const MOST_SPEED: f64 = 1e100;

/// An end of a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// The number belongs to the range.
    In(f64),
    /// The number does not belong to it.
    Out(f64),
}

impl End {
    /// The number.
    #[must_use]
    pub const fn number(self) -> f64 {
        match self {
            Self::In(end) | Self::Out(end) => end,
        }
    }

    /// A number of the range at its end, or close to it if the end does not belong to it; `inside` is in the range.
    pub(super) fn within(self, inside: f64) -> f64 {
        match self {
            Self::In(end) => end,
            Self::Out(end) => end + 1e-6 * (inside - end),
        }
    }
}

impl Range {
    /// The ends, lower and upper.
    #[must_use]
    pub const fn ends(self) -> [End; 2] {
        use End::{In, Out};
        let (zero, infinite) = (0.0, Out(f64::INFINITY));
        match self {
            Self::Finite => [Out(f64::NEG_INFINITY), infinite],
            Self::Speed => [In(-MOST_SPEED), In(MOST_SPEED)],
            Self::NonNegativeSpeed => [In(zero), In(MOST_SPEED)],
            Self::Positive => [Out(zero), infinite],
            Self::PositiveOrInfinite => [Out(zero), In(f64::INFINITY)],
            Self::NonNegative => [In(zero), infinite],
            Self::Friction => [In(zero), In(f64::INFINITY)],
            Self::FiniteFriction => [In(zero), In(1e30)],
            Self::Poisson => [Out(-1.0), In(0.5)],
            Self::Radius => [In(f64::NEG_INFINITY), In(f64::INFINITY)],
            Self::Incidence => [In(zero), In(90.0)],
            Self::Part => [In(zero), In(1.0)],
            Self::SignedPart => [In(-1.0), In(1.0)],
            Self::LawTolerance => [Out(zero), In(0.1)],
            Self::SolveTolerance => [In(1e-13), In(0.01)],
            Self::Accuracy => [In(1e-6), In(0.1)],
            Self::Count => [In(2.0), In(MOST)],
            Self::Whole => [In(1.0), In(MOST)],
            Self::Cells => [In(1.0), In(16_384.0)],
            Self::Point => [In(zero), In(MOST)],
            Self::Elements => [In(6.0), In(512.0)],
            Self::Harmonics => [In(4.0), In(256.0)],
            Self::Places => [In(4.0), In(10_000.0)],
            Self::Around => [In(-36_000.0), In(36_000.0)],
            Self::HalfTurn => [Out(zero), Out(180.0)],
            Self::Turn => [In(3.0), In(170.0)],
            Self::Factor => [In(1e-6), In(1e6)],
            Self::Seed => [In(zero), In(MOST_SEED)],
        }
    }

    /// Whether the range holds whole numbers only.
    #[must_use]
    pub const fn is_whole(self) -> bool {
        matches!(
            self,
            Self::Count
                | Self::Whole
                | Self::Cells
                | Self::Point
                | Self::Elements
                | Self::Harmonics
                | Self::Places
                | Self::Seed
        )
    }

    /// Whether `value` lies in it.
    #[must_use]
    pub fn holds(self, value: f64) -> bool {
        let [low, high] = self.ends();
        let is_above = match low {
            End::In(end) => value >= end,
            End::Out(end) => value > end,
        };
        let is_below = match high {
            End::In(end) => value <= end,
            End::Out(end) => value < end,
        };
        let is_fit = !self.is_whole() || value.fract() == 0.0;
        let is_between = match self {
            Self::Radius => value != 0.0,
            Self::Friction | Self::FiniteFriction => Friction::new(value).is_ok(),
            _ => true,
        };
        is_above && is_below && is_fit && is_between
    }

    /// The allowed values, in words.
    #[must_use]
    pub const fn allowed(self) -> &'static str {
        match self {
            Self::Finite => "finite",
            Self::Speed => "finite, within +-1e100",
            Self::NonNegativeSpeed => "finite and >= 0, at most 1e100",
            Self::Positive => "finite and > 0",
            Self::PositiveOrInfinite => "> 0 (inf is allowed)",
            Self::NonNegative => "finite and >= 0",
            Self::Friction => ">= 0 (0, 1e-30 to 1e30, or inf: no slip)",
            Self::FiniteFriction => "finite and >= 0 (0, or 1e-30 to 1e30)",
            Self::Poisson => "in (-1, 0.5]",
            Self::Radius => "nonzero (inf: straight, negative: concave)",
            Self::Incidence => "in [0, 90], degrees from the normal",
            Self::Part => "in [0, 1]",
            Self::SignedPart => "in [-1, 1]",
            Self::LawTolerance => "> 0 and <= 0.1",
            Self::SolveTolerance => "from 1e-13 to 0.01",
            Self::Accuracy => "from 1e-6 to 0.1",
            Self::Count => "a whole number from 2 to 1000000",
            Self::Whole => "a whole number from 1 to 1000000",
            Self::Cells => "a whole number from 1 to 16384",
            Self::Point => "a whole number from 0 to 1000000",
            Self::Elements => "a whole number from 6 to 512",
            Self::Harmonics => "a whole number from 4 to 256",
            Self::Places => "a whole number from 4 to 10000",
            Self::Around => "in [-36000, 36000]",
            Self::HalfTurn => "> 0 and < 180",
            Self::Turn => "in [3, 170]",
            Self::Factor => "from 1e-6 to 1e6",
            Self::Seed => "a whole number from 0 to 2^53",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_belong_to_a_range_or_not() {
        for (range, inside, outside) in [
            (Range::Finite, &[0.0, -f64::MAX, f64::MAX][..], &[f64::INFINITY, f64::NAN][..]),
            (Range::Speed, &[1e100, -1e100], &[1.1e100, f64::NAN, f64::NEG_INFINITY]),
            (Range::Positive, &[f64::MIN_POSITIVE], &[0.0, f64::INFINITY]),
            (Range::PositiveOrInfinite, &[f64::INFINITY], &[0.0, -0.0, f64::NAN]),
            (
                Range::Friction,
                &[0.0, -0.0, 1e-30, f64::INFINITY],
                &[-1e-300, 1e-31, 1e31, f64::NAN],
            ),
            (Range::FiniteFriction, &[0.0, 1e30], &[1e-31, 1.1e30, f64::INFINITY, f64::NAN]),
            (Range::Poisson, &[0.5, 0.0, -0.999], &[-1.0, 0.51]),
            (Range::Radius, &[-1.0, f64::NEG_INFINITY, f64::INFINITY], &[0.0, -0.0, f64::NAN]),
            (Range::Count, &[2.0, 1e6], &[1.0, 2.5, 1_000_001.0]),
            (Range::Seed, &[0.0, MOST_SEED], &[-1.0, 0.5, 2.0 * MOST_SEED]),
        ] {
            assert!(inside.iter().all(|value| range.holds(*value)), "{range:?}");
            assert!(!outside.iter().any(|value| range.holds(*value)), "{range:?}");
        }
    }

    #[test]
    fn the_tolerance_of_a_law_is_that_of_the_library() {
        for tolerance in [0.0, 1e-300, 1e-3, 0.1, 0.1 + 1e-16, 0.100_000_1, -1.0, f64::NAN] {
            let library = carom_laws::coulomb::Tolerance::new(tolerance).is_ok();
            assert_eq!(Range::LawTolerance.holds(tolerance), library, "{tolerance}");
        }
    }
}
