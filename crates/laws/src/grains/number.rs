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

    /// The number where `other` is > 0, and 0 elsewhere.
    fn where_positive(self, other: Self) -> Self;

    /// Whether it is > 0 in any lane.
    fn is_any_positive(self) -> bool;

    /// Functions of several numbers, computed for each lane by itself.
    fn each<const N: usize, const M: usize>(
        numbers: [Self; N],
        of: impl Fn([f64; N]) -> [f64; M],
    ) -> [Self; M];

    /// Three functions of two numbers. `near` computes them if the numbers of all lanes are at most `up_to` in magnitude,
    /// otherwise `each` does for each lane.
    fn near_or_each(
        numbers: [Self; 2],
        up_to: [f64; 2],
        near: impl Fn([Self; 2]) -> [Self; 3],
        each: impl Fn([f64; 2]) -> [f64; 3],
    ) -> [Self; 3];
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
    fn where_positive(self, other: Self) -> Self {
        if other > 0.0 { self } else { 0.0 }
    }

    #[inline(always)]
    fn is_any_positive(self) -> bool {
        self > 0.0
    }

    #[inline(always)]
    fn each<const N: usize, const M: usize>(
        numbers: [Self; N],
        of: impl Fn([f64; N]) -> [f64; M],
    ) -> [Self; M] {
        of(numbers)
    }

    #[inline(always)]
    fn near_or_each(
        numbers: [Self; 2],
        up_to: [f64; 2],
        near: impl Fn([Self; 2]) -> [Self; 3],
        each: impl Fn([f64; 2]) -> [f64; 3],
    ) -> [Self; 3] {
        let [one, two] = from_fn(|k| numbers[k].abs() <= up_to[k]);
        if one & two { near(numbers) } else { each(numbers) }
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
    fn where_positive(self, other: Self) -> Self {
        // Numbers and comparisons are of one type: a comparison that holds has all bits.
        self & other.simd_gt(Self::splat(0.0))
    }

    #[inline(always)]
    fn is_any_positive(self) -> bool {
        self.simd_gt(Self::splat(0.0)).to_bitmask() != 0
    }

    #[inline(always)]
    fn each<const N: usize, const M: usize>(
        numbers: [Self; N],
        of: impl Fn([f64; N]) -> [f64; M],
    ) -> [Self; M] {
        let numbers = numbers.map(Self::to_array);
        let all: [[f64; M]; LANES] = from_fn(|i| of(numbers.map(|lane| lane[i])));
        from_fn(|k| lanes(|i| all[i][k]))
    }

    #[inline(always)]
    fn near_or_each(
        numbers: [Self; 2],
        up_to: [f64; 2],
        near: impl Fn([Self; 2]) -> [Self; 3],
        each: impl Fn([f64; 2]) -> [f64; 3],
    ) -> [Self; 3] {
        let [one, two] = from_fn(|k| numbers[k].abs().simd_le(Self::splat(up_to[k])));
        if hold(one & two) {
            return near(numbers);
        }
        let numbers = numbers.map(Self::to_array);
        let all: [[f64; 3]; LANES] = from_fn(|i| each([numbers[0][i], numbers[1][i]]));
        from_fn(|k| lanes(|i| all[i][k]))
    }
}

/// Whether a comparison holds in all lanes: with one branch.
#[inline(always)]
pub(super) fn hold(mask: Lanes) -> bool {
    mask.to_bitmask() == (1 << LANES) - 1
}
