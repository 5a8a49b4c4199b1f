//! Discretisation errors, estimated from the same solution on three nested grids.

use carom_laws::law::{ContactLoad, Shift};

use super::border::{Border, NORMAL, ROUND_OFF, TANGENTIAL, TORSIONAL, Uncertain, is_given};
use super::contour::Contour;
use crate::state::{CellState, ContactState};

/// Bounds on the ratio of successive differences when the cell width is halved: 4 is second order.
const DIFFERENCE_RATIOS: [f64; 2] = [1.5, 4.0];

/// The same in first order: 2 is its ratio, less that of values whose order is not reached yet.
const FIRST_ORDER_RATIOS: [f64; 2] = [1.75, 2.0];
/// A factor on estimates of first order.
const FIRST_ORDER_SAFETY: f64 = 1.25;

/// The least part of the error of one component in that of the other.
const LEAST_PART: f64 = 0.25;

/// A traction has an edge at the border of the grid if it is greatest there and exceeds the value
/// in the next cell by this factor.
const EDGE_RATIO: f64 = 1.01;

/// The least error of a force or a shift where tractions are greatest at an edge, which cells miss by up to a half: this part of
/// the value times the width of a cell over the size of the contact. It covered 98 % of the errors of 150 drawn punches with
/// closed forms (circles, ellipses, squares turned against the grid), the worst to 1.2 times.
const PART_OF_EDGE: f64 = 0.4;
/// A torque under a punch grows with the third power of its size, a force with the first; most of its error is that of the size.
const TORQUE_OVER_FORCE: f64 = 2.5;

/// How much more a contact gives way along the surface than along the normal: 1 to 1.5 times where it sticks, twice that
/// near sliding.
const TANGENTIAL_COMPLIANCE: f64 = 2.0;
/// The same of a twist at the radius of the contact.
const TORSIONAL_COMPLIANCE: f64 = 3.0;

/// The error of the greatest pressure, which lies between cells, often near an edge: this part of what it exceeds its four
/// neighbours by.
const PART_OF_EXCESS: f64 = 0.3;
/// Its bounds, over the differences between grids.
const PARTS_OF_DIFFERENCE: [f64; 2] = [0.45, 2.0];

/// The smallest contact spot that a grid may miss, in cells: two by two.
const CELLS_OF_A_MISSED_SPOT: f64 = 4.0;

/// Tangential loads and shifts are compared with at least this fraction of the normal ones.
const LEAST_TANGENTIAL_FRACTION: f64 = 0.01;

/// The order in which tangential values of a method converge with the width of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MeshOrder {
    /// The error is halved with the width, as in rolling, where surfaces are compared over one cell.
    First,
    /// The error falls to a quarter.
    #[default]
    Second,
}

/// A value on the finest grid with an estimate of its discretisation error.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Estimated {
    /// The value on the finest grid.
    pub value: f64,
    /// The estimated magnitude of its error.
    pub error: f64,
}

impl Estimated {
    /// From the values on grids of width h, 2 h and 4 h, finest first, by Richardson extrapolation.
    /// The observed ratio of successive differences is limited to the range 1.5 to 4. A difference
    /// that vanishes by coincidence is not taken for an error of zero.
    #[must_use]
    pub fn of(values: [f64; 3]) -> Self {
        let (fine, coarse) = ((values[0] - values[1]).abs(), (values[1] - values[2]).abs());
        let fall = if fine > 0.0 {
            (coarse / fine).clamp(DIFFERENCE_RATIOS[0], DIFFERENCE_RATIOS[1])
        } else {
            DIFFERENCE_RATIOS[1]
        };
        let error = fine.max(coarse / DIFFERENCE_RATIOS[1]) / (fall - 1.0);
        Self { value: values[0], error }
    }

    /// As [`Estimated::of`], for tractions that are greatest at an edge that the grid resolves only
    /// to a fraction of a cell, as under a punch. The error is then of first order and changes in
    /// jumps, so that values may agree by chance: unless they are given, it is at least this part of the value.
    #[must_use]
    pub fn of_edge(values: [f64; 3], least: f64) -> Self {
        let (fine, coarse) = ((values[0] - values[1]).abs(), (values[1] - values[2]).abs());
        let least = if is_given(values) { 0.0 } else { least * values[0].abs() };
        Self { value: values[0], error: fine.max(coarse / DIFFERENCE_RATIOS[1]).max(least) }
    }
}

