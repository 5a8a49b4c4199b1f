//! The threads used by an operator.

use super::pool;
use crate::Grid;

/// From this number of cells on a solve is faster on two threads. Below, it takes longer to divide the work.
const CELLS_TO_SHARE: usize = 144 * 144;
/// The same of the coarse grids of a solve, during which the workers are awake.
const COARSE_CELLS_TO_SHARE: usize = 72 * 72;

/// The threads used for tables and products. The result is bit for bit the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Threads {
    /// On the calling thread.
    #[default]
    One,
    /// On all threads of the current rayon pool; on one without the feature `threads`.
    Pool,
}

impl Threads {
    /// The pool, where a grid has so many cells that several threads are faster; one thread
    /// otherwise.
    #[must_use]
    pub const fn for_grid(grid: Grid) -> Self {
        if grid.nx() * grid.ny() < CELLS_TO_SHARE { Self::One } else { Self::Pool }
    }

    /// For an operator on a smaller grid, made from one with these threads.
    pub(crate) const fn on_smaller(self, grid: Grid) -> Self {
        match self {
            Self::One => Self::One,
            Self::Pool if grid.nx() * grid.ny() < COARSE_CELLS_TO_SHARE => Self::One,
            Self::Pool => Self::Pool,
        }
    }

    pub(crate) fn count(self) -> usize {
        match self {
            Self::One => 1,
            Self::Pool => pool::count(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coarse grids of a solve on one thread stay on it; those of a solve on several leave them later than a grid of
    /// their own size would.
    #[test]
    fn small_grids_are_on_one_thread() {
        let grid = |nx, ny| Grid::new(nx, ny, 0.1, 0.1).unwrap();
        assert_eq!(
            [grid(143, 144), grid(72, 288)].map(Threads::for_grid),
            [Threads::One, Threads::Pool]
        );
        for (nx, ny, on_several) in
            [(71, 72, Threads::One), (72, 72, Threads::Pool), (288, 18, Threads::Pool)]
        {
            assert_eq!(Threads::One.on_smaller(grid(nx, ny)), Threads::One);
            assert_eq!(Threads::Pool.on_smaller(grid(nx, ny)), on_several);
        }
    }
}
