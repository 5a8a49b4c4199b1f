//! A history as SVG.

use super::view::Step;
use crate::command::plot::{Course, drawn};
use crate::error::CliError;

/// Loads and sizes against the step, and force against shift.
pub(super) fn draw(history: &[Step]) -> Result<String, CliError> {
    let course = Course { records: history, label: "step", at: |step| step.step as f64 };
    let panels = [
        course.panel(
            "loads on body 1",
            "force / N",
            &[("F_x", |s| s.f_x), ("F_y", |s| s.f_y), ("F_z", |s| s.f_z)],
        ),
        course.paths(
            "loops",
            ["shift / m", "force / N"],
            &[("F_x against ξ", |s| s.xi, |s| s.f_x), ("F_y against η", |s| s.eta, |s| s.f_y)],
        ),
        course.panel(
            "contact and stick ellipse",
            "semi-axis / m",
            &[
                ("a", |s| s.semi_axis_a),
                ("b", |s| s.semi_axis_b),
                ("a, stick", |s| s.stick_semi_axis_a),
                ("b, stick", |s| s.stick_semi_axis_b),
            ],
        ),
        course.panel(
            "energy",
            "energy / J",
            &[("stored", |s| s.stored_energy), ("dissipated", |s| s.dissipated)],
        ),
    ];
    drawn("Load history", &panels)
}
