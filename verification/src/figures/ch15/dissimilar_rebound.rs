//! Fig. 15.6: the tangential restitution of dissimilar spheres.

use carom_halfspace::Material;
use rayon::prelude::*;

use super::numerical::{SHEAR_MODULUS, Spheres};
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series};
use carom_impact::restitution::{DissimilarGroups, DissimilarTable, of_spheres};
use carom_laws::friction::Friction;

const CELLS: usize = 12;
const STEPS: usize = 50;
const LAMBDAS: [f64; 10] = [0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0];
const INDEPENDENT: &str = "an independent half-space program";

/// G_2/G_1 and f.
const PAIRS: [[f64; 2]; 5] = [[1.0, 0.1], [3.0, 0.3], [10.0, 0.3], [3.0, 0.1], [10.0, 0.1]];

fn gamma(delta: f64) -> f64 {
    (delta - 1.0) / (2.0 * (delta + 1.0)) // (15.2), nu_1 = nu_2 = 0
}

fn spheres([delta, friction]: [f64; 2]) -> Result<Spheres, Failure> {
    let body = |ratio| Material::from_shear(ratio * SHEAR_MODULUS, 0.0);
    Ok(Spheres::of([body(1.0)?, body(delta)?], friction))
}

fn name([delta, f]: [f64; 2]) -> String {
    if delta == 1.0 {
        "γ = 0".to_owned()
    } else {
        format!("δ = {delta}, f = {f}: f/γ = {:.2}", f / gamma(delta))
    }
}

/// R_x without a grid: by the table that rings filled.
fn by_table(pair: [f64; 2], lambda: f64) -> Result<f64, Failure> {
    let [delta, f] = pair;
    let groups = DissimilarGroups::of_spheres(1.0, gamma(delta), Friction::new(f)?, lambda)?;
    Ok(DissimilarTable::shared().restitution(&groups)?.r_x)
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("κ", "1");
    figure.derived("ν₁ = ν₂, γ", "0, (δ - 1)/(2δ + 2)");
    figure.assumed("δ, f", "3 and 10, 0.1 and 0.3");
    figure.assumed("circles: elements, steps", "12 × 12 about the greatest contact, 50");
    figure.derived("lines", "the stored table of R_x, made by rings");
    let jobs: Vec<_> =
        PAIRS.iter().flat_map(|pair| LAMBDAS.map(|lambda| (*pair, lambda))).collect();
    let run = |&(pair, lambda): &([f64; 2], f64)| spheres(pair)?.restitutions(lambda, CELLS, STEPS);
    let both: Vec<[f64; 2]> = jobs.par_iter().map(run).collect::<Result<_, Failure>>()?;
    let found: Vec<f64> = both.iter().map(|[r_x, _]| *r_x).collect();
    let curves: Vec<&[f64]> = found.chunks(LAMBDAS.len()).collect();
    let mut panel = Panel::new("λ", "R_x").titled("κ = 1");
    let lambdas = crate::linspace(0.05, 8.0, 160);
    let exact: Result<Vec<_>, _> =
        lambdas.into_iter().map(|at| Ok::<_, Failure>((at, of_spheres(1.0, at)?))).collect();
    panel.add(Series::dashed("γ = 0, exact", exact?).coloured(0));
    for (i, (pair, curve)) in PAIRS.iter().zip(&curves).enumerate() {
        let points: Vec<_> = LAMBDAS.into_iter().zip(curve.iter().copied()).collect();
        if i > 0 {
            let at = |lambda| Ok::<_, Failure>((lambda, by_table(*pair, lambda)?));
            let table = crate::linspace(0.05, 8.0, 160).into_iter().map(at);
            let table = table.collect::<Result<Vec<_>, _>>()?;
            panel.add(Series::line("", table).coloured(i));
        }
        panel.add(Series::markers(name(*pair), Marker::Circle, points).coloured(i));
    }
    figure.panel(panel);
    claims(&mut figure, &curves)?;
    claim_table(&mut figure, &curves)?;
    let last: Vec<[f64; 2]> =
        both.chunks(LAMBDAS.len()).map(|curve| curve[LAMBDAS.len() - 1]).collect();
    // (9.33) with the normal impulse: the largest effect of friction.
    let below: Vec<f64> =
        last.iter().map(|[r_x, e_z]| 3.5 * (1.0 + e_z) / 8.0 - 1.0 - r_x).collect();
    figure
        .at_most("λ = 8, γ = 0 slides throughout: R_x = 7/λ - 1", below[0].abs(), 1e-6)
        .source("(9.33)");
    let most = below.iter().copied().fold(0.0, f64::max);
    figure
        .at_most("γ > 0 takes hardly anything from that", most, 0.01)
        .source("(9.33); the radial slip turns the tractions a little");
    let least = below.iter().copied().fold(f64::INFINITY, f64::min);
    figure.at_least("and adds nothing", least, -1e-6).source("|F_x| ≤ f F_z");
    Ok(figure)
}

