//! Thin rings and shells of revolution by Fourier matrices: the flange at the end of a tube and the
//! expansion bellows (propositions 4 and 5 of the thesis). It contains no contact mechanics.
//!
//! | module | content |
//! |---|---|
//! | [`fourier`] | series as matrices: products, derivatives, division, coefficients that jump |
//! | [`flange`] | a ring of variable stiffness on a tube, loaded by forces around it |
//! | [`bellows`] | corrugated shells of revolution with large rotation under pressure and axial load |
//!
//! Both systems are linear equations, or steps of Newton's method, whose variable coefficients are
//! known functions of an angle. With unknowns as Fourier series a product with a known function is
//! a matrix, and the solution is a division of matrices. Lengths, forces and moduli are in any
//! consistent units.
//!
//! ```
//! use carom_shells::{Wall, bellows::{Bellows, Meridian}};
//! // One corrugation of a steel bellows: 100 mm mean radius, 5 mm amplitude, 20 mm pitch, 1 mm wall.
//! let wall = Wall::new(2e11, 0.3, 1e-3)?;
//! let bellows = Bellows::new(Meridian::sine(0.1, 5e-3, 0.02)?, wall, 32)?;
//! let response = bellows.linear_response()?;
//! assert!(response.spring_rate > 1e6 && response.spring_rate < 1e8); // N/m
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

pub mod bellows;
pub mod flange;
pub mod fourier;

mod dense;
mod wall;

pub use wall::Wall;
