//! The course of an impact, or a sweep, as SVG.

use super::view::{Instant, Record};
use crate::error::CliError;
use carom_plot::{Axis, Marker, Panel, Series, render};

/// Instants of a drawn course.
pub(super) const INSTANTS: usize = 401;

/// Forces, displacements and radii against time.
pub(super) fn course(history: &[Instant]) -> Result<String, CliError> {
    let line = |label: &str, value: fn(&Instant) -> f64| {
        Series::line(label, history.iter().map(|instant| (instant.time, value(instant))))
    };
    let panel = |title: &str, y: &str, lines: Vec<Series>| {
        let mut panel = Panel::new(Axis::linear("time / s"), Axis::linear(y)).titled(title);
        lines.into_iter().for_each(|line| panel.add(line));
        panel
    };
    let panels = [
        panel(
            "forces on body 1",
            "force / N",
            vec![
                line("normal", |instant| instant.normal_force),
                line("tangential", |instant| instant.tangential_force),
            ],
        ),
        panel(
            "displacements",
            "displacement / m",
            vec![
                line("approach", |instant| instant.approach),
                line("shift", |instant| instant.shift),
            ],
        ),
        panel(
            "areas",
            "radius / m",
            vec![
                line("contact", |instant| instant.contact_radius),
                line("stick", |instant| instant.stick_radius),
            ],
        ),
    ];
    Ok(render("Course of the impact", &panels)?)
}

/// Restitution, velocity and spin of body 1 against the angle of incidence.
pub(super) fn sweep(records: &[Record]) -> Result<String, CliError> {
    let restitution = records
        .iter()
        .filter_map(|record| Some((record.angle?, record.rebound.as_ref()?.restitution)));
    let velocity =
        records.iter().filter_map(|record| Some((record.angle?, record.after.body_1.velocity[0])));
    let spin =
        records.iter().filter_map(|record| Some((record.angle?, record.after.body_1.spin[1])));
    let panels = [
        panel("R_x", restitution.collect()),
        panel("v_x of body 1 afterwards / m/s", velocity.collect()),
        panel("spin_y of body 1 afterwards / rad/s", spin.collect()),
    ];
    Ok(render("Sweep over the angle of incidence", &panels)?)
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
