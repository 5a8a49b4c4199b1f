//! Chapter 7: load histories with varying direction.

mod ellipsoid_traction;
mod oblique_impact;

use crate::catalogue::Entry;

/// The tables and figures of the chapter, in order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry::figure("7.1", "Shifts against time for the oblique impact").by(oblique_impact::draw),
    Entry::figure("7.2", "Functions Γ, Φ, Ψ, Θ of the ellipse").by(ellipsoid_traction::draw),
    Entry::figure("7.3", "Stress distribution of two shifts with different directions"),
    Entry::figure("7.4", "Circle of instantaneous adhesion"),
    Entry::figure("7.5", "Reflection of the slip direction"),
    Entry::figure("7.6", "Condition of the N-th shift, constant compression"),
    Entry::figure("7.7", "Regime circles for varying contact areas"),
    Entry::figure("7.8", "Circle of equal stick radii for the N-th shift"),
    Entry::figure("7.9", "Torsional stiffness δ_T of the ellipse"),
    Entry::figure("7.10", "Torque against twist, formula and numerical solution"),
    Entry::figure("7.11", "Varying torque, a/b = 1/10, ν = 0"),
    Entry::figure("7.12", "Example 1: forces and displacements"),
    Entry::figure("7.13", "Example 2: forces and displacements"),
    Entry::figure("7.14", "Example 3: forces and displacements"),
    Entry::figure("7.15", "Example 3: slip and stress directions at step 21"),
];
