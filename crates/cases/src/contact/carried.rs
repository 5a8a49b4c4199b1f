//! States that go from one case of an input to the next.

use super::case::ContactCase;
use super::potential::Potential;
use crate::Error;
use carom_halfspace::Field;
use carom_halfspace::operator::{DisplacementField, RolledOperator, TractionField};
use carom_laws::law::Shift;
use carom_solver::{ContactProblem, ContactState, ProblemError};

/// A state whose shifts count from here.
pub(super) fn at_rest(state: ContactState) -> ContactState {
    ContactState { shift: Shift { zeta: state.shift.zeta, ..Shift::default() }, ..state }
}

/// Replaces the displacements of a state by those that particles bring from ahead.
pub(super) fn bring(rolled: &RolledOperator, state: &mut ContactState) -> Result<(), Error> {
    use carom_halfspace::operator::SurfaceOperator as _;
    let grid = state.pressure.grid();
    let [mut along, mut across] = [Field::uniform(grid, 0.0), Field::uniform(grid, 0.0)];
    let load = TractionField::full(
        state.traction_x.values(),
        state.traction_y.values(),
        state.pressure.values(),
    );
    let change = DisplacementField::tangential(along.values_mut(), across.values_mut());
    rolled.apply(load, change, &mut rolled.workspace()).map_err(ProblemError::from)?;
    let fields = [(&mut state.displacement_x, along), (&mut state.displacement_y, across)];
    for (own, change) in fields {
        own.values_mut().iter_mut().zip(change.values()).for_each(|(own, change)| *own -= change);
    }
    Ok(())
}

/// Writes the displacements of the tractions of a state.
pub(super) fn displace(problem: &ContactProblem, state: &mut ContactState) -> Result<(), Error> {
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
    Ok(operator.apply(load, out, &mut operator.workspace()).map_err(ProblemError::from)?)
}

/// Cells that a step of rolling needs beyond those of a case.
pub(super) fn padding(case: &ContactCase) -> Result<[usize; 2], Error> {
    let Some(rolling) = case.motion.rolling() else { return Ok([0; 2]) };
    let (ahead, area) = (rolling.way()?.ahead(), &case.area);
    let more = |i: usize, ahead: f64| {
        let cells = (ahead.abs() / area.size[i]).ceil();
        if cells < area.cells[i] as f64 { Some(0) } else { (cells < 1e4).then_some(cells as usize) }
    };
    match [more(0, ahead.x), more(1, ahead.y)] {
        [Some(x), Some(y)] => Ok([x, y]),
        _ => Err(Error::input("DQ is longer than 10000 cells")),
    }
}

/// The values of a field on the cells of another area; `beyond` elsewhere.
pub(super) fn moved(
    field: &Field,
    from: &Potential,
    to: &Potential,
    beyond: f64,
) -> Result<Field, carom_special::RangeError> {
    let [x, y] = to.offset_from(from).unwrap_or([i64::MAX; 2]);
    let grid = to.window()?.grid();
    let [nx, ny] = to.cells.map(|count| count as i64);
    let value = |i: i64, j: i64| {
        let place =
            |at: i64, offset: i64| at.checked_add(offset).and_then(|at| usize::try_from(at).ok());
        let cell = place(i, x).zip(place(j, y)).and_then(|(i, j)| field.get(i, j));
        cell.copied().unwrap_or(beyond)
    };
    let rows = (0..ny).flat_map(|j| (0..nx).map(move |i| (i, j)));
    Field::new(grid, rows.map(|(i, j)| value(i, j)).collect())
}
