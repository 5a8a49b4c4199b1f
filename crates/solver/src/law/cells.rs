//! The grid of a contact that grows and shrinks: cell widths change rarely, cell counts follow the
//! contact.

use carom_halfspace::Grid;
use carom_laws::ellipse::ContactEllipse;
use carom_special::RangeError;

use crate::state::{CellState, ContactState};

/// A square number of cells about the contact point. Counts are multiples of four: then the cells
/// of two windows with equal widths coincide, and four cells form one of twice the width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cells {
    dx: f64,
    dy: f64,
    /// How often the cell widths were doubled.
    doubled: u32,
    /// Number of cells along x and along y.
    count: usize,
    /// Number of cells required across the expected contact.
    asked: usize,
}

/// Ratio of window to Hertz contact, apart from one cell on either side: contacts of dissimilar
/// bodies are up to 2 % wider.
const WINDOW_OVER_HERTZ: f64 = 1.05;

impl Cells {
    /// Cells with this number across an ellipse.
    pub(super) fn across(ellipse: &ContactEllipse, asked: usize) -> Result<Self, RangeError> {
        let width = |semi_axis: f64| 2.0 * semi_axis / asked as f64;
        let (dx, dy) = (width(ellipse.semi_axis_a()), width(ellipse.semi_axis_b()));
        RangeError::positive("width of a cell", dx)?;
        RangeError::positive("width of a cell", dy)?;
        Ok(Self { dx, dy, doubled: 0, count: 8, asked })
    }

    pub(super) const fn asked(&self) -> usize {
        self.asked
    }

    /// How many cells lie across an ellipse.
    pub(super) fn widths_across(&self, ellipse: &ContactEllipse) -> f64 {
        2.0 * (ellipse.semi_axis_a() / self.dx).max(ellipse.semi_axis_b() / self.dy)
    }

    /// The same number of cells, twice as wide.
    pub(super) fn coarser(self) -> Self {
        Self { dx: 2.0 * self.dx, dy: 2.0 * self.dy, doubled: self.doubled + 1, ..self }
    }

    /// The smallest window in which a contact of this size does not reach the border.
    pub(super) fn window_for(self, ellipse: &ContactEllipse) -> Self {
        let needed = WINDOW_OVER_HERTZ * self.widths_across(ellipse) + 2.0;
        let mut cells = Self { count: 8, ..self };
        while (cells.count as f64) < needed {
            cells = cells.wider();
        }
        cells
    }

    /// The next larger window: 8, 12, 16, 24, 32, ...
    pub(super) const fn wider(self) -> Self {
        let count = if self.count.is_power_of_two() {
            self.count + self.count / 2
        } else {
            self.count / 3 * 4
        };
        Self { count, ..self }
    }

    pub(super) fn grid(&self) -> Result<Grid, RangeError> {
        Grid::new(self.count, self.count, self.dx, self.dy)
    }

    /// The key that identifies this window within a law.
    pub(super) const fn key(&self) -> (u32, usize) {
        (self.doubled, self.count)
    }

    /// Whether this window contains all cells of another one.
    pub(super) const fn contain(&self, other: &Self) -> bool {
        self.doubled == other.doubled && self.count >= other.count
    }

    /// Whether a cell at the border is in contact, so that the contact may extend beyond it.
    pub(super) fn touch_border(&self, state: &ContactState) -> bool {
        let (n, cells) = (self.count, state.cells.values());
        let touches = |i: usize| cells[i] != CellState::Exterior;
        (0..n).any(|i| [i, i + n * (n - 1), n * i, n * i + n - 1].into_iter().any(touches))
    }

    /// Transfers values from this window to another one: the mean of four cells where the new cells
    /// are twice as wide, zero where the new window extends beyond this one. Values outside the new
    /// window are dropped.
    pub(super) fn pass(&self, values: &[f64], to: &Self) -> Vec<f64> {
        let (mut from, mut values) = (*self, values.to_vec());
        while from.doubled < to.doubled {
            // Pairs are formed from the centre outwards.
            let whole = from.count.next_multiple_of(4);
            (values, from.count) = (from.placed(&values, whole), whole);
            let half = from.count / 2;
            let mut means = vec![0.0; half * half];
            for (row, line) in values.chunks_exact(from.count).enumerate() {
                for (column, value) in line.iter().enumerate() {
                    means[half * (row / 2) + column / 2] += 0.25 * value;
                }
            }
            (from, values) = (Self { count: half, ..from.coarser() }, means);
        }
        from.placed(&values, to.count)
    }

    /// Values about the centre of a window with another number of cells.
    fn placed(&self, values: &[f64], count: usize) -> Vec<f64> {
        let mut placed = vec![0.0; count * count];
        let common = self.count.min(count);
        let (skip, shift) = ((self.count - common) / 2, (count - common) / 2);
        for row in 0..common {
            let (from, to) = (self.count * (row + skip) + skip, count * (row + shift) + shift);
            placed[to..to + common].copy_from_slice(&values[from..from + common]);
        }
        placed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(count: usize) -> Cells {
        Cells { dx: 0.5, dy: 0.25, doubled: 0, count, asked: 8 }
    }

    #[test]
    fn windows_grow_by_a_third_and_a_half() {
        let mut own = cells(8);
        for expected in [12, 16, 24, 32, 48, 64] {
            own = own.wider();
            assert_eq!(own.count, expected);
        }
    }

    #[test]
    fn values_keep_their_places_and_forces() {
        let place = |cells: &Cells, at: &dyn Fn(f64, f64) -> f64| {
            let centres = cells.grid().unwrap().centres();
            centres.map(|(x, y)| at(x, y)).collect::<Vec<_>>()
        };
        let inside = |x: f64, y: f64| f64::from(x.abs() < 2.0 && y.abs() < 1.0);
        let plane = |x: f64, y: f64| (3.0 + x - 2.0 * y) * inside(x, y);
        let (small, large) = (cells(12), cells(16));
        let grown = small.pass(&place(&small, &plane), &large);
        assert_eq!(grown, place(&large, &plane));
        assert_eq!(large.pass(&grown, &small), place(&small, &plane));
        // A plane has its own values as means.
        let wide = Cells { count: 8, ..large.coarser() };
        assert_eq!(large.pass(&grown, &wide), place(&wide, &plane));
        let wide = Cells { count: 16, ..large.coarser() };
        assert_eq!(small.pass(&place(&small, &plane), &wide), place(&wide, &plane));
        // Twice at once is once and once more, from a window without whole pairs of pairs too.
        let (once, twice) =
            (cells(12).coarser(), Cells { count: 8, ..cells(12).coarser().coarser() });
        let step = small.pass(&place(&small, &plane), &once);
        assert_eq!(small.pass(&place(&small, &plane), &twice), once.pass(&step, &twice));
    }
}
