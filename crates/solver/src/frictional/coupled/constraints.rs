//! What slipping cells change of the inverse on the torus.
//!
//! On the torus all tractions follow from all displacements. In a slipping cell one traction is
//! bound to the others instead: the traction lies on its ray, and around the ray it falls with the
//! slip. The displacements that enforce this are found from a small dense system.

use carom_dense::{Factors, Mat};
use nalgebra::Vector3;

use super::cells::Cells;
use super::torus::{Space, Torus};
use crate::state::CellState;

/// The greatest number of constraints. Their matrix takes 32 MB, its factors as much again each.
const MOST: usize = 2000;

/// A condition on the tractions of a cell, and the displacement that enforces it.
#[derive(Clone, Copy)]
struct Constraint {
    cell: usize,
    traction: Vector3<f64>,
    displacement: Vector3<f64>,
    /// Amount of the displacement in its own condition.
    own: f64,
}

/// All constraints, with their dense system.
#[derive(Clone)]
pub(super) struct Constraints {
    all: Vec<Constraint>,
    system: Option<Factors>,
}

impl Constraints {
    /// `None` if there are too many.
    pub(super) fn new(cells: &Cells, torus: &Torus) -> Option<Self> {
        let slips = |cell: &&usize| cells.states[**cell] == CellState::Slip;
        let slipping = cells.active.iter().filter(slips);
        let all: Vec<_> = slipping.flat_map(|cell| of_cell(cells, *cell)).collect();
        if all.len() > MOST {
            return None;
        }
        let system = (!all.is_empty()).then(|| Factors::new(&matrix(&all, torus)));
        Some(Self { all, system })
    }

    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Adds to the displacements what makes the tractions, which they have without that, meet the
    /// constraints.
    pub(super) fn enforce(&self, traction: &Space, displacement: &mut Space) {
        let Some(system) = &self.system else { return };
        let amount = |constraint: &Constraint| {
            let at = Vector3::from_fn(|k, _| traction[k][constraint.cell]);
            -constraint.traction.dot(&at)
        };
        let amounts = system.solve(&self.all.iter().map(amount).collect::<Vec<_>>());
        for (constraint, amount) in self.all.iter().zip(amounts) {
            for (k, values) in displacement.iter_mut().enumerate() {
                values[constraint.cell] += amount * constraint.displacement[k];
            }
        }
    }
}

/// By how much each constraint, in rows, is met by the displacement of each, in columns.
fn matrix(all: &[Constraint], torus: &Torus) -> Mat<f64> {
    let places: Vec<_> = all.iter().map(|constraint| torus.place(constraint.cell)).collect();
    // The constraints of a cell follow each other: they share the tractions on it.
    let (mut last, mut tractions) = ([usize::MAX; 2], Vector3::zeros());
    Mat::from_fn(all.len(), all.len(), |row, column| {
        let (to, from) = (&all[row], &all[column]);
        if last != [to.cell, column] {
            last = [to.cell, column];
            tractions = torus.answer(places[row], places[column]) * from.displacement;
        }
        let own = if row == column { to.own } else { 0.0 };
        own + to.traction.dot(&tractions)
    })
}

