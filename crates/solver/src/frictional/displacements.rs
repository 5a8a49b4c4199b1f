//! Displacements due to tractions and rigid shifts, before and after a step.

use carom_halfspace::operator::{DisplacementField, TractionField};
use carom_laws::law::Shift;
use nalgebra::Vector3;

use super::pass::Pass;
use super::{FrictionalError, FrictionalScratch};
use crate::state::{CellState, ContactState};
use crate::tangential::displacement;

impl Pass<'_> {
    /// The offset c: displacements due to the pressure, minus those before the step and the rigid
    /// shift of the step.
    pub(super) fn offsets(&self, scratch: &mut FrictionalScratch) {
        let moved = Vector3::from(self.moved());
        let grid = self.problem.grid();
        let before = [self.from.displacement_x.values(), self.from.displacement_y.values()];
        for row in 0..grid.ny() {
            let (cells, y) = (grid.index(0, row)..grid.index(0, row + 1), grid.centred_y(row));
            let [along, across] = &mut scratch.offset;
            let (along, across) = (&mut along[cells.clone()], &mut across[cells.clone()]);
            let before = before.map(|values| &values[cells.clone()]);
            for (column, (u, v)) in along.iter_mut().zip(across.iter_mut()).enumerate() {
                let rigid = displacement(&moved, grid.centred_x(column), y);
                *u = -before[0][column] - rigid[0];
                *v = -before[1][column] - rigid[1];
            }
            if self.problem.operator().is_coupled() {
                for (own, pressed) in [along, across].into_iter().zip(&scratch.by_pressure) {
                    let pressed = &pressed[cells.clone()];
                    own.iter_mut().zip(pressed).for_each(|(own, pressed)| *own += pressed);
                }
            }
        }
    }

    /// The prescribed rigid shifts and twist of the step; zero where the load is prescribed.
    pub(super) fn moved(&self) -> [f64; 3] {
        let (now, before) = (self.drive.shift_after(self.from.shift), self.from.shift);
        [now.xi - before.xi, now.eta - before.eta, now.omega - before.omega]
    }

    /// The change of the normal displacement due to tangential tractions since the last normal
    /// solve, relative to the approach.
    pub(super) fn change(
        &mut self,
        to: &ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<f64, FrictionalError> {
        std::mem::swap(&mut scratch.by_traction, &mut scratch.last);
        self.displace_by_traction(to, scratch)?;
        let heights = self.problem.gap().heights().values();
        let (mut moved, mut scale) = (0.0_f64, 0.0_f64);
        for (i, pressure) in to.pressure.values().iter().enumerate().filter(|(_, p)| **p > 0.0) {
            let change = (scratch.by_traction[i] - scratch.last[i]).abs();
            if change.is_nan() || pressure.is_nan() {
                return Ok(f64::NAN);
            }
            moved = moved.max(change);
            scale = scale.max((to.shift.zeta - heights[i]).abs());
        }
        Ok(if scale > 0.0 { moved / scale } else { moved })
    }

    pub(super) fn displace_by_traction(
        &mut self,
        to: &ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<(), FrictionalError> {
        let load = TractionField::tangential(to.traction_x.values(), to.traction_y.values());
        let displacement = DisplacementField::normal(&mut scratch.by_traction);
        self.problem.operator().apply(load, displacement, scratch.normal.workspace())?;
        self.cost.coupling += 1.0;
        Ok(())
    }

    /// Writes shifts and the displacements of all cells. Cells in contact without friction are
    /// marked as slipping.
    pub(super) fn finish(
        &mut self,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<(), FrictionalError> {
        let given = self.drive.shift_after(self.from.shift);
        let [dx, dy, turn] = self.rigid.moved;
        to.shift = Shift {
            zeta: to.shift.zeta,
            xi: given.xi + dx,
            eta: given.eta + dy,
            omega: given.omega + turn,
        };
        let tangential = TractionField::tangential(to.traction_x.values(), to.traction_y.values());
        let normal = self.problem.operator().is_coupled().then(|| to.pressure.values());
        let load = TractionField { normal, ..tangential };
        let (u, v) = (to.displacement_x.values_mut(), to.displacement_y.values_mut());
        let displacement = DisplacementField::tangential(u, v);
        self.problem.operator().apply(load, displacement, scratch.normal.workspace())?;
        self.cost.tangential += 1.0;
        if normal.is_some() {
            self.cost.coupling += 1.0;
        }
        for ((cell, pressure), friction) in
            to.cells.values_mut().iter_mut().zip(to.pressure.values()).zip(&scratch.limits.friction)
        {
            if *pressure > 0.0 && *friction == 0.0 {
                *cell = CellState::Slip;
            }
        }
        Ok(())
    }
}
