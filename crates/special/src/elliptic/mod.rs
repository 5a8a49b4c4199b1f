//! Elliptic integrals as functions of the [`AxisRatio`](crate::AxisRatio) `k' = a/b`.
//!
//! The integrals of the thesis are taken over the angle of an ellipse with semi-axes a and b, so
//! `k' = a/b` is the exactly known number. The modulus `k = sqrt(1 - k'^2)` would lose accuracy at
//! both ends of the range. Any positive `k'` is valid: `k' > 1` is an ellipse with a > b, which has
//! a negative parameter `m = k^2`.

mod amplitude;
pub mod complete;
pub mod incomplete;

pub use amplitude::Amplitude;
