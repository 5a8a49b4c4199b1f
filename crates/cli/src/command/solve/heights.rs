//! A height map from a CSV file.

use crate::case::HeightFile;
use crate::error::CliError;
use crate::input::read_table;
use carom_halfspace::{Field, Grid};
use carom_solver::Gap;
use std::path::Path;

/// The gap under a surface of these heights, and the text of the file.
///
/// # Errors
/// [`CliError::Input`] with line and column if the file is ragged, of another size than the grid, or
/// holds anything but finite numbers.
pub(in crate::command) fn read(
    path: &Path,
    map: &HeightFile,
    grid: Grid,
) -> Result<(Gap, String), CliError> {
    let refused = |reason: String| CliError::Input { path: path.to_owned(), reason };
    let text = read_table(path)?;
    let mut heights = Vec::with_capacity(grid.cells());
    let mut rows = 0;
    for (i, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let before = heights.len();
        for (j, cell) in line.split([',', ';', '\t']).enumerate() {
            let cell = cell.trim();
            let height = cell.parse::<f64>().ok().filter(|height| height.is_finite());
            let reason = || {
                refused(format!(
                    "line {}, value {}: {cell:?} must be a finite number",
                    i + 1,
                    j + 1
                ))
            };
            heights.push(map.scale * height.ok_or_else(reason)?);
        }
        let count = heights.len() - before;
        if count != grid.nx() {
            let wanted = grid.nx();
            return Err(refused(format!(
                "line {}: {count} values; must be {wanted}, as `grid.cells` along x",
                i + 1
            )));
        }
        rows += 1;
    }
    if rows != grid.ny() {
        let wanted = grid.ny();
        return Err(refused(format!("{rows} lines; must be {wanted}, as `grid.cells` along y")));
    }
    let gaps = heights
        .iter()
        .zip(grid.centres())
        .map(|(height, (x, y))| 0.5 * (x * x + y * y) / map.radius - height);
    let mut gaps: Vec<f64> = gaps.collect();
    let lowest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
    for gap in &mut gaps {
        *gap -= lowest;
    }
    let field = Field::new(grid, gaps).and_then(Gap::new);
    Ok((field.map_err(|error| refused(error.to_string()))?, text))
}
