//! Solves the cases of an input of CONTACT in turn.

use super::below::{Below, extremes};
use super::carried::{at_rest, bring, displace, moved, padding};
use super::case::{Asked, Begin, ContactCase, Motion};
use super::method::Way;
use super::potential::Potential;
use super::row::Row;
use super::springs::Fastsim;
use crate::Error;
use crate::case::InfluenceFile;
use crate::input::CaseFile;
use crate::roll::of_one_line;
use crate::solve::{border, influence_of_contact};
use carom_halfspace::operator::{Blocks, KernelOperator, OperatorError, RolledOperator};
use carom_halfspace::{Field, Grid};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellFriction, CellState, ContactProblem, ContactState, Drive, Driven, Frictional, Gap,
    Method as _, NestedError, NestedHistory, ProblemError, StoredEnergy, SurfaceFriction, Window,
    dissipated,
};
use std::path::PathBuf;
use std::sync::Arc;

/// A case that is solved.
#[derive(Debug, Clone, PartialEq)]
pub struct Solved {
    /// What CONTACT prints of it.
    pub row: Row,
    /// The extreme stresses of each block of points.
    pub below: Vec<Below>,
    /// What is told about it.
    pub notes: Vec<String>,
}

/// Solves all cases of a file. `observer` is told of each.
///
/// # Errors
/// [`Error`] with the number of the case that could not be solved.
pub fn solved(
    file: &CaseFile,
    cases: &[ContactCase],
    observer: &mut dyn FnMut(),
) -> Result<Vec<Solved>, Error> {
    let mut last = None;
    let mut all = Vec::with_capacity(cases.len());
    for case in cases {
        let placed = |error: Error| error.at("case", case.number);
        let contact = Contact::new(file, case).map_err(placed)?;
        let (solved, state) = contact.follow(last.as_ref()).map_err(placed)?;
        all.push(solved);
        last = Some(state);
        observer();
    }
    Ok(all)
}

/// The contact after a case.
struct Last {
    area: Potential,
    state: ContactState,
    /// On two coarser grids of the same area.
    coarse: [Option<ContactState>; 2],
}

/// The contact of a case.
struct Contact<'a> {
    case: &'a ContactCase,
    /// The cells, and as many beyond them as a step of rolling needs.
    area: Potential,
    window: Window,
    table: Option<KernelOperator>,
}

impl<'a> Contact<'a> {
    fn new(file: &CaseFile, case: &'a ContactCase) -> Result<Self, Error> {
        let area = case.area.padded(padding(case)?);
        let window = area.window()?;
        let table = match &case.influence {
            Some(name) => {
                let named = InfluenceFile { file: PathBuf::from(name), scale: 1.0 };
                let blocks = if case.motion == Motion::None { Blocks::Normal } else { Blocks::All };
                let grid = window.grid();
                Some(influence_of_contact(file, &named, grid, case.materials, blocks)?)
            }
            None => None,
        };
        Ok(Self { case, area, window, table })
    }

    fn is_padded(&self) -> bool {
        self.area != self.case.area
    }

    /// The gap on a grid; no body lies beyond the cells of the file.
    fn gap(&self, grid: Grid) -> Result<Gap, ProblemError> {
        let own = self.case.area.window().map_err(OperatorError::from)?;
        let made = if self.is_padded() {
            self.case.surface.gap(&own, &own).and_then(|gap| {
                let heights = moved(gap.heights(), &self.case.area, &self.area, f64::INFINITY)?;
                Gap::new(heights)
            })
        } else {
            self.case.surface.gap(&self.window.with(grid), &own)
        };
        Ok(made.map_err(OperatorError::from)?)
    }

    fn friction(&self, grid: Grid) -> Result<SurfaceFriction, ProblemError> {
        let case = self.case;
        if case.motion == Motion::None {
            return Ok(Friction::NONE.into());
        }
        let of = |value: f64| Friction::new(value).map_err(OperatorError::from);
        if let [one] = *case.friction {
            return Ok(of(one)?.into());
        }
        let all: Result<Vec<_>, _> = case.friction.iter().map(|value| of(*value)).collect();
        let (all, area, middle) = (all?, case.area, self.window.middle()[1]);
        let row = |y: f64| {
            let place = (middle + y - area.corner[1]) / area.size[1];
            all[(place.max(0.0) as usize).min(all.len() - 1)]
        };
        Ok(Field::from_function(grid, |_, y| CellFriction::from(row(y))).into())
    }

    fn problem(&self, grid: Grid) -> Result<ContactProblem, ProblemError> {
        let grid = of_one_line(self.window.grid(), grid).map_err(OperatorError::from)?;
        let (gap, friction) = (self.gap(grid)?, self.friction(grid)?);
        match &self.table {
            Some(table) => ContactProblem::new(gap, Arc::new(table.coarsened_to(grid)?), friction),
            None => ContactProblem::of_half_spaces(gap, self.case.materials, friction),
        }
    }

