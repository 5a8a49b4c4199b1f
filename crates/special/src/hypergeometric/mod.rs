//! Hypergeometric functions of real parameters on the unit interval.
//!
//! The argument is a [`UnitArgument`], which stores both x and 1 - x. Most functions here behave
//! like a power of one of them at an end of the interval, and neither can be computed from the
//! other without loss of accuracy.

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
