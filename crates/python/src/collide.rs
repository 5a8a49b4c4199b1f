//! Collisions, one or many.

use carom::impact::{
    Body as Colliding, Collision, CollisionError, HistoryPoint, ImpactFriction, LossCause,
    NormalRestitution, Outcome, ReboundDerivatives, RestitutionBySpeed, TorsionMode,
};
use carom::numerical::CollisionLaw;
use carom::special::{RangeError, WordError};
use carom_cases::theory::readable;

use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Numbers, Rows, map_by, same_length};
use crate::bodies::{Body, motion};
use crate::error::Fault;
use crate::friction::{Beside, checked};
use crate::quantities::{In, Normal, Row, Tolerance};
use crate::records::{self, arrays};
use crate::room;
use crate::threads::without_python;
use crate::told::{Told, of_impacts};

/// Least number of impacts for a thread: an exact impact takes some microseconds, a stepped one much longer.
const SHARE: usize = 8;

/// Speeds and restitutions of a restitution by speed.
type Table = (Vec<f64>, Vec<f64>);

/// Options of a collision.
#[derive(Clone)]
struct Way {
    normal: Option<[f64; 3]>,
    torsion: TorsionMode,
    law: CollisionLaw,
    tolerance: Option<f64>,
    loss: NormalRestitution,
}

/// What the number of a loss in the material is.
enum Loss {
    Waves,
    Relaxation,
    Restitution(LossCause),
    BySpeed(NormalRestitution),
}

impl Loss {
    fn new(cause: &str, table: Option<Table>) -> PyResult<Self> {
        let of = |cause: &str| cause.parse::<LossCause>();
        match cause {
            "waves" => return Ok(Self::Waves),
            "relaxation" => return Ok(Self::Relaxation),
            _ => {}
        }
        let cause = of(cause).map_err(|error| PyValueError::new_err(error.to_string()))?;
        let Some(table) = table else { return Ok(Self::Restitution(cause)) };
        let by_speed = by_speed(&table).and_then(|table| NormalRestitution::by_speed(cause, table));
        Ok(Self::BySpeed(by_speed.map_err(Fault::from)?))
    }

    fn with(&self, value: f64) -> Result<NormalRestitution, RangeError> {
        match self {
            Self::Waves => Ok(NormalRestitution::by_waves()),
            Self::Relaxation => NormalRestitution::viscoelastic(value),
            Self::Restitution(cause) => NormalRestitution::by(*cause, value),
            Self::BySpeed(loss) => Ok(loss.clone()),
        }
    }
}

fn by_speed((speeds, restitutions): &Table) -> Result<RestitutionBySpeed, RangeError> {
    RestitutionBySpeed::new(speeds, restitutions)
}

/// The restitutions of a restitution by speed, at these speeds.
#[pyfunction]
pub(crate) fn restitution_by_speed(table: Table, speeds: Vec<f64>) -> PyResult<Vec<f64>> {
    let table = by_speed(&table).map_err(Fault::from)?;
    Ok(speeds.into_iter().map(|speed| table.at(speed)).collect())
}

impl Way {
    fn new(
        normal: Option<Row<Normal, 3>>,
        torsion: Option<bool>,
        law: &str,
        tolerance: Option<In<Tolerance>>,
    ) -> PyResult<Self> {
        let (normal, tolerance) = (normal.map(|normal| normal.0), tolerance.map(|given| given.0));
        let torsion = torsion.into();
        let law = law.parse();
        let law = law.map_err(|error: WordError| PyValueError::new_err(error.to_string()))?;
        Ok(Self { normal, torsion, law, tolerance, loss: NormalRestitution::ELASTIC })
    }

    /// The same with a loss in the material.
    fn losing(self, loss: NormalRestitution) -> Self {
        Self { loss, ..self }
    }

    fn collision(
        &self,
        one: Colliding,
        two: Colliding,
        friction: ImpactFriction,
    ) -> Result<Collision, Fault> {
        let mut collision = match self.normal {
            Some(normal) => Collision::along(one, two, normal, friction)?,
            None => Collision::touching(one, two, friction)?,
        };
        collision = collision.with_normal_restitution(self.loss.clone());
        if let Some(tolerance) = self.tolerance {
            collision = collision.within(tolerance)?;
        }
        Ok(collision.with_torsion_mode(self.torsion))
    }
}

