//! Fig. 15.2: the tangential restitution of similar spheres.

use carom_impact::closed_form::restitution_without_slip;
use carom_impact::restitution::{RestitutionError, of_spheres};
use rayon::prelude::*;

use super::numerical::Spheres;
use crate::reference::rows;
use crate::spheres::kappa;
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series, linspace};

/// κ and λ of the row that ends early.
const EARLY: [f64; 2] = [1.055_6, 0.5];

fn values(points: &[(f64, f64)]) -> Result<Vec<f64>, RestitutionError> {
    points.par_iter().map(|&(kappa, lambda)| of_spheres(kappa, lambda)).collect()
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("ν₁ = ν₂", "0, 0.1 .. 0.5");
    figure.assumed("λ", "0 to 10");
    figure.assumed(
        "numerical: ν, elements, steps",
        "0, 0.3 and 0.5; 16 × 16 about the greatest contact, 128",
    );
    let mut panel = Panel::new("λ", "R_x").titled("Spheres");
    let lambdas = linspace(0.0, 10.0, 201);
    let mut curves = Vec::new();
    for nu in linspace(0.0, 0.5, 6) {
        let kappa = kappa(nu);
        let points: Vec<_> = lambdas.iter().map(|&lambda| (kappa, lambda)).collect();
        let curve = values(&points)?;
        panel.add(Series::line(
            format!("ν = {nu:.1}, κ = {kappa:.4}"),
            lambdas.iter().copied().zip(curve.iter().copied()),
        ));
        curves.push(curve);
    }
    numerical(&mut figure, &mut panel)?;
    figure.panel(panel);
    table_claims(&mut figure)?;
    limit_claims(&mut figure)?;

    let first_merged = lambdas.iter().position(|&lambda| lambda > 5.5).unwrap_or(0);
    let least_rise = (0..first_merged)
        .flat_map(|i| curves.windows(2).map(move |pair| pair[1][i] - pair[0][i]))
        .fold(f64::INFINITY, f64::min);
    figure
        .holds("R_x rises with ν up to λ = 5.5", least_rise > 0.0, least_rise)
        .source("ordering of the printed curves");
    let merged = lambdas.iter().enumerate().filter(|(_, lambda)| **lambda >= 6.0 + 1e-9);
    let spread =
        merged.map(|(i, lambda)| (curves[0][i] - (7.0 / lambda - 1.0)).abs()).fold(0.0, f64::max);
    figure
        .at_most("ν = 0 slides throughout from λ = 6 on: R_x = 7/λ - 1", spread, 1e-15)
        .source("(9.33)");
    figure.deviation(
        "complete slip for λ ≥ 7",
        "complete slip for λ ≥ 7 - κ",
        "the printed condition overlooks the elastic recoil; sliding with R_x > 0 is possible",
    );
    Ok(figure)
}

/// λ of the numerical impacts.
const MARKED: [f64; 9] = [0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 8.0];

fn numerical(figure: &mut Figure, panel: &mut Panel) -> Result<(), Failure> {
    let nus = [0.0, 0.3, 0.5];
    let jobs: Vec<_> = nus.iter().flat_map(|nu| MARKED.map(|lambda| (*nu, lambda))).collect();
    let run = |&(nu, lambda): &(f64, f64)| Spheres::alike(nu)?.restitution(lambda, 16, 128);
    let found: Vec<f64> = jobs.par_iter().map(run).collect::<Result<_, Failure>>()?;
    for (i, curve) in found.chunks(MARKED.len()).enumerate() {
        let label = if i == 0 { "numerical" } else { "" };
        let points = MARKED.into_iter().zip(curve.iter().copied());
        let colour = [0, 3, 5][i];
        panel.add(Series::markers(label, Marker::Circle, points).coloured(colour));
    }
    let all: Vec<_> = jobs.iter().copied().zip(found.iter().copied()).collect();
    let exact = |((nu, lambda), own): ((f64, f64), f64)| {
        Ok::<_, RestitutionError>((own, of_spheres(kappa(nu), lambda)?))
    };
    let slow = |((_, lambda), _): &((f64, f64), f64)| *lambda <= 1.0;
    let of = |slowly: bool| -> Result<Vec<_>, RestitutionError> {
        all.iter().filter(|job| slow(job) == slowly).map(|job| exact(*job)).collect()
    };
    figure.all_close("numerical R_x for λ ≥ 2", of(false)?, Absolute(0.004)).source("exact walk");
    figure
        .all_close("and for λ ≤ 1, where steps count", of(true)?, Absolute(0.02))
        .source("exact walk");
    let table = rows::<4>(include_str!("../../../data/impact/numerical_similar.csv"))?;
    // Its first-order steps leave up to 0.02 at smaller λ, as the exact walk shows.
    let fast = table.iter().filter(|[_, lambda, _, _]| *lambda >= 2.0);
    let worst = fast.map(|[nu, lambda, r_x, error]| {
        let own = all.iter().find(|((n, l), _)| n == nu && l == lambda);
        own.map_or(f64::INFINITY, |(_, own)| (own - r_x).abs() / error)
    });
    figure
        .at_most(
            "numerical R_x for λ ≥ 2 against another half-space program, over its error",
            worst.fold(0.0, f64::max),
            1.0,
        )
        .source("an independent half-space program with 20 × 20 elements and 100 steps");
    Ok(())
}

