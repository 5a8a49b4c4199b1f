//! Hypergeometric functions of real parameters on the unit interval.
//!
//! The argument is a [`UnitArgument`]: it knows x and 1 - x both, as most functions here behave like
//! a power of one of them at an end, and neither can be had from the other without loss.

mod argument;
mod continuation;
mod error;
mod gauss;
mod series;
mod three_f_two;

pub use argument::UnitArgument;
pub use error::HypergeometricError;
pub use gauss::{Gauss, gauss};
pub use three_f_two::{ThreeFTwo, three_f_two};
