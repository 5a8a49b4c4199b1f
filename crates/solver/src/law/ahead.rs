//! Slip taken ahead, so that steps are of second order.
//!
//! A backward step lets a cell slip along its traction at the end of the step; that direction lags by half a step.
//! The backward difference of second order, `s - s_1 = w^2/(1 + 2 w) (s_1 - s_2) + (a part along the traction)`
//! with w the ratio of the lengths of the two steps, begins a step with a part of the last slip.

use carom_laws::law::Shift;

use super::cells::Cells;
use crate::state::{CellState, ContactState};

/// A ratio of lengths above which slip is not looked ahead any further.
const FARTHEST: f64 = 2.0;

/// The part of the slipping cells that stick after a step from which on it is done without slip ahead: it would have
/// carried them too far.
const ENDED: f64 = 0.75;

/// The way of a step: approach, shifts over f, and twist times a radius over f.
#[derive(Debug, Clone, Copy)]
pub(super) struct Way([f64; 4]);

impl Way {
    /// `radius` is about that of the contact. The friction is finite.
    pub(super) fn new(from: &Shift, to: &Shift, radius: f64, friction: f64) -> Self {
        // Without friction slip has no bearing on loads.
        let over = if friction > 0.0 { 1.0 / friction } else { 1.0 };
        Self([
            to.zeta - from.zeta,
            over * (to.xi - from.xi),
            over * (to.eta - from.eta),
            over * radius * (to.omega - from.omega),
        ])
    }

    fn dot(&self, other: &Self) -> f64 {
        self.0.iter().zip(other.0).map(|(a, b)| a * b).sum()
    }

    /// The part of the slip of the step before that a step begins with; nothing where the way turns back.
    fn part_of(&self, before: &Self) -> f64 {
        let (square, along) = (before.dot(before), self.dot(before));
        if square <= 0.0 || along <= 0.0 {
            return 0.0;
        }
        let cosine = along / (square * self.dot(self)).sqrt();
        let ratio = (self.dot(self) / square).sqrt().min(FARTHEST);
        cosine * ratio * ratio / (1.0 + 2.0 * ratio)
    }
}

/// The displacements of all cells along both axes.
pub(super) fn displacements(state: &ContactState) -> [Vec<f64>; 2] {
    [&state.displacement_x, &state.displacement_y].map(|field| field.values().to_vec())
}

/// Takes back what was taken ahead.
pub(super) fn restore(state: &mut ContactState, before: &[Vec<f64>; 2]) {
    state.displacement_x.values_mut().copy_from_slice(&before[0]);
    state.displacement_y.values_mut().copy_from_slice(&before[1]);
}

/// The slip of a step, in each cell.
#[derive(Debug, Clone)]
pub(super) struct Slip {
    way: Way,
    pub(super) by: [Vec<f64>; 2],
}

impl Slip {
    /// That of a step to a state; zero where cells do not slip. `before` are the displacements before the step.
    pub(super) fn of(way: Way, from: &Shift, before: &[Vec<f64>; 2], state: &ContactState) -> Self {
        let (grid, to) = (state.pressure.grid(), &state.shift);
        let [xi, eta, turn] = [to.xi - from.xi, to.eta - from.eta, to.omega - from.omega];
        let after = [state.displacement_x.values(), state.displacement_y.values()];
        let mut by = [vec![0.0; grid.cells()], vec![0.0; grid.cells()]];
        for (i, (x, y)) in grid.centres().enumerate() {
            if state.cells.values()[i] == CellState::Slip {
                let moved = [xi + y * turn, eta - x * turn]; // (12.2)
                for axis in 0..2 {
                    by[axis][i] = moved[axis] - (after[axis][i] - before[axis][i]);
                }
            }
        }
        Self { way, by }
    }

    /// Whether this slip ends in a state on other cells.
    pub(super) fn ends(&self, own: &Cells, cells: &Cells, state: &ContactState) -> bool {
        let [x, y] = [0, 1].map(|axis| own.pass(&self.by[axis], cells));
        let slipped = x.iter().zip(&y).map(|(x, y)| *x != 0.0 || *y != 0.0);
        let (mut all, mut ended) = (0_u32, 0_u32);
        for (_, cell) in slipped.zip(state.cells.values()).filter(|(slipped, _)| *slipped) {
            all += u32::from(*cell != CellState::Exterior);
            ended += u32::from(*cell == CellState::Stick);
        }
        f64::from(ended) > ENDED * f64::from(all)
    }

    /// Begins a step from a state on other cells with a part of this slip.
    pub(super) fn take_ahead(
        &self,
        own: &Cells,
        way: &Way,
        cells: &Cells,
        from: &mut ContactState,
    ) {
        let part = way.part_of(&self.way);
        if part == 0.0 {
            return;
        }
        let displaced = [from.displacement_x.values_mut(), from.displacement_y.values_mut()];
        for (displaced, by) in displaced.into_iter().zip(&self.by) {
            for (u, slip) in displaced.iter_mut().zip(own.pass(by, cells)) {
                *u -= part * slip;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_part_is_that_of_the_backward_difference() {
        let to = |zeta, xi| Shift { zeta, xi, ..Shift::default() };
        let way = |zeta, xi| Way::new(&Shift::default(), &to(zeta, xi), 1.0, 0.5);
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-15, "{a} {b}");
        near(way(0.3, 0.2).part_of(&way(0.3, 0.2)), 1.0 / 3.0);
        near(way(0.3, 0.2).part_of(&way(0.6, 0.4)), 0.125);
        near(way(9.0, 6.0).part_of(&way(0.3, 0.2)), 0.8);
        // Nothing at a right angle, the other way, and after standstill.
        near(way(0.4, -0.2).part_of(&way(0.4, 0.2)), 0.0);
        near(way(-0.3, -0.2).part_of(&way(0.3, 0.2)), 0.0);
        near(way(0.3, 0.2).part_of(&way(0.0, 0.0)), 0.0);
    }

    #[test]
    fn slip_that_follows_a_parabola_is_met_by_the_rest() {
        // s = t^2 at t = 0, 1, 1.5: the rest is along the rate at the end, (1 + w)/(1 + 2 w) of a step of it.
        let way =
            |t: f64| Way::new(&Shift::default(), &Shift { zeta: t, ..Shift::default() }, 1.0, 1.0);
        let rest = (2.25 - 1.0) - way(0.5).part_of(&way(1.0)) * 1.0;
        assert!((rest - 1.5 / 2.0 * 0.5 * 3.0).abs() < 1e-15, "{rest}");
    }
}
