//! The steps of a case, one after another.

use super::classic::Classic;
use super::store::{Found, Store};
use super::view::Step;
use crate::case::{Leg, SolveCase, Target};
use crate::error::CliError;
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLoad, Shift};
use carom_solver::{
    CellState, ContactProblem, ContactState, DirectError, Drive, Driven, Frictional,
    FrictionalScratch, Gap, Method as _, StoredEnergy, dissipated,
};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::path::Path;

/// What a run leaves.
pub(super) struct Followed {
    pub(super) steps: Vec<Step>,
    pub(super) state: ContactState,
    /// How many steps were there before.
    pub(super) found: usize,
}

/// The contact on its grid, ready to be driven.
pub(super) struct Run<'a> {
    path: &'a Path,
    case: &'a SolveCase,
    problem: ContactProblem,
    method: Frictional,
    /// As made: each step takes a copy, so that a resumed run gives the same bits.
    scratch: FrictionalScratch,
    /// Instead, if the case asks for an older one.
    classic: Option<Classic>,
}

impl<'a> Run<'a> {
    /// # Errors
    /// [`CliError`] if the grid is too large for memory or a value out of range.
    pub(super) fn new(path: &'a Path, case: &'a SolveCase, gap: Gap) -> Result<Self, CliError> {
        let range = |source| CliError::Law { path: path.to_owned(), source };
        let friction = Friction::new(case.friction).map_err(range)?;
        let problem = ContactProblem::of_half_spaces(gap, case.materials, friction)
            .map_err(|source| CliError::Problem { path: path.to_owned(), source: source.into() })?;
        let method = Frictional::default();
        let method = match case.tolerance {
            Some(tolerance) => method.within(tolerance).map_err(range)?,
            None => method,
        };
        let scratch = method.scratch(&problem).map_err(|source| CliError::Step {
            path: path.to_owned(),
            step: 0,
            source: source.into(),
        })?;
        let classic =
            Classic::of(case, &problem).map_err(|source| classic_failed(path, 0, source))?;
        Ok(Self { path, case, problem, method, scratch, classic })
    }

    /// What is solved.
    pub(super) const fn problem(&self) -> &ContactProblem {
        &self.problem
    }

    /// By which method.
    pub(super) const fn method(&self) -> Frictional {
        self.method
    }

    /// Goes on from what was found to the last step; each step is kept when it is done.
    ///
    /// # Errors
    /// [`CliError::Step`], [`CliError::Border`], or if a step cannot be kept.
    pub(super) fn follow(self, found: Found, store: Option<&Store>) -> Result<Followed, CliError> {
        let Found { mut steps, mut state } = found;
        let count = steps.len();
        let drives = self.case.legs.iter().map(|leg| leg.count).sum::<usize>();
        let bar = progress(drives);
        bar.set_position(count as u64);
        bar.reset_eta();
        let (mut first, mut held) = (0, [Driven::Shift(0.0); 4]);
        for leg in &self.case.legs {
            for number in first + 1..=first + leg.count {
                let begin = if first == 0 { Step::default() } else { steps[first - 1] };
                let drive = drive(leg, number - first, &begin, held);
                if number > count {
                    let next = self.step(number, &drive, &state, steps.last())?;
                    (state, _) = (next.0, steps.push(next.1));
                    if let Some(store) = store {
                        store.save(&steps, &state)?;
                    }
                    bar.inc(1);
                }
            }
            first += leg.count;
            held = kept(leg, held);
        }
        bar.finish_and_clear();
        Ok(Followed { steps, state, found: count })
    }

    fn step(
        &self,
        number: usize,
        drive: &Drive,
        before: &ContactState,
        last: Option<&Step>,
    ) -> Result<(ContactState, Step), CliError> {
        let failed = |source| CliError::Step { path: self.path.to_owned(), step: number, source };
        let (mut scratch, mut state) = (self.scratch.clone(), before.clone());
        let went = match &self.classic {
            Some(classic) => classic
                .step(&self.problem, before, drive, &mut state)
                .map_err(|source| classic_failed(self.path, number, source))?,
            None => self
                .method
                .step(&self.problem, before, drive, &mut state, &mut scratch, &mut ())
                .map_err(|error| failed(error.into()))?,
        };
        if let Some(side) = border(&state).filter(|_| !self.case.is_cut) {
            return Err(CliError::Border { path: self.path.to_owned(), step: number, side });
        }
        let mut step = Step::of(number, &state, &went);
        let stored = StoredEnergy::of(&self.problem, &state);
        step.stored_energy = stored.map_err(|error| failed(Box::new(error.into())))?.total();
        let heat: f64 = dissipated(before, &state).values().iter().sum();
        step.dissipated = last.map_or(0.0, |last| last.dissipated) + heat;
        Ok((state, step))
    }
}

fn classic_failed(path: &Path, step: usize, source: DirectError) -> CliError {
    CliError::Classic { path: path.to_owned(), step, source: Box::new(source) }
}

/// What drives a step of a leg that began at `begin`.
fn drive(leg: &Leg, number: usize, begin: &Step, held: [Driven; 4]) -> Drive {
    let part = number as f64 / leg.count as f64;
    let mix = |from: f64, to: f64| if number == leg.count { to } else { from + part * (to - from) };
    let Shift { zeta, xi, eta, omega } = begin.shift;
    let ContactLoad { f_x, f_y, f_z, m_z } = begin.load;
    let at = |i: usize, shift: f64, load: f64| match leg.targets[i] {
        Target::Kept => held[i],
        Target::Shift(to) => Driven::Shift(mix(shift, to)),
        Target::Load(to) => Driven::Load(mix(load, to)),
    };
    Drive {
        normal: at(0, zeta, f_z),
        x: at(1, xi, f_x),
        y: at(2, eta, f_y),
        twist: at(3, omega, m_z),
    }
}

/// What drives each motion from now on, unless a leg says otherwise.
fn kept(leg: &Leg, held: [Driven; 4]) -> [Driven; 4] {
    std::array::from_fn(|i| match leg.targets[i] {
        Target::Kept => held[i],
        Target::Shift(to) => Driven::Shift(to),
        Target::Load(to) => Driven::Load(to),
    })
}

/// The border that the contact reaches, if it does.
fn border(state: &ContactState) -> Option<&'static str> {
    let grid = state.cells.grid();
    let touches = |i: usize, j: usize| state.cells.get(i, j) != Some(&CellState::Exterior);
    let (right, upper) = (grid.nx() - 1, grid.ny() - 1);
    let (mut rows, mut columns) = (0..grid.ny(), 0..grid.nx());
    match () {
        () if rows.clone().any(|j| touches(0, j)) => Some("left"),
        () if rows.any(|j| touches(right, j)) => Some("right"),
        () if columns.clone().any(|i| touches(i, 0)) => Some("lower"),
        () if columns.any(|i| touches(i, upper)) => Some("upper"),
        () => None,
    }
}

/// A bar with the time left; it hides where standard error is no terminal.
fn progress(count: usize) -> ProgressBar {
    let target = ProgressDrawTarget::stderr_with_hz(5);
    let bar = ProgressBar::with_draw_target(Some(count as u64), target);
    match ProgressStyle::with_template("{bar:40} {pos}/{len} steps, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
