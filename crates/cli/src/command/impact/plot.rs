//! The picture of the course of an impact, or of a sweep.

use super::view::{Parameter, Record};
use crate::case::Input;
use crate::command::plot::{Course, MOST_MARKS, Value};
use crate::output::Picture;
use carom_impact::HistoryPoint;
use carom_special::linspace;

/// Instants of a drawn course.
pub(super) const INSTANTS: usize = 401;
/// Values of a drawn sweep.
const VALUES: usize = 361;

/// Forces, displacements, velocities and the contact against time.
pub(super) fn course(history: &[HistoryPoint]) -> Picture {
    let course =
        Course { records: history, marked: &[], label: "time / s", at: |point| point.time };
    let mut areas: Vec<(&'static str, Value<HistoryPoint>)> =
        vec![("a, along x", |p| p.semi_axes[0]), ("b, along y", |p| p.semi_axes[1])];
    if history.iter().all(|point| point.stick_radius.is_some()) {
        areas = vec![
            ("contact", |p| p.semi_axes[0]),
            ("stick", |p| p.stick_radius.unwrap_or_default()),
        ];
    }
    let panels = [
        course.panel(
            "forces on body 1",
            "force / N",
            &[("F_x", |p| p.force.x), ("F_y", |p| p.force.y), ("F_z", |p| p.force.z)],
        ),
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
        course.panel("contact", "radius, semi-axis / m", &areas),
    ];
    Picture::new("Course of the impact", panels)
}

/// The finite values of a sweep with those between its least and its greatest, close together; none
/// where these are one.
pub(super) fn between(values: &[f64]) -> Vec<f64> {
    let values: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if low >= high {
        return Vec::new();
    }
    let mut all = [values, linspace(low, high, VALUES)].concat();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// Restitution, velocity and spin of body 1 against the swept number; `between` are those drawn
/// as lines, `given` those of the case.
pub(super) fn sweep(input: &Input, between: &[Record], given: &[Record]) -> Picture {
    let points = |records: &[Record]| -> Vec<[f64; 4]> {
        let point = |record: &Record| {
            let [_, [body_1, _]] = record.motions();
            let restitution = record.restitution()?;
            let value = Some(record.parameter?.value).filter(|value| value.is_finite())?;
            Some([value, restitution, body_1.velocity[0], body_1.spin[1]])
        };
        records.iter().filter_map(point).collect()
    };
    let (between, given) = (points(between), points(given));
    let name = Parameter::of(input, 0.0).name;
    let (label, what) = match (name, input.unit) {
        ("angle", _) => ("angle from the normal / °".to_owned(), "the angle of incidence"),
        (name, "") => (name.to_owned(), name),
        (name, unit) => (format!("{name} / {unit}"), name),
    };
    let course = Course { records: &between, marked: &given, label: &label, at: |point| point[0] };
    let panels = [
        course.panel("", "R_x", &[("", |point| point[1])]),
        course.panel("", "v_x of body 1 afterwards / m/s", &[("", |point| point[2])]),
        course.panel("", "spin_y of body 1 afterwards / rad/s", &[("", |point| point[3])]),
    ];
    let marks = match (name, given.len() <= MOST_MARKS) {
        (_, false) => "",
        ("angle", true) => " (dots: the angles given)",
        (_, true) => " (dots: the values given)",
    };
    Picture::new(&format!("Sweep over {what}{marks}"), panels)
}
