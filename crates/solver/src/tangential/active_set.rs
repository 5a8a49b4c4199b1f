//! The tangential problem at given pressures, by Newton's method on an active set.
//!
//! Coulomb's law in each cell is the condition of a minimum: with the slip s = A t + c, where c is
//! the displacement without tangential tractions, `t.A t/2 + t.c` is least over the discs |t| <= R.
//! A cell that sticks has two unknowns. A cell that slips has one, along the rim of its disc; the
//! curvature of the rim adds `D = -s.e/R` to the diagonal (12.20)-(12.24). Preconditioned conjugate
//! gradients solve for all cells together. The sets of sticking and slipping cells change when the
//! violation of the discs, or of the direction of slip, exceeds the last step. Projections onto the
//! discs and a damped step share one product. Where the operator has rough products, corrections take them, and the slip
//! is computed again by a product without their errors before these count.
//!
//! All fields are compressed to the cells of the contact; products use the box that contains them.

use carom_halfspace::operator::{OperatorError, ROUGHNESS, SurfaceOperator, Threads};
use nalgebra::Vector3;

use super::compressed::Compressed;
use super::contact::ContactInfluence;
use super::iteration_state::IterationState;
use super::law::{REACHED, Violation, ViolationSums, project_to_disc};
use super::plane::{Plane, slices, slices_mut};
use super::rigid::{self, Deflation};
use super::search_scratch::Search;
use super::task::TangentialTask;
use crate::convergence::Products;
use crate::parts::{each, fold};
use crate::rough::takes_rough;
use crate::state::CellState;

/// Curvature of the objective below this fraction of its diagonal part counts as zero.
const NEGLIGIBLE_CURVATURE: f64 = 1e-8;

/// One grid of the tangential problem with its working memory; fields are on the cells of the
/// contact.
#[derive(Clone)]
pub(super) struct ActiveSet {
    pub(super) threads: Threads,
    pub(super) influence: ContactInfluence,
    pub(super) compressed: Compressed,
    pub(super) centres: Plane,
    pub(super) deflation: Deflation,
    /// The influence of a cell's traction on itself, mean of both directions; of the operator of the task.
    pub(super) own: f64,
    /// The slip.
    pub(super) slip: Plane,
    /// Directions of the tractions in slipping cells.
    pub(super) rim: Plane,
    /// The curvature term D of the rim in slipping cells.
    pub(super) bend: Vec<f64>,
    /// Terms of the preconditioner in slipping cells: the square root of the weight of the inverse
    /// on a torus, and the diagonal term.
    pub(super) root: Vec<f64>,
    pub(super) alone: Vec<f64>,
    /// The residual of the linearised problem, then the preconditioned step.
    pub(super) rest: Plane,
    pub(super) preconditioned: Plane,
    pub(super) direction: Plane,
    pub(super) image: Plane,
    pub(super) search: Search,
}

