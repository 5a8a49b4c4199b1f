//! Work on the rows of a grid whose normal displacements are computed row by row.

use std::sync::OnceLock;

use carom_halfspace::Grid;
use carom_halfspace::operator::NormalRows;

/// A row of cells.
pub(crate) struct Row<'a> {
    pub(crate) number: usize,
    pub(crate) displacements: &'a [f64],
    pub(crate) pressures: &'a [f64],
    /// The distances of the surfaces at zero approach.
    heights: &'a [f64],
}

impl Row<'_> {
    /// Pressures and gaps.
    pub(crate) fn gaps(&self, approach: f64) -> impl Iterator<Item = (f64, f64)> {
        let gaps =
            self.displacements.iter().zip(self.heights).map(move |(w, z)| w + (z - approach));
        self.pressures.iter().copied().zip(gaps)
    }
}

/// What `work` makes of each row of pressures and heights that is wanted; of others the default.
pub(crate) fn of_rows<R: Default + Send + Sync>(
    rows: &mut dyn NormalRows,
    (grid, [pressures, heights]): (Grid, [&[f64]; 2]),
    wanted: &(dyn Fn(usize) -> bool + Sync),
    work: &(dyn Fn(&Row<'_>) -> R + Sync),
) -> Vec<R> {
    let results: Vec<OnceLock<R>> = (0..grid.ny()).map(|_| OnceLock::new()).collect();
    rows.each(wanted, &|number, displacements| {
        let cells = number * grid.nx()..(number + 1) * grid.nx();
        let [pressures, heights] = [pressures, heights].map(|values| &values[cells.clone()]);
        results[number].get_or_init(|| work(&Row { number, displacements, pressures, heights }));
    });
    results.into_iter().map(|result| result.into_inner().unwrap_or_default()).collect()
}
