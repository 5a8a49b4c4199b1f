//! Pressures and tractions together, where solving for them in turn does not converge.
//!
//! Newton's method on the conditions of contact and friction as they stand: in each cell the
//! traction (p, t) lies in Coulomb's cone `|t| <= f p`. A cell is apart, sticks (three unknowns:
//! no gap, no slip) or slips (two: along a ray of the cone, with no gap, and around it, with slip
//! against the traction). Rays are followed by their length, so that the cone may open to the
//! half-space of infinite friction. There a cell at the edge may be neither stuck, for its own
//! tractions would pull it off, nor apart, for without them it overlaps: it slips with next to no
//! pressure.

mod cells;
mod krylov;
mod system;

use std::ops::ControlFlow;

use carom_halfspace::operator::{OperatorError, SurfaceOperator};

use crate::convergence::{Convergence, Observer, Products, Progress, Stop};
use crate::drive::Driven;
use crate::state::CellState;
use crate::tangential::Rigid;
use cells::Cells;
use system::System;

/// What is left of a linear system, over what there was.
const INEXACT: f64 = 1e-4;
/// Products of a linear system.
const PRODUCTS: usize = 240;
/// Newton's steps without progress after which half as many cells may change at once.
const PATIENCE: usize = 6;
/// Newton's steps without progress after which it is given up.
const HOPELESS: usize = 8;
/// Gaps of this part of the greatest displacement are no start.
const LOST: f64 = 0.5;

/// What is to be solved and what is found.
pub(crate) struct CoupledTask<'a> {
    pub(crate) operator: &'a dyn SurfaceOperator,
    /// Distances of the surfaces at approach zero, without any traction.
    pub(crate) heights: &'a [f64],
    /// Coefficients of friction.
    pub(crate) friction: &'a [f64],
    /// The slip of cells without tractions, but for what has a given load.
    pub(crate) offset: [&'a [f64]; 2],
    pub(crate) normal: Driven,
    pub(crate) approach: f64,
    pub(crate) rigid: Rigid,
    pub(crate) pressure: &'a mut [f64],
    pub(crate) traction: [&'a mut [f64]; 2],
    pub(crate) cells: &'a mut [CellState],
}

/// The working memory.
#[derive(Clone)]
pub(crate) struct Coupled {
    system: System,
    cells: Cells,
    products: Products,
}

impl Coupled {
    pub(crate) fn new(operator: &dyn SurfaceOperator) -> Self {
        let (system, cells) = (System::new(operator), Cells::new(operator));
        Self { system, cells, products: Products::default() }
    }

    /// Solves a task from its own start.
    ///
    /// # Errors
    /// The operator's.
    pub(crate) fn solve(
        &mut self,
        task: &mut CoupledTask<'_>,
        tolerance: f64,
        iterations: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        self.products = Products::default();
        self.cells.begin(task);
        let (mut least, mut since, mut share) = (f64::INFINITY, 0, 1.0_f64);
        let mut iteration = 0;
        loop {
            self.system.displace(task, &mut self.products)?;
            let residuals = self.cells.residuals(task, &self.system);
            let touching = task.pressure.iter().filter(|pressure| **pressure > 0.0).count();
            let worst = residuals.worst();
            // Where nothing touches any more, the next step may press again.
            let lost = touching > 0 && residuals.normal > LOST;
            let cells = task.pressure.len();
            let seen = observer.see(&Progress { iteration, cells, touching, residuals });
            let stop = if worst.is_nan() || since > HOPELESS || lost {
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
                (least, since, share) = (worst, 0, 1.0);
            } else {
                since += 1;
                if since % PATIENCE == 0 {
                    share *= 0.5;
                }
            }
            iteration += 1;
            self.cells.choose(task, &self.system, share);
            self.system.displace(task, &mut self.products)?;
            self.system.newton_step(task, &self.cells, &mut self.products)?;
        }
    }
}
