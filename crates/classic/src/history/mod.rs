//! The thesis's own statements of the load history, kept beside the memory polyline as a second
//! implementation for cross-checks and figures: (6.48) for one direction, (7.55)-(7.64) for two.

pub mod ellipse;
pub mod sphere;
