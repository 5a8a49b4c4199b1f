//! Impacts with uncertain inputs: measured scatter in, scatter of the rebound out.
//!
//! Friction, velocity, angle, radius or modulus follow a [`Distribution`]; a [`Sampling`] draws
//! them independently (plain Monte Carlo, seeded), follows every impact and gives a
//! [`Study`]: mean, standard deviation, quantiles and histogram of each [`Quantity`]. Draws
//! outside the valid range, such as a negative friction, are counted, not dropped in silence.

mod distribution;
mod draw;
mod quantity;
mod study;
mod summary;

pub use distribution::Distribution;
pub use quantity::Quantity;
pub use study::{OutOfRange, Sampling, Study, UncertainError};
pub use summary::{Bin, Summary};
