//! The picture of a solution.

use std::ops::Range;

use super::limits::limits;
use crate::command::plot::{Course, Value};
use crate::error::CliError;
use crate::output::Picture;
use carom_cases::case::SolveCase;
use carom_cases::solve::Followed;
use carom_plot::{Arrow, Axis, Field, Marker, Panel, Point, Series};
use carom_solver::{CellState, ContactState, Contour, StepSummary};

/// Approaches that differ by less than this part are the same, solved to a tolerance.
const SAME: f64 = 1e-6;
/// Loads below this part of the normal force are round-off.
const ROUND_OFF: f64 = 1e-10;
/// Largest number of arrows along an axis.
const MAX_ARROWS: usize = 40;

pub(super) fn draw(followed: &Followed, case: &SolveCase) -> Result<Picture, CliError> {
    let steps = followed.steps.as_slice();
    let course = Course {
        records: steps,
        marked: steps,
        label: "step",
        at: |step: &StepSummary| step.step as f64,
    };
    let (state, f) = (&followed.state, case.friction.motion);
    let (mut panels, mut rest) = (Vec::new(), Vec::new());
    if steps.len() > 1 {
        panels.extend(curves(&course));
        panels.extend(limits(case, steps));
        rest.extend(over_steps(&course));
    }
    if state.pressure.values().iter().any(|p| *p > 0.0) {
        let middle = followed.window.middle();
        panels.push(pressures(state, middle)?);
        let tractions = [&state.traction_x, &state.traction_y];
        let is_sheared = tractions.iter().any(|t| t.values().iter().any(|t| *t != 0.0));
        // The smoothed outline of single cells in a row is empty.
        let outlines = Some(stick_and_slip(state, middle));
        let outlines = outlines.filter(|panel| !panel.series.is_empty());
        if is_sheared {
            panels.extend(outlines);
            rest.extend([sizes(state, f), angles(state)]);
        } else {
            rest.extend(outlines.map(|panel| panel.titled("contact, outline smoothed")));
        }
    }
    Ok(Picture::new("Contact on a grid", panels).with(rest))
}

/// Loads over the motions that change; over the steps the motions that need no load.
fn curves(course: &Course<'_, StepSummary>) -> Vec<Panel> {
    let steps = course.records;
    let mut panels = Vec::new();
    let greatest =
        |of: Value<StepSummary>| steps.iter().map(|step| of(step).abs()).fold(0.0, f64::max);
    let force = greatest(|s| s.load.f_z);
    let shears = greatest(|s| s.load.f_x).max(greatest(|s| s.load.f_y)) > ROUND_OFF * force;
    if steps.iter().any(|step| step.shift.xi != 0.0 || step.shift.eta != 0.0) {
        let free: [(&str, Value<StepSummary>); 2] = [("ξ", |s| s.shift.xi), ("η", |s| s.shift.eta)];
        panels.push(if !shears {
            course.panel("shift without a force", "shift / m", &free)
        } else {
            course.paths(
                "load curves",
                ["shift / m", "force / N"],
                &[
                    ("F_x against ξ", |s| s.shift.xi, |s| s.load.f_x),
                    ("F_y against η", |s| s.shift.eta, |s| s.load.f_y),
                ],
            )
        });
    }
    let first = steps[0].shift.zeta;
    if steps.iter().any(|step| (step.shift.zeta - first).abs() > SAME * first.abs()) {
        panels.push(course.paths(
            "approach",
            ["ζ / m", "force / N"],
            &[("F_z against ζ", |s| s.shift.zeta, |s| s.load.f_z)],
        ));
    }
    let least = steps.iter().map(|step| step.load.f_z).fold(f64::INFINITY, f64::min);
    if force - least > SAME * force {
        panels.push(course.paths(
            "area over force",
            ["F_z / N", "part of the window"],
            &[("contact", |s| s.load.f_z, |s| s.contact_share)],
        ));
    }
    let torque = ROUND_OFF * force * libm::sqrt(greatest(|s| s.contact_area));
    if steps.iter().any(|step| step.shift.omega != 0.0) {
        panels.push(match greatest(|s| s.load.m_z) > torque {
            true => course.paths(
                "torque",
                ["ω / rad", "torque / N m"],
                &[("M_z against ω", |s| s.shift.omega, |s| s.load.m_z)],
            ),
            false => course.panel("twist without a torque", "ω / rad", &[("", |s| s.shift.omega)]),
        });
    }
    panels
}

