//! The Fourier transforms of one grid.

use carom_fourier::{ComplexPlan, RealPlan};

use super::length::Sizes;
use super::precision::Real;
use super::threads::Threads;
use crate::Grid;

/// The transforms of a padded grid.
#[derive(Clone)]
pub(crate) struct Plan<T: Real = f64> {
    pub(crate) sizes: Sizes,
    pub(crate) threads: Threads,
    pub(crate) rows: RealPlan<T>,
    pub(crate) columns: ComplexPlan<T>,
}

impl Plan {
    pub(crate) fn new(grid: Grid, threads: Threads) -> Self {
        Self::on(Sizes::of(grid), threads)
    }
}

impl<T: Real> Plan<T> {
    pub(crate) fn on(sizes: Sizes, threads: Threads) -> Self {
        let (rows, columns) = (T::real_plan(sizes.px), T::complex_plan(sizes.py));
        Self { sizes, threads, rows, columns }
    }

    /// Complex numbers of working memory that the largest transform needs.
    pub(crate) fn scratch(&self) -> usize {
        self.rows
            .forward
            .get_scratch_len()
            .max(self.rows.inverse.get_scratch_len())
            .max(self.columns.forward.get_inplace_scratch_len())
            .max(self.columns.inverse.get_inplace_scratch_len())
    }
}
