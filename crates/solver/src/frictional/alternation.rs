//! Panagiotopoulos' alternation: pressures at the last tractions, then tractions at these
//! pressures.

use carom_halfspace::operator::{DisplacementField, TractionField};

use super::coupled::Steps;
use super::error::{TOGETHER, converged};
use super::pass::Pass;
use super::{FrictionalError, FrictionalScratch};
use crate::convergence::{Convergence, Residuals, Stop};
use crate::normal::Target;
use crate::problem::PeriodError;
use crate::state::ContactState;
use crate::tangential::{TangentialTask, half_diagonal};

/// The alternation has stalled if the least change has not been halved within this many passes.
const PASSES_WITHOUT_PROGRESS: usize = 40;
/// Newton's method on both problems together is tried after this many passes.
const PASSES_BEFORE_NEWTON: usize = 35;
/// A shift is small if it is at most this share of the approach, times the greatest limit over the greatest pressure.
const SMALL_SHIFT: f64 = 0.05;
/// Passes are accelerated by Anderson mixing once the change exceeds this fraction of the previous
/// one.
const SLOW_CONVERGENCE_RATE: f64 = 0.25;

impl Pass<'_> {
    pub(super) fn alternate_to_convergence(
        &mut self,
        fresh: bool,
        tolerance: f64,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        let coupled = self.problem.operator().is_coupled();
        let mut inner = if coupled { 1e-3_f64.max(0.3 * tolerance) } else { tolerance };
        let (mut last_change, mut mixes) = (f64::INFINITY, false);
        let mut least = (0, f64::INFINITY);
        scratch.mixing.clear();
        let mut pass = 0;
        loop {
            pass += 1;
            let first = fresh && pass == 1;
            let normal_part = self.solve_normal(inner, first, to, scratch)?;
            let tangential_part = self.solve_tangential(inner, first, to, scratch)?;
            let change = if coupled { self.change(to, scratch)? } else { 0.0 };
            let residuals = Residuals {
                normal: normal_part.residuals.normal.max(change),
                tangential: tangential_part.residuals.tangential,
            };
            if change <= tolerance && inner <= tolerance {
                if let Some(slides) = self.slides.take() {
                    return Err(slides);
                }
                return Ok(self.so_far(residuals, Stop::Converged));
            }
            if change < 0.5 * least.1 {
                least = (pass, change);
            }
            let stalls = !change.is_finite() || pass > least.0 + PASSES_WITHOUT_PROGRESS;
            if stalls || pass >= self.method.passes {
                let stop = if stalls { Stop::Stalled } else { Stop::Exhausted };
                let reached = self.so_far(residuals, stop);
                return Err(FrictionalError::NotConverged { what: TOGETHER, tolerance, reached });
            }
            if pass == PASSES_BEFORE_NEWTON
                && self.slides.is_none()
                && let Some(reached) = self.solve_together(Steps::Full, to, scratch)?
            {
                return Ok(reached);
            }
            mixes |= pass > 1 && change > SLOW_CONVERGENCE_RATE * last_change;
            last_change = change;
            if mixes {
                scratch.mixing.mix(&scratch.last, &mut scratch.by_traction);
            }
            inner = (0.1 * change).clamp(0.3 * tolerance, 1e-3_f64.max(0.3 * tolerance));
        }
    }

    fn solve_normal(
        &mut self,
        tolerance: f64,
        first: bool,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        let (operator, driven) = (self.problem.operator(), self.drive.normal);
        let heights = self.problem.gap().heights().values();
        // Zero without coupling: the heights are then unchanged.
        for ((own, height), w) in
            scratch.normal.heights_mut().iter_mut().zip(heights).zip(&scratch.by_traction)
        {
            *own = height + w;
        }
        let target = Target { tolerance, iterations: self.method.iterations };
        if first && self.drive.is_small_step(self.from) {
            scratch.normal.start_from(self.from.pressure.values());
        } else if first {
            self.cost = self.cost.plus(scratch.normal.start(operator, driven, target)?);
        }
        let (approach, reached) = scratch.normal.solve(operator, driven, target, self.observer)?;
        to.shift.zeta = approach;
        to.pressure.values_mut().copy_from_slice(scratch.normal.pressure());
        self.count(reached);
        converged("pressures", tolerance, reached)
    }

    fn solve_tangential(
        &mut self,
        tolerance: f64,
        first: bool,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        let operator = self.problem.operator();
        if operator.is_coupled() {
            let [u, v] = &mut scratch.by_pressure;
            let load = TractionField::normal(to.pressure.values());
            operator.apply(
                load,
                DisplacementField::tangential(u, v),
                scratch.normal.workspace(),
            )?;
            self.cost.coupling += 1.0;
        }
        let own = operator.normal_influence_of_a_cell();
        let gaps = match scratch.limits.is_sharp() {
            true => &[],
            false => scratch.normal.gap(operator, to.shift.zeta)?,
        };
        scratch.limits.follow(&to.pressure, gaps, own);
        self.check_period_can_shift(&scratch.limits.values)?;
        if let Some(slid) = self.slide(to, scratch)? {
            return Ok(slid);
        }
        self.offsets(scratch);
        let [x, y] = &scratch.offset;
        let mut task = TangentialTask {
            operator,
            limits: &scratch.limits.values,
            offset: [x, y],
            rigid: self.rigid,
            pressure: to.pressure.values().iter().copied().fold(0.0, f64::max),
            traction: [to.traction_x.values_mut(), to.traction_y.values_mut()],
            cells: to.cells.values_mut(),
        };
        let iterations = self.method.iterations;
        let fresh = task.traction.iter().all(|values| values.iter().all(|t| *t == 0.0));
        let starts =
            fresh || (operator.is_reciprocal() && !self.shifts_little(to.shift.zeta, &task));
        if first && starts {
            let moved = (!operator.is_coupled()).then(|| self.moved());
            let started = scratch.tangential.start(&mut task, moved, (tolerance, iterations))?;
            self.cost = self.cost.plus(started);
        }
        let reached = scratch.tangential.solve(&mut task, tolerance, iterations, self.observer)?;
        self.rigid = task.rigid;
        self.count(reached);
        converged("tractions", tolerance, reached)
    }

    /// Whether all shifts are prescribed and change so little that the last tractions are as good a start as the
    /// solution on coarser grids.
    fn shifts_little(&self, approach: f64, task: &TangentialTask<'_>) -> bool {
        let grid = self.problem.grid();
        let limit =
            task.limits.iter().copied().filter(|limit| limit.is_finite()).fold(0.0, f64::max);
        let little = SMALL_SHIFT * limit / task.pressure * approach.abs();
        let [x, y, turn] = self.moved();
        let moved = x.hypot(y) + half_diagonal(grid) * turn.abs();
        let loaded = self.rigid.loads.iter().any(Option::is_some);
        !task.operator.is_coupled()
            && !loaded
            && moved <= little
            && self.drive.is_small_step(self.from)
    }

    /// An error if a shift is prescribed where the whole period sticks at any traction.
    fn check_period_can_shift(&self, limits: &[f64]) -> Result<(), FrictionalError> {
        if self.problem.operator().displaces_on_average()
            || limits.iter().any(|limit| limit.is_finite())
        {
            return Ok(());
        }
        let shifts = self.moved().into_iter().zip(["x", "y"]).zip(self.rigid.loads);
        for ((shift, axis), load) in shifts {
            if load.is_none() && shift != 0.0 {
                return Err(PeriodError::AllSticks { axis, shift }.into());
            }
        }
        Ok(())
    }
}
