//! Why dissimilar bodies rebound better: compression makes them slip radially, which turns friction away from the
//! direction of the shift.

use carom_halfspace::Material;
use carom_impact::{
    AnalyticOrRings, Body, Collision, CollisionSolver as _, HistoryPoint, Motion, RingImpact,
};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;

use super::super::mesh::{APPROACH, Mesh, Step, Touching, steps};
use crate::{Absolute, Axis, Failure, Figure, FigureResult, Panel, Series};

const FRICTION: f64 = 0.1;
const POISSON: [f64; 2] = [0.0, 0.5];
/// m/s, tangential and normal: lambda = 0.5.
const BEFORE: [f64; 2] = [0.05, 1.0];
const INSTANTS: usize = 161;

/// Steel-like spheres of 4 cm; `poisson` of both.
fn collision(poisson: [f64; 2]) -> Result<Collision, Failure> {
    let ball = |nu| -> Result<Body, Failure> {
        Ok(Body::sphere(0.0405, Material::from_shear(82e9, nu)?, 2.188)?)
    };
    let [tangential, normal] = BEFORE;
    let moving = Motion::new([-tangential, 0.0, -normal], [0.0; 3])?;
    let [one, two] = poisson;
    Ok(Collision::new(ball(one)?.moving(moving), ball(two)?, Friction::new(FRICTION)?)?)
}

/// The contact pressed in equal steps, then shifted while it is pressed on.
fn pressed() -> Result<[Step; 2], Failure> {
    let mesh = Mesh { poisson: POISSON, friction: FRICTION, ..Mesh::of([1.1, 1.1], [28, 28]) };
    let at = |part: f64, xi: f64| Shift { zeta: part * APPROACH, xi, ..Shift::default() };
    let mut path: Vec<Shift> = steps(at(0.0, 0.0), at(0.9, 0.0), 9).collect();
    path.push(at(1.0, 0.0));
    let pressed = mesh.follow(&path)?;
    // As fast as in the impact.
    path[9] = at(1.0, 0.1 * APPROACH * BEFORE[0] / BEFORE[1]);
    let shifted = mesh.follow(&path)?;
    let last = |run: Vec<Step>| run.into_iter().next_back().ok_or("no step");
    Ok([last(pressed)?, last(shifted)?])
}

fn map(step: &Step, title: &str) -> Panel {
    let mut panel = Panel::new("x", "y").titled(title).equal_aspect();
    panel.add(step.arrows("traction on body 1", 0.25, |cell| cell.traction).coloured(1));
    panel.add(Series::line("stick", step.stick_outline()).coloured(0));
    panel
}

/// Time over the duration, and what a point has.
fn course(history: &[HistoryPoint], of: impl Fn(&HistoryPoint) -> f64) -> Vec<(f64, f64)> {
    let duration = history.last().map_or(1.0, |point| point.time);
    history.iter().map(|point| (point.time / duration, of(point))).collect()
}

/// The tangential velocity over that before, at the greatest approach.
fn at_greatest_approach(history: &[HistoryPoint]) -> Result<f64, Failure> {
    let greatest = history.iter().max_by(|a, b| a.shift.z.total_cmp(&b.shift.z));
    Ok(greatest.ok_or("no instants")?.velocity.x / BEFORE[0])
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("spheres", "ν = 0 and 0.5, G equal, f = 0.1: f/γ = 0.3; λ = 0.5");
    figure.assumed("alike", "the same impact with the coupling left out");
    let [still, shifted] = pressed()?;
    figure.panel(map(&still, "Pressed only"));
    figure.panel(map(&shifted, "Pressed on and shifted, λ = 0.5"));
    let unlike = RingImpact::new(&collision(POISSON)?).history(INSTANTS)?;
    let alike = collision(POISSON)?.history(INSTANTS)?;
    let greatest = alike.iter().map(|point| point.force.z).fold(0.0, f64::max);
    let mut force = Panel::new("time over duration", "F_x/(f F_z,max)").titled("Friction");
    let mut velocity =
        Panel::new(Axis::linear("time over duration"), Axis::linear("v_x/v_x before"))
            .titled("Tangential velocity of the contact point");
    for (i, (name, history)) in [("alike", &alike), ("unlike", &unlike)].into_iter().enumerate() {
        let scaled = course(history, |point| point.force.x / (FRICTION * greatest));
        force.add(Series::line(name, scaled).coloured(i));
        let scaled = course(history, |point| point.velocity.x / BEFORE[0]);
        velocity.add(Series::line(name, scaled).coloured(i));
    }
    figure.panel(force);
    figure.panel(velocity);
    pressing_claims(&mut figure, &still, &shifted);
    impact_claims(&mut figure, &alike, &unlike)?;
    Ok(figure)
}

