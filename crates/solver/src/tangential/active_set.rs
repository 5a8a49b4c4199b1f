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

use super::descent::Descent;
use super::rigid::{self, Deflation, Rigid};
use crate::convergence::{Convergence, Observer, Products, Progress, Residuals, Stop};
use crate::state::CellState;

/// A cell whose traction is within this part of its limit has reached it.
const REACHED: f64 = 1.0 - 1e-9;
/// The sets change when their violation exceeds this part of the last step.
const EAGERNESS: f64 = 0.3;
/// The same once that does not converge.
const PATIENCE: f64 = 3.0;
/// A violation that falls by less than this between changes of the sets calls for care.
const FALL: f64 = 0.7;
/// A violation that has fallen to this part since the last change of the sets has fallen far.
const FAR: f64 = 0.03;
/// Part of a preconditioned step beside projections.
const DAMPING: f64 = 0.4;
/// A disc smaller than this part of what sticking would take cannot hold its cell.
const TINY: f64 = 0.003;
/// Compliance of a slipping cell, over that by its own traction, for the preconditioner.
const SOFTNESS: f64 = 2.5;

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
    inverse: Option<TorusInverse>,
    workspace: Workspace,
    centres: Plane,
    deflation: Deflation,
    /// The influence of a cell's traction on itself, the mean of both directions.
    pub(super) own: f64,
    /// The slip.
    pub(super) slip: Plane,
    /// Directions of the tractions of slipping cells.
    rim: Plane,
    /// The bend D of the rim in slipping cells.
    bend: Vec<f64>,
    /// What is left of the linearised problem, then the preconditioned step.
    rest: Plane,
    preconditioned: Plane,
    pub(super) direction: Plane,
    pub(super) image: Plane,
}

/// The course of an iteration on one grid.
#[derive(Default)]
struct Course {
    products: Products,
    power: Option<f64>,
    step: f64,
    last_violation: Option<f64>,
    started: bool,
    /// How often the violation hardly fell from one change of the sets to the next.
    slow_changes: u32,
    /// For how many steps the sets stand.
    held: u32,
}

impl Course {
    /// Whether changes of the sets lead nowhere; not if the violation has fallen far since.
    fn careful(&self, violation: f64) -> bool {
        self.slow_changes >= 2 && self.last_violation.is_none_or(|last| violation > FAR * last)
    }

