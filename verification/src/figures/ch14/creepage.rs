//! Fig. 14.30: force and moment of a contact that slides and spins as a whole.

use crate::{Absolute, Figure, FigureResult, Panel, Series, linspace};
use carom_classic::rigid_slip::{RigidSlip, pole_of, spin_about};
use carom_laws::ellipse::ContactEllipse;
use std::f64::consts::PI;

/// Pole distance, angle in degrees, force over f F_z and moment for a/b = 1/10.
const REFERENCE: [[f64; 4]; 3] = [
    [0.0, 0.0, 0.0, 1.204_820],
    [2.0, 0.0, 0.815_282, 0.450_986],
    [2.0, 90.0, 0.848_376, 0.719_476],
];

fn load(
    ellipse: &ContactEllipse,
    distance: f64,
    degrees: f64,
) -> Result<RigidSlip, carom_special::RangeError> {
    let [x, y] = pole_of(ellipse, distance, degrees.to_radians());
    spin_about(ellipse, x, y)
}

fn force(load: &RigidSlip) -> f64 {
    load.force_x.hypot(load.force_y)
}

/// f of the circle in closed form.
fn circle_force(v: f64) -> f64 {
    if v <= 1.0 {
        return 3.0 * PI / 8.0 * (v - v * v * v / 4.0);
    }
    let (arc, root) = ((1.0 / v).asin(), (v * v - 1.0).sqrt());
    3.0 / (4.0 * v) * ((v * v - v.powi(4) / 4.0) * arc + 0.75 * root + root.powi(3) / 4.0)
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("a/b", "1/10 (full), circle (broken)");
    figure.assumed("v_K, α", "0 to 6; 0°, 45°, 90°");
    let (slender, circle) = (ContactEllipse::new(1.0, 10.0)?, ContactEllipse::circle(1.0)?);
    let distances = linspace(0.0, 6.0, 121);
    let mut forces = Panel::new("v_K", "F/(f F_z)");
    let mut moments = Panel::new("v_K", "M_z/(f F_z √(ab))");
    for degrees in [0.0, 45.0, 90.0] {
        let curve: Result<Vec<_>, _> =
            distances.iter().map(|&v| load(&slender, v, degrees).map(|load| (v, load))).collect();
        let curve = curve?;
        forces.add(Series::line(
            format!("α = {degrees}°"),
            curve.iter().map(|(v, l)| (*v, force(l))),
        ));
        moments.add(Series::line(
            format!("α = {degrees}°"),
            curve.iter().map(|(v, l)| (*v, l.torque)),
        ));
    }
    let round: Result<Vec<_>, _> =
        distances.iter().map(|&v| load(&circle, v, 0.0).map(|load| (v, load))).collect();
    let round = round?;
    forces.add(Series::dashed("circle", round.iter().map(|(v, l)| (*v, force(l)))));
    moments.add(Series::dashed("circle", round.iter().map(|(v, l)| (*v, l.torque))));
    figure.panel(forces);
    figure.panel(moments);
    let pairs = round.iter().map(|(v, l)| (force(l), circle_force(*v)));
    figure.all_close("force of the circle", pairs, Absolute(1e-12)).source("closed form");
    let inside = round
        .iter()
        .filter(|(v, _)| *v <= 1.0)
        .map(|(v, l)| (l.torque, 3.0 * PI / 16.0 * (1.0 - v * v + 0.375 * v.powi(4))));
    figure
        .all_close("moment of the circle, pole inside", inside, Absolute(1e-13))
        .source("closed form");
    let mut pairs = Vec::new();
    for [v, degrees, f, m] in REFERENCE {
        let load = load(&slender, v, degrees)?;
        pairs.push((force(&load), f));
        pairs.push((load.torque, m));
    }
    figure
        .all_close("a/b = 1/10", pairs, Absolute(6e-7))
        .source("chord integrals at twice the order");
    let excess = round.iter().map(|(_, l)| force(l)).fold(0.0, f64::max);
    figure.at_most("the force does not exceed f F_z", excess, 1.0).source("Coulomb's law");
    let far = load(&slender, 1e6, 45.0)?;
    figure.close("a far pole slides only", force(&far), 1.0, Absolute(1e-10)).source("limit");
    figure.deviation("m_z over f F_z", "m_z over f F_z √(ab)", "norm of (14.3)");
    Ok(figure)
}
