//! Impacts with uncertain inputs: distributions of the inputs give distributions of the rebound.
//!
//! Friction, velocity, angle, radius or modulus have a [`Distribution`]. A [`Sampling`] draws them
//! independently (plain Monte Carlo with a seed), computes every impact and returns a [`Study`]: mean,
//! standard deviation, quantiles and histogram of each [`Quantity`]. Samples outside the valid range, such as
//! a negative friction, are counted and reported.

mod distribution;
mod draw;
mod quantity;
mod study;
mod summary;

pub use distribution::Distribution;
pub use quantity::Quantity;
pub use study::{OutOfRange, Sampling, Study, UncertainError};
pub use summary::{Bin, Summary};
