//! Floor 4 of carom: the numerical contact problem (chapters 11 to 14).
//!
//! This version has the problem, its state and the trait of the methods, no method yet.
#![forbid(unsafe_code)]

mod gap;
mod method;
mod problem;
mod state;

pub use gap::Gap;
pub use method::Method;
pub use problem::Problem;
pub use state::ContactState;