/// Forces, energy and areas after each step.
fn over_steps(course: &Course<'_, StepSummary>) -> [Panel; 3] {
    [
        course.panel(
            "forces on body 1",
            "force / N",
            &[("F_x", |s| s.load.f_x), ("F_y", |s| s.load.f_y), ("F_z", |s| s.load.f_z)],
        ),
        course.panel(
            "energy",
            "energy / J",
            &[("stored", |s| s.stored_energy), ("dissipated", |s| s.dissipated)],
        ),
        course.panel(
            "areas",
            "area / m²",
            &[("contact", |s| s.contact_area), ("stick", |s| s.stick_area)],
        ),
    ]
}

/// Part of the contact's width by which the map of pressures extends beyond it.
const MARGIN: usize = 8;

pub(in crate::command) fn axes(title: &str) -> Panel {
    Panel::new(Axis::linear("x / m"), Axis::linear("y / m")).titled(title).equal_aspect()
}

fn outlines(panel: &mut Panel, lines: &[Contour], middle: [f64; 2], label: &str, colour: usize) {
    for (i, line) in lines.iter().enumerate() {
        let closed = line.points.iter().chain(line.points.first());
        let closed = closed.map(|[x, y]| (middle[0] + x, middle[1] + y));
        panel.add(Series::line(if i == 0 { label } else { "" }, closed).coloured(colour));
    }
}

pub(in crate::command) fn pressures(
    state: &ContactState,
    middle: [f64; 2],
) -> Result<Panel, CliError> {
    let grid = state.pressure.grid();
    if grid.nx() == 1 || grid.ny() == 1 {
        return Ok(profile(state, middle));
    }
    let [columns, rows] = around_contact(state);
    let x = columns.clone().map(|i| middle[0] + grid.centred_x(i)).collect();
    let y = rows.clone().map(|j| middle[1] + grid.centred_y(j)).collect();
    let pressure = |(i, j): (usize, usize)| state.pressure.values()[j * grid.nx() + i];
    let cells = rows.flat_map(|j| columns.clone().map(move |i| (i, j)));
    let field = Field::new("p / Pa", x, y, cells.map(pressure).collect())?;
    Ok(axes("pressure, last step").over(field))
}

/// Pressure and tractions along a single line of cells.
fn profile(state: &ContactState, middle: [f64; 2]) -> Panel {
    let grid = state.pressure.grid();
    let is_column = grid.nx() == 1 && grid.ny() > 1;
    let along = usize::from(is_column);
    let range = around_contact(state)[along].clone();
    let place = |i: usize| match is_column {
        true => middle[1] + grid.centred_y(i),
        false => middle[0] + grid.centred_x(i),
    };
    let axis = Axis::linear(if is_column { "y / m" } else { "x / m" });
    let mut panel = Panel::new(axis, Axis::linear("traction / Pa")).titled("pressure, last step");
    let fields = [("p", &state.pressure), ("t_x", &state.traction_x), ("t_y", &state.traction_y)];
    for (colour, (name, field)) in fields.into_iter().enumerate() {
        let values = field.values();
        if values.iter().any(|value| *value != 0.0) {
            let points = range.clone().map(|i| (place(i), values[i]));
            panel.add(Series::line(name, points.collect::<Vec<_>>()).coloured(colour));
        }
    }
    panel
}