impl Estimated {
    /// As [`Estimated::of`], for values that converge in first order or slower: a difference is half of the one before, and as
    /// large as all those that follow. A quarter is added, since the order is not known well.
    #[must_use]
    pub fn of_first_order(values: [f64; 3]) -> Self {
        let (fine, coarse) = ((values[0] - values[1]).abs(), (values[1] - values[2]).abs());
        let fall = if fine > 0.0 {
            (coarse / fine).clamp(FIRST_ORDER_RATIOS[0], FIRST_ORDER_RATIOS[1])
        } else {
            FIRST_ORDER_RATIOS[1]
        };
        Self { value: values[0], error: FIRST_ORDER_SAFETY * fine.max(0.5 * coarse) / (fall - 1.0) }
    }
}

/// Both components of a force or a shift in first order. A component whose values on three grids agree by
/// chance still has a part of the error of the other one.
fn both_of_first_order(components: [[f64; 3]; 2]) -> [Estimated; 2] {
    let components = components.map(Estimated::of_first_order);
    let least = LEAST_PART * components[0].error.max(components[1].error);
    // A given value has no error.
    let raised = |own: Estimated| Estimated { error: own.error.max(least), ..own };
    components.map(|own| if own.error > ROUND_OFF * own.value.abs() { raised(own) } else { own })
}

/// How tangential values converge.
#[derive(Debug, Clone, Copy)]
struct Along {
    order: MeshOrder,
    /// Where tractions are greatest at an edge: the least part of a force or a shift by which it is in error.
    at_edge: Option<f64>,
}

impl Along {
    /// Both components of a force or a shift.
    fn both(self, components: [[f64; 3]; 2], at_border: Uncertain) -> [Estimated; 2] {
        match self.order {
            MeshOrder::First => both_of_first_order(components),
            MeshOrder::Second => match self.at_edge {
                Some(least) => components.map(|values| Estimated::of_edge(values, least)),
                None => TANGENTIAL.of_both(components, at_border),
            },
        }
    }

    /// A torque or a twist.
    fn turned(
        self,
        values: [f64; 3],
        beside: [[f64; 3]; 2],
        radius: f64,
        at_border: f64,
    ) -> Estimated {
        match self.order {
            MeshOrder::First => Estimated::of_first_order(values),
            MeshOrder::Second => match self.at_edge {
                Some(least) => Estimated::of_edge(values, TORQUE_OVER_FORCE * least),
                None => TORSIONAL.of_turned(values, beside, radius, at_border),
            },
        }
    }
}

impl ContactState {
    /// The area of the cells in contact; that of a cell without contact.
    fn cells_in_contact(&self) -> f64 {
        let touching = self.pressure.values().iter().filter(|p| **p > 0.0).count().max(1);
        touching as f64 * self.pressure.grid().cell_area()
    }

    /// The radius of a circle of the size of the contact.
    fn radius(&self) -> f64 {
        (self.cells_in_contact() / std::f64::consts::PI).sqrt()
    }

    /// The greater width of a cell over the size of the contact, the root of its area.
    fn width_over_size(&self) -> f64 {
        let grid = self.pressure.grid();
        grid.dx().max(grid.dy()) / self.cells_in_contact().sqrt()
    }

    /// The approach over the force; 0 without a force.
    fn compliance(&self) -> f64 {
        let force = self.load().f_z;
        if force > 0.0 { self.shift.zeta.abs() / force } else { 0.0 }
    }

