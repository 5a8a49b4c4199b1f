//! Fig. 3.3: the tangential stress of Cattaneo and Mindlin for several shifts.

use crate::{Axis, Claim, Figure, FigureResult, Panel, Series, Tolerance, linspace};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::shift::{CattaneoMindlin, ShiftState};
use carom_laws::stiffness::ContactStiffness;

const SHIFTS: [f64; 5] = [0.2, 0.4, 0.6, 0.8, 1.0];

fn state(part: f64) -> Result<ShiftState, Box<dyn std::error::Error + Send + Sync>> {
    let law = CattaneoMindlin::new(ContactStiffness::new(1.0, 1.0, 1.0)?, Friction::new(1.0)?);
    Ok(law.at_shift(1.0, part, 0.0)?)
}

/// sigma_zx over f sigma_z0 on y = 0.
fn stress(state: &ShiftState, ellipse: &ContactEllipse, x: f64) -> f64 {
    let peak = 1.5 * state.normal_force / ellipse.area();
    state.traction(ellipse, x, 0.0)[0] / peak
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("c_x ξ/(f c_z ζ)", "0.2, 0.4, 0.6, 0.8, 1");
    figure.assumed("axes", "x/a, σ_zx/(f σ_z0), y = 0");
    let ellipse = ContactEllipse::new(1.0, 2.0)?;
    let mut panel = Panel::new(Axis::linear("x/a"), Axis::linear("σ_zx/(f σ_z0)"));
    let xs = linspace(-1.0, 1.0, 401);
    let (mut excess, mut below) = (0.0_f64, 0.0_f64);
    let mut radii = Vec::new();
    let mut forces = Vec::new();
    for part in SHIFTS {
        let state = state(part)?;
        let value = |&x: &f64| (x, stress(&state, &ellipse, x));
        panel.add(Series::line(format!("{part}"), xs.iter().map(value)));
        for &x in &xs {
            let limit = (1.0 - x * x).max(0.0).sqrt();
            let got = stress(&state, &ellipse, x);
            excess = excess.max(got - limit);
            if x.abs() >= state.stick_radius() {
                below = below.max(limit - got);
            }
        }
        radii.push((state.stick_radius().powi(2), 1.0 - part));
        // The force as the integral of the stress over the ellipse: int 2 q sigma dq.
        let n = 20_000;
        let mean = (0..n).map(|i| {
            let q = (f64::from(i) + 0.5) / f64::from(n);
            2.0 * q * stress(&state, &ellipse, q)
        });
        let force = 1.5 * mean.sum::<f64>() / f64::from(n);
        forces.push((force, 1.0 - (1.0 - part).powf(1.5)));
    }
    figure.panel(panel);
    figure.claim(Claim::at_most("σ does not exceed f p_z", excess, 1e-15).source("(5.23)"));
    figure.claim(Claim::at_most("σ = f p_z in the slip area", below, 1e-15).source("(5.24)"));
    figure.claim(
        Claim::all_close("(a*/a)² = 1 − c_x ξ/(f c_z ζ)", radii, Tolerance::Absolute(1e-15))
            .source("(5.26)"),
    );
    figure.claim(
        Claim::all_close("F_x = f F_z (1 − (a*/a)³)", forces, Tolerance::Absolute(1e-6))
            .source("quadrature of the stress"),
    );
    let inner = state(0.6)?;
    let edge = inner.stick_radius();
    let slope = (stress(&inner, &ellipse, edge) - stress(&inner, &ellipse, edge - 1e-10)) / 1e-10;
    figure.claim(
        Claim::at_least("the inner slope at a* is vertical", slope, 1e3).source("text of 3.2"),
    );
    Ok(figure)
}
