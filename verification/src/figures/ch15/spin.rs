//! Fig. 15.7: the tangential restitution of spheres that spin about the normal.

use std::f64::consts::TAU;

use carom_halfspace::Material;
use carom_impact::restitution::of_spheres;
use carom_impact::torsional::{SpinCollision, Spinner};
use carom_laws::friction::Friction;
use rayon::prelude::*;

use super::numerical::{SHEAR_MODULUS, Spheres};
use crate::{Failure, Figure, FigureResult, Marker, Panel, Relative, Series};

const CELLS: usize = 16;
const STEPS: usize = 50;
const LAMBDAS: [f64; 9] = [0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0];
/// Turns a second.
const SPINS: [f64; 3] = [0.0, 10.0, 500.0];
const POISSON: f64 = 0.3;

/// Steel at 7.16 m/s.
fn spheres() -> Result<Spheres, Failure> {
    let (radius, speed) = (0.01, 7.16);
    let mass = 4.0 / 3.0 * std::f64::consts::PI * 7850.0 * radius * radius * radius;
    let bodies = [Material::from_shear(SHEAR_MODULUS, POISSON)?; 2];
    Ok(Spheres { bodies, radius, mass, friction: 0.1, speed })
}

/// R_x and the ratio of the spins after and before.
fn rebound(spheres: &Spheres, lambda: f64, spin: f64) -> Result<[f64; 2], Failure> {
    let run = spheres.follow(lambda, TAU * spin, CELLS, STEPS)?;
    let [first, .., last] = &run[..] else { return Err("no impact".into()) };
    Ok([-last.rate[0] / first.rate[0], last.rate[3] / first.rate[3]])
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("spins, v_n", "10 Hz and 500 Hz, 7.16 m/s");
    figure.stated("bodies", "two spheres of steel");
    figure.assumed("R, f, ν, G, ρ", "10 mm, 0.1, 0.3, 82000 N/mm², 7.85 g/cm³");
    figure.assumed("spin", "that of one sphere against the other");
    figure.assumed("elements, steps", "16 × 16 about the greatest contact, 50");
    let spheres = spheres()?;
    let greatest = spheres.hertz()?.ellipse(spheres.normal()?.maximal_approach())?.semi_axis_a();
    // (15.4) with the normal velocity.
    let omega_n = |spin: f64| 2.0 * greatest * TAU * spin / (spheres.friction * spheres.speed);
    let jobs: Vec<_> = SPINS.iter().flat_map(|spin| LAMBDAS.map(|at| (*spin, at))).collect();
    let run = |&(spin, lambda): &(f64, f64)| Ok(rebound(&spheres, lambda, spin)?[0]);
    let found: Vec<f64> = jobs.par_iter().map(run).collect::<Result<_, Failure>>()?;
    let curves: Vec<&[f64]> = found.chunks(LAMBDAS.len()).collect();
    let kappa = crate::spheres::kappa(POISSON);
    let mut panel = Panel::new("λ", "R_x").titled("steel spheres");
    let lambdas = crate::linspace(0.05, 8.0, 160);
    let exact: Result<Vec<_>, _> =
        lambdas.into_iter().map(|at| Ok::<_, Failure>((at, of_spheres(kappa, at)?))).collect();
    panel.add(Series::dashed("without spin, exact", exact?).coloured(0));
    for (i, (spin, curve)) in SPINS.iter().zip(&curves).enumerate() {
        let points: Vec<_> = LAMBDAS.into_iter().zip(curve.iter().copied()).collect();
        let label = format!("{spin} Hz, ω_N = {:.2}", omega_n(*spin));
        panel.add(Series::markers(label, Marker::Circle, points).coloured(i));
    }
    rings(&mut figure, &mut panel, &spheres, &curves)?;
    figure.panel(panel);
    claims(&mut figure, &spheres, &curves)?;
    figure.deviation(
        "ω_N = 2 a_max ω/(f ξ̇₀)",
        "ω_N = 2 a_max ω/(f ζ̇₀)",
        "with ξ̇₀ it would depend on λ; the text speaks of the normal velocity",
    );
    Ok(figure)
}

/// Lines by rings beside the circles of the grid, in as many steps.
fn rings(
    figure: &mut Figure,
    panel: &mut Panel,
    spheres: &Spheres,
    curves: &[&[f64]],
) -> Result<(), Failure> {
    let at = |lambda: f64, spin: f64| -> Result<f64, Failure> {
        let run = spheres.by_rings(lambda, TAU * spin, STEPS, |_| ())?;
        let [first, .., last] = &run[..] else { return Err("no impact".into()) };
        Ok(-last.rate[0] / first.rate[0])
    };
    let mut off = Vec::new();
    for (i, (spin, curve)) in SPINS.iter().zip(curves).enumerate().skip(1) {
        let line = crate::linspace(0.25, 7.0, 55);
        let line: Result<Vec<_>, Failure> =
            line.into_par_iter().map(|lambda| Ok((lambda, at(lambda, *spin)?))).collect();
        let label = if i == 1 { "rings" } else { "" };
        panel.add(Series::line(label, line?).coloured(i));
        for (lambda, on_grid) in LAMBDAS.iter().zip(*curve) {
            off.push((lambda.min(1.0) * (at(*lambda, *spin)? - on_grid)).abs());
        }
    }
    let most = off.iter().copied().fold(0.0, f64::max);
    figure
        .at_most("min(λ, 1) R_x by rings, against the circles", most, 0.01)
        .source("the grid of this figure, 16 × 16 in 50 steps");
    Ok(())
}

fn claims(figure: &mut Figure, spheres: &Spheres, curves: &[&[f64]]) -> Result<(), Failure> {
    let change = |i: usize, j: usize| curves[i][j] - curves[0][j];
    let slow = (2..LAMBDAS.len()).map(|j| change(1, j).abs()).fold(0.0, f64::max);
    figure.at_most("10 Hz changes R_x little for λ ≥ 1", slow, 0.02).source("section 15.3");
    let raised = (0..3).map(|j| change(2, j)).fold(f64::INFINITY, f64::min);
    figure.at_least("500 Hz raises R_x for λ ≤ 1", raised, 0.05).source("section 15.3");
    let low = change(2, 0).min(change(2, 1));
    let twist = change(1, 0).abs().max(change(1, 1).abs());
    figure
        .at_most("below that by a fifth of what 500 Hz does", twist, 0.2 * low)
        .source("section 15.3: almost to be neglected");
    // Hardly any slip: the torsional impact of chapter 10.
    let friction = Friction::new(spheres.friction)?;
    let still = Spinner::solid_sphere(spheres.mass, spheres.radius)?;
    let hertz = spheres.hertz()?;
    let pairs: Result<Vec<_>, Failure> = SPINS[1..]
        .iter()
        .map(|spin| {
            let bodies = [still.spinning(TAU * spin)?, still];
            let exact = SpinCollision::new(&hertz, friction, bodies, spheres.speed)?.solve()?;
            let [_, ratio] = rebound(spheres, 1e-6, *spin)?;
            Ok((1.0 - ratio, 1.0 - exact.spin_ratio))
        })
        .collect();
    figure
        .all_close("without slip, the part of the spin that is lost", pairs?, Relative(0.05))
        .source("torsional impact of chapter 10, exact for circles");
    Ok(())
}
