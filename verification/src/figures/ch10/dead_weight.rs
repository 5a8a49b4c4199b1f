//! Hertz's table at (10.42): steel spheres on a rigid plane under their own weight.

use std::f64::consts::PI;

use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::hertz::Hertz;

use crate::{Cell, Claim, Figure, FigureResult, Table, Tolerance};

const YOUNG: f64 = 210_000.0; // N/mm^2
const POISSON: f64 = 0.3;
const WEIGHT: f64 = 7.85e-6 * 9.81; // N/mm^3

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("a", "R^(4/3)/1000 in mm");
    figure.assumed("steel", "E = 210 GPa, ν = 0.3, ρ = 7850 kg/m³, g = 9.81 m/s²");
    let heads = ["sphere radius R", "a (thesis, mm)", "a/R (thesis)", "a (steel, mm)"];
    let mut table = Table::new("Contact radius under dead weight", heads);
    let mut ratios = Vec::new();
    let mut computed = Vec::new();
    for (name, radius) in [("1 mm", 1.0), ("1 m", 1e3), ("1 km", 1e6), ("1000 km", 1e9)] {
        let thesis = libm::pow(radius, 4.0 / 3.0) / 1000.0;
        let steel = contact_radius(radius)?;
        ratios.push(thesis / radius);
        computed.push((steel / libm::pow(radius, 4.0 / 3.0), libm::cbrt(scale())));
        table.row([
            Cell::Text(name.to_owned()),
            Cell::Number(thesis),
            Cell::Number(thesis / radius),
            Cell::Number(steel),
        ]);
    }
    figure.table(table);
    let stated = [1e-3, 1e-2, 1e-1, 1.0];
    figure.claim(
        Claim::all_close("a/R", ratios.into_iter().zip(stated), Tolerance::Relative(1e-13))
            .source("Hertz's table"),
    );
    figure.claim(
        Claim::all_close(
            "a³ = π R⁴ γ (1 - ν²)/E by the contact law",
            computed.iter().copied(),
            Tolerance::Relative(1e-13),
        )
        .source("(10.42), corrected"),
    );
    figure.claim(
        Claim::close("steel's coefficient", computed[0].0, 1e-3, Tolerance::Relative(0.02))
            .source("(10.42): 1/1000"),
    );
    figure.deviation("(10.42): a³ = R⁴γ(1 - ν²)/E", "π R⁴γ(1 - ν²)/E", "without π 0.69/1000");
    figure.deviation("(10.42): a³ = R^(4/3)/1000", "a = R^(4/3)/1000", "misprint");
    Ok(figure)
}

fn scale() -> f64 {
    PI * WEIGHT * (1.0 - POISSON * POISSON) / YOUNG
}

fn contact_radius(radius: f64) -> Result<f64, Box<dyn std::error::Error + Send + Sync>> {
    let steel = Material::from_shear(YOUNG / (2.0 * (1.0 + POISSON)), POISSON)?;
    let gap = RelativeCurvature::new(PrincipalRadii::sphere(radius)?, PrincipalRadii::PLANE, 0.0)?;
    let hertz = Hertz::new(gap, MaterialPair::new(steel, Material::RIGID)?)?;
    let weight = 4.0 / 3.0 * PI * radius.powi(3) * WEIGHT;
    Ok(hertz.at_force(weight)?.ellipse.semi_axis_a())
}