/// Columns and rows of the contact and a few cells around it.
pub(in crate::command) fn around_contact(state: &ContactState) -> [Range<usize>; 2] {
    let grid = state.pressure.grid();
    let all = [grid.nx(), grid.ny()];
    let Some(extent) = state.extent() else { return all.map(|count| 0..count) };
    [0, 1].map(|axis| {
        let [first, last] = extent[axis];
        let margin = 2 + (last - first) / MARGIN;
        let (from, to) = (first.saturating_sub(margin), (last + margin + 1).min(all[axis]));
        // A field has two nodes or more along each axis.
        if to - from < 2 { 0..all[axis] } else { from..to }
    })
}

/// Tractions as arrows, with the outlines of contact and stick area.
fn stick_and_slip(state: &ContactState, middle: [f64; 2]) -> Panel {
    let mut panel = axes("tractions on body 1, outlines smoothed");
    outlines(&mut panel, &state.contact_outlines(), middle, "contact", 0);
    outlines(&mut panel, &state.stick_outlines(), middle, "stick", 1);
    if let Some(arrows) = arrows(state, middle) {
        panel.add(Series::arrows("", arrows).coloured(2));
    }
    panel
}

/// Tractions as arrows; none without a traction.
pub(in crate::command) fn arrows(state: &ContactState, middle: [f64; 2]) -> Option<Vec<Arrow>> {
    let grid = state.pressure.grid();
    let widest = around_contact(state).iter().map(Range::len).max().unwrap_or(1);
    let stride = widest.div_ceil(MAX_ARROWS);
    let (x, y) = (state.traction_x.values(), state.traction_y.values());
    let longest = x.iter().zip(y).map(|(x, y)| libm::hypot(*x, *y)).fold(0.0, f64::max);
    let scale = 2.0 * stride as f64 * grid.dx().max(grid.dy()) / longest;
    let cells = grid.centres().enumerate().filter(|(i, _)| {
        (i % grid.nx()).is_multiple_of(stride) && (i / grid.nx()).is_multiple_of(stride)
    });
    let arrows = cells.filter(|(i, _)| libm::hypot(x[*i], y[*i]) > 0.02 * longest).map(
        |(i, (at_x, at_y))| {
            let (at_x, at_y) = (middle[0] + at_x, middle[1] + at_y);
            Arrow {
                tail: Point::new(at_x, at_y),
                head: Point::new(at_x + scale * x[i], at_y + scale * y[i]),
            }
        },
    );
    (longest > 0.0).then(|| arrows.collect())
}

/// Cells in contact with this state: distance from the middle, size and angle of the traction.
fn scatter(state: &ContactState, cell: CellState) -> impl Iterator<Item = [f64; 3]> + '_ {
    let cells = state.pressure.grid().centres().enumerate();
    cells.filter(move |(i, _)| state.cells.values()[*i] == cell).map(|(i, (x, y))| {
        let (t_x, t_y) = (state.traction_x.values()[i], state.traction_y.values()[i]);
        [libm::hypot(x, y), libm::hypot(t_x, t_y), libm::atan2(t_y, t_x).to_degrees()]
    })
}

const KINDS: [(&str, CellState, Marker); 2] =
    [("stick", CellState::Stick, Marker::Star), ("slip", CellState::Slip, Marker::Square)];

fn sizes(state: &ContactState, f: f64) -> Panel {
    let mut panel = Panel::new(Axis::linear("r / m"), Axis::linear("|t|/(f p_max)"));
    let most = f * state.pressure.values().iter().copied().fold(0.0, f64::max);
    for (label, cell, marker) in KINDS {
        let points = scatter(state, cell).map(|[r, size, _]| (r, size / most));
        panel.add(Series::markers(label, marker, points.collect::<Vec<_>>()));
    }
    panel.titled("size of the tractions")
}

fn angles(state: &ContactState) -> Panel {
    let mut panel = Panel::new(Axis::linear("r / m"), Axis::linear("angle / degrees"));
    for (label, cell, marker) in KINDS {
        let points = scatter(state, cell).filter(|[_, size, _]| *size > 0.0);
        panel.add(Series::markers(
            label,
            marker,
            points.map(|[r, _, angle]| (r, angle)).collect::<Vec<_>>(),
        ));
    }
    panel.titled("direction of the tractions")
}
