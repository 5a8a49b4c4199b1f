//! The normal problem by preconditioned conjugate gradients on an active set.
//!
//! Pressures p >= 0 and gaps g = A p + z - zeta >= 0, with p g = 0 in each cell. On the set I of
//! cells with pressure, preconditioned conjugate gradients solve g = 0. The set is changed when the
//! violation of the inequalities exceeds the last correction. Cells that leave the set lose their
//! pressure in the same product as a damped step of the others. If the force is prescribed, the
//! mean of g is free: it is deflated with K 1, where K is the preconditioner, so that no correction
//! changes the force. The damped step does not change the force either if the approach is
//! prescribed: for a contact of many distant spots K overestimates the response to a uniform
//! displacement fifty times, which would need a line search.

use std::ops::ControlFlow;
use std::sync::Arc;

use carom_halfspace::operator::{
    DisplacementField, OperatorError, Preconditioner, ROUGHNESS, SurfaceOperator, Threads,
    TractionField, Workspace,
};

use super::iteration_state::IterationState;
use super::signs::{Seen, lower};
use super::task::{LARGE, Limits, NormalTask, finish};
use crate::convergence::{Convergence, Observer, Progress, Residuals, Stop};
use crate::drive::Driven;
use crate::lanes::{self, product, product_where};
use crate::parts::{each, fold, sum};
use crate::rough::{inverse_of, takes_rough};

/// A relative error of the force above this means that the force was lost to rounding.
const LARGEST_FORCE_ERROR: f64 = 1e-9;
/// The gap is computed again when the errors of rough products may exceed this part of the violation.
const ROUGH: f64 = 0.2;

/// One grid of the normal problem, with its working memory.
#[derive(Clone)]
pub(super) struct ActiveSet {
    pub(super) threads: Threads,
    pub(super) inverse: Option<Arc<dyn Preconditioner>>,
    pub(super) workspace: Workspace,
    /// Whether corrections take rough products.
    pub(super) rough: bool,
    /// The influence of a cell on itself.
    pub(super) own: f64,
    /// The gap g.
    pub(super) gap: Vec<f64>,
    /// Whether it is that of the last solution.
    pub(super) knows_gap: bool,
    /// K g on the active set.
    pub(super) preconditioned: Vec<f64>,
    /// The correction, subtracted from the pressure.
    pub(super) direction: Vec<f64>,
    /// A times the correction.
    pub(super) image: Vec<f64>,
    /// K 1 on the active set, valid until the set changes, and its sum.
    pub(super) ones: Vec<f64>,
    sum_of_ones: f64,
    pub(super) active: Vec<bool>,
}

impl ActiveSet {
    pub(super) fn new(operator: &dyn SurfaceOperator) -> Self {
        let cells = operator.grid().cells();
        // Zeroed memory is allocated lazily; a copy of zeros is not.
        let zero = || vec![0.0; cells];
        Self {
            threads: operator.threads(),
            inverse: inverse_of(operator),
            workspace: operator.workspace(),
            rough: cells >= LARGE && takes_rough(operator),
            own: operator.normal_influence_of_a_cell(),
            gap: zero(),
            knows_gap: false,
            preconditioned: zero(),
            direction: zero(),
            image: zero(),
            ones: zero(),
            sum_of_ones: 0.0,
            active: vec![false; cells],
        }
    }

    /// Gives back the memory of all fields.
    pub(super) fn release(&mut self) {
        for field in self.fields() {
            *field = Vec::new();
        }
        (self.active, self.workspace) = (Vec::new(), Workspace::default());
        self.knows_gap = false;
    }

    /// Makes room after a release.
    pub(super) fn make_room(&mut self, cells: usize) {
        if self.active.len() == cells {
            return;
        }
        for field in self.fields() {
            *field = vec![0.0; cells];
        }
        self.active = vec![false; cells];
    }

    const fn fields(&mut self) -> [&mut Vec<f64>; 5] {
        let Self { gap, preconditioned, direction, image, ones, .. } = self;
        [gap, preconditioned, direction, image, ones]
    }

    /// The gaps of a solution.
    pub(super) fn gap_of(
        &mut self,
        (operator, heights): (&dyn SurfaceOperator, &[f64]),
        pressure: &[f64],
        approach: f64,
    ) -> Result<&[f64], OperatorError> {
        if self.knows_gap {
            return Ok(&self.gap);
        }
        self.make_room(heights.len());
        self.compute_gap((operator, heights), pressure, approach)?;
        Ok(&self.gap)
    }

