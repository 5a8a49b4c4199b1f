//! The model of impacts: the outcomes of a case with unknowns for each row of data.

use crate::FitError;
use crate::columns::{Input, Known, Read};
use crate::measured::Measurement;
use crate::model::{Model, Parameter};
use crate::observable::{Bounce, Observable};
use carom_cases::case::{CaseError, ImpactCase, OpenCase, Unknown};
use carom_cases::impact::{course, outcome};
use carom_cases::{Error, ErrorKind};
use carom_impact::{HistoryPoint, NeededLaw, TabledCollision};
use carom_laws::friction::Friction;
use carom_numerical::CollisionLaw;
use carom_special::{Readable, interrupt};
use rayon::prelude::*;

/// Relative steps of differences, and changes of sums that mean nothing: by the table and the exact impact, and by laws that
/// refine in steps.
const SMOOTH: [f64; 2] = [2e-3, 1e-13];
const COARSE: [f64; 2] = [1e-2, 1e-6];
/// Rows that a thread takes at least.
const SHARE: usize = 256;

impl Known for Observable {
    fn find(name: &str) -> Option<Self> {
        Self::find(name)
    }

    fn names() -> Vec<String> {
        Self::names()
    }

    fn about(&self) -> [&'static str; 2] {
        [self.unit(), self.meaning()]
    }
}

/// The impacts of a case, one for each row of data.
pub(crate) struct Impacts<'a> {
    case: &'a OpenCase<'a, ImpactCase>,
    parameters: Vec<Parameter>,
    /// The offsets of the unknowns in the case.
    places: Vec<usize>,
    rows: Vec<Row>,
    /// What the unknowns are, if each is a number of the contact that the table takes.
    direct: Option<Vec<Direct>>,
    /// Its step of differences, and change of a sum that means nothing.
    smoothness: [f64; 2],
}

/// A row of the data, or several rows of one impact at several times.
#[derive(Default)]
struct Row {
    /// Its number, from 0.
    index: usize,
    /// The numbers of the case that it replaces.
    numbers: Vec<(usize, f64)>,
    /// What is measured: the place of the prediction, the quantity, and which of the readings of the clock it has.
    measured: Vec<(usize, Observable, usize)>,
    /// Readings of the clock, and the rows that they have; one impact has all that follow one another.
    readings: Vec<(f64, usize)>,
    /// The collision by the table, with the numbers of the contact that are not unknown.
    tabled: Option<(TabledCollision, [f64; 3])>,
}

impl Row {
    /// The first place of its predictions.
    fn place(&self) -> usize {
        self.measured.first().map_or(0, |(place, ..)| *place)
    }

    /// The history of the impact at its readings of the clock; empty if nothing of it is measured.
    fn course(&self, case: &ImpactCase) -> Result<Vec<HistoryPoint>, Error> {
        let is_needed = self.measured.iter().any(|(_, own, _)| own.is_of_instant());
        let Some([_, touch]) = case.clock.filter(|_| is_needed) else { return Ok(Vec::new()) };
        let mut order: Vec<usize> = (0..self.readings.len()).collect();
        order.sort_by(|i, j| self.readings[*i].0.total_cmp(&self.readings[*j].0));
        let times: Vec<f64> = order.iter().map(|i| self.readings[*i].0 - touch).collect();
        let points = course(case, times.as_slice())?;
        let mut points: Vec<(usize, HistoryPoint)> = order.into_iter().zip(points).collect();
        points.sort_by_key(|(i, _)| *i);
        Ok(points.into_iter().map(|(_, point)| point).collect())
    }
}

/// An unknown that the table takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Direct {
    Friction,
    StiffnessRatio,
    NormalRestitution,
}

impl Direct {
    fn of(field: &str) -> Option<Self> {
        Some(match field {
            "contact.friction" => Self::Friction,
            "contact.normal_over_tangential_stiffness" => Self::StiffnessRatio,
            "contact.normal_restitution" => Self::NormalRestitution,
            _ => return None,
        })
    }
}

