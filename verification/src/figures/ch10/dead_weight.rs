//! Hertz's table at (10.42): steel spheres on a rigid plane under their own weight.

use std::f64::consts::PI;

use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::hertz::Hertz;
use carom_special::quadrature::GaussLegendre;

use crate::{Cell, Failure, Figure, FigureResult, Relative, Table};

const YOUNG: f64 = 210_000.0; // N/mm^2
const POISSON: f64 = 0.3;
const WEIGHT: f64 = 7.85e-6 * 9.81; // N/mm^3

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("a", "R^(4/3)/1000 in mm");
    figure.assumed("steel", "E = 210 GPa, ν = 0.3, ρ = 7850 kg/m³, g = 9.81 m/s²");
    let heads = ["sphere radius R", "a (thesis, mm)", "a/R (thesis)", "a (steel, mm)"];
    let mut table = Table::new("Contact radius under dead weight", heads);
    let mut shares = Vec::new();
    let mut computed = Vec::new();
    for (name, radius) in [("1 mm", 1.0), ("1 m", 1e3), ("1 km", 1e6), ("1000 km", 1e9)] {
        let thesis = libm::pow(radius, 4.0 / 3.0) / 1000.0;
        let steel = contact_radius(radius)?;
        shares.push(steel / radius);
        computed.push((steel / libm::pow(radius, 4.0 / 3.0), libm::cbrt(scale())));
        table.row([
            Cell::Text(name.to_owned()),
            Cell::Number(thesis),
            Cell::Number(thesis / radius),
            Cell::Number(steel),
        ]);
    }
    figure.table(table);
    let growth = shares.windows(2).map(|pair| (pair[1] / pair[0], 10.0));
    figure
        .all_close("a/R grows tenfold from line to line", growth, Relative(1e-13))
        .source("Hertz's table: radii a thousandfold, a/R = R^(1/3)/1000");
    figure
        .all_close(
            "a³ = π R⁴ γ (1 - ν²)/E by the contact law",
            computed.iter().copied(),
            Relative(1e-13),
        )
        .source("(10.42), corrected");
    figure
        .close("steel's coefficient", computed[0].0, 1e-3, Relative(0.02))
        .source("(10.42): 1/1000");
    energy_claim(&mut figure)?;
    figure.deviation("(10.42): a³ = R⁴γ(1 - ν²)/E", "π R⁴γ(1 - ν²)/E", "without π 0.69/1000");
    figure.deviation("(10.42): a³ = R^(4/3)/1000", "a = R^(4/3)/1000", "misprint");
    Ok(figure)
}

/// Energy, stiffness and greatest pressure of a ball of 1 m under its weight.
fn energy_claim(figure: &mut Figure) -> Result<(), Failure> {
    let radius = 1e3;
    let (hertz, weight) = (contact(radius)?, weight(radius));
    let state = hertz.at_force(weight)?;
    // Hertz's formulas with E* and R.
    let modulus = YOUNG / (1.0 - POISSON * POISSON);
    let approach = libm::pow(0.75 * weight / (modulus * radius.sqrt()), 2.0 / 3.0);
    let pressure = libm::cbrt(6.0 * weight * modulus * modulus / (radius * radius)) / PI;
    figure
        .all_close(
            "approach and greatest pressure at R = 1 m",
            [(state.approach, approach), (state.peak_pressure, pressure)],
            Relative(1e-13),
        )
        .source("Hertz's formulas with E* and R");
    // The force as a power of the approach: smooth in its root.
    let rule = GaussLegendre::new(8)?;
    let work = rule.integrate(0.0, approach.sqrt(), |root| {
        4.0 / 3.0 * modulus * radius.sqrt() * root * root * root * 2.0 * root
    });
    figure
        .close(
            "elastic energy of the ball at rest on the plane",
            hertz.normal_energy(state.approach),
            work,
            Relative(1e-13),
        )
        .source("∫F dζ by quadrature of Hertz's force");
    figure
        .close(
            "stiffness under the weight",
            state.normal_stiffness,
            2.0 * modulus * (radius * approach).sqrt(),
            Relative(1e-13),
        )
        .source("2 E* a, a flat punch of the contact's size");
    Ok(())
}

fn scale() -> f64 {
    PI * WEIGHT * (1.0 - POISSON * POISSON) / YOUNG
}

fn contact(radius: f64) -> Result<Hertz, Failure> {
    let steel = Material::from_shear(YOUNG / (2.0 * (1.0 + POISSON)), POISSON)?;
    let gap = RelativeCurvature::new(PrincipalRadii::sphere(radius)?, PrincipalRadii::PLANE, 0.0)?;
    Ok(Hertz::new(gap, MaterialPair::new(steel, Material::RIGID)?)?)
}

fn weight(radius: f64) -> f64 {
    4.0 / 3.0 * PI * radius.powi(3) * WEIGHT
}

fn contact_radius(radius: f64) -> Result<f64, Failure> {
    Ok(contact(radius)?.at_force(weight(radius))?.ellipse.semi_axis_a())
}
