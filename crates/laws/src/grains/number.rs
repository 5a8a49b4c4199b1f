//! A number, or one number for each of several contacts that are advanced together.

use std::array::from_fn;
use std::ops::{Add, Div, Mul, Sub};

/// Number of contacts that are advanced together.
pub(super) const LANES: usize = 4;

/// The number type of the geometry of a step: `f64`, or [`Lanes`] for several contacts at once.
/// Each lane gives the same bits as `f64`.
pub(super) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The same value in each lane.
    fn of(value: f64) -> Self;

    fn sqrt(self) -> Self;

    fn larger(self, other: Self) -> Self;

    /// Whether it is > 0 in any lane.
    fn is_any_positive(self) -> bool;

    /// Fast path `then` if all lanes are at most `up_to` in magnitude; otherwise lane by lane.
    fn where_small(
        self,
        up_to: f64,
        then: impl Fn(Self) -> Self,
        else_each: impl Fn(f64) -> f64,
    ) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.max(other)
    }

    #[inline(always)]
    fn is_any_positive(self) -> bool {
        self > 0.0
    }

    #[inline(always)]
    fn where_small(
        self,
        up_to: f64,
        then: impl Fn(Self) -> Self,
        else_each: impl Fn(f64) -> f64,
    ) -> Self {
        if self.abs() <= up_to { then(self) } else { else_each(self) }
    }
}

/// One number for each of several contacts.
pub(super) type Lanes = wide::f64x4;

/// Calls a function for the value of each lane.
#[inline(always)]
pub(super) fn lanes(value: impl FnMut(usize) -> f64) -> Lanes {
    Lanes::new(from_fn(value))
}

impl Number for Lanes {
    #[inline(always)]
    fn of(value: f64) -> Self {
        Self::splat(value)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.max(other)
    }

    #[inline(always)]
    fn is_any_positive(self) -> bool {
        self.simd_gt(Self::splat(0.0)).any()
    }

    #[inline(always)]
    fn where_small(
        self,
        up_to: f64,
        then: impl Fn(Self) -> Self,
        else_each: impl Fn(f64) -> f64,
    ) -> Self {
        if self.abs().simd_le(Self::splat(up_to)).all() {
            return then(self);
        }
        // Lane by lane, with the same bits as a single number.
        let one = |value: f64| match value.abs() <= up_to {
            true => then(Self::splat(value)).to_array()[0],
            false => else_each(value),
        };
        Self::new(self.to_array().map(one))
    }
}