impl<'a> Impacts<'a> {
    pub(crate) fn new(
        case: &'a OpenCase<'a, ImpactCase>,
        (parameters, places): (Vec<Parameter>, Vec<usize>),
        read: &Read<Observable>,
        measured: &[Measurement],
    ) -> Result<Self, FitError> {
        // The measured values follow one another row by row.
        let mut rows: Vec<Row> = Vec::new();
        for (place, one) in measured.iter().enumerate() {
            let number = |input: &Input| (input.place, input.values[one.row]);
            let numbers: Vec<_> =
                read.inputs.iter().filter(|own| !is_time(own)).map(number).collect();
            let reading =
                read.inputs.iter().find(|own| is_time(own)).map(|own| own.values[one.row]);
            let own = read.quantities[one.quantity].1;
            if reading.is_none() && own.is_of_instant() {
                return Err(without_time(&read.quantities[one.quantity].0.name));
            }
            let goes_on = |row: &Row| match reading {
                Some(_) => row.numbers == numbers,
                None => row.index == one.row,
            };
            if !rows.last().is_some_and(goes_on) {
                rows.push(Row { index: one.row, numbers, ..Row::default() });
            }
            let Some(row) = rows.last_mut() else { continue };
            if row.readings.last().is_none_or(|(_, last)| *last != one.row) {
                row.readings.extend(reading.map(|reading| (reading, one.row)));
            }
            row.measured.push((place, own, row.readings.len().saturating_sub(1)));
        }
        let direct = parameters.iter().map(|one| Direct::of(one.field)).collect();
        let mut impacts = Self { case, parameters, places, rows, direct, smoothness: SMOOTH };
        impacts.prepare()?;
        Ok(impacts)
    }

    /// Looks up the collision of each row, by the table where that holds.
    fn prepare(&mut self) -> Result<(), FitError> {
        // A loss in the middle would be computed for each row, and is not needed.
        let middle = |one: &Parameter| match Direct::of(one.field) {
            Some(Direct::NormalRestitution) => one.at(1.0),
            _ => one.at(0.5),
        };
        let nominal: Vec<f64> = self.parameters.iter().map(middle).collect();
        let is_friction = |one: &&Parameter| Direct::of(one.field) == Some(Direct::Friction);
        let friction = self.parameters.iter().find(is_friction);
        let ends = friction.map(|one| NEAR_BOUNDS.map(|x| one.at(x)));
        // The cause of a loss shows where there is one.
        let first = self.rows.first().map(|row| {
            let inner: Vec<f64> = self.parameters.iter().map(|one| one.at(0.5)).collect();
            self.case_of(row, &inner)
        });
        let Some(first) = first.transpose()? else { return Ok(()) };
        let loss = first.contact.normal_restitution.clone();
        if is_coarse(&first) {
            self.smoothness = COARSE;
        }
        let needs_outcome = |row: &Row| {
            row.measured.iter().any(|(_, own, _)| !matches!(own, Observable::Bounce(_)))
        };
        let find = |row: &Row| -> Result<Option<(TabledCollision, [f64; 3])>, FitError> {
            let case = self.case_of(row, &nominal)?;
            if case.collision.velocity().z <= 0.0 {
                return Err(FitError::NoImpact { row: row.index + 1 });
            }
            let is_direct = self.direct.is_some()
                && !needs_outcome(row)
                && has_analytic_law(&case)
                && ends.iter().flatten().all(|friction| is_analytic_with(&case, *friction));
            let tabled = is_direct.then(|| tabled(&case)).flatten();
            Ok(tabled.and_then(|(one, own)| Some((one.with_normal_restitution(&loss)?, own))))
        };
        let found: Vec<_> = self.rows.par_iter().map(find).collect::<Result<_, _>>()?;
        for (row, tabled) in self.rows.iter_mut().zip(found) {
            row.tabled = tabled;
        }
        Ok(())
    }

