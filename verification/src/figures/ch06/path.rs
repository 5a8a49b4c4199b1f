//! A contact led along a path, and the closed stresses of chapter 6 to compare it with.

use crate::{Axis, Claim, Figure, Panel, Series, Tolerance, linspace};
use carom_laws::memory::ScalarMemory;

/// The state after a path of approaches and shifts `(ζ, ξ/(f κ))`, ζ = 1 being a contact of
/// radius 1.
pub(super) fn led(path: &[(f64, f64)]) -> Result<ScalarMemory, carom_special::RangeError> {
    let mut memory = ScalarMemory::new();
    for &(zeta, x) in path {
        memory.advance(zeta, x)?;
    }
    Ok(memory)
}

/// The stress over μ at a radius.
pub(super) fn stress(memory: &ScalarMemory, rho: f64) -> f64 {
    let zeta = memory.zeta();
    memory.traction(rho * rho / zeta) * zeta.sqrt()
}

/// `σ_CM/μ` between the contact radii of two approaches (6.10).
pub(super) fn cattaneo(outer: f64, inner: f64, rho: f64) -> f64 {
    let root = |zeta: f64| (zeta - rho * rho).max(0.0).sqrt();
    root(outer) - root(inner)
}

/// Draws the stress of a state with its friction limit, and claims that it is the sum of closed
/// stresses `factor × σ_CM(outer, inner)`.
pub(super) fn stress_panel(
    figure: &mut Figure,
    title: &str,
    memory: &ScalarMemory,
    parts: &[(f64, f64, f64)],
) {
    let edge = memory.zeta().sqrt();
    let radii = linspace(0.0, edge, 301);
    let mut panel = Panel::new(Axis::linear("ρ"), Axis::linear("σ/μ")).titled(title);
    panel.add(Series::line("σ", radii.iter().map(|&rho| (rho, stress(memory, rho)))));
    if parts.len() > 1 {
        for (i, &(factor, outer, inner)) in parts.iter().enumerate() {
            let part = |&rho: &f64| (rho, factor * cattaneo(outer, inner, rho));
            panel.add(Series::dashed(format!("part {}", i + 1), radii.iter().map(part)));
        }
    }
    let limit = |sign: f64| {
        radii.iter().map(|&rho| (rho, sign * (edge * edge - rho * rho).max(0.0).sqrt())).collect()
    };
    panel.add(Series::dotted("± f p", limit(1.0)));
    let upper: Vec<(f64, f64)> = limit(-1.0);
    panel.add(Series::dotted("", upper));
    figure.panel(panel);
    let closed = |rho: f64| -> f64 {
        parts.iter().map(|&(factor, outer, inner)| factor * cattaneo(outer, inner, rho)).sum()
    };
    let pairs: Vec<(f64, f64)> =
        radii.iter().map(|&rho| (stress(memory, rho), closed(rho))).collect();
    figure.claim(
        Claim::all_close(
            format!("{title}: σ is the sum of Cattaneo's stresses"),
            pairs,
            Tolerance::Absolute(2e-8), // the root of round-off where a ring begins
        )
        .source("closed forms of chapter 6"),
    );
    // Round-off of the radius itself shows as its root on the very edge.
    let excess = radii[..radii.len() - 1]
        .iter()
        .map(|&rho| stress(memory, rho).abs() - (edge * edge - rho * rho).max(0.0).sqrt())
        .fold(f64::NEG_INFINITY, f64::max);
    figure.claim(
        Claim::at_most(format!("{title}: |σ| does not exceed f p"), excess, 1e-14)
            .source("Coulomb's law"),
    );
}
