//! Figs. 7.12 to 7.14: three histories in which the direction of the shift turns.

use super::super::mesh::{APPROACH, Mesh, Step};
use super::led::{distance, polar};
use super::ring_contact::RingContact;
use crate::{Absolute, Claim, Failure, Figure, FigureResult, Marker, Panel, Series};
use carom_laws::law::Shift;
use carom_laws::memory::{Lateral, MemoryRegime, VectorMemory};
use carom_laws::sliders::SliderLaw;

/// A path of the thesis: a number of steps to e_1, then a number in the second direction.
pub(super) struct Example {
    first: [f64; 2],
    second: [f64; 2],
    steps: usize,
    /// Final state by the closed theory, and of a half-space with rings.
    theory: [f64; 2],
    rings: [f64; 2],
    /// Final state on a mesh of 60 by 60, by an independent half-space program.
    mesh: [f64; 2],
}

impl Example {
    pub(super) fn new(number: usize) -> Self {
        match number {
            1 => Self {
                first: [0.5, 0.0],
                second: polar(0.5_f64.sqrt(), 135.0),
                steps: 5,
                theory: [0.0, 1.0 - 0.5_f64.powf(1.5)],
                rings: [-0.037_01, 0.635_93],
                mesh: [-0.035_1, 0.636_63],
            },
            2 => Self {
                first: [1.0, 0.0],
                second: polar(2.0_f64.sqrt(), 135.0),
                steps: 10,
                theory: [0.0, 1.0],
                rings: [-0.205_22, 0.939_30],
                mesh: [-0.198_8, 0.940_4],
            },
            _ => Self {
                first: [1.0, 0.0],
                second: polar(2.0 * 15.0_f64.to_radians().cos(), 165.0),
                steps: 10,
                theory: [-0.75_f64.sqrt(), 0.5],
                rings: [-0.899_92, 0.423_15],
                mesh: [-0.899_0, 0.425_3],
            },
        }
    }

    /// All points e; the first is the compression.
    pub(super) fn path(&self) -> Vec<[f64; 2]> {
        let n = self.steps;
        let part = |i: usize| i as f64 / n as f64;
        let first = (0..=n).map(|i| self.first.times(part(i)));
        let second = (1..=n).map(|i| self.first.plus(self.second.times(part(i))));
        first.chain(second).collect()
    }
}

fn draw(number: usize) -> FigureResult {
    let example = Example::new(number);
    let mut figure = Figure::new();
    figure.stated("contact", "spheres, ν = 0, equal G, f = 1, ζ constant");
    figure.derived("e₁", format!("({}, 0) ζ in {} steps", example.first[0], example.steps));
    figure.derived("end", "in as many steps along 135° (examples 1, 2) or 165° (3)");
    figure.stated("numerical markers", "100 elements: 12 × 12 on the square, 112 in the circle");
    figure.assumed("other markers", "60 rings on a half-space, and springs with sliders");
    let (mut memory, mut sliders) = (VectorMemory::new(), SliderLaw::new(400, 1.0, 1.0)?);
    let mut rings = RingContact::new(60)?;
    let mut from = [0.0; 2];
    let mut ring_markers: [Vec<(f64, f64)>; 2] = Default::default();
    let mut curves: [Vec<(f64, f64)>; 5] = Default::default();
    let mut markers: [Vec<(f64, f64)>; 2] = Default::default();
    let mut reversal = None;
    for (i, e) in example.path().into_iter().enumerate() {
        let step = (i + 1) as f64;
        let force = memory.advance(1.0, e)?;
        let other = sliders.advance(1.0, e)?;
        for part in 1..=4 {
            rings.advance(from.plus(e.minus(from).times(f64::from(part) / 4.0)))?;
        }
        from = e;
        for k in 0..2 {
            ring_markers[k].push((step, rings.force()[k]));
            curves[k].push((step, force[k]));
            curves[2 + k].push((step, e[k]));
            markers[k].push((step, other[k]));
        }
        curves[4].push((step, memory.stick_depth()));
        if memory.regime() == MemoryRegime::Reversal && reversal.is_none() {
            reversal = Some((step, memory.stick_depth()));
        }
    }
    let mut forces = Panel::new("step", "F/(f F_z)");
    for k in 0..2 {
        forces.add(Series::line(["F_x", "F_y"][k], curves[k].clone()).coloured(k));
        let name = ["F_x, sliders", "F_y, sliders"][k];
        forces.add(Series::markers(name, Marker::Circle, markers[k].clone()).coloured(k));
        let name = ["F_x, rings", "F_y, rings"][k];
        let cross = Series::markers(name, Marker::Cross, ring_markers[k].clone());
        forces.add(cross.coloured(k).sized(0.6));
    }
    let run = example.numerical(12)?;
    for k in 0..2 {
        let points = run.iter().enumerate().map(|(i, step)| ((i + 1) as f64, mesh_force(step)[k]));
        let name = ["F_x, numerical", "F_y, numerical"][k];
        forces.add(Series::markers(name, Marker::Square, points).coloured(k).sized(1.7));
    }
    figure.panel(forces);
    numerical_claims(&mut figure, &example, number)?;
    let mut shifts = Panel::new("step", "e, ζ*/ζ");
    for (k, name) in ["e_x", "e_y", "ζ*/ζ"].into_iter().enumerate() {
        shifts.add(Series::line(name, curves[2 + k].clone()));
    }
    figure.panel(shifts);
    figure.claim(work_claim(&example)?);
    let end = memory.force();
    figure
        .all_close(
            "the theory ends where the thesis says",
            end.into_iter().zip(example.theory),
            Absolute(1e-6),
        )
        .source("closed form at the end of the path");
    let first = example.steps as f64 + 2.0;
    figure
        .close(
            "P₁ appears in the step after the turn",
            reversal.map_or(0.0, |r| r.0),
            first,
            Absolute(0.0),
        )
        .source("text of 7.7");
    if number == 1 {
        let depths: Vec<(f64, f64)> =
            curves[4][6..11].iter().map(|p| p.1).zip([0.9, 0.8, 0.7, 0.6, 0.5]).collect();
        figure.all_close("ζ*/ζ in steps 7 to 11", depths, Absolute(1e-12)).source("(7.20)");
    }
    figure
        .all_close(
            "F_x, F_y over f F_z of the rings at the end",
            rings.force().into_iter().zip(example.rings),
            Absolute(2e-3),
        )
        .source("independent program: half-space of 200 rings, 4 parts a step");
    let allowed = [0.002, 0.013, 0.006][number - 1];
    figure
        .all_close(
            "F_x, F_y of the springs with sliders at the end",
            sliders.force().into_iter().zip(example.rings),
            Absolute(allowed),
        )
        .source("independent program: half-space of 200 rings, 4 parts a step");
    let far = [0.038, 0.214, 0.084][number - 1];
    figure
        .close(
            "how far the closed law ends from the rings",
            distance(end, rings.force()),
            far,
            Absolute(2e-3),
        )
        .source("theory of 7.7 less the end of the independent program's rings");
    let caption = format!("text names fig. 7.{}", 12 + number);
    figure.deviation(caption, format!("fig. 7.{}", 11 + number), "numbers of figures in 7.7");
    Ok(figure)
}

