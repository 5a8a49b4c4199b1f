//! Computes the impact of a case, or all impacts of its sweep.

use crate::case::{CaseFault, ImpactCase, ImpactFile, Input};
use crate::input::CaseFile;
use crate::{Error, ErrorKind};
use carom_impact::{CollisionError, HistoryPoint, Instants, Outcome};
use carom_numerical::CollisionLawError;
use carom_special::interrupt;
use rayon::prelude::*;

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
    let case = file.parse::<ImpactFile<'_>>()?;
    file.follow(|| {
        check_known(&case)?;
        if case.uncertainty().is_some() {
            return Err(ErrorKind::Uncertainty.into());
        }
        let Some((input, values)) = case.sweep() else {
            return Ok(Followed { swept: None, outcomes: vec![outcome(case.nominal())?] });
        };
        let ask = interrupt::asked();
        let outcome = |value: &f64| {
            interrupt::under(ask.clone(), || match interrupt::is_wanted() {
                true => Err(ErrorKind::Interrupted.into()),
                false => outcome(&case.case(&[*value])?),
            })
        };
        let outcomes = values.par_iter().map(outcome).collect::<Result<_, _>>()?;
        Ok(Followed { swept: Some((name(input), input.unit, values.to_vec())), outcomes })
    })
}

/// Checks that a case has no unknowns.
///
/// # Errors
/// [`ErrorKind::Unknown`] with the first of them.
pub fn check_known(case: &ImpactFile<'_>) -> Result<(), Error> {
    let unknown = case.inputs().iter().find(|input| input.unknown().is_some());
    unknown.map_or(Ok(()), |input| Err(ErrorKind::Unknown(input.field).into()))
}

/// The name of the swept number in the results; the angle of incidence has a short one.
#[must_use]
pub fn name(input: &Input) -> &'static str {
    if input.field == "approach.angle" { "angle" } else { input.field }
}

/// Computes the outcome of a case.
///
/// # Errors
/// [`ErrorKind::Collision`] if it cannot be computed; [`ErrorKind::Case`] if its torsion cannot be computed.
pub fn outcome(case: &ImpactCase) -> Result<Outcome, Error> {
    case.contact.law.solve(&case.collision).map_err(|source| blamed(case, source))
}

/// The history of an impact at so many instants, or at given times.
///
/// # Errors
/// As [`outcome`].
pub fn course<'a>(
    case: &ImpactCase,
    instants: impl Into<Instants<'a>>,
) -> Result<Vec<HistoryPoint>, Error> {
    case.contact.law.history(&case.collision, instants).map_err(|source| blamed(case, source))
}

/// Reports torsion that cannot be computed as an error of the case.
fn blamed(case: &ImpactCase, source: CollisionLawError) -> Error {
    match (source, case.contact.torsion_line) {
        (CollisionLawError::Collision(CollisionError::NormalSpin(source)), line @ 1..) => {
            CaseFault::Torsion(Box::new(source)).at("contact.torsion", line).into()
        }
        (source, _) => source.into(),
    }
}
