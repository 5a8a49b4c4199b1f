//! A step with friction, on a box around the contact or on all cells.

use carom_laws::law::Shift;

use super::Frictional;
use super::boxed::InBox;
use super::error::FrictionalError;
use super::scratch::FrictionalScratch;
use crate::convergence::{Convergence, Lasting, Observer, Stop};
use crate::drive::{Drive, Driven};
use crate::method::Method;
use crate::nested;
use crate::parts;
use crate::problem::ContactProblem;
use crate::state::ContactState;

impl Method for Frictional {
    type Error = FrictionalError;
    type Scratch = FrictionalScratch;

    fn scratch(&self, problem: &ContactProblem) -> Result<FrictionalScratch, FrictionalError> {
        problem.operator().check_invariant()?;
        self.scratch_with(problem, &nested::coarser_operators(problem.operator())?)
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, FrictionalError> {
        drive.check()?;
        from.check_grid(problem.grid())?;
        if let Some(zeta) = problem.apart(drive.normal) {
            refuse_tangential_loads(drive)?;
            *to = ContactState::apart(problem.grid());
            to.shift = Shift { zeta, ..drive.shift_after(from.shift) };
            let (products, residuals) = Default::default();
            return Ok(Convergence { iterations: 0, products, residuals, stop: Stop::Converged });
        }
        problem.check_approach(drive.normal)?;
        let observer = &mut Lasting::new(observer);
        parts::within((problem.operator().threads(), problem.grid().cells()), || {
            match self.step_in_a_box(problem, from, drive, to, scratch, observer)? {
                InBox::Solved(convergence) => Ok(convergence),
                InBox::NotWorthIt | InBox::Escaped => {
                    self.step_on_all(problem, from, drive, to, scratch, observer)
                }
            }
        })
    }
}

/// Separated bodies cannot hold a tangential load.
pub(super) fn refuse_tangential_loads(drive: &Drive) -> Result<(), FrictionalError> {
    let [x, y, torque] = [drive.x, drive.y, drive.twist].map(|driven| match driven {
        Driven::Load(load) => load,
        Driven::Shift(_) => 0.0,
    });
    let force = x.hypot(y);
    if torque != 0.0 {
        return Err(FrictionalError::Turns { torque, force, part: 0.0 });
    }
    if force != 0.0 {
        return Err(FrictionalError::Slides { force, limit: 0.0 });
    }
    Ok(())
}
