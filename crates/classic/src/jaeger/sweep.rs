//! One sweep of the modified Gauss-Seidel procedure (12.17).

use super::gauss_seidel::SlipStress;
use super::program::Program;
use carom_solver::CellState;

impl Program<'_> {
    pub(super) fn sweep(&mut self) -> f64 {
        self.sweeps += 1;
        over(self)
    }
}

/// Updates all stresses along x, then along y, then the pressures, each from the newest values of
/// the others. Returns the largest change relative to the largest pressure.
fn over(program: &mut Program<'_>) -> f64 {
    let own = program.influence.own();
    let relaxation = program.method.relaxation();
    let (mut change, mut top) = (0.0_f64, 0.0_f64);
    for (axis, own) in own.into_iter().enumerate() {
        for cell in 0..program.outcome.cells.len() {
            let given = match program.outcome.cells[cell] {
                CellState::Exterior => false,
                CellState::Stick => true,
                CellState::Slip => axis == 2,
            };
            if !given {
                continue;
            }
            let found = program.influence.displacement(axis, cell, &program.outcome.traction);
            let missing = (program.demand.target[axis][cell] - found) / own;
            program.outcome.traction[axis][cell] += relaxation * missing; // (12.17), first line
            change = change.max(missing.abs());
            if axis == 2 {
                top = top.max(program.outcome.traction[2][cell]);
                if program.method.slip_stress() == SlipStress::AtOnce
                    && program.outcome.cells[cell] == CellState::Slip
                {
                    program.slip_stress(cell);
                }
            }
        }
    }
    program.define_slip_stress(); // (12.17), second line, corrected
    change / top.max(f64::MIN_POSITIVE)
}
