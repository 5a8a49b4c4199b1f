//! A number, or as many as there are contacts that make a step together.

use std::array::from_fn;
use std::ops::{Add, Div, Mul, Sub};

/// How many contacts make a step together.
pub(super) const LANES: usize = 4;

/// What the geometry of a step is made of: `f64`, or [`Lanes`] for some contacts at once, each to the
/// same bits as alone.
pub(super) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The same in each.
    fn of(value: f64) -> Self;

    fn sqrt(self) -> Self;

    fn larger(self, other: Self) -> Self;

    /// By what is right for numbers of a size up to this, if all are; else of each by itself.
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
    fn where_small(
        self,
        up_to: f64,
        then: impl Fn(Self) -> Self,
        else_each: impl Fn(f64) -> f64,
    ) -> Self {
        if self.abs() <= up_to { then(self) } else { else_each(self) }
    }
}

/// One number of each of some contacts.
pub(super) type Lanes = wide::f64x4;

/// As a function tells it for each.
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
    fn where_small(
        self,
        up_to: f64,
        then: impl Fn(Self) -> Self,
        else_each: impl Fn(f64) -> f64,
    ) -> Self {
        if self.abs().simd_le(Self::splat(up_to)).all() {
            return then(self);
        }
        // Each as it would be alone.
        let one = |value: f64| match value.abs() <= up_to {
            true => then(Self::splat(value)).to_array()[0],
            false => else_each(value),
        };
        Self::new(self.to_array().map(one))
    }
}