    /// Whether a traction is greatest in a cell at the border of the contact, as under a punch. At
    /// the border of the grid it must also decrease inwards: a periodic traction has no edge.
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
            (None, Some(before)) => most > EDGE_RATIO * traction(before),
            (None, None) => false,
        };
        most > 0.0 && (0..2).any(|axis| ends(axis, 1) || ends(axis, -1))
    }

    /// The part of a tangential force that a stick area of two cells along x would take away at the leading edge of a contact
    /// that slides at a falling creepage: Carter's, and of an ellipse that of its strips.
    fn hidden_stick(&self) -> f64 {
        let (grid, p) = (self.pressure.grid(), self.pressure.values());
        let touches = |i: &usize| (0..grid.ny()).any(|j| p[grid.index(*i, j)] > 0.0);
        let columns = (0..grid.nx()).filter(touches).count().max(2);
        let size = 2.0 / columns as f64;
        if grid.ny() == 1 { size * size } else { size * size * size.sqrt() }
    }

    /// Whether the pressure is greatest at an edge, as under a punch.
    pub(super) fn has_a_pressed_edge(&self) -> bool {
        let p = self.pressure.values();
        self.peaks_at_the_edge(|i| p[i])
    }

    /// The greatest pressure with its error, from that on three grids.
    fn estimated_peak(&self, values: [f64; 3], at_edge: bool, border: Border) -> Estimated {
        if at_edge {
            return Estimated::of_edge(values, 0.0);
        }
        if border.normal == Uncertain::default() {
            return Estimated::of(values);
        }
        let difference = (values[0] - values[1]).abs() + 0.5 * (values[1] - values[2]).abs();
        let [least, most] = PARTS_OF_DIFFERENCE.map(|part| part * difference);
        let error = (PART_OF_EXCESS * self.excess_of_the_peak()).clamp(least, most);
        Estimated { value: values[0], error }
    }

    /// By how much the highest cell exceeds the means of its neighbours along both axes, together.
    fn excess_of_the_peak(&self) -> f64 {
        let (grid, p) = (self.pressure.grid(), self.pressure.values());
        let Some((top, peak)) = p.iter().enumerate().max_by(|one, other| one.1.total_cmp(other.1))
        else {
            return 0.0;
        };
        let excess = |at: usize, count: usize, step: usize| {
            let inside = at > 0 && at + 1 < count;
            if inside { 2.0 * peak - p[top - step] - p[top + step] } else { 0.0 }
        };
        excess(top % grid.nx(), grid.nx(), 1) + excess(top / grid.nx(), grid.ny(), grid.nx())
    }

    /// The greatest pressure, from parabolas through the highest cell and its neighbours along both
    /// axes if all of these are in contact.
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

/// The loads, shifts and areas of a state with their estimated discretisation errors.
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
    /// Approach. Its error is not zero if the normal force is prescribed.
    pub zeta: Estimated,
    /// Shift along x.
    pub xi: Estimated,
    /// Shift along y.
    pub eta: Estimated,
    /// Twist.
    pub omega: Estimated,
    /// The greatest pressure.
    pub peak: Estimated,
    /// The contact area. Its error is at least that of half a ring of cells along the border, and
    /// at least four cells, the size of a spot that the grid may miss.
    pub contact_area: Estimated,
    /// The stick area. Its error has the same lower bound; it is zero only without friction.
    pub stick_area: Estimated,
}

impl Estimates {
    /// From the states of one contact on three grids, finest first, with cell widths h, 2 h and 4
    /// h. Tangential values converge in this order.
    #[must_use]
    pub fn of(states: [&ContactState; 3], order: MeshOrder) -> Self {
        let state = states[0];
        let [x, y] = [&state.traction_x, &state.traction_y].map(|f| f.values());
        let normal_edge = state.has_a_pressed_edge();
        let tangential_edge = normal_edge || state.peaks_at_the_edge(|i| x[i].hypot(y[i]));
        let least = PART_OF_EDGE * state.width_over_size();
        // A smooth contact that sticks has such tractions too, but meets its outline as one that slides.
        let at_edge = tangential_edge.then_some(if normal_edge { least } else { 0.0 });
        let along = Along { order, at_edge };
        let border = Border::of(state);
        let (radius, compliance) = (state.radius(), state.compliance());
        let pressed = |values: [f64; 3], at_border: Uncertain| {
            if normal_edge {
                Estimated::of_edge(values, least)
            } else {
                NORMAL.estimated(values, at_border)
            }
        };
        let area = |outlines: &dyn Fn(&ContactState) -> Vec<Contour>, touching: bool| {
            let all = states.map(outlines);
            let values = all.each_ref().map(|lines| lines.iter().map(Contour::area).sum());
            let estimated =
                if normal_edge { Estimated::of_edge(values, 0.0) } else { Estimated::of(values) };
            let cell = state.pressure.grid().cell_area();
            let ring: f64 = all[0].iter().map(Contour::length).sum();
            let missed = if touching { CELLS_OF_A_MISSED_SPOT * cell } else { 0.0 };
            let least = missed.max(0.5 * ring * cell.sqrt());
            Estimated { error: estimated.error.max(least), ..estimated }
        };
        let touches = state.pressure.values().iter().any(|p| *p > 0.0);
        // Without tangential tractions and without stick there is no friction.
        let pulled = x.iter().chain(y).any(|t| *t != 0.0);
        let may_stick = pulled || state.count(CellState::Stick) > 0;
        let tangential = border.tangential;
        let loads = states.map(ContactState::load);
        let load = |value: fn(ContactLoad) -> f64| loads.map(value);
        let shift = |value: fn(Shift) -> f64| states.map(|state| value(state.shift));
        let forces = [load(|all| all.f_x), load(|all| all.f_y)];
        let shifts = [shift(|all| all.xi), shift(|all| all.eta)];
        let shifted = tangential * compliance * TANGENTIAL_COMPLIANCE;
        let twisted = tangential.curved * compliance * TORSIONAL_COMPLIANCE / radius;
        // Where all cells slide on all grids, an area too small for them may stick.
        let slides = pulled && state.count(CellState::Stick) == 0 && order == MeshOrder::First;
        let hidden = if slides { state.hidden_stick() } else { 0.0 };
        let raised = |own: Estimated| {
            let error = own.error.max(hidden * own.value.abs());
            Estimated { error, ..own }
        };
        let [f_x, f_y] = along.both(forces, tangential).map(raised);
        let [xi, eta] = along.both(shifts, shifted);
        Self {
            f_x,
            f_y,
            f_z: pressed(load(|all| all.f_z), border.normal),
            m_z: raised(along.turned(
                load(|all| all.m_z),
                forces,
                radius,
                tangential.curved * radius,
            )),
            zeta: pressed(shift(|all| all.zeta), border.normal * compliance),
            xi,
            eta,
            omega: along.turned(shift(|all| all.omega), shifts, 1.0 / radius, twisted),
            peak: state.estimated_peak(
                states.map(ContactState::peak_pressure),
                normal_edge,
                border,
            ),
            contact_area: area(&ContactState::contact_outlines, touches),
            stick_area: area(&ContactState::stick_outlines, may_stick),
        }
    }

