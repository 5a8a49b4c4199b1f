//! Impacts that lose energy: a viscous material, by all ways that the library has.

use carom_halfspace::Material;
use carom_impact::normal::NormalImpact;
use carom_impact::oblique::Groups;
use carom_impact::restitution::{RestitutionTable, of_spheres, with_yield};
use carom_impact::viscoelastic::{ViscoelasticImpact, ViscousLoss};
use carom_impact::{Body, Collision, Motion, NormalRestitution, RingImpact};
use carom_laws::damping::HertzDamping;
use carom_laws::friction::Friction;
use carom_laws::grains::{Grain, GrainContact, GrainLoad, Meeting, Wall};
use carom_laws::shift_law::ShiftLaw;
use rayon::prelude::*;

use crate::reference::rows;
use crate::{Absolute, Axis, Failure, Figure, FigureResult, Marker, Panel, Series, linspace};

const KAPPA: f64 = 1.2;
const LOSSES: [f64; 5] = [0.95, 0.9, 0.7, 0.5, 0.3];
/// Tolerance of what is claimed, and of what is drawn.
const CLAIMED: f64 = 1e-4;
const DRAWN: f64 = 1e-3;

/// R_x of viscous solid spheres with this restitution along the normal.
pub(super) fn viscous(kappa: f64, lambda: f64, e: f64, tolerance: f64) -> Result<f64, Failure> {
    let groups = Groups::of_spheres(kappa, lambda)?;
    let loss = ViscousLoss::of_restitution(e)?;
    Ok(ViscoelasticImpact::new(groups, loss).solve(tolerance).restitution)
}

fn by_table(kappa: f64, lambda: f64, e: f64) -> Result<f64, Failure> {
    Ok(RestitutionTable::shared().restitution_with(Groups::of_spheres(kappa, lambda)?, e)?)
}

/// A ball of 1 mm on a plane of its material: kappa 1.2143.
const FRICTION: f64 = 0.35;
const SPEED: f64 = 0.610_557_122_6;
const RADIUS: f64 = 1e-3;

/// The mass of the ball.
fn mass() -> f64 {
    2600.0 * 4.0 / 3.0 * std::f64::consts::PI * RADIUS.powi(3)
}

/// The ball with this velocity along the plane.
fn ball(along: f64, e: f64) -> Result<Collision, Failure> {
    let material = Material::from_young(1e10, 0.3)?;
    let motion = Motion::new([along, 0.0, -SPEED], [0.0; 3])?;
    let ball = Body::sphere(RADIUS, material, mass())?.moving(motion);
    let collision = Collision::new(ball, Body::plane(material), Friction::new(FRICTION)?)?;
    Ok(collision.with_normal_restitution(NormalRestitution::new(e)?))
}

/// R_x of the ball by the contact of particle codes, in 50 steps of velocity Verlet.
fn by_steps(along: f64, e: f64) -> Result<f64, Failure> {
    let collision = ball(along, e)?;
    let law = ShiftLaw::<[f64; 2]>::new(collision.hertz().stiffness(), Friction::new(FRICTION)?);
    let damping = HertzDamping::of_restitution(e)?;
    let mut contact = GrainContact::new(law, 0.0)?.with_restitution(damping)?;
    let dt = NormalImpact::new(1.0 / mass(), collision.hertz().stiffness().c_z, SPEED)?.duration()
        / 50.0;
    let mut grain = Grain {
        place: [0.0, 0.0, RADIUS],
        velocity: [along, 0.0, -SPEED],
        spin: [0.0; 3],
        radius: RADIUS,
        mass: mass(),
    };
    let wall = Wall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: [0.0; 3] };
    let mut load = GrainLoad::default();
    loop {
        let kick = |grain: &mut Grain, load: &GrainLoad| {
            let inertia = 0.4 * grain.mass * RADIUS * RADIUS;
            for k in 0..3 {
                grain.velocity[k] += 0.5 * dt * load.force[k] / grain.mass;
                grain.spin[k] += 0.5 * dt * load.torques[0][k] / inertia;
            }
        };
        kick(&mut grain, &load);
        (0..3).for_each(|k| grain.place[k] += dt * grain.velocity[k]);
        load = contact.advance(&Meeting::on_wall(&grain, &wall, 0.5), dt)?;
        kick(&mut grain, &load);
        if grain.place[2] >= RADIUS {
            return Ok((grain.velocity[0] - RADIUS * grain.spin[1]) / -along);
        }
    }
}

