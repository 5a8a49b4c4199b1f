//! Lengths for which the Fourier transform is fast.

use super::precision::Real as _;
use super::threads::Threads;
use crate::Grid;

/// The transform length for a grid of `cells` along one axis: at least `2 cells - 1`, so that the
/// periodic images do not overlap; even, and a product of small primes.
///
/// ```
/// use carom_halfspace::operator::transform_length;
/// assert_eq!(transform_length(512), 1024);
/// assert_eq!(transform_length(41), 84);
/// ```
#[must_use]
pub fn transform_length(cells: usize) -> usize {
    fast_length((2 * cells).saturating_sub(1))
}

/// An even length, at least `least`, for which the transform is fast.
pub(crate) fn fast_length(least: usize) -> usize {
    let least = least.max(2);
    let power = least.next_power_of_two();
    let mut best = (power, cost(power));
    for five in 0..3u32 {
        for three in 0..4u32 {
            for seven in 0..2u32 {
                let odd = 5usize.pow(five) * 3usize.pow(three) * 7usize.pow(seven);
                let twos = least.div_ceil(odd).next_power_of_two().max(2);
                let length = odd * twos;
                let cost = cost(length);
                if cost < best.1 {
                    best = (length, cost);
                }
            }
        }
    }
    best.0
}

/// Relative time of a transform, measured: points times the weighted sum of the prime factors.
fn cost(length: usize) -> f64 {
    let mut rest = length;
    let mut weight = 0.0;
    for (prime, factor_cost) in [(2, 1.0), (3, 1.9), (5, 4.0), (7, 4.5)] {
        while rest.is_multiple_of(prime) {
            rest /= prime;
            weight += factor_cost;
        }
    }
    length as f64 * (weight + OVERHEAD)
}

/// Work per point outside the transform (copies, transposition, product), in units of a factor 2.
const OVERHEAD: f64 = 4.0;

/// The lengths of a grid and of its padded transforms.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sizes {
    pub(crate) nx: usize,
    pub(crate) ny: usize,
    /// Padded lengths.
    pub(crate) px: usize,
    pub(crate) py: usize,
}

impl Sizes {
    pub(crate) fn of(grid: Grid) -> Self {
        let (nx, ny) = (grid.nx(), grid.ny());
        Self { nx, ny, px: transform_length(nx), py: transform_length(ny) }
    }

    /// Of a torus that is hardly larger than the grid, so that its ends are adjacent.
    pub(crate) fn of_torus(grid: Grid) -> Self {
        let (nx, ny) = (grid.nx(), grid.ny());
        Self { nx, ny, px: fast_length(nx), py: fast_length(ny) }
    }

    /// Of a periodic surface.
    pub(crate) const fn of_period(grid: Grid) -> Self {
        let (nx, ny) = (grid.nx(), grid.ny());
        Self { nx, ny, px: nx, py: ny }
    }

    /// Number of columns of the spectrum of real data.
    pub(crate) const fn columns(&self) -> usize {
        self.px / 2 + 1
    }

    /// Bytes of the spectrum of a kernel with even or odd symmetry in both coordinates.
    pub(crate) const fn symmetric_spectrum(&self) -> u128 {
        8 * self.columns() as u128 * (self.py / 2 + 1) as u128
    }

    /// Bytes of any other spectrum.
    pub(crate) const fn general_spectrum(&self) -> u128 {
        16 * self.columns() as u128 * self.py as u128
    }

    /// Bytes of the workspace of a product of `fields` tractions and displacements.
    pub(crate) fn workspace(&self, fields: usize, threads: Threads) -> u128 {
        let field = self.columns() as u128 * self.ny as u128;
        let lane = f64::BLOCK * (fields + 1) * self.py + self.columns() + self.px;
        16 * (fields as u128 * field + lane as u128 * threads.count() as u128)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_even_sufficient_and_not_wasteful() {
        for cells in 1..5000 {
            let length = transform_length(cells);
            assert!(length >= 2 * cells - 1 && length.is_multiple_of(2));
            assert!(cells < 16 || (length as f64) < 1.2 * 2.0 * cells as f64, "{cells}: {length}");
            let mut rest = length;
            for prime in [2, 3, 5, 7] {
                while rest.is_multiple_of(prime) {
                    rest /= prime;
                }
            }
            assert_eq!(rest, 1);
        }
    }
}
