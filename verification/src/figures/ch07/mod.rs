//! Chapter 7: load histories with varying direction.

mod directions;
mod ellipsoid_traction;
mod examples;
mod led;
mod oblique_impact;
mod regimes;
mod ring_contact;
mod torsion;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("7.1", "Shifts against time for the oblique impact").by(oblique_impact::draw),
    Entry::figure("7.2", "Functions Γ, Φ, Ψ, Θ of the ellipse").by(ellipsoid_traction::draw),
    Entry::figure("7.3", "Stress distribution of two shifts with different directions")
        .by(regimes::draw_stress),
    Entry::figure("7.4", "Circle of instantaneous adhesion").by(regimes::draw_circle),
    Entry::figure("7.5", "Reflection of the slip direction").by(regimes::draw_reflection),
    Entry::figure("7.6", "Condition of the N-th shift, constant compression")
        .by(regimes::draw_condition),
    Entry::figure("7.7", "Regime circles for varying contact areas").by(regimes::draw_varying),
    Entry::figure("7.8", "Circle of equal stick radii for the N-th shift")
        .by(regimes::draw_equal_radii),
    Entry::figure("7.9", "Torsional stiffness δ_T of the ellipse").by(torsion::draw_stiffness),
    Entry::figure("7.10", "Torque against twist, formula and numerical solution")
        .by(torsion::draw_loading),
    Entry::figure("7.11", "Varying torque, a/b = 1/10, ν = 0").by(torsion::draw_reversals),
    Entry::figure("7.12", "Example 1: forces and displacements").by(examples::draw_first),
    Entry::figure("7.13", "Example 2: forces and displacements").by(examples::draw_second),
    Entry::figure("7.14", "Example 3: forces and displacements").by(examples::draw_third),
    Entry::figure("7.15", "Example 3: slip and stress directions at step 21").by(directions::draw),
];
