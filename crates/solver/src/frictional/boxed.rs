//! Solves a step on a box of cells around the contact: the same solution at a lower cost.
//!
//! Cells outside the box carry no traction, so they are left out of the iterations. Once the step is solved,
//! one product on all cells shows whether the bodies overlap outside the box; then the step is solved on all
//! cells. A pilot solution on coarse cells chooses the box from the problem, the state before the step and
//! the drive alone, so that a step depends on nothing else.

use std::sync::Arc;

use carom_halfspace::operator::{DisplacementField, SurfaceOperator, TractionField};

use super::cut::Cut;
use super::scratch::Boxed;
use super::{Frictional, FrictionalError, FrictionalScratch};
use crate::convergence::{Convergence, Observer, Products};
use crate::drive::{Drive, Driven};
use crate::friction::SurfaceFriction;
use crate::gap::Gap;
use crate::normal::Target;
use crate::problem::ContactProblem;
use crate::state::ContactState;

/// A box is used on grids of at least so many cells.
const CELLS_FOR_A_BOX: usize = 96 * 96;
/// Coarse cells between the contact and each side of the box.
const MARGIN: usize = 2;

/// How a step on a box ended.
pub(super) enum InBox {
    /// It is the solution on all cells.
    Solved(Convergence),
    /// No box was used: the grid is small, the box would be nearly as large, or the operator has no smaller
    /// one.
    NotWorthIt,
    /// The contact does not fit into the box, or the iterations on the box did not converge.
    Escaped,
}

impl Boxed {
    /// The problem on a box. The last one is reused if it was on the same box, and its operator is
    /// shared if its box had the same size. `None` if the operator has no smaller one.
    fn new(
        method: &Frictional,
        problem: &ContactProblem,
        cut: Cut,
        last: Option<Box<Self>>,
    ) -> Result<Option<Box<Self>>, FrictionalError> {
        if last.as_ref().is_some_and(|last| last.cut == cut) {
            return Ok(last);
        }
        let known = last.filter(|last| last.cut.own == cut.own);
        let (operator, coarser) = if let Some(known) = known {
            (known.operator, known.coarser)
        } else {
            let Some(fewer) = problem.operator().on_fewer(cut.own.nx(), cut.own.ny()) else {
                return Ok(None);
            };
            let operator: Arc<dyn SurfaceOperator> = fewer?.into();
            let coarser = crate::nested::coarser_operators(&*operator)?;
            (operator, coarser)
        };
        // A box in which neither body lies has no gap.
        let Ok(gap) = Gap::new(cut.take(problem.gap().heights())?) else { return Ok(None) };
        let friction = match problem.friction() {
            SurfaceFriction::ByCell(field) => cut.take(field)?.into(),
            uniform @ SurfaceFriction::Uniform(_) => uniform.clone(),
        };
        let problem = ContactProblem::of_parts(gap, Arc::clone(&operator), friction);
        let scratch = method.scratch_with(&problem, &coarser)?;
        Ok(Some(Box::new(Self { cut, problem, operator, coarser, scratch })))
    }
}

impl Frictional {
    /// Solves a step on a box about the contact, where that saves work. `to` is the state after the step only if
    /// the step is solved.
    ///
    /// # Errors
    /// The errors of the step, unless a solution on all cells may succeed where the box does not.
    pub(super) fn step_in_a_box(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
        observer: &mut dyn Observer,
    ) -> Result<InBox, FrictionalError> {
        let Some(cut) = self.cut(problem, from, drive, scratch)? else {
            return Ok(InBox::NotWorthIt);
        };
        let last = scratch.boxed.take();
        let Some(boxed) = Boxed::new(self, problem, cut, last)? else {
            return Ok(InBox::NotWorthIt);
        };
        let boxed = scratch.boxed.insert(boxed);
        let own_from = cut.state(from)?;
        if boxed.problem.apart(drive.normal).is_some() {
            return Ok(InBox::Escaped);
        }
        let mut own = ContactState::apart(cut.own);
        let solved = self.step_on_all(
            &boxed.problem,
            &own_from,
            drive,
            &mut own,
            &mut boxed.scratch,
            observer,
        );
        let solved = match solved {
            Ok(solved) => solved,
            Err(error) if may_depend_on_the_box(&error) => return Ok(InBox::Escaped),
            Err(error) => return Err(error),
        };
        *to = ContactState::apart(cut.all);
        to.shift = own.shift;
        cut.give(&own.pressure, &mut to.pressure);
        cut.give(&own.traction_x, &mut to.traction_x);
        cut.give(&own.traction_y, &mut to.traction_y);
        cut.give(&own.cells, &mut to.cells);
        let part = cut.own.cells() as f64 / cut.all.cells() as f64;
        let products = solved.products.times(part).plus(self.displace(problem, to, scratch)?);
        if self.overlaps_outside(problem, cut, to, scratch) {
            return Ok(InBox::Escaped);
        }
        Ok(InBox::Solved(Convergence { products, ..solved }))
    }