/// R_x of the ball over lambda by everything that the library has.
fn doors(figure: &mut Figure) -> Result<(), Failure> {
    const E: f64 = 0.5;
    let kappa = {
        let stiffness = ball(0.1, E)?.hertz().stiffness();
        stiffness.c_z / stiffness.c_x
    };
    let mut panel = Panel::new(Axis::linear("λ = v_t/(f v_n)"), Axis::linear("R_x"))
        .titled("All ways, a ball on a plane, e = 0.5, κ = 1.2143");
    let solved = |outcome: carom_impact::Outcome| -> Result<f64, Failure> {
        outcome.rebound().and_then(|rebound| rebound.r_x).ok_or_else(|| "they meet".into())
    };
    let ball = |lambda: f64| ball(lambda * FRICTION * SPEED, E);
    let exact = |lambda: f64| solved(ball(lambda)?.solve()?);
    let table = |lambda: f64| by_table(kappa, lambda, E);
    let rings = |lambda: f64| solved(RingImpact::new(&ball(lambda)?).solve()?);
    let steps = |lambda: f64| by_steps(lambda * FRICTION * SPEED, E);
    let curve = |places: Vec<f64>, way: &dyn Fn(f64) -> Result<f64, Failure>| {
        places
            .into_iter()
            .map(|lambda| Ok((lambda, way(lambda)?)))
            .collect::<Result<Vec<_>, Failure>>()
    };
    panel.add(Series::line("exact impact", curve(linspace(0.02, 8.0, 134), &exact)?));
    panel.add(Series::dashed("stored table", curve(linspace(0.02, 8.0, 134), &table)?));
    let few = || linspace(0.25, 8.0, 32);
    let [by_rings, by_steps] = [curve(few(), &rings)?, curve(few(), &steps)?];
    let off: Result<Vec<f64>, Failure> =
        by_steps.iter().map(|&(lambda, r_x)| Ok((r_x - exact(lambda)?).abs())).collect();
    let off = off?.into_iter().fold(0.0, f64::max);
    figure
        .close("contacts of particles in 50 steps less the exact impact", off, 0.0, Absolute(0.036))
        .source("the exact impact; the step law errs by up to 0.029, its steps by 0.007");
    for (label, marker, points) in [
        ("rings", Marker::Circle, by_rings),
        ("contacts of particles, 50 steps", Marker::Dot, by_steps),
    ] {
        let points: Vec<[f64; 2]> = points.into_iter().map(|(x, y)| [x, y]).collect();
        panel.add(Series::markers(label, marker, points));
    }
    figure.panel(panel);
    Ok(())
}

fn curves(figure: &mut Figure, known: &[[f64; 4]]) -> Result<(), Failure> {
    let places = linspace(0.02, 9.0, 181);
    let curve =
        |of: &(dyn Fn(f64) -> Result<f64, Failure> + Sync)| -> Result<Vec<(f64, f64)>, Failure> {
            places.par_iter().map(|&lambda| Ok((lambda, of(lambda)?))).collect()
        };
    let mut panel = Panel::new(Axis::linear("λ = v_t/(f v_n)"), Axis::linear("R_x"))
        .titled("Solid spheres, κ = 1.2, viscous");
    panel.add(Series::line("e = 1", curve(&|lambda| Ok(of_spheres(KAPPA, lambda)?))?));
    for e in LOSSES {
        panel.add(Series::line(
            format!("e = {e}"),
            curve(&|lambda| viscous(KAPPA, lambda, e, DRAWN))?,
        ));
    }
    let is_drawn = |row: &&[f64; 4]| row[0] == KAPPA && (row[1] == 1.0 || LOSSES.contains(&row[1]));
    let points: Vec<[f64; 2]> = known.iter().filter(is_drawn).map(|row| [row[2], row[3]]).collect();
    panel.add(Series::markers("rows of springs, other programs", Marker::Circle, points));
    figure.panel(panel);
    Ok(())
}

