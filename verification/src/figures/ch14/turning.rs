//! Figs. 14.6 to 14.13: spheres shifted to sliding, then in another direction.

use super::super::mesh::{APPROACH, Mesh, Step, steps};
use super::super::outline::ellipse;
use super::angle_axis;
use crate::{Absolute, Arrow, Axis, Failure, Figure, FigureResult, Marker, Panel, Point, Series};
use carom_laws::law::Shift;
use carom_laws::memory::VectorMemory;

const ELEMENTS: usize = 30;
/// Steps of the second leg.
const LEG: usize = 5;

/// A second leg of fig. 14.6: its direction and length over zeta, and how far the stress turns from
/// that of chapter 7 in the middle and at the rim, by an independent program.
struct Leg {
    name: &'static str,
    degrees: f64,
    length: f64,
    middle: f64,
    rim: f64,
}

/// To a circle of radius zeta about the origin where the direction turns back.
fn leg(number: usize) -> Leg {
    let to_circle = |degrees: f64| 2.0 * degrees.to_radians().cos().abs();
    let make = |name, degrees: f64, length, middle, rim| Leg { name, degrees, length, middle, rim };
    match number {
        2 => make("1-2", 165.0, to_circle(165.0), -10.0, 11.0),
        3 => make("1-3", 150.0, to_circle(150.0), -16.0, 23.0),
        4 => make("1-4", 135.0, to_circle(135.0), -18.0, 33.0),
        5 => make("1-5", 120.0, to_circle(120.0), -17.0, 42.0),
        6 => make("1-6", 90.0, 1.0, -2.0, 26.0),
        _ => make("1-7", 45.0, 1.0, 3.0, 13.0),
    }
}

impl Leg {
    /// Shifts over zeta.
    fn end(&self) -> [f64; 2] {
        let angle = self.degrees.to_radians();
        [1.0 + self.length * angle.cos(), self.length * angle.sin()]
    }

    /// Pressed in one step, shifted to sliding in another, then along the leg.
    fn history(&self, sliding: f64) -> Vec<Shift> {
        let at = |[x, y]: [f64; 2]| Shift {
            zeta: APPROACH,
            xi: x * sliding,
            eta: y * sliding,
            ..Shift::default()
        };
        let mut path = vec![at([0.0; 2])];
        path.extend(steps(at([0.0; 2]), at([1.0, 0.0]), LEG));
        path.extend(steps(at([1.0, 0.0]), at(self.end()), LEG));
        path
    }

    /// Chapter 7's law after a part of the leg.
    fn memory(&self, part: f64) -> Result<VectorMemory, Failure> {
        let mut memory = VectorMemory::new();
        memory.advance(1.0, [0.0; 2])?;
        memory.advance(1.0, [1.0, 0.0])?;
        let [x, y] = self.end();
        memory.advance(1.0, [1.0 + part * (x - 1.0), part * y])?;
        Ok(memory)
    }

    /// The direction of the force in chapter 7 at the end, in degrees.
    fn theory(&self) -> Result<f64, Failure> {
        let [x, y] = self.memory(1.0)?.force();
        Ok(y.atan2(x).to_degrees())
    }

    /// Chapter 7's tractions over f p_0 from the middle to the rim.
    fn tractions(&self, part: f64) -> Result<Vec<(f64, [f64; 2])>, Failure> {
        let memory = self.memory(part)?;
        let at = |r: f64| (r, memory.superpose(|z| (z - r * r).max(0.0).sqrt()));
        Ok((0..200).map(|i| at(f64::from(i) / 200.0)).collect())
    }
}

