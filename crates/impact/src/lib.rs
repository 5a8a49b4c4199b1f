//! Floor 5 of carom: impact of elastic bodies with friction (chapters 8, 9, 10 and 15).
//!
//! [`Collision`] takes two bodies with their motions and gives an [`Outcome`]; [`oblique`] is the
//! same in two dimensionless groups, [`restitution`] its one number, [`closed_form`] its limits.
#![forbid(unsafe_code)]

mod body;
mod collision;
mod mobility;
mod outcome;

pub mod closed_form;
pub mod normal;
pub mod oblique;
pub mod restitution;
pub mod scene;
pub mod uncertain;

pub use body::{Body, Inertia, Motion, Shape, kinetic_energy};
pub use collision::{Collision, CollisionError};
pub use outcome::{EnergyBudget, HistoryPoint, LogEntry, Outcome, Rebound, Warning};
