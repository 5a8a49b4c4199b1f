//! Strong coupling: continuation in the friction coefficient, and Newton's method on both problems
//! together.

use super::error::TOGETHER;
use super::pass::Pass;
use super::{FrictionalError, FrictionalScratch};
use crate::convergence::{Convergence, Stop};
use crate::frictional::coupled::{Coupled, CoupledTask, Steps};
use crate::state::ContactState;

/// Passes of the continuation in the friction coefficient. Near a fold, where the solution for a
/// smaller coefficient ceases to exist, the limits may change slowly for some hundred passes before
/// they reach another solution.
const CONTINUATION_PASSES: u32 = 400;
/// Newton's method is tried after the first pass, and again after this many or this fraction of the
/// passes made. It is tried earlier if the limits are off by less than `CLOSE` of the greatest traction
/// and by half of what they were off when it last failed. With damped steps, which take longer, it is tried
/// each time that the number of passes has doubled.
const PASSES_BETWEEN_TRIALS: u32 = 4;
const FRACTION_BETWEEN_TRIALS: f64 = 0.25;
const CLOSE: f64 = 0.05;

impl Pass<'_> {
    /// Passes with a friction coefficient of at most `most` and a cohesion that makes up for the
    /// difference (see [`FrictionLimits`](super::limits::FrictionLimits)). At intervals Newton's
    /// method is tried from there.
    pub(super) fn continue_in_friction(
        &mut self,
        mut most: f64,
        fresh: bool,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        let (least, mut change) = (0.05 * most, 1.0_f64);
        let tolerance = self.method.tolerance;
        scratch.limits.blunt(most);
        let (mut round, mut near, mut full, mut damped) = (0, CLOSE, 1, 1);
        loop {
            let kept = self.keep(to, scratch);
            let inner = (1e-2 * change).clamp(1e-5, 1e-3).max(tolerance);
            let reached =
                match self.alternate_to_convergence(fresh && round == 0, inner, to, scratch) {
                    Err(error) if most > least && error.lets_others_try() => {
                        self.go_back(kept, to, scratch);
                        most *= 0.5;
                        scratch.limits.blunt(most);
                        continue;
                    }
                    done => done?,
                };
            if self.together {
                return Ok(reached);
            }
            round += 1;
            change = scratch.limits.open(to);
            if change < near || round >= full {
                near = near.min(0.5 * change);
                let more = (FRACTION_BETWEEN_TRIALS * f64::from(round)) as u32;
                full = round + more.max(PASSES_BETWEEN_TRIALS);
                if let Some(reached) = self.solve_together(Steps::Full, to, scratch)? {
                    return Ok(reached);
                }
            }
            if round >= damped {
                damped = 2 * round;
                if let Some(reached) = self.solve_together(Steps::Damped, to, scratch)? {
                    return Ok(reached);
                }
            }
            if round == CONTINUATION_PASSES || change.is_nan() {
                let reached = self.so_far(reached.residuals, Stop::Exhausted);
                return Err(FrictionalError::NotConverged { what: TOGETHER, tolerance, reached });
            }
        }
    }

    /// Solves for pressures and tractions together, starting from their present values; `None` if
    /// that does not converge, and they are then unchanged.
    ///
    /// # Errors
    /// [`FrictionalError::NotConverged`] only if the observer ends the iterations.
    pub(super) fn solve_together(
        &mut self,
        steps: Steps,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Option<Convergence>, FrictionalError> {
        let (operator, start) = (self.problem.operator(), to.clone());
        for values in &mut scratch.by_pressure {
            values.fill(0.0);
        }
        self.offsets(scratch);
        let solver = scratch.coupled.get_or_insert_with(|| Box::new(Coupled::new(operator)));
        let [x, y] = &scratch.offset;
        let mut task = CoupledTask {
            operator,
            heights: self.problem.gap().heights().values(),
            friction: &scratch.limits.friction,
            offset: [x, y],
            normal: self.drive.normal,
            approach: to.shift.zeta,
            rigid: self.rigid,
            pressure: to.pressure.values_mut(),
            traction: [to.traction_x.values_mut(), to.traction_y.values_mut()],
            cells: to.cells.values_mut(),
        };
        let tolerance = self.method.tolerance;
        let limits = (tolerance, self.method.iterations);
        let reached = solver.solve(&mut task, steps, limits, self.observer)?;
        if reached.stop == Stop::Converged {
            (to.shift.zeta, self.rigid) = (task.approach, task.rigid);
            self.together = true;
            return Ok(Some(self.count(reached)));
        }
        *to = start;
        let reached = self.count(reached);
        if reached.stop == Stop::Observer {
            return Err(FrictionalError::NotConverged { what: TOGETHER, tolerance, reached });
        }
        Ok(None)
    }
}