impl ActiveSet {
    pub(super) fn new(operator: &dyn SurfaceOperator) -> Self {
        Self {
            threads: operator.threads(),
            influence: ContactInfluence::new(operator.threads()),
            compressed: Compressed::default(),
            centres: Plane::default(),
            deflation: Deflation::default(),
            own: 0.0,
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

    pub(super) fn make_room(&mut self, operator: &dyn SurfaceOperator) {
        let own = operator.coefficients(0, 0).rows;
        self.own = 0.5 * (own[0][0] + own[1][1]);
        self.influence.contact.centres(operator.grid(), &mut self.centres);
        let cells = self.influence.contact.cells();
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

    /// The initial slip and the initial rim directions.
    pub(super) fn begin(
        &mut self,
        task: &mut TangentialTask<'_>,
        state: &mut IterationState,
    ) -> Result<(), OperatorError> {
        for axis in 0..2 {
            self.direction[axis].copy_from_slice(task.traction[axis]);
        }
        self.multiply(task.operator, &mut state.products)?;
        self.slip_of_image(task);
        // Results of the previous solve must not enter.
        for i in 0..task.limits.len() {
            let at = [task.traction[0][i], task.traction[1][i]];
            let norm = (at[0] * at[0] + at[1] * at[1]).sqrt();
            let rim = if norm > 0.0 { at.map(|t| t / norm) } else { [0.0; 2] };
            (self.rim[0][i], self.rim[1][i]) = (rim[0], rim[1]);
        }
        Ok(())
    }

    /// The slip for tractions whose displacement is `image`.
    pub(super) fn slip_of_image(&mut self, task: &TangentialTask<'_>) {
        let moved = Vector3::from(task.rigid.moved);
        let places = slices(&self.centres);
        let parts = (slices_mut(&mut self.slip), slices(&self.image), task.offset, places);
        each(self.threads, parts, &|([u, v], image, offset, centres)| {
            let slips = u.iter_mut().zip(v);
            let images = image[0].iter().zip(image[1]);
            let offsets = offset[0].iter().zip(offset[1]);
            let places = centres[0].iter().zip(centres[1]);
            for (((u, v), (along, across)), ((c_x, c_y), (x, y))) in
                slips.zip(images).zip(offsets.zip(places))
            {
                let [x, y] = rigid::displacement(&moved, *x, *y);
                *u = along + c_x - x;
                *v = across + c_y - y;
            }
        });
    }

    /// A step of conjugate gradients along `preconditioned`, whose product with `rest` is `power`.
    pub(super) fn gradient_step(
        &mut self,
        task: &mut TangentialTask<'_>,
        power: f64,
        state: &mut IterationState,
    ) -> Result<Violation, OperatorError> {
        let share = state.power.map_or(0.0, |last| power / last);
        let parts = (slices_mut(&mut self.direction), slices(&self.preconditioned));
        each(self.threads, parts, &|(directions, steps)| {
            for (direction, step) in directions.into_iter().zip(steps) {
                let both = direction.iter_mut().zip(step);
                both.for_each(|(direction, step)| *direction = step + share * *direction);
            }
        });
        state.power = Some(power);
        // The preconditioner is symmetric to single precision only, so that corrections change the loads a little.
        self.restore_loads(task);
        if self.runs_away() {
            return Ok(Violation::LOST);
        }
        self.multiply_roughly(task.operator, &mut state.products)?;
        let parts =
            ((slices(&self.direction), &self.bend[..]), (slices(&self.rest), slices(&self.image)));
        let [down, bend, alone] = fold(
            self.threads,
            parts,
            &|(([along, across], bends), (rest, image))| {
                let (mut down, mut bend, mut alone) = (0.0, 0.0, 0.0);
                let rest = rest[0].iter().zip(rest[1]);
                let image = image[0].iter().zip(image[1]);
                for (((x, y), own), ((r_x, r_y), (u, v))) in
                    along.iter().zip(across).zip(bends).zip(rest.zip(image))
                {
                    down += x * r_x + y * r_y;
                    bend += x * u + y * v + own * (x * x + y * y);
                    alone += x * x + y * y;
                }
                [down, bend, alone]
            },
            &|one: [f64; 3], other| std::array::from_fn(|k| one[k] + other[k]),
        );
        // Uniform tractions on a whole period cause no displacement: they grow until some reach
        // their bounds.
        let bend = bend.max(NEGLIGIBLE_CURVATURE * self.own * alone);
        let length = if bend > 0.0 { down / bend } else { 0.0 };
        Ok(self.correct(task, length, state))
    }

    /// Whether `direction` is infinite or NaN: no correction gives the prescribed loads.
    pub(super) fn runs_away(&self) -> bool {
        let all_finite = |parts: [&[f64]; 2]| {
            // Without branches, in vector registers.
            let values = parts.into_iter().flatten();
            values.fold(true, |finite, value| finite & value.is_finite())
        };
        !fold(self.threads, slices(&self.direction), &all_finite, &|one, other| one && other)
    }

    /// Subtracts `length` times `direction` from the tractions. Returns the violation of the law.
    pub(super) fn correct(
        &mut self,
        task: &mut TangentialTask<'_>,
        length: f64,
        state: &mut IterationState,
    ) -> Violation {
        let per_own = 1.0 / self.own;
        let [x, y] = &mut task.traction;
        let parts = (
            ([&mut **x, &mut **y], slices_mut(&mut self.slip)),
            (slices(&self.direction), slices(&self.image)),
            (task.limits, &*task.cells, slices(&self.rim)),
        );
        let (square, farthest, off) = fold(
            self.threads,
            parts,
            &|(([x, y], [u, v]), (steps, images), (limits, cells, rims))| {
                let (mut square, mut farthest) = (0.0, 0.0_f64);
                let mut off = ViolationSums::default();
                let (tractions, slips) = (x.iter_mut().zip(y), u.iter_mut().zip(v));
                let steps = steps[0].iter().zip(steps[1]);
                let images = images[0].iter().zip(images[1]);
                let (given, rims) = (limits.iter().zip(cells), rims[0].iter().zip(rims[1]));
                for ((((x, y), (u, v)), ((d_x, d_y), (a_x, a_y))), ((limit, cell), (e_x, e_y))) in
                    tractions.zip(slips).zip(steps.zip(images)).zip(given.zip(rims))
                {
                    *x -= length * d_x;
                    *y -= length * d_y;
                    square += d_x * d_x + d_y * d_y;
                    *u -= length * a_x;
                    *v -= length * a_y;
                    farthest = farthest.max(a_x.abs()).max(a_y.abs());
                    off.add(*cell, *limit, [*x, *y], [*u * per_own, *v * per_own], [*e_x, *e_y]);
                }
                (square, farthest, off)
            },
            &|(square, farthest, off), (squares, others, more)| {
                (square + squares, f64::max(farthest, others), off.plus(more))
            },
        );
        state.step = length.abs() * f64::sqrt(square);
        if takes_rough(task.operator) {
            state.roughness += ROUGHNESS * (length.abs() * farthest * per_own + state.step);
        }
        off.all()
    }

    /// The violation of the law.
    pub(super) fn check_law(&self, task: &TangentialTask<'_>) -> Violation {
        let per_own = 1.0 / self.own;
        let tractions = [&*task.traction[0], &*task.traction[1]];
        let parts =
            ((task.limits, &*task.cells), (tractions, slices(&self.slip)), slices(&self.rim));
        let off = fold(
            self.threads,
            parts,
            &|((limits, cells), (tractions, slips), rims)| {
                let mut off = ViolationSums::default();
                for (i, (limit, cell)) in limits.iter().zip(cells).enumerate() {
                    let traction = [tractions[0][i], tractions[1][i]];
                    let slip = [slips[0][i] * per_own, slips[1][i] * per_own];
                    off.add(*cell, *limit, traction, slip, [rims[0][i], rims[1][i]]);
                }
                off
            },
            &ViolationSums::plus,
        );
        off.all()
    }

    /// Projects tractions onto their discs and sets the states of the cells.
    pub(super) fn finish(&self, task: &mut TangentialTask<'_>) {
        for (i, &limit) in task.limits.iter().enumerate() {
            let slips = task.cells[i] == CellState::Slip;
            let at = [0, 1].map(|axis| task.traction[axis][i]);
            let norm = (at[0] * at[0] + at[1] * at[1]).sqrt();
            let [x, y] = if slips && norm > 0.0 {
                at.map(|t| limit * (t / norm))
            } else {
                project_to_disc(at, limit)
            };
            (task.traction[0][i], task.traction[1][i]) = (x, y);
            let along = self.slip[0][i] * x + self.slip[1][i] * y;
            let slips = (x * x + y * y).sqrt() >= limit * REACHED && along < 0.0;
            task.cells[i] = if slips { CellState::Slip } else { CellState::Stick };
        }
    }

    /// Computes the slip again, without the errors of rough products.
    pub(super) fn refine(
        &mut self,
        task: &TangentialTask<'_>,
        state: &mut IterationState,
    ) -> Result<(), OperatorError> {
        for (rest, traction) in self.rest.iter_mut().zip(&task.traction) {
            rest.copy_from_slice(traction);
        }
        let products = &mut state.products;
        self.influence.displace(task.operator, &self.rest, &mut self.image, products)?;
        self.slip_of_image(task);
        state.roughness = 0.0;
        Ok(())
    }

    /// Sets `image` to A times `direction`, roughly.
    pub(super) fn multiply_roughly(
        &mut self,
        operator: &dyn SurfaceOperator,
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        if !takes_rough(operator) {
            return self.multiply(operator, products);
        }
        self.influence.displace_roughly(operator, &self.direction, &mut self.image, products)
    }

    /// Sets `image` to A times `direction`.
    pub(super) fn multiply(
        &mut self,
        operator: &dyn SurfaceOperator,
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        self.influence.displace(operator, &self.direction, &mut self.image, products)
    }
}
