//! `carom shell`: a bellows under pressure and axial load, or a flange under forces around it.

mod plot;

use crate::columns::{self, Record, Records};
use crate::command::case_arguments::{CaseArguments, Given};
use crate::error::CliError;
use crate::output::{Answer, Format, json};
use carom_cases::shell::{
    BellowsRow, FlangeSummary, FollowedBellows, RESPONSE_COLUMNS, Response, RingPlace, Solved,
    SolvedFlange, WALL_COLUMNS, solved,
};
use carom_shells::bellows::WallPoint;
use carom_table::row;
use serde::Serialize;

/// A bellows under pressure and axial load, or a flange under forces around it.
///
/// The file is TOML. Numbers are in SI units; other units are given as texts such as "2.5 mm"; see
/// examples/shell_*.toml. A bellows has large rotations; it is followed from load to load, and a
/// limit point on the way is named. A flange is a ring of variable stiffness, alone or at the end of
/// a tube, under small displacements. The picture shows the deformed shape, what it carries, and the
/// force of a bellows over its elongation.
#[derive(Debug, clap::Args)]
#[command(after_long_help = help())]
pub(super) struct Arguments {
    #[command(flatten)]
    pub(super) given: CaseArguments,
    /// Give displacements and stresses at the places of the wall instead of the rows: around a
    /// flange, from crest to root of a corrugation after the last load.
    #[arg(long)]
    places: bool,
}

fn help() -> String {
    [
        columns::help("A bellows has a row for each load", BellowsRow::COLUMNS),
        columns::help("Its response to small loads, in tables and JSON", RESPONSE_COLUMNS),
        columns::help("With --places, and in JSON", WALL_COLUMNS),
        columns::help("A flange has one row", FlangeSummary::COLUMNS),
        columns::help("With --places, and in JSON", RingPlace::COLUMNS),
    ]
    .join("\n")
}

pub(super) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let Given { case: file, plot } = arguments.given.read()?;
    let solved = solved(&file)?;
    let format = arguments.given.format();
    let (text, picture) = match &solved {
        Solved::Bellows(bellows) => {
            columns::check(RESPONSE_COLUMNS, std::slice::from_ref(&bellows.response))?;
            columns::check(BellowsRow::COLUMNS, &bellows.rows)?;
            (of_bellows(arguments, format, bellows)?, plot::bellows(bellows))
        }
        Solved::Flange(flange) => {
            columns::check(RingPlace::COLUMNS, &flange.places)?;
            (of_flange(arguments, format, flange)?, plot::flange(flange))
        }
    };
    let picture = plot.map(|to| (to, picture));
    Ok(Answer { text, picture, warnings: solved.warnings(), ..Answer::default() })
}

/// The complete result of a bellows.
#[derive(Serialize)]
struct BellowsReport<'a> {
    #[serde(flatten)]
    response: Record<'a, Response>,
    loads: Records<'a, BellowsRow>,
    places: Records<'a, WallPoint>,
}

/// The complete result of a flange.
#[derive(Serialize)]
struct FlangeReport<'a> {
    #[serde(flatten)]
    summary: Record<'a, FlangeSummary>,
    places: Records<'a, RingPlace>,
}

fn of_bellows(
    arguments: &Arguments,
    format: Format,
    bellows: &FollowedBellows,
) -> Result<String, CliError> {
    let FollowedBellows { response, rows, .. } = bellows;
    let places = rows.last().map_or(&[][..], |row| row.state.profile());
    match format {
        Format::Json => json(&BellowsReport {
            response: Record::new(RESPONSE_COLUMNS, response),
            loads: Records(BellowsRow::COLUMNS, rows),
            places: Records(WALL_COLUMNS, places),
        }),
        _ if arguments.places => columns::rows(format, WALL_COLUMNS, places),
        Format::Table(page) => {
            let head = columns::upright(page, &row(RESPONSE_COLUMNS, Some(response)));
            Ok(head + &columns::rows(format, BellowsRow::COLUMNS, rows)?)
        }
        Format::Csv | Format::Chosen(_) | Format::None => {
            columns::rows(format, BellowsRow::COLUMNS, rows)
        }
    }
}

fn of_flange(
    arguments: &Arguments,
    format: Format,
    flange: &SolvedFlange,
) -> Result<String, CliError> {
    let SolvedFlange { summary, places, .. } = flange;
    let rows = std::slice::from_ref(summary);
    columns::check(FlangeSummary::COLUMNS, rows)?;
    match format {
        Format::Json => json(&FlangeReport {
            summary: Record::new(FlangeSummary::COLUMNS, summary),
            places: Records(RingPlace::COLUMNS, places),
        }),
        _ if arguments.places => columns::rows(format, RingPlace::COLUMNS, places),
        Format::Table(page) => {
            Ok(columns::upright(page, &row(FlangeSummary::COLUMNS, Some(summary))))
        }
        Format::Csv | Format::Chosen(_) | Format::None => {
            columns::rows(format, FlangeSummary::COLUMNS, rows)
        }
    }
}
