//! Figs. 7.3 to 7.8: two directions of slip and the circles of their conditions.

use super::super::outline::circle;
use super::led::{distance, led, polar};
use crate::{Absolute, Arrow, Claim, Figure, FigureResult, Panel, Point, Series, linspace};
use carom_laws::memory::{Lateral, MemoryRegime, VectorMemory};

/// The plane of the shifts e = (c_x ξ, c_y η)/(f c_z ζ₁).
fn e_plane() -> Panel {
    Panel::new("e_x = c_x ξ/(f c_z ζ₁)", "e_y = c_y η/(f c_z ζ₁)").equal_aspect()
}

fn arrow(tail: [f64; 2], head: [f64; 2]) -> Arrow {
    Arrow { tail: Point::from((tail[0], tail[1])), head: Point::from((head[0], head[1])) }
}

/// The path from the origin through all shifts, as arrows with names at their ends.
fn path(panel: &mut Panel, shifts: &[[f64; 2]], names: &[&str]) {
    let tails = std::iter::once([0.0; 2]).chain(shifts.iter().copied());
    let arrows: Vec<Arrow> = tails.zip(shifts).map(|(tail, head)| arrow(tail, *head)).collect();
    panel.add(Series::arrows("path of the shift", arrows).coloured(6));
    for (shift, name) in shifts.iter().zip(names) {
        panel.add(Series::note(*name, (shift[0] + 0.01, shift[1])).coloured(6));
    }
}

pub(super) fn draw_stress() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("e", "(0.5, 0), then 0.4 more at 120°, ζ = 1");
    let step = polar(0.4, 120.0);
    let memory = led(1.0, &[(1.0, [0.5, 0.0]), (1.0, [0.5 + step[0], step[1]])])?;
    let radii = linspace(0.0, 0.999, 300);
    let mut panel = Panel::new("ρ/a", "σ/(f σ_z0)");
    for (i, name) in ["σ_zx", "σ_zy"].into_iter().enumerate() {
        panel.add(Series::line(name, radii.iter().map(|&r| (r, memory.traction(r * r)[i]))));
    }
    panel.add(Series::dotted("f p", radii.iter().map(|&r| (r, (1.0 - r * r).sqrt()))));
    figure.panel(panel);
    // zeta_2* of (7.20), corrected, and the turned direction of (7.29).
    let star = 1.0 + step.dot(step) / (2.0 * step[0]);
    figure.close("ζ₂*", memory.stick_depth(), star, Absolute(1e-15)).source("(7.20), corrected");
    let excess = radii.iter().map(|&r| memory.traction(r * r).length() - (1.0 - r * r).sqrt());
    figure
        .at_most("|σ| does not exceed f p", excess.fold(f64::NEG_INFINITY, f64::max), 1e-14)
        .source("Coulomb's law");
    let ring = linspace(star.sqrt() + 1e-6, 0.999, 100)
        .into_iter()
        .map(|r| (memory.traction(r * r).length(), (1.0 - r * r).sqrt()));
    figure
        .all_close("|σ| = f p in the whole ring", ring, Absolute(1e-14))
        .source("|p₁ + p₂| = 1 (7.16)");
    figure.deviation(
        "ζ₂* = ζ₂ + |e₁||de₂|²/(e₁·de₂)",
        "ζ₂* = ζ₂ + |e₁||de₂|²/(2 e₁·de₂)",
        "factor in (7.20)",
    );
    Ok(figure)
}

/// A step from a state: its regime.
fn regime(
    state: &VectorMemory,
    zeta: f64,
    e: [f64; 2],
) -> Result<MemoryRegime, carom_special::RangeError> {
    let mut memory = state.clone();
    memory.advance(zeta, e)?;
    Ok(memory.regime())
}

/// Counts the steps on a grid about a state whose regime differs from the expected one; None is not tested.
fn disagreements(
    state: &VectorMemory,
    zeta: f64,
    reach: f64,
    expected: impl Fn([f64; 2]) -> Option<MemoryRegime>,
) -> Result<(u32, u32), carom_special::RangeError> {
    let (mut wrong, mut tested) = (0, 0);
    for dx in linspace(-reach, reach, 61) {
        for dy in linspace(-reach, reach, 61) {
            let e = state.shift().plus([dx + 1e-5, dy + 2e-5]);
            if let Some(want) = expected([dx + 1e-5, dy + 2e-5]) {
                tested += 1;
                wrong += u32::from(regime(state, zeta, e)? != want);
            }
        }
    }
    Ok((wrong, tested))
}

fn agreement(statement: &str, (wrong, tested): (u32, u32)) -> Claim {
    Claim::holds(
        format!("{statement} ({tested} steps)"),
        wrong == 0 && tested > 1000,
        f64::from(wrong),
    )
}

