//! Fig. 15.3: tangential stresses during an impact.

use carom_impact::restitution::of_spheres;
use carom_laws::friction::Friction;
use carom_laws::shift_law::ShiftLaw;
use carom_solver::{CellState, ContactState};

use super::numerical::{FineRings, Instant, Spheres, stick};
use crate::{Absolute, Arrow, Axis, Failure, Figure, FigureResult, Marker, Panel, Point, Series};
use std::cell::RefCell;

const SHOWN: [usize; 5] = [10, 25, 35, 40, 45];
const STEPS: usize = 50;
const CELLS: usize = 28;
const LAMBDA: f64 = 1.0;
const POISSON: f64 = 0.5;
/// Angles of a ring in a turn.
const ANGLES: usize = 16;

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("κ, λ", "3/2, 1");
    figure.stated("steps", "50, shown are 10, 25, 35, 40, 45");
    figure.derived("ν", "0.5, from κ");
    figure.derived("elements", "28 × 28, 616 in the greatest contact (600 points)");
    figure.assumed("f, bodies, steps", "0.1; those of fig. 15.4; equal time");
    let spheres = Spheres::alike(POISSON)?;
    let run = spheres.follow(LAMBDA, 0.0, CELLS, STEPS)?;
    let normal = spheres.normal()?;
    let greatest = spheres.hertz()?.at_approach(normal.maximal_approach())?;
    let unit = spheres.friction * greatest.peak_pressure;
    let radius = greatest.ellipse.semi_axis_a();
    let contact = |step: usize| -> Result<&ContactState, Failure> {
        Ok(run.get(step).and_then(|at| at.contact.as_ref()).ok_or("no contact")?)
    };
    let mut panel = Panel::new("x/a_max", "σ_zx/(f p₀,max)").titled("along the middle");
    for (colour, step) in SHOWN.into_iter().enumerate() {
        let points = middle_row(contact(step)?);
        let points = points.into_iter().map(|(x, t, _)| (x / radius, t / unit));
        panel.add(Series::line(format!("step {step}"), points).coloured(colour));
    }
    let by_rings = rings(&spheres)?;
    for (colour, step) in SHOWN.into_iter().enumerate() {
        let label = if colour == 0 { "rings" } else { "" };
        let points = by_rings.get(step - 1).ok_or("no contact")?;
        let points = points.iter().map(|(x, t)| (x / radius, t / unit));
        panel.add(Series::markers(label, Marker::Circle, points).coloured(colour));
    }
    figure.panel(panel);
    claim_rings(&mut figure, [unit, radius], &by_rings, &contact)?;
    for step in [25, 35, 40] {
        figure.panel(arrows(contact(step)?, step, radius));
    }
    claims(&mut figure, &spheres, &run)?;
    figure
        .at_least("step 10: all sticks but the rim", stick(contact(10)?), 0.9)
        .source("adhesion for λ < κ while the bodies approach (9.42)");
    let parts = SHOWN[1..].iter().map(|step| Ok(stick(contact(*step)?)));
    figure
        .decreasing("then less and less sticks", parts.collect::<Result<Vec<_>, Failure>>()?)
        .source("regimes of the exact walk: partial slip the other way, then sliding");
    let rim = |step: usize| -> Result<Vec<(f64, f64)>, Failure> {
        let cells = slipping(contact(step)?);
        Ok(cells.into_iter().map(|(t, p)| (t / (spheres.friction * p), -1.0)).collect())
    };
    let pairs = [rim(35)?, rim(40)?, rim(45)?].concat();
    figure
        .all_close("where it slips the stress is -f p along x", pairs, Absolute(0.05))
        .source("Coulomb's law; for ν = 1/2 the stress turns by less than 18 degrees");
    Ok(figure)
}

/// Places along the middle and tractions along x there.
type Row = Vec<(f64, f64)>;

/// The tractions of rings along the middle, step by step.
fn rings(spheres: &Spheres) -> Result<Vec<Row>, Failure> {
    let hertz = spheres.hertz()?;
    let seen = RefCell::new(Vec::new());
    let run = spheres.by_rings(LAMBDA, 0.0, STEPS, |law| seen.borrow_mut().push(along(law)))?;
    let rows = seen.into_inner().into_iter().zip(run.iter().skip(1));
    rows.map(|(row, at)| {
        let radius = hertz.ellipse(at.shift.zeta)?.semi_axis_a();
        Ok(row.into_iter().map(|(x, traction)| (radius * x, traction)).collect())
    })
    .collect()
}

