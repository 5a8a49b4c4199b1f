//! A folder with the history so far: `loads.csv`, and each step's fields as `step-000001.npz`, from
//! which the run goes on bit for bit.

use super::npz::{self, Array};
use super::view::{COLUMNS, NUMBERS, Step};
use crate::columns;
use crate::destination::Aside;
use crate::error::CliError;
use crate::output::Format;
use carom_halfspace::{Field, Grid};
use carom_laws::law::Shift;
use carom_solver::{CellState, ContactState};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Where the steps go.
#[derive(Debug)]
pub(super) struct Store {
    folder: PathBuf,
    /// Of the case and all that it reads.
    fingerprint: u64,
}

/// Steps found, and the state after the last one.
pub(super) struct Found {
    pub(super) steps: Vec<Step>,
    pub(super) state: ContactState,
}

impl Store {
    /// The folder, made if it is not there, for a case of this text.
    ///
    /// # Errors
    /// [`CliError::Io`] if it cannot be made.
    pub(super) fn open(folder: &Path, inputs: &[&[u8]]) -> Result<Self, CliError> {
        std::fs::create_dir_all(folder).map_err(|error| CliError::io("write", folder, error))?;
        Ok(Self { folder: folder.to_owned(), fingerprint: fingerprint(inputs) })
    }

    fn path(&self, step: usize) -> PathBuf {
        self.folder.join(format!("step-{step:06}.npz"))
    }

    /// Refuses a folder that holds steps already.
    ///
    /// # Errors
    /// [`CliError::Input`].
    pub(super) fn check_empty(&self) -> Result<(), CliError> {
        if self.path(1).exists() {
            let reason = "steps of an earlier run are here; add --resume to go on with them, or \
                          name another folder";
            return Err(self.refused(&self.folder, reason));
        }
        Ok(())
    }

    /// The steps that are there, at most so many.
    ///
    /// # Errors
    /// [`CliError::Input`] if one is damaged or of another case.
    pub(super) fn find(&self, grid: Grid, most: usize) -> Result<Found, CliError> {
        let mut found = Found { steps: Vec::new(), state: ContactState::apart(grid) };
        for number in 1..=most {
            let path = self.path(number);
            let Ok(bytes) = std::fs::read(&path) else { break };
            let arrays = npz::decode(&bytes)
                .ok_or_else(|| self.refused(&path, "this is no step of carom, or damaged"))?;
            let stamp = Array::Bytes(vec![8], self.fingerprint.to_le_bytes().to_vec());
            if arrays.get("case") != Some(&stamp) {
                return Err(self.refused(&path, "this step belongs to another case"));
            }
            let read = || Some((read_numbers(&arrays)?, read_state(&arrays, grid)?));
            let (step, state) = read()
                .ok_or_else(|| self.refused(&path, "this is no step of carom, or damaged"))?;
            found.steps.push(step);
            found.state = state;
        }
        Ok(found)
    }

    /// Keeps the last step and its state: whole, or not at all.
    ///
    /// # Errors
    /// [`CliError::Io`]; earlier steps stay as they are.
    pub(super) fn save(&self, steps: &[Step], state: &ContactState) -> Result<(), CliError> {
        let Some(last) = steps.last() else { return Ok(()) };
        let path = self.path(steps.len());
        let bytes = npz::encode(&self.arrays(last, state));
        Aside::write(&path, &bytes)?.put_in_place()?;
        let loads = self.folder.join("loads.csv");
        let text = columns::rows(Format::Csv, COLUMNS, steps)?;
        Aside::write(&loads, text.as_bytes())?.put_in_place()
    }

    fn arrays(&self, step: &Step, state: &ContactState) -> BTreeMap<&'static str, Array> {
        let grid = state.pressure.grid();
        let shape = vec![grid.ny(), grid.nx()];
        let field = |field: &Field| Array::Numbers(shape.clone(), field.values().to_vec());
        let cells = state.cells.values().iter().map(|cell| match cell {
            CellState::Exterior => 0,
            CellState::Stick => 1,
            CellState::Slip => 2,
        });
        let Shift { zeta, xi, eta, omega } = state.shift;
        let axis = |count: usize, at: &dyn Fn(usize) -> f64| {
            Array::Numbers(vec![count], (0..count).map(at).collect())
        };
        BTreeMap::from([
            ("case", Array::Bytes(vec![8], self.fingerprint.to_le_bytes().to_vec())),
            ("numbers", Array::Numbers(vec![NUMBERS], step.numbers().to_vec())),
            ("shift", Array::Numbers(vec![4], vec![zeta, xi, eta, omega])),
            ("x", axis(grid.nx(), &|i| grid.centred_x(i))),
            ("y", axis(grid.ny(), &|i| grid.centred_y(i))),
            ("pressure", field(&state.pressure)),
            ("traction_x", field(&state.traction_x)),
            ("traction_y", field(&state.traction_y)),
            ("displacement_x", field(&state.displacement_x)),
            ("displacement_y", field(&state.displacement_y)),
            ("cells", Array::Bytes(shape.clone(), cells.collect())),
        ])
    }

    fn refused(&self, path: &Path, reason: &str) -> CliError {
        CliError::Input { path: path.to_owned(), reason: reason.to_owned() }
    }
}

fn read_numbers(arrays: &BTreeMap<String, Array>) -> Option<Step> {
    let Array::Numbers(_, numbers) = arrays.get("numbers")? else { return None };
    Some(Step::from_numbers(numbers.as_slice().try_into().ok()?))
}

fn read_state(arrays: &BTreeMap<String, Array>, grid: Grid) -> Option<ContactState> {
    let numbers = |name: &str| match arrays.get(name)? {
        Array::Numbers(_, values) => Some(values.clone()),
        Array::Bytes(..) => None,
    };
    let field = |name: &str| Field::new(grid, numbers(name)?).ok();
    let Array::Bytes(_, cells) = arrays.get("cells")? else { return None };
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

/// FNV-1a, 64 bits, of all inputs with their lengths and of the program's version.
fn fingerprint(inputs: &[&[u8]]) -> u64 {
    let version = env!("CARGO_PKG_VERSION").as_bytes();
    let mut sum = 0xcbf2_9ce4_8422_2325_u64;
    for input in inputs.iter().chain([&version]) {
        let length = (input.len() as u64).to_le_bytes();
        for byte in length.iter().chain(input.iter()) {
            sum = (sum ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    sum
}
