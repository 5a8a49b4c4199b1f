//! The main part of the program, fig. 12.3.

use super::chart::ProgramStep;
use super::directions::Directions;
use super::gauss_seidel::GaussSeidel;
use crate::chart::Machine;
use crate::direct::{Demand, DirectError, Influence, Outcome};
use carom_solver::{CellState, Observer, Progress, Residuals};

/// A violation below this fraction of its scale is rounding.
const ROUNDING: f64 = 1e-13;

/// The program during one step.
pub(super) struct Program<'a> {
    pub(super) method: &'a GaussSeidel,
    pub(super) influence: &'a Influence,
    pub(super) demand: &'a Demand,
    pub(super) outcome: &'a mut Outcome,
    /// Unit vectors of the stress in the slip area.
    pub(super) directions: &'a mut Directions,
    pub(super) observer: &'a mut dyn Observer,
    pub(super) sweeps: usize,
    pub(super) residuals: Residuals,
    pub(super) stopped: bool,
    /// The effect of the last step.
    pub(super) amount: f64,
    /// Number of cells that entered or left the stick area in this pass.
    pub(super) moved: f64,
}

impl Program<'_> {
    fn displace(&mut self) {
        self.influence.displacements(&self.outcome.traction, &mut self.outcome.displacement);
    }

    fn test_contact(&mut self) -> f64 {
        let least = ROUNDING * self.demand.depth();
        let mut count = 0.0;
        for cell in 0..self.outcome.cells.len() {
            let overlap = self.demand.target[2][cell] - self.outcome.displacement[2][cell];
            let outside = self.outcome.cells[cell] == CellState::Exterior;
            if outside && overlap > least {
                // An element that left the contact while slipping returns slipping: if it stuck it
                // would be in tension again.
                let slipped = self.directions.left_slipping(cell);
                self.outcome.cells[cell] = if slipped { CellState::Slip } else { CellState::Stick };
            } else if !outside && self.outcome.traction[2][cell] < 0.0 {
                self.let_go(cell);
            } else {
                continue;
            }
            count += 1.0;
        }
        count
    }

    /// Removes an element in tension. If it sticks, it might be in compression once it slips: it is
    /// made to slip first, and leaves the contact only if it is still in tension.
    fn let_go(&mut self, cell: usize) {
        let limit = self.demand.limit(cell, -self.outcome.traction[2][cell]);
        let slips = self.outcome.cells[cell] == CellState::Slip;
        if slips || limit == 0.0 || limit.is_infinite() {
            self.directions.leave(cell, slips);
            self.outcome.release(cell);
        } else {
            self.directions.set(cell, self.outcome.direction(cell));
            self.outcome.cells[cell] = CellState::Slip;
            self.slip_stress(cell);
        }
    }

    fn test_sign(&mut self) -> f64 {
        let least = ROUNDING * self.demand.depth();
        let mut count = 0.0;
        for cell in 0..self.outcome.cells.len() {
            if self.outcome.cells[cell] != CellState::Slip || self.demand.friction[cell] == 0.0 {
                continue;
            }
            let slip = self.demand.slip(cell, &self.outcome.displacement);
            let [x, y] = self.directions.of(cell);
            if slip[0] * x + slip[1] * y > least {
                self.outcome.cells[cell] = CellState::Stick;
                count += 1.0;
            }
        }
        count
    }

    fn define_stick_area(&mut self) -> f64 {
        let mut count = 0.0;
        for cell in 0..self.outcome.cells.len() {
            if self.outcome.cells[cell] != CellState::Stick {
                continue;
            }
            let limit = self.demand.limit(cell, self.outcome.traction[2][cell]);
            let [x, y] = self.outcome.tangent(cell);
            let smooth = self.demand.friction[cell] == 0.0;
            if smooth || x.hypot(y) > limit * (1.0 + ROUNDING) {
                self.directions.set(cell, self.outcome.direction(cell));
                self.outcome.cells[cell] = CellState::Slip;
                count += 1.0;
            }
        }
        count
    }

    /// Coulomb's law (12.4) in the slip area.
    pub(super) fn define_slip_stress(&mut self) {
        for cell in 0..self.outcome.cells.len() {
            if self.outcome.cells[cell] == CellState::Slip {
                self.slip_stress(cell);
            }
        }
    }

    pub(super) fn slip_stress(&mut self, cell: usize) {
        let size = self.demand.friction[cell] * self.outcome.traction[2][cell];
        self.outcome.pull(cell, size, self.directions.of(cell));
    }

    fn test_all(&mut self) {
        self.displace();
        let Outcome { traction, displacement, .. } = &*self.outcome;
        self.residuals = self.demand.residuals(traction, displacement);
        let touching = self.outcome.touching().count();
        let progress = Progress {
            iteration: self.sweeps,
            cells: self.outcome.cells.len(),
            touching,
            residuals: self.residuals,
        };
        self.stopped = self.observer.see(&progress).is_break();
    }
}

impl Machine for Program<'_> {
    type Step = ProgramStep;
    type Error = DirectError;

    fn perform(&mut self, step: ProgramStep) -> Result<f64, DirectError> {
        self.amount = match step {
            ProgramStep::Sweep => self.sweep(),
            ProgramStep::TestContact => self.test_contact(),
            ProgramStep::SlipAlgorithm => self.correct_directions()?,
            ProgramStep::TestSign => {
                self.moved = self.test_sign();
                self.moved
            }
            ProgramStep::DefineStickArea => {
                let count = self.define_stick_area();
                self.moved += count;
                count
            }
            ProgramStep::Displacements => {
                self.displace();
                0.0
            }
            ProgramStep::DefineSlipStress => {
                self.define_slip_stress();
                0.0
            }
            ProgramStep::TestAll => {
                self.test_all();
                self.residuals.worst()
            }
            _ => 0.0,
        };
        Ok(self.amount)
    }

    fn is_done(&mut self, question: ProgramStep, round: usize) -> Result<bool, DirectError> {
        let most = self.method.most();
        let tolerance = self.method.tolerance();
        Ok(match question {
            ProgramStep::StressesStand => self.amount <= 0.1 * tolerance || round >= most.seidel,
            ProgramStep::ContactStands => self.amount == 0.0 || round >= most.contact,
            ProgramStep::DirectionsStand => self.amount <= 0.1 * tolerance || round >= most.slip,
            ProgramStep::StickAreaStands => self.moved == 0.0 || round >= most.stick,
            _ => self.amount <= tolerance || self.stopped || round >= most.program,
        })
    }
}
