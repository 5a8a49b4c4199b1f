//! Layer 1 of carom: special functions and numerical tools. It contains no mechanics.
//!
//! | module | content |
//! |---|---|
//! | [`elliptic`] | complete K, E, D, B, C and incomplete F, E, D of the axis ratio |
//! | [`hypergeometric`] | 2F1 and 3F2(s, a, b; s + 1, c) on the unit interval |
//! | [`gamma`] | gamma, its reciprocal and its logarithm |
//! | [`quadrature`] | Gauss-Legendre, adaptive Gauss-Kronrod, tanh-sinh |
//! | [`roots`] | Brent's method in a bracket, bisection |
//! | [`ode`] | ordinary differential equations with dense output |
//! | [`interrupt`] | ends a long computation from outside |
//!
//! Arguments are types that keep full accuracy at both ends of their range: [`AxisRatio`] instead
//! of the modulus, [`elliptic::Amplitude`] instead of the angle, [`hypergeometric::UnitArgument`]
//! with x and 1 - x. Transcendental functions come from `libm`: the same digits on every machine.
//!
//! ```
//! use carom_special::{AxisRatio, elliptic::complete};
//! // An ellipse 1e200 times as long as wide: K = ln(4/k') to the last digit.
//! let slender = AxisRatio::new(1e-200)?;
//! assert!((complete::k(slender) - (4e200_f64).ln()).abs() < 1e-12);
//! # Ok::<(), carom_special::RangeError>(())
//! ```
#![forbid(unsafe_code)]

pub mod elliptic;
pub mod gamma;
pub mod hypergeometric;
pub mod interrupt;
pub mod ode;
pub mod quadrature;
pub mod roots;

mod axis_ratio;
mod error;
mod spacing;
mod word;

pub use axis_ratio::AxisRatio;
pub use error::{RangeError, Readable};
pub use spacing::{linspace, logspace};
pub use word::{WordError, nearest};
