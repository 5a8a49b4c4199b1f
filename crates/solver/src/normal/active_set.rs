//! The normal problem by conjugate gradients on an active set.
//!
//! Pressures p >= 0 and gaps g = A p + z - zeta >= 0, one of them zero in each cell. On the
//! set I of cells with pressure, preconditioned conjugate gradients solve g = 0. The set changes
//! when what violates the signs outweighs the last step; pressures that leave are dropped in one
//! product with a damped step of those that stay. A given force keeps the mean of g free: it is
//! deflated with K 1, so that every correction has no force of its own. The damped step has none by a
//! given approach either: where the contact is many spots far apart, K overestimates the answer to an
//! even displacement fifty times, which takes a line search.

use std::ops::ControlFlow;

use carom_halfspace::operator::{
    DisplacementField, OperatorError, SurfaceOperator, TorusInverse, TractionField, Workspace,
};

use super::course::Course;
use super::signs::finish;
use crate::convergence::{Convergence, Observer, Progress, Residuals, Stop};
use crate::drive::Driven;

/// A force that is off by more than this part is lost.
const LOST: f64 = 1e-9;

/// When to stop.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// Greatest violation over the greatest displacement.
    pub(super) tolerance: f64,
    /// Correction and violation of signs over the pressure, in norms; zero asks for the tolerance.
    pub(super) change: f64,
    pub(super) iterations: usize,
}

/// What is to be solved, and what is found: the pressure, and the approach.
pub(super) struct NormalTask<'a> {
    pub(super) operator: &'a dyn SurfaceOperator,
    /// Distances of the surfaces at approach zero.
    pub(super) heights: &'a [f64],
    pub(super) driven: Driven,
    /// The start, some of it positive, and the solution.
    pub(super) pressure: &'a mut [f64],
    pub(super) approach: f64,
}

/// One grid of the normal problem, with its working memory.
#[derive(Clone)]
pub(super) struct ActiveSet {
    pub(super) inverse: Option<TorusInverse>,
    pub(super) workspace: Workspace,
    /// The influence of a cell on itself.
    pub(super) own: f64,
    /// The gap g.
    pub(super) gap: Vec<f64>,
    /// K g on the set.
    pub(super) preconditioned: Vec<f64>,
    /// The correction, taken from the pressure.
    pub(super) direction: Vec<f64>,
    /// A times the correction.
    pub(super) image: Vec<f64>,
    /// K 1 on the set, kept while it stands.
    pub(super) ones: Vec<f64>,
    pub(super) active: Vec<bool>,
}

impl ActiveSet {
    pub(super) fn new(operator: &dyn SurfaceOperator) -> Self {
        let cells = operator.grid().cells();
        // Fresh memory costs nothing until it is used; a copy of zeros does.
        let zero = || vec![0.0; cells];
        Self {
            inverse: operator.inverse(),
            workspace: operator.workspace(),
            own: operator.coefficients(0, 0).rows[2][2],
            gap: zero(),
            preconditioned: zero(),
            direction: zero(),
            image: zero(),
            ones: zero(),
            active: vec![false; cells],
        }
    }

    /// The gaps of the last solution.
    pub(super) fn gap(&self) -> &[f64] {
        &self.gap
    }

    /// Solves a task whose start is positive somewhere.
    ///
    /// # Errors
    /// The operator's.
    pub(super) fn solve(
        &mut self,
        task: &mut NormalTask<'_>,
        limits: Limits,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let mut course = Course::default();
        self.begin(task, &mut course)?;
        let normal = self.residual(task);
        if normal <= limits.tolerance && task.pressure.iter().any(|p| *p > 0.0) {
            finish(task);
            let (products, residuals) = (course.products, Residuals { normal, tangential: 0.0 });
            return Ok(Convergence { iterations: 0, products, residuals, stop: Stop::Converged });
        }
        let mut iteration = 0;
        loop {
            iteration += 1;
            if iteration == 1 || course.asks_for_change(self.violation(task)) {
                self.change_set(task, &mut course)?;
            } else {
                course.held = false;
                self.precondition(&mut course);
                self.gradient_step(task, &mut course)?;
            }
            self.deflate(task);
            let normal = self.residual(task);
            let residuals = Residuals { normal, tangential: 0.0 };
            let (cells, touching) =
                (task.pressure.len(), task.pressure.iter().filter(|p| **p > 0.0).count());
            let seen = observer.see(&Progress { iteration, cells, touching, residuals });
            let lost = !normal.is_finite() || touching == 0 || is_force_lost(task);
            if lost && !course.rescued {
                self.rescue(task, &mut course)?;
                continue;
            }
            let stop = if lost {
                Some(Stop::Stalled)
            } else if normal <= limits.tolerance || self.is_settled(task, &course, limits.change) {
                Some(Stop::Converged)
            } else if matches!(seen, ControlFlow::Break(())) {
                Some(Stop::Observer)
            } else {
                (iteration >= limits.iterations).then_some(Stop::Exhausted)
            };
            if let Some(stop) = stop {
                finish(task);
                let products = course.products;
                return Ok(Convergence { iterations: iteration, products, residuals, stop });
            }
        }
    }

