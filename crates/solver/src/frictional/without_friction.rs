//! A step of bodies whose surfaces have no friction and whose materials are not coupled: pressures
//! alone, without memory for tractions.

use carom_halfspace::Field;
use carom_laws::law::Shift;

use super::error::converged;
use super::step::refuse_tangential_loads;
use super::{Frictional, FrictionalError, FrictionalScratch};
use crate::convergence::{Convergence, Observer};
use crate::drive::Drive;
use crate::normal::Target;
use crate::problem::ContactProblem;
use crate::state::ContactState;

impl Frictional {
    /// Whether a step has no tractions and no tangential displacements.
    pub(super) fn has_pressures_alone(problem: &ContactProblem, from: &ContactState) -> bool {
        let fields =
            [&from.traction_x, &from.traction_y, &from.displacement_x, &from.displacement_y];
        problem.friction().is_none()
            && !problem.operator().is_coupled()
            && fields.into_iter().all(Field::is_zero)
    }

    /// Solves such a step on all cells.
    pub(super) fn press(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, FrictionalError> {
        refuse_tangential_loads(drive)?;
        // Fields of zeros take no memory until they are written; made ahead, they are no hole in what follows.
        *to = ContactState::apart(problem.grid());
        let operator = problem.operator();
        let target = Target { tolerance: self.tolerance, iterations: self.iterations };
        let grids = &mut scratch.normal;
        grids.set_heights(problem.gap().shared_heights());
        let started = if drive.is_small_step(from) {
            grids.start_from(from.pressure.values());
            Default::default()
        } else {
            grids.start(operator, drive.normal, target)?
        };
        let (zeta, reached) = grids.solve(operator, drive.normal, target, observer)?;
        let reached = Convergence { products: started.plus(reached.products), ..reached };
        let reached = converged("pressures", self.tolerance, reached)?;
        to.shift = Shift { zeta, ..drive.shift_after(from.shift) };
        grids.give(to)?;
        Ok(reached)
    }
}
