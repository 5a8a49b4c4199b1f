//! Initial value problems: an explicit Runge-Kutta method of order 8 with dense output.

mod dop853;
mod tableau;

pub use dop853::{DenseStep, OdeError, Stepper, Tolerance};
