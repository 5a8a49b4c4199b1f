//! The linear system of a Newton step.
//!
//! Unknowns of a cell: pressure and both tractions if it sticks; the length along its ray and the
//! traction around the ray if it slips. Further unknowns are the motions whose loads are
//! prescribed. Equations of a cell: the gap and the slip, or the component of the slip around the
//! ray.

use carom_halfspace::operator::{DisplacementField, OperatorError, SurfaceOperator, TractionField};
use nalgebra::{Matrix4, Vector4};

use super::cells::Cells;
use super::constraints::Constraints;
use super::system::{MOTIONS, System, count, given};
use super::task::CoupledTask;
use crate::convergence::Products;
use crate::krylov::{self, LinearMap};
use crate::state::CellState;
use crate::tangential::{displacement, half_diagonal};

/// Relative residual to which each linear system is solved.
const LINEAR_RESIDUAL: f64 = 1e-4;
/// The same of a step whose damping exceeds `WELL_DAMPED`: it leaves a greater part of the violation anyway.
const DAMPED_LINEAR_RESIDUAL: f64 = 1e-3;
const WELL_DAMPED: f64 = 1e-3;
/// Motions that make less than this fraction of the greatest load are left out of the preconditioner.
const LEAST_LOAD: f64 = 1e-8;
/// Greatest number of products for one linear system.
const MOST_PRODUCTS: usize = 240;

impl System {
    /// Makes one Newton step for the given states of the cells.
    pub(super) fn newton_step(
        &mut self,
        task: &mut CoupledTask<'_>,
        cells: &Cells,
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        let n = cells.active.len();
        let mut right = vec![0.0; 3 * n + MOTIONS];
        for (right, &i) in right.chunks_exact_mut(3).zip(&cells.active) {
            let rows = equations(cells, i, self.gap[i], self.slip(i), 0.0);
            right.copy_from_slice(&rows.map(|row| -row));
        }
        let missing = self.missing(task);
        self.clear();
        let constraints = self.torus.as_ref().and_then(|torus| Constraints::new(cells, torus));
        let (operator, given) = (task.operator, given(task));
        let mut map = Newton { system: self, operator, cells, constraints, given, products };
        map.prepare();
        for k in 0..MOTIONS {
            right[3 * n + k] = map.weight(k) * missing[k];
        }
        let mut step = vec![0.0; 3 * n + MOTIONS];
        let least = linear_residual(cells.damping) * krylov::norm(&right);
        krylov::solve(&mut map, &right, &mut step, least, MOST_PRODUCTS)?;
        for (step, &i) in step.chunks_exact(3).zip(&cells.active) {
            let [t_x, t_y, p] = unknowns(cells, i, step);
            task.pressure[i] += p;
            task.traction[0][i] += t_x;
            task.traction[1][i] += t_y;
        }
        task.approach += step[3 * n];
        for k in 0..3 {
            task.rigid.moved[k] += step[3 * n + 1 + k];
        }
        Ok(())
    }
}

/// The relative residual to which the linear system of a step with this damping is solved.
fn linear_residual(damping: f64) -> f64 {
    if damping > WELL_DAMPED { DAMPED_LINEAR_RESIDUAL } else { LINEAR_RESIDUAL }
}

/// The equations of a cell from its gap and slip; `turned` is its traction around the ray.
fn equations(cells: &Cells, i: usize, gap: f64, slip: [f64; 2], turned: f64) -> [f64; 3] {
    match cells.states[i] {
        CellState::Exterior => [0.0; 3],
        CellState::Stick => [gap, slip[0], slip[1]],
        CellState::Slip => {
            let around = cells.rim[0][i] * slip[1] - cells.rim[1][i] * slip[0];
            [gap, around + cells.bend[i] * turned, 0.0]
        }
    }
}

/// Tractions x, y and pressure from the unknowns of a cell.
fn unknowns(cells: &Cells, i: usize, own: &[f64]) -> [f64; 3] {
    match cells.states[i] {
        CellState::Exterior => [0.0; 3],
        CellState::Stick => [own[1], own[2], own[0]],
        CellState::Slip => {
            let ([cos, sin], e) = (cells.ray[i], [cells.rim[0][i], cells.rim[1][i]]);
            let (along, around) = (sin * own[0], own[1]);
            [along * e[0] - around * e[1], along * e[1] + around * e[0], cos * own[0]]
        }
    }
}

/// The motions that make a load, from the loads that each motion makes. A motion that hardly makes a load,
/// as that along which all cells slip, remains zero. Torques and twists count by this arm.
fn motions_of(loads: &Matrix4<f64>, arm: f64) -> Matrix4<f64> {
    let scale = Matrix4::from_diagonal(&Vector4::new(1.0, 1.0, 1.0, 1.0 / arm));
    let scaled = scale * loads * scale;
    if !scaled.iter().all(|load| load.is_finite()) {
        return Matrix4::zeros();
    }
    let motions = scaled.pseudo_inverse(LEAST_LOAD * scaled.norm());
    motions.map_or_else(|_| Matrix4::zeros(), |motions| scale * motions * scale)
}

/// The linear system for given states of the cells.
pub(super) struct Newton<'a> {
    pub(super) system: &'a mut System,
    operator: &'a dyn SurfaceOperator,
    pub(super) cells: &'a Cells,
    pub(super) constraints: Option<Constraints>,
    given: [Option<f64>; MOTIONS],
    pub(super) products: &'a mut Products,
}

