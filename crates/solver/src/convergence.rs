//! How an iteration went: what it cost, how far it got, why it stopped.

use std::ops::ControlFlow;

/// Products with the blocks of the influence, and applications of a preconditioner, counted on the
/// finest grid: one on a grid, or on a box about the contact, with a quarter of the cells counts a
/// quarter.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Products {
    /// Normal displacement by pressure.
    pub normal: f64,
    /// Tangential displacements by tangential tractions.
    pub tangential: f64,
    /// Normal displacement by tangential tractions, or the converse.
    pub coupling: f64,
    /// Preconditioners.
    pub preconditioner: f64,
}

impl Products {
    /// The sum of two counts.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            normal: self.normal + other.normal,
            tangential: self.tangential + other.tangential,
            coupling: self.coupling + other.coupling,
            preconditioner: self.preconditioner + other.preconditioner,
        }
    }

    /// The same products on a grid with this part of the cells.
    #[must_use]
    pub fn times(self, part: f64) -> Self {
        Self {
            normal: part * self.normal,
            tangential: part * self.tangential,
            coupling: part * self.coupling,
            preconditioner: part * self.preconditioner,
        }
    }
}

/// What is left of the conditions of contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Residuals {
    /// The greatest violation of the normal conditions (a gap in the contact, an overlap outside,
    /// tension) over the greatest displacement.
    pub normal: f64,
    /// The greatest violation of the friction law over the greatest friction limit.
    pub tangential: f64,
}

impl Residuals {
    /// The greater of both; not a number if one is not.
    #[must_use]
    pub const fn worst(&self) -> f64 {
        if self.normal.is_nan() || self.tangential.is_nan() {
            f64::NAN
        } else {
            self.normal.max(self.tangential)
        }
    }
}

/// Why an iteration stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Stop {
    /// The residuals fell below the tolerance.
    Converged,
    /// They would not fall any more.
    Stalled,
    /// The greatest number of iterations was done.
    Exhausted,
    /// An observer asked for it.
    Observer,
}

/// How a step went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Convergence {
    /// Iterations on the finest grid.
    pub iterations: usize,
    /// Products on all grids.
    pub products: Products,
    /// What is left.
    pub residuals: Residuals,
    /// Why it stopped.
    pub stop: Stop,
}

/// One iteration, as an observer sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Its number, from 1, on this grid.
    pub iteration: usize,
    /// Cells of this grid, or of the box about the contact.
    pub cells: usize,
    /// Cells in contact.
    pub touching: usize,
    /// What is left.
    pub residuals: Residuals,
}

/// Sees each iteration and may end the work.
pub trait Observer {
    /// Called after each iteration; `Break` ends the work with [`Stop::Observer`].
    fn see(&mut self, progress: &Progress) -> ControlFlow<()>;
}

/// Sees nothing.
impl Observer for () {
    fn see(&mut self, _: &Progress) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

impl<F: FnMut(&Progress) -> ControlFlow<()>> Observer for F {
    fn see(&mut self, progress: &Progress) -> ControlFlow<()> {
        self(progress)
    }
}
