//! R_x of dissimilar spheres and planes from a table, and by the law that fills it.

use std::sync::OnceLock;

use super::RestitutionTable;
use crate::collision::CollisionError;
use crate::oblique::ObliqueImpact;
use crate::rings::{RingImpact, RingImpactError, by_groups, left_out};
use nodes::{ENTRIES, Nodes};

mod answer;
mod estimate;
mod fill;
mod groups;
mod nodes;
mod stored;

pub use answer::{DissimilarMethod, DissimilarRestitution};
pub use groups::DissimilarGroups;

/// A table of R_x of dissimilar spheres and planes without spin about the normal.
///
/// It covers kappa from 1 to 1.5 (Poisson's ratios from 0 to 1/2), every gamma of such materials, gamma/f to 12,
/// f to 1, lambda to 8 and D_xx/D_zz from 1 to 6. It was filled by 16 x 16 rings in 128 steps. What it misses of alike
/// bodies, which are known exactly, is taken off where Gamma = gamma/f is small, in part `1/(1 + Gamma^2)`.
///
/// Against a grid of 64 cells in 256 steps (solid spheres, lambda > 0.2, |gamma| f < 0.1), and against finer rings
/// between its entries, it is off by less than 2e-3 in the mean; at most 8e-3 was found against the grid. Where
/// |gamma| f > 0.15 and lambda < 0.1 it is off by up to 7e-2 against finer rings, which the error estimate says.
///
/// ```
/// use carom_impact::restitution::{DissimilarGroups, DissimilarMethod, DissimilarTable};
/// use carom_laws::friction::Friction;
/// let table = DissimilarTable::shared(); // stored in the crate
/// // A rigid sphere on one of Poisson's ratio 0.
/// let groups = DissimilarGroups::of_spheres(1.0, 0.5, Friction::new(0.2)?, 2.0)?;
/// let found = table.restitution(&groups)?;
/// assert_eq!(found.method, DissimilarMethod::Table);
/// assert!((found.r_x - 0.196).abs() < found.error_estimate);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct DissimilarTable {
    nodes: Nodes,
    /// Empty where what is stored is damaged: the law then answers.
    entries: Vec<f64>,
}

impl DissimilarTable {
    /// The table of this process, read at the first call from the data stored in this crate.
    #[must_use]
    pub fn shared() -> &'static Self {
        static TABLE: OnceLock<DissimilarTable> = OnceLock::new();
        TABLE.get_or_init(|| Self {
            nodes: Nodes::new(),
            entries: stored::from_bytes(stored::STORED)
                .map_or(Vec::new(), |entries| entries.into_iter().map(f64::from).collect()),
        })
    }

    /// What is stored: a head of 24 bytes, then the entries by gamma/f, lambda, D_xx/D_zz, kappa and gamma^2, the last
    /// fastest, each of four bytes, little-endian.
    #[must_use]
    pub fn as_bytes() -> &'static [u8] {
        stored::STORED
    }

    /// R_x: -1 without friction, the exact one of alike bodies where gamma = 0, by the table, or by rings out of its
    /// range.
    ///
    /// # Errors
    /// [`RingImpactError`] where the rings cannot follow the impact.
    pub fn restitution(
        &self,
        groups: &DissimilarGroups,
    ) -> Result<DissimilarRestitution, RingImpactError> {
        if let Some(known) = known(groups)? {
            return Ok(known);
        }
        match self.stored(groups) {
            Some(found) => Ok(found),
            None => followed(groups, RingImpact::TOLERANCE),
        }
    }

    /// R_x by the table; none out of its range and without coupling.
    ///
    /// It allocates nothing where [`RestitutionTable`] needs no exact impact.
    #[must_use]
    pub fn stored(&self, groups: &DissimilarGroups) -> Option<DissimilarRestitution> {
        if groups.gamma == 0.0 || groups.is_frictionless() {
            return None;
        }
        let spread = groups.spread();
        let part = 1.0 / (1.0 + spread * spread);
        let coupled = self.nodes.value(&self.entries, groups, part)?;
        let alike = RestitutionTable::shared().restitution(groups.alike().ok()?).ok()?;
        let estimate = estimate::of_table(groups) + left_out(&groups.impact());
        let r_x = coupled + part * alike;
        Some(DissimilarRestitution::estimated(r_x, DissimilarMethod::Table, estimate))
    }
}

/// R_x of dissimilar spheres and planes by rings, refined until the tangential velocity is known to `tolerance` times
/// f v_z. That without friction and that of alike bodies are exact.
///
/// # Errors
/// [`RingImpactError`] where the rings cannot follow the impact.
pub fn of_dissimilar(
    groups: &DissimilarGroups,
    tolerance: f64,
) -> Result<DissimilarRestitution, RingImpactError> {
    match known(groups)? {
        Some(known) => Ok(known),
        None => followed(groups, tolerance),
    }
}

/// What needs neither table nor rings.
fn known(groups: &DissimilarGroups) -> Result<Option<DissimilarRestitution>, RingImpactError> {
    if groups.is_frictionless() {
        return Ok(Some(DissimilarRestitution::FRICTIONLESS));
    }
    if groups.gamma != 0.0 {
        return Ok(None);
    }
    let impact = ObliqueImpact::new(groups.alike()?).map_err(CollisionError::from)?;
    Ok(Some(DissimilarRestitution::uncoupled(impact.restitution())))
}

fn followed(
    groups: &DissimilarGroups,
    tolerance: f64,
) -> Result<DissimilarRestitution, RingImpactError> {
    let [r_x, estimate] = by_groups(&groups.impact(), tolerance)?;
    Ok(DissimilarRestitution::estimated(r_x, DissimilarMethod::Rings, estimate))
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
        let stored = entries.get(index).copied().unwrap_or(f64::INFINITY);
        largest = largest.max((fill::entry(index)? - stored).abs());
    }
    Ok(largest)
}
