//! A contact under each of its normal loads.

use crate::Error;
use crate::case::{Given, HertzCase};
use crate::input::CaseFile;
use crate::theory::{ValidityReport, readable};
use carom_laws::hertz::{Hertz, HertzState};
use carom_laws::validity::Validity;
use carom_special::RangeError;

/// The contact of a case under each of its loads.
#[derive(Debug, Clone)]
pub struct Followed {
    /// The case.
    pub case: HertzCase,
    /// The contact under each load.
    pub states: Vec<HertzState>,
}

impl Followed {
    /// How far each loaded contact is from the limits of the theory.
    #[must_use]
    pub fn validities(&self) -> Vec<Validity> {
        let HertzCase { hertz, smallest_radius, .. } = &self.case;
        let of = |state| Validity::of_hertz(hertz, state, *smallest_radius);
        self.states.iter().map(of).collect()
    }

    /// What the contacts exceed.
    #[must_use]
    pub fn validity_report(&self) -> ValidityReport {
        let mut report = ValidityReport::default();
        for (state, validity) in self.states.iter().zip(self.validities()) {
            report.add(|| format!("at {} N", readable(state.force)), validity);
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
    let loaded = |value: &f64| Ok(loaded(&case.hertz, case.given, *value)?);
    let states = file.follow(|| case.values.as_slice().iter().map(loaded).collect())?;
    Ok(Followed { case, states })
}

fn loaded(hertz: &Hertz, given: Given, value: f64) -> Result<HertzState, RangeError> {
    match given {
        Given::Force => hertz.at_force(value),
        Given::Approach => hertz.at_approach(value),
        Given::SemiAxisA => hertz.at_semi_axis_a(value),
        Given::SemiAxisB => hertz.at_semi_axis_b(value),
    }
}
