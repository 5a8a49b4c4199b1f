//! Closed contour lines of a field on a grid (marching squares).

use std::collections::BTreeMap;

use carom_halfspace::{Field, Grid};

use crate::state::{CellState, ContactState};

/// A closed contour line. The region inside lies on its left: outer contours run counterclockwise,
/// those of holes clockwise. The first point is not repeated at the end.
#[derive(Debug, Clone, PartialEq)]
pub struct Contour {
    /// Vertices (x, y), measured from the centre of the grid.
    pub points: Vec<[f64; 2]>,
}

impl Contour {
    /// The enclosed area; negative for holes, so that the areas of all contours add up to that of
    /// the region.
    #[must_use]
    pub fn area(&self) -> f64 {
        let next = self.points.iter().cycle().skip(1);
        0.5 * self.points.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>()
    }

    /// The length of the contour.
    #[must_use]
    pub fn length(&self) -> f64 {
        let next = self.points.iter().cycle().skip(1);
        self.points.iter().zip(next).map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1])).sum()
    }
}

/// Contours of the region where a field exceeds `level`. The field is interpolated linearly between
/// neighbouring cell centres. Beyond the grid it has the value `outside`, which should not exceed
/// `level`: then all contours are closed.
///
/// ```
/// use carom_halfspace::{Field, Grid};
/// use carom_solver::contours;
/// let grid = Grid::new(40, 40, 0.06, 0.06)?;
/// let dome = Field::from_function(grid, |x, y| 1.0 - x * x - y * y);
/// let lines = contours(&dome, 0.0, -1.0);
/// assert_eq!(lines.len(), 1);
/// assert!((lines[0].area() / std::f64::consts::PI - 1.0).abs() < 2e-3);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[must_use]
pub fn contours(field: &Field, level: f64, outside: f64) -> Vec<Contour> {
    Squares { field, level, outside }.contours()
}

impl<T: Copy + Into<f64>> Squares<'_, T> {
    fn contours(&self) -> Vec<Contour> {
        let mut next = self.segments();
        let mut lines = Vec::new();
        while let Some((first, _)) = next.first_key_value() {
            let (first, mut points) = (*first, Vec::new());
            let mut side = first;
            while let Some(onwards) = next.remove(&side) {
                points.push(self.crossing(side));
                side = onwards;
            }
            lines.push(Contour { points });
        }
        lines
    }
}

impl ContactState {
    /// Smoothed contours of the contact area.
    #[must_use]
    pub fn contact_outlines(&self) -> Vec<Contour> {
        self.outlines(|cell| cell != CellState::Exterior)
    }

    /// Smoothed contours of the stick area.
    #[must_use]
    pub fn stick_outlines(&self) -> Vec<Contour> {
        self.outlines(|cell| cell == CellState::Stick)
    }

    /// Smoothed contours of the slip area.
    #[must_use]
    pub fn slip_outlines(&self) -> Vec<Contour> {
        self.outlines(|cell| cell == CellState::Slip)
    }

    /// Contours at the level 1/2 of the smoothed indicator function of a set of cells.
    fn outlines(&self, among: impl Fn(CellState) -> bool) -> Vec<Contour> {
        if !self.cells.values().iter().any(|cell| among(*cell)) {
            return Vec::new();
        }
        let field = sixteenths(&self.cells.map(|cell| u8::from(among(*cell))));
        Squares { field: &field, level: 8.0, outside: 0.0 }.contours()
    }
}

/// Sixteen times the field averaged with the weights 1 2 1 along both axes; values beyond the grid are zero.
fn sixteenths(mask: &Field<u8>) -> Field<u8> {
    let grid = mask.grid();
    let mut all = mask.clone();
    for row in all.values_mut().chunks_exact_mut(grid.nx()) {
        let mut before = 0;
        for i in 0..row.len() {
            let after = row.get(i + 1).copied().unwrap_or(0);
            (before, row[i]) = (row[i], before + 2 * row[i] + after);
        }
    }
    let mut before = vec![0; grid.nx()];
    for j in 0..grid.ny() {
        for (i, before) in before.iter_mut().enumerate() {
            let (here, after) =
                (all.values()[grid.index(i, j)], all.get(i, j + 1).copied().unwrap_or(0));
            all.values_mut()[grid.index(i, j)] = *before + 2 * here + after;
            *before = here;
        }
    }
    all
}

/// An edge between two neighbouring cell centres. Centres of the grid are numbered from 1; 0 lies
/// beyond it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Side {
    /// From (i, j) to (i + 1, j).
    AlongX(usize, usize),
    /// From (i, j) to (i, j + 1).
    AlongY(usize, usize),
}

struct Squares<'a, T> {
    field: &'a Field<T>,
    level: f64,
    outside: f64,
}

