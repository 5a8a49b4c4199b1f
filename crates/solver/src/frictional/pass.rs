//! One step with friction: repeats until no further cell changes to kinetic friction.

use super::coupling::coupling;
use super::{Frictional, FrictionalError, FrictionalScratch};
use crate::convergence::{Convergence, Observer, Products, Residuals, Stop};
use crate::drive::{Drive, Driven};
use crate::friction::COEFFICIENT_FOR_INFINITE;
use crate::problem::ContactProblem;
use crate::state::{CellState, ContactState};
use crate::tangential::Rigid;

/// Coupling is strong if the friction coefficient times gamma exceeds this; the full coefficient is
/// used from the start only below it.
const STRONG_COUPLING: f64 = 4.0;

/// A cell of infinite friction counts as dragged if its traction exceeds this fraction of its
/// bound.
const DRAGGED_FRACTION: f64 = 1.0 - 1e-6;

/// The values to return to: rigid shifts, state, normal displacement due to tractions.
pub(super) type Kept = (Rigid, ContactState, Vec<f64>);

/// The solution of one step.
pub(super) struct Pass<'a> {
    pub(super) method: &'a Frictional,
    pub(super) problem: &'a ContactProblem,
    pub(super) from: &'a ContactState,
    pub(super) drive: &'a Drive,
    pub(super) rigid: Rigid,
    pub(super) observer: &'a mut dyn Observer,
    pub(super) cost: Products,
    /// Iterations of all solves on the finest grid so far.
    pub(super) iterations: usize,
    /// Whether pressures and tractions were solved together.
    pub(super) together: bool,
    /// The error to report if the bodies slide under the pressures of the last pass.
    pub(super) slides: Option<FrictionalError>,
}

impl Pass<'_> {
    /// Solves the step. Cells that begin to slip at static friction change to kinetic friction,
    /// which may make other cells slip, so that the solution is repeated.
    pub(super) fn solve_with_static_friction(
        &mut self,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        to.clone_from(self.from);
        for (kinetic, cell) in scratch.kinetic.iter_mut().zip(self.from.cells.values()) {
            *kinetic = *cell == CellState::Slip;
        }
        // These cells are reported as sticking, but the next solve starts from their slip.
        self.mark_dragged(CellState::Slip, to);
        scratch.by_traction.fill(0.0);
        if self.problem.operator().is_coupled() {
            self.displace_by_traction(to, scratch)?;
        }
        let mut convergence = self.alternate_or_continue(true, to, scratch)?;
        while self.switch_to_kinetic_friction(to, scratch) {
            convergence = self.alternate_or_continue(false, to, scratch)?;
        }
        self.finish(to, scratch)?;
        self.mark_dragged(CellState::Stick, to);
        Ok(Convergence { products: self.cost, ..convergence })
    }

    /// Sets the state of those cells of infinite friction whose traction reaches the bound of the
    /// substitute coefficient.
    fn mark_dragged(&self, state: CellState, to: &mut ContactState) {
        let friction = self.problem.friction();
        if !self.problem.operator().is_coupled() || !friction.is_infinite_somewhere() {
            return;
        }
        let tractions = to.traction_x.values().iter().zip(to.traction_y.values());
        let pressed = tractions.zip(to.pressure.values());
        for (i, (((x, y), p), cell)) in pressed.zip(to.cells.values_mut()).enumerate() {
            let all = *p > 0.0 && x.hypot(*y) >= DRAGGED_FRACTION * COEFFICIENT_FOR_INFINITE * p;
            if all && friction.at(i).motion().get().is_infinite() {
                *cell = state;
            }
        }
    }

    /// Whether any cell slips that did not before and thereby loses friction.
    fn switch_to_kinetic_friction(
        &self,
        to: &ContactState,
        scratch: &mut FrictionalScratch,
    ) -> bool {
        let mut any = false;
        for (i, (kinetic, cell)) in scratch.kinetic.iter_mut().zip(to.cells.values()).enumerate() {
            let friction = self.problem.friction().at(i);
            let breaks = !*kinetic && *cell == CellState::Slip;
            any |= breaks && friction.rest() > friction.motion();
            *kinetic |= breaks;
        }
        any
    }

    /// Solves for pressures and tractions in equilibrium.
    fn alternate_or_continue(
        &mut self,
        fresh: bool,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        for (i, (own, slides)) in
            scratch.limits.friction.iter_mut().zip(&scratch.kinetic).enumerate()
        {
            let friction = self.problem.friction().at(i);
            *own = if *slides { friction.motion() } else { friction.rest() }.get();
        }
        scratch.limits.sharpen();
        scratch.tangential.begin_step();
        self.together = false;
        let tolerance = self.method.tolerance;
        if !self.problem.operator().is_coupled() {
            return self.alternate_to_convergence(fresh, tolerance, to, scratch);
        }
        let (greatest, strong) = (
            scratch.limits.greatest_friction(),
            STRONG_COUPLING / coupling(self.problem.operator()),
        );
        if greatest <= strong {
            let start = self.keep(to, scratch);
            match self.alternate_to_convergence(fresh, tolerance, to, scratch) {
                Err(error) if error.lets_others_try() => self.go_back(start, to, scratch),
                done => return done,
            }
        }
        self.continue_in_friction(strong.min(0.5 * greatest), fresh, to, scratch)
    }

    /// Adds the iterations and the products of a solve, and returns its report with the sums so far.
    pub(super) fn count(&mut self, reached: Convergence) -> Convergence {
        self.iterations += reached.iterations;
        self.cost = self.cost.plus(reached.products);
        self.so_far(reached.residuals, reached.stop)
    }

    /// The report with all iterations and products of the step so far.
    pub(super) const fn so_far(&self, residuals: Residuals, stop: Stop) -> Convergence {
        Convergence { iterations: self.iterations, products: self.cost, residuals, stop }
    }

    pub(super) fn keep(&self, to: &ContactState, scratch: &FrictionalScratch) -> Kept {
        (self.rigid, to.clone(), scratch.by_traction.clone())
    }

    pub(super) fn go_back(
        &mut self,
        kept: Kept,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) {
        (self.rigid, *to, scratch.by_traction) = kept;
    }
}

impl Frictional {
    /// A step with contact, solved on all cells.
    pub(super) fn step_on_all(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, FrictionalError> {
        if Self::has_pressures_alone(problem, from) {
            return self.press(problem, from, drive, to, scratch, observer);
        }
        let area = problem.grid().cell_area();
        let load = |driven| match driven {
            Driven::Shift(_) => None,
            Driven::Load(load) => Some(load / area),
        };
        let loads = [load(drive.x), load(drive.y), load(drive.twist)];
        let (cost, rigid) = (Products::default(), Rigid { loads, ..Rigid::default() });
        let (iterations, together, slides) = (0, false, None);
        let mut pass = Pass {
            method: self,
            problem,
            from,
            drive,
            rigid,
            observer,
            cost,
            iterations,
            together,
            slides,
        };
        pass.solve_with_static_friction(to, scratch)
    }
}
