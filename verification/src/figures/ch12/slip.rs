//! Fig. 12.1: slip of body 1 against body 2, and the stress of body 2 on body 1.

use super::super::mesh::{Mesh, Step, steps};
use crate::{Absolute, Arrow, Axis, Failure, Figure, FigureResult, Panel, Series};
use carom_laws::law::Shift;

const FRICTION: f64 = 0.3;

/// Both bodies with what acts on them.
fn sketch() -> Panel {
    let mut panel =
        Panel::new(Axis::bare("").between(-3.2, 3.2), Axis::bare("").between(-2.2, 2.2))
            .titled("What the bodies do to each other")
            .equal_aspect();
    for (y, sign) in [(0.45, 1.0), (-0.45, -1.0)] {
        let far = y + sign * 1.2;
        let outline = [(-2.0, y), (2.0, y), (2.0, far), (-2.0, far), (-2.0, y)];
        panel.add(Series::line("", outline).coloured(6));
    }
    panel.add(Series::note("body 2, shifted by Δξ", (-1.9, 1.2)).coloured(6));
    panel.add(Series::note("body 1", (-1.9, -1.4)).coloured(6));
    let arrow = |x: f64, to: f64, y: f64| Arrow { tail: (x, y).into(), head: (to, y).into() };
    panel.add(Series::arrows("stress σ₂₁ on body 1", [arrow(0.2, 1.8, -0.3)]).coloured(0));
    panel.add(Series::arrows("stress σ₁₂ on body 2", [arrow(1.8, 0.2, 0.3)]).coloured(1));
    panel
        .add(Series::arrows("slip s₁₂ of body 1 against 2", [arrow(-0.2, -1.8, -0.3)]).coloured(2));
    panel.add(Series::arrows("slip s₂₁ of body 2 against 1", [arrow(-1.8, -0.2, 0.3)]).coloured(3));
    panel
}

fn run() -> Result<Vec<Step>, Failure> {
    let mesh = Mesh { poisson: [0.3, 0.3], friction: FRICTION, ..Mesh::of([1.1, 1.1], [20, 20]) };
    let pressed = Shift { zeta: 0.1, ..Shift::default() };
    let end = Shift { xi: 0.02, eta: -0.005, omega: 0.01, ..pressed };
    let history: Vec<Shift> = std::iter::once(pressed).chain(steps(pressed, end, 3)).collect();
    mesh.follow(&history)
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed(
        "run",
        "sphere, 20 × 20 elements, ν = 0.3, f = 0.3; shift and twist in three steps",
    );
    figure.panel(sketch());
    let steps = run()?;
    let last = &steps[steps.len() - 1];
    let mut map = Panel::new("x", "y").titled("Stress on body 1 and slip of body 1").equal_aspect();
    map.add(last.arrows("stress", 0.3, |cell| cell.traction).coloured(0));
    map.add(last.arrows("slip", 0.3, |cell| cell.slip).coloured(2));
    figure.panel(map);

    let slipping = || last.touching().filter(|cell| !cell.sticks);
    figure
        .all_close(
            "slip opposes the stress on the same body",
            last.cosines_to_slip(),
            Absolute(1e-6),
        )
        .source("Coulomb (12.4): cosine of the angle between s₁₂ and σ₂₁");
    let sizes = slipping().map(|cell| (cell.size() / cell.pressure, FRICTION));
    figure.all_close("|σₜ|/σₙ = f where it slips", sizes, Absolute(1e-9)).source("(12.4)");
    let before = &steps[steps.len() - 2];
    let turn = last.state.shift.omega - before.state.shift.omega;
    let reach = |slip: [f64; 2]| slip[0].hypot(slip[1]);
    let stuck = || last.touching().filter(|cell| cell.sticks);
    let still = stuck().map(|cell| reach(cell.slip)).fold(0.0, f64::max);
    let printed = stuck()
        .map(|cell| reach([cell.slip[0] + 2.0 * cell.y * turn, cell.slip[1] - 2.0 * cell.x * turn]))
        .fold(0.0, f64::max);
    let moved = (last.state.shift.xi - before.state.shift.xi).abs();
    figure
        .at_most("no slip in the stick area, over Δξ", still / moved, 1e-7)
        .source("(12.2) and the sign of Ω that goes with it");
    figure
        .at_least("with the printed signs of (12.5) there is slip, over Δξ", printed / moved, 0.1)
        .source("(12.5): +y ΔΩ, −x ΔΩ, opposite to (12.2)");
    figure.deviation(
        "(12.5): sₓ = −Δξ + ΔU₁ + y ΔΩ, s_y = −Δη + ΔU₂ − x ΔΩ",
        "− y ΔΩ, + x ΔΩ",
        "s = 0 must follow from (12.2), else nothing sticks",
    );
    figure.deviation(
        "(12.8): forces with ΔxΔy beside elements of 2Δx by 2Δy",
        "the area of the element, with full widths",
        "chapter 4 calls half the width Δx, chapter 11 the full one",
    );
    Ok(figure)
}
