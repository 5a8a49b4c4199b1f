//! R_x on a grid of chi and psi, in parallel.

use std::sync::atomic::{AtomicUsize, Ordering};

#[cfg(feature = "threads")]
use rayon::prelude::*;

use super::RestitutionError;
use crate::oblique::{Groups, ObliqueImpact};

/// R_x for every pair of `chi` and `psi`: one row for each psi, one column for each chi.
///
/// Exact impacts, in parallel, the same bits on any number of threads. `progress` is told the
/// number of rows done after each.
///
/// ```
/// use carom_impact::restitution::restitution_map;
/// let map = restitution_map(&[2.5, 3.5], &[0.5, 1.0, 9.0], |_| ())?;
/// assert_eq!((map.len(), map[2][1]), (3, 2.0 * 3.5 / 9.0 - 1.0));
/// # Ok::<(), carom_impact::restitution::RestitutionError>(())
/// ```
///
/// # Errors
/// [`RestitutionError`] of the first pair that has no answer.
pub fn restitution_map(
    chi: &[f64],
    psi: &[f64],
    progress: impl Fn(usize) + Sync,
) -> Result<Vec<Vec<f64>>, RestitutionError> {
    let done = AtomicUsize::new(0);
    #[cfg(feature = "threads")]
    let rows = psi.par_iter();
    #[cfg(not(feature = "threads"))]
    let rows = psi.iter();
    rows.map(|&psi| {
        let row = chi
            .iter()
            .map(|&chi| Ok(ObliqueImpact::new(Groups::new(chi, psi)?)?.restitution()))
            .collect();
        progress(done.fetch_add(1, Ordering::Relaxed) + 1);
        row
    })
    .collect()
}