    /// Solves a task whose initial pressure is positive somewhere.
    ///
    /// # Errors
    /// The errors of the operator.
    pub(super) fn solve(
        &mut self,
        task: &mut NormalTask<'_>,
        limits: Limits,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        self.make_room(task.heights.len());
        self.knows_gap = true;
        let patient = !task.operator.is_invariant();
        let mut state = IterationState { patient, ..IterationState::default() };
        let lift = self.begin(task, limits, &mut state)?;
        let mut seen = self.check(task, (lift, limits.tolerance), &mut state)?;
        if seen.normal() <= limits.tolerance && seen.touching > 0 {
            finish(task);
            let residuals = Residuals { normal: seen.normal(), tangential: 0.0 };
            let (products, stop) = (state.products, Stop::Converged);
            return Ok(Convergence { iterations: 0, products, residuals, stop });
        }
        let mut iteration = 0;
        loop {
            iteration += 1;
            let lift = if iteration == 1 || state.asks_for_change(seen.violation) {
                self.change_set(task, seen.violation, &mut state)?
            } else {
                state.held = false;
                let inverted = self.precondition(0.0, &mut state);
                self.gradient_step(task, inverted, &mut state)?
            };
            seen = self.check(task, (lift, limits.tolerance), &mut state)?;
            let normal = seen.normal();
            let residuals = Residuals { normal, tangential: 0.0 };
            let (cells, touching) = (task.pressure.len(), seen.touching);
            let wish = observer.see(&Progress { iteration, cells, touching, residuals });
            let lost = !normal.is_finite() || touching == 0 || is_force_lost(task, seen.sum);
            if lost && !state.rescued {
                let lift = self.rescue(task, limits, &mut state)?;
                seen = self.check(task, (lift, limits.tolerance), &mut state)?;
                continue;
            }
            let stop = if lost {
                Some(Stop::Stalled)
            } else if normal <= limits.tolerance
                || self.is_converged(task, (&seen, &state), limits.change)
            {
                Some(Stop::Converged)
            } else if matches!(wish, ControlFlow::Break(())) {
                Some(Stop::Observer)
            } else {
                (iteration >= limits.iterations).then_some(Stop::Exhausted)
            };
            if let Some(stop) = stop {
                finish(task);
                let products = state.products;
                return Ok(Convergence { iterations: iteration, products, residuals, stop });
            }
        }
    }

    /// The number of cells with pressure.
    pub(super) fn touching(&self, task: &NormalTask<'_>) -> usize {
        let count = |pressures: &[f64]| pressures.iter().filter(|p| **p > 0.0).count();
        fold(self.threads, &*task.pressure, &count, &|one, other| one + other)
    }

    /// By how much the approach is to be raised on a new set, so that corrections do not change a prescribed force.
    fn lift_of_set(&mut self, task: &NormalTask<'_>, state: &mut IterationState) -> f64 {
        if matches!(task.driven, Driven::Shift(_)) {
            return 0.0;
        }
        let gaps = self.precondition_ones(state);
        self.lift(gaps)
    }

    /// The same of the sum of the gaps on the set, each times K 1.
    fn lift(&self, gaps: f64) -> f64 {
        if self.sum_of_ones > 0.0 { gaps / self.sum_of_ones } else { 0.0 }
    }

    /// Removes cells in tension from the set and adds cells that overlap, and makes a step. Returns by how much the
    /// approach is to be raised then.
    fn change_set(
        &mut self,
        task: &mut NormalTask<'_>,
        violation: f64,
        state: &mut IterationState,
    ) -> Result<f64, OperatorError> {
        state.changes(violation);
        let parts = (&mut self.active[..], &*task.pressure, &self.gap[..]);
        let (drops, dropped) = fold(
            self.threads,
            parts,
            &|(actives, pressures, gaps)| {
                let (mut drops, mut dropped) = (false, 0.0);
                for ((active, pressure), gap) in actives.iter_mut().zip(pressures).zip(gaps) {
                    drops |= *active && *pressure < 0.0;
                    *active = if *active { *pressure > 0.0 } else { *gap < 0.0 };
                    dropped += if *active { 0.0 } else { *pressure };
                }
                (drops, dropped)
            },
            &|one: (bool, f64), other: (bool, f64)| (one.0 | other.0, one.1 + other.1),
        );
        let lift = self.lift_of_set(task, state);
        task.approach += lift;
        let inverted = self.precondition(lift, state);
        state.power = None;
        if drops {
            self.merged_step(task, (inverted, dropped), state)
        } else {
            self.gradient_step(task, inverted, state)
        }
    }