    fn case_of(&self, row: &Row, values: &[f64]) -> Result<ImpactCase, FitError> {
        let mut numbers = row.numbers.clone();
        numbers.extend(self.places.iter().copied().zip(values.iter().copied()));
        let failed = |error: CaseError| {
            let bounds = self.bounds_beside(&error.field);
            let source = Error::from(ErrorKind::from(error));
            match bounds {
                Some(bounds) => FitError::Bounds { bounds, source },
                None => FitError::Row { row: row.index + 1, source },
            }
        };
        self.case.case(&numbers).map_err(failed)
    }

    /// The bounds of all unknowns, if there are several and this one, each within its own, is out of its range: it must be by
    /// another one.
    fn bounds_beside(&self, field: &str) -> Option<String> {
        let all = &self.parameters;
        let of = |one: &Parameter| {
            let Unknown { low, high, .. } = one.unknown;
            format!("`{}` from {} to {}", one.field, Readable(low), Readable(high))
        };
        let is_unknown = all.iter().any(|one| one.field == field) && all.len() > 1;
        is_unknown.then(|| all.iter().map(of).collect::<Vec<_>>().join(" and "))
    }

    /// The predictions of a row: places and values.
    fn row(
        &self,
        row: &Row,
        values: &[f64],
        put: &mut dyn FnMut(usize, f64),
    ) -> Result<(), FitError> {
        let failed = |source: Error| FitError::Row { row: row.index + 1, source };
        if let (Some((tabled, own)), Some(direct)) = (&row.tabled, &self.direct) {
            let mut numbers = *own;
            direct.iter().zip(values).for_each(|(one, value)| numbers[*one as usize] = *value);
            let [friction, ratio, e] = numbers;
            let rebound = tabled.rebound(friction, ratio, e);
            let rebound = rebound
                .map_err(|error| failed(carom_numerical::CollisionLawError::from(error).into()))?;
            let bounce = Bounce::tabled(tabled, &rebound);
            row.measured
                .iter()
                .for_each(|(place, own, _)| put(*place, own.of(Some(&bounce), None, None)));
            return Ok(());
        }
        let case = self.case_of(row, values)?;
        let course = row.course(&case).map_err(failed)?;
        let outcome = match row.measured.iter().all(|(_, own, _)| own.is_of_instant()) {
            true => None,
            false => Some(outcome(&case).map_err(failed)?),
        };
        let bounce = match &outcome {
            Some(outcome) => Bounce::of(&case.collision, outcome).map(Some),
            None => Some(None),
        };
        let bounce = bounce.ok_or(FitError::NoImpact { row: row.index + 1 })?;
        for (place, own, at) in &row.measured {
            put(*place, own.of(bounce.as_ref(), outcome.as_ref(), course.get(*at)));
        }
        Ok(())
    }

    /// How many of the rows slide throughout with these values; none if that is not known of all of them.
    pub(crate) fn sliding(&self, values: &[f64]) -> Option<[usize; 2]> {
        let direct = self.direct.as_ref()?;
        let slides = |row: &Row| {
            let (tabled, own) = row.tabled.as_ref()?;
            let mut numbers = *own;
            direct.iter().zip(values).for_each(|(one, value)| numbers[*one as usize] = *value);
            Some(tabled.slides(numbers[0], numbers[1]))
        };
        let all: Option<Vec<bool>> = self.rows.iter().map(slides).collect();
        all.map(|all| [all.iter().filter(|slides| **slides).count(), all.len()])
    }
}

/// Whether this is the clock, which one impact has many readings of.
fn is_time(input: &Input) -> bool {
    input.field == "clock.time"
}

fn without_time(quantity: &str) -> FitError {
    let reason =
        "it is of an instant: the data need a column `time`, and the case `clock = { time = 0 }`";
    FitError::column(quantity, reason)
}

