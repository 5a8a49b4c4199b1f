//! Impacts that lose energy: a viscous material, by all ways that the library has.

use carom_halfspace::Material;
use carom_impact::oblique::Groups;
use carom_impact::restitution::{RestitutionTable, of_spheres, with_yield};
use carom_impact::viscoelastic::{ViscoelasticImpact, ViscousLoss};
use carom_impact::{Body, Collision, Motion, NormalRestitution, RingImpact};
use carom_laws::friction::Friction;
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

/// The ball of 1 mm on a plane of its material: kappa 1.2143, lambda 1.8719.
fn ball(e: f64) -> Result<Collision, Failure> {
    let material = Material::from_young(1e10, 0.3)?;
    let mass = 2600.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-9;
    let motion = Motion::new([0.4, 0.0, -0.610_557_122_6], [0.0; 3])?;
    let ball = Body::sphere(1e-3, material, mass)?.moving(motion);
    let collision = Collision::new(ball, Body::plane(material), Friction::new(0.35)?)?;
    Ok(collision.with_normal_restitution(NormalRestitution::new(e)?))
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
        let collision = ball(e)?;
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
    claims(&mut figure, &known)?;
    Ok(figure)
}
