//! Gaps and slips of a task, and its loads.

use std::sync::Arc;

use carom_halfspace::operator::{
    DisplacementField, OperatorError, Preconditioner, SurfaceOperator, TractionField, Workspace,
};
use nalgebra::{Matrix4, Vector4};

use super::task::CoupledTask;
use super::torus::{Space, Torus};
use crate::convergence::Products;
use crate::drive::Driven;
use crate::frictional::coupling::coupling;

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
    /// Influence of a tangential traction on its own cell.
    pub(super) own: f64,
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
        let (grid, own) = (operator.grid(), operator.coefficients(0, 0).rows);
        let zero = vec![0.0; grid.cells()];
        let space = || [zero.clone(), zero.clone(), zero.clone()];
        let (x, y) = grid.centres().unzip();
        Self {
            inverse: operator.inverse(),
            torus: operator.is_reciprocal().then(|| Torus::new(operator)),
            workspace: operator.workspace(),
            centres: [x, y],
            own: 0.5 * (own[0][0] + own[1][1]),
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
        let [dx, dy, turn] = task.rigid.moved;
        for i in 0..task.heights.len() {
            let (x, y) = (self.centres[0][i], self.centres[1][i]);
            self.gap[i] = self.image[2][i] + task.heights[i] - task.approach;
            self.slip[0][i] = self.image[0][i] + task.offset[0][i] - dx - y * turn; // (12.2)
            self.slip[1][i] = self.image[1][i] + task.offset[1][i] - dy + x * turn;
        }
        Ok(())
    }

    /// The loads of tractions divided by the area of a cell, F_z first.
    fn loads(&self, pressure: &[f64], traction: [&[f64]; 2]) -> Vector4<f64> {
        let mut sums = Vector4::zeros();
        for (i, pressure) in pressure.iter().enumerate() {
            let (t_x, t_y) = (traction[0][i], traction[1][i]);
            let torque = self.centres[1][i] * t_x - self.centres[0][i] * t_y;
            sums += Vector4::new(*pressure, t_x, t_y, torque);
        }
        sums
    }

    /// Prescribed loads minus those of the tractions; zero where the shift is prescribed.
    pub(super) fn missing(&self, task: &CoupledTask<'_>) -> Vector4<f64> {
        let given = given(task);
        let now = self.loads(task.pressure, [task.traction[0], task.traction[1]]);
        Vector4::from_fn(|k, _| given[k].map_or(0.0, |load| load - now[k]))
    }

    /// The errors of the loads, as a displacement (normal) and as a traction (tangential).
    pub(super) fn unbalance(&self, task: &CoupledTask<'_>) -> [f64; 2] {
        let missing = self.missing(task);
        let touching = task.pressure.iter().filter(|p| **p > 0.0).count().max(1) as f64;
        let grid = task.operator.grid();
        let arm = 0.5 * (grid.nx() as f64 * grid.dx()).hypot(grid.ny() as f64 * grid.dy());
        let tangential = missing[1].abs().max(missing[2].abs()).max(missing[3].abs() / arm);
        [self.own * missing[0].abs() / touching, tangential / touching]
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
