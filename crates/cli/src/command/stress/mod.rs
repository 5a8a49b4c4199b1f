//! `carom stress`: stresses in a body below a contact under normal and tangential load.

mod field;
mod point;

use crate::columns::{self, Record};
use crate::command::hertz::smallest_radius;
use crate::command::theory::{Excess, caution, large_contact};
use crate::command::{self, CaseArguments};
use crate::error::CliError;
use crate::output::{Answer, Format, Picture, json};
use carom_cases::Error;
use carom_cases::case::StressCase;
use carom_halfspace::{Point, Stress, Traction};
use carom_laws::field::partial_slip_stress;
use carom_laws::hertz::HertzState;
use carom_plot::{Axis, Field, Panel, PlotError, Series};
use carom_special::RangeError;
use carom_table::{Value, row};
use rayon::prelude::*;
use serde::Serialize;
use std::path::PathBuf;

use field::FieldFile;
use point::StressPoint;

/// Stresses below a contact with normal force (Hertz) and tangential force (Cattaneo and Mindlin).
///
/// The file is TOML. Numbers are in SI units; other units are given as texts such as "2.5 mm"; see
/// examples/stress_*.toml. x is the direction of the larger relative curvature, so that a <= b. The
/// tangential force was applied after the normal force: an outer annulus of the ellipse slips, all
/// of it at the limit. Stresses are exact for these tractions. The table gives the point of maximum
/// equivalent stress; CSV and JSON give every point. The picture shows the equivalent stress in a
/// plane, or all stresses along a line.
#[derive(Debug, clap::Args)]
#[command(after_long_help = columns::help("A row for each point", StressPoint::COLUMNS))]
pub(super) struct Arguments {
    #[command(flatten)]
    given: CaseArguments,

    /// Write the stresses at all points to this file: as NumPy arrays over depth, y and x, with the
    /// names of the columns below, if it ends in .npz; as a grid for ParaView if it ends in .vtk.
    #[arg(long, value_name = "FILE")]
    field: Option<PathBuf>,
}

/// All of a case: the contact and its points.
#[derive(Serialize)]
struct Report<'a> {
    contact: Record<'a, HertzState>,
    /// Radius of the stick area over that of the contact.
    stick_radius: f64,
    points: Vec<Record<'a, StressPoint>>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let (command::Given { case: file, plot }, to) = arguments.given.read_beside(|outputs| {
        arguments.field.as_ref().map(|path| FieldFile::new(path, outputs)).transpose()
    })?;
    let case = file.parse(StressCase::parse)?;
    let failed = |source| Error::Law { path: file.path.clone(), source };
    let state = case.hertz.at_force(case.force[2]).map_err(failed)?;
    let stick_radius = stick_radius(&case);
    let points = stresses(&case, &state, stick_radius).map_err(failed)?;
    columns::check(&file.path, StressPoint::COLUMNS, &points)?;
    let format = arguments.given.format();
    let records = || points.iter().map(|point| Record::new(StressPoint::COLUMNS, point)).collect();
    let text = match format {
        Format::Json => json(&Report {
            contact: Record::new(HertzState::COLUMNS, &state),
            stick_radius,
            points: records(),
        })?,
        Format::Table(page) => {
            columns::upright(page, &row(HertzState::COLUMNS, Some(&state)))
                + &format!("stick radius over that of the contact: {stick_radius:.6}\n")
                + "maximum equivalent stress among the points:\n"
                + &columns::upright(page, &row(StressPoint::COLUMNS, greatest(&points)))
        }
        Format::Csv | Format::None => columns::rows(format, StressPoint::COLUMNS, &points)?,
    };
    let picture = match plot {
        Some(to) => Some((to, draw(&case, &points).map_err(CliError::from)?)),
        None => None,
    };
    let excess = Excess::of_contact(state.approach, smallest_radius(&case.hertz));
    let file = to.map(|to| to.encoded(&case, &points)).transpose()?;
    let semi_axis = state.ellipse.semi_axis_a().max(state.ellipse.semi_axis_b());
    let large = large_contact(semi_axis, case.smallest_radius);
    let warnings = large.iter().map(ToString::to_string).collect();
    let answer = Answer { text, warnings, picture, file, ..Answer::default() };
    Ok(answer.cautioned(caution(&[excess], "loads"), format))
}