fn table_claims(figure: &mut Figure) -> Result<(), Failure> {
    let table = rows::<3>(include_str!("../../../data/impact/spheres.csv"))?;
    let points: Vec<_> = table.iter().map(|[kappa, lambda, _]| (*kappa, *lambda)).collect();
    let found = values(&points)?;
    let pairs = |is_early: bool| {
        let rows = table.iter().zip(&found);
        let chosen = rows.filter(move |([kappa, lambda, _], _)| {
            ((*kappa - EARLY[0]).abs() < 1e-3 && *lambda == EARLY[1]) == is_early
        });
        chosen.map(|(row, own)| (*own, row[2])).collect::<Vec<_>>()
    };
    let source = "planar event-driven integration of an independent program";
    figure.all_close("R_x of 151 impacts", pairs(false), Absolute(1e-10)).source(source);
    figure
        .all_close("and of one whose integration stops 1e-4 T early", pairs(true), Absolute(1e-9))
        .source(source);
    let peaks = rows::<4>(include_str!("../../../data/impact/peaks.csv"))?;
    let points: Vec<_> = peaks.iter().map(|[_, kappa, lambda, _]| (*kappa, *lambda)).collect();
    let pairs = values(&points)?.into_iter().zip(peaks.iter().map(|row| row[3]));
    figure.all_close("the six peaks", pairs, Absolute(1e-9)).source(source);
    let beside: Vec<_> = points
        .iter()
        .flat_map(|&(kappa, lambda)| [(kappa, lambda - 0.01), (kappa, lambda + 0.01)])
        .collect();
    let lower = values(&beside)?;
    let tops = values(&points)?;
    let drop = (0..6)
        .flat_map(|i| [tops[i] - lower[2 * i], tops[i] - lower[2 * i + 1]])
        .fold(f64::INFINITY, f64::min);
    figure
        .holds("R_x is lower on both sides of each peak", drop > 0.0, drop)
        .source("places of the peaks by the independent program");
    Ok(())
}

fn limit_claims(figure: &mut Figure) -> Result<(), Failure> {
    let nus = linspace(0.0, 0.5, 6);
    let small: Vec<_> = nus.iter().map(|&nu| (kappa(nu), 1e-9)).collect();
    let limits = nus.iter().map(|&nu| restitution_without_slip(3.5 / kappa(nu)));
    let pairs = values(&small)?.into_iter().zip(limits);
    figure.all_close("λ = 1e-9 meets (9.46)", pairs, Absolute(1e-8)).source("closed form");
    let psi = 1e-4;
    let slope = |nu: f64| -> Result<f64, RestitutionError> {
        let kappa = kappa(nu);
        Ok((of_spheres(kappa, psi * kappa)? - restitution_without_slip(3.5 / kappa)) / psi)
    };
    let slopes = [(0.0, 0.0719), (0.3, 0.2577), (0.5, 0.382)];
    let pairs: Result<Vec<(f64, f64)>, RestitutionError> =
        slopes.iter().map(|&(nu, expected)| Ok((slope(nu)?, expected))).collect();
    figure
        .all_close("slope dR_x/dψ at 0, ν = 0, 0.3, 0.5", pairs?, Absolute(5e-4))
        .source("independent program");
    let seven: Vec<_> = nus.iter().map(|&nu| (kappa(nu), 7.0)).collect();
    let pairs = values(&seven)?.into_iter().map(|r| (r, 0.0));
    figure.all_close("R_x(7) = 0 for every ν", pairs, Absolute(1e-15)).source("(9.33): -1 + 7/λ");
    Ok(())
}