    /// The extra creepages of body 2 against body 1.
    fn local(&self) -> Result<Option<[Field; 2]>, Error> {
        let Some(extra) = &self.case.extra else { return Ok(None) };
        let grid = self.case.area.window()?.grid();
        let axis = |i: usize| {
            let own = Field::new(grid, extra.iter().map(|slip| -slip[i]).collect())?;
            moved(&own, &self.case.area, &self.area, 0.0)
        };
        Ok(Some([axis(0)?, axis(1)?]))
    }

    fn history(&self, local: Option<[Field; 2]>) -> Result<NestedHistory<Way>, Error> {
        let alone = local.is_some() || self.is_padded();
        let way = Way::new(self.case.motion, local, self.case.falling)?;
        let made = if alone {
            NestedHistory::without_estimates(way, self.problem(self.window.grid())?)
        } else {
            NestedHistory::new(way, self.window.grid(), |grid| self.problem(grid))
        };
        made.map_err(|error| match error {
            NestedError::Problem(source) => source.into(),
            NestedError::Method(source) => source.into(),
        })
    }

    /// The tractions with which the case begins, and what they displace.
    fn before(
        &self,
        problem: &ContactProblem,
        last: Option<&Last>,
        local: Option<&[Field; 2]>,
    ) -> Result<ContactState, Error> {
        let mut state = ContactState::apart(problem.grid());
        if let Some(last) = last.filter(|_| self.case.begin != Begin::Apart) {
            let take = |field: &Field| moved(field, &last.area, &self.area, 0.0);
            state.pressure = take(&last.state.pressure)?;
            if self.case.begin == Begin::Tractions {
                state.traction_x = take(&last.state.traction_x)?;
                state.traction_y = take(&last.state.traction_y)?;
            }
            displace(problem, &mut state)?;
        }
        // Steady rolling has its own place for them.
        let length = match self.case.motion {
            Motion::Shift => 1.0,
            Motion::Step(rolling) => rolling.dq,
            Motion::None | Motion::Steady(_) => return Ok(state),
        };
        if let Some([along, across]) = local {
            for (own, extra) in
                [(&mut state.displacement_x, along), (&mut state.displacement_y, across)]
            {
                let pairs = own.values_mut().iter_mut().zip(extra.values());
                pairs.for_each(|(own, extra)| *own += length * extra);
            }
        }
        Ok(state)
    }

    /// What drives the case, in carom's signs: motions of body 2 against body 1 about the middle of the cells.
    fn drive(&self, problem: &ContactProblem) -> Result<Drive, Error> {
        let case = self.case;
        if case.motion == Motion::None {
            return Ok(Drive { normal: case.drive.normal, ..Drive::default() });
        }
        let of_middle = case.of_middle();
        let force = case.scale() * self.normal_force(problem)?;
        let axis = |i: usize| match case.drive.along[i] {
            Asked::Creepage(creepage) => Driven::Shift(-(creepage + of_middle[i])),
            Asked::Force(part) => Driven::Load(part * force),
        };
        let twist = Driven::Shift(case.drive.spin);
        Ok(Drive { normal: case.drive.normal, x: axis(0), y: axis(1), twist })
    }

    /// The normal force by which relative forces are multiplied; 0 if there are none.
    fn normal_force(&self, problem: &ContactProblem) -> Result<f64, Error> {
        let asks = |asked: &Asked| matches!(asked, Asked::Force(_));
        match self.case.drive.normal {
            Driven::Load(force) => Ok(force),
            Driven::Shift(_) if !self.case.drive.along.iter().any(asks) => Ok(0.0),
            Driven::Shift(_) if problem.operator().is_coupled() => Err(Error::input(
                "relative forces (F = 1 or 2) at a given approach (N = 0) are for bodies that are not coupled: \
                 give FN (N = 1)",
            )),
            normal => {
                let (method, bare) = (Frictional::default(), problem.clone().without_friction());
                let apart = ContactState::apart(bare.grid());
                let mut pressed = apart.clone();
                let drive = Drive { normal, ..Drive::default() };
                let failed = |error| Error::from(super::method::WayError::from(error));
                let mut scratch = method.scratch(&bare).map_err(failed)?;
                method
                    .step(&bare, &apart, &drive, &mut pressed, &mut scratch, &mut ())
                    .map_err(failed)?;
                Ok(pressed.load().f_z)
            }
        }
    }