    /// The set and the gap of the start, which is scaled to fit best.
    fn begin(
        &mut self,
        task: &mut NormalTask<'_>,
        course: &mut Course,
    ) -> Result<(), OperatorError> {
        for (active, pressure) in self.active.iter_mut().zip(task.pressure.iter_mut()) {
            *pressure = pressure.max(0.0);
            *active = *pressure > 0.0;
        }
        self.direction.copy_from_slice(task.pressure);
        self.multiply(task.operator, course)?;
        let (mut wanted, mut got) = (0.0, 0.0);
        for (i, pressure) in task.pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
            wanted += pressure * (task.approach - task.heights[i]);
            got += pressure * self.image[i];
        }
        let factor = match task.driven {
            Driven::Load(force) => {
                force / (task.operator.grid().cell_area() * task.pressure.iter().sum::<f64>())
            }
            Driven::Shift(_) if wanted > 0.0 && got > 0.0 => wanted / got,
            Driven::Shift(_) => 1.0,
        };
        for pressure in task.pressure.iter_mut() {
            *pressure *= factor;
        }
        for ((gap, image), height) in self.gap.iter_mut().zip(&self.image).zip(task.heights) {
            *gap = factor * image + height - task.approach;
        }
        if matches!(task.driven, Driven::Load(_)) {
            self.precondition_ones(course);
        }
        self.deflate(task);
        Ok(())
    }

    /// Begins afresh from the lowest cell alone, with all care. Where heights are far above what the
    /// pressures press in, tension far above the force is dropped, and rounding takes the force along.
    /// Where the cells of a period are slender, a damped step overshoots too: each row of close cells
    /// answers to an even displacement like a spot far from all others.
    fn rescue(
        &mut self,
        task: &mut NormalTask<'_>,
        course: &mut Course,
    ) -> Result<(), OperatorError> {
        *course = Course::rescue(course.products);
        task.pressure.fill(0.0);
        let lowest = task.heights.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
        if let Some((cell, _)) = lowest {
            task.pressure[cell] = 1.0;
        }
        if matches!(task.driven, Driven::Load(_)) {
            task.approach = 0.0;
        }
        self.begin(task, course)
    }

    /// Drops pressures that pull and takes up cells that overlap.
    fn change_set(
        &mut self,
        task: &mut NormalTask<'_>,
        course: &mut Course,
    ) -> Result<(), OperatorError> {
        course.changes(self.violation(task));
        let mut dropped = false;
        for ((active, pressure), gap) in
            self.active.iter_mut().zip(task.pressure.iter()).zip(&self.gap)
        {
            dropped |= *active && *pressure < 0.0;
            *active = if *active { *pressure > 0.0 } else { *gap < 0.0 };
        }
        if matches!(task.driven, Driven::Load(_)) {
            self.precondition_ones(course);
        }
        self.deflate(task);
        self.precondition(course);
        course.power = None;
        if dropped { self.merged_step(task, course) } else { self.gradient_step(task, course) }
    }

    /// What was dropped goes, what stays takes a damped step, in one product.
    fn merged_step(
        &mut self,
        task: &mut NormalTask<'_>,
        course: &mut Course,
    ) -> Result<(), OperatorError> {
        let (damping, mut dropped, mut step) = (course.damping(), 0.0, 0.0);
        for (i, direction) in self.direction.iter_mut().enumerate() {
            if self.active[i] {
                *direction = damping * self.preconditioned[i];
                step += *direction;
            } else {
                *direction = task.pressure[i];
                dropped += *direction;
            }
        }
        // By an approach what is dropped changes the force, by a force nothing does.
        let force = match task.driven {
            Driven::Load(_) => dropped + step,
            Driven::Shift(_) => step,
        };
        if force != 0.0 {
            if matches!(task.driven, Driven::Shift(_)) {
                self.precondition_ones(course);
            }
            let part = force / self.ones.iter().sum::<f64>();
            for (direction, one) in self.direction.iter_mut().zip(&self.ones) {
                *direction -= part * one;
            }
        }
        self.multiply(task.operator, course)?;
        self.correct(task, 1.0, course);
        for (pressure, active) in task.pressure.iter_mut().zip(&self.active) {
            if !active {
                *pressure = 0.0;
            }
        }
        Ok(())
    }

    /// A step of conjugate gradients along `preconditioned`.
    fn gradient_step(
        &mut self,
        task: &mut NormalTask<'_>,
        course: &mut Course,
    ) -> Result<(), OperatorError> {
        let power = dot(&self.preconditioned, &self.gap, &self.active);
        let share = course.power.map_or(0.0, |last| power / last);
        for (i, direction) in self.direction.iter_mut().enumerate() {
            *direction =
                if self.active[i] { self.preconditioned[i] + share * *direction } else { 0.0 };
        }
        course.power = Some(power);
        self.multiply(task.operator, course)?;
        let down = dot(&self.direction, &self.gap, &self.active);
        let bend = dot(&self.direction, &self.image, &self.active);
        // Nothing left to do, to rounding.
        let length = if bend > 0.0 { down / bend } else { 0.0 };
        self.correct(task, length, course);
        Ok(())
    }

    fn correct(&mut self, task: &mut NormalTask<'_>, length: f64, course: &mut Course) {
        let mut square = 0.0;
        for (pressure, direction) in task.pressure.iter_mut().zip(&self.direction) {
            *pressure -= length * direction;
            square += direction * direction;
        }
        for (gap, image) in self.gap.iter_mut().zip(&self.image) {
            *gap -= length * image;
        }
        course.step = length.abs() * square.sqrt();
    }

    /// With a given force the approach is what makes corrections have no force of their own.
    fn deflate(&mut self, task: &mut NormalTask<'_>) {
        if matches!(task.driven, Driven::Shift(_)) {
            return;
        }
        let sum: f64 = self.ones.iter().sum();
        if sum <= 0.0 {
            return;
        }
        let mean = dot(&self.ones, &self.gap, &self.active) / sum;
        task.approach += mean;
        for gap in &mut self.gap {
            *gap -= mean;
        }
    }

    /// K 1 on the set.
    fn precondition_ones(&mut self, course: &mut Course) {
        for (one, active) in self.preconditioned.iter_mut().zip(&self.active) {
            *one = f64::from(u8::from(*active));
        }
        self.invert(course);
        self.ones.copy_from_slice(&self.preconditioned);
    }

    /// K g on the set.
    fn precondition(&mut self, course: &mut Course) {
        for (i, value) in self.preconditioned.iter_mut().enumerate() {
            *value = if self.active[i] { self.gap[i] } else { 0.0 };
        }
        self.invert(course);
    }

    /// Puts K times `preconditioned` there, on the set alone.
    fn invert(&mut self, course: &mut Course) {
        if let Some(inverse) = &self.inverse {
            self.image.copy_from_slice(&self.preconditioned);
            inverse.pressure(&self.image, &mut self.preconditioned, &mut self.workspace);
            course.products.preconditioner += 1.0;
        }
        for (value, active) in self.preconditioned.iter_mut().zip(&self.active) {
            if !active {
                *value = 0.0;
            }
        }
    }

    /// Puts A times `direction` into `image`.
    fn multiply(
        &mut self,
        operator: &dyn SurfaceOperator,
        course: &mut Course,
    ) -> Result<(), OperatorError> {
        let tractions = TractionField::normal(&self.direction);
        let displacements = DisplacementField::normal(&mut self.image);
        operator.apply(tractions, displacements, &mut self.workspace)?;
        course.products.normal += 1.0;
        Ok(())
    }
}

/// Whether the pressures have not the given force but for rounding.
fn is_force_lost(task: &NormalTask<'_>) -> bool {
    let Driven::Load(force) = task.driven else { return false };
    let sum = task.operator.grid().cell_area() * task.pressure.iter().sum::<f64>();
    (sum - force).abs() > LOST * force
}

fn dot(a: &[f64], b: &[f64], active: &[bool]) -> f64 {
    // What lies outside may be infinite: it does not count.
    a.iter().zip(b).zip(active).filter(|(_, active)| **active).map(|((a, b), _)| a * b).sum()
}
