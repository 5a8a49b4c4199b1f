//! A contact under each of its normal loads.

use crate::Pressed;
use crate::case::HertzCase;
use crate::input::CaseFile;
use crate::theory::{ValidityReport, readable};
use crate::{Error, ErrorKind};
use carom_laws::validity::Validity;
use carom_table::Cell;

/// The contact of a case under each of its loads.
#[derive(Debug, Clone)]
pub struct Followed {
    /// The case.
    pub case: HertzCase,
    /// The contact under each load.
    pub states: Vec<Pressed>,
}

impl Followed {
    /// How far each loaded contact is from the limits of the theory.
    #[must_use]
    pub fn validities(&self) -> Vec<Validity> {
        let HertzCase { contact, smallest_radius, .. } = &self.case;
        self.states.iter().map(|state| state.validity(contact, *smallest_radius)).collect()
    }

    /// The quantities under each load, and the peak pressure over its limit.
    #[must_use]
    pub fn cells(&self) -> Vec<Vec<Cell>> {
        let row = |(state, validity): (&Pressed, Validity)| {
            let mut cells = state.cells();
            cells.push(Validity::OVER_YIELD.cell(Some(&validity)));
            cells
        };
        self.states.iter().zip(self.validities()).map(row).collect()
    }

    /// What the contacts exceed.
    #[must_use]
    pub fn validity_report(&self) -> ValidityReport {
        let mut report = ValidityReport::default();
        for (state, validity) in self.states.iter().zip(self.validities()) {
            report.add(|| format!("at {} N", readable(state.force())), validity);
        }
        report
    }
}

/// Computes the contact under each of its loads.
///
/// # Errors
/// If the case has an error, or a load is out of range.
pub fn followed(file: &CaseFile) -> Result<Followed, Error> {
    let case = file.parse::<HertzCase>()?;
    if let Some(unknown) = case.unknowns.first() {
        return Err(Error::from(ErrorKind::Unknown(unknown.field)).of_file(&file.path));
    }
    let loaded = |value: &f64| Ok(case.contact.at(case.given, *value)?);
    let states = file.follow(|| case.values.as_slice().iter().map(loaded).collect())?;
    Ok(Followed { case, states })
}
