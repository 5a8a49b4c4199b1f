//! The picture of the course of an impact, or of a sweep.

use super::model;
use super::samples::Sample;
use super::view::{self, Instant, Record};
use crate::case::{Approach, ImpactCase, Numbers};
use crate::command::plot::{Course, MOST_MARKS};
use crate::output::Picture;
use carom_impact::CollisionError;
use carom_plot::linspace;

/// Instants of a drawn course.
pub(super) const INSTANTS: usize = 401;
/// Angles of a drawn sweep.
const ANGLES: usize = 361;

/// Forces, displacements and radii against time.
pub(super) fn course(history: &[Instant]) -> Picture {
    let course =
        Course { records: history, marked: &[], label: "time / s", at: |instant| instant.time };
    let panels = [
        course.panel(
            "forces on body 1",
            "force / N",
            &[("normal", |i| i.normal_force), ("tangential", |i| i.tangential_force)],
        ),
        course.panel(
            "displacements",
            "displacement / m",
            &[("approach", |i| i.approach), ("shift", |i| i.shift)],
        ),
        course.panel(
            "areas",
            "radius / m",
            &[("contact", |i| i.contact_radius), ("stick", |i| i.stick_radius)],
        ),
    ];
    Picture::new("Course of the impact", panels)
}

/// Forces, displacements, velocities and the contact ellipse of an encounter against time.
pub(super) fn encounter(samples: &[Sample]) -> Picture {
    let course =
        Course { records: samples, marked: &[], label: "time / s", at: |sample| sample.time };
    let panels = [
        course.panel(
            "forces on body 1",
            "force / N",
            &[("F_x", |s| s.force[0]), ("F_y", |s| s.force[1]), ("F_z", |s| s.force[2])],
        ),
        course.panel(
            "displacements of body 2 against body 1",
            "displacement / m",
            &[("ξ", |s| s.shift[0]), ("η", |s| s.shift[1]), ("ζ", |s| s.shift[2])],
        ),
        course.panel(
            "velocities of body 2 against body 1",
            "velocity / m/s",
            &[("v_x", |s| s.velocity[0]), ("v_y", |s| s.velocity[1]), ("v_z", |s| s.velocity[2])],
        ),
        course.panel(
            "contact ellipse",
            "semi-axis / m",
            &[("a, along x", |s| s.semi_axes[0]), ("b, along y", |s| s.semi_axes[1])],
        ),
    ];
    Picture::new("Course of the impact", panels)
}

/// The impacts of a sweep between its least and its greatest angle, close together; none where
/// these are one.
pub(super) fn between(
    case: &ImpactCase,
    records: &[Record],
) -> Result<Vec<Record>, CollisionError> {
    let angles = || records.iter().filter_map(|record| record.angle);
    let (low, high) = (angles().fold(90.0, f64::min), angles().fold(0.0, f64::max));
    let Some(approach) = case.approach.as_ref().filter(|_| low < high) else {
        return Ok(Vec::new());
    };
    let mut angles: Vec<f64> = angles().chain(linspace(low, high, ANGLES)).collect();
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    let approach = Approach { angles: Numbers::Sweep(angles), ..approach.clone() };
    let case = ImpactCase { approach: Some(approach), ..case.clone() };
    view::records(&model::shots(&case)?)
}

/// Restitution, velocity and spin of body 1 against the angle of incidence; `between` are those
/// drawn as lines, `given` those of the case.
pub(super) fn sweep(between: &[Record], given: &[Record]) -> Picture {
    let points = |records: &[Record]| -> Vec<[f64; 4]> {
        let point = |record: &Record| {
            let body_1 = &record.after.body_1;
            let restitution = record.restitution()?;
            Some([record.angle?, restitution, body_1.velocity[0], body_1.spin[1]])
        };
        records.iter().filter_map(point).collect()
    };
    let (between, given) = (points(between), points(given));
    let label = "angle from the normal / °";
    let course = Course { records: &between, marked: &given, label, at: |point| point[0] };
    let panels = [
        course.panel("", "R_x", &[("", |point| point[1])]),
        course.panel("", "v_x of body 1 afterwards / m/s", &[("", |point| point[2])]),
        course.panel("", "spin_y of body 1 afterwards / rad/s", &[("", |point| point[3])]),
    ];
    let marks = if given.len() <= MOST_MARKS { " (dots: the angles given)" } else { "" };
    Picture::new(&format!("Sweep over the angle of incidence{marks}"), panels)
}