    /// The greatest error of any load or shift in a history, relative to the greatest value of its
    /// kind. Tangential forces are taken together and compared with at least a hundredth of the
    /// normal force; torques are divided by a radius.
    #[must_use]
    pub fn worst(all: &[Self]) -> f64 {
        Self::worst_of_each(all).fold(0.0, f64::max)
    }

    /// The same of each step, in order.
    pub(super) fn worst_of_each(all: &[Self]) -> impl Iterator<Item = f64> {
        let greatest = |value: &dyn Fn(&Self) -> f64| {
            all.iter().map(|one| value(one).abs()).fold(0.0, f64::max)
        };
        let radius = (greatest(&|one| one.contact_area.value) / std::f64::consts::PI).sqrt();
        let force = greatest(&|one| one.f_z.value);
        let depth = greatest(&|one| one.zeta.value);
        let along = greatest(&|one| one.f_x.value.hypot(one.f_y.value))
            .max(LEAST_TANGENTIAL_FRACTION * force);
        let shift = greatest(&|one| one.xi.value.hypot(one.eta.value))
            .max(LEAST_TANGENTIAL_FRACTION * depth);
        let torque = greatest(&|one| one.m_z.value).max(LEAST_TANGENTIAL_FRACTION * force * radius);
        let turned = if radius > 0.0 { LEAST_TANGENTIAL_FRACTION * depth / radius } else { 0.0 };
        let twist = greatest(&|one| one.omega.value).max(turned);
        let over =
            |value: Estimated, scale: f64| if scale > 0.0 { value.error / scale } else { 0.0 };
        all.iter().map(move |one| {
            let errors = [
                over(one.f_z, force),
                over(one.zeta, depth),
                over(one.f_x, along),
                over(one.f_y, along),
                over(one.xi, shift),
                over(one.eta, shift),
                over(one.m_z, torque),
                over(one.omega, twist),
            ];
            errors.into_iter().fold(0.0, f64::max)
        })
    }
}

#[cfg(test)]
mod tests {
    use carom_halfspace::Grid;

    use super::*;

    /// Pressures of the cells of each row.
    fn pressed<const N: usize>(rows: &[[f64; N]]) -> ContactState {
        let mut state = ContactState::apart(Grid::new(N, rows.len(), 0.1, 0.2).unwrap());
        state.pressure.values_mut().copy_from_slice(&rows.concat());
        state
    }

