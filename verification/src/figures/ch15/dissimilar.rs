//! Figs. 15.4 and 15.5: the impact of two dissimilar spheres.

use carom_halfspace::Material;
use carom_solver::{ContactState, Contour};

use super::numerical::{Instant, SHEAR_MODULUS, Spheres, stick};
use crate::reference::rows;
use crate::{Absolute, Axis, Failure, Figure, FigureResult, Panel, Series};

const LAMBDA: f64 = 0.5;
const CELLS: usize = 20;
const STEPS: usize = 50;
const INDEPENDENT: &str = "an independent half-space program";

fn spheres() -> Result<Spheres, Failure> {
    let body = |poisson| Material::from_shear(SHEAR_MODULUS, poisson);
    Ok(Spheres::of([body(0.0)?, body(0.5)?], 0.1))
}

fn inputs(figure: &mut Figure) {
    figure.stated("ν₁, ν₂, G, f", "0, 0.5, 82000 N/mm², 0.1");
    figure.stated("masses, velocities", "2188 g; ξ̇ = 0.05 m/s, ζ̇ = 1 m/s");
    figure.stated("elements", "20 × 20 about the greatest contact");
    figure.derived("steps", "50 of equal time");
    figure.assumed("radius", "40.5 mm, from 7.85 g/cm³");
}

pub(super) fn forces() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    let spheres = spheres()?;
    let run = spheres.follow(LAMBDA, 0.0, CELLS, STEPS)?;
    let mut force = Panel::new("t in ms", "forces in kN");
    let line = |of: &dyn Fn(&Instant) -> f64| -> Vec<(f64, f64)> {
        run.iter().map(|instant| (1e3 * instant.time, of(instant))).collect()
    };
    force.add(Series::line("F_z/100", line(&|at| 1e-5 * at.load.f_z)));
    force.add(Series::line("F_x", line(&|at| 1e-3 * at.load.f_x)));
    let limit = |at: &Instant| 1e-3 * spheres.friction * at.load.f_z;
    force.add(Series::dotted("±f F_z", line(&|at| limit(at))));
    force.add(Series::dotted("", line(&|at| -limit(at))).coloured(2));
    let by_rings = spheres.by_rings(LAMBDA, 0.0, STEPS, |_| ())?;
    let rings = by_rings.iter().map(|at| (1e3 * at.time, 1e-3 * at.load.f_x));
    force.add(Series::dashed("F_x, rings", rings).coloured(3));
    // The thesis's picture shows no such limit; where F_x is small compared with it nothing slides.
    force.y = force.y.between(-0.35, 0.35);
    figure.panel(force);
    let mut shift = Panel::new("t in ms", "shifts in µm");
    shift.add(Series::line("ζ/10", line(&|at| 1e5 * at.shift.zeta)));
    shift.add(Series::line("ξ", line(&|at| 1e6 * at.shift.xi)));
    figure.panel(shift);
    claims(&mut figure, &spheres, &run)?;
    claim_rings(&mut figure, &run, &by_rings)?;
    Ok(figure)
}

fn claims(figure: &mut Figure, spheres: &Spheres, run: &[Instant]) -> Result<(), Failure> {
    let [first, .., last] = run else { return Err("no impact".into()) };
    let ratio = |i: usize| -last.rate[i] / first.rate[i];
    let peak = |of: &dyn Fn(&Instant) -> f64| run.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
    let highest = peak(&|at| at.shift.zeta);
    let table = rows::<5>(include_str!("../../../data/impact/numerical_dissimilar.csv"))?;
    let normal = spheres.normal()?;
    for [cells, steps, r_x, e_z, approach] in table {
        if (cells, steps) != (CELLS as f64, STEPS as f64) {
            continue;
        }
        let statement = "R_x";
        figure.close(statement, ratio(0), r_x, Absolute(0.006)).source(INDEPENDENT);
        figure.close("e_z", ratio(2), e_z, Absolute(2e-4)).source(INDEPENDENT);
        let found = highest / normal.maximal_approach();
        figure.close("ζ_max over Hertz's", found, approach, Absolute(1e-3)).source(INDEPENDENT);
    }
    let found = [peak(&|at| at.load.f_x), peak(&|at| -at.load.f_x)];
    figure
        .all_close(
            "F_x between -104 N and 280 N",
            [(found[0], 280.0), (found[1], 104.0)],
            Absolute(6.0),
        )
        .source(INDEPENDENT);
    figure
        .close("greatest F_z in kN", 1e-3 * peak(&|at| at.load.f_z), 16.2, Absolute(0.1))
        .source(INDEPENDENT);
    // Momentum: the impulse of F equals the change of velocity.
    let impulse = |of: &dyn Fn(&Instant) -> f64| {
        run.windows(2)
            .map(|pair| 0.5 * (pair[1].time - pair[0].time) * (of(&pair[0]) + of(&pair[1])))
            .sum::<f64>()
    };
    let unit = 2.0 / spheres.mass;
    let pairs = [
        (unit * impulse(&|at| at.load.f_z), first.rate[2] - last.rate[2]),
        (3.5 * unit * impulse(&|at| at.load.f_x), first.rate[0] - last.rate[0]),
    ];
    figure
        .all_close("impulses over masses are changes of velocity", pairs, Absolute(1e-3))
        .source("Newton's law");
    let energy = |at: &Instant| 0.5 * (at.rate[2].powi(2) + at.rate[0].powi(2) / 3.5);
    figure
        .holds(
            "the impact loses energy",
            energy(last) < energy(first),
            energy(last) / energy(first),
        )
        .source("friction dissipates");
    Ok(())
}

