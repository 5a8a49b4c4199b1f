//! The model of a contact under a history of shifts: loads after each step, with an unknown point of contact.

use crate::FitError;
use crate::columns::{Input, Known, Read};
use crate::measured::Measurement;
use crate::model::{Model, Parameter};
use crate::observable::Part;
use carom_cases::Error;
use carom_cases::case::{HistoryCase, OpenCase, Steps};
use carom_cases::history::{COLUMNS, Laws, Step, TWIST_COLUMNS, step};
use carom_laws::law::Shift;

/// Relative steps of differences, and changes of sums that mean nothing: where the shift keeps its direction, and where it
/// turns, which is followed to a tolerance.
const STRAIGHT: [f64; 2] = [2e-3, 1e-13];
const TURNING: [f64; 2] = [1e-2, 1e-6];
/// What the rows give.
const INPUTS: [&str; 5] = ["step", "zeta", "xi", "eta", "omega"];

impl Known for Part<Step> {
    fn find(name: &str) -> Option<Self> {
        let tables = [COLUMNS, TWIST_COLUMNS].into_iter().filter(|_| !INPUTS.contains(&name));
        tables.into_iter().find_map(|columns| Self::find(columns, name))
    }

    fn names() -> Vec<String> {
        let all = [COLUMNS, TWIST_COLUMNS].into_iter().flat_map(carom_table::heads);
        all.filter(|name| !INPUTS.contains(&name.as_str())).collect()
    }

    fn about(&self) -> [&'static str; 2] {
        [self.unit(), self.meaning()]
    }
}

/// A contact whose steps are the rows of data.
pub(crate) struct Histories<'a> {
    case: &'a OpenCase<'a, HistoryCase>,
    parameters: Vec<Parameter>,
    places: Vec<usize>,
    /// The shifts of the rows; zeta as it was read.
    readings: Vec<Shift>,
    /// The row of each measured value, and what is measured.
    measured: Vec<(usize, Part<Step>)>,
    smoothness: [f64; 2],
}

impl<'a> Histories<'a> {
    pub(crate) fn new(
        case: &'a OpenCase<'a, HistoryCase>,
        (parameters, places): (Vec<Parameter>, Vec<usize>),
        read: &Read<Part<Step>>,
        measured: &[Measurement],
    ) -> Result<Self, FitError> {
        let base = match &case.nominal().steps {
            Steps::Inline(steps) => steps.first().copied().unwrap_or_default(),
            Steps::File(_) => Shift::default(),
        };
        let base = Shift { zeta: base.zeta + case.nominal().touch, ..base };
        let rows = read.inputs.first().map_or(0, |input| input.values.len());
        let mut readings = vec![base; rows];
        for Input { field, values, .. } in &read.inputs {
            for (reading, value) in readings.iter_mut().zip(values) {
                *match *field {
                    "history.zeta" => &mut reading.zeta,
                    "history.xi" => &mut reading.xi,
                    "history.eta" => &mut reading.eta,
                    "history.omega" => &mut reading.omega,
                    _ => {
                        let reason =
                            "all rows are steps of one history, which have one value of it";
                        return Err(FitError::column(*field, reason));
                    }
                } = *value;
            }
        }
        if rows == 0 {
            let reason = "a history needs a column of its steps, `zeta`, `xi` or `eta`, and the case \
                          `history = { zeta = 0, xi = 0 }`";
            return Err(FitError::Table(reason.to_owned()));
        }
        let turns = readings.iter().any(|reading| reading.eta != 0.0);
        let smoothness = if turns { TURNING } else { STRAIGHT };
        let of = |one: &Measurement| (one.row, read.quantities[one.quantity].1);
        let measured = measured.iter().map(of).collect();
        Ok(Self { case, parameters, places, readings, measured, smoothness })
    }
}

impl Model for Histories<'_> {
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn count(&self) -> usize {
        self.measured.len()
    }

    fn predict(&self, values: &[f64], into: &mut [f64]) -> Result<(), FitError> {
        let numbers: Vec<(usize, f64)> =
            self.places.iter().copied().zip(values.iter().copied()).collect();
        let case = self.case.case(&numbers).map_err(Error::from)?;
        let from_touch = |shift: &Shift| Shift { zeta: shift.zeta - case.touch, ..*shift };
        let shifts: Vec<Shift> = self.readings.iter().map(from_touch).collect();
        let mut laws = Laws::new(&case, &shifts).map_err(Error::from)?;
        let mut left = into.iter_mut().zip(&self.measured).peekable();
        for (i, shift) in shifts.iter().enumerate() {
            let failed = |source: Error| FitError::Row { row: i + 1, source };
            laws.advance(*shift).map_err(|error| failed(error.into()))?;
            let mut state = None;
            while let Some((place, (_, own))) = left.next_if(|(_, (row, _))| *row == i) {
                if state.is_none() {
                    state = Some(step((i + 1) as f64, &laws, case.friction, 0).map_err(failed)?);
                }
                let number = state.as_ref().and_then(|state| own.of(state));
                *place = number.ok_or(FitError::Undefined { row: i + 1 })?;
            }
        }
        Ok(())
    }

    fn step(&self) -> f64 {
        self.smoothness[0]
    }

    fn jitter(&self) -> f64 {
        self.smoothness[1]
    }
}
