//! `carom restitution`: R_x of similar spheres by kappa and lambda.

use crate::error::CliError;
use crate::output::{Answer, Format, PlotFile, csv, json, short, table};
use crate::range::Values;
use carom_impact::oblique::{Groups, ObliqueImpact, Regime};
use carom_plot::{Axis, Marker, Panel, Series, render};
use rayon::prelude::*;
use serde::Serialize;
use std::path::PathBuf;

/// Tangential restitution R_x of solid spheres of similar material.
///
/// R_x is the tangential velocity of the contact points after the impact over that before,
/// reversed: 1 rebounds elastically, 0 stops, -1 slides on unhindered.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Ratio of stiffness c_z/c_x, (2 - nu)/(2 (1 - nu)): a value, a list 1,1.2 or
    /// start:stop:count.
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    kappa: Values,
    /// Tangential over normal velocity, over friction: a value, a list 1,2 or start:stop:count.
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    lambda: Values,
    /// Format of the results.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// Draw the results into this file, as SVG.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
}

#[derive(Debug, Serialize)]
struct Row {
    kappa: f64,
    #[serde(serialize_with = "finite_or_word")]
    lambda: f64,
    #[serde(rename = "R_x")]
    restitution: f64,
    regimes: Vec<&'static str>,
}

const HEADS: [&str; 4] = ["kappa", "lambda", "R_x", "regimes"];

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let pairs: Vec<Groups> = groups(&arguments.kappa, &arguments.lambda)?;
    let inputs = arguments
        .kappa
        .0
        .iter()
        .flat_map(|kappa| arguments.lambda.0.iter().map(|lambda| (*kappa, *lambda)));
    let inputs: Vec<(f64, f64)> = inputs.collect();
    let rows = pairs
        .into_par_iter()
        .zip(inputs)
        .map(|(groups, (kappa, lambda))| {
            let impact = ObliqueImpact::new(groups)?;
            let regimes = impact.regimes().map(Regime::name).collect();
            Ok(Row { kappa, lambda, restitution: impact.restitution(), regimes })
        })
        .collect::<Result<Vec<Row>, CliError>>()?;
    let text = match arguments.format {
        Format::Json => json(&rows)?,
        Format::Csv => csv(&HEADS, &cells(&rows, |value| value.to_string()))?,
        Format::Table => table(&HEADS, &cells(&rows, short)),
    };
    let plot = match &arguments.plot {
        Some(path) => Some(PlotFile { path: path.clone(), svg: plot(&rows, arguments)? }),
        None => None,
    };
    Ok(Answer { text, warnings: Vec::new(), plot })
}

fn groups(kappa: &Values, lambda: &Values) -> Result<Vec<Groups>, CliError> {
    let pairs = kappa.0.iter().flat_map(|kappa| lambda.0.iter().map(|lambda| (*kappa, *lambda)));
    Ok(pairs.map(|(kappa, lambda)| Groups::of_spheres(kappa, lambda)).collect::<Result<_, _>>()?)
}

fn cells(rows: &[Row], number: impl Fn(f64) -> String) -> Vec<Vec<String>> {
    let cells = rows.iter().map(|row| {
        let numbers = [row.kappa, row.lambda, row.restitution].map(&number);
        numbers.into_iter().chain([row.regimes.join(" ")]).collect()
    });
    cells.collect()
}

/// R_x against lambda, a line for each kappa; against kappa if there is one lambda only.
fn plot(rows: &[Row], arguments: &Arguments) -> Result<String, CliError> {
    let over_kappa = arguments.lambda.0.len() == 1 && arguments.kappa.0.len() > 1;
    let (label, lines): (_, Vec<Series>) = if over_kappa {
        let points = rows.iter().map(|row| (row.kappa, row.restitution));
        ("κ", vec![line(format!("λ = {}", short(arguments.lambda.0[0])), points.collect())])
    } else {
        let per_kappa = rows.chunks(arguments.lambda.0.len());
        let lines = per_kappa.map(|rows| {
            let finite = rows.iter().filter(|row| row.lambda.is_finite());
            let points = finite.map(|row| (row.lambda, row.restitution));
            line(format!("κ = {}", short(rows[0].kappa)), points.collect())
        });
        ("λ", lines.collect())
    };
    let mut panel = Panel::new(Axis::linear(label), Axis::linear("R_x"));
    lines.into_iter().for_each(|line| panel.add(line));
    Ok(render("Tangential restitution of spheres", &[panel])?)
}

fn line(label: String, points: Vec<(f64, f64)>) -> Series {
    if points.len() > 1 {
        Series::line(label, points)
    } else {
        Series::markers(label, Marker::Dot, points)
    }
}

/// JSON has no infinity: lambda of frictionless spheres is the word `inf`.
fn finite_or_word<S: serde::Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    if value.is_finite() {
        serializer.serialize_f64(*value)
    } else {
        serializer.serialize_str("inf")
    }
}