/// Rings and grid, in the same steps.
fn claim_rings(figure: &mut Figure, run: &[Instant], by_rings: &[Instant]) -> Result<(), Failure> {
    let greatest = run.iter().map(|at| at.load.f_x.abs()).fold(0.0, f64::max);
    let off = run.iter().zip(by_rings).map(|(a, b)| (a.load.f_x - b.load.f_x).abs() / greatest);
    figure
        .at_most("F_x by rings over the greatest of the grid", off.fold(0.0, f64::max), 0.02)
        .source("the grid of this figure");
    let ratio =
        |run: &[Instant]| -> Option<f64> { Some(-run.last()?.rate[0] / run.first()?.rate[0]) };
    let [on_grid, rings] = [run, by_rings].map(ratio);
    let (on_grid, rings) = (on_grid.ok_or("no impact")?, rings.ok_or("no impact")?);
    figure.close("R_x by rings", rings, on_grid, Absolute(0.01)).source("the grid of this figure");
    Ok(())
}

/// Steps of fig. 15.5: during compression and during restitution.
const SHOWN: [usize; 4] = [20, 28, 32, 38];

pub(super) fn areas() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    figure.stated("steps shown", "20, 28");
    figure.assumed("further steps", "32, 38");
    figure
        .assumed("smoothing", "means with the weights 1 2 1 along both axes, outline at one half");
    let spheres = spheres()?;
    let run = spheres.follow(LAMBDA, 0.0, CELLS, STEPS)?;
    let contact = |step: usize| -> Result<&ContactState, Failure> {
        Ok(run.get(step).and_then(|at| at.contact.as_ref()).ok_or("no contact")?)
    };
    for step in SHOWN {
        figure.panel(map(contact(step)?, step));
    }
    sticking(&mut figure, &spheres, &run)?;
    let part = |step: usize| Ok::<f64, Failure>(stick(contact(step)?));
    let hole = |step: usize| -> Result<f64, Failure> {
        let lines = contact(step)?.stick_outlines();
        Ok(lines.iter().map(Contour::area).filter(|area| *area < 0.0).sum::<f64>().abs())
    };
    let outside = |step: usize| -> Result<f64, Failure> {
        let contact = contact(step)?;
        let outer = |lines: Vec<Contour>| {
            lines.iter().map(Contour::area).filter(|area| *area > 0.0).sum::<f64>()
        };
        let all = outer(contact.contact_outlines());
        Ok((all - outer(contact.stick_outlines())) / all)
    };
    let parts =
        |steps: std::ops::RangeInclusive<usize>| steps.map(part).collect::<Result<Vec<f64>, _>>();
    let compression = parts(10..=20)?.into_iter().fold(0.0, f64::max);
    figure
        .at_most("while the bodies approach little sticks", compression, 0.05)
        .source(INDEPENDENT);
    let ring = parts(27..=30)?;
    let least = ring.iter().copied().fold(1.0, f64::min);
    figure.at_least("from half of the time on a ring sticks", least, 0.3).source(INDEPENDENT);
    let greatest = parts(25..=40)?.into_iter().fold(0.0, f64::max);
    figure.at_most("of at most six tenths of the contact", greatest, 0.65).source(INDEPENDENT);
    let holes = [34, 36, 38, 40].map(hole).into_iter().collect::<Result<Vec<f64>, _>>()?;
    figure.decreasing("the slip area inside the ring shrinks", holes).source("section 15.2");
    let rims = [34, 37, 40, 43].map(outside).into_iter().collect::<Result<Vec<f64>, _>>()?;
    figure
        .increasing("that at the rim grows, as a part of the contact", rims)
        .source("section 15.2");
    let uneven = SHOWN
        .map(|step| contact(step).map(unevenness))
        .into_iter()
        .collect::<Result<Vec<f64>, _>>()?;
    figure
        .at_most(
            "cells whose mirror image across y = 0 is in another state",
            uneven.into_iter().fold(0.0, f64::max),
            0.0,
        )
        .source("mirror symmetry");
    figure.deviation(
        "restitution starts in step 28",
        "it starts in step 25",
        "50 steps of equal time within Hertz's duration; the thesis's steps are not stated",
    );
    Ok(figure)
}

