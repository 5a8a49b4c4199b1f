//! Torsional impact: how a normal impact changes the spin about its normal (chapter 10).
//!
//! [`TorsionalImpact`] solves it for two groups, [`TorsionalGroups`]: complete adhesion in
//! compression, then partial slip from the edge inwards, by Lubkin's solution added to the stored
//! adhesive one. [`SpinCollision`] is the same with dimensions. [`limits`] contains the closed
//! forms.

mod adhesion;
mod error;
mod groups;
mod impact;
mod slip;
mod spin;
mod stepped;
mod trace;
mod trajectory;

pub mod limits;

pub use error::TorsionalError;
pub use groups::TorsionalGroups;
pub use impact::TorsionalImpact;
pub use spin::{SpinCollision, SpinOutcome, Spinner};
pub use trace::{TorsionalPhase, TorsionalPoint};