/// Heat of a step that turns the slip annulus, from the slip, compared with the work of the force in small
/// parts minus the change of stored energy.
fn turning_claim(from: [f64; 2], to: [f64; 2]) -> Result<Claim, carom_special::RangeError> {
    const PARTS: usize = 4000;
    let mut fine = led(1.0, &[(1.0, from)])?;
    let (heat, stored) = (fine.dissipation(1.0, to), fine.stored_energy());
    let mut work = [0.0; 2];
    for part in 1..=PARTS {
        let (force, at) = (fine.force(), fine.shift());
        let next = from.plus(to.minus(from).times(part as f64 / PARTS as f64));
        let mean = force.plus(fine.advance(1.0, next)?).times(0.5);
        let way = next.minus(at);
        work = work.plus([mean[0] * way[0], mean[1] * way[1]]);
    }
    let lost = work.minus(fine.stored_energy().minus(stored));
    Ok(Claim::all_close(
        "heat of a shift from e₁ to (0.6, 0.6), whose slip turns, along x and y, over f F_z ζ",
        (0..2).map(|i| (heat[i], lost[i])),
        Absolute(1e-5),
    )
    .source("work of the force in 4000 parts less the energy stored"))
}

pub(super) fn draw_circle() -> FigureResult {
    let mut figure = Figure::new();
    let e_1 = [0.5, 0.0];
    figure.assumed("e₁, ζ", "(0.5, 0), 1");
    let mut panel = e_plane().titled("Where the second shift e₂ may end");
    // |e_2| < |e_1|: a new point of instantaneous adhesion (7.23).
    panel.add(
        Series::area("|e₂| < |e₁|: a point P₁ of instantaneous adhesion", circle([0.0; 2], 0.5))
            .coloured(2),
    );
    panel.add(Series::line("|e₂| = |e₁|", circle([0.0; 2], 0.5)).coloured(2));
    panel.add(Series::dotted("|e₂| = 1: complete sliding", circle([0.0; 2], 1.0)).coloured(1));
    path(&mut panel, &[e_1], &["e₁"]);
    let examples = [(polar(0.3, 120.0), "e₂: P₁"), (polar(0.75, 60.0), "e₂: slip goes on")];
    for (to, name) in examples {
        panel.add(Series::arrows("", [arrow(e_1, to)]).coloured(0));
        panel.add(Series::note(name, (to[0], to[1])).coloured(0));
    }
    figure.panel(panel);
    // The examples: zeta_2* of (7.20), and 1 - |e_2| of (7.5).
    let mut depths = Vec::new();
    for (to, _) in examples {
        let memory = led(1.0, &[(1.0, e_1), (1.0, to)])?;
        let step = to.minus(e_1);
        let turned = 1.0 + e_1.length() * step.dot(step) / (2.0 * e_1.dot(step));
        let expected = if to.length() < 0.5 { turned } else { 1.0 - to.length() };
        depths.push((memory.stick_depth(), expected));
    }
    figure
        .all_close("ζ₂* at the two ends drawn", depths, Absolute(1e-14))
        .source("(7.20), corrected, inside; (7.5) outside");
    figure.claim(turning_claim(e_1, [0.6, 0.6])?);
    let state = led(1.0, &[(1.0, e_1)])?;
    let found = disagreements(&state, 1.0, 1.2, |d| {
        let size = e_1.plus(d).length();
        if (size - 0.5).abs() < 1e-3 || size > 0.999 {
            None
        } else {
            Some(if size < 0.5 { MemoryRegime::Reversal } else { MemoryRegime::Slip })
        }
    })?;
    figure.claim(agreement("P₁ appears exactly inside the circle", found).source("(7.23)"));
    Ok(figure)
}