fn causes(figure: &mut Figure, rheologies: &[[f64; 4]]) -> Result<(), Failure> {
    let places = linspace(0.1, 7.0, 139);
    let mut panel = Panel::new(Axis::linear("λ = v_t/(f v_n)"), Axis::linear("R_x"))
        .titled("The same restitution e = 0.7 by other causes, κ = 1.2");
    let curve = |of: fn(f64) -> Result<f64, Failure>| -> Result<Vec<(f64, f64)>, Failure> {
        places.iter().map(|&lambda| Ok((lambda, of(lambda)?))).collect()
    };
    panel.add(Series::line("viscous", curve(|lambda| viscous(KAPPA, lambda, 0.7, DRAWN))?));
    let by_yield = |lambda| Ok(with_yield(Groups::of_spheres(KAPPA, lambda)?, 0.7)?);
    panel.add(Series::dashed("yield: impulses times (1 + e)/2", curve(by_yield)?));
    for (kind, label) in [(1.0, "constant loss tangent"), (0.0, "Maxwell")] {
        let points: Vec<[f64; 2]> = rheologies
            .iter()
            .filter(|row| row[0] == kind && row[1] == 0.7)
            .map(|row| [row[2], row[3]])
            .collect();
        let marker = if kind > 0.5 { Marker::Circle } else { Marker::Dot };
        panel.add(Series::markers(label, marker, points));
    }
    figure.panel(panel);
    Ok(())
}

/// Least-squares slope through the origin of R_x λ over λ along the sticking branch, as measurements give it.
fn beta0(kappa: f64, e: f64) -> Result<f64, Failure> {
    let mut beta = 0.3;
    for _ in 0..8 {
        let end = 3.5 * (1.0 + e) / (1.0 + beta);
        let places = linspace(0.0, end, 41);
        let (mut across, mut square) = (0.0, 0.0);
        for &lambda in &places[1..] {
            across += viscous(kappa, lambda, e, DRAWN)? * lambda * lambda;
            square += lambda * lambda;
        }
        beta = across / square;
    }
    Ok(beta)
}

fn claims(figure: &mut Figure, known: &[[f64; 4]]) -> Result<(), Failure> {
    let lossy = || known.iter().filter(|row| row[1] < 1.0);
    let pairs: Result<Vec<(f64, f64)>, Failure> = lossy()
        .map(|&[kappa, e, lambda, r_x]| Ok((viscous(kappa, lambda, e, CLAIMED)?, r_x)))
        .collect();
    figure
        .all_close("R_x of 168 impacts", pairs?, Absolute(1.1e-4))
        .source("three programs with rows of springs, errors below 1e-5");
    let pairs: Result<Vec<(f64, f64)>, Failure> =
        lossy().map(|&[kappa, e, lambda, r_x]| Ok((by_table(kappa, lambda, e)?, r_x))).collect();
    figure.all_close("the same by the table", pairs?, Absolute(3e-3)).source("the same");
    let sliding: Result<Vec<(f64, f64)>, Failure> =
        [(1.0, 0.3, 6.0), (1.2, 0.5, 8.0), (1.5, 0.9, 20.0)]
            .into_iter()
            .map(|(kappa, e, lambda)| {
                Ok((viscous(kappa, lambda, e, CLAIMED)?, 3.5 * (1.0 + e) / lambda - 1.0))
            })
            .collect();
    figure
        .all_close("sliding throughout, whatever the material", sliding?, Absolute(1e-14))
        .source("the impulse of friction is f times the normal one");
    let (mut exact, mut rings) = (Vec::new(), Vec::new());
    for (e, r_x) in [(0.9, 0.2557), (0.7, 0.1956), (0.5, 0.1564), (0.3, 0.1102)] {
        let collision = ball(0.4, e)?;
        let of = |outcome: carom_impact::Outcome| {
            outcome.rebound().and_then(|rebound| rebound.r_x).ok_or("they meet")
        };
        exact.push((of(collision.solve()?)?, r_x));
        rings.push((of(RingImpact::new(&collision).solve()?)?, r_x));
    }
    figure
        .all_close("a ball of 1 mm on a plane, e 0.9 to 0.3", exact, Absolute(1.5e-4))
        .source("rows of springs");
    figure
        .all_close(
            "the same by rings, whose step law is corrected by the exact impact",
            rings,
            Absolute(2e-3),
        )
        .source("the same");
    figure
        .close("β₀ of polyurethane, κ = 1.480, e = 0.60", beta0(1.48, 0.6)?, 0.286, Absolute(3e-3))
        .source("rows of springs; measured 0.30 with an error of 0.02");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("material", "Kelvin and Voigt: each stress has a viscous companion");
    figure
        .assumed("Coulomb's limit", "f times the whole normal pressure, its viscous part included");
    let known: Vec<[f64; 4]> = rows(include_str!("../../../data/particles/viscous.csv"))?;
    let rheologies: Vec<[f64; 4]> = rows(include_str!("../../../data/particles/rheologies.csv"))?;
    curves(&mut figure, &known)?;
    causes(&mut figure, &rheologies)?;
    doors(&mut figure)?;
    claims(&mut figure, &known)?;
    Ok(figure)
}
