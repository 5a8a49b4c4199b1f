//! The program of chapter 12 of the thesis: five nested loops around a modified Gauss-Seidel sweep.
//!
//! [`PROGRAM`] is its chart, fig. 12.3; [`GaussSeidel`] executes it. [`DiscGaussSeidel`] solves
//! contact and friction exactly for one element at a time; it needs no loops for areas and
//! directions and serves as a check.

mod chart;
mod directions;
mod disc;
mod gauss_seidel;
mod program;
mod slip_algorithm;
mod step;
mod sweep;

pub use chart::{PROGRAM, ProgramStep};
pub use disc::{DiscGaussSeidel, DiscScratch};
pub use gauss_seidel::{GaussSeidel, Most, SlipStress};
pub use step::GaussSeidelScratch;
