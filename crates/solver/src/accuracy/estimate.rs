//! How wrong a solution is by its mesh, seen from the same one on two coarser grids.

use super::contour::Contour;
use crate::state::{CellState, ContactState};

/// Differences of successive grids fall at least by this factor, at most as the square of the width.
const FALL: [f64; 2] = [1.5, 4.0];

/// A traction that is greatest at the border of the grid, and by this factor greater than in the
/// next cell, has an edge there.
const FALLS: f64 = 1.01;

/// Cells of a spot that a grid may miss: two by two.
const MISSED: f64 = 4.0;

/// What counts beside a greater load or shift of its kind, over the normal one.
const SMALLEST: f64 = 0.01;

/// A value on the finest grid with an estimate of its error by the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Estimated {
    /// The value.
    pub value: f64,
    /// The estimated size of its error.
    pub error: f64,
}

impl Estimated {
    /// From the values on the finest grid and on those of twice and four times the width
    /// (Richardson): differences of successive grids fall with the measured order, kept between
    /// that of 1.5 and of 4 a halving. A difference that vanishes by accident is not believed.
    #[must_use]
    pub fn of(values: [f64; 3]) -> Self {
        let (fine, coarse) = ((values[0] - values[1]).abs(), (values[1] - values[2]).abs());
        let fall = if fine > 0.0 { (coarse / fine).clamp(FALL[0], FALL[1]) } else { FALL[1] };
        let error = fine.max(coarse / FALL[1]) / (fall - 1.0);
        Self { value: values[0], error }
    }

    /// The same where tractions are greatest at an edge that the grid fixes: the edge lies within
    /// part of a cell of its place, which makes errors of the first order, in leaps.
    #[must_use]
    pub fn of_edge(values: [f64; 3]) -> Self {
        let (fine, coarse) = ((values[0] - values[1]).abs(), (values[1] - values[2]).abs());
        Self { value: values[0], error: fine.max(coarse / FALL[1]) }
    }
}

impl ContactState {
    /// Whether a traction is greatest in a cell at the border of the contact, as under a punch. At the
    /// border of the grid it must fall from there: what repeats itself has no edge.
    fn peaks_at_the_edge(&self, traction: impl Fn(usize) -> f64) -> bool {
        let grid = self.pressure.grid();
        let values = (0..grid.cells()).map(|i| (i, traction(i)));
        let Some((top, most)) = values.max_by(|one, other| one.1.total_cmp(&other.1)) else {
            return false;
        };
        let at = [top % grid.nx(), top / grid.nx()];
        let place = |axis: usize, step: isize| {
            let mut place = at;
            place[axis] = at[axis].checked_add_signed(step)?;
            let inside = place[0] < grid.nx() && place[1] < grid.ny();
            inside.then(|| grid.index(place[0], place[1]))
        };
        let ends = |axis: usize, step: isize| match (place(axis, step), place(axis, -step)) {
            (Some(beyond), _) => self.pressure.values()[beyond] == 0.0,
            (None, Some(before)) => most > FALLS * traction(before),
            (None, None) => false,
        };
        most > 0.0 && (0..2).any(|axis| ends(axis, 1) || ends(axis, -1))
    }

    /// The greatest pressure, on parabolas through the highest cell and its neighbours along both
    /// axes where all of them touch.
    #[must_use]
    pub fn peak_pressure(&self) -> f64 {
        let (grid, p) = (self.pressure.grid(), self.pressure.values());
        let Some((top, peak)) = p.iter().enumerate().max_by(|one, other| one.1.total_cmp(other.1))
        else {
            return 0.0;
        };
        let (column, row) = (top % grid.nx(), top / grid.nx());
        let rise = |at: usize, count: usize, step: usize| {
            if at == 0 || at + 1 == count {
                return 0.0;
            }
            let (before, after) = (p[top - step], p[top + step]);
            let bend = 2.0 * peak - before - after;
            let counts = before > 0.0 && after > 0.0 && bend > 0.0;
            if counts { (after - before) * (after - before) / (8.0 * bend) } else { 0.0 }
        };
        peak + rise(column, grid.nx(), 1) + rise(row, grid.ny(), grid.nx())
    }
}

