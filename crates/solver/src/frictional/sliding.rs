//! Given loads that friction cannot hold.

use nalgebra::Vector3;

use super::pass::Pass;
use super::{FrictionalError, FrictionalScratch};
use crate::convergence::{Convergence, Products, Residuals, Stop};
use crate::drive::Driven;
use crate::friction::SurfaceFriction;
use crate::state::{CellState, ContactState};

/// Loads that are below the friction limit by less than this part are not below it.
const ROUNDING: f64 = 1e-12;
/// From this part of the limit on, the loads of coupled bodies are found by their motions: elsewhere
/// nothing ties the motions to the loads but displacements that pressures make uneven.
const NEAR: f64 = 0.99;

impl Pass<'_> {
    /// Where friction cannot hold the given loads under these pressures, the tractions of rigid sliding; an
    /// error where other pressures would change nothing.
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
        if scratch.surface.used_at_most(&loads) >= NEAR {
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
            if coupled && scratch.limits.is_sharp() && used.part >= NEAR {
                scratch.tangential.find_by_motions();
            }
        }
        scratch.limits.hold(to.pressure.values(), loads[0].hypot(loads[1]));
        Ok(None)
    }

    /// Whether no pass changes what friction can hold.
    fn limit_stands(&self, scratch: &FrictionalScratch) -> bool {
        let uniform = matches!(self.problem.friction(), SurfaceFriction::Uniform(own) if own.rest() == own.motion());
        let force_alone = self.rigid.loads[2].is_none();
        let pressed = matches!(self.drive.normal, Driven::Load(_));
        !self.problem.operator().is_coupled()
            || (uniform && force_alone && pressed && scratch.limits.is_sharp())
    }

    /// Loads that use this part of what friction can hold.
    fn beyond(&self, part: f64) -> FrictionalError {
        let area = self.problem.grid().cell_area();
        let [x, y, turning] = self.rigid.loads.map(Option::unwrap_or_default);
        let force = area * x.hypot(y);
        if turning == 0.0 {
            // No better known than that.
            return FrictionalError::Slides { force, limit: (force / part).min(force) };
        }
        FrictionalError::Turns { torque: area * turning, force, part: (1.0 / part).min(1.0) }
    }

    /// Tractions in the direction of a rigid velocity, as far as friction goes.
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
            let [u, v] = [motion[0] + y * motion[2], motion[1] - x * motion[2]]; // (12.2)
            let speed = u.hypot(v);
            let part = if speed > 0.0 { limit / speed } else { 0.0 };
            (*t_x, *t_y) = (part * u, part * v);
            *cell = if limit > 0.0 { CellState::Slip } else { CellState::Exterior };
        }
    }
}
