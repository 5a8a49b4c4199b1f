//! `carom compare`: one case solved by all methods.

use std::time::{Duration, Instant};

use super::follow;
use crate::columns::{self, Records};
use crate::error::CliError;
use crate::format::Printing;
use crate::global_options::Messages;
use crate::output::{Answer, Format, json};
use crate::outputs::Outputs;
use crate::progress::Progress;
use carom_cases::case::{SolveCase, SolveMethod};
use carom_cases::solve::{Bodies, Found, Run};
use carom_classic::jaeger::{DiscGaussSeidel, GaussSeidel};
use carom_classic::kalker::{Johnson, Kombi, Panagiotopoulos};
use carom_laws::law::Shift;
use carom_solver::{CellState, ContactProblem, ContactState, Drive, Frictional, Method};
use carom_table::{Column, Value};
use std::path::PathBuf;

/// Largest number of cells in contact for sweeping methods, for those with dense matrices, and for
/// KOMBI: more would take minutes per step.
const MAX_CELLS_IN_CONTACT: [usize; 3] = [2000, 500, 150];

/// Solve one case by all methods: those of 1992 and earlier, and the present one.
///
/// The file is one for `carom solve`. Loads are replaced by the shifts that result from them, since
/// the older methods accept shifts only. The difference is the largest difference of a traction or
/// pressure at the end, over the largest pressure.
#[derive(Debug, clap::Args)]
#[command(after_long_help = columns::help("A row for each method", COLUMNS))]
pub(in crate::command) struct Arguments {
    /// The case file; - is standard input.
    #[arg(value_name = "CASE.toml")]
    pub(in crate::command) case: PathBuf,
    #[command(flatten)]
    printing: Printing,
}

/// The result of a method.
#[derive(Debug)]
struct Row {
    method: &'static str,
    went: Option<Went>,
    /// Difference from the present method.
    difference: Option<f64>,
    /// Why there is no result.
    note: String,
}

const COLUMNS: &[Column<Row>] = &[
    Column::text("method", "", "its name", |row| row.method.into()),
    Column::count("iterations", "", "sweeps or linear systems of all steps", |row| {
        row.of(|went| Some(Value::Count(went.iterations as u64)))
    }),
    Column::new("products", "", "products with blocks of the influence matrix", |row| {
        row.of(|went| Some(went.products.into()).filter(|_| went.products > 0.0))
    }),
    Column::new("seconds", "s", "all steps", |row| {
        row.of(|went| Some(went.time.as_secs_f64().into()))
    }),
    Column::new(
        "difference",
        "",
        "largest difference of a traction or pressure, over the largest pressure",
        |row| row.difference.map_or(Value::Undefined, Value::Number),
    ),
    Column::text("note", "", "why there is no result", |row| row.note.clone().into()),
];

impl Row {
    fn of(&self, value: impl Fn(&Went) -> Option<Value>) -> Value {
        self.went.as_ref().and_then(value).unwrap_or(Value::Undefined)
    }
}

/// A history of shifts that every method can solve.
struct Course<'a> {
    problem: &'a ContactProblem,
    shifts: Vec<Shift>,
    want: ContactState,
    touching: usize,
}

#[derive(Debug)]
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
        let none = |note| Row { method: name, went: None, difference: None, note };
        if self.touching > most {
            return none(format!("not run: {} cells in contact, at most {most}", self.touching));
        }
        match self.follow(method) {
            Ok(went) => {
                let difference = Some(difference(&self.want, &went.state));
                Row { method: name, went: Some(went), difference, note: String::new() }
            }
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

pub(in crate::command) fn run(
    arguments: &Arguments,
    messages: &Messages,
) -> Result<Answer, CliError> {
    arguments.printing.check()?;
    let outputs = Outputs::of_command(arguments.printing.format())?;
    let file = outputs.read_case(&arguments.case)?;
    // The method that the case requests is one of those compared.
    let case = SolveCase { method: SolveMethod::Newton, ..file.parse::<SolveCase>()? };
    super::only_half_spaces(&case, "the comparison of methods")?;
    let bodies = Bodies::of(&file, &case)?;
    let run = Run::new(&case, &bodies)?;
    let (problem, method) = (run.problem().clone(), run.method());
    let followed = follow(run, Found::default(), None, messages)?;
    let shifts = followed.steps.iter().map(|step| step.shift).collect();
    let touching = problem.grid().cells() - followed.state.count(CellState::Exterior);
    let path = Course { problem: &problem, shifts, want: followed.state, touching };
    let rows = rows(&path, &method, *messages);
    let format = arguments.printing.format();
    let text = match format {
        Format::Json => json(&Records(COLUMNS, &rows))?,
        format => columns::rows(format, COLUMNS, &rows)?,
    };
    Ok(Answer { text, ..Answer::default() })
}

fn rows(path: &Course<'_>, main: &Frictional, messages: Messages) -> Vec<Row> {
    let [sweeps, dense, combined] = MAX_CELLS_IN_CONTACT;
    let (gauss, discs) = (GaussSeidel::default(), DiscGaussSeidel::default());
    let (johnson, kalker) = (Johnson::default(), Panagiotopoulos::default());
    let kombi = Kombi::default();
    type Task<'a> = (&'static str, Box<dyn Fn(&'static str) -> Row + 'a>);
    let tasks: [Task<'_>; 6] = [
        (
            "Newton on active sets (present method)",
            Box::new(|name| path.row(name, usize::MAX, main)),
        ),
        ("Jaeger: Gauss-Seidel", Box::new(|name| path.row(name, sweeps, &gauss))),
        ("Gauss-Seidel on discs", Box::new(|name| path.row(name, sweeps, &discs))),
        ("Johnson", Box::new(|name| path.row(name, dense, &johnson))),
        ("Panagiotopoulos", Box::new(|name| path.row(name, dense, &kalker))),
        ("KOMBI", Box::new(|name| path.row(name, combined, &kombi))),
    ];
    let progress = Progress::new(messages, tasks.len(), "methods");
    let solve = |(name, solve): &Task<'_>| {
        progress.now(name);
        let row = solve(name);
        progress.inc(1);
        row
    };
    tasks.iter().map(solve).collect()
}