    fn changes(&mut self, violation: f64) {
        let careful = self.careful(violation);
        if self.last_violation.is_some_and(|last| violation > FALL * last) {
            self.slow_changes += 1;
        }
        // That of the start says nothing: tractions of the last step are all in their discs.
        self.last_violation = self.started.then_some(violation);
        self.started = true;
        self.held = if careful { 2 } else { 1 };
    }
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
            } else if iteration == 1 || asks_for_change(violation, &course) {
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

    /// Projects tractions to their discs and decides what sticks and what slips.
    fn change_sets(
        &mut self,
        task: &mut TangentialTask<'_>,
        violation: f64,
        course: &mut Course,
    ) -> Result<(), OperatorError> {
        let damping = if course.careful(violation) { 0.0 } else { DAMPING };
        course.changes(violation);
        let projected = self.project(task);
        self.prepare_deflation(task, course);
        self.precondition_projected(task, course);
        course.power = None;
        if projected || self.excess(task).norm() > 0.0 {
            for axis in 0..2 {
                let steps = self.direction[axis].iter_mut().zip(&self.preconditioned[axis]);
                steps.for_each(|(direction, step)| *direction += damping * step);
            }
            self.restore_loads(task);
            self.multiply(task.operator, &mut course.products)?;
            self.correct(task, 1.0, course);
            Ok(())
        } else {
            self.gradient_step(task, course)
        }
    }

    /// Sets the states, the rims and the bends, and puts into `direction` what takes tractions to
    /// their discs (to be subtracted). Whether that is anything.
    fn project(&mut self, task: &mut TangentialTask<'_>) -> bool {
        let mut any = false;
        for i in 0..task.limits.len() {
            let limit = task.limits[i];
            let [x, y] = [task.traction[0][i], task.traction[1][i]];
            let norm = (x * x + y * y).sqrt();
            self.bend[i] = 0.0;
            let target = if limit == 0.0 {
                task.cells[i] = CellState::Exterior;
                [0.0; 2]
            } else {
                let at_rim = norm >= limit * REACHED;
                let slipped = task.cells[i] == CellState::Slip;
                let along = if norm > 0.0 {
                    (self.slip[0][i] * x + self.slip[1][i] * y) / norm
                } else {
                    0.0
                };
                let pulled = [x - self.slip[0][i] / self.own, y - self.slip[1][i] / self.own];
                let pull = (pulled[0] * pulled[0] + pulled[1] * pulled[1]).sqrt();
                // Slip opposes the traction; a cell that is pushed out begins to slip, and one
                // whose disc is tiny beside what it would take to stick does.
                let tiny = limit < TINY * pull;
                let slips = (norm > limit && !slipped) || ((at_rim || slipped) && along < 0.0);
                if tiny || (slips && norm > 0.0) {
                    task.cells[i] = CellState::Slip;
                    let e = if tiny { pulled.map(|t| t / pull) } else { [x / norm, y / norm] };
                    (self.rim[0][i], self.rim[1][i]) = (e[0], e[1]);
                    let along = self.slip[0][i] * e[0] + self.slip[1][i] * e[1];
                    self.bend[i] = (-along).max(0.0) / limit;
                    [limit * e[0], limit * e[1]]
                } else {
                    task.cells[i] = CellState::Stick;
                    let part = if norm > limit { limit / norm } else { 1.0 };
                    [part * x, part * y]
                }
            };
            (self.direction[0][i], self.direction[1][i]) = (x - target[0], y - target[1]);
            any |= self.direction[0][i] != 0.0 || self.direction[1][i] != 0.0;
        }
        any
    }

    fn excess(&self, task: &TangentialTask<'_>) -> Vector3<f64> {
        task.rigid.excess(&self.centres, [task.traction[0], task.traction[1]])
    }

    /// K times the rigid displacements whose loads are given.
    fn prepare_deflation(&mut self, task: &TangentialTask<'_>, course: &mut Course) {
        if !task.rigid.is_loaded() {
            return;
        }
        for k in (0..3).filter(|&k| task.rigid.loads[k].is_some()) {
            let mut motion = Vector3::zeros();
            motion[k] = 1.0;
            for i in 0..task.limits.len() {
                let [x, y] = rigid::displacement(&motion, self.centres[0][i], self.centres[1][i]);
                let [x, y] = self.admitted(task.cells[i], i, [x, y]);
                (self.rest[0][i], self.rest[1][i]) = (x, y);
            }
            self.invert(task.cells, course);
            for axis in 0..2 {
                self.deflation.corrections[k][axis].copy_from_slice(&self.preconditioned[axis]);
            }
        }
        let mut deflation = std::mem::take(&mut self.deflation);
        deflation.prepare(&task.rigid, |i| {
            let (x, y) = (self.centres[0][i], self.centres[1][i]);
            // A correction lies in what its cell admits, so that the whole displacement will do.
            [Vector3::new(1.0, 0.0, y), Vector3::new(0.0, 1.0, -x)]
        });
        self.deflation = deflation;
    }

    /// Makes `direction`, which is subtracted, lead to the given loads.
    fn restore_loads(&mut self, task: &TangentialTask<'_>) {
        if !task.rigid.is_loaded() {
            return;
        }
        let mut wrong = rigid::sums(&self.centres, [&self.direction[0], &self.direction[1]])
            - self.excess(task);
        for k in (0..3).filter(|&k| task.rigid.loads[k].is_none()) {
            wrong[k] = 0.0;
        }
        let parts = self.deflation.parts(&wrong);
        for k in (0..3).filter(|&k| task.rigid.loads[k].is_some()) {
            for axis in 0..2 {
                let steps = self.direction[axis].iter_mut();
                for (step, own) in steps.zip(&self.deflation.corrections[k][axis]) {
                    *step -= parts[k] * own;
                }
            }
        }
    }

    /// Moves what has a given load so that corrections have none of their own.
    fn deflate(&mut self, task: &mut TangentialTask<'_>) {
        if !task.rigid.is_loaded() {
            return;
        }
        let mut loads = Vector3::zeros();
        for k in (0..3).filter(|&k| task.rigid.loads[k].is_some()) {
            loads[k] = dot(&self.deflation.corrections[k], &self.rest);
        }
        let moved = self.deflation.parts(&loads);
        for i in 0..task.limits.len() {
            let went = rigid::displacement(&moved, self.centres[0][i], self.centres[1][i]);
            let [x, y] = self.admitted(task.cells[i], i, went);
            self.rest[0][i] -= x;
            self.rest[1][i] -= y;
            self.slip[0][i] -= went[0];
            self.slip[1][i] -= went[1];
        }
        for k in 0..3 {
            task.rigid.moved[k] += moved[k];
        }
    }

    /// A step of conjugate gradients along `preconditioned`.
    fn gradient_step(
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

    fn correct(&mut self, task: &mut TangentialTask<'_>, length: f64, course: &mut Course) {
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

    /// What is left of the linearised problem, and the preconditioned step.
    fn precondition(&mut self, task: &mut TangentialTask<'_>, course: &mut Course) {
        for i in 0..task.limits.len() {
            let [x, y] = self.rest_at(task, i);
            (self.rest[0][i], self.rest[1][i]) = (x, y);
        }
        self.deflate(task);
        self.invert(task.cells, course);
    }

    /// The same for tractions that have been taken to their rims: what they were around a rim of
    /// another direction is no part of the linearised problem.
    fn precondition_projected(&mut self, task: &mut TangentialTask<'_>, course: &mut Course) {
        for i in 0..task.limits.len() {
            let [x, y] = self.admitted(task.cells[i], i, [self.slip[0][i], self.slip[1][i]]);
            (self.rest[0][i], self.rest[1][i]) = (x, y);
        }
        self.deflate(task);
        self.invert(task.cells, course);
    }

    /// The preconditioner on `rest`: `S K S` with the weight 1 where the surfaces stick and
    /// sqrt(sigma) along the rim where they slip, where the rest of the diagonal is added.
    fn invert(&mut self, cells: &[CellState], course: &mut Course) {
        let soft = SOFTNESS / self.own;
        for (i, state) in cells.iter().enumerate() {
            let rest = [self.rest[0][i], self.rest[1][i]];
            let [x, y] = match state {
                CellState::Exterior => [0.0; 2],
                CellState::Stick => rest,
                CellState::Slip => {
                    let weight = (1.0 + self.bend[i] * soft).sqrt();
                    rest.map(|rest| rest / weight)
                }
            };
            (self.image[0][i], self.image[1][i]) = (x, y);
        }
        if let Some(inverse) = &self.inverse {
            let [x, y] = &mut self.preconditioned;
            let image = [&self.image[0][..], &self.image[1][..]];
            inverse.traction(image, [x, y], &mut self.workspace);
            course.products.preconditioner += 1.0;
        } else {
            for axis in 0..2 {
                self.preconditioned[axis].copy_from_slice(&self.image[axis]);
            }
        }
        for (i, state) in cells.iter().enumerate() {
            if *state == CellState::Exterior {
                (self.preconditioned[0][i], self.preconditioned[1][i]) = (0.0, 0.0);
                continue;
            }
            let sigma = 1.0 / (1.0 + self.bend[i] * soft);
            let step = [self.preconditioned[0][i], self.preconditioned[1][i]];
            let step = self.admitted(*state, i, step).map(|step| sigma.sqrt() * step);
            let own = if self.inverse.is_some() && self.bend[i] > 0.0 {
                (1.0 - sigma) / (self.bend[i] + 1.0 / soft)
            } else {
                0.0
            };
            self.preconditioned[0][i] = step[0] + own * self.rest[0][i];
            self.preconditioned[1][i] = step[1] + own * self.rest[1][i];
        }
    }

    /// The gradient of the linearised problem in the cell.
    fn rest_at(&self, task: &TangentialTask<'_>, i: usize) -> [f64; 2] {
        let bend = self.bend[i];
        let whole = [0, 1].map(|axis| self.slip[axis][i] + bend * task.traction[axis][i]);
        self.admitted(task.cells[i], i, whole)
    }

    /// The part of a change that a cell admits: all, along the rim, none.
    fn admitted(&self, state: CellState, i: usize, [x, y]: [f64; 2]) -> [f64; 2] {
        match state {
            CellState::Exterior => [0.0; 2],
            CellState::Stick => [x, y],
            CellState::Slip => {
                let (e_x, e_y) = (self.rim[0][i], self.rim[1][i]);
                let across = e_x * y - e_y * x;
                [-e_y * across, e_x * across]
            }
        }
    }

    /// The norm of what breaks the law: tractions beyond their discs, or in them where the cell is
    /// said to slip, and slip along the traction, as tractions.
    fn violation(&self, task: &TangentialTask<'_>) -> f64 {
        let mut square = 0.0;
        for (i, limit) in task.limits.iter().enumerate() {
            if task.cells[i] == CellState::Exterior {
                continue;
            }
            let [x, y] = [task.traction[0][i], task.traction[1][i]];
            let norm = (x * x + y * y).sqrt();
            let beyond = match task.cells[i] {
                CellState::Slip => (norm - limit).abs(),
                _ => (norm - limit).max(0.0),
            };
            square += beyond * beyond;
            if task.cells[i] == CellState::Slip {
                let along = self.slip[0][i] * self.rim[0][i] + self.slip[1][i] * self.rim[1][i];
                let wrong = along.max(0.0) / self.own;
                square += wrong * wrong;
            }
        }
        square.sqrt()
    }

    /// The greatest distance of a traction from where the slip would take it and its disc hold it.
    fn residual(&self, task: &TangentialTask<'_>) -> f64 {
        let mut greatest = 0.0_f64;
        for (i, &limit) in task.limits.iter().enumerate() {
            if task.cells[i] == CellState::Exterior {
                continue;
            }
            let at = [0, 1].map(|axis| task.traction[axis][i]);
            let pulled = [0, 1].map(|axis| at[axis] - self.slip[axis][i] / self.own);
            let [x, y] = within(pulled, limit);
            let distance = ((at[0] - x) * (at[0] - x) + (at[1] - y) * (at[1] - y)).sqrt();
            if distance.is_nan() {
                return distance;
            }
            greatest = greatest.max(distance);
        }
        greatest
    }

    /// How far the loads are from the given ones, as a mean traction.
    fn unbalance(&self, task: &TangentialTask<'_>, touching: usize) -> f64 {
        if !task.rigid.is_loaded() {
            return 0.0;
        }
        let (excess, touching) = (self.excess(task), touching as f64);
        let grid = task.operator.grid();
        let arm = 0.5 * (grid.nx() as f64 * grid.dx()).hypot(grid.ny() as f64 * grid.dy());
        (excess[0].abs().max(excess[1].abs()).max(excess[2].abs() / arm)) / touching
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

    /// Tractions in their discs, and what the cells do.
    fn finish(&self, task: &mut TangentialTask<'_>) {
        for (i, &limit) in task.limits.iter().enumerate() {
            let slips = task.cells[i] == CellState::Slip;
            let at = [0, 1].map(|axis| task.traction[axis][i]);
            let norm = (at[0] * at[0] + at[1] * at[1]).sqrt();
            let [x, y] = if slips && norm > 0.0 {
                at.map(|t| limit * (t / norm))
            } else {
                within(at, limit)
            };
            (task.traction[0][i], task.traction[1][i]) = (x, y);
            let along = self.slip[0][i] * x + self.slip[1][i] * y;
            task.cells[i] = if limit == 0.0 {
                CellState::Exterior
            } else if x.hypot(y) >= limit * REACHED && along < 0.0 {
                CellState::Slip
            } else {
                CellState::Stick
            };
        }
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

fn asks_for_change(violation: f64, course: &Course) -> bool {
    let eagerness = if course.careful(violation) { PATIENCE } else { EAGERNESS };
    course.held == 0 && violation > eagerness * course.step
}

/// Whether tractions have left their discs for good.
fn is_lost(task: &TangentialTask<'_>, violation: f64) -> bool {
    let size: f64 = task.limits.iter().filter(|r| r.is_finite()).map(|r| r * r).sum();
    size > 0.0 && violation > 10.0 * size.sqrt()
}

/// The nearest point of a disc.
pub(crate) fn within([x, y]: [f64; 2], limit: f64) -> [f64; 2] {
    let norm = (x * x + y * y).sqrt();
    if norm > limit { [limit * (x / norm), limit * (y / norm)] } else { [x, y] }
}

/// The greatest limit; where that is above all pressures and above what the offset asks for, the
/// greater of these.
fn force_scale(task: &TangentialTask<'_>) -> f64 {
    let finite = task.limits.iter().copied().filter(|limit| limit.is_finite());
    let greatest = finite.fold(0.0, f64::max);
    if greatest > 0.0 && greatest <= task.pressure {
        return greatest;
    }
    let own = task.operator.coefficients(0, 0).rows[0][0];
    let offset = task.offset.iter().flat_map(|values| values.iter());
    let asked = offset.fold(0.0_f64, |most, value| most.max(value.abs())) / own;
    if greatest > 0.0 {
        greatest.min(asked.max(task.pressure))
    } else if asked > 0.0 {
        asked
    } else {
        1.0
    }
}

fn dot(a: &Plane, b: &Plane) -> f64 {
    let along = |axis: usize| a[axis].iter().zip(&b[axis]).map(|(a, b)| a * b).sum::<f64>();
    along(0) + along(1)
}
