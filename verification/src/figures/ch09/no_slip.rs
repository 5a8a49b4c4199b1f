//! Fig. 9.2: the restitution of an impact without slip.

use carom_halfspace::Material;
use carom_impact::closed_form::{ImpactConstants, restitution_without_slip};
use carom_impact::restitution::of_groups;
use carom_special::roots::{Bracket, brent};

use crate::reference::rows;
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Relative, Series, linspace};

fn by_phi(phi: f64) -> f64 {
    restitution_without_slip((phi * phi - 1.0) / 120.0)
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.derived("φ", "sqrt(1 + 120 D_xx c_x/(D_zz c_z))");
    figure.derived("spheres", "D_xx/D_zz = 7/2, ν = 0 to 1/2: φ = 20.518 to 16.763");
    figure.derived("ellipsoids", "φ from sqrt 61 to sqrt 721 (15.9)");
    let curve: Vec<(f64, f64)> =
        linspace(7.0, 27.0, 401).into_iter().map(|phi| (phi, by_phi(phi))).collect();
    let mut panel = Panel::new("φ", "R_x").titled("Without slip (9.46)");
    panel.add(Series::line("R_x(φ)", curve));
    let spheres: Vec<(f64, f64)> = linspace(0.0, 0.5, 6)
        .into_iter()
        .map(|nu| {
            let chi = crate::spheres::chi(nu);
            let phi = (1.0 + 120.0 * chi).sqrt();
            (phi, by_phi(phi))
        })
        .collect();
    panel.add(Series::markers("spheres, ν = 0, 0.1 .. 0.5", Marker::Circle, spheres));
    let ends = [61.0_f64.sqrt(), 721.0_f64.sqrt()].map(|phi| (phi, by_phi(phi)));
    panel.add(Series::markers("ends of the ellipsoids", Marker::Triangle, ends));
    figure.panel(panel);

    let table = rows::<2>(include_str!("../../../data/impact/no_slip.csv"))?;
    let pairs = table.iter().map(|[chi, r]| (restitution_without_slip(*chi), *r));
    figure
        .all_close("nine values", pairs, Absolute(1e-13))
        .source("(9.46) in 25 digits by an independent program");
    let walked: Result<Vec<(f64, f64)>, _> = table
        .iter()
        .map(|[chi, _]| of_groups(*chi, 1e-9).map(|r| (r, restitution_without_slip(*chi))))
        .collect();
    figure
        .all_close("limit of the event-driven impact, ψ = 1e-9", walked?, Absolute(1e-8))
        .source("integration through partial slip");
    figure
        .all_close(
            "ends R_x(sqrt 61), R_x(sqrt 721)",
            ends.map(|(_, r)| r).into_iter().zip([0.619_660_3, 0.512_442_9]),
            Absolute(5e-8),
        )
        .source("independent program");
    for (low, high, zero) in [(17.0, 18.0, 17.270_338), (24.0, 25.0, 24.400_798)] {
        let root = brent(by_phi, Bracket::new(low, high)?, 0.0)?.position;
        figure
            .close(format!("zero near {zero}"), root, zero, Absolute(1e-6))
            .source("independent program");
    }
    let (at, least) = linspace(20.0, 22.0, 20_001)
        .into_iter()
        .map(|phi| (phi, by_phi(phi)))
        .fold((0.0, f64::INFINITY), |best, point| if point.1 < best.1 { point } else { best });
    figure.close("least R_x", least, -0.390_03, Absolute(1e-5)).source("independent program");
    figure.close("φ of the least R_x", at, 20.82, Absolute(0.01)).source("independent program");
    constants_claim(&mut figure)?;
    figure
        .all_close(
            "full reversal at φ = 11 and 31",
            [11.0, 31.0].map(|phi| (by_phi(phi), 1.0)),
            Absolute(1e-14),
        )
        .source("poles of Γ((11 - φ)/20)");
    figure.deviation("fig. 9.1 named in section 15.4", "fig. 9.2", "slip of the text");
    Ok(figure)
}

/// (9.49): the constants of two spheres, and χ of the text.
fn constants_claim(figure: &mut Figure) -> Result<(), Failure> {
    let (masses, radii, shear) = ([0.4, 0.1], [0.03, 0.015], 2e9);
    let mut pairs = Vec::new();
    for nu in [0.0, 0.2, 0.5] {
        let body = Material::from_shear(shear, nu)?;
        let found = ImpactConstants::of_spheres(masses, radii, [body, body])?;
        // Mindlin and Hertz: 8 G* sqrt(R*), 2 E* sqrt(R*) with R* = 10 mm.
        let root = 0.1;
        pairs.extend([
            (found.d_zz, 12.5),
            (found.d_xx, 43.75),
            (found.d_yy, 43.75),
            (found.c_x / (8.0 * shear / (2.0 * (2.0 - nu)) * root), 1.0),
            (found.c_z / (2.0 * shear / (1.0 - nu) * root), 1.0),
        ]);
    }
    figure
        .all_close("constants of two unlike spheres, three ν", pairs, Relative(1e-14))
        .source("1/m₁ + 1/m₂, 7/2 of it; Hertz's and Mindlin's stiffness with E*, G*, R*");
    Ok(())
}
