//! Displacements row by row.

use crate::Field;

/// Normal displacements of the cells of a grid, read row by row where their transforms were, so that a large grid needs no
/// field of them: of [`SurfaceOperator::pressed`](super::SurfaceOperator::pressed).
///
/// They may be read several times, some of them or all.
pub trait NormalRows {
    /// Gives each row that is `wanted`, with its number, to `take`. Threads have different rows.
    fn each(
        &mut self,
        wanted: &(dyn Fn(usize) -> bool + Sync),
        take: &(dyn Fn(usize, &[f64]) + Sync),
    );
}

impl NormalRows for Field {
    fn each(
        &mut self,
        wanted: &(dyn Fn(usize) -> bool + Sync),
        take: &(dyn Fn(usize, &[f64]) + Sync),
    ) {
        let rows = self.values().chunks_exact(self.grid().nx()).enumerate();
        rows.filter(|(row, _)| wanted(*row)).for_each(|(row, values)| take(row, values));
    }
}