/// Why there is no impact, and what to do about it; empty if there is one.
fn missed(collision: &Collision, outcome: &Outcome) -> String {
    if outcome.rebound().is_some() {
        return String::new();
    }
    // That of body 2 against body 1, along the normal into body 1.
    let speed = collision.velocity().z;
    let (how, way_out) = match speed < 0.0 {
        true => (
            format!("move apart at {} m/s", readable(-speed)),
            "exchange the bodies, or change the sign of a velocity",
        ),
        false => ("have no speed".to_owned(), "give a body a `velocity` along it"),
    };
    let [x, y, z] = <[f64; 3]>::from(collision.frame().z()).map(readable);
    format!(
        "no impact: the bodies {how} along the normal ({x}, {y}, {z}), which points from body 2 into body 1:\n\
         {way_out}"
    )
}

/// Computes the collision of two bodies; also gives its warnings, and why there is no impact.
#[pyfunction]
#[allow(clippy::too_many_arguments)] // named ones, in Python
pub(crate) fn collide<'py>(
    py: Python<'py>,
    body_1: Body,
    body_2: Body,
    friction: f64,
    beside: Beside,
    normal: Option<Row<Normal, 3>>,
    torsion: Option<bool>,
    law: &str,
    tolerance: Option<In<Tolerance>>,
    loss: (String, f64, Option<Table>),
) -> PyResult<(Bound<'py, PyDict>, Told, String)> {
    let (cause, value, table) = loss;
    let lost = Loss::new(&cause, table)?.with(value).map_err(Fault::from)?;
    let way = Way::new(normal, torsion, law, tolerance)?.losing(lost);
    let (one, two) = (body_1.colliding()?, body_2.colliding()?);
    let solve = || -> Result<(Outcome, String), Fault> {
        let collision = way.collision(one, two, checked(friction, beside)?)?;
        let outcome = way.law.solve(&collision)?;
        let missed = missed(&collision, &outcome);
        Ok((outcome, missed))
    };
    let (outcome, missed) = without_python(py, solve)??;
    let (columns, warnings) = told(py, &[outcome])?;
    Ok((columns, warnings, missed))
}

