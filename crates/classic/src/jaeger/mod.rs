//! The thesis's own program of chapter 12: five nested loops around a modified Gauss-Seidel sweep.
//!
//! [`PROGRAM`] is its chart, fig. 12.3; [`GaussSeidel`] carries it out. [`DiscGaussSeidel`], which
//! solves the contact and friction of one element after the other exactly, needs no loops for areas
//! and directions and serves as a check.

mod directions;
mod disc;
mod gauss_seidel;
mod program;
mod sweep;

pub use disc::{DiscGaussSeidel, DiscScratch};
pub use gauss_seidel::{GaussSeidel, GaussSeidelScratch, Most, SlipStress};
pub use program::{PROGRAM, ProgramStep};