/// Forces over f F_z.
fn mesh_force(step: &Step) -> [f64; 2] {
    [step.load.f_x / step.load.f_z, step.load.f_y / step.load.f_z]
}

/// The numerical solution on a finer mesh compared with that of another program.
fn numerical_claims(figure: &mut Figure, example: &Example, number: usize) -> Result<(), Failure> {
    let (run, source) = (example.numerical(40)?, "an independent half-space program, 60 by 60");
    let end = mesh_force(&run[run.len() - 1]);
    figure
        .all_close(
            "F_x, F_y over f F_z of the numerical solution at the end",
            end.into_iter().zip(example.mesh),
            Absolute(2e-3),
        )
        .source(source);
    // Fraction of the contact that sticks before the turn, after it, and at the end.
    let turn = example.steps;
    let sticks = [turn, turn + 1, 2 * turn].map(|i| run[i].stick());
    let known = match number {
        1 => [0.5049, 0.8945, 0.4824],
        2 => [0.0, 0.8945, 0.0],
        _ => [0.0, 0.9058, 0.0],
    };
    figure
        .all_close(
            "parts that stick before the turn, after it, at the end",
            sticks.into_iter().zip(known),
            Absolute(0.03),
        )
        .source(source);
    Ok(())
}

impl Example {
    /// The history on a mesh of so many elements along each side.
    pub(super) fn numerical(&self, elements: usize) -> Result<Vec<Step>, Failure> {
        let shifts = self.path().into_iter().map(|[x, y]| Shift {
            zeta: APPROACH,
            xi: x * APPROACH,
            eta: y * APPROACH,
            ..Shift::default()
        });
        Mesh::of([1.0; 2], [elements; 2]).follow(&shifts.collect::<Vec<_>>())
    }
}

/// Work of the force along the path, compared with the stored energy and the heat of the law.
fn work_claim(example: &Example) -> Result<Claim, carom_special::RangeError> {
    const PARTS: usize = 400;
    let (mut whole, mut fine) = (VectorMemory::new(), VectorMemory::new());
    let (mut work, mut heat) = (0.0, 0.0);
    for e in example.path() {
        heat += whole.dissipation(1.0, e).dot([1.0; 2]);
        whole.advance(1.0, e)?;
        let from = fine.shift();
        for part in 1..=PARTS {
            let (before, at) = (fine.force(), fine.shift());
            let to = from.plus(e.minus(from).times(part as f64 / PARTS as f64));
            let after = fine.advance(1.0, to)?;
            work += 0.5 * before.plus(after).dot(to.minus(at));
        }
    }
    let stored = whole.stored_energy().dot([1.0; 2]);
    Ok(Claim::close(
        "energy stored and turned into heat by the closed law, over f F_z ζ",
        stored + heat,
        work,
        Absolute(2e-3),
    )
    .source("work of its force along the path, in 400 parts a step"))
}

pub(super) fn draw_first() -> FigureResult {
    draw(1)
}

pub(super) fn draw_second() -> FigureResult {
    draw(2)
}

pub(super) fn draw_third() -> FigureResult {
    draw(3)
}
