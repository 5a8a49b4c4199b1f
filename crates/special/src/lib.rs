//! Floor 1 of carom: special functions and numerical tools. It knows no mechanics.
#![forbid(unsafe_code)]

pub mod elliptic;

mod axis_ratio;
mod error;
pub mod ode;

pub use axis_ratio::AxisRatio;
pub use error::RangeError;