    /// Under the edge of a body or at the border of the grid, on whichever side.
    #[test]
    fn a_pressure_that_is_greatest_at_any_edge_is_found() {
        let hill = [
            [0.0; 5],
            [0.0, 1.0, 2.0, 1.0, 0.0],
            [0.0, 2.0, 3.0, 2.0, 0.0],
            [0.0, 1.0, 2.0, 1.0, 0.0],
            [0.0; 5],
        ];
        assert!(!pressed(&hill).has_a_pressed_edge());
        let turned = |rows: [[f64; 5]; 5], back: bool, exchanged: bool| {
            let at = |i: usize| if back { 4 - i } else { i };
            let place = |row: usize, column: usize| {
                if exchanged { rows[at(column)][row] } else { rows[row][at(column)] }
            };
            [0, 1, 2, 3, 4].map(|row| [0, 1, 2, 3, 4].map(|column| place(row, column)))
        };
        let edge = [
            [0.0; 5],
            [0.0, 2.0, 1.5, 1.0, 0.0],
            [0.0, 3.0, 2.0, 1.0, 0.0],
            [0.0, 2.0, 1.5, 1.0, 0.0],
            [0.0; 5],
        ];
        let border = [
            [1.0; 5],
            [2.0, 1.5, 1.0, 1.0, 1.0],
            [3.0, 2.0, 1.5, 1.0, 1.0],
            [2.0, 1.5, 1.0, 1.0, 1.0],
            [1.0; 5],
        ];
        for rows in [edge, border] {
            for (back, exchanged) in [(false, false), (true, false), (false, true), (true, true)] {
                let state = pressed(&turned(rows, back, exchanged));
                assert!(state.has_a_pressed_edge(), "{back} {exchanged}: {rows:?}");
            }
        }
        assert!(!pressed(&[[1.0; 5]; 5]).has_a_pressed_edge());
    }

    /// The vertex of the parabola through three cells; beside a separated cell there is none.
    #[test]
    fn the_peak_lies_between_cells_in_contact_alone() {
        let peak = |row: [f64; 5]| pressed(&[row]).peak_pressure();
        assert!((peak([0.0, 2.0, 3.0, 2.5, 0.0]) - (3.0 + 0.25 / 12.0)).abs() < 1e-15);
        assert_eq!(peak([0.0, 3.0, 2.0, 1.0, 0.0]), 3.0);
        assert_eq!(peak([3.0, 2.0, 1.0, 0.0, 0.0]), 3.0);
        assert_eq!(peak([0.0, 2.0, 3.0, 2.0, 0.0]), 3.0);
    }

    /// One component may have a small error by chance, which is raised to a quarter of the other; a given one has none.
    #[test]
    fn the_smaller_error_of_two_components_is_at_least_a_quarter_of_the_greater() {
        let (great, small, given) = ([1.0, 0.9, 0.8], [1.0, 0.999, 0.998], [1.0; 3]);
        let errors = |components| both_of_first_order(components).map(|one| one.error);
        for (components, expected) in [
            ([great, small], [0.1, 0.025]),
            ([small, great], [0.025, 0.1]),
            ([great, given], [0.1, 0.0]),
            ([given, great], [0.0, 0.1]),
        ] {
            // A difference that does not fall counts 1.25/(1.75 - 1) times.
            let [x, y] = errors(components).map(|error| 0.6 * error);
            assert!((x - expected[0]).abs() < 1e-12 && (y - expected[1]).abs() < 1e-12, "{x} {y}");
        }
    }

    /// Along each axis, where the highest cell lies between two others; the axes may be exchanged.
    #[test]
    fn the_highest_cell_exceeds_its_neighbours_along_both_axes() {
        let excess = |state: ContactState| state.excess_of_the_peak();
        assert_eq!(excess(pressed(&[[0.0, 1.0, 0.0], [2.0, 5.0, 3.0], [0.0, 2.5, 0.0]])), 11.5);
        // At the border of the grid one axis is left.
        let upright = [[1.0, 0.0], [5.0, 3.0], [2.5, 0.0]];
        let lying = [[1.0, 5.0, 2.5], [0.0, 3.0, 0.0]];
        assert_eq!([excess(pressed(&upright)), excess(pressed(&lying))], [6.5; 2]);
    }

    /// The error of each load and shift counts, over the greatest value of its kind.
    #[test]
    fn the_worst_error_may_be_that_of_any_value() {
        type Part = fn(&mut Estimates) -> &mut Estimated;
        let parts: [Part; 8] = [
            |all| &mut all.f_x,
            |all| &mut all.f_y,
            |all| &mut all.f_z,
            |all| &mut all.m_z,
            |all| &mut all.zeta,
            |all| &mut all.xi,
            |all| &mut all.eta,
            |all| &mut all.omega,
        ];
        for part in parts {
            let mut all = [Estimates::default(); 2];
            *part(&mut all[0]) = Estimated { value: 1.0, error: 0.25 };
            *part(&mut all[1]) = Estimated { value: -2.0, error: 0.5 };
            assert_eq!(Estimates::worst(&all), 0.25);
            assert_eq!(Estimates::worst_of_each(&all).collect::<Vec<_>>(), [0.125, 0.25]);
        }
    }
}
