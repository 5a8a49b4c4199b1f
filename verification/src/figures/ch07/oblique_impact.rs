//! Fig. 7.1: the shifts of an oblique impact that begins in adhesion.

use carom_impact::closed_form::AdhesiveCompression;
use carom_impact::normal;
use carom_impact::oblique::{Event, Groups, ObliqueImpact, TracePoint};

use carom_special::hypergeometric::UnitArgument;

use crate::spring_impact;
use crate::{Absolute, Failure, Figure, FigureResult, Panel, Series, linspace};

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("ν", "0, equal spheres: χ = 7/2");
    figure.assumed("ψ", "0.5, so that the impact begins in adhesion");
    let groups = Groups::new(3.5, 0.5)?;
    let times = linspace(0.0, normal::DURATION, 1001);
    let velocities: Vec<f64> = times.iter().map(|&t| normal::state_at(t).velocity).collect();
    let trace = ObliqueImpact::trace(groups, &velocities)?;
    let impact = ObliqueImpact::new(groups)?;

    let mut panel = Panel::new("t ζ′_A / ζ_max", "ζ/ζ_max, c_x ξ/(f c_z ζ_max)").titled("Shifts");
    panel.add(Series::line("ζ", trace.iter().map(|p| (p.time, p.compression))));
    panel.add(Series::line("ξ", trace.iter().map(|p| (p.time, groups.psi() * p.shift))));
    figure.panel(panel);
    let mut forces = Panel::new("t ζ′_A / ζ_max", "force / (f F_max)").titled("Forces");
    let limit = |p: &TracePoint| p.compression * p.compression.sqrt();
    forces.add(Series::line("F_x", trace.iter().map(|p| (p.time, groups.psi() * p.force))));
    forces.add(Series::dashed("f F_z", trace.iter().map(|p| (p.time, limit(p)))));
    figure.panel(forces);

    let stepped = spring_impact::course(3.5, 0.5);
    let onset = impact
        .phases()
        .iter()
        .find(|phase| phase.began_by == Event::SlipStart)
        .ok_or("the impact has no slip phase")?;
    let peak =
        trace.iter().max_by(|p, q| p.shift.total_cmp(&q.shift)).ok_or("the trace is empty")?;
    let end = normal::time(onset.start);
    figure
        .close("adhesion ends", end, 1.217_076_971_237_919, Absolute(1e-9))
        .source("independent program");
    figure
        .close("the maximum of ξ comes before", peak.time, stepped.peak, Absolute(4e-3))
        .source("springs with sliders, stepped in time; text below the figure");
    let before = 0.5 * normal::DURATION - end;
    figure
        .at_least("adhesion ends before maximal compression, by", before, 0.1)
        .source("text below the figure");
    let at_onset = ObliqueImpact::trace(groups, &[onset.start])?;
    let limit = groups.psi() * at_onset[0].velocity.abs();
    figure.close("there |c_x ξ′| = f c_z ζ′", limit, onset.start, Absolute(1e-10)).source("(8.50)");
    adhesion_claim(&mut figure, groups, onset.start)?;
    let least = trace.iter().map(|p| p.shift).fold(f64::INFINITY, f64::min);
    let last = trace[1000];
    let shifts = [
        (groups.psi() * least, stepped.least),
        (groups.psi() * last.shift, stepped.last),
        (impact.restitution(), stepped.restitution),
    ];
    figure
        .all_close(
            "least ξ, in restitution as R_x < 0, ξ at the end, and R_x",
            shifts,
            Absolute(1e-4),
        )
        .source("springs with sliders, stepped in time; text below the figure");
    let excess = trace.iter().map(|p| p.friction_used.abs()).fold(0.0, f64::max);
    figure
        .close("greatest |F_x|/(f F_z): sliding", excess, 1.0, Absolute(1e-12))
        .source("Coulomb's law");
    let step = normal::DURATION / 1000.0;
    let impulse: f64 = trace.iter().map(|p| p.force * step).sum();
    figure
        .close(
            "the impulse is the change of velocity",
            1.25 * groups.chi() * impulse,
            1.0 + impact.restitution(),
            Absolute(1e-4),
        )
        .source("e″ = -(5/4) χ Φ summed by the trapezoidal rule");
    Ok(figure)
}

/// Shift and velocity during adhesion in compression, in closed form and integrated from the equation of
/// motion.
fn adhesion_claim(figure: &mut Figure, groups: Groups, end: f64) -> Result<(), Failure> {
    let motion = AdhesiveCompression::new(groups.chi())?;
    let velocities = [0.99, 0.95, 0.9, 0.8, 0.5 * (1.0 + end)];
    let trace = ObliqueImpact::trace(groups, &velocities)?;
    let mut pairs = Vec::new();
    for (w, point) in velocities.into_iter().zip(&trace) {
        let s = UnitArgument::from_complement(w * w)?;
        let [velocity, shift] = summed(groups.chi(), w);
        pairs.extend([(motion.velocity(s)?, velocity), (motion.shift(s)?, shift)]);
        pairs.extend([(point.velocity, velocity), (point.shift, shift)]);
    }
    figure
        .all_close(
            "ξ and its rate while the contact sticks: closed form and walk",
            pairs,
            Absolute(1e-7),
        )
        .source(
            "(1 - w²) u″ - (6/5) w u′ + (6/5) χ u = 0 as equations in time, by Runge and Kutta",
        );
    Ok(())
}

/// Velocity and shift of the sticking contact when the normal velocity is w, stepped in time.
fn summed(chi: f64, w: f64) -> [f64; 2] {
    // In the time t: zeta' = w, u' = -(5/4) chi P, P' = (3/2) sqrt(zeta) u, e' = u.
    let end = normal::time(w);
    let steps = 4000;
    let dt = end / f64::from(steps);
    // Near first contact zeta = t and P = t^(3/2): the integration starts a little later, with the first
    // terms.
    let mut t = dt;
    let mut state = [1.0 - 0.5 * chi * libm::pow(dt, 2.5), libm::pow(dt, 1.5), dt];
    let rate = |t: f64, [u, p, _]: [f64; 3]| {
        [-1.25 * chi * p, 1.5 * normal::state_at(t).compression.sqrt() * u, u]
    };
    let moved = |s: [f64; 3], k: [f64; 3], h: f64| [0, 1, 2].map(|i| s[i] + h * k[i]);
    for _ in 1..steps {
        let one = rate(t, state);
        let two = rate(t + 0.5 * dt, moved(state, one, 0.5 * dt));
        let three = rate(t + 0.5 * dt, moved(state, two, 0.5 * dt));
        let four = rate(t + dt, moved(state, three, dt));
        for i in 0..3 {
            state[i] += dt / 6.0 * (one[i] + 2.0 * two[i] + 2.0 * three[i] + four[i]);
        }
        t += dt;
    }
    [state[0], state[2]]
}