/// The lines against the circles: rings and grid have nothing in common but the theory.
fn claim_table(figure: &mut Figure, curves: &[&[f64]]) -> Result<(), Failure> {
    let mut off = Vec::new();
    for (pair, curve) in PAIRS.iter().zip(curves).skip(1) {
        // At the first lambda 50 steps are too few.
        for (lambda, on_grid) in LAMBDAS.into_iter().zip(curve.iter()).skip(1) {
            off.push((by_table(*pair, lambda)? - on_grid).abs());
        }
    }
    let mean = off.iter().sum::<f64>() / off.len() as f64;
    let most = off.iter().copied().fold(0.0, f64::max);
    let grid = "the grid of this figure, 12 × 12 in 50 steps";
    figure.at_most("from λ = 0.5 on lines are near circles, in the mean", mean, 0.01).source(grid);
    figure.at_most("and nowhere far from them", most, 0.025).source(grid);
    figure
        .all_close(
            "λ = 0.25, f/γ = 0.40: the line, where the circle is at 0.037",
            [(by_table(PAIRS[3], 0.25)?, 0.0065)],
            Absolute(0.005),
        )
        .source("the impact on a finer grid, within 0.013 by its own estimate");
    Ok(())
}

fn claims(figure: &mut Figure, curves: &[&[f64]]) -> Result<(), Failure> {
    figure
        .all_close(
            "λ = 0.5: R_x of f/γ = 0.40 and 0.24",
            [(curves[3][1], 0.024), (curves[4][1], 0.262)],
            Absolute(0.02),
        )
        .source(INDEPENDENT);
    let exact: Result<Vec<f64>, _> = LAMBDAS.iter().map(|at| of_spheres(1.0, *at)).collect();
    let exact = exact?;
    figure
        .all_close(
            "γ = 0 is the exact walk",
            curves[0].iter().copied().zip(exact.iter().copied()),
            Absolute(0.02),
        )
        .source("exact walk; at small λ the steps count");
    let rise = |curve: &[f64]| curve[1] - curves[0][1];
    figure
        .increasing("λ = 0.5: R_x rises as f/γ falls", [1, 2, 3, 4].map(|i| rise(curves[i])))
        .source("section 15.2");
    figure
        .at_most("f/γ > 1 raises R_x little", rise(curves[1]).abs(), 0.1)
        .source("section 15.2: only f/γ < 1 changes R_x");
    // With exchanged bodies gamma changes its sign.
    let lambdas = [0.5, 2.0];
    let pairs: Result<Vec<_>, Failure> = lambdas
        .iter()
        .map(|lambda| {
            let one = spheres([10.0, 0.1])?;
            let [soft, hard] = one.bodies;
            let other = Spheres { bodies: [hard, soft], ..one };
            Ok((one.restitution(*lambda, 12, 40)?, other.restitution(*lambda, 12, 40)?))
        })
        .collect();
    figure
        .all_close("γ and -γ give the same R_x", pairs?, Absolute(1e-5))
        .source("exchange of the bodies; section 15.2");
    Ok(())
}
