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
    DisplacementField, OperatorError, Preconditioner, SurfaceOperator, Threads, TractionField,
    Workspace,
};

use super::iteration_state::IterationState;
use super::task::{Limits, NormalTask, finish};
use crate::convergence::{Convergence, Observer, Progress, Residuals, Stop};
use crate::drive::Driven;
use crate::lanes::{self, product, product_where};
use crate::parts::{each, fold, sum};
use crate::rough::inverse_of;

/// A relative error of the force above this means that the force was lost to rounding.
const LARGEST_FORCE_ERROR: f64 = 1e-9;

/// One grid of the normal problem, with its working memory.
#[derive(Clone)]
pub(super) struct ActiveSet {
    pub(super) threads: Threads,
    pub(super) inverse: Option<Arc<dyn Preconditioner>>,
    pub(super) workspace: Workspace,
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
    /// K 1 on the active set, valid until the set changes.
    pub(super) ones: Vec<f64>,
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
            own: operator.normal_influence_of_a_cell(),
            gap: zero(),
            knows_gap: false,
            preconditioned: zero(),
            direction: zero(),
            image: zero(),
            ones: zero(),
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
        let displacements = DisplacementField::normal(&mut self.gap);
        operator.apply(TractionField::normal(pressure), displacements, &mut self.workspace)?;
        each(self.threads, (&mut self.gap[..], heights), &|(gaps, heights)| {
            gaps.iter_mut().zip(heights).for_each(|(gap, height)| *gap += height - approach);
        });
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
        self.begin(task, &mut state)?;
        let normal = self.residual(task);
        if normal <= limits.tolerance && task.pressure.iter().any(|p| *p > 0.0) {
            finish(task);
            let (products, residuals) = (state.products, Residuals { normal, tangential: 0.0 });
            return Ok(Convergence { iterations: 0, products, residuals, stop: Stop::Converged });
        }
        let mut iteration = 0;
        loop {
            iteration += 1;
            if iteration == 1 || state.asks_for_change(self.violation(task)) {
                self.change_set(task, &mut state)?;
            } else {
                state.held = false;
                self.precondition(&mut state);
                self.gradient_step(task, &mut state)?;
            }
            self.deflate(task);
            let normal = self.residual(task);
            let residuals = Residuals { normal, tangential: 0.0 };
            let (cells, touching) = (task.pressure.len(), self.touching(task));
            let seen = observer.see(&Progress { iteration, cells, touching, residuals });
            let lost = !normal.is_finite() || touching == 0 || self.is_force_lost(task);
            if lost && !state.rescued {
                self.rescue(task, &mut state)?;
                continue;
            }
            let stop = if lost {
                Some(Stop::Stalled)
            } else if normal <= limits.tolerance || self.is_converged(task, &state, limits.change) {
                Some(Stop::Converged)
            } else if matches!(seen, ControlFlow::Break(())) {
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

    /// Sets up active set and gap. The initial pressure is scaled for the best fit.
    fn begin(
        &mut self,
        task: &mut NormalTask<'_>,
        state: &mut IterationState,
    ) -> Result<(), OperatorError> {
        for (active, pressure) in self.active.iter_mut().zip(task.pressure.iter_mut()) {
            *pressure = pressure.max(0.0);
            *active = *pressure > 0.0;
        }
        self.direction.copy_from_slice(task.pressure);
        self.multiply(task.operator, state)?;
        let approach = task.approach;
        let parts = (&*task.pressure, &self.image[..], task.heights);
        let [wanted, got] = fold(
            self.threads,
            parts,
            &|(pressures, images, heights)| {
                let (mut wanted, mut got) = (0.0, 0.0);
                for ((pressure, image), height) in pressures.iter().zip(images).zip(heights) {
                    if *pressure > 0.0 {
                        wanted += pressure * (approach - height);
                        got += pressure * image;
                    }
                }
                [wanted, got]
            },
            &|one: [f64; 2], other| [one[0] + other[0], one[1] + other[1]],
        );
        let factor = match task.driven {
            Driven::Load(force) => {
                force / (task.operator.grid().cell_area() * total(self.threads, task.pressure))
            }
            Driven::Shift(_) if wanted > 0.0 && got > 0.0 => wanted / got,
            Driven::Shift(_) => 1.0,
        };
        let fields = (&mut *task.pressure, &mut self.gap[..]);
        let parts = (fields, &self.image[..], task.heights);
        each(self.threads, parts, &|((pressures, gaps), images, heights)| {
            pressures.iter_mut().for_each(|pressure| *pressure *= factor);
            for ((gap, image), height) in gaps.iter_mut().zip(images).zip(heights) {
                *gap = factor * image + height - approach;
            }
        });
        if matches!(task.driven, Driven::Load(_)) {
            self.precondition_ones(state);
        }
        self.deflate(task);
        Ok(())
    }

    /// Restarts from the lowest cell alone, with cautious changes of the set. This is needed in two
    /// cases. If the heights are far above the indentation, the tension dropped is far above the
    /// force, and rounding loses the force. If the cells of a periodic surface are slender, a
    /// damped step may overshoot: each row of close cells responds to a uniform displacement like a
    /// spot far from all others.
    fn rescue(
        &mut self,
        task: &mut NormalTask<'_>,
        state: &mut IterationState,
    ) -> Result<(), OperatorError> {
        *state = IterationState::rescue(state.products, state.patient);
        task.pressure.fill(0.0);
        let lowest = task.heights.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
        if let Some((cell, _)) = lowest {
            task.pressure[cell] = 1.0;
        }
        if matches!(task.driven, Driven::Load(_)) {
            task.approach = 0.0;
        }
        self.begin(task, state)
    }

    /// Removes cells in tension from the set and adds cells that overlap.
    fn change_set(
        &mut self,
        task: &mut NormalTask<'_>,
        state: &mut IterationState,
    ) -> Result<(), OperatorError> {
        state.changes(self.violation(task));
        let parts = (&mut self.active[..], &*task.pressure, &self.gap[..]);
        let dropped = fold(
            self.threads,
            parts,
            &|(actives, pressures, gaps)| {
                let mut dropped = false;
                for ((active, pressure), gap) in actives.iter_mut().zip(pressures).zip(gaps) {
                    dropped |= *active && *pressure < 0.0;
                    *active = if *active { *pressure > 0.0 } else { *gap < 0.0 };
                }
                dropped
            },
            &|one, other| one | other,
        );
        if matches!(task.driven, Driven::Load(_)) {
            self.precondition_ones(state);
        }
        self.deflate(task);
        self.precondition(state);
        state.power = None;
        if dropped { self.merged_step(task, state) } else { self.gradient_step(task, state) }
    }

    /// Drops the pressure of cells that leave and makes a damped step of the others, in one
    /// product.
    fn merged_step(
        &mut self,
        task: &mut NormalTask<'_>,
        state: &mut IterationState,
    ) -> Result<(), OperatorError> {
        let damping = state.damping();
        let given = (&self.active[..], &self.preconditioned[..], &*task.pressure);
        let [step, dropped] = fold(
            self.threads,
            (&mut self.direction[..], given),
            &|(directions, (actives, steps, pressures))| {
                let (mut step, mut dropped) = (0.0, 0.0);
                for (i, direction) in directions.iter_mut().enumerate() {
                    if actives[i] {
                        *direction = damping * steps[i];
                        step += *direction;
                    } else {
                        *direction = pressures[i];
                        dropped += *direction;
                    }
                }
                [step, dropped]
            },
            &|one: [f64; 2], other| [one[0] + other[0], one[1] + other[1]],
        );
        // If the approach is prescribed, dropping pressure may change the force; if the force is,
        // nothing may.
        let force = match task.driven {
            Driven::Load(_) => dropped + step,
            Driven::Shift(_) => step,
        };
        if force != 0.0 {
            if matches!(task.driven, Driven::Shift(_)) {
                self.precondition_ones(state);
            }
            self.take_force(force);
        }
        self.multiply(task.operator, state)?;
        self.correct(task, 1.0, state);
        keep_active(self.threads, task.pressure, &self.active);
        Ok(())
    }

    /// Takes a force out of `direction`, by a uniform displacement.
    fn take_force(&mut self, force: f64) {
        let ones = total(self.threads, &self.ones);
        if ones > 0.0 {
            subtract(self.threads, force / ones, &self.ones, &mut self.direction);
        }
    }

    /// A step of conjugate gradients along `preconditioned`.
    fn gradient_step(
        &mut self,
        task: &mut NormalTask<'_>,
        state: &mut IterationState,
    ) -> Result<(), OperatorError> {
        let power = self.dot(&self.preconditioned, &self.gap);
        let share = state.power.map_or(0.0, |last| power / last);
        let parts = (&mut self.direction[..], &self.preconditioned[..], &self.active[..]);
        each(self.threads, parts, &|(directions, steps, actives)| {
            for ((direction, step), active) in directions.iter_mut().zip(steps).zip(actives) {
                *direction = if *active { step + share * *direction } else { 0.0 };
            }
        });
        state.power = Some(power);
        if matches!(task.driven, Driven::Load(_)) {
            // The preconditioner is symmetric to single precision only.
            let added = total(self.threads, &self.direction);
            self.take_force(added);
        }
        self.multiply(task.operator, state)?;
        let down = self.dot(&self.direction, &self.gap);
        let bend = self.dot(&self.direction, &self.image);
        // Converged to rounding.
        let length = if bend > 0.0 { down / bend } else { 0.0 };
        self.correct(task, length, state);
        Ok(())
    }

    fn correct(&mut self, task: &mut NormalTask<'_>, length: f64, state: &mut IterationState) {
        let parts =
            ((&mut *task.pressure, &self.direction[..]), (&mut self.gap[..], &self.image[..]));
        let square = sum(self.threads, parts, &|((pressures, directions), (gaps, images))| {
            let steps = pressures.iter_mut().zip(directions);
            steps.for_each(|(pressure, direction)| *pressure -= length * direction);
            gaps.iter_mut().zip(images).for_each(|(gap, image)| *gap -= length * image);
            product(directions, directions)
        });
        state.step = length.abs() * square.sqrt();
    }

    /// If the force is prescribed, adjusts the approach so that corrections do not change the
    /// force.
    fn deflate(&mut self, task: &mut NormalTask<'_>) {
        if matches!(task.driven, Driven::Shift(_)) {
            return;
        }
        let ones = total(self.threads, &self.ones);
        if ones <= 0.0 {
            return;
        }
        let mean = self.dot(&self.ones, &self.gap) / ones;
        task.approach += mean;
        each(self.threads, &mut self.gap[..], &|gaps: &mut [f64]| {
            gaps.iter_mut().for_each(|gap| *gap -= mean);
        });
    }

    /// K 1 on the active set.
    fn precondition_ones(&mut self, state: &mut IterationState) {
        for (one, active) in self.preconditioned.iter_mut().zip(&self.active) {
            *one = f64::from(u8::from(*active));
        }
        self.invert(state);
        std::mem::swap(&mut self.ones, &mut self.preconditioned);
    }

    /// K g on the active set.
    fn precondition(&mut self, state: &mut IterationState) {
        let parts = (&mut self.preconditioned[..], &self.gap[..], &self.active[..]);
        each(self.threads, parts, &|(values, gaps, actives)| {
            for ((value, gap), active) in values.iter_mut().zip(gaps).zip(actives) {
                *value = if *active { *gap } else { 0.0 };
            }
        });
        self.invert(state);
    }

    /// Applies K to `preconditioned`, restricted to the active set.
    fn invert(&mut self, state: &mut IterationState) {
        if let Some(inverse) = &self.inverse {
            std::mem::swap(&mut self.image, &mut self.preconditioned);
            inverse.pressure(&self.image, &mut self.preconditioned, &mut self.workspace);
            state.products.preconditioner += 1.0;
        }
        keep_active(self.threads, &mut self.preconditioned, &self.active);
    }

    /// Whether the sum of the pressures differs from the prescribed force by more than rounding.
    fn is_force_lost(&self, task: &NormalTask<'_>) -> bool {
        let Driven::Load(force) = task.driven else { return false };
        let sum = task.operator.grid().cell_area() * total(self.threads, task.pressure);
        (sum - force).abs() > LARGEST_FORCE_ERROR * force
    }

    /// The sum of products over the active set.
    fn dot(&self, a: &[f64], b: &[f64]) -> f64 {
        let parts = (a, b, &self.active[..]);
        sum(self.threads, parts, &|(a, b, actives)| product_where(a, b, actives))
    }

    /// Sets `image` to A times `direction`.
    fn multiply(
        &mut self,
        operator: &dyn SurfaceOperator,
        state: &mut IterationState,
    ) -> Result<(), OperatorError> {
        let tractions = TractionField::normal(&self.direction);
        let displacements = DisplacementField::normal(&mut self.image);
        operator.apply(tractions, displacements, &mut self.workspace)?;
        state.products.normal += 1.0;
        Ok(())
    }
}

fn total(threads: Threads, values: &[f64]) -> f64 {
    sum(threads, values, &lanes::total)
}

/// Subtracts `part` times `from` from the values.
fn subtract(threads: Threads, part: f64, from: &[f64], values: &mut [f64]) {
    each(threads, (values, from), &|(values, from)| {
        values.iter_mut().zip(from).for_each(|(value, from)| *value -= part * from);
    });
}

/// Sets the values of inactive cells to zero.
fn keep_active(threads: Threads, values: &mut [f64], active: &[bool]) {
    each(threads, (values, active), &|(values, actives)| {
        for (value, active) in values.iter_mut().zip(actives) {
            if !active {
                *value = 0.0;
            }
        }
    });
}
