//! Strong coupling: a cone of friction that opens, and Newton's method on both problems together.

use super::pass::Pass;
use super::{FrictionalError, FrictionalScratch};
use crate::convergence::{Convergence, Stop};
use crate::frictional::coupled::{Coupled, CoupledTask};
use crate::state::ContactState;

/// Rounds of a cone that opens. Where the solution of a blunter cone has just ended, limits creep
/// past the place for some hundred rounds before they go on to another solution.
const ROUNDS: usize = 400;
/// How many rounds lie between trials of Newton's method, unless limits are off by less than this
/// part of the greatest traction and by half of what they were when it last failed.
const ROUNDS_A_TRIAL: usize = 4;
const CLOSE: f64 = 0.05;

impl Pass<'_> {
    /// Rounds with a blunter cone, no greater a coefficient than `most`, beside cohesion that follows;
    /// now and then Newton's method is tried from there.
    pub(super) fn open_the_cone(
        &mut self,
        mut most: f64,
        fresh: bool,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        let (least, mut change) = (0.05 * most, 1.0_f64);
        let (what, tolerance) = ("pressures and tractions together", self.method.tolerance);
        scratch.limits.blunt(most);
        let (mut round, mut near) = (0, CLOSE);
        loop {
            let kept = self.keep(to, scratch);
            let inner = (1e-2 * change).clamp(1e-5, 1e-3).max(tolerance);
            let reached =
                match self.alternate_to_convergence(fresh && round == 0, inner, to, scratch) {
                    Err(FrictionalError::NotConverged { .. }) if most > least => {
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
            if change < near || round % ROUNDS_A_TRIAL == 0 {
                near = near.min(0.5 * change);
                let kept = self.keep(to, scratch);
                if let Some(reached) = self.solve_together(to, scratch)? {
                    return Ok(reached);
                }
                self.go_back(kept, to, scratch);
            }
            if round == ROUNDS || change.is_nan() {
                let (products, stop) = (self.spent, Stop::Exhausted);
                let reached = Convergence { products, stop, ..reached };
                return Err(FrictionalError::NotConverged { what, tolerance, reached });
            }
        }
    }

    /// Pressures and tractions by one system, from what they are; none if that does not converge,
    /// and they are as they were.
    pub(super) fn solve_together(
        &mut self,
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
        let (tolerance, most) = (self.method.tolerance, self.method.iterations);
        let reached = solver.solve(&mut task, tolerance, most, self.observer)?;
        self.spent = self.spent.plus(reached.products);
        if reached.stop == Stop::Converged {
            (to.shift.zeta, self.rigid) = (task.approach, task.rigid);
            self.together = true;
            return Ok(Some(Convergence { products: self.spent, ..reached }));
        }
        *to = start;
        Ok(None)
    }
}
