//! `carom compare`: one case by all methods.

use std::path::Path;
use std::time::{Duration, Instant};

use super::follow::Run;
use super::heights;
use super::store::Found;
use crate::case::{GapCase, SolveCase};
use crate::error::CliError;
use crate::input::CaseFile;
use crate::output::{Answer, Format, csv, json, short, table};
use carom_laws::law::Shift;
use carom_solver::jaeger::{DiscGaussSeidel, GaussSeidel};
use carom_solver::kalker::{Johnson, Kombi, Panagiotopoulos};
use carom_solver::{CellState, ContactProblem, ContactState, Drive, Frictional, Method};
use serde::Serialize;
use std::path::PathBuf;

/// Most cells in contact for the methods that sweep, for those with dense matrices, and for KOMBI:
/// more would take minutes a step.
const MOST: [usize; 3] = [2000, 500, 150];

/// One case by all methods: those of 1992 and before beside that of today.
///
/// The file is one for `carom solve`. Loads, if there are any, are replaced by the shifts that they
/// lead to, as the older methods take no others. The difference is the largest one of a traction or
/// pressure at the end, over the largest pressure.
#[derive(Debug, clap::Args)]
pub(in crate::command) struct Arguments {
    /// The case file.
    #[arg(value_name = "CASE.toml")]
    case: PathBuf,
    /// Format of the results.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// How a method did.
#[derive(Debug, Serialize)]
struct Row {
    method: &'static str,
    /// Iterations, sweeps or linear systems of all steps.
    iterations: Option<usize>,
    /// Products with blocks of the influence.
    products: Option<f64>,
    seconds: Option<f64>,
    difference: Option<f64>,
    /// Why it gave none.
    note: String,
}

/// A history of shifts, to be followed by any method.
struct Course<'a> {
    problem: &'a ContactProblem,
    shifts: Vec<Shift>,
    want: ContactState,
    touching: usize,
}

struct Went {
    state: ContactState,
    iterations: usize,
    products: f64,
    time: Duration,
}

impl Course<'_> {
    fn follow<M: Method>(&self, method: &M) -> Result<Went, M::Error> {
        let mut scratch = method.scratch(self.problem)?;
        let mut before = ContactState::apart(self.problem.grid());
        let mut state = before.clone();
        let (mut iterations, mut products, start) = (0, 0.0, Instant::now());
        for shift in &self.shifts {
            let drive = Drive::by_shift(*shift);
            let went =
                method.step(self.problem, &before, &drive, &mut state, &mut scratch, &mut ())?;
            iterations += went.iterations;
            products += went.products.normal + went.products.tangential + went.products.coupling;
            before.clone_from(&state);
        }
        Ok(Went { state, iterations, products, time: start.elapsed() })
    }

    fn row<M: Method>(&self, name: &'static str, most: usize, method: &M) -> Row {
        let none = |note| Row {
            method: name,
            iterations: None,
            products: None,
            seconds: None,
            difference: None,
            note,
        };
        if self.touching > most {
            return none(format!("left out: {} cells touch, at most {most}", self.touching));
        }
        match self.follow(method) {
            Ok(went) => Row {
                iterations: Some(went.iterations),
                products: (went.products > 0.0).then_some(went.products),
                seconds: Some(went.time.as_secs_f64()),
                difference: Some(difference(&self.want, &went.state)),
                ..none(String::new())
            },
            Err(error) => none(error.to_string()),
        }
    }
}

/// The largest difference of a traction or pressure over the largest pressure.
fn difference(a: &ContactState, b: &ContactState) -> f64 {
    let pairs = [
        (&a.pressure, &b.pressure),
        (&a.traction_x, &b.traction_x),
        (&a.traction_y, &b.traction_y),
    ];
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    let differences = pairs
        .into_iter()
        .flat_map(|(a, b)| a.values().iter().zip(b.values()).map(|(a, b)| (a - b).abs()));
    differences.fold(0.0, f64::max) / largest(a.pressure.values()).max(f64::MIN_POSITIVE)
}

pub(in crate::command) fn run(arguments: &Arguments) -> Result<Answer, CliError> {
    let file = CaseFile::read(&arguments.case)?;
    let case = file.parse(SolveCase::parse)?;
    let gap = match &case.gap {
        GapCase::Formula(gap) => gap.clone(),
        GapCase::Heights(map) => {
            let name = file.path.parent().unwrap_or(Path::new("")).join(&map.file);
            heights::read(&name, map, case.grid)?.0
        }
    };
    let run = Run::new(&file.path, &case, gap)?;
    let (problem, method) = (run.problem().clone(), run.method());
    let nothing = Found { steps: Vec::new(), state: ContactState::apart(case.grid) };
    let followed = run.follow(nothing, None)?;
    let shifts = followed.steps.iter().map(|step| step.shift).collect();
    let touching = case.grid.cells() - followed.state.count(CellState::Exterior);
    let path = Course { problem: &problem, shifts, want: followed.state, touching };
    let rows = rows(&path, &method);
    let format = arguments.format;
    let text = match format {
        Format::None => String::new(),
        Format::Json => json(&rows)?,
        Format::Csv => csv(&HEADS, &cells(&rows, |value| value.to_string()))?,
        Format::Table => table(&HEADS, &cells(&rows, short)),
    };
    Ok(Answer { text, ..Answer::default() })
}

fn rows(path: &Course<'_>, today: &Frictional) -> Vec<Row> {
    let [sweeps, dense, combined] = MOST;
    vec![
        path.row("Newton on active sets, today", usize::MAX, today),
        path.row("Jaeger: Gauss-Seidel", sweeps, &GaussSeidel::default()),
        path.row("Gauss-Seidel on discs", sweeps, &DiscGaussSeidel::default()),
        path.row("Johnson", dense, &Johnson::default()),
        path.row("Panagiotopoulos", dense, &Panagiotopoulos::default()),
        path.row("KOMBI", combined, &Kombi::default()),
    ]
}

const HEADS: [&str; 6] = ["method", "iterations", "products", "seconds", "difference", "note"];

fn cells(rows: &[Row], number: impl Fn(f64) -> String) -> Vec<Vec<String>> {
    let shown = |value: Option<f64>| value.map_or_else(String::new, &number);
    let row = |row: &Row| {
        vec![
            row.method.to_owned(),
            row.iterations.map_or_else(String::new, |count| count.to_string()),
            shown(row.products),
            shown(row.seconds),
            shown(row.difference),
            row.note.clone(),
        ]
    };
    rows.iter().map(row).collect()
}
