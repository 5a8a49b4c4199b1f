//! Computes the impact of a case, or all impacts of its sweep.

use crate::Error;
use crate::case::{CaseError, ImpactCase, ImpactFile, Input};
use crate::input::CaseFile;
use carom_impact::{CollisionError, HistoryPoint, Outcome};
use carom_numerical::CollisionLawError;
use carom_special::interrupt;
use rayon::prelude::*;
use std::path::Path;

/// The impacts of a case.
#[derive(Debug)]
pub struct Followed {
    /// Name, unit and values of the swept number, if there is a sweep.
    pub swept: Option<(&'static str, &'static str, Vec<f64>)>,
    /// The outcome of each impact.
    pub outcomes: Vec<Outcome>,
}

/// Computes the impact of a case, or all impacts of its sweep in parallel.
///
/// # Errors
/// If the case has an error or `[uncertainty]`, or an impact cannot be computed.
pub fn followed(file: &CaseFile) -> Result<Followed, Error> {
    let (path, file) = (&file.path, file.parse(ImpactFile::parse)?);
    if file.uncertainty().is_some() {
        return Err(Error::Uncertainty { path: path.clone() });
    }
    let Some((input, values)) = file.sweep() else {
        return Ok(Followed { swept: None, outcomes: vec![outcome(path, file.nominal())?] });
    };
    let ask = interrupt::asked();
    let outcome = |value: &f64| {
        interrupt::under(ask.clone(), || match interrupt::is_wanted() {
            true => Err(Error::Interrupted),
            false => outcome(path, &swept(path, &file, *value)?),
        })
    };
    let outcomes = values.par_iter().map(outcome).collect::<Result<_, _>>()?;
    Ok(Followed { swept: Some((name(input), input.unit, values.to_vec())), outcomes })
}

/// The name of the swept number in the results; the angle of incidence has a short one.
#[must_use]
pub fn name(input: &Input) -> &'static str {
    if input.field == "approach.angle" { "angle" } else { input.field }
}

/// The case at one value of its sweep.
///
/// # Errors
/// [`Error::Case`] if the value is not allowed.
pub fn swept(path: &Path, file: &ImpactFile<'_>, value: f64) -> Result<ImpactCase, Error> {
    file.case(&[value]).map_err(|source| refused(path, source))
}

/// Computes the outcome of a case.
///
/// # Errors
/// [`Error::Collision`], [`Error::CollisionLaw`] if it cannot be computed; [`Error::Case`] if its torsion
/// cannot be computed.
pub fn outcome(path: &Path, case: &ImpactCase) -> Result<Outcome, Error> {
    case.contact.law.solve(&case.collision).map_err(|source| blamed(path, case, source))
}

/// The history of an impact at `count` instants.
///
/// # Errors
/// As [`outcome`].
pub fn course(path: &Path, case: &ImpactCase, count: usize) -> Result<Vec<HistoryPoint>, Error> {
    case.contact.law.history(&case.collision, count).map_err(|source| blamed(path, case, source))
}

/// Reports torsion that cannot be computed as an error of the case.
fn blamed(path: &Path, case: &ImpactCase, source: CollisionLawError) -> Error {
    match (source, case.contact.torsion_line) {
        (CollisionLawError::Collision(CollisionError::NormalSpin(source)), line @ 1..) => {
            refused(path, CaseError::Torsion { line, source: Box::new(source) })
        }
        (CollisionLawError::Collision(source), _) => {
            Error::Collision { path: path.to_owned(), source: Box::new(source) }
        }
        (source, _) => Error::CollisionLaw { path: path.to_owned(), source: Box::new(source) },
    }
}

fn refused(path: &Path, source: CaseError) -> Error {
    let message = source.to_string();
    Error::Case { path: path.to_owned(), source: Box::new(source), message }
}
