//! Kalker's processes of chapter 11: active sets with dense linear systems.

mod charts;
mod kombi;
mod norm;
mod process;
mod scratch;
mod sets;
mod tang;

pub use charts::{JOHNSON, KOMBI, KombiStep, PANAGIOTOPOULOS, ProcessStep};
pub use kombi::Kombi;
pub use norm::{NORM, NormStep};
pub use process::{Johnson, Panagiotopoulos};
pub use scratch::{KalkerScratch, Traces};
pub use tang::{TANG, TangStep};
