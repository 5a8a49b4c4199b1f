//! Fig. 12.3: the program, drawn from what runs and held against a run.

use super::super::mesh::Mesh;
use super::super::structure;
use crate::{Absolute, Cell, Figure, FigureResult, Table};
use carom_classic::Block;
use carom_classic::jaeger::{GaussSeidel, PROGRAM, ProgramStep};
use carom_laws::law::Shift;
use carom_solver::{ContactState, Drive, Frictional, Method as _};

const FRICTION: f64 = 0.3;

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("run", "sphere, 10 × 10 elements, ν = 0 and 1/2, f = 0.3, three steps");
    figure.panel(structure::chart("The main part of the program", PROGRAM));

    let mesh = Mesh { poisson: [0.0, 0.5], friction: FRICTION, ..Mesh::of([1.1, 1.1], [10, 10]) };
    let problem = mesh.problem()?;
    let (method, today) = (GaussSeidel::default(), Frictional::default().within(1e-12)?);
    let (mut scratch, mut check) = (method.scratch(&problem)?, today.scratch(&problem)?);
    let mut state = ContactState::apart(problem.grid());
    let mut want = state.clone();
    let (mut pairs, mut walked, mut sweeps) = (Vec::new(), 0, Vec::new());
    let history = [(0.1, 0.0, 0.0), (0.1, 0.015, 0.01), (0.08, -0.005, 0.01)];
    for (zeta, xi, eta) in history {
        let drive = Drive::by_shift(Shift { zeta, xi, eta, omega: 0.0 });
        let before = state.clone();
        let went = method.step(&problem, &before, &drive, &mut state, &mut scratch, &mut ())?;
        today.step(&problem, &want.clone(), &drive, &mut want, &mut check, &mut ())?;
        let top = want.pressure.values().iter().copied().fold(0.0, f64::max);
        let fields = [
            (&state.pressure, &want.pressure),
            (&state.traction_x, &want.traction_x),
            (&state.traction_y, &want.traction_y),
        ];
        for (found, want) in fields {
            let both = found.values().iter().zip(want.values());
            pairs.extend(both.map(|(found, want)| (found / top, want / top)));
        }
        walked += usize::from(scratch.trace().follows(PROGRAM));
        let count = scratch.trace().count(ProgramStep::Sweep);
        sweeps.push((count as f64, went.iterations as f64));
    }
    let trace = scratch.trace();
    let mut table = Table::new("The last step of the run", ["module or question", "times"]);
    for (step, times, _) in structure::counts(trace) {
        table.row([Cell::from(step.to_string()), Cell::from(times as f64)]);
    }
    figure.table(table);

    figure
        .close(
            "every step of the run walks the chart as it is drawn",
            walked as f64,
            history.len() as f64,
            Absolute(0.0),
        )
        .source("the traces of the run, read by the chart as by a grammar");
    let [Block::Until { body, .. }] = PROGRAM else { return Err("one loop around all".into()) };
    figure
        .holds("without the outermost loop it does not fit", !trace.follows(body), 0.0)
        .source("the last part tests again and repeats all loops");
    figure
        .all_close("sweeps in the trace and iterations", sweeps, Absolute(0.0))
        .source("the method counts its own sweeps");
    let depth = [
        ProgramStep::TestAll,
        ProgramStep::DefineStickArea,
        ProgramStep::SlipAlgorithm,
        ProgramStep::TestContact,
        ProgramStep::Sweep,
    ];
    let counts = depth.map(|step| trace.count(step) as f64);
    let nested = counts.windows(2).all(|pair| pair[0] <= pair[1]);
    figure
        .holds("inner loops turn at least as often as outer ones", nested, counts[4])
        .source("every step of an outer loop repeats all inner loops (section 12.5)");
    figure
        .all_close("stresses over the largest pressure", pairs, Absolute(1e-8))
        .source("Newton's method on active sets, a method of today, on the same mesh");
    figure.deviation(
        "DefineStickArea, then Testsign; DefineConstants at the end",
        "Testsign first; no DefineConstants",
        "elements that have just been let slip have no slip yet whose sign could be tested; the \
         displacements of the stick area are those of the whole step",
    );
    figure.deviation(
        "an element with tension leaves the contact",
        "one that sticks slips first, and leaves if it still pulls",
        "with dissimilar materials the areas else change to and fro without end",
    );
    Ok(figure)
}
