//! Gaps and slips of a task, and its loads.

use std::sync::Arc;

use carom_halfspace::operator::{
    DisplacementField, OperatorError, Preconditioner, SurfaceOperator, TractionField, Workspace,
};
use nalgebra::{Matrix4, Vector3, Vector4};

use super::task::CoupledTask;
use super::torus::{Space, Torus};
use crate::convergence::Products;
use crate::drive::Driven;
use crate::frictional::coupling::coupling;
use crate::tangential::displacement;

/// Motions: approach, two shifts, twist.
pub(super) const MOTIONS: usize = 4;

/// Gaps and slips, with the working memory of the linear system.
#[derive(Clone)]
pub(super) struct System {
    pub(super) inverse: Option<Arc<dyn Preconditioner>>,
    /// The inverse with coupling; none where displacements are not reciprocal.
    pub(super) torus: Option<Torus>,
    pub(super) workspace: Workspace,
    pub(super) centres: [Vec<f64>; 2],
    /// Coupling of tangential tractions and normal displacements.
    pub(super) coupling: f64,
    pub(super) gap: Vec<f64>,
    pub(super) slip: [Vec<f64>; 2],
    pub(super) traction: Space,
    pub(super) image: Space,
    /// The preconditioner applied to each unit motion, and the loads of the result.
    pub(super) corrections: Vec<Vec<f64>>,
    pub(super) answers: Matrix4<f64>,
}

impl System {
    pub(super) fn new(operator: &dyn SurfaceOperator) -> Self {
        let grid = operator.grid();
        let zero = vec![0.0; grid.cells()];
        let space = || [zero.clone(), zero.clone(), zero.clone()];
        let (x, y) = grid.centres().unzip();
        Self {
            inverse: operator.inverse(),
            torus: operator.is_reciprocal().then(|| Torus::new(operator)),
            workspace: operator.workspace(),
            centres: [x, y],
            coupling: coupling(operator),
            gap: zero.clone(),
            slip: [zero.clone(), zero.clone()],
            traction: space(),
            image: space(),
            corrections: Vec::new(),
            answers: Matrix4::identity(),
        }
    }

    /// Empties the tractions of all cells for a linear system.
    pub(super) fn clear(&mut self) {
        for values in &mut self.traction {
            values.fill(0.0);
        }
    }

    /// The slip of a cell.
    pub(super) fn slip(&self, i: usize) -> [f64; 2] {
        [self.slip[0][i], self.slip[1][i]]
    }

    /// Computes gaps and slips from the tractions of a task.
    pub(super) fn displace(
        &mut self,
        task: &CoupledTask<'_>,
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        let tractions = TractionField::full(task.traction[0], task.traction[1], task.pressure);
        let [u, v, w] = &mut self.image;
        let displacements = DisplacementField::full(u, v, w);
        task.operator.apply(tractions, displacements, &mut self.workspace)?;
        count(products);
        let moved = Vector3::from(task.rigid.moved);
        for i in 0..task.heights.len() {
            let rigid = displacement(&moved, self.centres[0][i], self.centres[1][i]);
            self.gap[i] = self.image[2][i] + task.heights[i] - task.approach;
            for (axis, rigid) in rigid.into_iter().enumerate() {
                self.slip[axis][i] = self.image[axis][i] + task.offset[axis][i] - rigid;
            }
        }
        Ok(())
    }

    /// The loads of a cell from its tractions x, y and pressure, divided by its area, F_z first.
    pub(super) fn loads_of(&self, i: usize, [t_x, t_y, p]: [f64; 3]) -> Vector4<f64> {
        let torque = self.centres[1][i] * t_x - self.centres[0][i] * t_y;
        Vector4::new(p, t_x, t_y, torque)
    }

    /// Prescribed loads minus those of the tractions; zero where the shift is prescribed.
    pub(super) fn missing(&self, task: &CoupledTask<'_>) -> Vector4<f64> {
        let given = given(task);
        let [x, y] = [&task.traction[0], &task.traction[1]];
        let cells = 0..task.pressure.len();
        let now: Vector4<f64> =
            cells.map(|i| self.loads_of(i, [x[i], y[i], task.pressure[i]])).sum();
        Vector4::from_fn(|k, _| given[k].map_or(0.0, |load| load - now[k]))
    }
}

pub(super) fn count(products: &mut Products) {
    products.normal += 1.0;
    products.tangential += 1.0;
    products.coupling += 2.0;
}

/// Prescribed loads divided by the area of a cell.
pub(super) fn given(task: &CoupledTask<'_>) -> [Option<f64>; MOTIONS] {
    let normal = match task.normal {
        Driven::Shift(_) => None,
        Driven::Load(force) => Some(force / task.operator.grid().cell_area()),
    };
    let [x, y, twist] = task.rigid.loads;
    [normal, x, y, twist]
}
