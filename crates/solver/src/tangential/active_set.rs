//! The tangential problem at known pressures by Newton's method on an active set.
//!
//! Coulomb's law in each cell is the condition of a minimum: with the slip s = A t + c,
//! where c is the displacement without tangential tractions, `t.A t/2 + t.c` is least over the discs
//! |t| <= R. Cells that stick have two unknowns, those that slip one, along the rim of their disc,
//! whose bend adds `D = -s.e/R` to the diagonal (12.20)-(12.24). Preconditioned conjugate gradients
//! solve for them together; the sets change when what violates the discs or the direction of slip
//! outweighs the last step. Projections to the discs are made in one product with a damped step.
//!
//! All of it runs on the cells of the contact alone, one after the other, and products on the box
//! that holds them.

use std::ops::ControlFlow;

use carom_halfspace::Grid;
use carom_halfspace::operator::{OperatorError, SurfaceOperator};
use nalgebra::Vector3;

use super::contact::Within;
use super::course::Course;
use super::descent::Descent;
use super::law::{Off, Sums, force_scale, is_lost};
use super::packed::Packed;
use super::rigid::{self, Deflation, Rigid};
use super::search::Search;
use crate::convergence::{Convergence, Observer, Products, Progress, Residuals, Stop};
use crate::state::CellState;

/// What is to be solved and what is found. All fields lie on the operator's grid, or, once it is
/// packed, on the cells of the contact.
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

/// What tractions displace, over what they would cell by cell, counts as nothing below this.
const NOTHING: f64 = 1e-8;

/// Two components in each cell.
pub(super) type Plane = [Vec<f64>; 2];

/// One grid of the tangential problem, with its working memory: fields of the cells of the contact.
#[derive(Clone)]
pub(super) struct ActiveSet {
    pub(super) within: Within,
    packed: Packed,
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
    /// What stands beside bends in the preconditioner: the square root of a slipping cell's weight
    /// against the influence, and what it takes by itself.
    pub(super) root: Vec<f64>,
    pub(super) alone: Vec<f64>,
    /// What is left of the linearised problem, then the preconditioned step.
    pub(super) rest: Plane,
    pub(super) preconditioned: Plane,
    pub(super) direction: Plane,
    pub(super) image: Plane,
    pub(super) search: Search,
}