pub(super) fn legs() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("first leg", "ζ = 0.1, ξ = 0.1: all slips");
    figure.assumed("directions of the others", "165°, 150°, 135°, 120° (2 ζ |cos|), 90°, 45° (ζ)");
    let mut panel =
        Panel::new(Axis::linear("ξ/ζ").between(-0.8, 2.0), Axis::linear("η/ζ").between(-0.3, 1.3))
            .equal_aspect();
    let arrow = |[a, b]: [f64; 2], [c, d]: [f64; 2]| Arrow {
        tail: Point::new(a, b),
        head: Point::new(c, d),
    };
    panel.add(Series::arrows("0-1", [arrow([0.0; 2], [1.0, 0.0])]));
    for number in 2..=7 {
        let leg = leg(number);
        panel.add(Series::arrows(leg.name, [arrow([1.0, 0.0], leg.end())]));
    }
    panel.add(Series::dotted("sliding", ellipse([0.0; 2], [1.0; 2], 120)));
    figure.panel(panel);
    // Where chapter 7's law slides at the end of each leg.
    let mut limits = Vec::new();
    for number in 2..=7 {
        let mut memory = VectorMemory::new();
        memory.advance(1.0, [0.0; 2])?;
        memory.advance(1.0, [1.0, 0.0])?;
        let [x, y] = memory.advance(1.0, leg(number).end())?;
        limits.push((x.hypot(y), 1.0));
    }
    figure
        .all_close("each leg ends in complete sliding", limits, Absolute(1e-12))
        .source("the thesis, section 14.2: until complete sliding occurs");
    Ok(figure)
}

/// Angles of the stress against the radius, 0 to 360 degrees.
fn angles(step: &Step) -> Vec<(f64, f64)> {
    step.touching().map(|cell| (cell.x.hypot(cell.y), cell.angle().rem_euclid(360.0))).collect()
}

/// Mean and spread of the angle in rings of width 0.1, from the middle outwards.
fn rings(step: &Step) -> Vec<[f64; 2]> {
    let mut rings = vec![Vec::new(); 10];
    for (r, angle) in angles(step) {
        rings[((10.0 * r) as usize).min(9)].push(angle);
    }
    rings
        .iter()
        .map(|angles| {
            let count = angles.len() as f64;
            let mean = angles.iter().sum::<f64>() / count;
            let square = angles.iter().map(|a| (a - mean) * (a - mean)).sum::<f64>() / count;
            [mean, square.sqrt()]
        })
        .collect()
}

/// Numerical tractions as markers; those of chapter 7, where a leg is given, as lines.
fn panels(
    figure: &mut Figure,
    mesh: &Mesh,
    run: &[Step],
    theory: Option<&Leg>,
) -> Result<(), Failure> {
    let peak = mesh.hertz()?.at_approach(APPROACH)?.pressure(0.0, 0.0);
    let mut directions = Panel::new("r/a", angle_axis());
    let mut sizes = Panel::new("r/a", "|t|/(f p₀)");
    for (colour, number) in [8, 10, LEG + 6].into_iter().enumerate() {
        let (name, step) = (format!("step {number}"), &run[number - 1]);
        directions.add(Series::markers(name.clone(), Marker::Dot, angles(step)).coloured(colour));
        let size = step.touching().map(|cell| (cell.x.hypot(cell.y), cell.size() / peak));
        sizes.add(Series::markers(name, Marker::Dot, size).coloured(colour));
        if let Some(leg) = theory {
            let lines = leg.tractions((number - LEG - 1) as f64 / LEG as f64)?;
            let angle = |[x, y]: [f64; 2]| y.atan2(x).to_degrees().rem_euclid(360.0);
            let line = lines.iter().map(|(r, t)| (*r, angle(*t)));
            directions.add(Series::line("", line).coloured(colour));
            let line = lines.iter().map(|(r, [x, y])| (*r, x.hypot(*y)));
            sizes.add(Series::line("", line).coloured(colour));
        }
    }
    figure.panel(directions);
    figure.panel(sizes);
    Ok(())
}

