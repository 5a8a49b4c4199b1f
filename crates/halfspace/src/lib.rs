//! Floor 2 of carom: the elastic half-space (chapter 4).
#![forbid(unsafe_code)]

mod material;

pub use material::{Material, MaterialPair};
