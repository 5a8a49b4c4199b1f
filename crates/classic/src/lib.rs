//! The algorithms of 1992 as stated in the thesis, for comparison with the present laws and solver:
//! the contact programs of Kalker (chapter 11) and Jaeger (chapter 12), and formulas of chapters 6,
//! 7 and 14.
//!
//! The programs solve steps of the same [`carom_solver::ContactProblem`] through the same trait
//! [`carom_solver::Method`], with dense influence coefficients instead of Fourier transforms.
//!
//! | item | content |
//! |---|---|
//! | [`kalker`] | NORM, TANG, and the processes of Johnson and Panagiotopoulos that use them (chapter 11) |
//! | [`jaeger`] | Gauss-Seidel sweeps over the elements (chapter 12) |
//! | [`Block`] | a structured program that can be executed and drawn |
//! | [`history`] | the formulas of chapters 6 and 7 for the force after any history of shifts |
//! | [`rigid_slip`] | force and torque of a contact that slides and spins as a whole (14.3) |
//! | [`theory`] | bounds on the convergence of these iterations |
#![forbid(unsafe_code)]

mod chart;
mod direct;
pub mod history;
pub mod jaeger;
pub mod kalker;
pub mod rigid_slip;
pub mod theory;

pub use chart::{Block, Entry, Step, Trace};
pub use direct::DirectError;