impl<T: Copy + Into<f64>> Squares<'_, T> {
    const fn grid(&self) -> Grid {
        self.field.grid()
    }

    fn value(&self, i: usize, j: usize) -> f64 {
        let inside = i.checked_sub(1).zip(j.checked_sub(1));
        inside.and_then(|(i, j)| self.field.get(i, j)).map_or(self.outside, |value| (*value).into())
    }

    fn above(&self, i: usize, j: usize) -> bool {
        self.value(i, j) > self.level
    }

    /// For each edge that a contour crosses, the next edge that it crosses.
    fn segments(&self) -> BTreeMap<Side, Side> {
        let mut next = BTreeMap::new();
        for j in 0..=self.grid().ny() {
            for i in 0..=self.grid().nx() {
                self.segments_of(i, j, &mut next);
            }
        }
        next
    }

    /// The segments in the square whose first corner is (i, j). Going counterclockwise around the
    /// square, a contour runs from an edge where one leaves the region above the level to an edge
    /// where one enters it.
    fn segments_of(&self, i: usize, j: usize, next: &mut BTreeMap<Side, Side>) {
        let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
        let above = corners.map(|(i, j)| self.above(i, j));
        if above == [above[0]; 4] {
            return;
        }
        let sides = [
            Side::AlongX(i, j),
            Side::AlongY(i + 1, j),
            Side::AlongX(i, j + 1),
            Side::AlongY(i, j),
        ];
        let middle = corners.iter().map(|(i, j)| 0.25 * self.value(*i, *j)).sum::<f64>();
        // If only two opposite corners are above the level, the value in the middle decides whether
        // they are connected.
        let onwards = if middle > self.level { 1 } else { 3 };
        for exit in (0..4).filter(|k| above[*k] && !above[(k + 1) % 4]) {
            let entry = (1..4).map(|turn| (exit + turn * onwards) % 4);
            let entry = entry.into_iter().find(|k| !above[*k] && above[(k + 1) % 4]);
            if let Some(entry) = entry {
                next.insert(sides[exit], sides[entry]);
            }
        }
    }

    /// The point of an edge at which the field equals the level.
    fn crossing(&self, side: Side) -> [f64; 2] {
        let (i, j, [along_x, along_y]) = match side {
            Side::AlongX(i, j) => (i, j, [1, 0]),
            Side::AlongY(i, j) => (i, j, [0, 1]),
        };
        let (low, high) = (self.value(i, j), self.value(i + along_x, j + along_y));
        let part = (self.level - low) / (high - low);
        let (i, j) = (i as f64 + along_x as f64 * part, j as f64 + along_y as f64 * part);
        let grid = self.grid();
        let middle = |count: usize| 0.5 * (count as f64 + 1.0);
        [(i - middle(grid.nx())) * grid.dx(), (j - middle(grid.ny())) * grid.dy()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn grid() -> Grid {
        Grid::new(50, 40, 0.05, 0.06).unwrap()
    }

    #[test]
    fn a_ring_has_an_outer_and_an_inner_outline() {
        let ring = |x: f64, y: f64| 0.3 - (x.hypot(y) - 0.6).abs();
        let mut lines = contours(&Field::from_function(grid(), ring), 0.0, -1.0);
        lines.sort_by(|a, b| a.area().total_cmp(&b.area()));
        let areas: Vec<f64> = lines.iter().map(Contour::area).collect();
        assert_eq!(areas.len(), 2);
        assert!((areas[0] / (-PI * 0.09) - 1.0).abs() < 0.01, "{areas:?}");
        assert!((areas[1] / (PI * 0.81) - 1.0).abs() < 0.01, "{areas:?}");
        assert!((lines[1].length() / (2.0 * PI * 0.9) - 1.0).abs() < 0.01);
    }

    #[test]
    fn what_meets_the_border_is_closed() {
        let lines = contours(&Field::uniform(grid(), 1.0), 0.5, 0.0);
        assert_eq!(lines.len(), 1);
        // Halfway between the last centres and those that would follow; corners are cut.
        let exact = 50.0 * 0.05 * 40.0 * 0.06 - 0.5 * 0.05 * 0.06;
        assert!((lines[0].area() - exact).abs() < 1e-12);
        assert!(contours(&Field::uniform(grid(), 0.0), 0.5, 0.0).is_empty());
    }

    #[test]
    fn corners_that_touch_belong_together_where_the_middle_does() {
        let grid = Grid::new(2, 2, 1.0, 1.0).unwrap();
        let count = |other: f64| {
            let field = Field::new(grid, vec![1.0, other, other, 1.0]).unwrap();
            contours(&field, 0.5, -3.0).len()
        };
        assert_eq!((count(0.4), count(-0.4)), (1, 2));
    }

    #[test]
    fn the_outline_of_a_mask_is_smooth() {
        let mut state = ContactState::apart(grid());
        let disc = |x: f64, y: f64| match x.hypot(y) {
            r if r < 0.5 => CellState::Stick,
            r if r < 0.9 => CellState::Slip,
            _ => CellState::Exterior,
        };
        state.cells = Field::from_function(grid(), disc);
        let area = |lines: Vec<Contour>| lines.iter().map(Contour::area).sum::<f64>();
        let [stick, slip, all] =
            [state.stick_outlines(), state.slip_outlines(), state.contact_outlines()];
        assert_eq!((stick.len(), slip.len(), all.len()), (1, 2, 1));
        let length = all[0].length();
        assert!((length / (2.0 * PI * 0.9) - 1.0).abs() < 0.03, "{length}");
        let [stick, slip, all] = [stick, slip, all].map(area);
        assert!((stick / (PI * 0.25) - 1.0).abs() < 0.02, "{stick}");
        assert!((all / (PI * 0.81) - 1.0).abs() < 0.02, "{all}");
        assert!((slip + stick - all).abs() < 0.01 * all, "{slip}");
    }
}
