//! Proposition 5: large deformation of expansion bellows.

use crate::{Absolute, Axis, Failure, Figure, FigureResult, Marker, Panel, Relative, Series};
use carom_shells::Wall;
use carom_shells::bellows::{
    Axial, Bellows, BellowsLoad, BellowsState, Meridian, PathEnd, WallPoint,
};
use carom_special::quadrature::GaussLegendre;
use std::f64::consts::{PI, TAU};

/// R = 10, amplitude 1, pitch 3, t = 0.1, E = 1.
fn corrugated() -> Result<Bellows, Failure> {
    Ok(Bellows::new(Meridian::sine(10.0, 1.0, 3.0)?, Wall::new(1.0, 0.3, 0.1)?, 32)?)
}

fn state(bellows: &Bellows, pressure: f64, growth: f64) -> Result<BellowsState, Failure> {
    Ok(bellows.solve(BellowsLoad::new(pressure, Axial::Dilatation(growth))?)?)
}

/// P5.1: the meridian at rest, stretched, pressed and under pressure.
fn shapes(figure: &mut Figure, bellows: &Bellows) -> Result<(), Failure> {
    let mut panel =
        Panel::new(Axis::linear("r"), Axis::linear("z")).titled("Meridian of one corrugation");
    let loads = [
        ("at rest", 0.0, 0.0),
        ("Δ = 0.6", 0.0, 0.6),
        ("Δ = -0.6", 0.0, -0.6),
        ("p = 0.001 E, Δ = 0", 1e-3, 0.0),
    ];
    for (name, pressure, growth) in loads {
        let state = state(bellows, pressure, growth)?;
        let places = state.profile();
        let length = 3.0 + growth;
        let up = places.iter().map(|at| (at.radius, at.height));
        let down = places.iter().rev().map(|at| (at.radius, length - at.height));
        panel.add(Series::line(name, up.chain(down)));
    }
    figure.panel(panel);
    Ok(())
}

/// P5.2: force against dilatation, with and without pressure.
fn forces(figure: &mut Figure, bellows: &Bellows) -> Result<(), Failure> {
    let rate = bellows.linear_response()?.spring_rate;
    let mut panel = Panel::new(Axis::linear("Δ"), Axis::linear("(F - F(0)) / E"))
        .titled("Axial force over elongation");
    for (name, pressure) in [("p = 0", 0.0), ("p = 0.0002 E", 2e-4)] {
        let rest = state(bellows, pressure, 0.0)?;
        let at = |state: &BellowsState| (state.dilatation(), state.force() - rest.force());
        let mut points = Vec::new();
        for end in [-0.8, 0.8] {
            let load = BellowsLoad::new(pressure, Axial::Dilatation(end))?;
            let path = bellows.follow(&rest, load, 16)?;
            let side: Vec<_> = path.states.iter().map(at).collect();
            if end < 0.0 { points.extend(side.into_iter().rev()) } else { points.extend(side) }
        }
        panel.add(Series::line(name, points));
    }
    panel.add(Series::dashed("linear", [(-0.8, -0.8 * rate), (0.8, 0.8 * rate)]));
    figure.panel(panel);
    let (stretched, pressed) = (state(bellows, 0.0, 0.6)?, state(bellows, 0.0, -0.6)?);
    let source = "collocation of the equations, half a corrugation";
    figure
        .close("F at Δ = 0.6", stretched.force(), 0.005_282_603_71, Relative(1e-8))
        .source(source);
    figure
        .close("F at Δ = -0.6", pressed.force(), -0.002_405_607_368, Relative(1e-8))
        .source(source);
    let rule = GaussLegendre::new(12)?;
    let mut work = 0.0;
    for node in rule.on(0.0, 0.6) {
        work += node.weight * state(bellows, 0.0, node.position)?.force();
    }
    figure
        .close("work of F up to Δ = 0.6", work, stretched.stored_energy(), Relative(1e-10))
        .source("conservation of energy");
    Ok(())
}

/// One of the stresses of a place.
type Stress = fn(&WallPoint) -> f64;

/// P5.3: stresses along the meridian per unit of dilatation.
fn stresses(figure: &mut Figure, bellows: &Bellows) -> Result<(), Failure> {
    let response = bellows.linear_response()?;
    figure
        .close(
            "effective area",
            response.effective_area,
            response.volume_per_dilatation,
            Relative(1e-8),
        )
        .source("reciprocity: dV/dΔ");
    let mut panel = Panel::new(Axis::linear("ξ / π, crest to root"), Axis::linear("σ / (E Δ)"))
        .titled("Stresses over the linear elongation");
    let kinds: [(&str, Stress); 4] = [
        ("meridional, membrane", |at| at.meridional_membrane),
        ("meridional, bending", |at| at.meridional_bending),
        ("hoop, membrane", |at| at.hoop_membrane),
        ("hoop, bending", |at| at.hoop_bending),
    ];
    for (name, of) in kinds {
        let points = response.per_dilatation.iter().map(|at| (at.parameter / PI, of(at)));
        panel.add(Series::line(name, points));
    }
    figure.panel(panel);
    Ok(())
}

/// B1, B2, B3 of a toroidal bellows of R/a = 1000 for mu = 6.61 r²/(D_m t).
fn toroidal(mu: f64) -> Result<[f64; 3], Failure> {
    let (radius, arc) = (1000.0, 1.0);
    let t = (12.0_f64 * 0.91).sqrt() / (radius * mu);
    let torus = Bellows::new(Meridian::torus(radius, arc)?, Wall::new(1.0, 0.3, t)?, 32)?;
    let response = torus.linear_response()?;
    let places = &response.per_dilatation;
    let membrane = places.iter().map(|at| at.meridional_membrane.abs()).fold(0.0, f64::max);
    let bending = places.iter().map(|at| at.meridional_bending.abs()).fold(0.0, f64::max);
    let b3 = response.spring_rate * 10.92 / (2.0 * radius * t * t * t);
    Ok([membrane * 34.3 / (t * t), bending * 5.72 / t, b3])
}

