//! `carom hertz`: the contact of two surfaces under normal load.

use crate::case::{Given, HertzCase, Numbers};
use crate::command::CaseArguments;
use crate::error::CliError;
use crate::output::{Answer, Format, PlotFile, csv, json, read_case, short, table};
use carom_laws::hertz::{Hertz, HertzState};
use carom_plot::{Axis, Panel, Series, linspace, render};
use carom_special::RangeError;
use serde::Serialize;
use std::path::PathBuf;

/// Hertz contact of two surfaces: ellipse, approach, pressure and stiffness.
///
/// The file is TOML in SI units; see examples/hertz_*.toml. x is the direction of the larger
/// relative curvature, so that a <= b.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    given: CaseArguments,
    /// Draw the pressure, or the loads of a sweep, into this file, as SVG.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
}

/// A loaded contact. SI units.
#[derive(Debug, Serialize)]
struct Row {
    force: f64,
    approach: f64,
    semi_axis_a: f64,
    semi_axis_b: f64,
    peak_pressure: f64,
    normal_stiffness: f64,
}

/// All of a case: the contact and its loads.
#[derive(Debug, Serialize)]
struct Report<'a> {
    axis_ratio: f64,
    /// From the first principal direction of body 1 to the x axis, degrees.
    angle: f64,
    c_x: f64,
    c_y: f64,
    c_z: f64,
    loads: &'a [Row],
}

const HEADS: [&str; 6] =
    ["force", "approach", "semi_axis_a", "semi_axis_b", "peak_pressure", "normal_stiffness"];
const READ_HEADS: [&str; 6] = ["force N", "approach m", "a m", "b m", "pressure Pa", "dF/dz N/m"];

impl Row {
    fn new(state: &HertzState) -> Self {
        Self {
            force: state.force,
            approach: state.approach,
            semi_axis_a: state.ellipse.semi_axis_a(),
            semi_axis_b: state.ellipse.semi_axis_b(),
            peak_pressure: state.peak_pressure,
            normal_stiffness: state.normal_stiffness,
        }
    }

    fn numbers(&self) -> [f64; 6] {
        [
            self.force,
            self.approach,
            self.semi_axis_a,
            self.semi_axis_b,
            self.peak_pressure,
            self.normal_stiffness,
        ]
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let case = read_case(&arguments.given.case, HertzCase::parse)?;
    let states = case
        .values
        .as_slice()
        .iter()
        .map(|value| loaded(&case.hertz, case.given, *value))
        .collect::<Result<Vec<_>, _>>()
        .map_err(|source| CliError::Law { path: arguments.given.case.clone(), source })?;
    let rows: Vec<Row> = states.iter().map(Row::new).collect();
    let cells = |number: fn(f64) -> String| -> Vec<Vec<String>> {
        rows.iter().map(|row| row.numbers().map(number).to_vec()).collect()
    };
    let text = match arguments.given.format {
        Format::Json => json(&report(&case.hertz, &rows))?,
        Format::Csv => csv(&HEADS, &cells(|value| value.to_string()))?,
        Format::Table => contact(&case.hertz) + &table(&READ_HEADS, &cells(short)),
    };
    let plot = match &arguments.plot {
        Some(path) => Some(PlotFile { path: path.clone(), svg: draw(&case.values, &states)? }),
        None => None,
    };
    Ok(Answer { text, warnings: Vec::new(), plot })
}

fn loaded(hertz: &Hertz, given: Given, value: f64) -> Result<HertzState, RangeError> {
    match given {
        Given::Force => hertz.at_force(value),
        Given::Approach => hertz.at_approach(value),
        Given::SemiAxisA => hertz.at_semi_axis_a(value),
        Given::SemiAxisB => hertz.at_semi_axis_b(value),
    }
}

fn report<'a>(hertz: &Hertz, loads: &'a [Row]) -> Report<'a> {
    let stiffness = hertz.stiffness();
    Report {
        axis_ratio: hertz.axis_ratio().get(),
        angle: hertz.curvature().angle().to_degrees(),
        c_x: stiffness.c_x,
        c_y: stiffness.c_y,
        c_z: stiffness.c_z,
        loads,
    }
}

fn contact(hertz: &Hertz) -> String {
    let Report { axis_ratio, angle, c_x, c_y, c_z, .. } = report(hertz, &[]);
    let rows = [
        ("axis ratio a/b", axis_ratio, ""),
        ("x axis from body 1's first direction", angle, "°"),
        ("c_x, force = c √approach shift", c_x, "N/m^1.5"),
        ("c_y", c_y, "N/m^1.5"),
        ("c_z", c_z, "N/m^1.5"),
    ];
    let rows = rows.map(|(name, value, unit)| vec![name.to_owned(), short(value), unit.to_owned()]);
    table(&["contact", "value", "unit"], &rows)
}

fn draw(values: &Numbers, states: &[HertzState]) -> Result<String, CliError> {
    let panels = match (values, states) {
        (Numbers::One(_), [state]) => vec![outline(state), pressure(state)],
        _ => {
            let by_approach = |y: &str, value: fn(&HertzState) -> f64| {
                let mut panel = Panel::new(Axis::linear("approach / m"), Axis::linear(y));
                panel.add(Series::line("", states.iter().map(|s| (s.approach, value(s)))));
                panel
            };
            vec![
                by_approach("force / N", |state| state.force),
                by_approach("peak pressure / Pa", |state| state.peak_pressure),
            ]
        }
    };
    Ok(render("Hertz contact", &panels)?)
}

fn outline(state: &HertzState) -> Panel {
    let (a, b) = (state.ellipse.semi_axis_a(), state.ellipse.semi_axis_b());
    let turn = linspace(0.0, std::f64::consts::TAU, 181);
    let points = turn.into_iter().map(|t| (a * libm::cos(t), b * libm::sin(t)));
    let mut panel = Panel::new(Axis::linear("x / m"), Axis::linear("y / m")).equal_aspect();
    panel.add(Series::area("", points));
    panel.titled("contact ellipse")
}

fn pressure(state: &HertzState) -> Panel {
    let (a, b) = (state.ellipse.semi_axis_a(), state.ellipse.semi_axis_b());
    let profile = |x: f64, y: f64| state.pressure(a * x, b * y);
    let grid = || linspace(-1.0, 1.0, 201).into_iter();
    let mut panel = Panel::new(Axis::linear("x, y / m"), Axis::linear("pressure / Pa"));
    panel.add(Series::line("along x", grid().map(|s| (a * s, profile(s, 0.0)))));
    panel.add(Series::dashed("along y", grid().map(|s| (b * s, profile(0.0, s)))));
    panel.titled("pressure")
}
