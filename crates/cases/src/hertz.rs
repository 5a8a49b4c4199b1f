//! A contact under each of its normal loads.

use crate::Error;
use crate::case::{Given, HertzCase};
use crate::input::CaseFile;
use crate::theory::{Excess, Warnings, large_contact, readable};
use carom_laws::hertz::{Hertz, HertzState};
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
    /// By how much each loaded contact exceeds the limits of the theory.
    #[must_use]
    pub fn excesses(&self) -> Vec<Excess> {
        let radius = smallest_radius(&self.case.hertz);
        self.states.iter().map(|state| Excess::of_contact(state.approach, radius)).collect()
    }

    /// Warnings on contacts that are large for their bodies.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = Warnings::default();
        for state in &self.states {
            let semi_axis = state.ellipse.semi_axis_a().max(state.ellipse.semi_axis_b());
            let large = large_contact(semi_axis, self.case.smallest_radius);
            warnings.add(|| format!("at {} N", readable(state.force)), large.as_slice());
        }
        warnings.told("loads")
    }
}

/// Computes the contact under each of its loads.
///
/// # Errors
/// If the case has an error, or a load is out of range.
pub fn followed(file: &CaseFile) -> Result<Followed, Error> {
    let case = file.parse(HertzCase::parse)?;
    let at_fault = |source| Error::Law { path: file.path.clone(), source };
    let loaded = |value: &f64| loaded(&case.hertz, case.given, *value);
    let states = case.values.as_slice().iter().map(loaded).collect::<Result<_, _>>();
    let states = states.map_err(at_fault)?;
    Ok(Followed { case, states })
}

/// The smaller principal radius of the gap.
#[must_use]
pub fn smallest_radius(hertz: &Hertz) -> f64 {
    0.5 / hertz.curvature().a()
}

fn loaded(hertz: &Hertz, given: Given, value: f64) -> Result<HertzState, RangeError> {
    match given {
        Given::Force => hertz.at_force(value),
        Given::Approach => hertz.at_approach(value),
        Given::SemiAxisA => hertz.at_semi_axis_a(value),
        Given::SemiAxisB => hertz.at_semi_axis_b(value),
    }
}
