//! Fig. 7.1: the shifts of an oblique impact that begins in adhesion.

use carom_impact::normal;
use carom_impact::oblique::{Event, Groups, ObliqueImpact, TracePoint};

use crate::{Axis, Claim, Figure, FigureResult, Panel, Series, Tolerance, linspace};

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("ν", "0, equal spheres: χ = 7/2");
    figure.assumed("ψ", "0.5, so that the impact begins in adhesion");
    let groups = Groups::new(3.5, 0.5)?;
    let times = linspace(0.0, normal::DURATION, 1001);
    let velocities: Vec<f64> = times.iter().map(|&t| normal::state_at(t).velocity).collect();
    let trace = ObliqueImpact::trace(groups, &velocities)?;
    let impact = ObliqueImpact::new(groups)?;

    let mut panel =
        Panel::new(Axis::linear("t ζ′_A / ζ_max"), Axis::linear("ζ/ζ_max, c_x ξ/(f c_z ζ_max)"))
            .titled("Shifts");
    panel.add(Series::line("ζ", trace.iter().map(|p| (p.time, p.compression))));
    panel.add(Series::line("ξ", trace.iter().map(|p| (p.time, groups.psi() * p.shift))));
    figure.panel(panel);
    let mut forces = Panel::new(Axis::linear("t ζ′_A / ζ_max"), Axis::linear("force / (f F_max)"))
        .titled("Forces");
    let limit = |p: &TracePoint| p.compression * p.compression.sqrt();
    forces.add(Series::line("F_x", trace.iter().map(|p| (p.time, groups.psi() * p.force))));
    forces.add(Series::dashed("f F_z", trace.iter().map(|p| (p.time, limit(p)))));
    figure.panel(forces);

    let onset = impact
        .phases()
        .iter()
        .find(|phase| phase.began_by == Event::SlipStart)
        .ok_or("the impact has no slip phase")?;
    let peak =
        trace.iter().max_by(|p, q| p.shift.total_cmp(&q.shift)).ok_or("the trace is empty")?;
    let end = normal::time(onset.start);
    figure.claim(
        Claim::close("adhesion ends", end, 1.217_076_971_237_919, Tolerance::Absolute(1e-9))
            .source("independent program"),
    );
    figure.claim(
        Claim::holds("adhesion ends after the maximum of ξ", end > peak.time, end - peak.time)
            .source("text below the figure"),
    );
    let before = 0.5 * normal::DURATION - end;
    figure.claim(Claim::holds("and before maximal compression", before > 0.0, before));
    let at_onset = ObliqueImpact::trace(groups, &[onset.start])?;
    let limit = groups.psi() * at_onset[0].velocity.abs();
    figure.claim(
        Claim::close("there |c_x ξ′| = f c_z ζ′", limit, onset.start, Tolerance::Absolute(1e-10))
            .source("(8.50)"),
    );
    let least = trace.iter().map(|p| p.shift).fold(f64::INFINITY, f64::min);
    let last = trace[1000];
    figure.claim(Claim::holds(
        "ξ has a minimum in restitution, as R_x < 0",
        impact.restitution() < 0.0 && least < last.shift && least < 0.0,
        least,
    ));
    let excess = trace.iter().map(|p| p.friction_used.abs()).fold(0.0, f64::max);
    figure.claim(Claim::at_most("the force never exceeds f F_z", excess, 1.0 + 1e-12));
    let step = normal::DURATION / 1000.0;
    let impulse: f64 = trace.iter().map(|p| p.force * step).sum();
    figure.claim(
        Claim::close(
            "the impulse is the change of velocity",
            1.25 * groups.chi() * impulse,
            1.0 + impact.restitution(),
            Tolerance::Absolute(1e-4),
        )
        .source("e″ = -(5/4) χ Φ summed by the trapezoidal rule"),
    );
    Ok(figure)
}
