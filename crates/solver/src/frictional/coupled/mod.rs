//! Newton's method on pressures and tractions together, used if the alternation does not converge.
//!
//! The unknowns of a cell are its pressure p and traction t in Coulomb's cone `|t| <= f p`. A cell
//! is separated, sticks (three unknowns; conditions: no gap, no slip) or slips (two unknowns: one
//! along a ray of the cone, with no gap, one around it, with the slip opposite to the traction).
//! Positions on a ray are measured by their length, so that the cone may open to the half-space of
//! infinite friction. With infinite friction a cell at the edge may be unable to stick, because its
//! own tractions would pull it off, and to separate, because without them the bodies overlap: it
//! then slips at almost no pressure.

mod cells;
mod constraints;
mod damping;
mod newton;
mod origin;
mod precondition;
mod system;
mod task;
#[cfg(test)]
mod tests;
mod torus;

use std::ops::ControlFlow;

use carom_halfspace::operator::{OperatorError, SurfaceOperator};

use crate::convergence::{Convergence, Observer, Products, Progress, Residuals, Stop};
use cells::{Cells, Changes};
use damping::{Damping, Next};
use origin::Origin;
use system::System;

pub(crate) use task::CoupledTask;

/// A step is without progress if the least residual is not halved. After this many full steps in a row without
/// progress only half of the cells that should change do, those with the greatest violation.
const STEPS_BEFORE_FEWER_CHANGES: usize = 6;
/// After more full steps in a row without progress the method gives up.
const STEPS_BEFORE_GIVING_UP: usize = 8;
/// The same for damped steps, which follow a contact in time: its edge may move for a while before the residual
/// falls. With 20 a receding contact at infinite friction was found in two of seven problems that differ in the 13th
/// digit, with 60 in all, with 100 by twice as many products.
const DAMPED_STEPS_BEFORE_GIVING_UP: usize = 60;
/// Full steps end if gaps in the contact or overlaps outside exceed this fraction of the greatest
/// displacement: they start close to the solution.
const LARGEST_GAP: f64 = 0.02;

/// How Newton's method approaches the solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Steps {
    /// By full steps, from a start close to the solution.
    Full,
    /// By damped steps, from any start.
    Damped,
}

/// The working memory of Newton's method.
#[derive(Clone)]
pub(crate) struct Coupled {
    system: System,
    cells: Cells,
    origin: Origin,
    products: Products,
}

impl Coupled {
    pub(crate) fn new(operator: &dyn SurfaceOperator) -> Self {
        let (system, cells) = (System::new(operator), Cells::new(operator));
        let origin = Origin::new(operator.grid().cells());
        Self { system, cells, origin, products: Products::default() }
    }

    /// Solves a task, starting from its own values.
    ///
    /// # Errors
    /// The errors of the operator.
    pub(crate) fn solve(
        &mut self,
        task: &mut CoupledTask<'_>,
        steps: Steps,
        (tolerance, iterations): (f64, usize),
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        self.products = Products::default();
        self.cells.begin(task);
        self.cells.damping = 0.0;
        let (mut least, mut since) = (f64::INFINITY, 0);
        let mut damping = (steps == Steps::Damped).then(Damping::default);
        let (patience, largest) = match steps {
            Steps::Full => (STEPS_BEFORE_GIVING_UP, LARGEST_GAP),
            Steps::Damped => (DAMPED_STEPS_BEFORE_GIVING_UP, f64::INFINITY),
        };
        let mut iteration = 0;
        loop {
            self.system.displace(task, &mut self.products)?;
            let residuals = self.cells.residuals(task, &self.system);
            let touching = task.pressure.iter().filter(|pressure| **pressure > 0.0).count();
            let worst = residuals.worst();
            // If no cell is left in contact, the next step may press the bodies together again.
            let lost = touching > 0 && residuals.normal > largest;
            let cells = task.pressure.len();
            let seen = observer.see(&Progress { iteration, cells, touching, residuals });
            let stop = if worst.is_nan() || since > patience || lost {
                Some(Stop::Stalled)
            } else if worst <= tolerance && iteration > 0 {
                Some(Stop::Converged)
            } else if matches!(seen, ControlFlow::Break(())) {
                Some(Stop::Observer)
            } else {
                (iteration >= iterations).then_some(Stop::Exhausted)
            };
            if let Some(stop) = stop {
                self.cells.finish(task);
                let products = self.products;
                return Ok(Convergence { iterations: iteration, products, residuals, stop });
            }
            if worst < 0.5 * least {
                (least, since) = (worst, 0);
            } else {
                since += 1;
            }
            let changes = if damping.is_none() && since >= STEPS_BEFORE_FEWER_CHANGES {
                Changes::GreaterHalf
            } else {
                Changes::All
            };
            if let Some(damping) = &mut damping {
                self.damp(damping, residuals, task);
            }
            iteration += 1;
            self.cells.choose(task, &self.system, changes);
            self.system.displace(task, &mut self.products)?;
            self.system.newton_step(task, &self.cells, &mut self.products)?;
        }
    }

    /// Sets the damping of the next step, which starts from here, or from where the last one started if that
    /// has failed.
    fn damp(&mut self, damping: &mut Damping, residuals: Residuals, task: &mut CoupledTask<'_>) {
        let violation = self.cells.violation(task, &self.system);
        self.cells.damping = match damping.next(violation, residuals) {
            Next::Onwards(damping) => {
                self.origin.keep(task, &self.system, &self.cells);
                damping
            }
            Next::Again(damping) => {
                self.origin.restore(task, &mut self.system, &mut self.cells);
                damping
            }
        };
    }
}