/// The middle of each ring on both sides over the contact radius, and the traction along x there.
fn along(law: &FineRings) -> Row {
    let mut inner = 0.0;
    let mut row = Vec::new();
    for (ring, (edge, _)) in law.slipping().enumerate() {
        let middle = 0.5 * (inner + f64::min(edge, 1.0));
        inner = edge;
        // Half a turn further, the radial traction points against x.
        let sides = [(0, 1.0), (ANGLES / 2, -1.0)];
        let radial = |(angle, sign): (usize, f64)| {
            Some((sign * middle, sign * law.traction(ring, angle)?[0]))
        };
        row.extend(sides.into_iter().filter_map(radial));
    }
    row
}

/// Rings against the cells beside them.
fn claim_rings<'a>(
    figure: &mut Figure,
    [unit, radius]: [f64; 2],
    by_rings: &[Row],
    contact: &impl Fn(usize) -> Result<&'a ContactState, Failure>,
) -> Result<(), Failure> {
    let mut off = Vec::new();
    for step in SHOWN {
        let cells = middle_row(contact(step)?);
        let width = 2.0 * radius / CELLS as f64;
        for (x, traction) in by_rings.get(step - 1).ok_or("no contact")? {
            // At the rim a ring and a cell are means over different places.
            let beside = cells.windows(2).skip(1).find(|pair| (pair[0].0..pair[1].0).contains(x));
            if let Some([(x_0, t_0, _), (_, t_1, _)]) = beside {
                let between = t_0 + (t_1 - t_0) * (x - x_0) / width;
                off.push((between - traction).abs() / unit);
            }
        }
    }
    let mean = off.iter().sum::<f64>() / off.len().max(1) as f64;
    figure.at_least("rings that lie between two cells", off.len() as f64, 100.0).source("a count");
    figure
        .at_most("tractions by rings, in the mean of these", mean, 0.02)
        .source("the grid of this figure");
    Ok(())
}

/// x, traction and pressure of the cells in contact along the row above the middle.
fn middle_row(contact: &ContactState) -> Vec<(f64, f64, f64)> {
    let grid = contact.pressure.grid();
    let row = grid.ny() / 2;
    let cells = (0..grid.nx()).map(|i| (grid.centred_x(i), grid.index(i, row)));
    let values = cells
        .map(|(x, cell)| (x, contact.traction_x.values()[cell], contact.pressure.values()[cell]));
    values.filter(|(_, _, pressure)| *pressure > 0.0).collect()
}

/// Traction along x and pressure of the cells that slip.
fn slipping(contact: &ContactState) -> Vec<(f64, f64)> {
    let values = contact.traction_x.values().iter().zip(contact.pressure.values());
    let cells = values.zip(contact.cells.values());
    cells.filter(|(_, cell)| **cell == CellState::Slip).map(|((t, p), _)| (*t, *p)).collect()
}

fn arrows(contact: &ContactState, step: usize, radius: f64) -> Panel {
    let grid = contact.pressure.grid();
    let (x, y) = (contact.traction_x.values(), contact.traction_y.values());
    let longest = x.iter().zip(y).map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max);
    let scale = 0.12 / longest;
    let cells = grid.centres().enumerate().filter(|(i, _)| contact.pressure.values()[*i] > 0.0);
    let arrows = cells.map(|(i, (at_x, at_y))| {
        let (at_x, at_y) = (at_x / radius, at_y / radius);
        Arrow {
            tail: Point::new(at_x, at_y),
            head: Point::new(at_x + scale * x[i], at_y + scale * y[i]),
        }
    });
    let mut panel = Panel::new(
        Axis::linear("x/a_max").between(-1.15, 1.15),
        Axis::linear("y/a_max").between(-1.15, 1.15),
    )
    .titled(format!("step {step}"))
    .equal_aspect();
    panel.add(Series::arrows("", arrows.collect::<Vec<_>>()));
    panel
}

fn claims(figure: &mut Figure, spheres: &Spheres, run: &[Instant]) -> Result<(), Failure> {
    let [first, .., last] = run else { return Err("no impact".into()) };
    let exact = of_spheres(1.5, LAMBDA)?;
    figure
        .close("R_x", -last.rate[0] / first.rate[0], exact, Absolute(0.01))
        .source("exact walk; 50 steps are off by less than 0.01 at λ = 1");
    // The analytic law on the same steps.
    let friction = Friction::new(spheres.friction)?;
    let law = ShiftLaw::<f64>::new(spheres.hertz()?.stiffness(), friction);
    let step = spheres.normal()?.duration() / STEPS as f64;
    let analytic = spheres.swing(law, first.rate, step, |_| None)?;
    let greatest = analytic.iter().map(|at| at.load.f_z).fold(0.0, f64::max);
    let pairs = SHOWN.map(|step| {
        let unit = 1.0 / (spheres.friction * greatest);
        (unit * run[step].load.f_x, unit * analytic[step].load.f_x)
    });
    figure
        .all_close("F_x/(f F_z,max) at the steps shown", pairs, Absolute(0.02))
        .source("Cattaneo-Mindlin with memory, the same steps");
    Ok(())
}