impl ActiveSet {
    pub(super) fn new(operator: &dyn SurfaceOperator) -> Self {
        let own = operator.coefficients(0, 0).rows;
        Self {
            within: Within::new(),
            packed: Packed::default(),
            centres: Plane::default(),
            deflation: Deflation::default(),
            own: 0.5 * (own[0][0] + own[1][1]),
            slip: Plane::default(),
            rim: Plane::default(),
            bend: Vec::new(),
            root: Vec::new(),
            alone: Vec::new(),
            rest: Plane::default(),
            preconditioned: Plane::default(),
            direction: Plane::default(),
            image: Plane::default(),
            search: Search::default(),
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
        self.on_the_contact(task, |set, own, cells| set.iterate(own, limits, cells, observer))
    }

    /// Solves a task with given loads by the motions that lead to them.
    ///
    /// # Errors
    /// The operator's.
    pub(super) fn solve_by_motions(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        self.on_the_contact(task, |set, own, cells| set.search(own, limits, cells, observer))
    }

    /// Packs a task for a solver, which is told the cells of the grid.
    fn on_the_contact(
        &mut self,
        task: &mut TangentialTask<'_>,
        solver: impl FnOnce(
            &mut Self,
            &mut TangentialTask<'_>,
            usize,
        ) -> Result<Convergence, OperatorError>,
    ) -> Result<Convergence, OperatorError> {
        self.within.enter(task.operator, task.limits);
        let mut packed = std::mem::take(&mut self.packed);
        packed.take(task, &self.within.contact);
        self.make_room(task.operator.grid());
        let mut own = packed.task(task);
        let went = solver(self, &mut own, task.limits.len());
        task.rigid = own.rigid;
        packed.give(task, &self.within.contact);
        self.packed = packed;
        went
    }

    fn make_room(&mut self, grid: Grid) {
        self.within.contact.centres(grid, &mut self.centres);
        let cells = self.within.contact.cells();
        let planes = [
            &mut self.slip,
            &mut self.rim,
            &mut self.rest,
            &mut self.preconditioned,
            &mut self.direction,
            &mut self.image,
        ];
        let all = [&mut self.bend, &mut self.root, &mut self.alone];
        for values in planes.into_iter().flatten().chain(all) {
            values.resize(cells, 0.0);
        }
    }

    pub(super) fn iterate(
        &mut self,
        task: &mut TangentialTask<'_>,
        limits: Limits,
        cells: usize,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, OperatorError> {
        let mut course = Course::default();
        let (scale, touching) = (force_scale(task), task.limits.len());
        self.begin(task, &mut course)?;
        let mut iteration = 0;
        let mut off = self.look(task);
        loop {
            iteration += 1;
            if course.slow_changes >= 4 || is_lost(task, off.violation) {
                Descent::new(task.operator).run(self, task, &mut course.products)?;
                course = Course { products: course.products, slow_changes: 2, ..Course::default() };
                off = self.look(task);
                off = self.change_sets(task, off.violation, &mut course)?;
            } else if iteration == 1 || course.asks_for_change(off.violation) {
                off = self.change_sets(task, off.violation, &mut course)?;
            } else {
                course.held = course.held.saturating_sub(1);
                let power = self.precondition(task, &mut course);
                off = self.gradient_step(task, power, &mut course)?;
            }
            let tangential = off.distance.max(self.unbalance(task, touching)) / scale;
            let tangential = if off.distance.is_nan() { off.distance } else { tangential };
            let residuals = Residuals { normal: 0.0, tangential };
            let seen = observer.see(&Progress { iteration, cells, touching, residuals });
            let stop = if tangential.is_nan() {
                Some(Stop::Stalled)
            } else if tangential <= limits.tolerance
                || is_settled(task, course.step.max(off.violation), limits.change)
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

    /// A step of conjugate gradients along `preconditioned`, whose product with `rest` is `power`.
    pub(super) fn gradient_step(
        &mut self,
        task: &mut TangentialTask<'_>,
        power: f64,
        course: &mut Course,
    ) -> Result<Off, OperatorError> {
        let share = course.power.map_or(0.0, |last| power / last);
        for axis in 0..2 {
            let steps = self.direction[axis].iter_mut().zip(&self.preconditioned[axis]);
            steps.for_each(|(direction, step)| *direction = step + share * *direction);
        }
        course.power = Some(power);
        if self.runs_away() {
            return Ok(Off::LOST);
        }
        self.multiply(task.operator, &mut course.products)?;
        let (mut down, mut bend, mut alone) = (0.0, 0.0, 0.0);
        let [along, across] = &self.direction;
        let rest = self.rest[0].iter().zip(&self.rest[1]);
        let image = self.image[0].iter().zip(&self.image[1]);
        for (((x, y), own), ((r_x, r_y), (u, v))) in
            along.iter().zip(across).zip(&self.bend).zip(rest.zip(image))
        {
            down += x * r_x + y * r_y;
            bend += x * u + y * v + own * (x * x + y * y);
            alone += x * x + y * y;
        }
        // Even tractions on all of a period displace nothing: they go on until some reach their limits.
        let bend = bend.max(NOTHING * self.own * alone);
        let length = if bend > 0.0 { down / bend } else { 0.0 };
        Ok(self.correct(task, length, course))
    }

    /// Whether `direction` is infinite or not a number: given loads that no correction has.
    pub(super) fn runs_away(&self) -> bool {
        !self.direction.iter().flatten().all(|value| value.is_finite())
    }

    /// Takes `length` times `direction` from the tractions; what breaks the law then.
    pub(super) fn correct(
        &mut self,
        task: &mut TangentialTask<'_>,
        length: f64,
        course: &mut Course,
    ) -> Off {
        let (mut square, mut off) = (0.0, Sums::default());
        let [tractions_x, tractions_y] = &mut task.traction;
        let [slips_x, slips_y] = &mut self.slip;
        let steps = self.direction[0].iter().zip(&self.direction[1]);
        let images = self.image[0].iter().zip(&self.image[1]);
        let rims = self.rim[0].iter().zip(&self.rim[1]);
        let tractions = tractions_x.iter_mut().zip(tractions_y.iter_mut());
        let slips = slips_x.iter_mut().zip(slips_y);
        let given = task.limits.iter().zip(task.cells.iter());
        let per_own = 1.0 / self.own;
        for ((((x, y), (u, v)), ((d_x, d_y), (a_x, a_y))), ((limit, state), (e_x, e_y))) in
            tractions.zip(slips).zip(steps.zip(images)).zip(given.zip(rims))
        {
            *x -= length * d_x;
            *y -= length * d_y;
            square += d_x * d_x + d_y * d_y;
            *u -= length * a_x;
            *v -= length * a_y;
            off.add(*state, *limit, [*x, *y], [*u * per_own, *v * per_own], [*e_x, *e_y]);
        }
        course.step = length.abs() * f64::sqrt(square);
        off.all()
    }

    /// Puts A times `direction` into `image`.
    pub(super) fn multiply(
        &mut self,
        operator: &dyn SurfaceOperator,
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        self.within.displace(operator, &self.direction, &mut self.image, products)
    }
}

/// Whether what is off, or the last step, is small beside the tractions.
fn is_settled(task: &TangentialTask<'_>, off: f64, change: f64) -> bool {
    if change == 0.0 {
        return false;
    }
    let square: f64 = task.traction.iter().flat_map(|values| values.iter()).map(|t| t * t).sum();
    off < change * square.sqrt()
}

pub(super) fn dot(a: &Plane, b: &Plane) -> f64 {
    let along = |axis: usize| a[axis].iter().zip(&b[axis]).map(|(a, b)| a * b).sum::<f64>();
    along(0) + along(1)
}
