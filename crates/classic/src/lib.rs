//! The contact programs of 1992: the algorithms of Kalker (chapter 11) and Jaeger (chapter 12) as the thesis
//! states them, for comparison with the solver of `carom-solver`.
//!
//! They solve a step of the same [`carom_solver::ContactProblem`] through the same
//! [`carom_solver::Method`], by dense influence coefficients instead of Fourier transforms.
//!
//! | item | what |
//! |---|---|
//! | [`kalker`] | NORM, TANG, and the processes of Johnson and Panagiotopoulos built of them (chapter 11) |
//! | [`jaeger`] | Gauss-Seidel sweeps over the elements (chapter 12) |
//! | [`Block`] | a structured program, which runs and can be drawn |
//! | [`theory`] | bounds of the convergence of these iterations |
#![forbid(unsafe_code)]

mod chart;
mod direct;
pub mod jaeger;
pub mod kalker;
pub mod theory;

pub use chart::{Block, Entry, Step, Trace};
pub use direct::DirectError;
