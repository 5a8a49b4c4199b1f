//! A box of cells cut out of the window.

use carom_halfspace::{Field, Grid};
use carom_special::RangeError;

use crate::state::ContactState;

/// A box is used if it holds at most this fraction of the cells.
const LARGEST_FRACTION: f64 = 0.7;
/// The shortest side of a box, in cells.
const SHORTEST_SIDE: usize = 32;

/// A rectangular part of a grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cut {
    pub(super) all: Grid,
    pub(super) own: Grid,
    corner: [usize; 2],
}

impl Cut {
    /// A box around the given columns and rows; `None` if it is not worth using. Its sides are
    /// rounded up to a few lengths, so that many steps share one box. If the drive twists the
    /// contact, the box keeps the centre of the grid.
    pub(super) fn about(all: Grid, cells: [[usize; 2]; 2], twists: bool) -> Option<Self> {
        let counts = [all.nx(), all.ny()];
        let side = |axis: usize| {
            let ([low, high], count) = (cells[axis], counts[axis]);
            let least = if twists { count - 2 * low.min(count - high) } else { high - low };
            let length = ladder(least);
            // The box keeps the centre of the grid.
            (!twists || count.is_multiple_of(2)).then_some(length.min(count))
        };
        let sides = [side(0)?, side(1)?];
        let corner = [0, 1].map(|axis| {
            let ([low, high], room) = (cells[axis], counts[axis] - sides[axis]);
            if twists {
                room / 2
            } else {
                ((low + high) / 2).saturating_sub(sides[axis] / 2).min(room)
            }
        });
        if (sides[0] * sides[1]) as f64 > LARGEST_FRACTION * all.cells() as f64 {
            return None;
        }
        let own = Grid::new(sides[0], sides[1], all.dx(), all.dy()).ok()?;
        Some(Self { all, own, corner })
    }

    /// The index in the grid at which each row of the box begins.
    fn rows(&self) -> impl Iterator<Item = usize> + use<> {
        let Self { all, own, corner } = *self;
        (0..own.ny()).map(move |row| all.index(corner[0], corner[1] + row))
    }

    pub(super) fn take<T: Clone>(&self, field: &Field<T>) -> Result<Field<T>, RangeError> {
        let rows =
            self.rows().flat_map(|at| field.values()[at..at + self.own.nx()].iter().cloned());
        Field::new(self.own, rows.collect())
    }

    pub(super) fn give<T: Clone>(&self, own: &Field<T>, field: &mut Field<T>) {
        for (at, row) in self.rows().zip(own.values().chunks_exact(self.own.nx())) {
            field.values_mut()[at..at + row.len()].clone_from_slice(row);
        }
    }

    pub(super) fn state(&self, all: &ContactState) -> Result<ContactState, RangeError> {
        Ok(ContactState {
            shift: all.shift,
            pressure: self.take(&all.pressure)?,
            traction_x: self.take(&all.traction_x)?,
            traction_y: self.take(&all.traction_y)?,
            displacement_x: self.take(&all.displacement_x)?,
            displacement_y: self.take(&all.displacement_y)?,
            cells: self.take(&all.cells)?,
        })
    }

    pub(super) fn holds(&self, cell: usize) -> bool {
        let (column, row) = (cell % self.all.nx(), cell / self.all.nx());
        let inside = |at: usize, corner: usize, side: usize| (corner..corner + side).contains(&at);
        inside(column, self.corner[0], self.own.nx()) && inside(row, self.corner[1], self.own.ny())
    }
}

/// The next of the lengths 4, 5, 6, 7 times a power of two.
fn ladder(least: usize) -> usize {
    let least = least.max(SHORTEST_SIDE);
    let step = (least.next_power_of_two() / 8).max(1);
    least.next_multiple_of(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_hold_their_cells_and_keep_the_middle_of_a_twist() {
        let all = Grid::new(200, 160, 0.1, 0.2).unwrap();
        for cells in [[[3, 40], [100, 160]], [[0, 20], [0, 30]], [[90, 120], [70, 80]]] {
            let cut = Cut::about(all, cells, false).unwrap();
            let [columns, rows] = cells;
            assert!(cut.holds(all.index(columns[0], rows[0])));
            assert!(cut.holds(all.index(columns[1] - 1, rows[1] - 1)));
            assert!(cut.corner[0] + cut.own.nx() <= 200 && cut.corner[1] + cut.own.ny() <= 160);
            if let Some(cut) = Cut::about(all, cells, true) {
                assert!(cut.holds(all.index(columns[0], rows[0])));
                assert_eq!(2 * cut.corner[0] + cut.own.nx(), 200);
                assert_eq!(2 * cut.corner[1] + cut.own.ny(), 160);
            }
        }
        // A box of a twist reaches as far on the other side of the middle.
        let cut = Cut::about(all, [[110, 150], [60, 90]], true).unwrap();
        assert!(cut.holds(all.index(149, 60)) && cut.holds(all.index(50, 89)));
        assert!(Cut::about(all, [[0, 199], [0, 159]], false).is_none());
        assert_eq!([30, 33, 65, 100, 129].map(ladder), [32, 40, 80, 112, 160]);
    }
}
