//! Fig. 7.15: directions of slip and stress over the contact, computed with rings that slip along their own
//! tractions.

use carom_laws::memory::{Lateral, VectorMemory};
use carom_laws::sliders::SliderLaw;

use super::super::outline::circle;
use super::examples::Example;
use super::led::polar;
use super::ring_contact::RingContact;
use crate::{Absolute, Arrow, Failure, Figure, FigureResult, Marker, Panel, Point, Series};

const RINGS: usize = 80;
/// Number of parts of each step; the slip is that of the last part.
const PARTS: usize = 4;
/// Meshes along a diameter, as in the thesis.
const MESH: usize = 10;

/// Radius over a and angle of slip in degrees, for a half-space with 200 rings and 4 parts per step.
const HALF_SPACE: [[f64; 2]; 8] = [
    [0.997, -18.82],
    [0.903, -19.21],
    [0.750, -20.56],
    [0.503, -25.81],
    [0.250, -35.63],
    [0.143, -39.29],
    [0.103, -40.15],
    [0.003, -41.30],
];

fn degrees(v: [f64; 2]) -> f64 {
    libm::atan2(v[1], v[0]).to_degrees()
}

/// A quantity of the rings at a radius, interpolated linearly.
fn at(rings: &RingContact, values: &[[f64; 2]], radius: f64) -> [f64; 2] {
    let radii = rings.radii();
    let above = radii.partition_point(|r| *r < radius).clamp(1, radii.len() - 1);
    let part = (radius - radii[above - 1]) / (radii[above] - radii[above - 1]);
    values[above - 1].times(1.0 - part).plus(values[above].times(part))
}

/// Slip of body 1 and stress at the centres of the meshes inside the circle.
fn map(rings: &RingContact) -> Panel {
    let mut panel =
        Panel::new("x/a", "y/a").titled("10 by 10 meshes, after step 21").equal_aspect();
    let (mut slips, mut stresses) = (Vec::new(), Vec::new());
    let width = 2.0 / MESH as f64;
    for row in 0..MESH {
        for column in 0..MESH {
            let [x, y] = [column, row].map(|i| (i as f64 + 0.5) * width - 1.0);
            let radius = libm::hypot(x, y);
            if radius >= 1.0 {
                continue;
            }
            let arrow = |v: [f64; 2]| Arrow {
                tail: Point::new(x, y),
                head: Point::new(x + v[0], y + v[1]),
            };
            let slip = at(rings, rings.slips(), radius);
            slips.push(arrow(slip.times(-0.8 * width / slip.length())));
            stresses.push(arrow(at(rings, rings.tractions(), radius).times(0.8 * width)));
        }
    }
    panel.add(Series::line("edge of the contact", circle([0.0; 2], 1.0)).coloured(6));
    panel.add(Series::arrows("direction of slip of body 1", slips).coloured(0));
    panel.add(Series::arrows("stress on body 1, by its size", stresses).coloured(1));
    panel
}

/// The angles of the reversed vectors, by the radius of their rings.
fn angles(rings: &RingContact, values: &[[f64; 2]]) -> Vec<(f64, f64)> {
    let pairs = rings.radii().iter().zip(values);
    pairs.map(|(&radius, v)| (radius, degrees(v.times(-1.0)))).collect()
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("history", "example 3, step 21; 10 by 10 meshes; ν = 0");
    figure.assumed("law", "Coulomb's, ring by ring on a half-space: 80 rings, 4 parts a step");
    let path = Example::new(3).path();
    let (mut memory, mut rings) = (VectorMemory::new(), RingContact::new(RINGS)?);
    let mut from = [0.0; 2];
    for &e in &path {
        memory.advance(1.0, e)?;
        for part in 1..=PARTS {
            rings.advance(from.plus(e.minus(from).times(part as f64 / PARTS as f64)))?;
        }
        from = e;
    }
    figure.panel(map(&rings));
    let (slip, stress) = (angles(&rings, rings.slips()), angles(&rings, rings.tractions()));
    let theory: Vec<(f64, f64)> =
        rings.radii().iter().map(|&r| (r, degrees(memory.traction(r * r).times(-1.0)))).collect();
    let mut panel = Panel::new("ρ/a", "angle / degrees").titled("Across the contact");
    panel.add(Series::line("slip", slip.iter().copied()).coloured(0));
    panel.add(Series::dashed("stress, reversed", stress.iter().copied()).coloured(1));
    panel.add(Series::dotted("closed law of chapter 7, both", theory.iter().copied()).coloured(2));
    let markers = HALF_SPACE.map(|[radius, angle]| (radius, angle));
    panel.add(Series::markers("slip by another program", Marker::Circle, markers).coloured(0));
    figure.panel(panel);
    numerical(&mut figure)?;
    ring_claims(&mut figure, &rings, &slip);
    slider_claim(&mut figure, &path, &rings)?;
    law_claims(&mut figure, &memory, &theory)?;
    figure.deviation(
        "slip from -15° at the border to -35° at the centre",
        "-19° to -41°, and -35° at a quarter of the radius",
        "the angle in the middle follows the last increment, which the thesis does not print to the \
         digit; the numerical solution on its mesh gives -19° to -39°",
    );
    Ok(figure)
}

