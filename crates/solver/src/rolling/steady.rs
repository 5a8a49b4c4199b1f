//! Steady rolling, solved at once.

use carom_halfspace::operator::{DisplacementField, TractionField};
use carom_laws::law::Shift;

use super::{Creepage, RollingError, check_room, columns};
use crate::convergence::Convergence;
use crate::direct::Influence;
use crate::drive::Drive;
use crate::kalker::{KalkerScratch, Panagiotopoulos};
use crate::method::Method as _;
use crate::problem::ContactProblem;
use crate::state::{CellState, ContactState};

/// Steady rolling.
#[derive(Debug, Clone)]
pub struct SteadyRolling {
    /// Tractions, displacements and areas, which stand still; the shift is that of one step.
    pub state: ContactState,
    /// How it was found.
    pub convergence: Convergence,
    /// Whether the creepage is beyond saturation: all of the contact slides, and more creepage brings
    /// no more force.
    pub slides: bool,
}

/// Steady rolling at an approach, in steps of this distance, by NORM and TANG with the coefficients
/// of u(x) - u(x + distance): what [`super::Roll`] with the same distance tends to.
///
/// # Errors
/// [`RollingError`] for a distance that is not positive, a contact too close to the leading border,
/// and where the active sets do not settle.
pub fn roll_steadily(
    problem: &ContactProblem,
    approach: f64,
    distance: f64,
    creepage: Creepage,
) -> Result<SteadyRolling, RollingError> {
    creepage.check()?;
    let shift = columns(problem, distance)?;
    let influence = Influence::rolled(problem.operator(), shift);
    let mut scratch = KalkerScratch::with_influence(problem, influence)?;
    let apart = ContactState::apart(problem.grid());
    let mut state = apart.clone();
    let drive = Drive::by_shift(Shift {
        zeta: approach,
        xi: creepage.along * distance,
        eta: creepage.across * distance,
        omega: creepage.spin * distance,
    });
    let method = Panagiotopoulos::default();
    let convergence = method.step(problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
    check_room(&state, shift)?;
    let load = TractionField::full(
        state.traction_x.values(),
        state.traction_y.values(),
        state.pressure.values(),
    );
    let out = DisplacementField::tangential(
        state.displacement_x.values_mut(),
        state.displacement_y.values_mut(),
    );
    let operator = problem.operator();
    operator.apply(load, out, &mut operator.workspace())?;
    let slides = state.count(CellState::Stick) == 0 && state.count(CellState::Slip) > 0;
    Ok(SteadyRolling { state, convergence, slides })
}
