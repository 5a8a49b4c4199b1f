//! Ranges of the numbers in case files.

/// The range of a number, with its words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// Finite.
    Finite,
    /// A component of a velocity or spin.
    Speed,
    /// A speed.
    NonNegativeSpeed,
    /// Finite and > 0.
    Positive,
    /// > 0; infinity is allowed.
    PositiveOrInfinite,
    /// Finite and >= 0.
    NonNegative,
    /// >= 0; infinity is allowed.
    NonNegativeOrInfinite,
    /// A Poisson's ratio.
    Poisson,
    /// A principal radius.
    Radius,
    /// Degrees from the normal.
    Incidence,
    /// A number of values.
    Count,
    /// A number of things, at least one.
    Whole,
}

/// Values that a sweep may have at most.
const MOST: f64 = 1e6;

impl Range {
    /// Whether `value` lies in it.
    #[must_use]
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Finite => value.is_finite(),
            Self::Speed => value.abs() <= 1e100,
            Self::NonNegativeSpeed => (0.0..=1e100).contains(&value),
            Self::Positive => value.is_finite() && value > 0.0,
            Self::PositiveOrInfinite => value > 0.0,
            Self::NonNegative => value.is_finite() && value >= 0.0,
            Self::NonNegativeOrInfinite => value >= 0.0,
            Self::Poisson => value > -1.0 && value <= 0.5,
            Self::Radius => value != 0.0 && !value.is_nan(),
            Self::Incidence => (0.0..=90.0).contains(&value),
            Self::Count => (2.0..=MOST).contains(&value) && value.fract() == 0.0,
            Self::Whole => (1.0..=MOST).contains(&value) && value.fract() == 0.0,
        }
    }

    /// What is allowed, in words.
    #[must_use]
    pub const fn allowed(self) -> &'static str {
        match self {
            Self::Finite => "finite",
            Self::Speed => "finite, within +-1e100",
            Self::NonNegativeSpeed => "finite and >= 0, at most 1e100",
            Self::Positive => "finite and > 0",
            Self::PositiveOrInfinite => "> 0 (inf is allowed)",
            Self::NonNegative => "finite and >= 0",
            Self::NonNegativeOrInfinite => ">= 0 (inf is allowed)",
            Self::Poisson => "in (-1, 0.5]",
            Self::Radius => "nonzero (inf: straight, negative: hollow)",
            Self::Incidence => "in [0, 90], degrees from the normal",
            Self::Count => "a whole number from 2 to 1000000",
            Self::Whole => "a whole number from 1 to 1000000",
        }
    }
}
