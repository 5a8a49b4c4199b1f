//! Rolling contact, which the thesis leaves to further research (16.2). The contact moves over both
//! bodies on a [`Way`], along +x unless another direction is given; in axes moving with the contact
//! the surfaces flow through it the other way.
//!
//! In a step of length d the particle now at x comes from x + d and brings its displacement along.
//! The rigid creepage moves it by d (xi + y phi, eta - x phi). The slip of the step is therefore
//! u(x) - u_old(x + d) - d (xi + y phi, ...), at the centres of the elements, also outside the
//! contact. Creepages are those of body 2 relative to body 1, as shifts are, so that forces on body
//! 1 have their sign. Spin has the sign of a twist (12.2).

#![forbid(unsafe_code)]

mod creep;
mod drive;
mod fastsim;
mod method;
mod slip_speed;
mod springs;
mod steady;
mod transient;
mod transient_method;
mod way;

use carom_halfspace::Offset;
use carom_halfspace::operator::OperatorError;
use carom_laws::curvature::CurvatureError;
use carom_special::RangeError;

pub use carom_laws::creep::CreepCoefficients;
pub use creep::{ContinuumForces, creep_coefficients, creep_coefficients_on, creep_table_entry};
pub use drive::RollingDrive;
pub use fastsim::{Fastsim, FastsimForces};
pub use method::SteadyMethod;
pub use slip_speed::RollingFriction;
pub use springs::Springs;
pub use steady::{SteadyContact, SteadyRolling, roll_steadily};
pub use transient::RollingContact;
pub use transient_method::TransientMethod;
pub use way::Way;

use carom_solver::{ContactProblem, ContactState, FrictionalError, ProblemError};

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
        RangeError::finite("creepage", self.along)?;
        RangeError::finite("creepage_across", self.across)?;
        RangeError::finite("spin", self.spin).map(drop)
    }
}

/// Why rolling failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RollingError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The contact is no ellipse.
    #[error(transparent)]
    Contact(#[from] CurvatureError),
    /// The operator failed.
    #[error(transparent)]
    Operator(#[from] OperatorError),
    /// A step of the solver failed.
    #[error(transparent)]
    Step(#[from] FrictionalError),
    /// The problem of a step could not be set up.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// The linear system of the creep coefficients has no solution.
    #[error("the linear system of {unknowns} unknowns is singular")]
    Singular {
        /// Its size.
        unknowns: usize,
    },
    /// Friction by the slip speed did not settle.
    #[error(
        "friction by the slip speed still changes by {change:.1e} of the limit after {passes} solves: the contact is \
         about to begin to slide as a whole; give another creepage, or friction that falls less with speed"
    )]
    SlipSpeed {
        /// Solves.
        passes: usize,
        /// The greatest change by the last one, over the greatest friction limit.
        change: f64,
    },
    /// Static friction exceeds kinetic friction.
    #[error(
        "the static friction {rest} exceeds the kinetic friction {motion}: rolling needs one coefficient, \
         because particles would carry the memory of their slip through the contact"
    )]
    TwoFrictions {
        /// The static coefficient.
        rest: f64,
        /// The kinetic coefficient.
        motion: f64,
    },
    /// The contact comes too close to the leading border of the grid.
    #[error(
        "the contact ends {free} cells before the leading border of the grid: particles that enter \
         it come from {needed} cells ahead"
    )]
    NoRoomAhead {
        /// Cells without contact at that border.
        free: usize,
        /// Cells without contact that a step needs.
        needed: usize,
    },
}

/// Checks that a contact has one coefficient of friction in each cell: where static friction exceeds
/// it, particles would keep the memory of their slip as they flow through the contact.
fn check_friction(problem: &ContactProblem) -> Result<(), RollingError> {
    let friction = problem.friction();
    let count = friction.grid().map_or(1, |grid| grid.cells());
    let two = (0..count).map(|cell| friction.at(cell)).find(|own| own.rest() > own.motion());
    match two {
        Some(own) => {
            let [rest, motion] = [own.rest(), own.motion()].map(|friction| friction.get());
            Err(RollingError::TwoFrictions { rest, motion })
        }
        None => Ok(()),
    }
}

/// Checks that particles entering the contact come from cells of the grid, for operators that know
/// no displacements beyond it.
fn check_room(
    problem: &ContactProblem,
    state: &ContactState,
    way: &Way,
) -> Result<(), RollingError> {
    let (grid, operator) = (problem.grid(), problem.operator());
    if operator.coefficients_at(Offset::default()).is_some() || !operator.displaces_on_average() {
        return Ok(());
    }
    let pressures = state.pressure.values().iter().enumerate();
    let touching: Vec<usize> = pressures.filter(|(_, p)| **p > 0.0).map(|(i, _)| i).collect();
    let ahead = way.ahead();
    let axes = [(ahead.x / grid.dx(), grid.nx(), 1), (ahead.y / grid.dy(), grid.ny(), grid.nx())];
    for (cells, count, stride) in axes {
        let places = touching.iter().map(|cell| cell / stride % count);
        let free =
            if cells > 0.0 { places.map(|place| count - 1 - place).min() } else { places.min() };
        // A whole number of cells but for rounding counts as whole.
        let needed = (cells.abs() - 1e-9).ceil().max(0.0) as usize;
        if let Some(free) = free.filter(|free| *free < needed) {
            return Err(RollingError::NoRoomAhead { free, needed });
        }
    }
    Ok(())
}
