//! Prescribed loads that friction cannot hold.

use nalgebra::Vector3;

use super::pass::Pass;
use super::{FrictionalError, FrictionalScratch};
use crate::convergence::{Convergence, Products, Residuals, Stop};
use crate::drive::Driven;
use crate::friction::SurfaceFriction;
use crate::state::{CellState, ContactState};
use crate::tangential::displacement;

/// A load counts as below the friction limit only if it is smaller by more than this fraction.
const ROUNDING: f64 = 1e-12;
/// From this fraction of the limit on, loads of coupled bodies are found by iterating on the
/// shifts. There the shifts depend on the loads only through uneven displacements by the pressures.
const NEAR_LIMIT: f64 = 0.99;
/// The bounds of a smaller coefficient of friction are raised at most so many times.
const RAISES: usize = 20;

impl Pass<'_> {
    /// The tractions of rigid sliding, if friction cannot hold the prescribed loads under these
    /// pressures; an error if no other pressures would change that.
    pub(super) fn slide(
        &mut self,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Option<Convergence>, FrictionalError> {
        self.slides = None;
        let loads = Vector3::from(self.rigid.loads.map(Option::unwrap_or_default));
        if loads == Vector3::zeros() {
            return Ok(None);
        }
        let pressed = scratch.limits.friction.iter().zip(to.pressure.values());
        let cells = self.problem.grid().centres().zip(pressed);
        let limits =
            cells.map(|((x, y), (friction, p))| [x, y, if *p > 0.0 { friction * p } else { 0.0 }]);
        scratch.surface.take(limits, &self.rigid.loads);
        let coupled = self.problem.operator().is_coupled();
        if scratch.surface.used_at_most(&loads) >= NEAR_LIMIT {
            let used = scratch.surface.used(&loads);
            if used.part >= 1.0 - ROUNDING {
                let slides = self.beyond(used.part);
                if self.limit_stands(scratch) {
                    return Err(slides);
                }
                self.slides = Some(slides);
                self.follow_sliding(&used.motion, to, scratch);
                let (products, residuals) = (Products::default(), Residuals::default());
                let stop = Stop::Converged;
                return Ok(Some(Convergence { iterations: 0, products, residuals, stop }));
            }
            if coupled && scratch.limits.is_sharp() && used.part >= NEAR_LIMIT {
                scratch.tangential.find_by_motions();
            }
        }
        if !scratch.limits.is_sharp() {
            self.raise_limits(&loads, to, scratch);
        }
        Ok(None)
    }

    /// Raises the bounds of a smaller coefficient of friction until they hold the prescribed loads.
    fn raise_limits(
        &self,
        loads: &Vector3<f64>,
        to: &ContactState,
        scratch: &mut FrictionalScratch,
    ) {
        for _ in 0..RAISES {
            let cells = self.problem.grid().centres().zip(&scratch.limits.values);
            let cells = cells.map(|((x, y), limit)| [x, y, *limit]);
            scratch.surface.take(cells, &self.rigid.loads);
            let part = scratch.surface.used(loads).part;
            if !scratch.limits.hold(to.pressure.values(), part) {
                break;
            }
        }
    }

    /// Whether the friction limit is final: no further pass can change it.
    fn limit_stands(&self, scratch: &FrictionalScratch) -> bool {
        let uniform = matches!(self.problem.friction(), SurfaceFriction::Uniform(own) if own.rest() == own.motion());
        let force_alone = self.rigid.loads[2].is_none();
        let pressed = matches!(self.drive.normal, Driven::Load(_));
        !self.problem.operator().is_coupled()
            || (uniform && force_alone && pressed && scratch.limits.is_sharp())
    }

    /// The error for loads of which friction can hold only this fraction.
    fn beyond(&self, part: f64) -> FrictionalError {
        let area = self.problem.grid().cell_area();
        let [x, y, turning] = self.rigid.loads.map(Option::unwrap_or_default);
        let force = area * x.hypot(y);
        if turning == 0.0 {
            // The limit is known only to this accuracy.
            return FrictionalError::Slides { force, limit: (force / part).min(force) };
        }
        FrictionalError::Turns { torque: area * turning, force, part: (1.0 / part).min(1.0) }
    }

    /// Tractions opposite to a rigid velocity, equal to the friction bounds.
    fn follow_sliding(
        &self,
        motion: &Vector3<f64>,
        to: &mut ContactState,
        scratch: &FrictionalScratch,
    ) {
        let (along, across) = (to.traction_x.values_mut(), to.traction_y.values_mut());
        let cells = along.iter_mut().zip(across).zip(to.cells.values_mut());
        let places = self.problem.grid().centres().zip(&scratch.limits.values);
        for (((t_x, t_y), cell), ((x, y), &limit)) in cells.zip(places) {
            let [u, v] = displacement(motion, x, y);
            let speed = u.hypot(v);
            let part = if speed > 0.0 { limit / speed } else { 0.0 };
            (*t_x, *t_y) = (part * u, part * v);
            *cell = if limit > 0.0 { CellState::Slip } else { CellState::Exterior };
        }
    }
}
