//! Fig. 14.14: an ellipse with nu = 0.5 shifted along x and back.

use super::super::mesh::{APPROACH, Mesh, Touching, steps};
use super::angle_axis;
use crate::{Absolute, Figure, FigureResult, Marker, Panel, Series};
use carom_laws::law::Shift;
use carom_laws::memory::Memory;

/// Parts of the contact that stick after steps 2 to 5, by an independent program on another mesh.
const STICK: [f64; 4] = [0.797, 0.602, 0.404, 0.198];

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("a, b, ν, f, ζ, Δξ", "2, 1, 0.5, 1, 0.1, 0.0317");
    figure.assumed("elements", "60 × 30 (20 × 10 in the thesis)");
    let mesh = Mesh { poisson: [0.5; 2], ..Mesh::of([2.0, 1.0], [60, 30]) };
    let hertz = mesh.hertz()?;
    let stiffness = hertz.stiffness();
    // One fifth of the way to sliding a step, to the digits of the caption.
    let at = |xi: f64| Shift { zeta: APPROACH, xi, ..Shift::default() };
    let mut path = vec![at(0.0)];
    path.extend(steps(at(0.0), at(0.1585), 5));
    path.extend(steps(at(0.1585), at(-0.1585), 10));
    let run = mesh.follow(&path)?;
    let peak = hertz.at_approach(APPROACH)?.pressure(0.0, 0.0);
    let mut angles = Panel::new("√(x²/a² + y²/b²)", angle_axis());
    let mut sizes = Panel::new("√(x²/a² + y²/b²)", "|t|/(f p₀)");
    let radius = |cell: &Touching| (0.5 * cell.x).hypot(cell.y);
    for (colour, number) in [6, 8, 10, 12, 14, 16].into_iter().enumerate() {
        let (step, name) = (&run[number - 1], format!("step {number}"));
        let angle = step.touching().map(|cell| (radius(&cell), cell.angle()));
        angles.add(Series::markers(name.clone(), Marker::Dot, angle).coloured(colour));
        let size = step.touching().map(|cell| (radius(&cell), cell.size() / peak));
        sizes.add(Series::markers(name, Marker::Dot, size).coloured(colour));
    }
    figure.panel(angles);
    figure.panel(sizes);
    let mut memory: Memory<f64> = Memory::new();
    let mut pairs = Vec::new();
    for (shift, step) in path.iter().zip(&run) {
        let force = memory.advance(1.0, shift.xi * stiffness.c_x / stiffness.c_z / APPROACH)?;
        pairs.push((step.load.f_x / step.load.f_z, force));
    }
    figure
        .all_close("the force is that of chapter 7", pairs, Absolute(0.0045))
        .source("closed form with c_x of (5.25)");
    let sticks = STICK.into_iter().enumerate().map(|(i, part)| (run[i + 1].stick(), part));
    figure
        .all_close("parts that stick after steps 2 to 5", sticks, Absolute(0.01))
        .source("an independent half-space program");
    let turned = run[15].touching().map(|cell| {
        let angle = cell.angle().abs();
        angle.min(180.0 - angle)
    });
    figure
        .at_most(
            "in the last step the stress is along x within degrees",
            turned.fold(0.0, f64::max),
            4.7,
        )
        .source("an independent half-space program: 4.6");
    figure
        .close("c_z/c_x", stiffness.c_z / stiffness.c_x, 1.584_56, Absolute(6e-6))
        .source("(5.25) evaluated apart");
    figure.deviation(
        "c_1/c_2 = 1.585, c_y/c_z = 1.415",
        "c_z/c_x = 1.585, c_z/c_y = 1.415",
        "the caption prints the inverse ratios; Δξ = 0.0317 is a fifth of the way to sliding only so",
    );
    Ok(figure)
}
