//! Proposition 4: forces on a flange at the end of a tube, by Fourier matrices.

use crate::{
    Absolute, Axis, Failure, Figure, FigureResult, Marker, Panel, Relative, Series, linspace,
};
use carom_shells::Wall;
use carom_shells::flange::{
    Flange, FlangeSolution, Ring, RingForce, RingStiffness, StiffnessKind, Tube, TubeEdge,
};
use carom_shells::fourier::{Complex, ComplexSeries, PiecewiseConstant, Sector};
use std::f64::consts::{PI, TAU};

const HARMONICS: usize = 64;
/// Section along the tube and outward, over the radius.
const SECTION: [f64; 2] = [0.08, 0.1];

fn ring() -> Result<Ring, Failure> {
    Ok(Ring::new(1.0, RingStiffness::rectangle(1.0, 0.3, SECTION[0], SECTION[1])?)?)
}

fn held(ring: Ring, thickness: f64, is_whole: bool) -> Result<Flange, Failure> {
    let wall = Wall::new(1.0, 0.3, thickness)?;
    let tube =
        if is_whole { Tube::koiter_sanders(1.0, wall)? } else { Tube::half_momentless(1.0, wall)? };
    Ok(Flange::on_tube(ring, tube, TubeEdge::at_centroid())?)
}

fn pinched(flange: &Flange) -> Result<FlangeSolution, Failure> {
    Ok(flange.solve(&RingForce::pinch(1.0)?, HARMONICS)?)
}

fn opening(flange: &Flange) -> Result<f64, Failure> {
    Ok(2.0 * pinched(flange)?.displacement(0.0).radial)
}

/// P4.1: the flange under two forces outward, for four thicknesses of the tube.
fn deformed(figure: &mut Figure) -> Result<(), Failure> {
    let mut panel = Panel::new(Axis::linear("x / R"), Axis::linear("y / R"))
        .titled("Pinched flange, exaggerated")
        .equal_aspect();
    let free = Flange::bare(ring()?);
    let exaggeration = 0.3 / opening(&free)?;
    for (colour, thickness) in [0.0, 0.005, 0.02, 0.05].into_iter().enumerate() {
        let flange = if thickness > 0.0 { held(ring()?, thickness, false)? } else { free.clone() };
        let solved = pinched(&flange)?;
        let place = |angle: f64| {
            let moved = solved.displacement(angle);
            let (w, v) = (exaggeration * moved.radial, exaggeration * moved.tangential);
            let (c, s) = (libm::cos(angle), libm::sin(angle));
            ((1.0 + w) * c - v * s, (1.0 + w) * s + v * c)
        };
        let name = format!("t/R = {thickness}");
        panel.add(
            Series::line(name, linspace(0.0, TAU, 121).into_iter().map(place)).coloured(colour),
        );
    }
    figure.panel(panel);
    Ok(())
}

/// P4.2: bending moment around, uniform, with eight holes, with two stiff sectors.
fn moments(figure: &mut Figure) -> Result<(), Failure> {
    let mut panel = Panel::new(Axis::linear("φ / π"), Axis::linear("M / (P R)"))
        .titled("Bending moment of a pinched flange");
    let holes: Result<Vec<_>, _> =
        (0..8).map(|i| Sector::new((f64::from(i) + 0.5) * PI / 4.0, 0.06, 0.5)).collect();
    let ribs = [Sector::new(0.0, 0.4, 5.0)?, Sector::new(PI, 0.4, 5.0)?];
    let rings = [
        ("EI uniform", ring()?),
        ("eight holes", ring()?.with_sectors(StiffnessKind::InPlane, &holes?)?),
        ("two stiff sectors", ring()?.with_sectors(StiffnessKind::InPlane, &ribs)?),
    ];
    for (colour, (name, ring)) in rings.into_iter().enumerate() {
        let solved = held(ring, 0.02, false)?.solve(&RingForce::pinch(1.0)?, 16)?;
        let at = |angle: f64| (angle / PI, solved.loads(angle).in_plane);
        panel.add(Series::line(name, linspace(0.0, PI, 181).into_iter().map(at)).coloured(colour));
        let at = |angle: f64| (angle / PI, solved.partial_loads(angle).in_plane);
        let name = if colour == 0 { "16 harmonics alone" } else { "" };
        panel
            .add(Series::dotted(name, linspace(0.0, PI, 181).into_iter().map(at)).coloured(colour));
    }
    figure.panel(panel);
    Ok(())
}

/// P4.3: the opening against the thickness of the tube.
fn openings(figure: &mut Figure) -> Result<(), Failure> {
    let free = opening(&Flange::bare(ring()?))?;
    let ratio = |thickness: f64, is_whole: bool| -> Result<(f64, f64), Failure> {
        Ok((thickness, opening(&held(ring()?, thickness, is_whole)?)? / free))
    };
    let thicknesses: Vec<f64> = crate::logspace(1e-4, 0.2, 30);
    let line: Result<Vec<_>, _> = thicknesses.iter().map(|&t| ratio(t, false)).collect();
    let points: Result<Vec<_>, _> =
        thicknesses.iter().step_by(3).map(|&t| ratio(t, true)).collect();
    let (line, points) = (line?, points?);
    figure
        .decreasing("a thicker tube holds the flange more", line.iter().map(|at| at.1))
        .source("energy: stiffness is added");
    figure
        .close("a tube of t/R = 1e-4 leaves it free", line[0].1, 1.0, Absolute(1e-4))
        .source("free ring");
    let whole = ratio(0.02, true)?.1;
    figure
        .close(
            "opening at t/R = 0.02 by the half-momentless theory",
            ratio(0.02, false)?.1,
            whole,
            Relative(0.004),
        )
        .source("whole shell (Koiter, Sanders)");
    let mut panel = Panel::new(Axis::log("t / R"), Axis::linear("opening / that of a free ring"));
    panel.add(Series::line("half-momentless", line));
    panel.add(Series::markers("whole shell", Marker::Circle, points));
    figure.panel(panel.titled("Opening of the pinched flange over the wall of the tube"));
    Ok(())
}

