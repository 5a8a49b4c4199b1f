//! The formulas of the thesis for load histories, a second implementation beside the memory
//! polyline for cross-checks and figures: (6.48) for one direction, (7.55)-(7.64) for two.

pub mod ellipse;
pub mod sphere;
