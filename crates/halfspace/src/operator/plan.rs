//! The Fourier transforms of one grid.

use std::sync::Arc;

use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftPlanner};

use super::length::Sizes;
use super::precision::Real;
use super::threads::Threads;
use crate::Grid;

/// The transforms of a padded grid.
#[derive(Clone)]
pub(crate) struct Plan<T: Real = f64> {
    pub(crate) sizes: Sizes,
    pub(crate) threads: Threads,
    pub(crate) row_forward: Arc<dyn RealToComplex<T>>,
    pub(super) row_inverse: Arc<dyn ComplexToReal<T>>,
    pub(crate) column_forward: Arc<dyn Fft<T>>,
    pub(super) column_inverse: Arc<dyn Fft<T>>,
}

impl Plan {
    pub(crate) fn new(grid: Grid, threads: Threads) -> Self {
        Self::on(Sizes::of(grid), threads)
    }
}

impl<T: Real> Plan<T> {
    pub(crate) fn on(sizes: Sizes, threads: Threads) -> Self {
        let (px, py) = (sizes.px, sizes.py);
        let mut real = RealFftPlanner::new();
        let mut complex = FftPlanner::new();
        Self {
            sizes,
            threads,
            row_forward: real.plan_fft_forward(px),
            row_inverse: real.plan_fft_inverse(px),
            column_forward: complex.plan_fft_forward(py),
            column_inverse: complex.plan_fft_inverse(py),
        }
    }

    /// Complex numbers of working memory that the largest transform needs.
    pub(crate) fn scratch(&self) -> usize {
        self.row_forward
            .get_scratch_len()
            .max(self.row_inverse.get_scratch_len())
            .max(self.column_forward.get_inplace_scratch_len())
            .max(self.column_inverse.get_inplace_scratch_len())
    }
}
