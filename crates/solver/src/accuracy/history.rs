//! A load history solved on three nested grids.

use carom_halfspace::Grid;
use carom_special::RangeError;

use super::estimate::Estimates;
use crate::accuracy::MeshOrder;
use crate::convergence::{Convergence, Observer};
use crate::drive::Drive;
use crate::method::Method;
use crate::problem::{ContactProblem, ProblemError};
use crate::state::ContactState;

/// A load history on a grid and on two coarser ones; it costs a third more than the history on one
/// grid.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{friction::Friction, law::Shift};
/// use carom_solver::{ContactProblem, Drive, Frictional, Gap, NestedHistory};
/// let body = Material::from_shear(2.0, 0.3)?;
/// let pair = MaterialPair::new(body, body)?;
/// let make = |grid: Grid| {
///     let gap = Gap::sphere(grid, 100.0).map_err(carom_halfspace::operator::OperatorError::from)?;
///     ContactProblem::of_half_spaces(gap, pair, Friction::NONE)
/// };
/// let grid = Grid::new(64, 64, 0.04, 0.04)?;
/// let mut history = NestedHistory::new(Frictional::default(), grid, make)?;
/// history.step(&Drive::by_shift(Shift { zeta: 0.01, ..Shift::default() }), &mut ())?;
/// let force = history.estimates().map(|all| all.f_z).unwrap_or_default();
/// let exact = 4.0 / 3.0 * (2.0 / 0.7) * 0.01;
/// assert!((force.value - exact).abs() < 4.0 * force.error && force.error < 1e-3 * exact);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct NestedHistory<M: Method> {
    method: M,
    finest: Level<M>,
    /// Cell widths 2 h and 4 h; `None` from the first step that could not be solved there.
    coarse: [Option<Level<M>>; 2],
}

/// A step that is solved on all grids, and not taken yet.
#[derive(Debug, Clone)]
pub struct Trial {
    state: ContactState,
    convergence: Convergence,
    /// On the coarser grids, where it could be solved.
    coarse: [Option<ContactState>; 2],
    order: MeshOrder,
}

impl Trial {
    /// The state at its end on the finest grid.
    #[must_use]
    pub const fn state(&self) -> &ContactState {
        &self.state
    }

    /// How its solution on the finest grid ended.
    #[must_use]
    pub const fn convergence(&self) -> &Convergence {
        &self.convergence
    }

    /// As [`NestedHistory::estimates`].
    #[must_use]
    pub fn estimates(&self) -> Option<Estimates> {
        estimates(&self.state, self.coarse.each_ref().map(Option::as_ref), self.order)
    }
}

fn estimates(
    state: &ContactState,
    [coarse, coarsest]: [Option<&ContactState>; 2],
    order: MeshOrder,
) -> Option<Estimates> {
    Some(Estimates::of([state, coarse?, coarsest?], order))
}

struct Level<M: Method> {
    problem: ContactProblem,
    state: ContactState,
    scratch: M::Scratch,
}

/// Why a history on three grids cannot be set up.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NestedError<E> {
    /// A problem could not be built.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// The method does not accept the problem.
    #[error(transparent)]
    Method(E),
}

impl<M: Method> Level<M> {
    fn new(method: &M, problem: ContactProblem) -> Result<Self, NestedError<M::Error>> {
        let scratch = method.scratch(&problem).map_err(NestedError::Method)?;
        Ok(Self { state: ContactState::apart(problem.grid()), problem, scratch })
    }

    fn stepped(
        &mut self,
        method: &M,
        drive: &Drive,
        observer: &mut dyn Observer,
    ) -> Result<(ContactState, Convergence), M::Error> {
        let (problem, from) = (&self.problem, &self.state);
        let mut to = ContactState::apart(problem.grid());
        let convergence =
            method.step(problem, from, drive, &mut to, &mut self.scratch, observer)?;
        Ok((to, convergence))
    }
}

