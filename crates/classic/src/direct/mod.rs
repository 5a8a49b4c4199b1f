//! Shared parts of the methods of chapters 11 and 12: influence coefficients, the displacements
//! that a step requires, and its violations.

mod demand;
pub(crate) mod dense;
mod error;
mod influence;
mod outcome;

pub(crate) use demand::{Demand, check_tolerance};
pub use error::DirectError;
pub(crate) use influence::Influence;
pub(crate) use outcome::{End, Outcome, apart};
