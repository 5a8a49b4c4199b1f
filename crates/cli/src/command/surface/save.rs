//! Maps as files for other programs: `.npy` and `.x3p`.

use crate::error::CliError;
use crate::outputs::{Outputs, Place};
use carom_surface::{Topography, npy, x3p};
use std::path::Path;

/// The place of a map to be saved.
#[derive(Debug)]
pub(in crate::command) struct Saved {
    place: Place,
    is_x3p: bool,
}

impl Saved {
    /// Claims the file of an option.
    ///
    /// # Errors
    /// [`CliError::Destination`] unless it ends in .npy or .x3p; as [`Outputs::file`].
    pub(in crate::command) fn claim(
        path: &Path,
        option: &'static str,
        outputs: &mut Outputs,
    ) -> Result<Self, CliError> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let is_x3p = match ending.to_ascii_lowercase().as_str() {
            "x3p" => true,
            "npy" => false,
            _ => {
                let reason = "the name must end in .npy or .x3p";
                return Err(CliError::Destination { option, path: path.to_owned(), reason });
            }
        };
        Ok(Self { place: outputs.file(option, path)?, is_x3p })
    }

    /// The file of a map; `meaning` says what its values are.
    ///
    /// # Errors
    /// If it cannot be encoded.
    pub(in crate::command) fn map(
        self,
        map: &Topography,
        meaning: &str,
    ) -> Result<(Place, Vec<u8>), CliError> {
        let spacing = map.spacing().unwrap_or([1.0; 2]);
        self.values(map.heights(), map.columns(), spacing, meaning)
    }

    /// The file of values row by row; infinity, where there is no body, is a missing point.
    ///
    /// # Errors
    /// If they cannot be encoded.
    pub(in crate::command) fn values(
        self,
        values: &[f64],
        columns: usize,
        spacing: [f64; 2],
        meaning: &str,
    ) -> Result<(Place, Vec<u8>), CliError> {
        let known = |value: &f64| if value.is_finite() { *value } else { f64::NAN };
        let values: Vec<f64> = values.iter().map(known).collect();
        let bytes = match self.is_x3p {
            true => x3p(columns, &values, spacing, meaning)
                .map_err(|error| CliError::io("write", Path::new("x3p"), error))?,
            false => {
                let shape = [values.len() / columns.max(1), columns];
                npy("<f8", &shape, values.iter().flat_map(|value| value.to_le_bytes()))
            }
        };
        Ok((self.place, bytes))
    }
}
