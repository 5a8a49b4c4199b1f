//! The contact problems of all windows of a law, each built when first needed.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::sync::Arc;

use carom_halfspace::operator::{DisplacementField, TractionField};
use carom_halfspace::{Field, Grid};
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::Shift;

use super::NumericalLawError;
use super::cells::Cells;
use crate::convergence::Convergence;
use crate::drive::Drive;
use crate::frictional::{Frictional, FrictionalError, FrictionalScratch};
use crate::gap::Gap;
use crate::method::Method as _;
use crate::problem::ContactProblem;
use crate::state::ContactState;

#[derive(Default)]
pub(super) struct Windows {
    by_key: BTreeMap<(u32, usize), Arc<Window>>,
}

/// The problem on one window, with its working memory.
pub(super) struct Window {
    cells: Cells,
    problem: ContactProblem,
    /// Unused working memory: each step copies it, so that steps do not affect each other.
    scratch: FrictionalScratch,
}

impl Windows {
    pub(super) fn get(
        &mut self,
        cells: Cells,
        hertz: &Hertz,
        friction: Friction,
        method: &Frictional,
    ) -> Result<Arc<Window>, NumericalLawError> {
        match self.by_key.entry(cells.key()) {
            Entry::Occupied(window) => Ok(Arc::clone(window.get())),
            Entry::Vacant(place) => {
                let window = Window::new(cells, hertz, friction, method)?;
                Ok(Arc::clone(place.insert(Arc::new(window))))
            }
        }
    }
}

impl Window {
    fn new(
        cells: Cells,
        hertz: &Hertz,
        friction: Friction,
        method: &Frictional,
    ) -> Result<Self, NumericalLawError> {
        let gap = Gap::of_curvature(cells.grid()?, &hertz.curvature());
        let problem = ContactProblem::of_half_spaces(gap, hertz.materials(), friction)?;
        let scratch = method.scratch(&problem)?;
        Ok(Self { cells, problem, scratch })
    }

    pub(super) fn grid(&self) -> Grid {
        self.problem.grid()
    }

    /// Transfers the state of another window to this one.
    pub(super) fn take(
        &self,
        cells: Cells,
        state: &ContactState,
    ) -> Result<ContactState, NumericalLawError> {
        if cells == self.cells {
            return Ok(state.clone());
        }
        let mut own = ContactState::apart(self.grid());
        own.shift = state.shift;
        let pass = |from: &Field, to: &mut Field| {
            to.values_mut().copy_from_slice(&cells.pass(from.values(), &self.cells));
        };
        pass(&state.pressure, &mut own.pressure);
        pass(&state.traction_x, &mut own.traction_x);
        pass(&state.traction_y, &mut own.traction_y);
        if cells.contain(&self.cells) {
            // Tractions outside this window still displace its cells.
            pass(&state.displacement_x, &mut own.displacement_x);
            pass(&state.displacement_y, &mut own.displacement_y);
        } else {
            self.displace(&mut own)?;
        }
        Ok(own)
    }

    /// Sets the displacements due to all tractions.
    fn displace(&self, state: &mut ContactState) -> Result<(), NumericalLawError> {
        let (x, y) = (state.traction_x.values(), state.traction_y.values());
        let tractions = TractionField::full(x, y, state.pressure.values());
        let (u, v) = (state.displacement_x.values_mut(), state.displacement_y.values_mut());
        let displacements = DisplacementField::tangential(u, v);
        let operator = self.problem.operator();
        operator
            .apply(tractions, displacements, &mut operator.workspace())
            .map_err(FrictionalError::from)?;
        Ok(())
    }

    pub(super) fn step(
        &self,
        method: &Frictional,
        from: &ContactState,
        to: Shift,
    ) -> Result<(ContactState, Convergence), NumericalLawError> {
        let (drive, mut state) = (Drive::by_shift(to), from.clone());
        let mut scratch = self.scratch.clone();
        let convergence =
            method.step(&self.problem, from, &drive, &mut state, &mut scratch, &mut ())?;
        Ok((state, convergence))
    }
}
