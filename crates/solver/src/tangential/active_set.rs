//! The tangential problem at known pressures by Newton's method on an active set.
//!
//! Coulomb's law in each cell is the condition of a minimum: with the slip s = A t + c,
//! where c is the displacement without tangential tractions, `t.A t/2 + t.c` is least over the discs
//! |t| <= R. Cells that stick have two unknowns, those that slip one, along the rim of their disc,
//! whose bend adds `D = -s.e/R` to the diagonal (12.20)-(12.24). Preconditioned conjugate gradients
//! solve for them together; the sets change when what violates the discs or the direction of slip
//! outweighs the last step. Projections to the discs are made in one product with a damped step.

use std::ops::ControlFlow;

use carom_halfspace::operator::{
    DisplacementField, OperatorError, SurfaceOperator, TorusInverse, TractionField, Workspace,
};
use nalgebra::Vector3;

use super::course::Course;
use super::descent::Descent;
use super::law::{force_scale, is_lost};
use super::rigid::{self, Deflation, Rigid};
use crate::convergence::{Convergence, Observer, Products, Progress, Residuals, Stop};
use crate::state::CellState;

/// What is to be solved and what is found. All fields lie on the operator's grid.
pub(crate) struct TangentialTask<'a> {
    pub(crate) operator: &'a dyn SurfaceOperator,
    /// Greatest tractions, zero outside the contact, infinite where nothing slips.
    pub(crate) limits: &'a [f64],
    /// The displacement c without tangential tractions, against what given shifts ask for.
    pub(crate) offset: [&'a [f64]; 2],
    /// Given loads, and the shifts that they lead to.
    pub(crate) rigid: Rigid,
    /// The greatest pressure: a limit above it may be out of reach.
    pub(crate) pressure: f64,
    /// The start and the solution.
    pub(crate) traction: [&'a mut [f64]; 2],
    /// What the cells did in the start and do in the solution.
    pub(crate) cells: &'a mut [CellState],
}

/// When to stop.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// Greatest violation of the friction law over the greatest friction limit.
    pub(super) tolerance: f64,
    /// Correction and violation over the tractions, in norms; zero asks for the tolerance.
    pub(super) change: f64,
    pub(super) iterations: usize,
}

/// Two components in each cell.
pub(super) type Plane = [Vec<f64>; 2];

/// One grid of the tangential problem, with its working memory.
#[derive(Clone)]
pub(super) struct ActiveSet {
    pub(super) inverse: Option<TorusInverse>,
    pub(super) workspace: Workspace,
    pub(super) centres: Plane,
    pub(super) deflation: Deflation,
    /// The influence of a cell's traction on itself, the mean of both directions.
    pub(super) own: f64,
    /// The slip.
    pub(super) slip: Plane,
    /// Directions of the tractions of slipping cells.
    pub(super) rim: Plane,
    /// The bend D of the rim in slipping cells.
    pub(super) bend: Vec<f64>,
    /// What is left of the linearised problem, then the preconditioned step.
    pub(super) rest: Plane,
    pub(super) preconditioned: Plane,
    pub(super) direction: Plane,
    pub(super) image: Plane,
}

impl ActiveSet {
    pub(super) fn new(operator: &dyn SurfaceOperator) -> Self {
        let zero = vec![0.0; operator.grid().cells()];
        let plane = || [zero.clone(), zero.clone()];
        let own = operator.coefficients(0, 0).rows;
        Self {
            inverse: operator.inverse(),
            workspace: operator.workspace(),
            centres: rigid::centres(operator.grid()),
            deflation: Deflation::new(zero.len()),
            own: 0.5 * (own[0][0] + own[1][1]),
            slip: plane(),
            rim: plane(),
            bend: zero.clone(),
            rest: plane(),
            preconditioned: plane(),
            direction: plane(),
            image: plane(),
        }
    }

    /// Solves a task.
    ///
    /// # Errors
    /// The operator's.
    pub(super) fn solve(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let mut course = Course::default();
        let (scale, cells) = (force_scale(task), task.limits.len());
        let touching = task.limits.iter().filter(|limit| **limit > 0.0).count();
        self.begin(task, &mut course)?;
        let mut iteration = 0;
        loop {
            iteration += 1;
            let violation = self.violation(task);
            if course.slow_changes >= 4 || is_lost(task, violation) {
                Descent::new(task.operator).run(self, task, &mut course.products)?;
                course = Course { products: course.products, slow_changes: 2, ..Course::default() };
                let violation = self.violation(task);
                self.change_sets(task, violation, &mut course)?;
            } else if iteration == 1 || course.asks_for_change(violation) {
                self.change_sets(task, violation, &mut course)?;
            } else {
                course.held = course.held.saturating_sub(1);
                self.precondition(task, &mut course);
                self.gradient_step(task, &mut course)?;
            }
            let tangential = self.residual(task).max(self.unbalance(task, touching)) / scale;
            let residuals = Residuals { normal: 0.0, tangential };
            let seen = observer.see(&Progress { iteration, cells, touching, residuals });
            let stop = if tangential.is_nan() {
                Some(Stop::Stalled)
            } else if tangential <= limits.tolerance
                || self.is_settled(task, &course, limits.change)
            {
                Some(Stop::Converged)
            } else if matches!(seen, ControlFlow::Break(())) {
                Some(Stop::Observer)
            } else {
                (iteration >= limits.iterations).then_some(Stop::Exhausted)
            };
            if let Some(stop) = stop {
                self.finish(task);
                let products = course.products;
                return Ok(Convergence { iterations: iteration, products, residuals, stop });
            }
        }
    }