    /// Drops the pressure of cells that leave and makes a damped step of the others, in one
    /// product.
    fn merged_step(
        &mut self,
        task: &mut NormalTask<'_>,
        (inverted, dropped): (Inverted, f64),
        state: &mut IterationState,
    ) -> Result<f64, OperatorError> {
        let (damping, by_force) = (state.damping(), matches!(task.driven, Driven::Load(_)));
        let step = damping * inverted.sum;
        let share = if by_force { self.share_of_ones(step + dropped) } else { 0.0 };
        let given = ((&self.active[..], &*task.pressure), &self.preconditioned[..], &self.ones[..]);
        each(self.threads, (&mut self.direction[..], given), &|(
            directions,
            ((actives, pressures), steps, ones),
        )| {
            for (i, direction) in directions.iter_mut().enumerate() {
                let step = damping * steps[i] - share * ones[i];
                *direction = if actives[i] { step } else { pressures[i] };
            }
        });
        // If the approach is prescribed, dropping pressure may change the force, the damped step may not.
        if !by_force && step != 0.0 {
            self.precondition_ones(state);
            let share = self.share_of_ones(step);
            each(self.threads, (&mut self.direction[..], &self.ones[..]), &|(steps, ones)| {
                steps.iter_mut().zip(ones).for_each(|(step, one)| *step -= share * one);
            });
        }
        self.multiply(task.operator, state)?;
        Ok(self.correct(task, 1.0, state))
    }

    /// The part of K 1 that has this force.
    fn share_of_ones(&self, force: f64) -> f64 {
        if self.sum_of_ones > 0.0 { force / self.sum_of_ones } else { 0.0 }
    }

    /// A step of conjugate gradients along `preconditioned`. Returns by how much the approach is to be raised.
    fn gradient_step(
        &mut self,
        task: &mut NormalTask<'_>,
        inverted: Inverted,
        state: &mut IterationState,
    ) -> Result<f64, OperatorError> {
        let share = state.power.map_or(0.0, |last| inverted.power / last);
        state.power = Some(inverted.power);
        // The preconditioner is symmetric to single precision only: its steps change the force a little. The last step
        // did not.
        let by_force = matches!(task.driven, Driven::Load(_));
        let of_ones = if by_force { self.share_of_ones(inverted.sum) } else { 0.0 };
        let given = ((&self.active[..], &self.ones[..]), &self.preconditioned[..]);
        each(self.threads, (&mut self.direction[..], given), &|(
            directions,
            ((actives, ones), steps),
        )| {
            for (i, direction) in directions.iter_mut().enumerate() {
                let step = steps[i] + share * *direction - of_ones * ones[i];
                *direction = if actives[i] { step } else { 0.0 };
            }
        });
        self.multiply(task.operator, state)?;
        let parts = ((&self.direction[..], &self.active[..]), (&self.gap[..], &self.image[..]));
        let [down, bend] = fold(
            self.threads,
            parts,
            &|((steps, actives), (gaps, images))| {
                [product_where(steps, gaps, actives), product_where(steps, images, actives)]
            },
            &|one: [f64; 2], other: [f64; 2]| [one[0] + other[0], one[1] + other[1]],
        );
        // Converged to rounding.
        let length = if bend > 0.0 { down / bend } else { 0.0 };
        Ok(self.correct(task, length, state))
    }

    /// Subtracts `length` times `direction` from the pressures. Returns by how much the approach is to be raised.
    fn correct(
        &mut self,
        task: &mut NormalTask<'_>,
        length: f64,
        state: &mut IterationState,
    ) -> f64 {
        let by_force = matches!(task.driven, Driven::Load(_));
        let corrected = ((&mut *task.pressure, &mut self.gap[..]), &self.direction[..]);
        let parts = (corrected, &self.image[..], &self.ones[..], &self.active[..]);
        let [square, far, raised] = fold(
            self.threads,
            parts,
            &|(((pressures, gaps), directions), images, ones, actives)| {
                let steps = pressures.iter_mut().zip(directions);
                steps.for_each(|(pressure, direction)| *pressure -= length * direction);
                gaps.iter_mut().zip(images).for_each(|(gap, image)| *gap -= length * image);
                let raised = if by_force { product_where(ones, gaps, actives) } else { 0.0 };
                [product(directions, directions), farthest(images), raised]
            },
            &|one, other| [one[0] + other[0], f64::max(one[1], other[1]), one[2] + other[2]],
        );
        state.step = length.abs() * square.sqrt();
        if self.rough {
            state.roughness += ROUGHNESS * (length.abs() * far + self.own * state.step);
        }
        self.lift(raised)
    }

