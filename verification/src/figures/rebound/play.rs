//! The error of the table behind the interactive impact of the report.

use crate::play::{Instant, Table, exact, lambda_of_sliding, restitution};
use crate::{Absolute, Axis, Failure, Figure, FigureResult, Panel, Series, linspace};

/// Points between the entries of the table, as far from them as possible.
const POISSONS: [f64; 4] = [0.025, 0.175, 0.325, 0.475];
const LAMBDAS: usize = 160;

/// Differences at one point: for the force the largest, for the stick radius the mean over the instants.
struct Off {
    lambda: f64,
    restitution: f64,
    force: f64,
    stick: f64,
}

fn off(table: &Table, poisson: f64, lambda: f64) -> Result<Off, Failure> {
    let (read, exact) = (table.read(poisson, lambda), exact(poisson, lambda)?);
    let differences = |of: fn(&Instant) -> f64| -> Vec<f64> {
        let pairs = read.iter().zip(&exact);
        pairs.map(|(one, (_, other))| (of(one) - of(other)).abs()).collect()
    };
    let (force, stick) = (differences(|at| at.force), differences(|at| at.stick));
    let end = read.last().ok_or("an impact without instants")?;
    Ok(Off {
        lambda,
        restitution: (-end.velocity - restitution(poisson, lambda)?).abs(),
        force: force.into_iter().fold(0.0, f64::max),
        stick: stick.iter().sum::<f64>() / stick.len() as f64,
    })
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("entries", "11 Poisson's ratios × 73 angles × 49 instants");
    figure.assumed("ν tried", "0.025, 0.175, 0.325, 0.475: in the middle between entries");
    let table = Table::new()?;
    let mut panel = Panel::new(Axis::linear("λ"), Axis::log("difference in R_x"));
    let mut all = Vec::new();
    for poisson in POISSONS {
        let lambdas = linspace(0.01, 1.1 * lambda_of_sliding(poisson), LAMBDAS);
        let tried: Result<Vec<Off>, Failure> =
            lambdas.into_iter().map(|lambda| off(&table, poisson, lambda)).collect();
        let tried = tried?;
        let points = tried.iter().map(|off| (off.lambda, off.restitution.max(1e-8)));
        panel.add(Series::line(format!("ν = {poisson}"), points.collect::<Vec<_>>()));
        all.extend(tried);
    }
    figure.panel(panel);
    let most = |of: &dyn Fn(&Off) -> f64| all.iter().map(of).fold(0.0, f64::max);
    let source = "the exact impact, followed at each of these places";
    for (statement, found, bound) in [
        ("R_x", most(&|off| off.restitution), 3e-3),
        ("F_x/(f F_z,max) at every instant", most(&|off| off.force), 1e-2),
    ] {
        let statement = format!("the table's {statement}, off by at most");
        figure.at_most(statement, found, bound).source(source);
    }
    let mean = all.iter().map(|off| off.stick).sum::<f64>() / all.len() as f64;
    // The stick radius jumps where sticking begins or ends, and its mean across the jump is meaningless.
    let statement =
        "its stick radius over that of the greatest contact, off in the mean by at most";
    figure.at_most(statement, mean, 0.02).source(source);
    let slides = table.read(0.3, 8.0);
    let end = slides.last().ok_or("an impact without instants")?.velocity;
    figure
        .close("λ = 8: R_x", -end, 7.0 / 8.0 - 1.0, Absolute(1e-12))
        .source("(9.33), sliding throughout");
    figure.snapshot_digits(3);
    Ok(figure)
}
