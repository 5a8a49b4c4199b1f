//! Fig. 15.2: the tangential restitution of similar spheres.

use carom_impact::closed_form::restitution_without_slip;
use carom_impact::restitution::{RestitutionError, of_spheres};
use rayon::prelude::*;

use crate::reference::rows;
use crate::{Axis, Claim, Figure, FigureResult, Panel, Series, Tolerance, linspace};

/// κ and λ of the row that ends early.
const EARLY: [f64; 2] = [1.055_6, 0.5];

fn kappa(nu: f64) -> f64 {
    (2.0 - nu) / (2.0 * (1.0 - nu))
}

fn values(points: &[(f64, f64)]) -> Result<Vec<f64>, RestitutionError> {
    points.par_iter().map(|&(kappa, lambda)| of_spheres(kappa, lambda)).collect()
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("ν₁ = ν₂", "0, 0.1 .. 0.5");
    figure.assumed("λ", "0 to 10");
    let mut panel = Panel::new(Axis::linear("λ"), Axis::linear("R_x")).titled("Spheres");
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
    figure.panel(panel);
    table_claims(&mut figure)?;
    limit_claims(&mut figure)?;

    let first_merged = lambdas.iter().position(|&lambda| lambda > 5.5).unwrap_or(0);
    let least_rise = (0..first_merged)
        .flat_map(|i| curves.windows(2).map(move |pair| pair[1][i] - pair[0][i]))
        .fold(f64::INFINITY, f64::min);
    figure.claim(
        Claim::holds("R_x rises with ν up to λ = 5.5", least_rise > 0.0, least_rise)
            .source("ordering of the printed curves"),
    );
    let merged = lambdas.iter().enumerate().filter(|(_, lambda)| **lambda >= 6.0 + 1e-9);
    let spread =
        merged.map(|(i, lambda)| (curves[0][i] - (7.0 / lambda - 1.0)).abs()).fold(0.0, f64::max);
    figure.claim(
        Claim::at_most("ν = 0 slides throughout from λ = 6 on: R_x = 7/λ - 1", spread, 1e-15)
            .source("(9.33)"),
    );
    figure.deviation(
        "complete slip for λ ≥ 7",
        "complete slip for λ ≥ 7 - κ",
        "the printed condition overlooks the elastic recoil; sliding with R_x > 0 is possible",
    );
    Ok(figure)
}

fn table_claims(figure: &mut Figure) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
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
    figure.claim(
        Claim::all_close("R_x of 151 impacts", pairs(false), Tolerance::Absolute(1e-10))
            .source(source),
    );
    figure.claim(
        Claim::all_close(
            "and of one whose integration stops 1e-4 T early",
            pairs(true),
            Tolerance::Absolute(1e-9),
        )
        .source(source),
    );
    let peaks = rows::<4>(include_str!("../../../data/impact/peaks.csv"))?;
    let points: Vec<_> = peaks.iter().map(|[_, kappa, lambda, _]| (*kappa, *lambda)).collect();
    let pairs = values(&points)?.into_iter().zip(peaks.iter().map(|row| row[3]));
    figure
        .claim(Claim::all_close("the six peaks", pairs, Tolerance::Absolute(1e-9)).source(source));
    let beside: Vec<_> = points
        .iter()
        .flat_map(|&(kappa, lambda)| [(kappa, lambda - 0.01), (kappa, lambda + 0.01)])
        .collect();
    let lower = values(&beside)?;
    let tops = values(&points)?;
    let drop = (0..6)
        .flat_map(|i| [tops[i] - lower[2 * i], tops[i] - lower[2 * i + 1]])
        .fold(f64::INFINITY, f64::min);
    figure.claim(
        Claim::holds("R_x is lower on both sides of each peak", drop > 0.0, drop)
            .source("places of the peaks by the independent program"),
    );
    Ok(())
}

fn limit_claims(figure: &mut Figure) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
    let nus = linspace(0.0, 0.5, 6);
    let small: Vec<_> = nus.iter().map(|&nu| (kappa(nu), 1e-9)).collect();
    let limits = nus.iter().map(|&nu| restitution_without_slip(3.5 / kappa(nu)));
    let pairs = values(&small)?.into_iter().zip(limits);
    figure.claim(
        Claim::all_close("λ = 1e-9 meets (9.46)", pairs, Tolerance::Absolute(1e-8))
            .source("closed form"),
    );
    let psi = 1e-4;
    let slope = |nu: f64| -> Result<f64, RestitutionError> {
        let kappa = kappa(nu);
        Ok((of_spheres(kappa, psi * kappa)? - restitution_without_slip(3.5 / kappa)) / psi)
    };
    let slopes = [(0.0, 0.0719), (0.3, 0.2577), (0.5, 0.382)];
    let pairs: Result<Vec<(f64, f64)>, RestitutionError> =
        slopes.iter().map(|&(nu, expected)| Ok((slope(nu)?, expected))).collect();
    figure.claim(
        Claim::all_close("slope dR_x/dψ at 0, ν = 0, 0.3, 0.5", pairs?, Tolerance::Absolute(5e-4))
            .source("independent program"),
    );
    let seven: Vec<_> = nus.iter().map(|&nu| (kappa(nu), 7.0)).collect();
    let pairs = values(&seven)?.into_iter().map(|r| (r, 0.0));
    figure.claim(
        Claim::all_close("R_x(7) = 0 for every ν", pairs, Tolerance::Absolute(1e-15))
            .source("(9.33): -1 + 7/λ"),
    );
    Ok(())
}