/// The collision of a case by the table; none if its law or its loss is not that of the table.
fn tabled(case: &ImpactCase) -> Option<(TabledCollision, [f64; 3])> {
    let tabled = case.collision.tabled().filter(|_| has_analytic_law(case))?;
    let ratio = tabled.stiffness_ratio();
    let friction = case.collision.friction().coefficient()?;
    let e = tabled.normal_restitution();
    Some((tabled, [friction, ratio, e]))
}

/// Whether the law of a case is one of those in closed form.
fn has_analytic_law(case: &ImpactCase) -> bool {
    match case.contact.law {
        CollisionLaw::Analytic(_) => true,
        CollisionLaw::Auto => case.collision.default_law() == NeededLaw::Analytic,
        _ => false,
    }
}

/// The same with another friction, on which it depends whether the coupling counts: the table must hold over its bounds.
fn is_analytic_with(case: &ImpactCase, friction: f64) -> bool {
    if case.contact.law != CollisionLaw::Auto {
        return true;
    }
    let changed = Friction::new(friction).and_then(|own| case.collision.clone().with_friction(own));
    changed.is_ok_and(|collision| collision.default_law() == NeededLaw::Analytic)
}

/// Places near the bounds of friction, from 0 to 1.
const NEAR_BOUNDS: [f64; 2] = [0.02, 0.98];

/// Whether the law of a case has an error that differences must bridge.
fn is_coarse(case: &ImpactCase) -> bool {
    match case.contact.law {
        CollisionLaw::Rings | CollisionLaw::Numerical => true,
        CollisionLaw::Analytic(_) => false,
        CollisionLaw::Auto => case.collision.default_law() != NeededLaw::Analytic,
    }
}

impl Model for Impacts<'_> {
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn count(&self) -> usize {
        self.rows.iter().map(|row| row.measured.len()).sum()
    }

    fn predict(&self, values: &[f64], into: &mut [f64]) -> Result<(), FitError> {
        if interrupt::is_wanted() {
            return Err(Error::from(ErrorKind::Interrupted).into());
        }
        let ask = interrupt::asked();
        let is_quick = self.rows.iter().all(|row| row.tabled.is_some());
        self.parts(into, if is_quick { SHARE } else { 1 }).into_par_iter().try_for_each(
            |(rows, into)| {
                interrupt::under(ask.clone(), || {
                    let first = rows.first().map_or(0, Row::place);
                    let mut put = |place: usize, value: f64| into[place - first] = value;
                    rows.iter().try_for_each(|row| self.row(row, values, &mut put))
                })
            },
        )?;
        match into.iter().position(|value| !value.is_finite()) {
            None => Ok(()),
            Some(place) => Err(FitError::Undefined { row: self.row_of(place) + 1 }),
        }
    }

    fn step(&self) -> f64 {
        self.smoothness[0]
    }

    fn jitter(&self) -> f64 {
        self.smoothness[1]
    }
}

impl Impacts<'_> {
    /// Rows with the places of their predictions, which follow one another as the rows do.
    fn parts<'b>(&self, mut rest: &'b mut [f64], share: usize) -> Vec<(&[Row], &'b mut [f64])> {
        let mut parts = Vec::with_capacity(self.rows.len().div_ceil(share));
        for rows in self.rows.chunks(share) {
            let count = rows.iter().map(|row| row.measured.len()).sum();
            let (own, others) = rest.split_at_mut(count);
            parts.push((rows, own));
            rest = others;
        }
        parts
    }

    fn row_of(&self, place: usize) -> usize {
        let of = |row: &Row| {
            let (.., at) = row.measured.iter().find(|(own, ..)| *own == place)?;
            Some(row.readings.get(*at).map_or(row.index, |(_, row)| *row))
        };
        self.rows.iter().find_map(of).unwrap_or(0)
    }
}
