//! The bellows, and its states under given loads.

use carom_special::RangeError;

use super::axial::{Axial, BellowsLoad};
use super::fields::{Unknowns, points};
use super::grid::Grid;
use super::linear::LinearResponse;
use super::meridian::Meridian;
use super::newton::{self, NotConverged, Solved};
use super::state::BellowsState;
use crate::Wall;
use crate::dense::Singular;
use crate::fourier::MOST_SAMPLES;

/// Why a state of a bellows was not found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum BellowsError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// Newton's method does not reach the load; there may be a limit point before it
    /// ([`Bellows::follow`]).
    #[error(transparent)]
    NotConverged(#[from] NotConverged),
    /// Equations without a solution in floating point.
    #[error(transparent)]
    Singular(#[from] Singular),
}

/// An infinite row of equal corrugations of a thin wall; loads and results are those of one.
///
/// ```
/// use carom_shells::{Wall, bellows::{Axial, Bellows, BellowsLoad, Meridian}};
/// let bellows = Bellows::new(Meridian::sine(10.0, 1.0, 3.0)?, Wall::new(1.0, 0.3, 0.1)?, 32)?;
/// let spring_rate = bellows.linear_response()?.spring_rate;
/// // Under internal pressure at fixed ends the bellows pushes.
/// let state = bellows.solve(BellowsLoad::new(1e-3, Axial::Dilatation(0.0))?)?;
/// assert!(spring_rate > 0.0 && state.thrust() > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Bellows {
    meridian: Meridian,
    wall: Wall,
    pub(super) grid: Grid,
}

/// Above this rotation the load is applied in parts.
const LARGE_TURN: f64 = 0.3;
/// The least part of the load that is tried.
const LEAST_PART: f64 = 1.0 / 1024.0;

impl Bellows {
    /// A bellows with series of `harmonics`, from 4 to 256.
    ///
    /// # Errors
    /// [`RangeError`] for the number of harmonics, or unless the thickness is from 1e-7 to 0.2 of the
    /// least radius, at most the least radius of curvature of the meridian, and less than the
    /// least gap between folds.
    pub fn new(meridian: Meridian, wall: Wall, harmonics: usize) -> Result<Self, RangeError> {
        let fits = (4..=256).contains(&harmonics);
        RangeError::check("harmonics", harmonics as f64, fits, "from 4 to 256")?;
        let t = wall.thickness();
        let least = meridian.at(std::f64::consts::PI).radius;
        let fits = t >= 1e-7 * least && t <= 0.2 * least;
        RangeError::check("thickness", t, fits, "from 1e-7 to 0.2 of the least radius")?;
        let fits = t <= meridian.least_curvature_radius();
        let allowed = "at most the least radius of curvature of the meridian";
        RangeError::check("thickness", t, fits, allowed)?;
        let fits = meridian.is_closed() || t < meridian.least_gap();
        RangeError::check("thickness", t, fits, "less than the gap between folds")?;
        debug_assert!(32 * harmonics <= MOST_SAMPLES);
        Ok(Self { meridian, wall, grid: Grid::new(&meridian, &wall, harmonics) })
    }

    /// Its meridian.
    #[must_use]
    pub const fn meridian(&self) -> &Meridian {
        &self.meridian
    }

    /// Its wall.
    #[must_use]
    pub const fn wall(&self) -> &Wall {
        &self.wall
    }

    /// Number of harmonics.
    #[must_use]
    pub const fn harmonics(&self) -> usize {
        self.grid.harmonics
    }

    /// The response to small loads.
    ///
    /// # Errors
    /// [`BellowsError::Singular`] if numbers overflow.
    pub fn linear_response(&self) -> Result<LinearResponse, BellowsError> {
        Ok(LinearResponse::new(&self.grid, &self.wall)?)
    }

    /// The state under a load, reached from rest.
    ///
    /// # Errors
    /// [`BellowsError::NotConverged`] if a state on the way cannot be found.
    pub fn solve(&self, load: BellowsLoad) -> Result<BellowsState, BellowsError> {
        let (pressure, axial) = self.without_units(load);
        let rest = Unknowns::zero(&self.grid);
        let linear = newton::solve_once(&self.grid, &rest, pressure, axial)?;
        let is_large = newton::greatest(
            &points(&self.grid, &linear, pressure).iter().map(|at| at.beta).collect::<Vec<_>>(),
        ) > LARGE_TURN;
        let mut part = if is_large { 0.25 } else { 1.0 };
        let mut reached = 0.0;
        let mut state = rest;
        loop {
            let next = f64::min(reached + part, 1.0);
            let target = axial.with(next * axial.value());
            match newton::solve(&self.grid, &state, next * pressure, target) {
                Ok(solved) if next >= 1.0 => return Ok(self.state(pressure, solved)),
                Ok(solved) => {
                    reached = next;
                    state = solved.unknowns;
                }
                Err(failure) if part <= LEAST_PART => {
                    return Err(NotConverged { fraction: reached, ..failure }.into());
                }
                Err(_) => part *= 0.5,
            }
        }
    }

    pub(super) fn state(&self, pressure: f64, solved: Solved) -> BellowsState {
        BellowsState::new(&self.grid, self.wall, pressure, solved)
    }

    /// Pressure over E, and force over E t^2 or dilatation over t.
    pub(super) fn without_units(&self, load: BellowsLoad) -> (f64, Axial) {
        let (t, e) = (self.wall.thickness(), self.wall.young_modulus());
        let axial = match load.axial() {
            Axial::Force(force) => Axial::Force(force / (e * t * t)),
            Axial::Dilatation(growth) => Axial::Dilatation(growth / t),
        };
        (load.pressure() / e, axial)
    }
}