/// Slip and stress of the numerical solution after step 21, on the thesis's mesh and a finer one.
fn numerical(figure: &mut Figure) -> Result<(), Failure> {
    let example = Example::new(3);
    let coarse = example.numerical(MESH)?;
    let last = &coarse[coarse.len() - 1];
    let mut panel =
        Panel::new("x/a", "y/a").titled("numerical solution, 10 by 10 elements").equal_aspect();
    panel.add(Series::line("edge of the contact", circle([0.0; 2], 1.0)).coloured(6));
    panel.add(last.arrows("slip of body 1", 0.2, |cell| cell.slip).coloured(0));
    panel.add(last.arrows("stress on body 1", 0.2, |cell| cell.traction).coloured(1));
    figure.panel(panel);
    // The slip of body 2 against body 1, minus 180 degrees, from the rim to the centre.
    let range = |elements: usize| -> Result<[f64; 2], Failure> {
        let run = example.numerical(elements)?;
        let angles: Vec<f64> =
            run[run.len() - 1].touching().map(|cell| degrees(cell.slip)).collect();
        let least = angles.iter().copied().fold(f64::INFINITY, f64::min);
        Ok([angles.iter().copied().fold(f64::NEG_INFINITY, f64::max), least])
    };
    let source = "an independent half-space program";
    for (elements, known) in [(MESH, [-18.8, -38.8]), (40, [-18.7, -40.3])] {
        figure
            .all_close(
                format!("slip at the border and in the middle, {elements} by {elements} elements"),
                range(elements)?.into_iter().zip(known),
                Absolute(0.6),
            )
            .source(source);
    }
    let opposed = last.touching().map(|cell| {
        let turn = degrees(cell.slip) - cell.angle();
        (turn - 360.0 * (turn / 360.0).floor(), 180.0)
    });
    figure.all_close("slip opposes the stress", opposed, Absolute(1e-3)).source("Coulomb's law");
    Ok(())
}

fn ring_claims(figure: &mut Figure, rings: &RingContact, slip: &[(f64, f64)]) {
    let found = HALF_SPACE.map(|[radius, angle]| {
        let v = at(rings, rings.slips(), radius.clamp(slip[0].0, slip[slip.len() - 1].0));
        (degrees(v.times(-1.0)), angle)
    });
    figure
        .all_close("angle of slip at eight radii, in degrees", found, Absolute(0.6))
        .source("independent program: half-space of 200 rings, 4 parts a step");
    figure
        .decreasing(
            "the slip turns all the way from the border to the centre",
            slip.iter().rev().map(|point| point.1),
        )
        .source("text of 7.7: -15° at the border, -35° at the centre");
    let ends = [-0.899_92, 0.423_15];
    figure
        .all_close("F_x, F_y over f F_z", rings.force().into_iter().zip(ends), Absolute(2e-3))
        .source("independent program: half-space of 200 rings, 4 parts a step");
    let pairs = rings.radii().iter().zip(rings.tractions());
    figure
        .all_close(
            "every ring carries f p_z",
            pairs.map(|(r, t)| (t.length(), (1.0 - r * r).sqrt())),
            Absolute(1e-12),
        )
        .source("Coulomb's law: the whole contact slides");
    let pairs = rings.slips().iter().zip(rings.tractions());
    figure
        .all_close(
            "and slips along its stress, in degrees",
            pairs.map(|(slip, t)| (degrees(*slip), degrees(*t))),
            Absolute(0.05),
        )
        .source("Coulomb's law");
}

/// Claims that the springs with sliders, which are not a half-space, approximate the stress of the rings.
fn slider_claim(
    figure: &mut Figure,
    path: &[[f64; 2]],
    rings: &RingContact,
) -> Result<(), Failure> {
    let mut sliders = SliderLaw::new(400, 1.0, 1.0)?;
    for &e in path {
        sliders.advance(1.0, e)?;
    }
    // int_rho dW/dx dx/(2 sqrt(x^2 - rho^2)), W straight in x^2 between springs.
    let edge = std::iter::once((1.0, sliders.shift()));
    let nodes: Vec<(f64, [f64; 2])> = sliders.springs().chain(edge).collect();
    let stress = |radius: f64| {
        let root = |depth: f64| (depth - radius * radius).max(0.0).sqrt();
        nodes.windows(2).filter(|pair| pair[1].0 > radius * radius).fold([0.0; 2], |sum, pair| {
            let [(low, from), (high, to)] = [pair[0], pair[1]];
            sum.plus(to.minus(from).times((root(high) - root(low)) / (high - low)))
        })
    };
    let pairs = [0.3, 0.5, 0.7, 0.9].into_iter().flat_map(|radius| {
        let (found, expected) = (stress(radius), at(rings, rings.tractions(), radius));
        [(found[0], expected[0]), (found[1], expected[1])]
    });
    figure
        .all_close(
            "stress of springs with sliders at four radii, over f p_z of the centre",
            pairs,
            Absolute(0.05),
        )
        .source("the rings of the figure; springs are bounded one by one, not point by point");
    Ok(())
}

fn law_claims(
    figure: &mut Figure,
    memory: &VectorMemory,
    theory: &[(f64, f64)],
) -> Result<(), Failure> {
    // 2 times 165 degrees + 180 less the 180 of the first slip, (7.29).
    let slip = memory.slip_direction().ok_or("the contact slips")?.times(-1.0);
    let expected = polar(1.0, 2.0 * 165.0 + 180.0 - 180.0);
    figure
        .all_close(
            "the closed law slips at -30°",
            (0..2).map(|i| (slip[i], expected[i])),
            Absolute(1e-6),
        )
        .source("(7.29), and text of 7.7");
    figure
        .all_close(
            "its traction is opposite all over the contact",
            theory.iter().map(|point| (point.1, -30.0)),
            Absolute(1e-3),
        )
        .source("(7.16)");
    let size = memory.traction(0.25).length();
    figure
        .close("and f p_z in size", size, (1.0 - 0.25_f64).sqrt(), Absolute(1e-9))
        .source("Coulomb's law");
    Ok(())
}
