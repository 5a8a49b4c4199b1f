//! Floor 1 of carom: special functions and numerical tools. It knows no mechanics.
#![forbid(unsafe_code)]

pub mod elliptic;
pub mod gamma;
pub mod hypergeometric;
pub mod ode;
pub mod quadrature;
pub mod roots;

mod axis_ratio;
mod error;

pub use axis_ratio::AxisRatio;
pub use error::RangeError;
