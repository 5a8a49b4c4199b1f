//! CONTACT's example of a ball that begins to roll by a given force: from Cattaneo's shift to steady rolling.

use std::sync::Arc;

use carom_halfspace::operator::{
    DisplacementField, RolledOperator, SurfaceOperator as _, Threads, TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{Creepage, RollingContact, RollingDrive, SteadyContact, SteadyRolling, Way};
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method as _,
    StoredEnergy,
};

use super::super::printed::{Compared, SOURCE, all_digits, beside, off_cell};
use super::printed::places;
use crate::reference::rows;
use crate::{Absolute, Cell, Failure, Figure, FigureResult, Marker, Panel, Series, Table};

const CELLS: usize = 33;
/// The width of a cell, and the length of a step.
const WIDTH: f64 = 0.25;
const CURVATURE: f64 = 0.002_963;
const FRICTION: f64 = 0.4013;
const NORMAL: f64 = 0.4705;
/// The force along over the friction limit.
const PART: f64 = -0.657;
/// Of so many steps one stands in the table.
const THINNED: usize = 8;
/// Where all values are within this part of the limit, a cell at the border of stick and slip may be either.
const TOLERANCE: f64 = 1e-11;

/// A step, with the values that the example prints.
struct Step {
    creepage: f64,
    state: ContactState,
    energy: f64,
    power: f64,
}

fn problem() -> Result<ContactProblem, Failure> {
    let grid = Grid::new(CELLS, CELLS, WIDTH, WIDTH)?;
    let body = Material::from_shear(1.0, 0.28)?;
    let gap = Gap::from_function(grid, |x, y| CURVATURE * (x * x + y * y))?;
    let friction = Friction::new(FRICTION)?;
    Ok(ContactProblem::of_half_spaces(gap, MaterialPair::new(body, body)?, friction)?)
}

/// In J, of a state in N and mm.
fn energy(problem: &ContactProblem, state: &ContactState) -> Result<f64, Failure> {
    Ok(1e-3 * StoredEnergy::of(problem, state)?.total())
}

/// The ball pressed, then shifted without rolling.
fn shifted(problem: &ContactProblem) -> Result<ContactState, Failure> {
    let method = Frictional::default().within(TOLERANCE)?;
    let mut scratch = method.scratch(problem)?;
    let mut state = ContactState::apart(problem.grid());
    let pressed = Drive { normal: Driven::Load(NORMAL), ..Drive::default() };
    let pushed = Drive { x: Driven::Load(PART * FRICTION * NORMAL), ..pressed };
    for drive in [pressed, pushed] {
        let before = state.clone();
        method.step(problem, &before, &drive, &mut state, &mut scratch, &mut ())?;
    }
    Ok(state)
}

/// The work of the tractions on the slips of a step over its length: at 1 m/s the power in W of lengths in mm.
fn power(problem: &ContactProblem, from: &ContactState, to: &ContactState) -> Result<f64, Failure> {
    let ahead = RolledOperator::new(
        Arc::clone(problem.shared_operator()),
        Way::new(WIDTH)?.ahead(),
        Threads::One,
    )?;
    let cells = problem.grid().cells();
    let [mut u, mut v] = [vec![0.0; cells], vec![0.0; cells]];
    ahead.apply(
        TractionField::full(
            from.traction_x.values(),
            from.traction_y.values(),
            from.pressure.values(),
        ),
        DisplacementField::tangential(&mut u, &mut v),
        &mut ahead.workspace(),
    )?;
    // From ahead comes what a cell had, less the change on the way.
    let part = |now: &[f64], before: &[f64], change: &[f64], shift: f64, traction: &[f64]| -> f64 {
        (0..cells).map(|i| traction[i] * (now[i] - before[i] + change[i] - shift)).sum()
    };
    let [xi, eta] = [to.shift.xi - from.shift.xi, to.shift.eta - from.shift.eta];
    let along = part(
        to.displacement_x.values(),
        from.displacement_x.values(),
        &u,
        xi,
        to.traction_x.values(),
    );
    let across = part(
        to.displacement_y.values(),
        from.displacement_y.values(),
        &v,
        eta,
        to.traction_y.values(),
    );
    Ok(problem.grid().cell_area() * (along + across) / WIDTH)
}

fn drive() -> RollingDrive {
    RollingDrive {
        along: Driven::Load(PART * FRICTION * NORMAL),
        ..RollingDrive::by_creepage(Driven::Load(NORMAL), Creepage::default())
    }
}

fn rolled(
    problem: &ContactProblem,
    start: &ContactState,
    count: usize,
) -> Result<Vec<Step>, Failure> {
    let mut contact = RollingContact::new(problem, Way::new(WIDTH)?)?.within(TOLERANCE)?;
    let (mut from, mut steps) = (start.clone(), Vec::new());
    for _ in 0..count {
        let mut state = from.clone();
        contact.step(&drive(), &from, &mut state, &mut ())?;
        steps.push(Step {
            creepage: (state.shift.xi - from.shift.xi) / WIDTH,
            energy: energy(problem, &state)?,
            power: power(problem, &from, &state)?,
            state: state.clone(),
        });
        from = state;
    }
    Ok(steps)
}

