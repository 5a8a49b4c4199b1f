//! R_x of dissimilar spheres and planes from a table, and by the law that fills it.

use std::sync::OnceLock;

use crate::rings::{RingImpact, RingImpactError, by_groups};
use nodes::{ENTRIES, Nodes};

mod fill;
mod groups;
mod nodes;
mod stored;

pub use groups::DissimilarGroups;

/// A table of R_x of dissimilar spheres and planes without spin about the normal.
///
/// It covers kappa from 1 to 1.5 (Poisson's ratios from 0 to 1/2), every gamma of such materials, gamma/f to 12,
/// f to 1, lambda to 8 and D_xx/D_zz from 1 to 6. It was filled by 16 x 16 rings in 128 steps. Against a grid of 64
/// cells in 256 steps (solid spheres, lambda > 0.2, |gamma| f < 0.1), and against finer rings between its entries,
/// it is off by less than 2e-3 in the mean; at most 8e-3 was found against the grid, 1e-2 against rings.
#[derive(Debug, Clone)]
pub struct DissimilarTable {
    nodes: Nodes,
    /// Empty where what is stored is damaged: the law then answers.
    entries: Vec<f32>,
}

impl DissimilarTable {
    /// The table of this process, read at the first call from the data stored in this crate.
    #[must_use]
    pub fn shared() -> &'static Self {
        static TABLE: OnceLock<DissimilarTable> = OnceLock::new();
        TABLE.get_or_init(|| Self {
            nodes: Nodes::new(),
            entries: stored::from_bytes(stored::STORED).unwrap_or_default(),
        })
    }

    /// R_x: that of alike bodies where gamma = 0, by the table, or by rings out of its range.
    ///
    /// # Errors
    /// [`RingImpactError`] where the rings cannot follow the impact.
    pub fn restitution(&self, groups: &DissimilarGroups) -> Result<f64, RingImpactError> {
        match self.stored(groups) {
            Some(value) => Ok(value),
            None => Ok(of_dissimilar(groups, RingImpact::TOLERANCE)?[0].clamp(-1.0, 1.0)),
        }
    }

    /// R_x by the table; none out of its range. It allocates nothing.
    #[must_use]
    pub fn stored(&self, groups: &DissimilarGroups) -> Option<f64> {
        (groups.gamma != 0.0).then(|| self.nodes.value(&self.entries, groups)).flatten()
    }
}

/// R_x of dissimilar spheres and planes by rings, and its estimated error; refined until the tangential velocity
/// is known to `tolerance` times f v_z. That of alike bodies is exact.
///
/// # Errors
/// [`RingImpactError`] where the rings cannot follow the impact.
pub fn of_dissimilar(
    groups: &DissimilarGroups,
    tolerance: f64,
) -> Result<[f64; 2], RingImpactError> {
    let DissimilarGroups { kappa, gamma, friction, lambda, ratio } = *groups;
    by_groups([kappa, gamma], friction, lambda, ratio, tolerance)
}

/// Makes the stored table anew. `progress` is told how many of how many parts are done.
///
/// # Errors
/// [`RingImpactError`] where the rings cannot follow an impact.
pub fn fill_dissimilar(progress: impl FnMut(usize, usize)) -> Result<Vec<u8>, RingImpactError> {
    Ok(stored::to_bytes(&fill::entries(progress)?))
}

/// Computes so many entries of the stored table anew, drawn by a seed; the largest difference.
///
/// # Errors
/// [`RingImpactError`] where the rings cannot follow an impact.
pub fn check_dissimilar(count: usize, seed: u64) -> Result<f64, RingImpactError> {
    let entries = &DissimilarTable::shared().entries;
    let (mut state, mut largest) = (seed, 0.0_f64);
    for _ in 0..count {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let index = (state >> 33) as usize % ENTRIES;
        let stored = entries.get(index).map_or(f64::INFINITY, |&entry| f64::from(entry));
        largest = largest.max((fill::entry(index)? - stored).abs());
    }
    Ok(largest)
}
