//! Quantities derived from states: slip, energies, violations, subsurface stresses.

mod check;
mod energy;
mod slip;
mod subsurface;
mod summary;
mod surfaces;

pub use check::violations;
pub use energy::{StoredEnergy, dissipated};
pub use subsurface::Subsurface;
pub use summary::StepSummary;
pub use surfaces::gap_left;