impl Newton<'_> {
    /// The factor that turns a load equation into a displacement.
    fn weight(&self, motion: usize) -> f64 {
        let over = if motion == 3 { half_diagonal(self.operator.grid()) } else { 1.0 };
        self.cells.own[1] / (self.cells.active.len().max(1) as f64).sqrt() / over
    }

    /// The equations of a cell in a unit motion.
    fn motion_rows(&self, i: usize, motion: &Vector4<f64>) -> [f64; 3] {
        let [x, y] = [0, 1].map(|axis| self.system.centres[axis][i]);
        let slip = displacement(&motion.fixed_rows::<3>(1).into(), x, y).map(|moved| -moved);
        equations(self.cells, i, -motion[0], slip, 0.0)
    }

    /// The loads that the preconditioner gives for each unit motion.
    fn prepare(&mut self) {
        let n = self.cells.active.len();
        self.system.corrections.clear();
        let mut answers = Matrix4::zeros();
        for k in 0..MOTIONS {
            let mut correction = vec![0.0; 3 * n];
            if self.given[k].is_some() {
                let unit = Vector4::from_fn(|l, _| f64::from(u8::from(l == k)));
                let mut rows = vec![0.0; 3 * n];
                for (rows, &i) in rows.chunks_exact_mut(3).zip(&self.cells.active) {
                    rows.copy_from_slice(&self.motion_rows(i, &unit).map(|row| -row));
                }
                self.invert(&rows, &mut correction);
                let loads = self.loads_of(&correction);
                for l in (0..MOTIONS).filter(|&l| self.given[l].is_some()) {
                    answers[(l, k)] = loads[l];
                }
            }
            self.system.corrections.push(correction);
        }
        self.system.answers = motions_of(&answers, half_diagonal(self.operator.grid()));
    }

    fn loads_of(&self, x: &[f64]) -> Vector4<f64> {
        let cells = x.chunks_exact(3).zip(&self.cells.active);
        cells.map(|(x, &i)| self.system.loads_of(i, unknowns(self.cells, i, x))).sum()
    }
}

impl LinearMap for Newton<'_> {
    type Error = OperatorError;

    fn apply(&mut self, x: &[f64], y: &mut [f64]) -> Result<(), OperatorError> {
        let n = self.cells.active.len();
        let system = &mut *self.system;
        for (x, &i) in x.chunks_exact(3).zip(&self.cells.active) {
            let own = unknowns(self.cells, i, x);
            for (k, value) in own.into_iter().enumerate() {
                system.traction[k][i] = value;
            }
        }
        let [t_x, t_y, p] = &system.traction;
        let [u, v, w] = &mut system.image;
        let displacements = DisplacementField::full(u, v, w);
        self.operator.apply(
            TractionField::full(t_x, t_y, p),
            displacements,
            &mut system.workspace,
        )?;
        count(self.products);
        let motion =
            Vector4::from_fn(|k, _| if self.given[k].is_some() { x[3 * n + k] } else { 0.0 });
        for ((y, x), &i) in y.chunks_exact_mut(3).zip(x.chunks_exact(3)).zip(&self.cells.active) {
            let [u, v, w] = [0, 1, 2].map(|k| self.system.image[k][i]);
            let slips = self.cells.states[i] == CellState::Slip;
            let (turned, along) = if slips { (x[1], x[0]) } else { (0.0, 0.0) };
            let damped = self.cells.damping * self.cells.own[0] * along;
            let own = equations(self.cells, i, w + damped, [u, v], turned);
            let rigid = self.motion_rows(i, &motion);
            for k in 0..3 {
                y[k] = own[k] + rigid[k];
            }
        }
        let loads = self.loads_of(x);
        for k in 0..MOTIONS {
            y[3 * n + k] =
                if self.given[k].is_some() { self.weight(k) * loads[k] } else { x[3 * n + k] };
        }
        Ok(())
    }

    fn precondition(&mut self, y: &[f64], x: &mut [f64]) {
        let n = self.cells.active.len();
        self.invert(&y[..3 * n], &mut x[..3 * n]);
        x[3 * n..].fill(0.0);
        let loads = self.loads_of(x);
        let wrong = Vector4::from_fn(|k, _| {
            if self.given[k].is_some() { y[3 * n + k] / self.weight(k) - loads[k] } else { 0.0 }
        });
        let motion = self.system.answers * wrong;
        for k in (0..MOTIONS).filter(|&k| self.given[k].is_some()) {
            x[3 * n + k] = motion[k];
            let corrections = &self.system.corrections[k];
            x[..3 * n].iter_mut().zip(corrections).for_each(|(x, own)| *x += motion[k] * own);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The approach, the shift along y and the twist keep their motions if no load changes along x.
    #[test]
    fn a_motion_without_load_leaves_the_others() {
        let arm = 20.0;
        let loads = Matrix4::new(
            2.0, 0.0, 0.3, 1.0, //
            1.5, 0.0, 0.1, 0.0, //
            0.2, 0.0, 3.0, 4.0, //
            9.0, 0.0, 2.0, 700.0,
        );
        let motion = Vector4::new(0.7, 0.0, -0.4, 0.05);
        let back = motions_of(&loads, arm) * (loads * motion);
        assert!((back - motion).norm() < 1e-10, "{back}");
        let without = Matrix4::from_diagonal(&Vector4::new(4.0, 0.0, 5.0, 0.0));
        let wanted = Matrix4::from_diagonal(&Vector4::new(0.25, 0.0, 0.2, 0.0));
        assert!((motions_of(&without, arm) - wanted).norm() < 1e-12);
        let unknown = Matrix4::from_element(f64::NAN);
        assert_eq!(motions_of(&unknown, arm), Matrix4::zeros());
    }
}
