//! An impact with uncertain inputs: the distribution of its outcome.

use crate::columns::{self, add_fields};
use crate::error::CliError;
use crate::output::{Format, Picture, json};
use carom_cases::Error;
use carom_cases::case::{CaseError, CaseFault, ImpactFile, Input, Uncertainty};
use carom_cases::theory::readable;
use carom_impact::uncertain::{Bin, Quantity, Study, Summary};
use carom_impact::{CollisionError, Outcome};
use carom_laws::validity::{Limit, Validity};
use carom_plot::{Axis, Panel, Series};
use carom_special::RangeError;
use carom_table::short;
use carom_table::{Cell, Column, row};
use serde::Serialize;
use serde::ser::SerializeMap as _;

/// The results of all samples. SI units, angles in degrees.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Report {
    samples: usize,
    no_impact: usize,
    out_of_range: Vec<Rejected>,
    /// The methods with which the samples were computed.
    methods: Vec<MethodRecord>,
    /// The largest of all samples.
    error_estimate: f64,
    /// Number of samples in which the coupling of dissimilar materials is neglected.
    coupling_neglected: usize,
    /// Limits of the theory that are exceeded with all inputs at their means.
    outside_theory: Vec<String>,
    inputs: Vec<Spread>,
    outcome: Vec<Spread>,
}

/// Samples with values that are not physically possible.
#[derive(Debug, Clone, Serialize)]
struct Rejected {
    field: &'static str,
    allowed: &'static str,
    first_value: f64,
    count: usize,
}

/// Number of samples that were computed by one method.
#[derive(Debug, Clone, Serialize)]
struct MethodRecord {
    method: &'static str,
    count: usize,
}

/// The distribution of a number.
#[derive(Debug, Clone)]
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

const COLUMNS: &[Column<Spread>] = &[
    Column::text("name", "", "name of the quantity", |spread| spread.name.into()),
    Column::count("count", "", "number of samples that have it", |spread| {
        (spread.count as u64).into()
    }),
    Column::new("mean", "", "mean, in the unit of the quantity", |spread| spread.mean.into()),
    Column::new("sd", "", "standard deviation", |spread| spread.sd.into()),
    Column::new("standard_error", "", "of the mean", |spread| spread.standard_error.into()),
    Column::new("minimum", "", "smallest sample", |spread| spread.minimum.into()),
    Column::new("maximum", "", "largest sample, after the quantiles", |s| s.maximum.into()),
];

impl Serialize for Spread {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        add_fields(&mut map, &row(COLUMNS, Some(self)))?;
        map.serialize_entry("quantiles", &self.quantiles)?;
        map.serialize_entry("histogram", &self.histogram)?;
        map.end()
    }
}

