//! The surfaces after a step: the gap that is left, patches of contact, and how near the pressure is to the solution.

use super::StoredEnergy;
use crate::problem::ContactProblem;
use crate::state::{CellState, ContactState};
use carom_halfspace::operator::OperatorError;
use carom_halfspace::Field;

/// The distance of the deformed surfaces in each cell, computed anew from the tractions: w1 - w2 plus the undeformed gap,
/// minus the approach; infinite where there is no body. In contact it is what is left of the conditions.
///
/// # Errors
/// [`OperatorError`] if the state is on another grid.
pub fn gap_left(problem: &ContactProblem, state: &ContactState) -> Result<Field, OperatorError> {
    let (_, w) = StoredEnergy::total_and_displacement(problem, state)?;
    Ok(left(problem, state, w))
}

/// The gap from the displacement w.
fn left(problem: &ContactProblem, state: &ContactState, mut w: Field) -> Field {
    let heights = problem.gap().heights().values();
    let zeta = state.shift.zeta;
    w.values_mut().iter_mut().zip(heights).for_each(|(w, height)| *w += height - zeta);
    w
}

/// What the deformed surfaces are.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Surfaces {
    /// Mean distance over the window, where there is a body.
    pub(super) mean_gap: f64,
    /// Number of patches of contact.
    pub(super) patches: usize,
    /// How far the elastic energy may be above its least value for this force.
    pub(super) energy_gap: f64,
    /// Elastic energy of both bodies.
    pub(super) stored: f64,
}

impl Surfaces {
    pub(super) fn of(
        problem: &ContactProblem,
        state: &ContactState,
    ) -> Result<Self, OperatorError> {
        let (stored, w) = StoredEnergy::total_and_displacement(problem, state)?;
        let gap = left(problem, state, w);
        let (sum, count) = gap
            .values()
            .iter()
            .filter(|gap| gap.is_finite())
            .fold((0.0, 0.0), |(sum, count), gap| (sum + gap, count + 1.0));
        Ok(Self {
            mean_gap: sum / count,
            patches: patches(&state.cells, !problem.operator().displaces_on_average()),
            energy_gap: energy_gap(&state.pressure, &gap),
            stored,
        })
    }
}

/// The gap of Frank and Wolfe. For a given force F the pressure p >= 0 is the one of least energy
/// J(p) = p.Kp/2 + p.h, whose gradient is the distance g of the surfaces but for a constant. J is convex, so that
/// J(p) - J(q) <= (p - q).g for every q; the least value of q.g is F times the least g. Hence J is above its least value by
/// p.g - F min g at most, and |p - p*|^2 = (p - p*).K(p - p*) by twice as much.
fn energy_gap(pressure: &Field, gap: &Field) -> f64 {
    let least = gap.values().iter().copied().fold(f64::INFINITY, f64::min);
    let pairs = pressure.values().iter().zip(gap.values()).filter(|(p, _)| **p > 0.0);
    let sum: f64 = pairs.map(|(p, gap)| p * (gap - least)).sum();
    pressure.grid().cell_area() * sum
}

/// The number of connected parts of the contact; cells are connected along their sides, and over the border if the
/// surfaces are periodic.
fn patches(cells: &Field<CellState>, is_periodic: bool) -> usize {
    let (grid, cells) = (cells.grid(), cells.values());
    let mut patches = Patches::default();
    let (mut below, mut first) = (vec![None; grid.nx()], Vec::new());
    for row in cells.chunks_exact(grid.nx()) {
        let mut own: Vec<Option<usize>> = Vec::with_capacity(grid.nx());
        for (cell, below) in row.iter().zip(&below) {
            let left = own.last().copied().flatten();
            own.push((*cell != CellState::Exterior).then(|| match (left, *below) {
                (Some(one), Some(other)) => patches.join(one, other),
                (Some(one), None) | (None, Some(one)) => one,
                (None, None) => patches.begin(),
            }));
        }
        if is_periodic && let (Some(Some(one)), Some(Some(other))) = (own.first(), own.last()) {
            patches.join(*one, *other);
        }
        if is_periodic && first.is_empty() {
            first.clone_from(&own);
        }
        below = own;
    }
    for pair in first.iter().zip(&below) {
        if let (Some(one), Some(other)) = pair {
            patches.join(*one, *other);
        }
    }
    patches.count
}

/// Parts of patches, each of which points to another of the same patch or to itself.
#[derive(Default)]
struct Patches {
    parents: Vec<usize>,
    count: usize,
}

impl Patches {
    fn begin(&mut self) -> usize {
        self.parents.push(self.parents.len());
        self.count += 1;
        self.parents.len() - 1
    }

    /// Makes two parts one patch.
    fn join(&mut self, one: usize, other: usize) -> usize {
        let [one, other] = [one, other].map(|part| self.root(part));
        if one != other {
            self.parents[one] = other;
            self.count -= 1;
        }
        other
    }

    fn root(&mut self, mut part: usize) -> usize {
        while self.parents[part] != part {
            self.parents[part] = self.parents[self.parents[part]];
            part = self.parents[part];
        }
        part
    }
}

/// Root mean square of the gradient of the undeformed gap, by differences of neighbours with a body.
pub(super) fn rms_slope(problem: &ContactProblem) -> f64 {
    let gap = problem.gap();
    let (grid, heights) = (gap.grid(), gap.heights().values());
    let mean = |offset: usize, width: f64, is_pair: &dyn Fn(usize) -> bool| {
        let steps = (0..heights.len().saturating_sub(offset)).filter(|cell| is_pair(*cell));
        let steps = steps.map(|cell| (heights[cell + offset] - heights[cell]) / width);
        let steps = steps.filter(|step| step.is_finite());
        let (sum, count) =
            steps.fold((0.0, 0.0), |(sum, count), step| (sum + step * step, count + 1.0));
        if count > 0.0 { sum / count } else { 0.0 }
    };
    let in_row = |cell: usize| cell % grid.nx() + 1 < grid.nx();
    libm::sqrt(mean(1, grid.dx(), &in_row) + mean(grid.nx(), grid.dy(), &|_| true))
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_halfspace::Grid;

    #[test]
    fn patches_are_connected_along_sides_and_over_a_periodic_border() {
        let grid = Grid::new(5, 4, 1.0, 1.0).unwrap();
        let map = "#.##.\
                   #...#\
                   .#...\
                   #...#";
        let cells =
            map.chars().map(|c| if c == '#' { CellState::Stick } else { CellState::Exterior });
        let cells = Field::new(grid, cells.collect()).unwrap();
        assert_eq!(patches(&cells, false), 6);
        // Over the border the left column joins itself, and the right one joins it.
        assert_eq!(patches(&cells, true), 3);
    }
}