/// a*/a of Cattaneo and Mindlin: (1 - F_t/(f F_z))^(1/3).
fn stick_radius(case: &StressCase) -> f64 {
    let [x, y, normal] = case.force;
    let pushed = libm::hypot(x, y);
    if pushed == 0.0 { 1.0 } else { libm::cbrt((1.0 - pushed / (case.friction * normal)).max(0.0)) }
}

/// The stresses at all points: for each depth, for each y, for each x.
fn stresses(
    case: &StressCase,
    state: &HertzState,
    stick_radius: f64,
) -> Result<Vec<StressPoint>, RangeError> {
    let [x, y, _] = case.force;
    let pushed = libm::hypot(x, y);
    let [unit_x, unit_y] = if pushed > 0.0 { [x / pushed, y / pushed] } else { [0.0; 2] };
    // Body 2 feels the opposite traction; seen from inside it, the normal points the other way.
    let (body, side) = match case.is_in_body_1 {
        true => (case.hertz.materials().body_1(), 1.0),
        false => (case.hertz.materials().body_2(), -1.0),
    };
    let limit = side * case.friction * state.peak_pressure;
    let peak = Traction { x: limit * unit_x, y: limit * unit_y, normal: state.peak_pressure };
    let [xs, ys, depths] = &case.places;
    let at = |i: usize| {
        let (column, rest) = (i % xs.len(), i / xs.len());
        let at = [xs[column], ys[rest % ys.len()], depths[rest / ys.len()]];
        let point = Point { x: at[0], y: at[1], z: at[2] };
        let s = partial_slip_stress(state.ellipse, body, peak, stick_radius, point)?;
        Ok(StressPoint { at, stress: Stress { yz: side * s.yz, zx: side * s.zx, ..s } })
    };
    (0..xs.len() * ys.len() * depths.len()).into_par_iter().map(at).collect()
}

fn greatest(points: &[StressPoint]) -> Option<&StressPoint> {
    points.iter().max_by(|one, two| one.stress.von_mises().total_cmp(&two.stress.von_mises()))
}

/// The equivalent stress over the plane of the points, or the stresses along their line.
fn draw(case: &StressCase, points: &[StressPoint]) -> Result<Picture, PlotError> {
    const NAMES: [&str; 3] = ["x / m", "y / m", "z / m"];
    // Body 2 lies below.
    let side = if case.is_in_body_1 { 1.0 } else { -1.0 };
    let place = |i: usize, at: f64| if i == 2 { side * at } else { at };
    let many: Vec<usize> = (0..3).filter(|i| case.places[*i].len() > 1).collect();
    let title = format!("Stress in {}", if case.is_in_body_1 { "body 1" } else { "body 2" });
    if let [across, up] = *many.as_slice() {
        let x = case.places[across].clone();
        let mut y: Vec<f64> = case.places[up].iter().map(|at| place(up, *at)).collect();
        let stress = |point: &StressPoint| point.stress.von_mises();
        let mut rows: Vec<Vec<f64>> =
            points.chunks(x.len()).map(|row| row.iter().map(stress).collect()).collect();
        if up == 2 && !case.is_in_body_1 {
            y.reverse();
            rows.reverse();
        }
        let field = Field::new("von Mises / Pa", x, y, rows.concat())?;
        let panel = Panel::new(NAMES[across], NAMES[up]).titled("equivalent stress");
        let mut panel = panel.equal_aspect().over(field);
        if let Some(point) = greatest(points) {
            panel.add(Series::markers(
                "",
                carom_plot::Marker::Cross,
                [(point.at[across], place(up, point.at[up]))],
            ));
        }
        return Ok(Picture::new(&title, [panel]));
    }
    let along = many.first().copied().unwrap_or(2);
    let mut panel = Panel::new(Axis::linear(NAMES[along]), Axis::linear("stress / Pa"));
    for column in &StressPoint::COLUMNS[3..10] {
        let line = points.iter().filter_map(|point| match column.value(point) {
            Value::Number(stress) => Some((place(along, point.at[along]), stress)),
            _ => None,
        });
        panel.add(Series::line(column.name().replace("von_mises", "von Mises"), line));
    }
    Ok(Picture::new(&title, [panel]))
}
