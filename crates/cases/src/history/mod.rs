//! A contact along a history of shifts and twists.

mod laws;
mod step;
mod steps;
mod twist;

pub use laws::{Laws, is_twisted};
pub use step::{
    COLUMNS, Step, TRACTION_COLUMNS, TWIST_COLUMNS, Traction, all_columns, columns, is_circle, step,
};
pub use steps::{StepsError, read as read_steps};
pub use twist::Twist;

use crate::case::{HistoryCase, Steps};
use crate::input::CaseFile;
use crate::theory::ValidityReport;
use crate::{Error, ErrorKind};
use carom_laws::law::Shift;

/// Reads the shifts of a case; a file that it names is relative to the case file.
///
/// # Errors
/// As [`read_steps`], if a step of a file has a twist under static friction, and if a number of the case is unknown.
pub fn shifts(file: &CaseFile, case: &HistoryCase) -> Result<Vec<Shift>, Error> {
    if let Some(unknown) = case.unknowns.first() {
        return Err(Error::from(ErrorKind::Unknown(unknown.field)).of_file(&file.path));
    }
    match &case.steps {
        Steps::Inline(shifts) => Ok(shifts.clone()),
        Steps::File(name) => {
            let shifts = read_steps(file, name)?;
            case.check_twist(&shifts)
                .map_err(|source| Error::from(source).of_file(&file.beside(name)))?;
            Ok(shifts)
        }
    }
}

/// The contact of a case after each step.
#[derive(Debug, Clone)]
pub struct Followed {
    /// The case.
    pub case: HistoryCase,
    /// The contact after each step.
    pub steps: Vec<Step>,
}

impl Followed {
    /// What the contacts exceed.
    #[must_use]
    pub fn validity_report(&self) -> ValidityReport {
        let mut report = ValidityReport::default();
        self.steps.iter().for_each(|step| step.add_to(&mut report, &self.case));
        report
    }
}

/// Computes the contact after each step of a history; files that the case names are relative to it.
///
/// # Errors
/// If the case has an error, a file cannot be read, or a law rejects a value.
pub fn followed(file: &CaseFile) -> Result<Followed, Error> {
    let case = file.parse::<HistoryCase>()?;
    let shifts = shifts(file, &case)?;
    let steps = file.follow(|| {
        let mut laws = Laws::new(&case, &shifts)?;
        let after = |(i, shift): (usize, &Shift)| {
            laws.advance(*shift)?;
            step((i + 1) as f64, &laws, case.friction, 0)
        };
        shifts.iter().enumerate().map(after).collect()
    })?;
    Ok(Followed { case, steps })
}
