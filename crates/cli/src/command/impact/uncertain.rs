//! An impact with uncertain inputs: what its outcome is, and how it scatters.

use crate::case::{CaseError, ImpactFile, Input, Uncertainty};
use crate::command::theory::Excess;
use crate::error::CliError;
use crate::output::{Format, Picture, csv, json, short, table};
use carom_impact::uncertain::{Bin, Quantity, Study, Summary, UncertainError};
use carom_impact::{CollisionError, Outcome};
use carom_plot::{Axis, Panel, Series};
use carom_special::RangeError;
use serde::Serialize;

/// The outcome of all samples. SI units, angles in degrees.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Report {
    samples: usize,
    no_impact: usize,
    out_of_range: Vec<Rejected>,
    /// What lies outside the theory where all inputs have their means, if anything.
    outside_theory: Vec<String>,
    inputs: Vec<Spread>,
    outcome: Vec<Spread>,
}

/// Samples that lie outside what physics allows.
#[derive(Debug, Clone, Serialize)]
struct Rejected {
    field: &'static str,
    allowed: &'static str,
    first_value: f64,
    count: usize,
}

/// A number and its scatter.
#[derive(Debug, Clone, Serialize)]
struct Spread {
    name: &'static str,
    count: usize,
    mean: f64,
    sd: f64,
    standard_error: f64,
    minimum: f64,
    maximum: f64,
    quantiles: Vec<QuantileRecord>,
    histogram: Vec<BinRecord>,
}

#[derive(Debug, Clone, Copy, Serialize)]
struct QuantileRecord {
    part: f64,
    value: f64,
}

#[derive(Debug, Clone, Copy, Serialize)]
struct BinRecord {
    low: f64,
    high: f64,
    count: usize,
}

/// Follows all samples of a case.
pub(super) fn study(
    file: &ImpactFile<'_>,
    uncertainty: &Uncertainty,
) -> Result<Study, UncertainError> {
    let distributions: Vec<_> = file.inputs().iter().filter_map(Input::distribution).collect();
    uncertainty.sampling.run(&distributions, |values| match file.case(values) {
        Ok(case) => Ok(case.collision),
        Err(CaseError::Collision { source, .. }) => Err(*source),
        Err(error) => Err(CollisionError::Range(out_of_range(file, &error))),
    })
}

/// The error of drawn values as that of a field out of range.
fn out_of_range(file: &ImpactFile<'_>, error: &CaseError) -> RangeError {
    if let CaseError::Range { field, value, .. } = error {
        if let Some(input) = file.inputs().iter().find(|input| input.field == field) {
            return RangeError::new(input.field, *value, input.allowed);
        }
        return RangeError::new("a derived value", *value, "possible together with the others");
    }
    RangeError::new("the drawn values", f64::NAN, "possible together")
}

/// How far the impact with all inputs at their means lies outside the theory.
pub(super) fn excess(file: &ImpactFile<'_>) -> Excess {
    let outcome = file.nominal().collision.solve().ok();
    outcome.as_ref().and_then(Outcome::rebound).map(Excess::of_impact).unwrap_or_default()
}

pub(super) fn report(
    file: &ImpactFile<'_>,
    case: &Uncertainty,
    study: &Study,
    excess: Excess,
) -> Result<Report, CliError> {
    let inputs = file.inputs().iter().map(|input| input.field).zip(study.inputs());
    let outcome = Quantity::ALL.iter().filter_map(|q| Some((q.name(), study.summary(*q)?)));
    Ok(Report {
        samples: study.samples(),
        no_impact: study.no_impact(),
        out_of_range: study
            .out_of_range()
            .iter()
            .map(|seen| Rejected {
                field: seen.first.field,
                allowed: seen.first.allowed,
                first_value: seen.first.value,
                count: seen.count,
            })
            .collect(),
        outside_theory: excess.reasons(),
        inputs: inputs.map(|(n, s)| spread(case, n, s)).collect::<Result<_, _>>()?,
        outcome: outcome.map(|(n, s)| spread(case, n, s)).collect::<Result<_, _>>()?,
    })
}

fn spread(case: &Uncertainty, name: &'static str, summary: &Summary) -> Result<Spread, CliError> {
    let quantile = |part: &f64| Ok(QuantileRecord { part: *part, value: summary.quantile(*part)? });
    let record = |bin: Bin| BinRecord { low: bin.low, high: bin.high, count: bin.count };
    Ok(Spread {
        name,
        count: summary.count(),
        mean: summary.mean(),
        sd: summary.deviation(),
        standard_error: summary.standard_error(),
        minimum: summary.quantile(0.0)?,
        maximum: summary.quantile(1.0)?,
        quantiles: case.quantiles.iter().map(quantile).collect::<Result<_, CliError>>()?,
        histogram: summary.histogram(case.bins)?.into_iter().map(record).collect(),
    })
}