    fn follow(&self, last: Option<&Last>) -> Result<(Solved, Last), Error> {
        let case = self.case;
        if let Some(fastsim) = &case.fastsim {
            return self.roll_on_springs(fastsim, last);
        }
        let local = self.local()?;
        let mut history = self.history(local.clone())?;
        let before = self.before(history.problem(), last, local.as_ref())?;
        let same = last.filter(|last| last.area == self.area && case.begin == Begin::Tractions);
        let coarse = match (case.begin, same) {
            (Begin::Apart, _) => history.coarse_states().map(|state| state.cloned()),
            (_, Some(last)) => last.coarse.clone().map(|state| state.map(at_rest)),
            _ => [None, None],
        };
        history.restore(before.clone(), coarse)?;
        let drive = self.drive(history.problem())?;
        history.step(&drive, &mut ())?;
        let (problem, state) = (history.problem(), history.state());
        let slipped = self.slipped(problem, &before, state, local.as_ref())?;
        let stored = StoredEnergy::of(problem, state).map_err(ProblemError::from)?;
        let force = state.load().f_z;
        let row = Row::of(case, state, force, history.estimates(), slipped, stored.total());
        let below = extremes(case, state, &self.area)?;
        let mut notes = case.notes.clone();
        // A line of cells is as long as the bodies.
        let [columns, rows] = case.area.cells;
        let side = border(state).filter(|side| match *side {
            "left" | "right" => columns > 1,
            _ => rows > 1,
        });
        if let Some(side) = side.filter(|_| !self.is_padded()) {
            notes.push(format!("the contact reaches the {side} border of its cells"));
        }
        let coarse = history.coarse_states().map(|state| state.cloned());
        Ok((Solved { row, below, notes }, Last { area: self.area, state: state.clone(), coarse }))
    }

    /// FASTSIM: pressures that are given or solved for, then springs.
    fn roll_on_springs(
        &self,
        fastsim: &Fastsim,
        last: Option<&Last>,
    ) -> Result<(Solved, Last), Error> {
        let case = self.case;
        let (Motion::Steady(rolling), [Asked::Creepage(x), Asked::Creepage(y)]) =
            (case.motion, case.drive.along)
        else {
            return Err(Error::input(
                "FASTSIM (M = 2 or 3) is for steady rolling at creepages (T = 3, F = 0)",
            ));
        };
        let given = case.bound.given(self.window.grid(), self.area.middle());
        let (mut state, force) = match (given, case.ellipse) {
            (Some(state), Some(ellipse)) => (state, ellipse.force),
            _ => {
                let bare = ContactCase { motion: Motion::None, fastsim: None, ..case.clone() };
                let state = Contact { case: &bare, table: self.table.clone(), ..*self }
                    .follow(last)?
                    .1
                    .state;
                let force = state.load().f_z;
                (state, force)
            }
        };
        let heat = rolling.dq * fastsim.roll(case, [x, y], &rolling.way()?, force, &mut state)?;
        let row = Row::of(case, &state, force, None, heat, 0.0);
        let below = extremes(case, &state, &self.area)?;
        let last = Last { area: self.area, state, coarse: [None, None] };
        Ok((Solved { row, below, notes: case.notes.clone() }, last))
    }

    /// The friction heat of the cells that slip, in a shift or a step.
    fn slipped(
        &self,
        problem: &ContactProblem,
        before: &ContactState,
        state: &ContactState,
        local: Option<&[Field; 2]>,
    ) -> Result<f64, Error> {
        let mut after = state.clone();
        let mut before = at_rest(before.clone());
        let way = match self.case.motion.rolling() {
            None => None,
            Some(rolling) => Some(rolling.way()?),
        };
        if let Some(way) = way {
            let (shift, at, length) = (state.shift, way.spin_offset(), way.length());
            after.shift.xi = length * (shift.xi + at.y * shift.omega);
            after.shift.eta = length * (shift.eta - at.x * shift.omega);
            after.shift.omega = length * shift.omega;
            let operator = Arc::clone(problem.shared_operator());
            let threads = operator.threads();
            let rolled =
                RolledOperator::new(operator, way.ahead(), threads).map_err(ProblemError::from)?;
            let steady = matches!(self.case.motion, Motion::Steady(_));
            if steady {
                before = after.clone();
                before.shift = Shift::default();
            }
            bring(&rolled, &mut before)?;
            if let Some(local) = local.filter(|_| steady) {
                let all = [&mut before.displacement_x, &mut before.displacement_y];
                for (own, extra) in all.into_iter().zip(local) {
                    let pairs = own.values_mut().iter_mut().zip(extra.values());
                    pairs.for_each(|(own, extra)| *own += length * extra);
                }
            }
        }
        let heat = dissipated(&before, &after);
        let cells = state.cells.values().iter().zip(heat.values());
        Ok(cells.filter(|(cell, _)| **cell == CellState::Slip).map(|(_, heat)| heat).sum())
    }
}
