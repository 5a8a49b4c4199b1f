//! The gap of a case, from its formula or from a file of heights.

use crate::case::{GapCase, HeightFile, SolveCase};
use crate::error::CliError;
use crate::input::read_table;
use crate::numbers::bare;
use carom_halfspace::Grid;
use carom_solver::{Gap, HeightMap};
use std::path::Path;

/// The gap of the case in the file at `path`, and the text of the heights that it names.
///
/// # Errors
/// [`CliError::Input`] if the heights are ragged, of another size than the grid, or hold anything but
/// finite numbers.
pub(in crate::command) fn gap(path: &Path, case: &SolveCase) -> Result<(Gap, String), CliError> {
    match &case.gap {
        GapCase::Formula(gap) => Ok((gap.clone(), String::new())),
        GapCase::Heights(map) => {
            let name = path.parent().unwrap_or(Path::new("")).join(&map.file);
            let text = read_table(&name)?;
            let gap = under(&text, map, case.grid);
            let gap = gap.map_err(|reason| CliError::Input { path: name, reason })?;
            Ok((gap, text))
        }
    }
}

fn under(text: &str, map: &HeightFile, grid: Grid) -> Result<Gap, String> {
    let mut rows = bare(text).map_err(|error| error.to_string())?;
    for height in rows.iter_mut().flatten() {
        *height *= map.scale;
    }
    let heights = HeightMap::from_rows(&rows).map_err(|error| error.to_string())?;
    heights.gap_over(grid, map.radius).map_err(|error| error.to_string())
}
