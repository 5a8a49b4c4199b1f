//! Proposition 8: N log N products against elimination, counted and measured.

use super::super::Failure;
use crate::{Axis, Cell, Claim, Figure, FigureResult, Panel, Series, Table, Tolerance, logspace};
use carom_halfspace::operator::{
    Blocks, DisplacementField, HalfSpaceOperator, SurfaceOperator, Threads, TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// N^3 over N log10 N.
fn factor(points: f64) -> f64 {
    points.powi(2) / libm::log10(points)
}

/// The shortest of several runs: what the machine does when nothing disturbs it.
fn shortest(runs: usize, mut work: impl FnMut() -> Result<(), Failure>) -> Result<f64, Failure> {
    let mut best = Duration::MAX;
    for _ in 0..runs {
        let start = Instant::now();
        work()?;
        best = best.min(start.elapsed());
    }
    Ok(best.as_secs_f64())
}

/// Seconds of a product with `cells` squared unknowns.
fn product_time(cells: usize) -> Result<f64, Failure> {
    let body = Material::from_shear(1.0, 0.3)?;
    let grid = Grid::new(cells, cells, 1.0, 1.0)?;
    let pair = MaterialPair::new(body, body)?;
    let operator = HalfSpaceOperator::with_blocks(pair, grid, Blocks::Normal, Threads::One)?;
    let mut workspace = operator.workspace();
    let pressure = vec![1.0; grid.cells()];
    let mut w = vec![0.0; grid.cells()];
    shortest(15, || {
        let load = TractionField::normal(black_box(&pressure));
        Ok(operator.apply(load, DisplacementField::normal(&mut w), &mut workspace)?)
    })
}

/// Seconds of a dense product with `cells` squared unknowns, whatever the entries.
fn dense_time(cells: usize) -> Result<f64, Failure> {
    let unknowns = cells * cells;
    let row: Vec<f64> = (0..2 * unknowns).map(|i| 1.0 / (1.0 + i as f64)).collect();
    let pressure = vec![1.0; unknowns];
    shortest(3, || {
        for i in 0..unknowns {
            let sum: f64 = row[i..].iter().zip(&pressure).map(|(a, p)| a * p).sum();
            black_box(sum);
        }
        Ok(())
    })
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("N", "1000 points in the contact area");
    let sizes = logspace(10.0, 1e6, 51);
    let mut panel = Panel::new(Axis::log("N"), Axis::log("multiplications"));
    type Count = fn(f64) -> f64;
    let counts: [(&str, Count); 3] = [
        ("elimination, N³", |n| n.powi(3)),
        ("direct product, N²", |n| n * n),
        ("fast product, N log₁₀ N", |n| n * libm::log10(n)),
    ];
    for (name, count) in counts {
        panel.add(Series::line(name, sizes.iter().map(|&n| (n, count(n))).collect::<Vec<_>>()));
    }
    figure.panel(panel);
    figure.claim(
        Claim::close(
            "gain of 333 000 for N = 1000",
            factor(1000.0),
            333_000.0,
            Tolerance::Absolute(500.0),
        )
        .source("proposition 8, read as N³/(N log N)"),
    );
    figure.deviation(
        "N²/(N log N) is 333 000 for N = 1000",
        "N³/(N log₁₀ N) = N²/log₁₀ N = 333 333",
        "N²/(N log N) is 333",
    );
    measured(&mut figure)?;
    Ok(figure)
}

/// Times differ from run to run: they are remarks, and the claims leave a wide margin.
fn measured(figure: &mut Figure) -> Result<(), Failure> {
    let times = [(32, product_time(32)?), (64, product_time(64)?), (256, product_time(256)?)];
    let dense = dense_time(64)?;
    let mut table = Table::new("Measured here, one thread", ["product", "milliseconds"]);
    let mut row = |what: String, seconds: f64| {
        table.row([Cell::Text(what), Cell::Remark(format!("{:.3}", 1e3 * seconds))]);
    };
    for (cells, seconds) in times {
        row(format!("fast, N = {cells}²"), seconds);
    }
    row("dense, N = 64²".to_owned(), dense);
    figure.table(table);
    figure.claim(
        Claim::at_least(
            "a fast product of 64² beats the dense one fivefold",
            dense / times[1].1,
            5.0,
        )
        .source("measured"),
    );
    // N log N grows 64-fold from 32^2 to 256^2, times 1.6; N^2 would grow 4096-fold.
    let growth = times[2].1 / times[0].1;
    figure.claim(
        Claim::at_most("from 32² to 256² the time grows as N log N, not as N²", growth, 512.0)
            .source("measured"),
    );
    Ok(())
}
