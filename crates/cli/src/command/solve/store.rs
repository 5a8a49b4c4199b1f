//! A folder with the history so far: `loads.csv`, and the fields of each step as `step-000001.npz`,
//! from which a run continues bit for bit.

use super::kept::{LOADS, Owned, fingerprint, step_name};
use crate::columns;
use crate::command::npz::{self, Array};
use crate::error::CliError;
use crate::output::Format;
use carom_cases::solve::{Chosen, Found, Saved};
use carom_halfspace::{Field, Grid};
use carom_laws::law::Shift;
use carom_solver::{CellState, ContactState, NestedHistory, StepSummary, Window};
use std::collections::BTreeMap;
use std::path::Path;

/// Storage of the steps.
#[derive(Debug)]
pub(super) struct Store(Owned);

/// Prefixes of the arrays of coarser grids.
const COARSE: [&str; 2] = ["coarse_", "coarsest_"];

impl Store {
    /// Storage in this folder.
    pub(super) const fn new(folder: Owned) -> Self {
        Self(folder)
    }

    /// Reads the stored steps, at most `count`; their fields must be on this grid.
    ///
    /// # Errors
    /// If one cannot be read, is damaged, was changed or belongs to another case or place, or if there are too many.
    pub(super) fn find(&self, grid: Grid, count: usize) -> Result<Found, CliError> {
        let mut found = Found::default();
        let below = |grid: Option<Grid>| grid.and_then(|grid| grid.coarser().ok());
        let coarse = [below(Some(grid)), below(below(Some(grid)))];
        for number in 1..=self.0.steps() {
            let name = step_name(number);
            if number > count {
                let reason = format!("the case has no step {number}, only {count}");
                return Err(self.0.input_error(&name, &reason));
            }
            let arrays = npz::decode(&self.0.read(&name, most_bytes(grid))?)
                .ok_or_else(|| self.0.input_error(&name, DAMAGED))?;
            if arrays.get("case") != Some(&self.stamp()) {
                return Err(self.0.input_error(&name, "this step belongs to another case"));
            }
            if arrays.get(SEAL) != Some(&self.seal(number, &arrays)) {
                return Err(self.0.input_error(&name, CHANGED));
            }
            let read = || Some((read_numbers(&arrays)?, read_state(&arrays, "", grid)?));
            let (step, state) = read().ok_or_else(|| self.0.input_error(&name, DAMAGED))?;
            found.steps.push(step);
            let coarse = std::array::from_fn(|i| read_state(&arrays, COARSE[i], coarse[i]?));
            found.saved = Some(Saved { state, coarse });
        }
        Ok(found)
    }

    /// Saves the last step and its state, completely or not at all.
    ///
    /// # Errors
    /// [`CliError::Io`]; earlier steps stay as they are.
    pub(super) fn save(
        &self,
        steps: &[StepSummary],
        history: &NestedHistory<Chosen>,
        window: &Window,
    ) -> Result<(), CliError> {
        let Some(last) = steps.last() else { return Ok(()) };
        let name = step_name(steps.len());
        let mut arrays = self.arrays(last, history, window);
        arrays.insert(SEAL.to_owned(), self.seal(steps.len(), &arrays));
        let archive = npz::encode(&arrays)
            .map_err(|source| CliError::io("write", Path::new(&name), source))?;
        self.0.write(&name, &archive)?;
        let text = columns::rows(Format::Csv, &StepSummary::columns(), steps)?;
        self.0.write(LOADS, text.as_bytes())
    }

    fn stamp(&self) -> Array {
        Array::Bytes(vec![8], self.0.fingerprint().to_le_bytes().to_vec())
    }

    /// A checksum of the case, the number of a step and all its arrays but the seal itself.
    fn seal(&self, number: usize, arrays: &BTreeMap<String, Array>) -> Array {
        let (case, number) = (self.0.fingerprint().to_le_bytes(), (number as u64).to_le_bytes());
        let named = arrays.iter().filter(|(name, _)| *name != SEAL);
        let parts: Vec<(&str, Vec<u8>)> =
            named.map(|(name, array)| (name.as_str(), array.bytes())).collect();
        let all = parts.iter().flat_map(|(name, bytes)| [name.as_bytes(), bytes]);
        let inputs: Vec<&[u8]> = [&case[..], &number[..]].into_iter().chain(all).collect();
        Array::Bytes(vec![8], fingerprint(&inputs).to_le_bytes().to_vec())
    }