/// The loads, shifts and areas of a state with their errors by the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Estimates {
    /// Force along x.
    pub f_x: Estimated,
    /// Force along y.
    pub f_y: Estimated,
    /// Normal force.
    pub f_z: Estimated,
    /// Torque.
    pub m_z: Estimated,
    /// Approach, which has an error where the force is given.
    pub zeta: Estimated,
    /// Shift along x.
    pub xi: Estimated,
    /// Shift along y.
    pub eta: Estimated,
    /// Twist.
    pub omega: Estimated,
    /// The greatest pressure.
    pub peak: Estimated,
    /// The area that touches; its error is at least that of half a ring of cells, and of the four cells
    /// of a spot too small for the grid.
    pub contact_area: Estimated,
    /// The area that sticks; its error is bounded below in the same way, zero only without friction.
    pub stick_area: Estimated,
}

impl Estimates {
    /// Of the same contact on three grids, the finest first, cells twice and four times as wide.
    #[must_use]
    pub fn of(states: [&ContactState; 3]) -> Self {
        let state = states[0];
        let [p, x, y] = [&state.pressure, &state.traction_x, &state.traction_y].map(|f| f.values());
        let normal_edge = state.peaks_at_the_edge(|i| p[i]);
        let tangential_edge = normal_edge || state.peaks_at_the_edge(|i| x[i].hypot(y[i]));
        let by = |edge: bool, value: &dyn Fn(&ContactState) -> f64| {
            let values = states.map(value);
            if edge { Estimated::of_edge(values) } else { Estimated::of(values) }
        };
        let of = |value: &dyn Fn(&ContactState) -> f64| by(normal_edge, value);
        let along = |value: &dyn Fn(&ContactState) -> f64| by(tangential_edge, value);
        let area = |outlines: &dyn Fn(&ContactState) -> Vec<Contour>, touching: bool| {
            let estimated = of(&|state| outlines(state).iter().map(Contour::area).sum());
            let cell = state.pressure.grid().cell_area();
            let ring: f64 = outlines(state).iter().map(Contour::length).sum();
            let missed = if touching { MISSED * cell } else { 0.0 };
            let least = missed.max(0.5 * ring * cell.sqrt());
            Estimated { error: estimated.error.max(least), ..estimated }
        };
        let touches = state.pressure.values().iter().any(|p| *p > 0.0);
        // Where nothing pulls and nothing sticks there is no friction.
        let pulled = x.iter().chain(y).any(|t| *t != 0.0);
        let may_stick = pulled || state.count(CellState::Stick) > 0;
        Self {
            f_x: along(&|state| state.load().f_x),
            f_y: along(&|state| state.load().f_y),
            f_z: of(&|state| state.load().f_z),
            m_z: along(&|state| state.load().m_z),
            zeta: of(&|state| state.shift.zeta),
            xi: along(&|state| state.shift.xi),
            eta: along(&|state| state.shift.eta),
            omega: along(&|state| state.shift.omega),
            peak: of(&ContactState::peak_pressure),
            contact_area: area(&ContactState::contact_outlines, touches),
            stick_area: area(&ContactState::stick_outlines, may_stick),
        }
    }

    /// The greatest error of a load or shift in a history over the greatest of its kind: tangential
    /// forces together, of at least a hundredth of the normal one, torques times a radius.
    #[must_use]
    pub fn worst(all: &[Self]) -> f64 {
        let greatest = |value: &dyn Fn(&Self) -> f64| {
            all.iter().map(|one| value(one).abs()).fold(0.0, f64::max)
        };
        let radius = (greatest(&|one| one.contact_area.value) / std::f64::consts::PI).sqrt();
        let force = greatest(&|one| one.f_z.value);
        let depth = greatest(&|one| one.zeta.value);
        let along = greatest(&|one| one.f_x.value.hypot(one.f_y.value)).max(SMALLEST * force);
        let shift = greatest(&|one| one.xi.value.hypot(one.eta.value)).max(SMALLEST * depth);
        let torque = greatest(&|one| one.m_z.value).max(SMALLEST * force * radius);
        let turned = if radius > 0.0 { SMALLEST * depth / radius } else { 0.0 };
        let twist = greatest(&|one| one.omega.value).max(turned);
        let over =
            |value: Estimated, scale: f64| if scale > 0.0 { value.error / scale } else { 0.0 };
        let errors = all.iter().flat_map(|one| {
            [
                over(one.f_z, force),
                over(one.zeta, depth),
                over(one.f_x, along),
                over(one.f_y, along),
                over(one.xi, shift),
                over(one.eta, shift),
                over(one.m_z, torque),
                over(one.omega, twist),
            ]
        });
        errors.fold(0.0, f64::max)
    }
}