/// P4.4: lengths over which main and boundary parts decay.
fn decays(figure: &mut Figure) -> Result<(), Failure> {
    let mut panel = Panel::new(Axis::log("harmonic n"), Axis::log("length of decay / R"))
        .titled("Decay of both parts along the tube; edge effect dashed");
    for (colour, thickness) in [0.005, 0.02, 0.05].into_iter().enumerate() {
        let tube = Tube::half_momentless(1.0, Wall::new(1.0, 0.3, thickness)?)?;
        let main = (2..=20).map(|n| (n as f64, 1.0 / tube.main_decay(n)));
        panel.add(Series::line(format!("main part, t/R = {thickness}"), main).coloured(colour));
        let boundary = 1.0 / tube.boundary_decay();
        panel.add(Series::dashed("", [(2.0, boundary), (20.0, boundary)]).coloured(colour));
    }
    figure.panel(panel);
    Ok(())
}

/// P4.5: the moment EI κ of a stepped EI by both rules of the product, from κ = |sin φ|/EI.
fn rules(figure: &mut Figure) -> Result<(), Failure> {
    let sectors = [Sector::new(0.0, 0.4, 5.0)?, Sector::new(PI, 0.4, 5.0)?];
    let stiffness = PiecewiseConstant::new(1.0, &sectors)?;
    let order = 512_i64;
    let smooth = |k: i64| {
        let size = if k % 2 == 0 { -2.0 / (PI * (k * k - 1) as f64) } else { 0.0 };
        Complex::new(size, 0.0)
    };
    let exact = ComplexSeries::new(&(-order..=order).map(smooth).collect::<Vec<_>>())?;
    let reciprocal = stiffness.reciprocal_series(1024);
    let error = |n: usize, is_inverse: bool| -> Result<(f64, f64), Failure> {
        let curvature = reciprocal.times(&exact, n);
        let moment = if is_inverse {
            ComplexSeries::times_across_jump(&reciprocal, &curvature)?
        } else {
            stiffness.series(2 * n).times(&curvature, n)
        };
        let n = n as i64;
        let off = (-n..=n).map(|k| (moment.coefficient(k) - smooth(k)).norm_sqr());
        Ok((n as f64, off.sum::<f64>().sqrt()))
    };
    let orders = [8, 16, 32, 64, 128];
    let mut panel = Panel::new(Axis::log("harmonics"), Axis::log("error of M"))
        .titled("Error of both products where EI jumps");
    let mut last = Vec::new();
    for (name, is_inverse) in [("T(1/EI)⁻¹", true), ("T(EI)", false)] {
        let points: Result<Vec<_>, _> = orders.iter().map(|&n| error(n, is_inverse)).collect();
        let points = points?;
        last.push(points[points.len() - 1].1);
        panel.add(Series::line(name, points));
    }
    figure
        .at_least("error of T(EI) over that of T(1/EI)⁻¹, 128 harmonics", last[1] / last[0], 10.0)
        .source("L. Li, J. Opt. Soc. Am. A 13 (1996) 1870");
    figure.panel(panel);
    Ok(())
}

fn rings(figure: &mut Figure) -> Result<(), Failure> {
    let stiff = RingStiffness::new(1e6, 1.0, 0.7, 0.4)?;
    let free = Flange::bare(Ring::new(1.0, stiff)?);
    let solved = pinched(&free)?;
    let source = "Timoshenko, Strength of Materials";
    figure
        .close("opening EI/(P R³) of a free ring", opening(&free)?, 0.149, Absolute(5e-4))
        .source(source);
    figure
        .close("M/(P R) under the load", solved.loads(0.0).in_plane, 1.0 / PI, Relative(1e-8))
        .source(source);
    let across = solved.loads(0.5 * PI).in_plane;
    figure.close("M/(P R) across", across, 1.0 / PI - 0.5, Relative(1e-8)).source(source);
    let pried = free.solve(&[RingForce::at(0.0)?.axial(1.0)?], HARMONICS)?;
    let found = pried.coefficient(carom_shells::flange::EdgeMotion::Axial, 3).re;
    let expected = (1.0 / 0.7 + 1.0 / (9.0 * 0.4)) / (64.0 * TAU);
    figure
        .close("out of the plane, u of harmonic 3", found, expected, Relative(1e-10))
        .source("Flügge, Stresses in Shells, rings");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("load", "singular forces, acting symmetrically on the flange");
    figure.assumed("forces", "two, radial, at φ = 0 and π");
    figure.assumed("section", "0.08 R along the tube, 0.10 R outward, ν = 0.3");
    rings(&mut figure)?;
    deformed(&mut figure)?;
    moments(&mut figure)?;
    openings(&mut figure)?;
    decays(&mut figure)?;
    rules(&mut figure)?;
    Ok(figure)
}
