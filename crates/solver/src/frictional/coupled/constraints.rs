//! What slipping cells change of the inverse on the torus.
//!
//! On the torus all tractions follow from all displacements. In a slipping cell one traction is
//! bound to the others instead: the traction lies on its ray, and around the ray it falls with the
//! slip. The displacements that enforce this are found from a small dense system.

use faer::linalg::solvers::{PartialPivLu, Solve as _};
use faer::{Col, Mat};
use nalgebra::Vector3;

use super::cells::Cells;
use super::torus::{Space, Torus};
use crate::state::CellState;

/// The greatest number of constraints, whose matrix takes 32 MB.
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
    system: Option<PartialPivLu<f64>>,
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
        let entry = |row: usize, column: usize| {
            let (to, from): (&Constraint, &Constraint) = (&all[row], &all[column]);
            let own = if row == column { to.own } else { 0.0 };
            own + to.traction.dot(&(torus.answer(to.cell, from.cell) * from.displacement))
        };
        let system =
            (!all.is_empty()).then(|| Mat::from_fn(all.len(), all.len(), entry).partial_piv_lu());
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
        let amounts = system.solve(&Col::from_fn(self.all.len(), |row| amount(&self.all[row])));
        for (constraint, amount) in self.all.iter().zip(amounts.iter()) {
            for (k, values) in displacement.iter_mut().enumerate() {
                values[constraint.cell] += amount * constraint.displacement[k];
            }
        }
    }
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
