//! `carom hertz`: the contact of two surfaces under normal load.

use crate::columns::{self, Fields, add_fields};
use crate::command::case_arguments::{CaseArguments, Given};
use crate::command::plot::{Course, MOST_MARKS};
use crate::error::CliError;
use crate::output::{Answer, Format, Picture, json};
use carom_cases::case::{Given as Load, HertzCase, Numbers};
use carom_cases::hertz::{self, Followed};
use carom_cases::{Error, Pressed};
use carom_laws::hertz::HertzState;
use carom_laws::line::LineState;
use carom_laws::validity::Validity;
use carom_plot::{Axis, Panel, Series};
use carom_special::RangeError;
use carom_special::linspace;
use carom_table::Cell;
use serde::Serialize;
use serde::ser::SerializeMap as _;
use std::f64::consts::PI;

/// Hertz contact of two surfaces: ellipse, approach, pressure and stiffness.
///
/// The file is TOML. Numbers are in SI units; other units are given as texts such as "2.5 mm"; see
/// examples/hertz_*.toml. x is the direction of the larger relative curvature, so that a <= b.
/// Cylinders with parallel axes touch along a line of `contact.length`. The picture shows the pressure, or force and pressure over the approach for several loads.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) given: CaseArguments,
}

/// What the rows hold.
fn help() -> String {
    let point = columns::help("A row for each load", HertzState::COLUMNS);
    point + &columns::help("Of a line", LineState::COLUMNS)
}

/// A contact under load, in SI units.
#[derive(Debug, Serialize)]
struct Row<'a> {
    #[serde(flatten)]
    state: &'a Fields<'a>,
    /// The limits of the theory that it exceeds.
    outside_theory: Vec<String>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let Given { case: file, plot } = arguments.given.read()?;
    let followed = hertz::followed(&file)?;
    let (Followed { case, states }, validities) = (&followed, followed.validities());
    columns::check_rows(states, [0, states.len()], Pressed::cells)?;
    let format = arguments.given.format();
    let cells = followed.cells();
    let loads = columns::cell_rows(format, &cells)?;
    let contact = case.contact.cells();
    let text = match format {
        Format::Json => {
            let fields: Vec<Fields<'_>> = cells.iter().map(|cells| Fields(cells)).collect();
            let record = |(state, validity): (_, &Validity)| Row {
                state,
                outside_theory: validity.reasons(),
            };
            let rows: Vec<Row<'_>> = fields.iter().zip(&validities).map(record).collect();
            json(&Report { contact: &contact, loads: &rows })?
        }
        Format::Table(page) => columns::upright(page, &contact) + &loads,
        Format::Csv | Format::Chosen(_) | Format::None => loads,
    };
    let picture = match plot {
        Some(to) => Some((to, draw(case, states).map_err(Error::from)?)),
        None => None,
    };
    let (caution, warnings) = followed.validity_report().told("loads");
    let answer = Answer { text, warnings, picture, ..Answer::default() };
    Ok(answer.cautioned(caution, format))
}

/// The complete result of a case: the contact and its loads.
struct Report<'a> {
    contact: &'a [Cell],
    loads: &'a [Row<'a>],
}

impl Serialize for Report<'_> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        add_fields(&mut map, self.contact)?;
        map.serialize_entry("loads", self.loads)?;
        map.end()
    }
}

/// The ellipse and pressure of one load; for several, force and pressure from zero to the largest
/// load, with the given loads marked.
fn draw(case: &HertzCase, states: &[Pressed]) -> Result<Picture, RangeError> {
    if let (Numbers::One(_), [state]) = (&case.values, states) {
        return Ok(Picture::new("Hertz contact", panels(state)));
    }
    let greatest = states.iter().map(Pressed::approach).fold(0.0, f64::max);
    // Denser where the pressure grows as a square root.
    let parts = linspace(0.0, 1.0, 201).into_iter().skip(1);
    let curve = parts
        .map(|part| case.contact.at(Load::Approach, greatest * part * part))
        .collect::<Result<Vec<_>, _>>()?;
    let points = |states: &[Pressed]| -> Vec<[f64; 3]> {
        states
            .iter()
            .map(|state| [state.approach(), state.force(), state.peak_pressure()])
            .collect()
    };
    let curve = [vec![[0.0; 3]], points(&curve)].concat();
    let marked = points(states);
    let course =
        Course { records: &curve, marked: &marked, label: "approach / m", at: |point| point[0] };
    let panels = [
        course.panel("", "force / N", &[("", |point| point[1])]),
        course.panel("", "peak pressure / Pa", &[("", |point| point[2])]),
    ];
    let marks = if marked.len() <= MOST_MARKS { " (dots: the loads given)" } else { "" };
    Ok(Picture::new(&format!("Hertz contact{marks}"), panels))
}

/// The outline and the pressure of an ellipse, the pressure across a line.
fn panels(state: &Pressed) -> Vec<Panel> {
    match state {
        Pressed::Point(state) => vec![outline(state), pressure(state)],
        Pressed::Line(state) => vec![across(state)],
    }
}

fn across(state: &LineState) -> Panel {
    // Denser at the edge, where the pressure vanishes as a square root.
    let places = linspace(-0.5 * PI, 0.5 * PI, 201).into_iter().map(libm::sin);
    let points = places.map(|s| (s * state.half_width, state.pressure(s * state.half_width)));
    let mut panel = Panel::new(Axis::linear("x / m"), Axis::linear("pressure / Pa"));
    panel.add(Series::line("", points.collect::<Vec<_>>()));
    panel.titled("pressure across the line")
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
    // Denser at the edge, where the pressure vanishes as a square root.
    let grid = || linspace(-0.5 * PI, 0.5 * PI, 201).into_iter().map(libm::sin);
    let mut panel = Panel::new(Axis::linear("x, y / m"), Axis::linear("pressure / Pa"));
    panel.add(Series::line("along x", grid().map(|s| (a * s, profile(s, 0.0)))));
    panel.add(Series::dashed("along y", grid().map(|s| (b * s, profile(0.0, s)))));
    panel.titled("pressure")
}
