//! The picture of a bellows.

use super::exaggeration;
use crate::command::plot::{Course, Value};
use crate::output::Picture;
use carom_cases::shell::{BellowsRow, FollowedBellows};
use carom_plot::{Axis, Panel, Series};
use carom_shells::bellows::WallPoint;
use std::f64::consts::PI;

/// The meridian at rest and after the last load, force over dilatation (or over pressure), and the
/// stresses along the meridian.
pub(in super::super) fn draw(solved: &FollowedBellows) -> Picture {
    let mut panels: Vec<Panel> = Vec::new();
    let last = solved.rows.last();
    panels.extend(last.map(|row| meridian(solved, row)));
    panels.extend(forces(solved));
    panels.extend(last.map(|row| stresses(row.state.profile())));
    let corrugations = match solved.corrugations {
        1 => "one corrugation".to_owned(),
        several => format!("{several} corrugations"),
    };
    Picture::new(&format!("Bellows, {corrugations}"), panels)
}

fn meridian(solved: &FollowedBellows, row: &BellowsRow) -> Panel {
    let shape = solved.bellows.meridian();
    let profile = row.state.profile();
    let rest = |at: &WallPoint| {
        let place = shape.at(at.parameter);
        (place.radius, place.height)
    };
    let moved = |at: &WallPoint| {
        let (radius, height) = rest(at);
        (at.radius - radius, at.height - height)
    };
    let moves = profile.iter().map(moved);
    let greatest = moves.map(|(r, z)| libm::hypot(r, z)).fold(0.0, f64::max);
    let size = 2.0 * (shape.at(0.0).radius - shape.mean_radius());
    let (factor, words) = exaggeration(greatest, size.max(shape.pitch()));
    let loaded = |at: &WallPoint| {
        let ((radius, height), (out, up)) = (rest(at), moved(at));
        (radius + factor * out, height + factor * up)
    };
    let mut panel = Panel::new(Axis::linear("r / m"), Axis::linear("z / m"))
        .titled(format!("meridian{words}"))
        .equal_aspect();
    panel.add(Series::dashed("at rest", whole(profile.iter().map(rest).collect())).coloured(1));
    panel.add(
        Series::line("after the last load", whole(profile.iter().map(loaded).collect()))
            .coloured(0),
    );
    panel
}

/// A corrugation from crest to crest, from its half from crest to root.
fn whole(half: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let root = half.last().map_or(0.0, |place| place.1);
    let mirrored: Vec<_> = half.iter().rev().map(|(r, z)| (*r, 2.0 * root - z)).collect();
    [half, mirrored].concat()
}

/// A state of all corrugations: dilatation, pressure, force.
type State = [f64; 3];

/// The force over what varies; none for a single load.
fn forces(solved: &FollowedBellows) -> Option<Panel> {
    let count = solved.corrugations as f64;
    let rows: Vec<State> = solved
        .rows
        .iter()
        .map(|row| [row.dilatation(), row.state.pressure(), row.state.force()])
        .collect();
    let varies = |axis: usize| rows.windows(2).any(|pair| pair[0][axis] != pair[1][axis]);
    if varies(1) {
        let at = |state: &State| state[1];
        let course = Course { records: &rows, marked: &rows, label: "pressure / Pa", at };
        let value: (&str, &str, Value<State>) = match varies(2) {
            true => ("thrust over pressure", "thrust on the anchors / N", |state| -state[2]),
            false => ("dilatation over pressure", "dilatation / m", |state| state[0]),
        };
        return Some(course.panel(value.0, value.1, &[("", value.2)]));
    }
    if !varies(0) && !varies(2) {
        return None;
    }
    let mut course: Vec<State> = solved
        .course
        .iter()
        .map(|state| [count * state.dilatation(), state.pressure(), state.force()])
        .collect();
    course.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let mut panel =
        Course { records: &course, marked: &rows, label: "dilatation / m", at: |s| s[0] }.panel(
            "force over dilatation",
            "force / N",
            &[("computed", |state| state[2])],
        );
    let rate = solved.response.linear.spring_rate / count;
    // The linear spring through the state without elongation, or the first one.
    let origin = course.iter().min_by(|one, other| one[0].abs().total_cmp(&other[0].abs()))?;
    let ends = [course.first()?, course.last()?];
    let line = ends.map(|end| (end[0], origin[2] + rate * (end[0] - origin[0])));
    panel.add(Series::dashed("linear spring rate", line).coloured(1));
    Some(panel)
}

fn stresses(profile: &[WallPoint]) -> Panel {
    let kinds: [(&str, Value<WallPoint>); 4] = [
        ("meridional, membrane", |at| at.meridional_membrane),
        ("meridional, bending", |at| at.meridional_bending),
        ("hoop, membrane", |at| at.hoop_membrane),
        ("hoop, bending", |at| at.hoop_bending),
    ];
    let axis = "ξ / π, from crest (0) to root (1)";
    let mut panel = Panel::new(Axis::linear(axis), Axis::linear("stress / Pa"))
        .titled("stresses after the last load");
    for (i, (name, of)) in kinds.into_iter().enumerate() {
        let line = profile.iter().map(|at| (at.parameter / PI, of(at)));
        let series = if i % 2 == 0 { Series::line(name, line) } else { Series::dashed(name, line) };
        panel.add(series.coloured(i / 2));
    }
    panel
}
