//! A rectangle on the surface that contains the contact, and a window around it.

use carom_halfspace::Grid;
use carom_special::RangeError;

use super::grid_warning::Side;
use super::window::Window;
use crate::problem::ContactProblem;
use crate::state::ContactState;

/// A rectangle with a side outside this range is rejected as no contact.
const ALLOWED_SIDES: [f64; 2] = [1e-18, 1e18];

/// Lower and upper bounds along x and along y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Span([[f64; 2]; 2]);

impl Span {
    pub(crate) fn about_origin(sides: [f64; 2]) -> Result<Self, RangeError> {
        RangeError::positive("sides", sides[0])?;
        RangeError::positive("sides", sides[1])?;
        Ok(Self(sides.map(|side| [-0.5 * side, 0.5 * side])))
    }

    /// The rectangle of all cells in contact; `None` if the bodies are separated.
    pub(crate) fn touching(state: &ContactState, window: &Window) -> Option<Self> {
        let [columns, rows] = state.extent()?;
        Some(Self::of_cells(window, columns, rows))
    }

    fn of_cells(window: &Window, columns: [usize; 2], rows: [usize; 2]) -> Self {
        let (grid, [x, y]) = (window.grid(), window.middle());
        let (dx, dy) = (0.5 * grid.dx(), 0.5 * grid.dy());
        Self([
            [x + grid.centred_x(columns[0]) - dx, x + grid.centred_x(columns[1]) + dx],
            [y + grid.centred_y(rows[0]) - dy, y + grid.centred_y(rows[1]) + dy],
        ])
    }

    /// A few cells around the one with the smallest gap.
    pub(crate) fn around_lowest(problem: &ContactProblem, window: &Window) -> Self {
        let heights = problem.gap().heights().values();
        let lowest = heights.iter().enumerate().min_by(|one, other| one.1.total_cmp(other.1));
        let (cell, nx) = (lowest.map_or(0, |(cell, _)| cell), window.grid().nx());
        Self::of_cells(window, [cell % nx; 2], [cell / nx; 2]).widened(1.5)
    }

    /// The smallest rectangle that contains both.
    pub(crate) fn joined(&self, other: &Self) -> Self {
        let join = |axis: usize| {
            let ([a, b], [c, d]) = (self.0[axis], other.0[axis]);
            [a.min(c), b.max(d)]
        };
        Self([join(0), join(1)])
    }

    /// The same, enlarged to be centred at the origin if `in_the_middle`.
    pub(crate) fn kept(self, in_the_middle: bool) -> Self {
        if !in_the_middle {
            return self;
        }
        Self(self.0.map(|[low, high]| {
            let half = low.abs().max(high.abs());
            [-half, half]
        }))
    }

    fn sides(&self) -> [f64; 2] {
        self.0.map(|[low, high]| high - low)
    }

    /// Enlarged on every side by half of `part` times its length.
    pub(crate) fn widened(&self, part: f64) -> Self {
        Self(self.0.map(|[low, high]| {
            let more = 0.5 * part * (high - low);
            [low - more, high + more]
        }))
    }

    /// One side moved outwards by `part` of the length; both sides if the centre is kept.
    pub(crate) fn moved(&self, side: Side, part: f64, in_the_middle: bool) -> Self {
        let (mut span, [x, y]) = (*self, self.sides());
        match side {
            Side::Left => span.0[0][0] -= part * x,
            Side::Right => span.0[0][1] += part * x,
            Side::Bottom => span.0[1][0] -= part * y,
            Side::Top => span.0[1][1] += part * y,
        }
        span.kept(in_the_middle)
    }

    /// Whether its length along either axis is less than `part` of the other's.
    pub(crate) fn is_small_in(&self, other: &Self, part: f64) -> bool {
        let (own, all) = (self.sides(), other.sides());
        own[0] < part * all[0] || own[1] < part * all[1]
    }

    pub(crate) fn is_sensible(&self) -> bool {
        let inside = |side: f64| (ALLOWED_SIDES[0]..=ALLOWED_SIDES[1]).contains(&side);
        self.sides().into_iter().all(inside)
    }

    /// A window with this number of cells along each axis, `free` of them beyond the rectangle on
    /// each side.
    pub(crate) fn window(&self, cells: usize, free: usize) -> Result<Window, RangeError> {
        let [dx, dy] = self.sides().map(|side| side / (cells - 2 * free) as f64);
        let middle = self.0.map(|[low, high]| 0.5 * (low + high));
        Window::about(middle, Grid::new(cells, cells, dx, dy)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_side_moves_by_a_part_of_the_length_across_it() {
        let oblong = Span([[0.0, 4.0], [0.0, 1.0]]);
        for (side, x, y) in [
            (Side::Left, [-2.0, 4.0], [0.0, 1.0]),
            (Side::Right, [0.0, 6.0], [0.0, 1.0]),
            (Side::Bottom, [0.0, 4.0], [-0.5, 1.0]),
            (Side::Top, [0.0, 4.0], [0.0, 1.5]),
        ] {
            assert_eq!(oblong.moved(side, 0.5, false), Span([x, y]));
        }
    }

    #[test]
    fn a_rectangle_that_is_short_along_either_axis_is_small() {
        let all = Span([[0.0, 1.0]; 2]);
        for (x, y, is_small) in [(0.1, 1.0, true), (1.0, 0.1, true), (0.5, 0.5, false)] {
            assert_eq!(Span([[0.0, x], [0.0, y]]).is_small_in(&all, 0.2), is_small);
        }
    }
}
