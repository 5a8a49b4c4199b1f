//! What follows from states: slip, energies, what is left of the conditions, stresses below.

mod check;
mod energy;
mod slip;
mod subsurface;
mod summary;

pub use check::violations;
pub use energy::{StoredEnergy, dissipated};
pub use subsurface::Subsurface;
pub use summary::StepSummary;
