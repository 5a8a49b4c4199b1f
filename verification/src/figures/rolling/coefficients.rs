//! Creep coefficients beside an independent calculation and beside what is printed.

use std::f64::consts::PI;

use crate::reference::reader;
use crate::{Axis, Failure, Figure, FigureResult, Marker, Panel, Relative, Series, Table};
use carom_rolling::creep_coefficients;
use rayon::prelude::*;

/// The axis ratios a/b that are computed lie between these.
const RATIOS: [f64; 2] = [0.2, 5.0];
const NAMES: [&str; 4] = ["C₁₁", "C₂₂", "C₂₃", "C₃₃"];

struct Row {
    ratio: f64,
    poisson: f64,
    printed: [f64; 4],
    other: [f64; 4],
    own: [f64; 4],
    /// C23 and C32.
    couplings: (f64, f64),
}

fn rows() -> Result<Vec<Row>, Failure> {
    let mut reader = reader(include_str!("../../../data/rolling/kalker_coefficients.csv"));
    let records: Result<Vec<_>, _> = reader.records().collect();
    let rows: Result<Vec<_>, _> = records?.into_par_iter().map(|record| row(&record)).collect();
    Ok(rows?.into_iter().flatten().collect())
}

/// A row of the table beside what is computed; none for a ratio outside those that are.
fn row(record: &csv::StringRecord) -> Result<Option<Row>, Failure> {
    let numbers: Result<Vec<f64>, _> = record.iter().map(str::parse).collect();
    let numbers = numbers?;
    let [ratio, poisson, rest @ ..] = &numbers[..] else { return Err("a row is short".into()) };
    if *ratio < RATIOS[0] || *ratio > RATIOS[1] {
        return Ok(None);
    }
    let c = creep_coefficients(*ratio, *poisson)?;
    // The two couplings are one in the continuum.
    let own = [c.c11, c.c22, 0.5 * (c.c23 + c.c32), c.c33];
    let four = |part: &[f64]| <[f64; 4]>::try_from(part);
    let (printed, other) = (four(&rest[..4])?, four(&rest[4..])?);
    let couplings = (c.c23, c.c32);
    Ok(Some(Row { ratio: *ratio, poisson: *poisson, printed, other, own, couplings }))
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.snapshot_digits(5);
    figure.assumed("bodies", "two equal ones; a along the direction of rolling");
    figure.assumed(
        "meshes",
        "four of the same shape, 1600 elements the finest, extrapolated to none",
    );
    let rows = rows()?;
    let heads = ["a/b", "ν", "C₁₁", "C₂₂", "C₂₃", "C₃₃"];
    let mut table = Table::new("Computed", heads);
    for row in &rows {
        table.row([row.ratio, row.poisson].into_iter().chain(row.own));
    }
    figure.table(table);
    for (which, name) in NAMES.into_iter().enumerate() {
        let mut panel = Panel::new(Axis::log("a/b"), Axis::log(name)).titled(name);
        for (colour, poisson) in [0.0, 0.25, 0.5].into_iter().enumerate() {
            let of = |value: fn(&Row) -> &[f64; 4]| -> Vec<(f64, f64)> {
                let rows = rows.iter().filter(|row| row.poisson == poisson);
                rows.map(|row| (row.ratio, value(row)[which])).collect()
            };
            let label = format!("ν = {poisson}");
            panel.add(Series::line(label, of(|row| &row.own)).coloured(colour));
            let printed = of(|row| &row.printed);
            panel.add(Series::markers("", Marker::Circle, printed).coloured(colour));
        }
        figure.panel(panel);
        let allowed = if which == 3 { 5e-3 } else { 2e-3 };
        let pairs = rows.iter().map(|row| (row.own[which], row.other[which]));
        figure
            .all_close(format!("{name} by the calculation"), pairs, Relative(allowed))
            .source("an independent boundary-element calculation");
        if which < 3 {
            let pairs = rows.iter().map(|row| (row.own[which], row.printed[which]));
            figure
                .all_close(format!("{name} as printed"), pairs, Relative(0.015))
                .source("Kalker 1990, table E.3");
        }
    }
    figure
        .all_close("C₂₃ = C₃₂", rows.iter().map(|row| row.couplings), Relative(1e-4))
        .source("reciprocity in the continuum; no mesh has it");
    let circle = rows.iter().find(|row| row.ratio == 1.0 && row.poisson == 0.0);
    let own = circle.ok_or("the circle is missing")?.own;
    let closed = [(own[0], 32.0 / (3.0 * PI)), (own[1], 32.0 / (3.0 * PI)), (own[2], 4.0 / 3.0)];
    figure
        .all_close("circle, ν = 0: 32/3π, 32/3π, 4/3", closed, Relative(1e-4))
        .source("closed forms of full adhesion");
    figure.deviation(
        "C₁₁ = 4.83 at a/b = 0.5, ν = 0.5",
        "4.87",
        "both calculations; 4.83 lies off the line through its neighbours too",
    );
    Ok(figure)
}
