//! Checks the contact conditions of a state, computed anew from the state alone.

use carom_halfspace::operator::{DisplacementField, OperatorError, TractionField};

use crate::convergence::Residuals;
use crate::friction::finite_coefficient;
use crate::problem::ContactProblem;
use crate::state::{CellState, ContactState};

/// The greatest violations of the contact conditions in the step between two states, defined as in
/// [`crate::Convergence`] but computed anew from the tractions.
///
/// Normal: the greatest gap in the contact, overlap outside, or tension (converted to a
/// displacement of its own cell), relative to the approach. Tangential: the distance between a
/// traction and the traction that its own slip leads to after projection onto the disc of its
/// bound. The bound is that of static friction if a cell slips neither before nor after the step,
/// otherwise of kinetic friction. The distance is relative to the greatest bound, or to the
/// greatest pressure or traction if the bound exceeds these.
///
/// # Errors
/// [`OperatorError`] if a state is on another grid.
pub fn violations(
    problem: &ContactProblem,
    before: &ContactState,
    after: &ContactState,
) -> Result<Residuals, OperatorError> {
    let operator = problem.operator();
    let own = operator.coefficients(0, 0).rows;
    let soft = 0.5 * (own[0][0] + own[1][1]);
    let (x, y) = (after.traction_x.values(), after.traction_y.values());
    let pressure = after.pressure.values();
    let (mut anew, mut w) = (after.clone(), vec![0.0; problem.grid().cells()]);
    let (u, v) = (anew.displacement_x.values_mut(), anew.displacement_y.values_mut());
    let displacements = DisplacementField::full(u, v, &mut w);
    let tractions = TractionField::full(x, y, pressure);
    operator.apply(tractions, displacements, &mut operator.workspace())?;
    let [slip_x, slip_y] = anew.slip_since(before);
    let (mut normal, mut tangential) = (0.0_f64, 0.0_f64);
    let (mut depth, mut most, mut reached) = (0.0_f64, 0.0_f64, 0.0_f64);
    for (i, height) in problem.gap().heights().values().iter().enumerate() {
        let gap = w[i] + height - after.shift.zeta;
        depth = depth.max(after.shift.zeta - height);
        let off = if pressure[i] > 0.0 { gap.abs() } else { (-gap).max(-own[2][2] * pressure[i]) };
        normal = normal.max(off);
        let slips = [before, after].map(|state| state.cells.values()[i] == CellState::Slip);
        let friction = problem.friction().at(i);
        let friction = if slips.contains(&true) { friction.motion() } else { friction.rest() };
        let limit = finite_coefficient(friction.get()) * pressure[i].max(0.0);
        most = most.max(limit);
        reached = reached.max(pressure[i]).max(x[i].hypot(y[i]));
        // One compliance for both directions: slip opposite to the traction pulls along it.
        let [to_x, to_y] = [x[i] - slip_x.values()[i] / soft, y[i] - slip_y.values()[i] / soft];
        let part = if to_x.hypot(to_y) > limit { limit / to_x.hypot(to_y) } else { 1.0 };
        tangential = tangential.max((part * to_x - x[i]).hypot(part * to_y - y[i]));
    }
    let over = |value: f64, scale: f64| if scale > 0.0 { value / scale } else { value };
    Ok(Residuals { normal: over(normal, depth), tangential: over(tangential, most.min(reached)) })
}
