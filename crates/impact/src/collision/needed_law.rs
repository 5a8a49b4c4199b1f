//! The choice of the contact law by the effect of coupling and twist.

use std::ops::RangeInclusive;

use carom_laws::coupling::coupling_bound;
use carom_laws::validity::Validity;

use super::{Collision, CollisionError};
use crate::outcome::{Outcome, TorsionMode};

/// Ratios D_xx/D_zz of spheres for which the bound of the effect of coupling was measured: from that of a thin shell, 5/2
/// to round-off, on.
const MEASURED: RangeInclusive<f64> = 2.5 - 1e-9..=5.0;

/// Largest |gamma| f for rings. Beyond it, with friction so large that little slips, they are less accurate
/// than the analytic laws: for gamma = 0.25, f = 30, 57 degrees, R_x = -0.319 on a grid, -0.293 analytically,
/// -0.265 by rings.
const LARGEST_FOR_RINGS: f64 = 1.0;

/// The cheapest contact law with which a collision is accurate to a tolerance.
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
    pub const NEGLIGIBLE_COUPLING: f64 = Validity::NEGLIGIBLE_COUPLING;

    /// An upper bound of the change of R_x by the coupling of normal and tangential displacements
    /// ([`carom_laws::coupling::coupling_bound`]).
    #[must_use]
    pub fn coupling_bound(&self) -> f64 {
        if self.materials.is_uncoupled() {
            return 0.0;
        }
        coupling_bound(self.materials.gamma(), self.friction)
    }

    /// The cheapest law whose error of R_x by neglected coupling, and of R_x and the relative spin about the
    /// normal by their neglected interaction ([`Collision::twist_bound`]), is below the tolerance. For
    /// spheres and planes with |gamma| f above 1 it is the analytic law, which is the most accurate there. A
    /// spin without tangential motion does not need rings: the torsional impact of elastic bodies is exact. Static friction above
    /// kinetic friction and a given ratio of stiffness have the analytic law only.
    #[must_use]
    pub fn needed_law(&self, tolerance: f64) -> NeededLaw {
        if self.static_friction.is_some() || self.stiffness_ratio.is_some() {
            return NeededLaw::Analytic;
        }
        let bound = self.coupling_bound();
        let d = self.mobility.matrix();
        let is_symmetric = self.is_symmetric();
        let is_measured = !is_symmetric || MEASURED.contains(&(d.m11 / d.m33));
        let strength = self.materials.gamma().abs() * self.friction.get();
        let twist = self.twist_bound();
        let is_still = twist.restitution == 0.0 || !self.is_tangential();
        let is_twist_small = twist.spin.max(twist.restitution) <= tolerance && is_measured;
        let is_coupling_small = bound == 0.0 || (bound <= tolerance && is_measured);
        match (is_coupling_small && (is_still || is_twist_small), is_symmetric) {
            (true, _) => NeededLaw::Analytic,
            (false, true) if strength > LARGEST_FOR_RINGS => NeededLaw::Analytic,
            (false, true) => NeededLaw::Rings,
            (false, false) => NeededLaw::Grid,
        }
    }

    /// [`Collision::needed_law`] for the tolerance of this collision, or for
    /// [`Collision::NEGLIGIBLE_COUPLING`] where that is less or none was given.
    #[must_use]
    pub fn default_law(&self) -> NeededLaw {
        let velocity = self.velocity();
        let slip = libm::hypot(velocity.x, velocity.y);
        let of_restitution = |tolerance: f64| tolerance * libm::hypot(slip, velocity.z) / slip;
        let asked = self.tolerance.map_or(f64::INFINITY, of_restitution);
        self.needed_law(asked.min(Self::NEGLIGIBLE_COUPLING))
    }

    /// As [`Collision::solve`]; friction acts on the spin about the normal where that is not negligible, as if there
    /// were no tangential impact.
    ///
    /// # Errors
    /// Those of [`Collision::solve`].
    pub fn solve_with_needed_torsion(&self) -> Result<Outcome, CollisionError> {
        let needs_torsion = self.torsion == TorsionMode::Auto
            && self.static_friction.is_none()
            && self.twist_bound().spin > Self::NEGLIGIBLE_COUPLING;
        match needs_torsion {
            true => self.clone().with_torsion().solve(),
            false => self.solve(),
        }
    }
}
