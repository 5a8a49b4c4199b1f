//! Rolling contact, which the thesis leaves to further research (16.2). The contact moves along +x
//! over both bodies; in axes moving with the contact the surfaces flow through it towards -x.
//!
//! In a step of length d the particle now at x comes from x + d and brings its displacement along.
//! The rigid creepage moves it by d (xi + y phi, eta - x phi). The slip of the step is therefore
//! u(x) - u_old(x + d) - d (xi + y phi, ...), at the centres of the elements, also outside the
//! contact. Creepages are those of body 2 relative to body 1, as shifts are, so that forces on body
//! 1 have their sign. Spin has the sign of a twist (12.2).

#![forbid(unsafe_code)]

mod creep;
mod fastsim;
mod steady;
mod transient;

use carom_halfspace::operator::OperatorError;
use carom_special::RangeError;

pub use creep::{CreepCoefficients, creep_coefficients, creep_coefficients_on};
pub use fastsim::{Fastsim, FastsimForces};
pub use steady::{SteadyRolling, roll_steadily};
pub use transient::Roll;

use carom_classic::DirectError;
use carom_solver::{ContactProblem, ContactState, FrictionalError, NormalError};

/// Rigid motion of body 2 relative to body 1 per distance rolled.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Creepage {
    /// Longitudinal creepage xi.
    pub along: f64,
    /// Lateral creepage eta.
    pub across: f64,
    /// Spin creepage phi: twist per length.
    pub spin: f64,
}

impl Creepage {
    fn check(self) -> Result<(), RangeError> {
        RangeError::finite("creepage along", self.along)?;
        RangeError::finite("creepage across", self.across)?;
        RangeError::finite("spin", self.spin).map(drop)
    }
}

/// Why rolling failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RollingError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The operator failed.
    #[error(transparent)]
    Operator(#[from] OperatorError),
    /// A step of the solver failed.
    #[error(transparent)]
    Step(#[from] FrictionalError),
    /// The frictionless contact, from which the search for a normal force starts, could not be
    /// solved.
    #[error(transparent)]
    Normal(#[from] NormalError),
    /// No approach was found that gives the normal force.
    #[error("no approach found for the normal force {force}: the last trial gave {reached}")]
    NormalForce {
        /// The prescribed force.
        force: f64,
        /// The force of the last trial.
        reached: f64,
    },
    /// The direct solution failed.
    #[error(transparent)]
    Steady(#[from] DirectError),
    /// The contact comes too close to the leading border of the grid.
    #[error(
        "the contact ends {free} columns before the leading border of the grid: particles that enter \
         it come from {needed} columns ahead"
    )]
    NoRoomAhead {
        /// Columns without contact at that border.
        free: usize,
        /// Columns without contact that a step needs.
        needed: usize,
    },
}

/// The distance of a step in columns of the grid, not necessarily whole.
fn columns(problem: &ContactProblem, distance: f64) -> Result<f64, RangeError> {
    RangeError::positive("rolling distance", distance)?;
    let columns = distance / problem.grid().dx();
    let nx = problem.grid().nx() as f64;
    RangeError::check("rolling distance", distance, columns < nx, "below the length of the grid")?;
    // A whole number of columns but for rounding counts as whole.
    let whole = columns.round();
    Ok(if (columns - whole).abs() < 1e-9 { whole } else { columns })
}

/// Checks that particles entering the contact come from cells of the grid.
fn check_room(state: &ContactState, columns: f64) -> Result<(), RollingError> {
    let nx = state.pressure.grid().nx();
    let pressures = state.pressure.values().iter().enumerate();
    let touching = pressures.filter(|(_, pressure)| **pressure > 0.0);
    let Some(last) = touching.map(|(i, _)| i % nx).max() else { return Ok(()) };
    let (free, needed) = (nx - 1 - last, columns.ceil() as usize);
    if free < needed { Err(RollingError::NoRoomAhead { free, needed }) } else { Ok(()) }
}