/// Computes the collisions of two bodies for many motions; also gives their warnings. Friction by the slip speed replaces
/// the coefficients.
#[pyfunction]
#[allow(clippy::too_many_arguments)] // named ones, in Python
pub(crate) fn collide_many<'py>(
    py: Python<'py>,
    body_1: Body,
    body_2: Body,
    friction: Numbers<'py>,
    beside: (Option<[f64; 3]>, Option<Numbers<'py>>),
    motions: [Rows<'py>; 4],
    normal: Option<Row<Normal, 3>>,
    torsion: Option<bool>,
    law: &str,
    tolerance: Option<In<Tolerance>>,
    loss: (String, Numbers<'py>, Option<Table>),
) -> PyResult<(Bound<'py, PyDict>, Told)> {
    let way = Way::new(normal, torsion, law, tolerance)?;
    let (cause, values, table) = loss;
    let (cause, values) = (Loss::new(&cause, table)?, values.as_slice()?);
    let (one, two) = (body_1.colliding()?, body_2.colliding()?);
    let friction = friction.as_slice()?;
    let (by_speed, at_rest) = &beside;
    let at_rest = at_rest.as_ref().map(|numbers| numbers.as_slice()).transpose()?;
    if let Some(at_rest) = at_rest {
        same_length("static_friction", at_rest.len(), friction.len())?;
    }
    let mut rows: [&[[f64; 3]]; 4] = [&[]; 4];
    for (rows, motion) in rows.iter_mut().zip(&motions) {
        *rows = motion.as_slice()?.as_chunks().0;
        same_length("motion", rows.len(), friction.len())?;
    }
    same_length("normal_restitution", values.len(), friction.len())?;
    // One material for all is made once.
    let first = values.first().map(|value| cause.with(*value)).transpose().map_err(Fault::from)?;
    let lost = |value: f64| match &first {
        Some(lost) if value == values[0] => Ok(lost.clone()),
        _ => cause.with(value),
    };
    let [v_1, w_1, v_2, w_2] = rows;
    let outcomes = map_by(SHARE, py, friction.len(), |i| {
        let one = one.clone().moving(motion(v_1[i], w_1[i])?);
        let two = two.clone().moving(motion(v_2[i], w_2[i])?);
        let way = way.clone().losing(lost(values[i])?);
        Ok(way.law.solve(&way.collision(
            one,
            two,
            checked(friction[i], (*by_speed, at_rest.map(|at_rest| at_rest[i])))?,
        )?)?)
    })?;
    told(py, &outcomes)
}

/// Velocities and spins after a collision, their derivatives row by row, whether these are of one side, and warnings.
type Derivatives<'py> = (Vec<f64>, Bound<'py, PyArray1<f64>>, bool, Told);

/// The rebound of spheres and planes with its derivatives by all inputs; none where the theory is not closed.
#[pyfunction]
#[pyo3(signature = (body_1, body_2, friction, normal, kappa))]
pub(crate) fn rebound_derivatives<'py>(
    py: Python<'py>,
    body_1: Body,
    body_2: Body,
    friction: f64,
    normal: Option<Row<Normal, 3>>,
    kappa: Option<f64>,
) -> PyResult<Option<Derivatives<'py>>> {
    let way = Way::new(normal, Some(false), CollisionLaw::default().name(), None)?;
    let (one, two) = (body_1.colliding()?, body_2.colliding()?);
    let solve = || -> Result<Option<(ReboundDerivatives, Outcome)>, Fault> {
        let collision = way.collision(one, two, checked(friction, (None, None))?)?;
        let collision = match kappa {
            Some(kappa) => collision.with_stiffness_ratio(kappa).map_err(of_kappa)?,
            None => collision,
        };
        let found = collision.derivatives().map_err(|error| match error {
            CollisionError::Range(error) => CollisionError::Range(of_kappa(error)),
            error => error,
        });
        let Some(found) = found? else { return Ok(None) };
        Ok(Some((found, collision.solve()?)))
    };
    let Some((found, outcome)) = solve()? else { return Ok(None) };
    let motions = found.motions.iter().flat_map(|one| one.velocity.iter().chain(&one.spin));
    let rows: Vec<f64> = found.matrix.transpose().iter().copied().collect();
    let (values, rows) = (motions.copied().collect(), PyArray1::from_vec(py, rows));
    Ok(Some((values, rows, found.is_at_change, of_impacts(&[outcome]))))
}

/// The error with the name that the ratio of stiffnesses has here.
fn of_kappa(error: RangeError) -> RangeError {
    match error.field {
        "normal_over_tangential_stiffness" => RangeError { field: "kappa", ..error },
        _ => error,
    }
}

/// The outcomes as arrays, and their warnings.
fn told<'py>(py: Python<'py>, outcomes: &[Outcome]) -> PyResult<(Bound<'py, PyDict>, Told)> {
    Ok((arrays(py, Outcome::COLUMNS, outcomes)?, of_impacts(outcomes)))
}

/// The history of a collision at equally spaced instants; also gives its warnings, and why there is none.
#[pyfunction]
#[allow(clippy::too_many_arguments)] // named ones, in Python
pub(crate) fn history<'py>(
    py: Python<'py>,
    body_1: Body,
    body_2: Body,
    friction: f64,
    beside: Beside,
    points: usize,
    normal: Option<Row<Normal, 3>>,
    law: &str,
    tolerance: Option<In<Tolerance>>,
    loss: (String, f64, Option<Table>),
) -> PyResult<(Bound<'py, PyDict>, Told, String)> {
    let (cause, value, table) = loss;
    let lost = Loss::new(&cause, table)?.with(value).map_err(Fault::from)?;
    let way = Way::new(normal, None, law, tolerance)?.losing(lost);
    room::check("points", points, records::bytes(HistoryPoint::COLUMNS))?;
    let (one, two) = (body_1.colliding()?, body_2.colliding()?);
    let trace = || -> Result<(Vec<HistoryPoint>, Outcome, String), Fault> {
        let collision = way.collision(one, two, checked(friction, beside)?)?;
        let outcome = way.law.solve(&collision)?;
        let missed = missed(&collision, &outcome);
        Ok((way.law.history(&collision, points)?, outcome, missed))
    };
    let (course, outcome, missed) = without_python(py, trace)??;
    Ok((arrays(py, HistoryPoint::COLUMNS, &course)?, of_impacts(&[outcome]), missed))
}
