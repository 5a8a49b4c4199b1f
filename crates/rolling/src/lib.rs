//! Rolling contact, which the thesis leaves to further research (16.2): the contact moves along +x
//! over both bodies, and the surfaces flow through it towards -x.
//!
//! In a step of length d the particle now at x comes from x + d; it takes its displacement along, and
//! the rigid creepage moves it by d (xi + y phi, eta - x phi), so that the slip of the step is
//! u(x) - u_old(x + d) - d (xi + y phi, ...), at the centres of the elements and outside of the
//! contact too. Creepages are of body 2 against body 1, as shifts are, so that forces on body 1 have
//! their sign; the sense of spin is that of a twist (12.2).

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

/// Rigid motion of body 2 against body 1 per distance rolled.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Creepage {
    /// Along the direction of rolling, xi.
    pub along: f64,
    /// Across it, eta.
    pub across: f64,
    /// Twist per length, phi.
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
    /// A step of the method of today failed.
    #[error(transparent)]
    Step(#[from] FrictionalError),
    /// Contact without friction, from which a normal force is sought, was not found.
    #[error(transparent)]
    Normal(#[from] NormalError),
    /// No approach leads to the normal force.
    #[error("the normal force {force} is not reached: {reached} after all trials of the approach")]
    NormalForce {
        /// The force.
        force: f64,
        /// That of the last trial.
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
        /// Columns without contact.
        free: usize,
        /// Columns needed.
        needed: usize,
    },
}

/// Columns of the grid that a step goes, whole or not.
fn columns(problem: &ContactProblem, distance: f64) -> Result<f64, RangeError> {
    RangeError::positive("rolling distance", distance)?;
    let columns = distance / problem.grid().dx();
    let nx = problem.grid().nx() as f64;
    RangeError::check("rolling distance", distance, columns < nx, "below the length of the grid")?;
    // A whole number of columns but for rounding is one.
    let whole = columns.round();
    Ok(if (columns - whole).abs() < 1e-9 { whole } else { columns })
}

/// Ok if particles that enter the contact come from cells of the grid.
fn check_room(state: &ContactState, columns: f64) -> Result<(), RollingError> {
    let nx = state.pressure.grid().nx();
    let pressures = state.pressure.values().iter().enumerate();
    let touching = pressures.filter(|(_, pressure)| **pressure > 0.0);
    let Some(last) = touching.map(|(i, _)| i % nx).max() else { return Ok(()) };
    let (free, needed) = (nx - 1 - last, columns.ceil() as usize);
    if free < needed { Err(RollingError::NoRoomAhead { free, needed }) } else { Ok(()) }
}