pub(super) fn draw_reflection() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("e₁", "0.5 at 20°");
    figure.assumed("de₂", "0.05 to 0.3 at 170°");
    let first = polar(0.5, 20.0);
    let (mut pairs, mut depths, mut arrows) = (Vec::new(), Vec::new(), Vec::new());
    let ends = linspace(0.05, 0.3, 6).into_iter().map(|size| first.plus(polar(size, 170.0)));
    for end in ends {
        let memory = led(1.0, &[(1.0, first), (1.0, end)])?;
        let Some(m) = memory.slip_direction() else { return Err("no slip".into()) };
        // Slip directions are opposite to tractions: beta_2 = 2 alpha_2 + 180 - beta_1, with
        // beta_1 = 200 degrees and alpha_2 = 170 degrees.
        let slip = polar(1.0, 2.0 * 170.0 + 180.0 - 200.0);
        pairs.extend([(m[0], -slip[0]), (m[1], -slip[1])]);
        let step = end.minus(first);
        let depth = 1.0 + first.length() * step.dot(step) / (2.0 * first.dot(step));
        depths.push((memory.stick_depth(), depth));
        // Body 1 slips against the traction that acts on it.
        arrows.push(arrow(end, end.minus(m.times(0.1))));
    }
    let mut panel = e_plane().titled("Slip of body 1 after e₁ at 20° and de₂ at 170°");
    let last = first.plus(polar(0.3, 170.0));
    path(&mut panel, &[first, last], &["e₁", ""]);
    let before = first.minus(polar(0.12, 20.0));
    panel.add(Series::arrows("slip after e₁, at β₁ = 200°", [arrow(first, before)]).coloured(1));
    panel.add(Series::arrows("slip after de₂, at β₂ = 320°", arrows).coloured(0));
    // The mirror of (7.29): across de_2.
    let mirror = [-0.1, 0.12].map(|length| last.plus(polar(length, 170.0)));
    panel.add(Series::dotted("line of de₂", mirror.map(|p| (p[0], p[1]))).coloured(2));
    let across = [-0.12, 0.12].map(|length| last.plus(polar(length, 80.0)));
    panel.add(Series::dashed("mirror, across de₂", across.map(|p| (p[0], p[1]))).coloured(2));
    figure.panel(panel);
    figure
        .all_close("ζ₂* for the six lengths", depths, Absolute(1e-14))
        .source("(7.20), corrected");
    figure
        .all_close("β₂ = 2 α₂ + π − β₁, whatever |de₂|", pairs, Absolute(1e-13))
        .source("(7.29), a reflection");
    Ok(figure)
}

/// 1 - ζ_N* of (7.38), the slip directions by reflection (7.29).
fn condition_radius(shifts: &[[f64; 2]]) -> f64 {
    let first = shifts[0];
    let (mut slip, mut radius) = (first.times(-1.0 / first.length()), first.length());
    for pair in shifts.windows(2) {
        let step = pair[1].minus(pair[0]);
        radius = step.dot(step) / (2.0 * step.dot(slip));
        slip = slip.minus(step.times(2.0 * slip.dot(step) / step.dot(step)));
    }
    radius
}

pub(super) fn draw_condition() -> FigureResult {
    let mut figure = Figure::new();
    let shifts = [[0.6, 0.0], [0.4, 0.15], [0.45, 0.05]];
    figure.assumed("e₁, e₂, e₃", "(0.6, 0), (0.4, 0.15), (0.45, 0.05), ζ = 1");
    let mut panel = e_plane().titled("Inside its circle the N-th shift makes a new point");
    path(&mut panel, &shifts, &["e₁", "e₂", "e₃"]);
    let (mut nested, mut radii) = (Vec::new(), Vec::new());
    for n in 1..=shifts.len() {
        let steps: Vec<(f64, [f64; 2])> = shifts[..n].iter().map(|&e| (1.0, e)).collect();
        let state = led(1.0, &steps)?;
        let Some(m) = state.slip_direction() else { return Err("no slip".into()) };
        // The points from which zeta_{N+1}* stays above zeta_N*: a ball that touches e.
        let radius = 1.0 - state.stick_depth();
        let centre = state.shift().minus(m.times(radius));
        panel.add(Series::line(format!("N = {}", n + 1), circle(centre, radius)).coloured(n - 1));
        nested.push((centre, radius));
        radii.push((radius, condition_radius(&shifts[..n])));
        let found = disagreements(&state, 1.0, 0.5, |d| {
            let size = distance(state.shift().plus(d), centre);
            ((size - radius).abs() > 1e-3 && size < radius).then_some(MemoryRegime::Reversal)
        })?;
        if n == 1 {
            figure.claim(agreement("a new point appears inside", found).source("(7.40)"));
        } else {
            let statement = format!("N = {}: a new point appears inside", n + 1);
            figure.at_most(statement, f64::from(found.0), 0.0).source("(7.40)");
        }
    }
    figure.panel(panel);
    figure
        .all_close("radii of the circles", radii, Absolute(1e-14))
        .source("(7.40): |e₁|, then |de_N-1|/(2 cos γ_N-1) with slip mirrored at each step");
    let outside = nested.windows(2).map(|pair| {
        let ((outer, big), (inner, small)) = (pair[0], pair[1]);
        distance(outer, inner) + small - big
    });
    figure
        .at_most(
            "each circle lies inside the one before",
            outside.fold(f64::NEG_INFINITY, f64::max),
            1e-12,
        )
        .source("text below (7.40)");
    Ok(figure)
}

