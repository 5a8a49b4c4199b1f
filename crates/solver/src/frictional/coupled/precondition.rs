//! The preconditioner of a Newton step: the inverse on a torus.
//!
//! With the coupling of normal and tangential displacements and the constraints of slipping cells it
//! needs a dense system of two unknowns for each slipping cell, three if the step is damped. Where friction
//! is great, few cells slip, and it leaves some 25 products for a Newton step, where the inverse without coupling needs 200: a
//! slipping cell then closes its gap by the tangential tractions around it. Where too many cells slip, the
//! normal and the tangential inverse are applied separately.

use super::newton::Newton;
use crate::state::CellState;

/// Diagonal term for slipping cells that are treated one by one, relative to the influence of a cell
/// on itself.
const ISOLATED_CELL_COMPLIANCE: f64 = 10.0;

impl Newton<'_> {
    /// Puts unknowns that satisfy these equations approximately into `x`.
    pub(super) fn invert(&mut self, rows: &[f64], x: &mut [f64]) {
        if self.constraints.is_some() {
            self.invert_together(rows, x);
        } else {
            self.invert_separately(rows, x);
        }
    }

    /// The inverse on a torus, with the constraints of slipping cells.
    fn invert_together(&mut self, rows: &[f64], x: &mut [f64]) {
        let (cells, system) = (self.cells, &mut *self.system);
        let (Some(torus), Some(constraints)) = (&mut system.torus, &self.constraints) else {
            return;
        };
        for (rows, &i) in rows.chunks_exact(3).zip(&cells.active) {
            let own = match cells.states[i] {
                CellState::Exterior => [0.0; 3],
                CellState::Stick => [rows[1], rows[2], rows[0]],
                CellState::Slip => [-rows[1] * cells.rim[1][i], rows[1] * cells.rim[0][i], rows[0]],
            };
            for (values, own) in system.traction.iter_mut().zip(own) {
                values[i] = own;
            }
        }
        torus.invert(&system.traction, &mut system.image);
        self.products.preconditioner += 2.0;
        if !constraints.is_empty() {
            constraints.enforce(&system.image, &mut system.traction);
            torus.invert(&system.traction, &mut system.image);
            self.products.preconditioner += 2.0;
        }
        for (x, &i) in x.chunks_exact_mut(3).zip(&cells.active) {
            let [t_x, t_y, p] = [0, 1, 2].map(|k| system.image[k][i]);
            let own = match cells.states[i] {
                CellState::Exterior => [0.0; 3],
                CellState::Stick => [p, t_x, t_y],
                CellState::Slip => {
                    let ([cos, sin], [e_x, e_y]) =
                        (cells.ray[i], [cells.rim[0][i], cells.rim[1][i]]);
                    [cos * p + sin * (e_x * t_x + e_y * t_y), e_x * t_y - e_y * t_x, 0.0]
                }
            };
            x.copy_from_slice(&own);
        }
    }

    /// The normal and the tangential inverse on a torus, applied separately and weighted in slipping
    /// cells.
    fn invert_separately(&mut self, rows: &[f64], x: &mut [f64]) {
        let cells = self.cells;
        let own = cells.own[1];
        let system = &mut *self.system;
        for (rows, &i) in rows.chunks_exact(3).zip(&cells.active) {
            let [gap, a, b] = [rows[0], rows[1], rows[2]];
            let (t_x, t_y) = match cells.states[i] {
                CellState::Slip => {
                    let part = a / (1.0 + cells.bend[i] / own).sqrt();
                    (-part * cells.rim[1][i], part * cells.rim[0][i])
                }
                _ => (a, b),
            };
            system.traction[0][i] = t_x;
            system.traction[1][i] = t_y;
            system.traction[2][i] = gap;
        }
        let [x_out, y_out, p_out] = &mut system.image;
        let [x_in, y_in, p_in] = &system.traction;
        if let Some(inverse) = &system.inverse {
            inverse.pressure(p_in, p_out, &mut system.workspace);
            inverse.traction(
                [Some(x_in), Some(y_in)],
                [Some(x_out), Some(y_out)],
                &mut system.workspace,
            );
            self.products.preconditioner += 2.0;
        } else {
            for (out, values) in [(x_out, x_in), (y_out, y_in), (p_out, p_in)] {
                out.iter_mut().zip(values).for_each(|(out, value)| *out = value / own);
            }
        }
        for ((x, rows), &i) in x.chunks_exact_mut(3).zip(rows.chunks_exact(3)).zip(&cells.active) {
            let (t_x, t_y, p) = (system.image[0][i], system.image[1][i], system.image[2][i]);
            let own = match cells.states[i] {
                CellState::Exterior => [0.0; 3],
                CellState::Stick => [p, t_x, t_y],
                CellState::Slip => {
                    let [cos, sin] = cells.ray[i];
                    let bend = cells.bend[i];
                    let sigma = 1.0 / (1.0 + bend / own);
                    let around = cells.rim[0][i] * t_y - cells.rim[1][i] * t_x;
                    let direct = (1.0 - sigma) / (bend + ISOLATED_CELL_COMPLIANCE * own) * rows[1];
                    [p / cos.hypot(system.coupling * sin), sigma.sqrt() * around + direct, 0.0]
                }
            };
            x.copy_from_slice(&own);
        }
    }
}
