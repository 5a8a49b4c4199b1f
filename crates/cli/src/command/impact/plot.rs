//! The course of an impact, or a sweep, as SVG.

use super::samples::Sample;
use super::view::{Instant, Record};
use crate::command::plot::{Course, drawn};
use crate::error::CliError;
use carom_plot::{Axis, Marker, Panel, Series};

/// Instants of a drawn course.
pub(super) const INSTANTS: usize = 401;

/// Forces, displacements and radii against time.
pub(super) fn course(history: &[Instant]) -> Result<String, CliError> {
    let course = Course { records: history, label: "time / s", at: |instant| instant.time };
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
    drawn("Course of the impact", &panels)
}

/// Forces, displacements, velocities and the contact ellipse of an encounter against time.
pub(super) fn encounter(samples: &[Sample]) -> Result<String, CliError> {
    let course = Course { records: samples, label: "time / s", at: |sample| sample.time };
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
    drawn("Course of the impact", &panels)
}

/// Restitution, velocity and spin of body 1 against the angle of incidence.
pub(super) fn sweep(records: &[Record]) -> Result<String, CliError> {
    let restitution =
        records.iter().filter_map(|record| Some((record.angle?, record.restitution()?)));
    let velocity =
        records.iter().filter_map(|record| Some((record.angle?, record.after.body_1.velocity[0])));
    let spin =
        records.iter().filter_map(|record| Some((record.angle?, record.after.body_1.spin[1])));
    let panels = [
        panel("R_x", restitution.collect()),
        panel("v_x of body 1 afterwards / m/s", velocity.collect()),
        panel("spin_y of body 1 afterwards / rad/s", spin.collect()),
    ];
    drawn("Sweep over the angle of incidence", &panels)
}

fn panel(label: &str, points: Vec<(f64, f64)>) -> Panel {
    let mut panel = Panel::new(Axis::linear("angle from the normal / °"), Axis::linear(label));
    panel.add(match points.len() {
        0..=20 => Series::markers("", Marker::Dot, points.clone()),
        _ => Series::line("", points.clone()),
    });
    if (2..=20).contains(&points.len()) {
        panel.add(Series::line("", points).coloured(0));
    }
    panel
}