fn draw(number: usize) -> FigureResult {
    let mut figure = Figure::new();
    let leg = leg(number);
    figure.stated("ν, f, ζ", "0, 1, 0.1");
    figure
        .assumed("second leg", format!("5 steps along {}°, {:.3} ζ long", leg.degrees, leg.length));
    figure.assumed("elements", format!("{ELEMENTS} × {ELEMENTS}"));
    let mesh = Mesh::of([1.0; 2], [ELEMENTS; 2]);
    let run = mesh.follow(&leg.history(APPROACH))?;
    panels(&mut figure, &mesh, &run, Some(&leg))?;
    let last = &run[run.len() - 1];
    let limit = last.touching().map(|cell| (cell.size() / cell.pressure, 1.0));
    figure.all_close("at the end all slips at f p", limit, Absolute(1e-9)).source("Coulomb's law");
    let (theory, peak) = (leg.theory()?, mesh.hertz()?.at_approach(APPROACH)?.pressure(0.0, 0.0));
    let mean = |values: &mut dyn Iterator<Item = f64>| {
        let all: Vec<f64> = values.collect();
        all.iter().sum::<f64>() / all.len() as f64
    };
    let line = leg.tractions(0.4)?;
    let differences = run[LEG + 2].touching().map(|cell| {
        let r = cell.x.hypot(cell.y);
        let [x, y] = line[((200.0 * r) as usize).min(199)].1;
        (cell.size() / peak - x.hypot(y)).abs()
    });
    let difference = mean(&mut { differences });
    figure
        .at_most("in step 8 the size is chapter 7's, in the mean over f p₀", difference, 0.05)
        .source("the thesis, below fig. 14.12: it corresponds very well");
    let rings = rings(last);
    let turned = |ring: usize| rings[ring][0] - theory;
    let source = "an independent half-space program on another mesh";
    figure
        .close(
            "in the middle the stress runs ahead of chapter 7's direction, or lags, by degrees",
            turned(0),
            leg.middle,
            Absolute(6.0),
        )
        .source(source);
    figure
        .close("at the rim it differs the other way", turned(9), leg.rim, Absolute(6.0))
        .source(source);
    let spread = rings.iter().map(|ring| ring[1]).fold(0.0, f64::max);
    figure
        .at_most("for ν = 0 the angle is constant on circles, to a ring's width", spread, 4.0)
        .source("the thesis, below fig. 14.12");
    Ok(figure)
}

macro_rules! each {
    ($($name:ident $number:literal),*) => {
        $(pub(super) fn $name() -> FigureResult {
            draw($number)
        })*
    };
}

each!(to_2 2, to_3 3, to_4 4, to_5 5, to_6 6, to_7 7);

/// Fig. 14.13: the leg 1-2 with nu = 0.5.
pub(super) fn incompressible() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("ν, f, ζ", "0.5, 1, 0.1; load history 1-2");
    figure.assumed("shifts", "3/2 of those of fig. 14.7, so that all slips after the first leg");
    figure.assumed("elements", format!("{ELEMENTS} × {ELEMENTS}"));
    let soft = Mesh { poisson: [0.5; 2], ..Mesh::of([1.0; 2], [ELEMENTS; 2]) };
    let run = soft.follow(&leg(2).history(1.5 * APPROACH))?;
    panels(&mut figure, &soft, &run, None)?;
    let stiff = Mesh::of([1.0; 2], [ELEMENTS; 2]).follow(&leg(2).history(APPROACH))?;
    let spread = |run: &[Step], number: usize| {
        rings(&run[number - 1]).iter().map(|ring| ring[1]).fold(0.0, f64::max)
    };
    figure
        .at_least(
            "the angle is no more constant on circles: its spread over that for ν = 0",
            spread(&run, 11) / spread(&stiff, 11),
            1.3,
        )
        .source("the thesis, below fig. 14.12");
    let last = &run[10];
    let limit = last.touching().map(|cell| (cell.size() / cell.pressure, 1.0));
    figure.all_close("at the end all slips at f p", limit, Absolute(1e-9)).source("Coulomb's law");
    Ok(figure)
}
