//! The report of an iterative solution: its cost, its residuals, why it stopped.

use std::ops::ControlFlow;

/// The cost of a solution: products of an influence matrix with a field, and applications of a
/// preconditioner. They are counted in units of the finest grid: a product on a grid, or on a box
/// around the contact, with a quarter of the cells counts as a quarter.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Products {
    /// Normal displacement due to pressure.
    pub normal: f64,
    /// Tangential displacements due to tangential tractions.
    pub tangential: f64,
    /// Normal displacement due to tangential tractions, or tangential displacements due to
    /// pressure.
    pub coupling: f64,
    /// Applications of a preconditioner.
    pub preconditioner: f64,
}

impl Products {
    /// The sum of two costs.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            normal: self.normal + other.normal,
            tangential: self.tangential + other.tangential,
            coupling: self.coupling + other.coupling,
            preconditioner: self.preconditioner + other.preconditioner,
        }
    }

    /// The cost of the same products on a grid with this fraction of the cells.
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

/// How far the conditions of contact are violated.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Residuals {
    /// The greatest violation of the normal conditions (a gap inside the contact, an overlap
    /// outside, tension), relative to the greatest displacement.
    pub normal: f64,
    /// The greatest violation of the friction law, relative to the greatest friction limit.
    pub tangential: f64,
}

impl Residuals {
    /// The greater of the two; NaN if either is NaN.
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
    /// The residuals stopped decreasing.
    Stalled,
    /// The greatest number of iterations was reached.
    Exhausted,
    /// An observer ended the iteration.
    Observer,
}

impl std::fmt::Display for Stop {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Converged => "converged",
            Self::Stalled => "it no longer decreases",
            Self::Exhausted => "no more are allowed",
            Self::Observer => "interrupted",
        })
    }
}

/// How the solution of a step ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Convergence {
    /// Iterations on the finest grid, or on the box around the contact: of all pressures, of all tractions and
    /// of Newton's method on both.
    pub iterations: usize,
    /// Products on all grids, in units of the finest.
    pub products: Products,
    /// The remaining violations.
    pub residuals: Residuals,
    /// Why the iteration stopped.
    pub stop: Stop,
}

/// One iteration, as reported to an observer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Its number in this solve, from 1; Newton's method on pressures and tractions together also reports its
    /// start, as 0.
    pub iteration: usize,
    /// Cells of this grid, or of the box around the contact.
    pub cells: usize,
    /// Cells in contact.
    pub touching: usize,
    /// The remaining violations.
    pub residuals: Residuals,
}

/// Follows the iterations and may end them; on large grids from a thread of the pool.
pub trait Observer: Send {
    /// Called after each iteration. `Break` ends the solution with [`Stop::Observer`].
    fn see(&mut self, progress: &Progress) -> ControlFlow<()>;
}

/// Ignores all iterations, and ends them on an [interrupt](carom_special::interrupt).
impl Observer for () {
    fn see(&mut self, _: &Progress) -> ControlFlow<()> {
        if carom_special::interrupt::is_wanted() {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }
}

/// An observer whose `Break` lasts: what ends one iteration ends the step.
pub(crate) struct Lasting<'a> {
    observer: &'a mut dyn Observer,
    ended: bool,
}

impl<'a> Lasting<'a> {
    pub(crate) fn new(observer: &'a mut dyn Observer) -> Self {
        Self { observer, ended: false }
    }
}

impl Observer for Lasting<'_> {
    fn see(&mut self, progress: &Progress) -> ControlFlow<()> {
        self.ended = self.ended || self.observer.see(progress).is_break();
        if self.ended { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

impl<F: FnMut(&Progress) -> ControlFlow<()> + Send> Observer for F {
    fn see(&mut self, progress: &Progress) -> ControlFlow<()> {
        self(progress)
    }
}