    fn arrays(
        &self,
        step: &StepSummary,
        history: &NestedHistory<Chosen>,
        window: &Window,
    ) -> BTreeMap<String, Array> {
        let (grid, [x, y]) = (window.grid(), window.middle());
        let axis = |count: usize, at: &dyn Fn(usize) -> f64| {
            Array::Numbers(vec![count], (0..count).map(at).collect())
        };
        let mut arrays = BTreeMap::from([
            ("case".to_owned(), self.stamp()),
            (
                "numbers".to_owned(),
                Array::Numbers(vec![StepSummary::NUMBERS], step.numbers().to_vec()),
            ),
            ("x".to_owned(), axis(grid.nx(), &|i| x + grid.centred_x(i))),
            ("y".to_owned(), axis(grid.ny(), &|i| y + grid.centred_y(i))),
        ]);
        add_state(&mut arrays, "", history.state());
        for (prefix, state) in COARSE.iter().zip(history.coarse_states()) {
            if let Some(state) = state {
                add_state(&mut arrays, prefix, state);
            }
        }
        arrays
    }
}

/// The name of the checksum of a step.
const SEAL: &str = "seal";
const CHANGED: &str = "this is another step, or its numbers were changed since carom wrote them; delete this step \
                       and those behind it, and resume";
const DAMAGED: &str = "this is not a step of carom, or it is damaged";

/// Upper bound of the size in bytes of a step on this grid and two coarser ones: 41 per cell, and
/// headers.
fn most_bytes(grid: Grid) -> u64 {
    (1 << 20) + 128 * grid.cells() as u64
}

fn read_numbers(arrays: &BTreeMap<String, Array>) -> Option<StepSummary> {
    let Array::Numbers(_, numbers) = arrays.get("numbers")? else { return None };
    Some(StepSummary::from_numbers(numbers.as_slice().try_into().ok()?))
}

/// Adds the fields of a state under their names with a prefix.
fn add_state(arrays: &mut BTreeMap<String, Array>, prefix: &str, state: &ContactState) {
    let grid = state.pressure.grid();
    let shape = vec![grid.ny(), grid.nx()];
    let cells = state.cells.values().iter().map(|cell| match cell {
        CellState::Exterior => 0,
        CellState::Stick => 1,
        CellState::Slip => 2,
    });
    let Shift { zeta, xi, eta, omega } = state.shift;
    let mut add = |name: &str, array| arrays.insert(format!("{prefix}{name}"), array);
    add("cells", Array::Bytes(shape.clone(), cells.collect()));
    add("shift", Array::Numbers(vec![4], vec![zeta, xi, eta, omega]));
    for (name, field) in [
        ("pressure", &state.pressure),
        ("traction_x", &state.traction_x),
        ("traction_y", &state.traction_y),
        ("displacement_x", &state.displacement_x),
        ("displacement_y", &state.displacement_y),
    ] {
        add(name, Array::Numbers(shape.clone(), field.values().to_vec()));
    }
}

fn read_state(arrays: &BTreeMap<String, Array>, prefix: &str, grid: Grid) -> Option<ContactState> {
    let array = |name: &str| arrays.get(&format!("{prefix}{name}"));
    let numbers = |name: &str| match array(name)? {
        Array::Numbers(_, values) => Some(values.clone()),
        Array::Bytes(..) => None,
    };
    let field = |name: &str| Field::new(grid, numbers(name)?).ok();
    let Array::Bytes(_, cells) = array("cells")? else { return None };
    let cells = cells.iter().map(|cell| match cell {
        0 => Some(CellState::Exterior),
        1 => Some(CellState::Stick),
        2 => Some(CellState::Slip),
        _ => None,
    });
    let [zeta, xi, eta, omega] = numbers("shift")?.try_into().ok()?;
    Some(ContactState {
        shift: Shift { zeta, xi, eta, omega },
        pressure: field("pressure")?,
        traction_x: field("traction_x")?,
        traction_y: field("traction_y")?,
        displacement_x: field("displacement_x")?,
        displacement_y: field("displacement_y")?,
        cells: Field::new(grid, cells.collect::<Option<Vec<_>>>()?).ok()?,
    })
}