    /// The slip of the start, and its rims.
    fn begin(
        &mut self,
        task: &mut TangentialTask<'_>,
        course: &mut Course,
    ) -> Result<(), OperatorError> {
        for axis in 0..2 {
            self.direction[axis].copy_from_slice(task.traction[axis]);
        }
        self.multiply(task.operator, &mut course.products)?;
        self.slip_of_image(task);
        // Nothing of what was solved before counts.
        for i in 0..task.limits.len() {
            let at = [task.traction[0][i], task.traction[1][i]];
            let norm = (at[0] * at[0] + at[1] * at[1]).sqrt();
            let rim = if norm > 0.0 { at.map(|t| t / norm) } else { [0.0; 2] };
            (self.rim[0][i], self.rim[1][i]) = (rim[0], rim[1]);
        }
        Ok(())
    }

    /// The slip of tractions whose displacement is `image`.
    pub(super) fn slip_of_image(&mut self, task: &TangentialTask<'_>) {
        let moved = Vector3::from(task.rigid.moved);
        for i in 0..task.limits.len() {
            let [x, y] = rigid::displacement(&moved, self.centres[0][i], self.centres[1][i]);
            self.slip[0][i] = self.image[0][i] + task.offset[0][i] - x;
            self.slip[1][i] = self.image[1][i] + task.offset[1][i] - y;
        }
    }

    /// A step of conjugate gradients along `preconditioned`.
    pub(super) fn gradient_step(
        &mut self,
        task: &mut TangentialTask<'_>,
        course: &mut Course,
    ) -> Result<(), OperatorError> {
        let power = dot(&self.preconditioned, &self.rest);
        let share = course.power.map_or(0.0, |last| power / last);
        for axis in 0..2 {
            let steps = self.direction[axis].iter_mut().zip(&self.preconditioned[axis]);
            steps.for_each(|(direction, step)| *direction = step + share * *direction);
        }
        course.power = Some(power);
        self.multiply(task.operator, &mut course.products)?;
        let down = dot(&self.direction, &self.rest);
        let mut bend = dot(&self.direction, &self.image);
        for (i, own) in self.bend.iter().enumerate() {
            let (x, y) = (self.direction[0][i], self.direction[1][i]);
            bend += own * (x * x + y * y);
        }
        let length = if bend > 0.0 { down / bend } else { 0.0 };
        self.correct(task, length, course);
        Ok(())
    }

    pub(super) fn correct(
        &mut self,
        task: &mut TangentialTask<'_>,
        length: f64,
        course: &mut Course,
    ) {
        let mut square = 0.0;
        for axis in 0..2 {
            for (traction, step) in task.traction[axis].iter_mut().zip(&self.direction[axis]) {
                *traction -= length * step;
                square += step * step;
            }
            for (slip, image) in self.slip[axis].iter_mut().zip(&self.image[axis]) {
                *slip -= length * image;
            }
        }
        course.step = length.abs() * square.sqrt();
    }

    fn is_settled(&self, task: &TangentialTask<'_>, course: &Course, change: f64) -> bool {
        if change == 0.0 {
            return false;
        }
        let square: f64 =
            task.traction.iter().flat_map(|values| values.iter()).map(|t| t * t).sum();
        let norm = change * square.sqrt();
        course.step < norm && self.violation(task) < norm
    }

    /// Puts A times `direction` into `image`.
    pub(super) fn multiply(
        &mut self,
        operator: &dyn SurfaceOperator,
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        let tractions = TractionField::tangential(&self.direction[0], &self.direction[1]);
        let [u, v] = &mut self.image;
        let displacements = DisplacementField::tangential(u, v);
        operator.apply(tractions, displacements, &mut self.workspace)?;
        products.tangential += 1.0;
        Ok(())
    }
}

pub(super) fn dot(a: &Plane, b: &Plane) -> f64 {
    let along = |axis: usize| a[axis].iter().zip(&b[axis]).map(|(a, b)| a * b).sum::<f64>();
    along(0) + along(1)
}
