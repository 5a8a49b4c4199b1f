//! Thin rings and shells of revolution by Fourier matrices: the flange at the end of a tube
//! (proposition 4 of the thesis). It contains no contact mechanics.
//!
//! | module | content |
//! |---|---|
//! | [`fourier`] | series as matrices: products, derivatives, division, coefficients that jump |
//! | [`flange`] | a ring of variable stiffness on a tube, loaded by forces around it |
//!
//! The variable coefficients of the equations are known functions of an angle. With unknowns as Fourier series a product with a known function is
//! a matrix, and the solution is a division of matrices. Lengths, forces and moduli are in any
//! consistent units.
#![forbid(unsafe_code)]

pub mod flange;
pub mod fourier;

mod dense;
mod wall;

pub use wall::Wall;