    /// Raises the approach, and sees how far the solution is from its conditions; where errors of rough products count,
    /// the gap is computed without them.
    fn check(
        &mut self,
        task: &mut NormalTask<'_>,
        (lift, tolerance): (f64, f64),
        state: &mut IterationState,
    ) -> Result<Seen, OperatorError> {
        task.approach += lift;
        let seen = Seen { roughness: state.roughness, ..self.see(task, lift) };
        if seen.normal() <= tolerance || state.roughness <= ROUGH * seen.greatest {
            return Ok(seen);
        }
        self.compute_gap((task.operator, task.heights), task.pressure, task.approach)?;
        self.give_back_exact();
        state.products.normal += 1.0;
        state.roughness = 0.0;
        let lift = match task.driven {
            Driven::Load(_) => self.lift(self.dot_ones()),
            Driven::Shift(_) => 0.0,
        };
        task.approach += lift;
        Ok(self.see(task, lift))
    }

    /// Gives back the memory of exact products, which are rare where corrections take rough ones.
    pub(super) fn give_back_exact(&mut self) {
        if self.rough {
            self.workspace = Workspace::default();
        }
    }

    /// K 1 on the active set. Returns the sum of the gaps there, each times K 1.
    fn precondition_ones(&mut self, state: &mut IterationState) -> f64 {
        for (one, active) in self.preconditioned.iter_mut().zip(&self.active) {
            *one = f64::from(u8::from(*active));
        }
        let inverted = self.invert(state);
        self.sum_of_ones = inverted.sum;
        std::mem::swap(&mut self.ones, &mut self.preconditioned);
        inverted.power
    }

    /// K g on the active set, where gaps are less by `lift`.
    fn precondition(&mut self, lift: f64, state: &mut IterationState) -> Inverted {
        let parts = (&mut self.preconditioned[..], &mut self.gap[..], &self.active[..]);
        each(self.threads, parts, &|(values, gaps, actives)| {
            lower(gaps, lift);
            for ((value, gap), active) in values.iter_mut().zip(gaps).zip(actives) {
                *value = if *active { *gap } else { 0.0 };
            }
        });
        self.invert(state)
    }

    /// Applies K to `preconditioned`, restricted to the active set.
    fn invert(&mut self, state: &mut IterationState) -> Inverted {
        if let Some(inverse) = &self.inverse {
            std::mem::swap(&mut self.image, &mut self.preconditioned);
            inverse.pressure(&self.image, &mut self.preconditioned, &mut self.workspace);
            state.products.preconditioner += 1.0;
        }
        let parts = (&mut self.preconditioned[..], &self.gap[..], &self.active[..]);
        fold(
            self.threads,
            parts,
            &|(values, gaps, actives)| {
                for (value, active) in values.iter_mut().zip(actives) {
                    *value = if *active { *value } else { 0.0 };
                }
                let sum = lanes::total(values);
                Inverted { sum, power: product_where(values, gaps, actives) }
            },
            &|one: Inverted, other: Inverted| Inverted {
                sum: one.sum + other.sum,
                power: one.power + other.power,
            },
        )
    }

    /// The sum of the gaps on the active set, each times K 1.
    fn dot_ones(&self) -> f64 {
        let parts = (&self.ones[..], &self.gap[..], &self.active[..]);
        sum(self.threads, parts, &|(ones, gaps, actives)| product_where(ones, gaps, actives))
    }

    /// Sets `image` to A times `direction`, roughly if the grid is large.
    fn multiply(
        &mut self,
        operator: &dyn SurfaceOperator,
        state: &mut IterationState,
    ) -> Result<(), OperatorError> {
        let tractions = TractionField::normal(&self.direction);
        let displacements = DisplacementField::normal(&mut self.image);
        if self.rough {
            operator.apply_roughly(tractions, displacements, &mut self.workspace)?;
        } else {
            operator.apply(tractions, displacements, &mut self.workspace)?;
        }
        state.products.normal += 1.0;
        Ok(())
    }
}

/// The greatest displacement.
pub(super) fn farthest(images: &[f64]) -> f64 {
    images.iter().fold(0.0, |farthest, image| farthest.max(image.abs()))
}

/// Whether the sum of the pressures differs from the prescribed force by more than rounding.
fn is_force_lost(task: &NormalTask<'_>, sum: f64) -> bool {
    let Driven::Load(force) = task.driven else { return false };
    (task.operator.grid().cell_area() * sum - force).abs() > LARGEST_FORCE_ERROR * force
}

/// What K gives on the active set.
struct Inverted {
    sum: f64,
    /// Its product with the gaps.
    power: f64,
}
