//! The model of contacts under normal load: forces over approach, with an unknown point of contact.

use crate::FitError;
use crate::columns::{Input, Known, Read};
use crate::measured::Measurement;
use crate::model::{Model, Parameter};
use carom_cases::case::{Given, HertzCase, OpenCase};
use carom_cases::{Error, ErrorKind, Pressed};

/// Relative step of differences of closed forms.
const STEP: f64 = 1e-5;

/// A quantity of a contact under load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pressing {
    Force,
    Approach,
    PeakPressure,
}

const ALL: [(Pressing, &str, &str, &str); 3] = [
    (Pressing::Force, "force", "N", "normal force"),
    (Pressing::Approach, "approach", "m", "approach of distant points"),
    (Pressing::PeakPressure, "peak_pressure", "Pa", "greatest pressure"),
];

impl Known for Pressing {
    fn find(name: &str) -> Option<Self> {
        ALL.iter().find(|(_, own, ..)| *own == name).map(|(own, ..)| *own)
    }

    fn names() -> Vec<String> {
        ALL.iter().map(|(_, name, ..)| (*name).to_owned()).collect()
    }

    fn about(&self) -> [&'static str; 2] {
        let own = ALL.iter().find(|(own, ..)| own == self);
        own.map_or(["", ""], |(_, _, unit, meaning)| [unit, meaning])
    }
}

impl Pressing {
    /// The quantity of a contact; 0 where the bodies do not touch.
    fn of(self, state: Option<&Pressed>) -> f64 {
        let Some(state) = state else { return 0.0 };
        match self {
            Self::Force => state.force(),
            Self::Approach => state.approach(),
            Self::PeakPressure => state.peak_pressure(),
        }
    }
}

/// The contacts of a case, one for each row of data.
pub(crate) struct Contacts<'a> {
    case: &'a OpenCase<'a, HertzCase>,
    parameters: Vec<Parameter>,
    places: Vec<usize>,
    given: Given,
    /// The load of each measured value, and what is measured.
    loads: Vec<(f64, Pressing, usize)>,
}

impl<'a> Contacts<'a> {
    pub(crate) fn new(
        case: &'a OpenCase<'a, HertzCase>,
        (parameters, places): (Vec<Parameter>, Vec<usize>),
        read: &Read<Pressing>,
        measured: &[Measurement],
    ) -> Result<Self, FitError> {
        let [Input { values, .. }] = read.inputs.as_slice() else {
            let reason = "a contact needs one column of its load, `load.approach` or `load.force`";
            return Err(FitError::Table(reason.to_owned()));
        };
        let load = |one: &Measurement| (values[one.row], read.quantities[one.quantity].1, one.row);
        let loads = measured.iter().map(load).collect();
        Ok(Self { case, parameters, places, given: case.nominal().given, loads })
    }
}

impl Model for Contacts<'_> {
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn count(&self) -> usize {
        self.loads.len()
    }

    fn predict(&self, values: &[f64], into: &mut [f64]) -> Result<(), FitError> {
        let numbers: Vec<(usize, f64)> =
            self.places.iter().copied().zip(values.iter().copied()).collect();
        let case = self.case.case(&numbers).map_err(|error| Error::from(ErrorKind::from(error)))?;
        for (place, (reading, own, row)) in into.iter_mut().zip(&self.loads) {
            let load = reading - if self.given == Given::Approach { case.touch } else { 0.0 };
            let failed = |source| FitError::Row { row: row + 1, source: Error::from(source) };
            let state = match load > 0.0 {
                true => Some(case.contact.at(self.given, load).map_err(failed)?),
                // They do not touch.
                false => None,
            };
            *place = own.of(state.as_ref());
        }
        Ok(())
    }

    fn step(&self) -> f64 {
        STEP
    }

    fn jitter(&self) -> f64 {
        f64::EPSILON
    }
}
