//! The surfaces after a step: the gap that is left, patches of contact, and how near the pressure is to the solution.

use super::StoredEnergy;
use super::energy::displaced;
use crate::problem::ContactProblem;
use crate::rows::{Row, of_rows};
use crate::state::{CellState, ContactState};
use carom_halfspace::Field;
use carom_halfspace::operator::OperatorError;

/// The distance of the deformed surfaces in each cell, computed anew from the tractions: w1 - w2 plus the undeformed gap,
/// minus the approach; infinite where there is no body. In contact it is what is left of the conditions.
///
/// # Errors
/// [`OperatorError`] if the state is on another grid.
pub fn gap_left(problem: &ContactProblem, state: &ContactState) -> Result<Field, OperatorError> {
    let [.., mut gap] = displaced(problem, state)?;
    let heights = problem.gap().heights().values();
    let zeta = state.shift.zeta;
    gap.values_mut().iter_mut().zip(heights).for_each(|(w, height)| *w += height - zeta);
    Ok(gap)
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
    /// How far the energy less the work of the approach may be above its least value, where a bound is known.
    pub(super) energy_gap_by_approach: Option<f64>,
    /// Elastic energy of both bodies.
    pub(super) stored: f64,
}

impl Surfaces {
    pub(super) fn of(
        problem: &ContactProblem,
        state: &ContactState,
    ) -> Result<Self, OperatorError> {
        let (operator, grid) = (problem.operator(), problem.grid());
        let mut workspace = operator.workspace();
        let (tangential, mut rows) =
            StoredEnergy::tangential_and_rows(problem, state, &mut workspace)?;
        let fields = [state.pressure.values(), problem.gap().heights().values()];
        let rows =
            of_rows(&mut *rows, (grid, fields), &|_| true, &|row| Sums::of(row, state.shift.zeta));
        let sums = rows.iter().fold(Sums::default(), Sums::plus);
        let area = grid.cell_area();
        // Where tractions displace along the normal, the normal energy is not that of the pressure alone.
        let least = operator.least_normal_influence().filter(|_| !operator.is_coupled());
        Ok(Self {
            mean_gap: sums.gap / sums.count,
            patches: patches(&state.cells, !operator.displaces_on_average()),
            energy_gap: area * sums.energy_gap(),
            energy_gap_by_approach: least.map(|least| sums.energy_gap_by_approach(area, least)),
            stored: 0.5 * area * sums.work + tangential,
        })
    }
}

/// Sums over cells.
struct Sums {
    /// Of the finite gaps, and their number.
    gap: f64,
    count: f64,
    least: f64,
    force: f64,
    /// Of pressure times gap, and of pressure times displacement.
    left: f64,
    work: f64,
}

impl Default for Sums {
    fn default() -> Self {
        Self { gap: 0.0, count: 0.0, least: f64::INFINITY, force: 0.0, left: 0.0, work: 0.0 }
    }
}

impl Sums {
    fn of(row: &Row<'_>, approach: f64) -> Self {
        let mut sums = Self::default();
        for ((pressure, gap), w) in row.gaps(approach).zip(row.displacements) {
            if gap.is_finite() {
                (sums.gap, sums.count) = (sums.gap + gap, sums.count + 1.0);
            }
            sums.least = sums.least.min(gap);
            if pressure > 0.0 {
                sums.force += pressure;
                sums.left += pressure * gap;
            }
            if pressure != 0.0 {
                sums.work += pressure * w;
            }
        }
        sums
    }

    fn plus(self, other: &Self) -> Self {
        Self {
            gap: self.gap + other.gap,
            count: self.count + other.count,
            least: self.least.min(other.least),
            force: self.force + other.force,
            left: self.left + other.left,
            work: self.work + other.work,
        }
    }

    /// The gap of Frank and Wolfe. For a given force F the pressure p >= 0 is the one of least energy
    /// J(p) = p.Kp/2 + p.h, whose gradient is the distance g of the surfaces but for a constant. J is convex, so that
    /// J(p) - J(q) <= (p - q).g for every q; the least value of q.g is F times the least g. Hence J is above its least
    /// value by p.g - F min g at most, and |p - p*|^2 = (p - p*).K(p - p*) by twice as much.
    fn energy_gap(&self) -> f64 {
        if self.force > 0.0 { (self.left - self.force * self.least).max(0.0) } else { 0.0 }
    }

    /// The same for a given approach. The pressure q of least energy less the work of the approach,
    /// J(q) = q.Kq/2 + q.(h - zeta), has the gradient g, so that J(p) - J(q) <= p.g - q.g <= p.g + o Q, with the force Q of q
    /// and the greatest overlap o. If the least influence is k, k Q^2 <= q.Kq = -2 J(q). With the stored energy
    /// E = p.g - J(p) and y^2 = -J(q): y^2 <= E + o sqrt(2/k) y.
    fn energy_gap_by_approach(&self, area: f64, least: f64) -> f64 {
        let (overlap, energy) = ((-self.least).max(0.0), 0.5 * area * self.work);
        let by = overlap * libm::sqrt(2.0 * area / least);
        let root = 0.5 * (by + libm::sqrt(by * by + 4.0 * energy));
        (area * self.left + by * root).max(0.0)
    }
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
    use crate::gap::Gap;
    use carom_halfspace::{Grid, Material, MaterialPair};
    use carom_laws::friction::Friction;

    /// One cell of influence k, at an approach z above its height: the pressure z/k has the least energy, and p has
    /// A k (p - z/k)^2/2 more; without pressure the bound is four times that.
    #[test]
    fn the_energy_by_approach_of_one_cell_is_bounded() {
        let grid = Grid::new(1, 1, 0.5, 0.25).unwrap();
        let body = Material::from_shear(1.0, 0.3).unwrap();
        let pair = MaterialPair::new(body, body).unwrap();
        let gap = Gap::from_function(grid, |_, _| 0.0).unwrap();
        let problem = ContactProblem::of_half_spaces(gap, pair, Friction::NONE).unwrap();
        let own = problem.operator().normal_influence_of_a_cell();
        let (zeta, area) = (0.01, grid.cell_area());
        for part in [0.0, 0.3, 0.9, 1.0, 1.4] {
            let pressure = part * zeta / own;
            let mut state = ContactState::apart(grid);
            (state.shift.zeta, state.pressure) = (zeta, Field::uniform(grid, pressure));
            let bound = Surfaces::of(&problem, &state).unwrap().energy_gap_by_approach;
            let above = 0.5 * area * own * (pressure - zeta / own).powi(2);
            let ratio = bound.unwrap() / (0.5 * area * zeta * zeta / own);
            assert!(ratio >= above / (0.5 * area * zeta * zeta / own) - 1e-15, "{part}: {ratio}");
            assert!(part > 0.0 || (ratio - 4.0).abs() < 1e-14, "{ratio}");
            assert!(part != 1.0 || ratio < 1e-12, "{ratio}");
        }
    }

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
