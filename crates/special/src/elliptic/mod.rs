//! Elliptic integrals as functions of the [`AxisRatio`](crate::AxisRatio) `k' = a/b`.
//!
//! Every integral of the thesis is taken over the angle of an ellipse with the semi-axes a and b,
//! so `k' = a/b` is the number that is known exactly; the modulus `k = sqrt(1 - k'^2)` is not, and
//! forming it costs all digits at both ends of the range. Any positive `k'` is valid: `k' > 1`
//! is an ellipse with a > b, that is, a negative parameter `m = k^2`.

mod amplitude;
pub mod complete;
pub mod incomplete;

pub use amplitude::Amplitude;
