//! Floor 5 of carom: impact of elastic bodies with friction (chapters 8, 9, 10 and 15).
//!
//! [`Collision`] takes two bodies of any smooth shape and gives an [`Outcome`]; [`coupled`] is the
//! same by its matrices, [`oblique`] that of spheres and planes in two dimensionless groups,
//! [`restitution`] its one number, [`closed_form`] its limits.
#![forbid(unsafe_code)]

mod body;
mod collision;
mod mobility;
mod normal_restitution;
mod normal_spin;
mod numerical;
mod outcome;
mod wave_share;

pub mod closed_form;
pub mod coupled;
pub mod normal;
pub mod oblique;
pub mod restitution;
pub mod scene;
pub mod torsional;
pub mod uncertain;

pub use body::{Body, Motion};
pub use collision::{Collision, CollisionError};
pub use mobility::{Lever, Mobility};
pub use normal_restitution::NormalRestitution;
pub use normal_spin::NormalSpinError;
pub use numerical::{NumericalImpact, NumericalImpactError};
pub use outcome::{EnergyBudget, HistoryPoint, LogEntry, Outcome, Rebound, Torsion, Warning};
