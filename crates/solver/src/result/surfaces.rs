//! The surfaces after a step: the gap that is left, patches of contact, and how near the pressure is to the solution.

use super::StoredEnergy;
use crate::problem::ContactProblem;
use crate::state::{CellState, ContactState};
use carom_halfspace::operator::OperatorError;
use carom_halfspace::{Field, Grid};

/// The distance of the deformed surfaces in each cell, computed anew from the tractions: w1 - w2 plus the undeformed gap,
/// minus the approach; infinite where there is no body. In contact it is what is left of the conditions.
///
/// # Errors
/// [`OperatorError`] if the state is on another grid.
pub fn gap_left(problem: &ContactProblem, state: &ContactState) -> Result<Field, OperatorError> {
    let (_, w) = StoredEnergy::with_displacement(problem, state)?;
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
        let (energy, w) = StoredEnergy::with_displacement(problem, state)?;
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
            stored: energy.total(),
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
    let grid = cells.grid();
    let is_in = |cell: usize| cells.values()[cell] != CellState::Exterior;
    // Each cell points to one of its patch; the patch is the cell that points to itself.
    let mut parents: Vec<usize> = (0..grid.cells()).collect();
    let mut count = (0..grid.cells()).filter(|cell| is_in(*cell)).count();
    for cell in (0..grid.cells()).filter(|cell| is_in(*cell)) {
        for other in
            next(grid, cell, is_periodic).into_iter().flatten().filter(|other| is_in(*other))
        {
            let [one, two] = [cell, other].map(|cell| root(&mut parents, cell));
            if one != two {
                parents[one] = two;
                count -= 1;
            }
        }
    }
    count
}

/// The cells to the right and above.
fn next(grid: Grid, cell: usize, is_periodic: bool) -> [Option<usize>; 2] {
    let (nx, ny) = (grid.nx(), grid.ny());
    let (i, j) = (cell % nx, cell / nx);
    let right = if i + 1 < nx { Some(cell + 1) } else { is_periodic.then_some(j * nx) };
    let above = if j + 1 < ny { Some(cell + nx) } else { is_periodic.then_some(i) };
    [right, above]
}

fn root(parents: &mut [usize], mut cell: usize) -> usize {
    while parents[cell] != cell {
        parents[cell] = parents[parents[cell]];
        cell = parents[cell];
    }
    cell
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
