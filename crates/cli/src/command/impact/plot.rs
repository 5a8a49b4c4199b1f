//! The picture of the history of an impact.

use crate::command::plot::{Course, Value};
use crate::output::Picture;
use carom_impact::HistoryPoint;
use carom_laws::friction::Friction;
use carom_plot::{Panel, Series};

/// Semi-axes that differ by this part or less are a radius.
const ROUND: f64 = 1e-9;
/// The palette's grey.
const GREY: usize = 6;
/// Number of instants of a drawn history.
pub(super) const INSTANTS: usize = 401;

/// Normal force, friction with its limit and the contact against time; displacements and velocities
/// on request.
pub(super) fn course(history: &[HistoryPoint], friction: Friction) -> Picture {
    let course =
        Course { records: history, marked: &[], label: "time / s", at: |point| point.time };
    let mut panels =
        vec![course.panel("normal force on body 1", "force / N", &[("", |p| p.force.z)])];
    if friction.get() > 0.0 {
        let mut panel = course.panel(
            "friction on body 1",
            "force / N",
            &[("F_x", |p| p.force.x), ("F_y", |p| p.force.y)],
        );
        for (name, f) in friction.coefficient().into_iter().flat_map(|f| [("± f F_z", f), ("", -f)])
        {
            let limit = history.iter().map(|point| (point.time, f * point.force.z));
            panel.add(Series::dotted(name, limit).coloured(GREY));
        }
        panels.push(panel);
    }
    panels.push(contact(&course));
    let rest = [
        course.panel(
            "displacements of body 2 against body 1",
            "displacement / m",
            &[("ξ", |p| p.shift.x), ("η", |p| p.shift.y), ("ζ", |p| p.shift.z)],
        ),
        course.panel(
            "velocities of body 2 against body 1",
            "velocity / m/s",
            &[("v_x", |p| p.velocity.x), ("v_y", |p| p.velocity.y), ("v_z", |p| p.velocity.z)],
        ),
    ];
    Picture::new("History of the impact", panels).with(rest)
}

/// The radius or the semi-axes of the contact, and the stick radius if it is known.
fn contact(course: &Course<'_, HistoryPoint>) -> Panel {
    let is_round = |point: &HistoryPoint| {
        let [a, b] = point.semi_axes;
        (a - b).abs() <= ROUND * b
    };
    let radius: (&str, Value<HistoryPoint>) = ("contact", |point| point.semi_axes[0]);
    let stick: (&str, Value<HistoryPoint>) =
        ("stick", |point| point.stick_radius.unwrap_or_default());
    if course.records.iter().all(|point| point.stick_radius.is_some()) {
        course.panel("contact", "radius / m", &[radius, stick])
    } else if course.records.iter().all(is_round) {
        course.panel("contact", "radius / m", &[("", radius.1)])
    } else {
        let axes: [(&str, Value<HistoryPoint>); 2] = [
            ("a, along x", |point| point.semi_axes[0]),
            ("b, along y", |point| point.semi_axes[1]),
        ];
        course.panel("contact", "semi-axis / m", &axes)
    }
}