fn pressing_claims(figure: &mut Figure, still: &Step, shifted: &Step) {
    let slipping =
        |step: &Step| -> Vec<Touching> { step.touching().filter(|cell| !cell.sticks).collect() };
    let cells = slipping(still);
    let sine = |cell: &Touching| {
        let [x, y] = cell.slip;
        (x * cell.y - y * cell.x).abs() / (cell.slip_size() * cell.x.hypot(cell.y))
    };
    let mean = cells.iter().map(sine).sum::<f64>() / cells.len() as f64;
    figure
        .at_most("pressed only, slip is radial: mean sine of its angle to the radius", mean, 0.03)
        .source("symmetry of a circle; the cells are square");
    // Stick radii at gamma/f = 3 and 4 on fine rings, kappa = 1.125: 0.12 and less.
    figure
        .at_most("and nearly all of it slips: the part that sticks", still.stick(), 0.03)
        .source("stick radius below 0.12 from γ/f = 3 on, by an independent program");
    let along = |step: &Step| step.load.f_x / (FRICTION * step.load.f_z);
    figure
        .at_most("pressed only, friction adds to nothing: |F_x|/(f F_z)", along(still).abs(), 1e-6)
        .source("symmetry");
    // Slip by pressing is outwards, by the shift along x: traction follows their sum.
    let cosine = |cell: &Touching| {
        let [x, y] = cell.traction;
        x * cell.x + y * cell.y > 0.0
    };
    let cells = slipping(shifted);
    let outwards = cells.iter().filter(|cell| cosine(cell)).count() as f64 / cells.len() as f64;
    figure
        .at_least(
            "shifted as well, most traction still points away from the middle",
            outwards,
            0.75,
        )
        .source("radial slip of a step is as large as its shift");
    figure
        .at_most(
            "and friction along the shift is far from its limit: F_x/(f F_z)",
            along(shifted),
            0.4,
        )
        .source("traction turned into the radius does not brake the shift");
}

fn impact_claims(
    figure: &mut Figure,
    alike: &[HistoryPoint],
    unlike: &[HistoryPoint],
) -> Result<(), Failure> {
    let [turned, turned_less] = [at_greatest_approach(alike)?, at_greatest_approach(unlike)?];
    figure
        .at_most("alike: at the greatest approach most of v_x is reversed", turned, -0.6)
        .source("exact impact");
    figure
        .increasing("unlike: less of it, but reversed", [turned, turned_less, 0.0])
        .source("rings");
    let end = |history: &[HistoryPoint]| -> Result<f64, Failure> {
        Ok(history.last().ok_or("no instants")?.velocity.x / BEFORE[0])
    };
    figure
        .at_least("alike: on the way out friction takes it all back", end(alike)?, 0.0)
        .source("exact impact");
    figure
        .at_most(
            "unlike: on the way out friction takes back less than a third as much",
            (end(unlike)? - turned_less) / (end(alike)? - turned),
            1.0 / 3.0,
        )
        .source("rings");
    let outcome = AnalyticOrRings.solve(&collision(POISSON)?)?;
    let found = outcome.rebound().and_then(|rebound| rebound.r_x).ok_or("they meet")?;
    figure
        .close("unlike: R_x", found, 0.3117, Absolute(2e-3))
        .source("the contact on a grid, refined until R_x settled");
    Ok(())
}
