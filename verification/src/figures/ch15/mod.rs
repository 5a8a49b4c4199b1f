//! Chapter 15: coefficients of restitution.

mod dissimilar;
mod dissimilar_rebound;
mod ellipsoid;
mod gamma_limits;
mod numerical;
mod spheres;
mod spin;
mod stresses;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("15.1", "Limits of γ for two ratios of stiffness").by(gamma_limits::draw),
    Entry::figure("15.2", "Tangential restitution against λ for similar spheres").by(spheres::draw),
    Entry::figure("15.3", "Stress distribution during an impact, κ = 3/2, λ = 1")
        .by(stresses::draw),
    Entry::figure("15.4", "Forces and displacements of a dissimilar impact").by(dissimilar::forces),
    Entry::figure("15.5", "Stick and slip areas of the impact of fig. 15.4").by(dissimilar::areas),
    Entry::figure("15.6", "Tangential restitution for dissimilar materials, κ = 1")
        .by(dissimilar_rebound::draw),
    Entry::figure("15.7", "Tangential restitution with spin").by(spin::draw),
    Entry::figure("15.8", "Ellipsoid on a plane").by(ellipsoid::draw),
];
