//! The picture of a history.

use super::follow::Drawn;
use crate::command::plot::{Course, MOST_MARKS, Value};
use crate::output::Picture;
use carom_cases::history::{Step, Traction};
use carom_plot::Panel;

/// Force against shift, torque against twist, the stick area, and the tractions after the last step in
/// contact; forces and energy against the step on request.
pub(super) fn draw(drawn: &Drawn) -> Picture {
    let (history, between) = (drawn.marked.as_slice(), drawn.course.as_slice());
    let course = Course { records: between, marked: history, label: "step", at: |step| step.step };
    let mut panels = vec![
        course.paths(
            "loops",
            ["shift / m", "force / N"],
            &[
                ("F_x against ξ", |s| s.shift.xi, |s| s.load.f_x),
                ("F_y against η", |s| s.shift.eta, |s| s.load.f_y),
            ],
        ),
        areas(&course),
    ];
    let mut rest = vec![
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
    ];
    if history.iter().any(|step| step.twist.is_some()) {
        let [torque, stick] = torsion(history, between);
        panels.push(torque);
        rest.push(stick);
    }
    panels.extend(drawn.last.as_ref().map(|[last, given]| tractions(last, &given.tractions)));
    let marks = if history.len() <= MOST_MARKS { " (dots: the steps given)" } else { "" };
    Picture::new(&format!("Load history{marks}"), panels).with(rest)
}

fn areas(course: &Course<'_, Step>) -> Panel {
    let is_round =
        |step: &Step| (step.semi_axis_a - step.semi_axis_b).abs() <= 1e-9 * step.semi_axis_b;
    if course.records.iter().all(is_round) {
        return course.panel(
            "contact and stick area",
            "radius / m",
            &[("contact", |s| s.semi_axis_a), ("stick", |s| s.stick_semi_axis_a)],
        );
    }
    course.panel(
        "contact and stick ellipse",
        "semi-axis / m",
        &[
            ("a", |s| s.semi_axis_a),
            ("b", |s| s.semi_axis_b),
            ("a, stick", |s| s.stick_semi_axis_a),
            ("b, stick", |s| s.stick_semi_axis_b),
        ],
    )
}

fn torsion(history: &[Step], between: &[Step]) -> [Panel; 2] {
    let stick: Value<Step> = |s| s.twist.map_or(0.0, |twist| twist.stick_semi_axis_b);
    let course = Course { records: between, marked: history, label: "step", at: |step| step.step };
    [
        course.paths(
            "torsion",
            ["twist Ω / rad", "torque M_z on body 1 / N m"],
            &[("", |s| s.shift.omega, |s| s.load.m_z)],
        ),
        course.panel("stick area of the twist", "larger semi-axis / m", &[("", stick)]),
    ]
}

fn tractions(step: &Step, given: &[Traction]) -> Panel {
    let course = Course {
        records: &step.tractions,
        marked: given,
        label: "radius, from the centre (0) to the edge (1)",
        at: |traction: &Traction| traction.radius,
    };
    let title = format!("tractions after step {}", step.step);
    let mut lines: Vec<(&str, Value<Traction>)> =
        vec![("t_x", |t| t.t_x), ("t_y", |t| t.t_y), ("friction limit", |t| t.limit)];
    if step.tractions.iter().any(|traction| traction.t_twist.is_some()) {
        lines.push(("around the normal", |t| t.t_twist.unwrap_or_default()));
    }
    course.panel(&title, "traction on body 1 / Pa", &lines)
}