    /// The box around the contact that the drive leads to, found on a coarse grid; `None` if it is
    /// not worth using.
    fn cut(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        scratch: &mut FrictionalScratch,
    ) -> Result<Option<Cut>, FrictionalError> {
        let grid = problem.grid();
        if grid.cells() < CELLS_FOR_A_BOX || !problem.operator().displaces_on_average() {
            return Ok(None);
        }
        let target = Target { tolerance: self.tolerance, iterations: self.iterations };
        let Some((coarse, cells)) =
            scratch.normal.find_contact_by_pilot(problem.operator(), drive.normal, target)?
        else {
            return Ok(None);
        };
        // Both grids have the same centre.
        let fine = |[low, high]: [usize; 2], coarse: usize, count: usize, times: f64| {
            let place = |edge: f64| times * (edge - 0.5 * coarse as f64) + 0.5 * count as f64;
            let low = place(low as f64 - MARGIN as f64).floor().max(0.0) as usize;
            let high = place((high + 1 + MARGIN) as f64).ceil().max(0.0) as usize;
            [low.min(count - 1), high.min(count)]
        };
        let times = [coarse.dx() / grid.dx(), coarse.dy() / grid.dy()];
        let cells = [
            fine(cells[0], coarse.nx(), grid.nx(), times[0]),
            fine(cells[1], coarse.ny(), grid.ny(), times[1]),
        ];
        let twists = drive.twist != Driven::Shift(from.shift.omega);
        Ok(Cut::about(grid, cells, twists))
    }

    /// The displacements of all cells: tangential ones go into the state, normal ones into their
    /// own field.
    fn displace(
        &self,
        problem: &ContactProblem,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Products, FrictionalError> {
        let (operator, mut products) = (problem.operator(), Products::default());
        let (x, y, normal) = (to.traction_x.values(), to.traction_y.values(), to.pressure.values());
        let (u, v) = (to.displacement_x.values_mut(), to.displacement_y.values_mut());
        scratch.sunk.resize(normal.len(), 0.0);
        if !operator.is_coupled() && x.iter().chain(y).all(|traction| *traction == 0.0) {
            let (load, sunk) = (TractionField::normal(normal), &mut scratch.sunk);
            operator.apply(load, DisplacementField::normal(sunk), scratch.normal.workspace())?;
            products.normal = 1.0;
            return Ok(products);
        }
        let tractions = TractionField::full(x, y, normal);
        let displacements = DisplacementField::full(u, v, &mut scratch.sunk);
        operator.apply(tractions, displacements, scratch.normal.workspace())?;
        (products.normal, products.tangential) = (1.0, 1.0);
        if operator.is_coupled() {
            products.coupling = 2.0;
        }
        Ok(products)
    }

    /// Whether the bodies overlap outside the box by more than the tolerance.
    fn overlaps_outside(
        &self,
        problem: &ContactProblem,
        cut: Cut,
        to: &ContactState,
        scratch: &FrictionalScratch,
    ) -> bool {
        let (heights, zeta) = (problem.gap().heights().values(), to.shift.zeta);
        let touching = to.pressure.values().iter().zip(heights).filter(|(p, _)| **p > 0.0);
        let scale = touching.map(|(_, height)| (zeta - height).abs()).fold(0.0, f64::max);
        let least = -self.tolerance * scale;
        let gaps = scratch.sunk.iter().zip(heights).map(|(w, height)| w + height - zeta);
        gaps.enumerate().any(|(cell, gap)| gap < least && !cut.holds(cell))
    }
}

/// Whether a step that fails on a box with this error may succeed on all cells: if the contact does
/// not fit into the box, the pressures and with them the friction limit are different.
fn may_depend_on_the_box(error: &FrictionalError) -> bool {
    match error {
        FrictionalError::NotConverged { .. } => error.lets_others_try(),
        FrictionalError::Slides { .. } | FrictionalError::Turns { .. } => true,
        FrictionalError::Range(_) | FrictionalError::Operator(_) | FrictionalError::Period(_) => {
            false
        }
    }
}
