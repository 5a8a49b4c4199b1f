//! Kalker's processes of chapter 11: active sets with dense linear systems.

mod kombi;
mod norm;
mod process;
mod scratch;
mod sets;
mod tang;

pub use kombi::{KOMBI, Kombi, KombiStep};
pub use norm::{NORM, NormStep};
pub use process::{JOHNSON, Johnson, PANAGIOTOPOULOS, Panagiotopoulos, ProcessStep};
pub use scratch::{KalkerScratch, Traces};
pub use tang::{TANG, TangStep};