/// mu, B1, B2, B3 of the code, two digits.
const CODE: [[f64; 4]; 8] = [
    [1.0, 1.1, 1.0, 1.1],
    [2.0, 1.4, 1.0, 1.3],
    [3.0, 2.0, 1.0, 1.5],
    [5.0, 3.6, 1.0, 2.3],
    [8.0, 6.8, 1.4, 3.8],
    [10.0, 9.2, 1.6, 4.9],
    [15.0, 16.0, 2.2, 7.4],
    [20.0, 23.3, 2.8, 10.0],
];

/// P5.4: the factors of the codes against mu.
fn factors(figure: &mut Figure) -> Result<(), Failure> {
    let mut panel = Panel::new(Axis::linear("μ"), Axis::log("factor"))
        .titled("Factors of a toroidal bellows; circles: the codes' table");
    let mus: Vec<f64> = (1..=40).map(|i| 0.5 * f64::from(i)).collect();
    let found: Result<Vec<_>, _> = mus.iter().map(|&mu| toroidal(mu)).collect();
    let found = found?;
    for (i, name) in ["B1", "B2", "B3"].into_iter().enumerate() {
        let line = mus.iter().zip(&found).map(|(mu, factors)| (*mu, factors[i]));
        panel.add(Series::line(name, line).coloured(i));
        let points = CODE.iter().map(|row| (row[0], row[i + 1]));
        panel.add(Series::markers("", Marker::Circle, points).coloured(i));
    }
    figure.panel(panel);
    let rate =
        |row: &[f64; 4]| -> Result<(f64, f64), Failure> { Ok((toroidal(row[0])?[2], row[3])) };
    let pairs: Result<Vec<_>, _> = CODE.iter().map(rate).collect();
    figure
        .all_close("B3 of toroidal bellows", pairs?, Relative(0.05))
        .source("table of EJMA and ASME VIII-1, appendix 26, two digits");
    Ok(())
}

/// P5.5: coefficients of the rotation.
fn coefficients(figure: &mut Figure, bellows: &Bellows) -> Result<(), Failure> {
    let mut panel = Panel::new(Axis::linear("k"), Axis::log("|β_k| / |β_1|"))
        .titled("Coefficients of the rotation");
    let fold = Meridian::u_shaped(10.0, 0.5, 1.0)?;
    let fold = Bellows::new(fold, Wall::new(1.0, 0.3, 0.05)?, 32)?;
    for (name, bellows) in [("sine", bellows), ("U-shaped", &fold)] {
        let state = state(bellows, 0.0, 0.3)?;
        let beta = state.rotation_coefficients();
        // Odd k carry most; the rest is kept where it can be drawn.
        let points = beta.iter().enumerate().map(|(i, b)| ((i + 1) as f64, (b / beta[0]).abs()));
        panel.add(Series::line(name, points.filter(|point| point.1 > 1e-13)));
    }
    figure.panel(panel);
    Ok(())
}

fn limits(figure: &mut Figure) -> Result<(), Failure> {
    // A shallow wave: Donnell.
    let (b, q) = (0.01, TAU / 3.0);
    let wall = Wall::new(1.0, 0.3, 0.1)?;
    let shallow = Bellows::new(Meridian::sine(10.0, b, 3.0)?, wall, 16)?.linear_response()?;
    let fourth = q * q * q * q;
    let bent = b * b * fourth * 0.1 / (2.0 * (wall.bending_stiffness() * fourth + 0.1 / 100.0));
    let donnell = 3.0 / (TAU * 10.0 * 0.1) * (1.0 + bent);
    figure
        .close(
            "Δ/F of a shallow wave, b/R = 0.001",
            1.0 / shallow.spring_rate,
            donnell,
            Relative(1e-4),
        )
        .source("Donnell's equations, to the order of b²");
    // A nearly straight tube, compressed.
    let tube = Bellows::new(Meridian::sine(10.0, 1e-4, 3.44)?, wall, 16)?;
    let rest = tube.solve(BellowsLoad::new(0.0, Axial::Force(0.0))?)?;
    let path = tube.follow(&rest, BellowsLoad::new(0.0, Axial::Force(-0.08))?, 20)?;
    let classical = TAU * 0.01 / (3.0_f64 * 0.91).sqrt();
    let limit = match path.end {
        PathEnd::LimitPoint { state, .. } => -state.force() / classical,
        PathEnd::Reached => f64::NAN,
    };
    figure
        .close(
            "limit of a nearly straight tube over the classical load",
            limit,
            1.0,
            Absolute(0.015),
        )
        .source("Lorenz, Timoshenko: 2π E t²/√(3(1-ν²))");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("method", "large deformation, by Fourier matrices");
    figure.assumed("bellows", "sine: R = 10, b = 1, pitch 3, t = 0.1, E = 1, ν = 0.3");
    let bellows = corrugated()?;
    shapes(&mut figure, &bellows)?;
    forces(&mut figure, &bellows)?;
    stresses(&mut figure, &bellows)?;
    factors(&mut figure)?;
    coefficients(&mut figure, &bellows)?;
    limits(&mut figure)?;
    Ok(figure)
}
