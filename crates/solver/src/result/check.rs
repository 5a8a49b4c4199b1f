//! How well a state satisfies the conditions of contact, from nothing but the state.

use carom_halfspace::operator::{DisplacementField, OperatorError, TractionField};

use crate::convergence::Residuals;
use crate::friction::firm;
use crate::problem::ContactProblem;
use crate::state::{CellState, ContactState};

/// The greatest violation of the conditions in the step between two states, as in
/// [`crate::Convergence`] but computed anew from the tractions.
///
/// Normal: a gap in the contact, an overlap outside or tension (in displacement by its own cell),
/// over the approach. Tangential: the distance of a traction from where its own slip would pull it
/// within the disc of its limit (of static friction where a cell neither slipped before nor slips
/// after, of kinetic friction elsewhere), over the greatest limit, or over the greatest pressure or
/// traction if friction could hold more than these.
///
/// # Errors
/// [`OperatorError`] for states of another grid.
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
        let limit = firm(friction.get()) * pressure[i].max(0.0);
        most = most.max(limit);
        reached = reached.max(pressure[i]).max(x[i].hypot(y[i]));
        // One compliance for both: a slip against the traction pulls along it.
        let [to_x, to_y] = [x[i] - slip_x.values()[i] / soft, y[i] - slip_y.values()[i] / soft];
        let part = if to_x.hypot(to_y) > limit { limit / to_x.hypot(to_y) } else { 1.0 };
        tangential = tangential.max((part * to_x - x[i]).hypot(part * to_y - y[i]));
    }
    let over = |value: f64, scale: f64| if scale > 0.0 { value / scale } else { value };
    Ok(Residuals { normal: over(normal, depth), tangential: over(tangential, most.min(reached)) })
}