pub(super) fn render_text(report: &Report, format: Format) -> Result<String, CliError> {
    match format {
        Format::Json => json(report),
        Format::None => Ok(String::new()),
        Format::Csv => {
            let (heads, rows) = cells(report, |_| true, |value| value.to_string());
            csv(&heads.iter().map(String::as_str).collect::<Vec<_>>(), &rows)
        }
        Format::Table => {
            // What never moves is left out.
            let (heads, rows) =
                cells(report, |spread| spread.minimum != 0.0 || spread.maximum != 0.0, short);
            let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
            Ok(format!(
                "{}{} samples, {} without impact, {} out of range\n",
                table(&heads, &rows),
                report.samples,
                report.no_impact,
                report.out_of_range.iter().map(|seen| seen.count).sum::<usize>(),
            ))
        }
    }
}

fn cells(
    report: &Report,
    shown: impl Fn(&Spread) -> bool,
    number: impl Fn(f64) -> String,
) -> (Vec<String>, Vec<Vec<String>>) {
    let mut heads: Vec<String> =
        ["kind", "name", "count", "mean", "sd", "standard_error", "minimum"]
            .map(str::to_owned)
            .into();
    let parts = report.inputs.first().map(|spread| spread.quantiles.as_slice()).unwrap_or_default();
    heads.extend(parts.iter().map(|quantile| format!("q{}", quantile.part)));
    heads.push("maximum".to_owned());
    let row = |kind: &str, spread: &Spread| {
        let mut row = vec![kind.to_owned(), spread.name.to_owned(), spread.count.to_string()];
        let before = [spread.mean, spread.sd, spread.standard_error, spread.minimum];
        let quantiles = spread.quantiles.iter().map(|quantile| quantile.value);
        row.extend(before.into_iter().chain(quantiles).chain([spread.maximum]).map(&number));
        row
    };
    let inputs = report.inputs.iter().map(|spread| row("input", spread));
    let outcome = report.outcome.iter().filter(|spread| shown(spread));
    let rows = inputs.chain(outcome.map(|spread| row("outcome", spread))).collect();
    (heads, rows)
}

/// What was left out of the numbers, for standard error.
pub(super) fn warnings(report: &Report) -> Vec<String> {
    let mut warnings: Vec<String> = report
        .out_of_range
        .iter()
        .map(|seen| {
            format!(
                "{} of {} samples are left out: {} must be {} (the first is {})",
                seen.count,
                report.samples,
                seen.field,
                seen.allowed,
                short(seen.first_value)
            )
        })
        .collect();
    if report.no_impact > 0 {
        let (none, all) = (report.no_impact, report.samples);
        warnings.push(format!("{none} of {all} samples make no impact and are left out"));
    }
    warnings
}

/// Histograms of R_x and of speed, angle and spin of the body that moves.
pub(super) fn draw(report: &Report) -> Picture {
    let moved = |name: &str| {
        report.outcome.iter().any(|spread| spread.name == name && spread.maximum > 0.0)
    };
    let (body, names) = match moved("body_1_speed") {
        true => ("body 1", ["R_x", "body_1_speed", "body_1_angle", "body_1_spin_y"]),
        false => ("body 2", ["R_x", "body_2_speed", "body_2_angle", "body_2_spin_y"]),
    };
    let labels = ["R_x", "speed / m/s", "angle from the normal / °", "spin_y / rad/s"];
    let mut panels = Vec::new();
    for (name, label) in names.iter().zip(labels) {
        let Some(spread) = report.outcome.iter().find(|spread| spread.name == *name) else {
            continue;
        };
        let mut panel = Panel::new(Axis::linear(label), Axis::linear("samples"));
        if *name != "R_x" {
            panel = panel.titled(format!("{body} afterwards"));
        }
        panel.add(Series::area("", outline(&spread.histogram)).coloured(0));
        panel.add(Series::line("", outline(&spread.histogram)).coloured(0));
        panels.push(panel);
    }
    Picture::new("Scatter of the impact", panels)
}

/// The steps of a histogram; one bin of no width as a bar with some.
fn outline(bins: &[BinRecord]) -> Vec<(f64, f64)> {
    let mut points = Vec::with_capacity(4 * bins.len());
    for bin in bins {
        let widen = if bin.low == bin.high { 1e-3 * bin.low.abs().max(1e-3) } else { 0.0 };
        let (low, high, count) = (bin.low - widen, bin.high + widen, bin.count as f64);
        points.extend([(low, 0.0), (low, count), (high, count), (high, 0.0)]);
    }
    points
}
