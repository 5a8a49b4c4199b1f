//! A loaded state of a bellows.

use super::fields::{Unknowns, dilatation, energy, points, volume};
use super::grid::Grid;
use super::meridian::least_gap;
use super::newton::{Solved, greatest};
use super::profile::{WallPoint, profile};
use crate::Wall;

/// How a state was reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Convergence {
    /// Steps of Newton's method, the last part of the load only.
    pub iterations: usize,
    /// Greatest change in the last step: rotations, displacements over t, forces over E t^2.
    pub last_step: f64,
    /// Greatest residual of the equations, in the same units.
    pub residual: f64,
    /// The greatest coefficient of the last eighth of the rotations over the greatest of all: an
    /// estimate of the truncation.
    pub truncation: f64,
}

/// A state of equilibrium of one corrugation.
///
/// ```
/// use carom_shells::{Wall, bellows::{Axial, Bellows, BellowsLoad, Meridian}};
/// let bellows = Bellows::new(Meridian::sine(10.0, 1.0, 3.0)?, Wall::new(1.0, 0.3, 0.1)?, 32)?;
/// let stretched = bellows.solve(BellowsLoad::new(0.0, Axial::Dilatation(0.6))?)?;
/// let pressed = bellows.solve(BellowsLoad::new(0.0, Axial::Dilatation(-0.6))?)?;
/// // Extension stiffens, compression softens.
/// assert!(stretched.force() > 2.0 * -pressed.force());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BellowsState {
    wall: Wall,
    pressure: f64,
    dilatation: f64,
    stored_energy: f64,
    volume: f64,
    least_gap: f64,
    profile: Vec<WallPoint>,
    truncation: f64,
    pub(super) solved: Solved,
}

impl BellowsState {
    /// `pressure` in units of E.
    pub(super) fn new(grid: &Grid, wall: Wall, pressure: f64, solved: Solved) -> Self {
        let (t, e) = (wall.thickness(), wall.young_modulus());
        let state = points(grid, &solved.unknowns, pressure);
        let profile = profile(grid, &wall, &state);
        let heights: Vec<_> = profile.iter().map(|at| at.height).collect();
        Self {
            pressure: e * pressure,
            dilatation: t * dilatation(grid, &state),
            stored_energy: e * t * t * t * energy(grid, &state),
            volume: t * t * t * volume(grid, &state),
            least_gap: least_gap(&heights, grid.is_closed),
            truncation: truncation(&solved.unknowns),
            profile,
            wall,
            solved,
        }
    }

    /// Internal pressure.
    #[must_use]
    pub const fn pressure(&self) -> f64 {
        self.pressure
    }

    /// F, the force on closed ends beside the pressure on them; tension is positive.
    #[must_use]
    pub fn force(&self) -> f64 {
        let (t, e) = (self.wall.thickness(), self.wall.young_modulus());
        e * t * t * self.solved.unknowns.force()
    }

    /// The thrust of the bellows on its ends beside the pressure on closed ends there, -F: what
    /// anchors must carry. Positive if the bellows pushes.
    #[must_use]
    pub fn thrust(&self) -> f64 {
        -self.force()
    }

    /// Growth in length of the corrugation.
    #[must_use]
    pub const fn dilatation(&self) -> f64 {
        self.dilatation
    }

    /// dF/dDelta of one corrugation in this state, at fixed pressure.
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        self.wall.young_modulus() * self.wall.thickness() * self.solved.stiffness
    }

    /// Stored energy of the corrugation.
    #[must_use]
    pub const fn stored_energy(&self) -> f64 {
        self.stored_energy
    }

    /// Volume that the corrugation encloses.
    #[must_use]
    pub const fn volume(&self) -> f64 {
        self.volume
    }

    /// The least distance along the axis of neighbouring folds; they touch when it is the
    /// thickness. See [`super::Meridian::least_gap`].
    #[must_use]
    pub const fn least_gap(&self) -> f64 {
        self.least_gap
    }

    /// Shape and stresses from crest to root.
    #[must_use]
    pub fn profile(&self) -> &[WallPoint] {
        &self.profile
    }

    /// The greatest rotation, in absolute value.
    #[must_use]
    pub fn greatest_rotation(&self) -> f64 {
        self.profile.iter().map(|at| at.rotation.abs()).fold(0.0, f64::max)
    }

    /// Coefficients of the rotation, that of sin xi first.
    #[must_use]
    pub fn rotation_coefficients(&self) -> &[f64] {
        self.solved.unknowns.beta()
    }

    /// How it was reached.
    #[must_use]
    pub const fn convergence(&self) -> Convergence {
        Convergence {
            iterations: self.solved.iterations,
            last_step: self.solved.last_step,
            residual: self.solved.residual,
            truncation: self.truncation,
        }
    }
}

fn truncation(unknowns: &Unknowns) -> f64 {
    let beta = unknowns.beta();
    let all = greatest(beta);
    let last = greatest(&beta[beta.len() - beta.len().div_ceil(8)..]);
    if all > 0.0 { last / all } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every other coefficient of a symmetric series vanishes, so that the last one alone says nothing.
    #[test]
    fn the_last_eighth_of_a_series_tells_of_its_truncation() {
        let of = |beta: [f64; 16]| {
            let mut unknowns = vec![0.0; 3 * 16 + 2];
            unknowns[..16].copy_from_slice(&beta);
            truncation(&Unknowns(unknowns))
        };
        let mut beta = [0.0; 16];
        assert_eq!(of(beta), 0.0);
        (beta[0], beta[13], beta[14]) = (-4.0, 1.0, 0.02);
        assert_eq!(of(beta), 0.005);
        beta[15] = -0.08;
        assert_eq!(of(beta), 0.02);
    }
}
