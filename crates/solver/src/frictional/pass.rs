//! One step of a history: until no cell breaks, pressures and tractions in equilibrium.

use super::{Frictional, FrictionalError, FrictionalScratch};
use crate::convergence::{Convergence, Observer, Products};
use crate::drive::Drive;
use crate::friction::FIRM;
use crate::problem::ContactProblem;
use crate::state::{CellState, ContactState};
use crate::tangential::Rigid;

/// Up to this over gamma friction is taken as it is.
const STRONG: f64 = 4.0;

/// From this part of the greatest traction on, a cell has all of it.
const DRAGGED: f64 = 1.0 - 1e-6;

/// What to go back to: rigid shifts, state, normal displacement by tractions.
pub(super) type Kept = (Rigid, ContactState, Vec<f64>);

/// One step of a history.
pub(super) struct Pass<'a> {
    pub(super) method: &'a Frictional,
    pub(super) problem: &'a ContactProblem,
    pub(super) from: &'a ContactState,
    pub(super) drive: &'a Drive,
    pub(super) rigid: Rigid,
    pub(super) observer: &'a mut dyn Observer,
    pub(super) spent: Products,
    /// Whether pressures and tractions were found together.
    pub(super) together: bool,
    /// What says that the bodies slide under the pressures of the last pass, if they do.
    pub(super) slides: Option<FrictionalError>,
}

impl Pass<'_> {
    /// Cells that begin to slip at static friction go on at kinetic friction, which may make others
    /// slip.
    pub(super) fn until_no_cell_breaks(
        &mut self,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        to.clone_from(self.from);
        for (broken, cell) in scratch.broken.iter_mut().zip(self.from.cells.values()) {
            *broken = *cell == CellState::Slip;
        }
        // Those are named sticking, but the search for them goes on from what they do.
        self.name_dragged(CellState::Slip, to);
        scratch.by_traction.fill(0.0);
        if self.problem.operator().is_coupled() {
            self.displace_by_traction(to, scratch)?;
        }
        let mut went = self.settle(true, to, scratch)?;
        while self.break_cells(to, scratch) {
            let more = self.settle(false, to, scratch)?;
            went = Convergence { iterations: went.iterations + more.iterations, ..more };
        }
        self.finish(to, scratch)?;
        self.name_dragged(CellState::Stick, to);
        Ok(Convergence { products: self.spent, ..went })
    }

    /// Names the cells of infinite friction whose traction is all that the coefficient that stands for it
    /// allows.
    fn name_dragged(&self, state: CellState, to: &mut ContactState) {
        let friction = self.problem.friction();
        if !self.problem.operator().is_coupled() || !friction.is_infinite_somewhere() {
            return;
        }
        let tractions = to.traction_x.values().iter().zip(to.traction_y.values());
        let pressed = tractions.zip(to.pressure.values());
        for (i, (((x, y), p), cell)) in pressed.zip(to.cells.values_mut()).enumerate() {
            let all = *p > 0.0 && x.hypot(*y) >= DRAGGED * FIRM * p;
            if all && friction.at(i).motion().get().is_infinite() {
                *cell = state;
            }
        }
    }

    /// Whether any cell slips that did not before, where that lessens its friction.
    fn break_cells(&self, to: &ContactState, scratch: &mut FrictionalScratch) -> bool {
        let mut any = false;
        for (i, (broken, cell)) in scratch.broken.iter_mut().zip(to.cells.values()).enumerate() {
            let friction = self.problem.friction().at(i);
            let breaks = !*broken && *cell == CellState::Slip;
            any |= breaks && friction.rest() > friction.motion();
            *broken |= breaks;
        }
        any
    }

    /// Pressures and tractions in equilibrium.
    fn settle(
        &mut self,
        fresh: bool,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        for (i, (own, slides)) in
            scratch.limits.friction.iter_mut().zip(&scratch.broken).enumerate()
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
        let (greatest, strong) = (scratch.limits.greatest_friction(), STRONG / self.gamma());
        if greatest <= strong {
            let start = self.keep(to, scratch);
            match self.alternate_to_convergence(fresh, tolerance, to, scratch) {
                Err(FrictionalError::NotConverged { .. }) => self.go_back(start, to, scratch),
                done => return done,
            }
        }
        self.open_the_cone(strong.min(0.5 * greatest), fresh, to, scratch)
    }

    /// The coupling of pressures and tractions over the compliance.
    fn gamma(&self) -> f64 {
        let [x, _, z] = self.problem.operator().coefficients(1, 0).rows[2];
        if x == 0.0 { 0.0 } else { (x / z).abs() }
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
