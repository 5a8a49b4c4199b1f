//! Torsional impact: what a normal impact takes off the spin about its normal (chapter 10).
//!
//! [`TorsionalImpact`] solves it in two groups, [`TorsionalGroups`]: complete adhesion in
//! compression, then partial slip from the rim inwards, with Lubkin's solution over the stored
//! adhesive one. [`SpinCollision`] is the same with dimensions; [`limits`] holds the closed forms.

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
