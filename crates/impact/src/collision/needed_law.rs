//! Which contact law a collision needs so that the coupling of dissimilar bodies counts.

use std::ops::RangeInclusive;

use carom_laws::coupling::coupling_bound;

use super::{Collision, CollisionError};
use crate::outcome::{Outcome, Warning};

/// Ratios D_xx/D_zz of spheres at which the bound of the effect of coupling was measured.
const MEASURED: RangeInclusive<f64> = 2.5..=5.0;

/// |gamma| f up to which rings are used. Beyond it, at friction that hardly lets anything slip, they are farther off
/// than the analytic laws: gamma = 0.25, f = 30 at 57 degrees, R_x = -0.319 on a grid, -0.293 analytic, -0.265 by
/// rings.
const LARGEST_FOR_RINGS: f64 = 1.0;

/// The cheapest contact law that follows a collision to a tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum NeededLaw {
    /// The analytic laws, which neglect the coupling of normal and tangential displacements
    /// ([`Collision::solve`]).
    Analytic,
    /// The law of rings, for spheres and planes ([`crate::RingImpact`]).
    Rings,
    /// The contact on a grid, for other shapes.
    Grid,
}

impl Collision {
    /// The change of R_x below which the coupling of dissimilar bodies is neglected by default: 5e-3.
    pub const NEGLIGIBLE_COUPLING: f64 = 5e-3;

    /// A bound of how much the coupling of normal and tangential displacements changes R_x
    /// ([`carom_laws::coupling::coupling_bound`]).
    #[must_use]
    pub fn coupling_bound(&self) -> f64 {
        if self.materials.is_uncoupled() {
            return 0.0;
        }
        coupling_bound(self.materials.gamma(), self.friction)
    }

    /// The cheapest law that knows R_x to this tolerance as far as coupling is concerned; of spheres and planes with
    /// |gamma| f above 1 the analytic law, which is nearest there.
    #[must_use]
    pub fn needed_law(&self, tolerance: f64) -> NeededLaw {
        let bound = self.coupling_bound();
        let d = self.mobility.matrix();
        let is_symmetric = self.is_symmetric();
        let is_measured = !is_symmetric || MEASURED.contains(&(d.m11 / d.m33));
        let strength = self.materials.gamma().abs() * self.friction.get();
        match (bound == 0.0 || (bound <= tolerance && is_measured), is_symmetric) {
            (true, _) => NeededLaw::Analytic,
            (false, true) if strength > LARGEST_FOR_RINGS => NeededLaw::Analytic,
            (false, true) => NeededLaw::Rings,
            (false, false) => NeededLaw::Grid,
        }
    }

    /// As [`Collision::solve`], where the bound of what coupling changes is part of the error estimate. Where it is
    /// negligible it takes the place of [`Warning::Coupling`].
    ///
    /// # Errors
    /// Those of [`Collision::solve`].
    pub fn solve_with_coupling_bound(&self) -> Result<Outcome, CollisionError> {
        let (mut outcome, bound) = (self.solve()?, self.coupling_bound());
        if let Outcome::Rebound(rebound) = &mut outcome {
            let velocity = self.velocity();
            rebound.error_estimate += bound * velocity.x.hypot(velocity.y) / velocity.norm();
            if bound <= Self::NEGLIGIBLE_COUPLING {
                rebound.warnings.retain(|warning| !matches!(warning, Warning::Coupling { .. }));
            }
        }
        Ok(outcome)
    }
}