/// Help on the rows of a distribution.
pub(super) fn help() -> String {
    columns::help("For a case with distributions, a row for each quantity", COLUMNS)
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

/// Computes all samples of a case.
pub(super) fn study(file: &ImpactFile<'_>, uncertainty: &Uncertainty) -> Result<Study, Error> {
    let distributions: Vec<_> = file.inputs().iter().filter_map(Input::distribution).collect();
    let law = file.nominal().contact.law;
    let study =
        uncertainty.sampling.run_by(&law, &distributions, |values| match file.case(values) {
            Ok(case) => Ok(case.collision),
            Err(CaseError { fault: CaseFault::Collision { source, .. }, .. }) => Err(*source),
            Err(error) => Err(CollisionError::Range(out_of_range(file, &error))),
        });
    Ok(study?)
}

/// Turns an error in a sample into one of a field out of range.
fn out_of_range(file: &ImpactFile<'_>, error: &CaseError) -> RangeError {
    if let CaseFault::Range { value, .. } = &error.fault {
        if let Some(input) = file.inputs().iter().find(|input| input.field == error.field) {
            return RangeError::new(input.field, *value, input.allowed);
        }
        return RangeError::new("a derived value", *value, "possible together with the others");
    }
    RangeError::new("the drawn values", f64::NAN, "possible together")
}

/// The limits of the theory exceeded by the impact with all inputs at their means.
pub(super) fn validity(file: &ImpactFile<'_>) -> Validity {
    let case = file.nominal();
    let outcome = case.contact.law.solve(&case.collision).ok();
    outcome.as_ref().and_then(Outcome::rebound).map(|rebound| rebound.validity).unwrap_or_default()
}

pub(super) fn report(
    file: &ImpactFile<'_>,
    case: &Uncertainty,
    study: &Study,
    validity: Validity,
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
        methods: study
            .methods()
            .iter()
            .map(|&(method, count)| MethodRecord { method, count })
            .collect(),
        error_estimate: study.error_estimate(),
        coupling_neglected: study.coupling_neglected(),
        outside_theory: validity.reasons(),
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
        Format::Csv | Format::Chosen(_) => columns::cell_rows(format, &rows(report, |_| true)),
        Format::Table(page) => {
            // Quantities that are always zero are omitted.
            let moves = |spread: &Spread| spread.minimum != 0.0 || spread.maximum != 0.0;
            let table = columns::cell_rows(format, &rows(report, moves))?;
            let (none, all) = (report.no_impact, report.samples);
            let out = report.out_of_range.iter().map(|seen| seen.count).sum::<usize>();
            let methods = report.methods.iter().map(|m| format!("{} {}", m.count, m.method));
            let methods = methods.collect::<Vec<_>>().join(", ");
            let estimate = readable(report.error_estimate);
            Ok(table
                + &page.fold(&format!(
                    "{all} samples, {none} without impact, {out} out of range; methods: {methods}; \
                 velocities may be off by {estimate} of those before\n"
                )))
        }
    }
}

fn rows(report: &Report, shown: impl Fn(&Spread) -> bool) -> Vec<Vec<Cell>> {
    let row = |kind: &'static str, spread: &Spread| {
        let mut cells = vec![Cell::new("kind", "", "input or outcome", kind)];
        cells.extend(row(COLUMNS, Some(spread)));
        let maximum = cells.len() - 1;
        let quantile = |quantile: &QuantileRecord| {
            Cell::new(format!("q{}", quantile.part), "", "quantile", quantile.value)
        };
        cells.splice(maximum..maximum, spread.quantiles.iter().map(quantile));
        cells
    };
    let inputs = report.inputs.iter().map(|spread| row("input", spread));
    let outcome = report.outcome.iter().filter(|spread| shown(spread));
    inputs.chain(outcome.map(|spread| row("outcome", spread))).collect()
}

/// Limits that are told in another way: coupling of the samples, the approach as outside the theory.
const APART: [Limit; 2] = [Limit::Coupling, Limit::LargeApproach];

/// Warnings about a contact that is large or yields at the means, and about samples that are left out.
pub(super) fn warnings(report: &Report, validity: Validity) -> Vec<String> {
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
    let told = validity.exceeded().filter(|excess| !APART.contains(&excess.limit));
    warnings.extend(told.map(|excess| format!("at the means: {excess}")));
    if report.coupling_neglected > 0 {
        let (neglected, all) = (report.coupling_neglected, report.samples);
        let words = Limit::Coupling.words().to_string_lossy();
        warnings.push(format!("{words} in {neglected} of {all} samples"));
    }
    if report.no_impact > 0 {
        let (none, all) = (report.no_impact, report.samples);
        warnings.push(format!("{none} of {all} samples have no impact and are left out"));
    }
    warnings
}

/// Histograms of R_x and of speed, angle and spin of the moving body.
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
    Picture::new("Distribution of the impact", panels)
}

/// The steps of a histogram; a bin of zero width is drawn as a narrow bar.
fn outline(bins: &[BinRecord]) -> Vec<(f64, f64)> {
    let mut points = Vec::with_capacity(4 * bins.len());
    for bin in bins {
        let widen = if bin.low == bin.high { 1e-3 * bin.low.abs().max(1e-3) } else { 0.0 };
        let (low, high, count) = (bin.low - widen, bin.high + widen, bin.count as f64);
        points.extend([(low, 0.0), (low, count), (high, count), (high, 0.0)]);
    }
    points
}
