//! A history as SVG.

use super::view::Step;
use crate::error::CliError;
use carom_plot::{Axis, Panel, Series, render};

/// Loads and sizes against the step, and force against shift.
pub(super) fn draw(history: &[Step]) -> Result<String, CliError> {
    let by_step = |title: &str, y: &str, lines: Vec<Series>| {
        panel(Panel::new(Axis::linear("step"), Axis::linear(y)).titled(title), lines)
    };
    let line = |label: &str, value: fn(&Step) -> f64| {
        Series::line(label, history.iter().map(|step| (step.step as f64, value(step))))
    };
    let loop_of = |label: &str, x: fn(&Step) -> f64, y: fn(&Step) -> f64| {
        Series::line(label, history.iter().map(|step| (x(step), y(step))))
    };
    let panels = [
        by_step(
            "loads on body 1",
            "force / N",
            vec![
                line("F_x", |step| step.f_x),
                line("F_y", |step| step.f_y),
                line("F_z", |step| step.f_z),
            ],
        ),
        panel(
            Panel::new(Axis::linear("shift / m"), Axis::linear("force / N")).titled("loops"),
            vec![
                loop_of("F_x against ξ", |step| step.xi, |step| step.f_x),
                loop_of("F_y against η", |step| step.eta, |step| step.f_y),
            ],
        ),
        by_step(
            "contact and stick ellipse",
            "semi-axis / m",
            vec![
                line("a", |step| step.semi_axis_a),
                line("b", |step| step.semi_axis_b),
                line("a, stick", |step| step.stick_semi_axis_a),
                line("b, stick", |step| step.stick_semi_axis_b),
            ],
        ),
        by_step(
            "energy",
            "energy / J",
            vec![
                line("stored", |step| step.stored_energy),
                line("dissipated", |step| step.dissipated),
            ],
        ),
    ];
    Ok(render("Load history", &panels)?)
}

fn panel(mut panel: Panel, lines: Vec<Series>) -> Panel {
    lines.into_iter().for_each(|line| panel.add(line));
    panel
}