pub(super) fn draw_varying() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("e₁, dζ", "(0.5, 0) at ζ = 1; ± 0.1");
    let e_1 = [0.5, 0.0];
    for (dz, title) in [(0.1, "dζ > 0"), (-0.1, "dζ < 0")] {
        let state = led(1.0, &[(1.0, e_1)])?;
        let outer = 0.5 + dz;
        let mut panel = e_plane().titled(title);
        panel.add(
            Series::area("inside (7.51): a point P₁ appears", circle([0.0; 2], outer)).coloured(2),
        );
        if dz > 0.0 {
            let label = "inside (7.53): complete adhesion";
            panel.add(Series::area(label, circle(e_1, dz)).coloured(0));
        }
        let limit = circle([0.0; 2], 1.0 + dz);
        panel.add(Series::dotted("|e₂| = ζ₂: complete sliding", limit).coloured(1));
        path(&mut panel, &[e_1], &["e₁"]);
        figure.panel(panel);
        // Between the circles, on the far and the near side.
        let mut depths = Vec::new();
        for degrees in [30.0, 100.0, 180.0, 250.0] {
            for share in [0.3, 0.7, 0.95] {
                let to = polar(share * outer, degrees);
                let memory = led(1.0, &[(1.0, e_1), (1.0 + dz, to)])?;
                // (7.48): with s_1 = -e_1/|e_1| and de'' = de_2 + s_1 dζ_2.
                let step = to.minus(e_1).plus([-dz, 0.0]);
                let depth = 1.0 + dz + step.dot(step) / (2.0 * step[0]);
                if to.minus(e_1).length() > dz.abs() {
                    depths.push((memory.stick_depth(), depth));
                }
            }
        }
        figure
            .all_close(format!("{title}: ζ₂* inside the first circle"), depths, Absolute(1e-13))
            .source("(7.48)");
        let found = disagreements(&state, 1.0 + dz, 1.1, |d| {
            let (size, step) = (e_1.plus(d).length(), d.length());
            let border = (size - outer).abs() < 1e-3 || (step - dz.abs()).abs() < 1e-3;
            if border || size > 0.998 + dz || (dz < 0.0 && step < -dz) {
                None
            } else if step < dz {
                Some(MemoryRegime::Adhesion)
            } else if size < outer {
                Some(MemoryRegime::Reversal)
            } else {
                Some(MemoryRegime::Slip)
            }
        })?;
        figure.claim(
            agreement(&format!("{title}: regimes as the circles say"), found)
                .source("(7.51), (7.53)"),
        );
    }
    Ok(figure)
}

pub(super) fn draw_equal_radii() -> FigureResult {
    let mut figure = Figure::new();
    let path = [(1.0, [0.6, 0.0]), (1.0, [0.4, 0.2])];
    figure.assumed("path (ζ, e)", "(1, (0.6, 0)), (1, (0.4, 0.2)); then dζ = ± 0.05");
    for (dz, title) in [(0.05, "dζ > 0"), (-0.05, "dζ < 0")] {
        let state = led(1.0, &path)?;
        let Some(m) = state.slip_direction() else { return Err("no slip".into()) };
        let depth = 1.0 - state.stick_depth();
        let centre = state.shift().minus(m.times(depth));
        let mut panel = e_plane().titled(title);
        let radius = depth + dz;
        panel.add(Series::line("(7.64): ζ₃* = ζ₂*", circle(centre, radius)).coloured(2));
        if dz > 0.0 {
            let label = "inside: complete adhesion";
            panel.add(Series::dashed(label, circle(state.shift(), dz)).coloured(0));
        }
        self::path(&mut panel, &path.map(|(_, e)| e), &["e₁", "e₂"]);
        figure.panel(panel);
        // On the circle the new slip annulus is exactly as deep as the old one.
        let mut pairs = Vec::new();
        // By (7.20), not from the state itself.
        let [first, second] = path.map(|(_, e)| e);
        let turn = second.minus(first);
        let old = 1.0 + first.length() * turn.dot(turn) / (2.0 * first.dot(turn));
        for degrees in (0..360).step_by(10) {
            let inside = centre.plus(polar(radius * (1.0 - 1e-9), f64::from(degrees)));
            let step = distance(inside, state.shift());
            if step > dz.abs() + 1e-3 {
                let mut memory = state.clone();
                memory.advance(1.0 + dz, inside)?;
                pairs.push((memory.stick_depth(), old));
            }
        }
        figure
            .all_close(format!("{title}: ζ₃* = ζ₂* on the circle"), pairs, Absolute(1e-6))
            .source("(7.64)");
    }
    figure.deviation(
        "denominator of (7.60) with s_N",
        "ζ_N* = ζ_N − |de''|²/(2 de''·s_{N−1}), de'' = de_N + s_{N−1} dζ_N",
        "index in (7.60)",
    );
    Ok(figure)
}