/// The constraints of a slipping cell: on its ray, around it, and along it if that is damped.
fn of_cell(cells: &Cells, cell: usize) -> impl Iterator<Item = Constraint> + use<> {
    let ([cos, sin], [x, y]) = (cells.ray[cell], cells.rim.each_ref().map(|rim| rim[cell]));
    let (along, around, normal) =
        (Vector3::new(x, y, 0.0), Vector3::new(-y, x, 0.0), Vector3::new(0.0, 0.0, 1.0));
    let damping = cells.damping * cells.own[0];
    let traction = cos * along - sin * normal;
    let on_ray = Constraint { cell, traction, displacement: along, own: 0.0 };
    let traction = cells.bend[cell] * around;
    let turned = Constraint { cell, traction, displacement: around, own: 1.0 };
    let traction = damping * (sin * along + cos * normal);
    let damped = Constraint { cell, traction, displacement: normal, own: 1.0 };
    [on_ray, turned].into_iter().chain((damping > 0.0).then_some(damped))
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_halfspace::operator::{HalfSpaceOperator, SurfaceOperator as _};
    use carom_halfspace::{Grid, Material, MaterialPair};

    const SLIPPING: [usize; 4] = [3, 7, 8, 17];

    /// All cells stick, but for a few that slip in various directions at various stiffnesses.
    fn cells(operator: &HalfSpaceOperator, slipping: &[usize], damping: f64) -> Cells {
        let mut cells = Cells::new(operator);
        cells.damping = damping;
        cells.active = (0..operator.grid().cells()).collect();
        cells.states.fill(CellState::Stick);
        for (number, &at) in slipping.iter().enumerate() {
            let angle = 0.7 + 1.9 * number as f64;
            cells.states[at] = CellState::Slip;
            (cells.rim[0][at], cells.rim[1][at]) = (angle.cos(), angle.sin());
            cells.bend[at] = [0.0, 0.3, 2.0, 1e6][number] * cells.own[1];
            cells.ray[at] = [[0.9_f64, 0.5, 0.1, 1e-9][number]; 2];
            cells.ray[at][1] = (1.0 - cells.ray[at][0].powi(2)).sqrt();
        }
        cells
    }

    /// The equations of slipping cells, one by one; those that stick keep their displacements.
    #[test]
    fn slipping_cells_have_their_tractions_on_the_ray() {
        let pair =
            MaterialPair::new(Material::from_shear(2.0, 0.1).unwrap(), Material::RIGID).unwrap();
        let operator = HalfSpaceOperator::new(pair, Grid::new(5, 4, 0.3, 0.2).unwrap()).unwrap();
        let (mut torus, n) = (Torus::new(&operator), operator.grid().cells());
        let wave = |k: f64| (0..n).map(|i| (k * (i * i + 1) as f64).sin()).collect::<Vec<_>>();
        // A cell alone is its own neighbour in the dense system.
        let sets: [&[usize]; 2] = [&SLIPPING, &SLIPPING[..1]];
        for (slipping, damping) in sets.into_iter().flat_map(|set| [(set, 0.0), (set, 0.4)]) {
            let cells = cells(&operator, slipping, damping);
            let given: Space = [wave(0.3), wave(0.7), wave(1.1)];
            let (mut moved, mut traction) = (given.clone(), given.clone());
            torus.invert(&given, &mut traction);
            Constraints::new(&cells, &torus).unwrap().enforce(&traction, &mut moved);
            torus.invert(&moved, &mut traction);
            let at = |field: &Space, i: usize| [0, 1, 2].map(|k| field[k][i]);
            for i in 0..n {
                let ([u, v, w], given) = (at(&moved, i), at(&given, i));
                if !slipping.contains(&i) {
                    assert_eq!([u, v, w], given);
                    continue;
                }
                let ([cos, sin], [t_x, t_y, p]) = (cells.ray[i], at(&traction, i));
                let [x, y] = [cells.rim[0][i], cells.rim[1][i]];
                let (along, around) = (x * t_x + y * t_y, x * t_y - y * t_x);
                let scale = t_x.abs() + t_y.abs() + p.abs();
                assert!((cos * along - sin * p).abs() < 1e-10 * scale, "{i}: off the ray");
                let turned = (x * v - y * u) + cells.bend[i] * around;
                let wanted = x * given[1] - y * given[0];
                // A stiff cell multiplies the rounding of its traction.
                let rounding = 1e-12 * (1.0 + cells.bend[i] * scale);
                assert!((turned - wanted).abs() < rounding, "{i}: {turned} {wanted}");
                let length = cos * p + sin * along;
                let gap = w + damping * cells.own[0] * length;
                assert!((gap - given[2]).abs() < 1e-10, "{i}: {gap} {}", given[2]);
            }
        }
    }
}
