//! Figs 11.2 and 11.3: the processes NORM and TANG, drawn from the running code and compared with a run.

use super::super::mesh::Mesh;
use super::super::structure;
use crate::{Absolute, Cell, Failure, Figure, FigureResult, Relative, Table};
use carom_classic::kalker::{
    KalkerScratch, NORM, NormStep, Panagiotopoulos, ProcessStep, TANG, TangStep,
};
use carom_classic::{Block, Step, Trace};
use carom_laws::law::Shift;
use carom_solver::{CellState, ContactProblem, ContactState, Convergence, Drive, Method as _};

/// A step from rest: sphere on half-space, nu 0 and 1/2, pressed and shifted at once.
struct Run {
    problem: ContactProblem,
    state: ContactState,
    scratch: KalkerScratch,
    reached: Convergence,
}

const FRICTION: f64 = 0.4;
const SHIFT: Shift = Shift { zeta: 0.1, xi: 0.02, eta: 0.01, omega: 0.0 };

fn run() -> Result<Run, Failure> {
    let mesh = Mesh { poisson: [0.0, 0.5], friction: FRICTION, ..Mesh::of([1.1, 1.1], [10, 10]) };
    let problem = mesh.problem()?;
    let method = Panagiotopoulos::default();
    let mut scratch = method.scratch(&problem)?;
    let apart = ContactState::apart(problem.grid());
    let mut state = apart.clone();
    let drive = Drive::by_shift(SHIFT);
    let reached = method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
    Ok(Run { problem, state, scratch, reached })
}

fn inputs(figure: &mut Figure) {
    figure.assumed("run", "sphere, 10 × 10 elements, ν = 0 and 1/2, f = 0.4, one oblique step");
    figure.assumed("ζ, ξ, η", "0.1, 0.02, 0.01 mm");
}

/// The steps of a run as a table, and the claim that it follows the chart.
fn trace<S: Step>(
    figure: &mut Figure,
    name: &str,
    chart: &'static [Block<S>],
    traces: &[Trace<S>],
) {
    let mut table = Table::new(
        format!("The first {name} of the run"),
        ["step or question", "times", "sum of its amounts"],
    );
    for (step, times, amount) in structure::counts(&traces[0]) {
        let cells = [Cell::from(step.to_string()), Cell::from(times as f64)];
        table.row(cells.into_iter().chain([Cell::Remark(format!("{amount:.4}"))]));
    }
    figure.table(table);
    let all = traces.iter().filter(|trace| trace.follows(chart)).count();
    let statement = format!("every {name} of the run walks the chart as it is drawn");
    figure
        .close(statement, all as f64, traces.len() as f64, Absolute(0.0))
        .source("the trace of the run, read by the chart as by a grammar");
}

pub(super) fn norm() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    figure.panel(structure::chart("NORM: contact area K", NORM));
    let Run { problem, state, scratch, reached } = run()?;
    let traces = &scratch.traces().norm;
    trace(&mut figure, "NORM", NORM, traces);
    let [Block::Until { body, .. }] = NORM else { return Err("NORM is one loop".into()) };
    figure
        .holds("without its outer loop the chart fits no run", !traces[0].follows(body), 0.0)
        .source("loops are nested and not sequential (section 11.2)");
    let dropped: Vec<f64> = traces.iter().map(|trace| trace.total(NormStep::DropTension)).collect();
    figure
        .at_least("elements leave K in the first NORM", dropped[0], 1.0)
        .source("K starts as the undeformed overlap, twice the area of contact");
    let rounds = traces[0].entries().iter().filter(|entry| entry.step == NormStep::Solve);
    let before_growth = rounds.map(|entry| entry.amount).take(traces[0].count(NormStep::NoTension));
    let sizes: Vec<f64> = before_growth.take(2).collect();
    figure
        .decreasing("K first decreases", sizes)
        .source("“the contact area first decreases until it remains constant”");
    figure
        .at_most("dᵢ = 0 in K, dᵢ ≥ 0 outside, over ζ", reached.residuals.normal, 1e-10)
        .source("(12.3), (12.6)");
    let lowest = state.pressure.values().iter().copied().fold(f64::INFINITY, f64::min);
    figure.at_least("no pᵢ < 0", lowest, 0.0).source("(12.3)");
    let touching = problem.grid().cells() - state.count(CellState::Exterior);
    let passes = scratch.traces().process.count(ProcessStep::Norm);
    figure.derived("elements in contact, passes of NORM", format!("{touching}, {passes}"));
    Ok(figure)
}

pub(super) fn tang() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    figure.panel(structure::chart("TANG: stick area A", TANG));
    let Run { problem, state, scratch, reached } = run()?;
    let traces = &scratch.traces().tang;
    trace(&mut figure, "TANG", TANG, traces);
    figure.deviation(
        "“the arrangement of the loops is sequential again”",
        "nested, as in NORM, with a third loop inside for the nonlinear equations",
        "section 11.2 calls the loops of NORM nested and not sequential; the thesis itself asks for \
         the third loop",
    );
    let [Block::Until { body, .. }] = TANG else { return Err("TANG is one loop".into()) };
    let two = Block::Until { body: &[Block::Do(TangStep::Solve)], done: TangStep::NoneTooLarge };
    let wrong = traces[0].follows(body) || traces[0].follows(&[two]);
    figure.holds("no chart of fewer loops fits", !wrong, 0.0).source("the trace of the run");
    figure
        .at_least("the third loop is needed: systems per set", per_set(&traces[0]), 1.5)
        .source("section 11.3: the Newton-Raphson formula converges only for small corrections");
    let mut law = Vec::new();
    for i in 0..problem.grid().cells() {
        let t = state.traction_x.values()[i].hypot(state.traction_y.values()[i]);
        if state.cells.values()[i] == CellState::Slip {
            law.push((t, FRICTION * state.pressure.values()[i]));
        }
    }
    figure.all_close("|σₜ| = f σₙ where it slips", law, Relative(1e-12)).source("Coulomb (12.4)");
    figure
        .at_most("what is left of (12.4), over f p", reached.residuals.tangential, 1e-10)
        .source("s = 0 in A, s against σₜ elsewhere");
    Ok(figure)
}

/// Linear systems solved for each stick area tried.
fn per_set(trace: &Trace<TangStep>) -> f64 {
    trace.count(TangStep::Solve) as f64 / trace.count(TangStep::LetSlip) as f64
}