/// The creepage over the way that the ball has rolled.
fn curve(steps: &[Step], printed: &[[f64; 5]], steady: &SteadyRolling) -> Panel {
    let way = |k: usize| (k + 1) as f64 * WIDTH;
    let mut panel =
        Panel::new("way rolled in mm", "ξ in 10⁻³").titled("the creepage that the force takes");
    let dots = printed.iter().enumerate().map(|(k, row)| (way(k), 1e3 * row[1]));
    panel.add(Series::markers("CONTACT", Marker::Circle, dots.collect::<Vec<_>>()).coloured(1));
    let own = steps.iter().enumerate().map(|(k, step)| (way(k), -1e3 * step.creepage));
    panel.add(Series::line("carom", own.collect::<Vec<_>>()).coloured(0));
    let level = -1e3 * steady.creepage.along;
    panel.add(Series::dotted("steady", vec![(0.0, level), (way(steps.len()), level)]).coloured(2));
    panel
}

/// Every eighth step.
fn table(steps: &[Step], printed: &[[f64; 5]]) -> Table {
    let heads = [
        "step",
        "ξ of CONTACT",
        "ξ of carom",
        "off, units of the 4th digit",
        "stick, CONTACT",
        "stick, carom",
    ];
    let mut table = Table::new("From step to step", heads);
    for (step, row) in steps.iter().zip(printed).step_by(THINNED) {
        let own = -step.creepage;
        let sticking = step.state.count(CellState::Stick) as f64;
        let [case, creepage, stick, ..] = *row;
        let off = off_cell(own, creepage);
        table.row(vec![
            Cell::from(case - 1.0),
            creepage.into(),
            own.into(),
            off,
            stick.into(),
            sticking.into(),
        ]);
    }
    table
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated(
        "bodies",
        "G = 1 N/mm², ν = 0.28; f = 0.4013; gap 0.002963 (x² + y²), 33 × 33 cells of 0.25 mm",
    );
    figure.stated("forces", "F_z = 0.4705 N, F_x = −0.657 f F_z, from the first shift on");
    figure.stated("way", "56 steps of 0.25 mm, two diameters of the contact; power at 1 m/s");
    figure.stated("signs", "as printed: body 1 against body 2");
    let problem = problem()?;
    let start = shifted(&problem)?;
    let printed: Vec<[f64; 5]> = rows(include_str!("../../../data/rolling/onset_printed.csv"))?;
    let steps = rolled(&problem, &start, printed.len())?;
    let steady = SteadyContact::new(&problem, Way::new(WIDTH)?)?.roll(&drive(), &mut ())?;
    let last = steps.last().ok_or("no step")?;
    figure.panel(curve(&steps, &printed, &steady));
    for (state, title) in [
        (&start, "shifted"),
        (&steps[12].state, "rolled by 3.25 mm"),
        (&last.state, "rolled by 14 mm"),
    ] {
        let panel = Panel::new("x in mm", "y in mm").titled(title).equal_aspect();
        figure.panel(places(state, panel));
    }

    let highest = start.pressure.values().iter().copied().fold(0.0, f64::max);
    let at_first = [
        ("shift", 1.774e-2, -start.shift.xi),
        ("approach", 7.258e-2, start.shift.zeta),
        ("p_max", 1.834e-2, highest),
        ("elastic energy", 1.470e-5, energy(&problem, &start)?),
    ];
    let compared: Vec<Compared> = at_first
        .into_iter()
        .map(|(name, printed, own)| Compared { name: format!("shifted: {name}"), printed, own })
        .collect();
    figure.table(beside(&compared));
    figure.table(table(&steps, &printed));
    all_digits(&mut figure, "before it rolls", compared.iter().map(|one| (one.own, one.printed)))
        .source(SOURCE);
    let of = |own: fn(&Step) -> f64, column: usize| {
        steps.iter().map(own).zip(printed.iter().map(move |row| row[column])).collect::<Vec<_>>()
    };
    all_digits(&mut figure, "creepages", of(|step| -step.creepage, 1)).source(SOURCE);
    all_digits(&mut figure, "elastic energies", of(|step| step.energy, 3)).source(SOURCE);
    all_digits(&mut figure, "friction powers", of(|step| step.power.abs(), 4)).source(SOURCE);
    let sticking = of(|step| step.state.count(CellState::Stick) as f64, 2);
    figure.all_close("cells that stick", sticking, Absolute(0.0)).source(SOURCE);
    figure
        .close(
            "cells that stick before it rolls",
            start.count(CellState::Stick) as f64,
            305.0,
            Absolute(0.0),
        )
        .source(SOURCE);
    let off = (last.creepage / steady.creepage.along - 1.0).abs();
    figure
        .at_most("the last creepage over the steady one, less 1", off, 2e-4)
        .source("the steady solution of the same contact");
    Ok(figure)
}
