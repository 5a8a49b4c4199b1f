//! `carom stress`: stresses in a body below a contact under normal and tangential load.

mod field;

use crate::columns::{self, Fields, Record, Records};
use crate::command::case_arguments::{CaseArguments, Given};
use crate::command::plot::{Course, Value};
use crate::error::CliError;
use crate::output::{Answer, Format, Picture, json};
use carom_cases::stress::{self, Solved, StressPoint};
use carom_cases::theory::ValidityReport;
use carom_plot::{Field, Marker, Panel, PlotError, Series};
use carom_table::row;
use serde::Serialize;
use std::path::PathBuf;

use field::FieldFile;

/// Stresses below a contact with normal force (Hertz) and tangential force (Cattaneo and Mindlin).
///
/// The file is TOML. Numbers are in SI units; other units are given as texts such as "2.5 mm"; see
/// examples/stress_*.toml. x is the direction of the larger relative curvature, so that a <= b. The
/// tangential force was applied after the normal force: an outer annulus of the ellipse slips, all
/// of it at the limit. Stresses are exact for these tractions. The table gives the points of greatest
/// equivalent stress and of greatest shear stress, also between the points; CSV and JSON give every point. The picture shows the equivalent stress in a
/// plane, or all stresses along a line.
#[derive(Debug, clap::Args)]
#[command(after_long_help = columns::help("A row for each point", StressPoint::COLUMNS))]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) given: CaseArguments,

    /// Write the stresses at all points to this file: as NumPy arrays over depth, y and x, with the
    /// names of the columns below, if it ends in .npz; as a grid for ParaView if it ends in .vtk.
    #[arg(long, value_name = "FILE")]
    field: Option<PathBuf>,
}

/// All of a case: the contact and its points.
#[derive(Serialize)]
struct Report<'a> {
    contact: Fields<'a>,
    /// Radius of the stick area over that of the contact.
    stick_radius: f64,
    points: Records<'a, StressPoint>,
    /// The point of greatest equivalent stress, searched between the points too.
    greatest: Record<'a, StressPoint>,
    /// The point of greatest shear stress, searched likewise.
    greatest_shear: Record<'a, StressPoint>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let (Given { case: file, plot }, to) = arguments.given.read_beside(|outputs| {
        arguments.field.as_ref().map(|path| FieldFile::new(path, outputs)).transpose()
    })?;
    let solved = stress::solved(&file)?;
    let Solved { case, state, stick_radius, points, greatest, greatest_shear } = &solved;
    columns::check(StressPoint::COLUMNS, points)?;
    let format = arguments.given.format();
    let text = match format {
        Format::Json => json(&Report {
            contact: Fields(&state.cells()),
            stick_radius: *stick_radius,
            points: Records(StressPoint::COLUMNS, points),
            greatest: Record::new(StressPoint::COLUMNS, greatest),
            greatest_shear: Record::new(StressPoint::COLUMNS, greatest_shear),
        })?,
        Format::Table(page) => {
            columns::upright(page, &state.cells())
                + &format!("stick radius over that of the contact: {stick_radius:.6}\n")
                + "greatest equivalent stress, searched between the points too:\n"
                + &columns::upright(page, &row(StressPoint::COLUMNS, Some(greatest)))
                + "greatest shear stress, searched likewise:\n"
                + &columns::upright(page, &row(StressPoint::COLUMNS, Some(greatest_shear)))
        }
        Format::Csv | Format::Chosen(_) | Format::None => {
            columns::rows(format, StressPoint::COLUMNS, points)?
        }
    };
    let picture = match plot {
        Some(to) => Some((to, draw(&solved).map_err(CliError::from)?)),
        None => None,
    };
    let file = to.map(|to| to.encoded(case, points)).transpose()?;
    let mut report = ValidityReport::default();
    report.add(String::new, solved.validity());
    let (caution, warnings) = report.told("loads");
    let files = file.into_iter().collect();
    let answer = Answer { text, warnings, picture, files, ..Answer::default() };
    Ok(answer.cautioned(caution, format))
}

/// The stresses along a line.
const STRESSES: [(&str, Value<StressPoint>); 7] = [
    ("s_xx", |point| point.stress.xx),
    ("s_yy", |point| point.stress.yy),
    ("s_zz", |point| point.stress.zz),
    ("s_xy", |point| point.stress.xy),
    ("s_yz", |point| point.stress.yz),
    ("s_zx", |point| point.stress.zx),
    ("von Mises", |point| point.stress.von_mises()),
];

/// The equivalent stress over the plane of the points, or the stresses along their line.
fn draw(solved: &Solved) -> Result<Picture, PlotError> {
    let Solved { case, points, greatest, .. } = solved;
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
        let most = (greatest.at[across], place(up, greatest.at[up]));
        panel.add(Series::markers("greatest", Marker::Cross, [most]));
        return Ok(Picture::new(&title, [panel]));
    }
    let (label, at): (&str, Value<StressPoint>) = match (many.first(), case.is_in_body_1) {
        (Some(0), _) => (NAMES[0], |point| point.at[0]),
        (Some(1), _) => (NAMES[1], |point| point.at[1]),
        (_, true) => (NAMES[2], |point| point.at[2]),
        (_, false) => (NAMES[2], |point| -point.at[2]),
    };
    let course = Course { records: points, marked: &[], label, at };
    Ok(Picture::new(&title, [course.panel("", "stress / Pa", &STRESSES)]))
}