/// The part of the contact that sticks, on the grid and by rings.
fn sticking(figure: &mut Figure, spheres: &Spheres, run: &[Instant]) -> Result<(), Failure> {
    let seen = std::cell::RefCell::new(Vec::new());
    spheres.by_rings(LAMBDA, 0.0, STEPS, |law| seen.borrow_mut().push(law.sticking()))?;
    let rings = seen.into_inner();
    let on_grid: Vec<f64> = run.iter().filter_map(|at| at.contact.as_ref()).map(stick).collect();
    let over_time = |parts: &[f64]| -> Vec<(f64, f64)> {
        parts.iter().zip(run.iter().skip(1)).map(|(part, at)| (1e3 * at.time, *part)).collect()
    };
    let mut panel = Panel::new("t in ms", "part of the contact that sticks").titled("all steps");
    panel.add(Series::line("elements", over_time(&on_grid)));
    panel.add(Series::dashed("rings", over_time(&rings)));
    figure.panel(panel);
    let off = on_grid.iter().zip(&rings).map(|(a, b)| (a - b).abs());
    let mean = off.sum::<f64>() / on_grid.len().max(1) as f64;
    figure
        .at_most("rings and elements: the part that sticks, in the mean", mean, 0.05)
        .source("16 rings by 16 angles; they share no code with the grid");
    Ok(())
}

/// How many cells differ from their mirror images.
fn unevenness(contact: &ContactState) -> f64 {
    let grid = contact.cells.grid();
    let rows = (0..grid.ny()).flat_map(|j| (0..grid.nx()).map(move |i| (i, j)));
    let differs =
        rows.filter(|(i, j)| contact.cells.get(*i, *j) != contact.cells.get(*i, grid.ny() - 1 - j));
    differs.count() as f64
}

/// The outlines, closed, in mm.
fn map(contact: &ContactState, step: usize) -> Panel {
    let mut panel = Panel::new(
        Axis::linear("x in mm").between(-1.6, 1.6),
        Axis::linear("y in mm").between(-1.6, 1.6),
    )
    .titled(format!("step {step}"))
    .equal_aspect();
    let closed = |line: &Contour| -> Vec<(f64, f64)> {
        let points = line.points.iter().chain(line.points.first());
        points.map(|[x, y]| (1e3 * x, 1e3 * y)).collect()
    };
    let mut add = |lines: Vec<Contour>, label: &str, colour: usize| {
        for (i, line) in lines.iter().enumerate() {
            let label = if i == 0 { label } else { "" };
            panel.add(Series::line(label, closed(line)).coloured(colour));
        }
    };
    add(contact.contact_outlines(), "contact", 0);
    add(contact.stick_outlines(), "stick", 1);
    let grid = contact.cells.grid();
    let marked = |state: carom_solver::CellState| {
        let cells = grid.centres().zip(contact.cells.values());
        cells.filter(move |(_, cell)| **cell == state).map(|((x, y), _)| (1e3 * x, 1e3 * y))
    };
    let sticks: Vec<_> = marked(carom_solver::CellState::Stick).collect();
    let slips: Vec<_> = marked(carom_solver::CellState::Slip).collect();
    panel.add(Series::markers("", crate::Marker::Star, sticks).coloured(1));
    panel.add(Series::markers("", crate::Marker::Square, slips).coloured(2));
    panel
}
