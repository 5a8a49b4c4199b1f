//! What the methods of chapters 11 and 12 share: coefficients instead of transforms, what a step
//! demands, what is left of its conditions.

mod demand;
pub(crate) mod dense;
mod error;
mod influence;
mod outcome;

pub(crate) use demand::{Demand, check_tolerance};
pub use error::DirectError;
pub(crate) use influence::Influence;
pub(crate) use outcome::{End, Outcome, apart};