impl<M: Method> NestedHistory<M> {
    /// Separated bodies on `grid` and on two coarser grids; `make` builds the problem on each. If
    /// it cannot be built on a coarser grid, there are no error estimates.
    ///
    /// # Errors
    /// [`NestedError`] if the problem or the method's memory cannot be built on `grid`.
    pub fn new(
        method: M,
        grid: Grid,
        make: impl Fn(Grid) -> Result<ContactProblem, ProblemError>,
    ) -> Result<Self, NestedError<M::Error>> {
        let finest = Level::new(&method, make(grid)?)?;
        let below = |grid: Option<Grid>| grid.and_then(|grid| grid.coarser().ok());
        let grids = [below(Some(grid)), below(below(Some(grid)))];
        let coarse = grids.map(|grid| Level::new(&method, make(grid?).ok()?).ok());
        Ok(Self { method, finest, coarse })
    }

    /// The same without coarser grids, at three quarters of the cost: there are no error estimates.
    ///
    /// # Errors
    /// As [`NestedHistory::new`].
    pub fn without_estimates(
        method: M,
        problem: ContactProblem,
    ) -> Result<Self, NestedError<M::Error>> {
        let finest = Level::new(&method, problem)?;
        Ok(Self { method, finest, coarse: [None, None] })
    }

    /// Advances all grids by one step. If the step cannot be solved on a coarser grid, there are no
    /// error estimates from then on.
    ///
    /// # Errors
    /// The method's error on the finest grid; all states are then unchanged.
    pub fn step(
        &mut self,
        drive: &Drive,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, M::Error> {
        let trial = self.trial(drive, observer)?;
        let convergence = trial.convergence;
        self.take(trial);
        Ok(convergence)
    }

    /// Solves one step on all grids. Until it is [taken](Self::take), all states are unchanged.
    ///
    /// # Errors
    /// The method's error on the finest grid.
    pub fn trial(&mut self, drive: &Drive, observer: &mut dyn Observer) -> Result<Trial, M::Error> {
        let method = &self.method;
        let (state, convergence) = self.finest.stepped(method, drive, observer)?;
        let coarse = self
            .coarse
            .each_mut()
            .map(|level| Some(level.as_mut()?.stepped(method, drive, &mut ()).ok()?.0));
        Ok(Trial { state, convergence, coarse, order: method.mesh_order() })
    }

    /// Takes a step of this history, the last that was tried.
    pub fn take(&mut self, trial: Trial) {
        self.finest.state = trial.state;
        for (place, state) in self.coarse.iter_mut().zip(trial.coarse) {
            match (place.as_mut(), state) {
                (Some(level), Some(state)) => level.state = state,
                _ => *place = None,
            }
        }
    }

    /// The problem on the finest grid.
    #[must_use]
    pub const fn problem(&self) -> &ContactProblem {
        &self.finest.problem
    }

    /// The state on the finest grid.
    #[must_use]
    pub const fn state(&self) -> &ContactState {
        &self.finest.state
    }

    /// The method's memory on the finest grid.
    #[must_use]
    pub const fn scratch(&self) -> &M::Scratch {
        &self.finest.scratch
    }

    /// The states on the coarser grids, as long as the history could be solved there.
    #[must_use]
    pub fn coarse_states(&self) -> [Option<&ContactState>; 2] {
        self.coarse.each_ref().map(|level| level.as_ref().map(|level| &level.state))
    }

    /// Restores saved states. The history continues bit for bit as without the interruption. If a
    /// coarse state is missing, there are no error estimates from then on.
    ///
    /// # Errors
    /// [`RangeError`] if a state is on another grid; nothing is changed then.
    pub fn restore(
        &mut self,
        state: ContactState,
        coarse: [Option<ContactState>; 2],
    ) -> Result<(), RangeError> {
        state.check_grid(self.finest.problem.grid())?;
        for (level, state) in self.coarse.iter().zip(&coarse) {
            if let (Some(level), Some(state)) = (level, state) {
                state.check_grid(level.problem.grid())?;
            }
        }
        self.finest.state = state;
        for (place, state) in self.coarse.iter_mut().zip(coarse) {
            match (place.as_mut(), state) {
                (Some(level), Some(state)) => level.state = state,
                _ => *place = None,
            }
        }
        Ok(())
    }

    /// Values on the finest grid with their discretisation errors; `None` if a step could not be
    /// solved on a coarser grid.
    #[must_use]
    pub fn estimates(&self) -> Option<Estimates> {
        estimates(self.state(), self.coarse_states(), self.method.mesh_order())
    }
}
