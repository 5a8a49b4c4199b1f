//! Rolling from rest, step by step.

use super::{Progress, Rolled, Rolling, Row, too_large};
use crate::Error;
use carom_laws::law::Shift;
use carom_rolling::{Creepage, RollingContact, RollingDrive};
use carom_solver::{ContactState, Drive, Frictional, Method as _};

impl Rolling<'_> {
    /// A row at rest and one for each step, and the state at the end.
    pub(super) fn from_rest(
        &self,
        distance: f64,
        observer: &mut dyn FnMut(Progress),
    ) -> Result<Rolled, Error> {
        let case = self.case;
        let window = self.window()?;
        let problem = self.bodies.problem(&window).map_err(|source| self.problem_error(source))?;
        let way = case.method.way(window.grid()).map_err(|source| self.range(source))?;
        // A whole number of steps, up to round-off.
        let count = (distance / way.length() * (1.0 - 1e-9)).ceil() as usize;
        observer(Progress::Begun(1 + count));
        let Some(drive) = case.drives.first() else {
            return Err(self.range(carom_special::RangeError::new("drives", 0.0, "at least one")));
        };
        let mut method = Frictional::default();
        let mut contact =
            RollingContact::new(&problem, way).map_err(|source| self.failed(1, source))?;
        if let Some(tolerance) = case.tolerance {
            method = method.within(tolerance).map_err(|source| self.range(source))?;
            contact = contact.within(tolerance).map_err(|source| self.failed(1, source))?;
        }
        let mut state = ContactState::apart(problem.grid());
        let before = state.clone();
        let pressed = Drive { normal: drive.normal, ..Drive::default() };
        let mut scratch = method.scratch(&problem).map_err(|source| self.failed(1, source))?;
        let convergence = method
            .step(&problem, &before, &pressed, &mut state, &mut scratch, &mut ())
            .map_err(|source| self.failed(1, source))?;
        self.check_border(1, &state)?;
        let row = |state: &ContactState, convergence, creepage, steps: usize| Row {
            distance: Some(steps as f64 * way.length()),
            ..Row::of(&problem, state, convergence, case.speed, creepage)
        };
        let mut rows = vec![row(&state, convergence, given(drive), 0)];
        observer(Progress::Row);
        for number in 1..=count {
            let before = state.clone();
            let convergence = contact
                .step(drive, &before, &mut state, &mut ())
                .map_err(|source| self.failed(number + 1, source))?;
            self.check_border(number + 1, &state)?;
            let creepage = way.creepage(between(before.shift, state.shift));
            rows.push(row(&state, convergence, creepage, number));
            observer(Progress::Row);
        }
        let warnings =
            problem.warnings(&state).map_err(|source| self.problem_error(source.into()))?;
        let too_large = too_large(warnings).map(|warning| (rows.len(), warning));
        Ok(Rolled { rows, state, window, too_large, creep: None })
    }
}

/// The creepages that are given, at rest.
fn given(drive: &RollingDrive) -> Creepage {
    drive.creepage()
}

/// The shift from one state to the next.
fn between(before: Shift, after: Shift) -> Shift {
    Shift {
        zeta: after.zeta - before.zeta,
        xi: after.xi - before.xi,
        eta: after.eta - before.eta,
        omega: after.omega - before.omega,
    }
}
