//! Tangent of the angle of rebound against that of incidence, as Maw, Barber and Fawcett (1976)
//! plotted it: psi_2 against psi_1, both of the contact point and over f kappa.

use carom_halfspace::Material;
use carom_impact::closed_form::{phi, restitution_without_slip};
use carom_impact::oblique::{Groups, ObliqueImpact};
use carom_impact::restitution::of_groups;
use carom_impact::{Body, Collision, Motion};
use carom_laws::friction::Friction;
use carom_special::roots::try_bisect;
use rayon::prelude::*;

use crate::spheres::{chi, kappa};
use crate::spring_impact;
use crate::{Absolute, Axis, Failure, Figure, FigureResult, Marker, Panel, Series, linspace};

const RATIOS: [f64; 4] = [0.0, 0.25, 0.3, 0.5];

/// psi_2 = -psi_1 R_x.
fn rebound(nu: f64, psi: f64) -> Result<f64, Failure> {
    Ok(-psi * of_groups(chi(nu), psi)?)
}

fn curves(figure: &mut Figure) -> Result<(), Failure> {
    let mut panel = Panel::new(
        Axis::linear("ψ₁ = v_t/(f κ v_n), incidence").between(0.0, 8.0),
        Axis::linear("ψ₂, rebound").between(-2.5, 2.5),
    )
    .titled("Solid spheres, by the exact walk");
    let psis = linspace(0.0, 8.0, 241);
    for (i, nu) in RATIOS.into_iter().enumerate() {
        let curve: Result<Vec<f64>, Failure> =
            psis.par_iter().map(|&psi| rebound(nu, psi)).collect();
        let label = format!("ν = {nu}, χ/2 = {:.4}", 0.5 * chi(nu));
        panel.add(Series::line(label, psis.iter().copied().zip(curve?)).coloured(i));
    }
    let edges = RATIOS.map(|nu| (2.0 * chi(nu) - 1.0, -1.0));
    panel.add(Series::markers("slides throughout from here on", Marker::Circle, edges).coloured(4));
    panel.add(Series::dotted("sticks at touch up to here", [(1.0, -2.5), (1.0, 2.5)]).coloured(4));
    panel.add(Series::dashed("no friction", [(0.0, 0.0), (2.5, 2.5)]).coloured(5));
    figure.panel(panel);
    Ok(())
}

/// The same in degrees, for one material and several coefficients of friction.
fn degrees(figure: &mut Figure) -> Result<(), Failure> {
    let nu = 0.3;
    let mut panel = Panel::new("incidence / degrees", "rebound / degrees")
        .titled("Angles at the contact point, ν = 0.3");
    let angles = linspace(0.0, 85.0, 171);
    for friction in [0.05, 0.1, 0.3, 1.0] {
        let curve: Result<Vec<f64>, Failure> = angles
            .par_iter()
            .map(|angle| {
                let limit = friction * kappa(nu);
                let psi = libm::tan(angle.to_radians()) / limit;
                Ok(libm::atan(limit * rebound(nu, psi)?).to_degrees())
            })
            .collect();
        panel.add(Series::line(format!("f = {friction}"), angles.iter().copied().zip(curve?)));
    }
    figure.panel(panel);

    // A glass ball on a plate of the same glass, with all its dimensions.
    let glass = Material::from_young(70e9, nu)?;
    let mut pairs = Vec::new();
    for degrees in [10.0_f64, 25.0, 40.0, 60.0] {
        let slope = libm::tan(degrees.to_radians());
        let motion = Motion::new([2.0 * slope, 0.0, -2.0], [0.0; 3])?;
        let ball = Body::sphere(0.004, glass, 6.7e-4)?.moving(motion);
        let outcome = Collision::new(ball, Body::plane(glass), Friction::new(0.3)?)?.solve()?;
        let after = outcome.rebound().ok_or("the ball falls on the plate")?.contact_velocity_after;
        let limit = 0.3 * kappa(nu);
        pairs.push((-after.x / (2.0 * limit), rebound(nu, slope / limit)?));
    }
    figure
        .all_close("a glass ball, with dimensions", pairs, Absolute(1e-11))
        .source("scaling by f, κ and v_n");
    Ok(())
}

fn limit_claims(figure: &mut Figure) -> Result<(), Failure> {
    let (mut slopes, mut sliding, mut edges) = (Vec::new(), Vec::new(), Vec::new());
    for nu in RATIOS {
        slopes.push((rebound(nu, 1e-7)? / 1e-7, -restitution_without_slip(chi(nu))));
        for psi in [2.0 * chi(nu) - 1.0, 2.0 * chi(nu), 9.0, 40.0] {
            sliding.push((rebound(nu, psi)?, psi - 2.0 * chi(nu)));
        }
        // Just before, the sliding stops at the very end.
        let before = 2.0 * chi(nu) - 1.01;
        let walk = ObliqueImpact::new(Groups::new(chi(nu), before)?)?;
        let stop = walk.phases().get(1).ok_or("the sliding does not stop")?.start;
        edges.push((stop, (chi(nu) - before) / (chi(nu) - 1.0)));
    }
    figure.all_close("slope at ψ₁ = 0, without slip", slopes, Absolute(1e-6)).source("(9.46)");
    figure
        .all_close(
            "ψ₂ = ψ₁ - 2χ from ψ₁ = 2χ - 1 on, with the zero at 2χ",
            sliding,
            Absolute(1e-12),
        )
        .source("complete sliding; Maw, Barber and Fawcett's 4χ - 1 and 4χ");
    figure
        .all_close("just below, sliding stops at w", edges, Absolute(1e-12))
        .source("w = (χ - ψ)/(χ - 1)");
    Ok(())
}

fn root(nu: f64, low: f64, high: f64) -> Result<f64, Failure> {
    let below = rebound(nu, low)? < 0.0;
    let same = |psi: f64| Ok::<_, Failure>((rebound(nu, psi)? < 0.0) == below);
    let [low, high] = try_bisect([low, high], 48, same)?;
    Ok(0.5 * (low + high))
}

fn zero_claims(figure: &mut Figure) -> Result<(), Failure> {
    let mut zeros = Vec::new();
    for nu in [0.0, 0.25, 0.3] {
        let psi = root(nu, 0.3, 2.5)?;
        zeros.push((psi * spring_impact::restitution(chi(nu), psi), 0.0));
    }
    figure
        .all_close("first zero, ν = 0, 0.25, 0.3", zeros, Absolute(1e-5))
        .source("ψ₂ there by springs with sliders, stepped in time");
    // The sign at small psi_1 changes where R_x without slip does, at phi = 17.270338.
    let returns = |nu: f64| Ok::<_, Failure>(rebound(nu, 1e-7)? > 0.0);
    let [low, high] = try_bisect([0.3, 0.5], 48, returns)?;
    figure
        .close(
            "small ψ₁ come back forward up to ν = 0.4525: φ there",
            phi(chi(0.5 * (low + high))),
            17.270_338,
            Absolute(2e-6),
        )
        .source("zero of (9.46) by an independent program");
    Ok(())
}

fn value_claims(figure: &mut Figure) -> Result<(), Failure> {
    let printed = [
        (0.25, 0.0416),
        (0.5, 0.0478),
        (1.0, -0.0597),
        (2.0, -0.8372),
        (3.0, -1.3797),
        (3.5, -1.4773),
        (4.0, -1.4365),
        (4.5, -1.2176),
        (5.0, -0.7647),
        (6.0, 0.2353),
    ];
    let pairs: Result<Vec<(f64, f64)>, Failure> =
        printed.iter().map(|&(psi, value)| Ok((rebound(0.3, psi)?, value))).collect();
    figure
        .all_close("ten values, ν = 0.3", pairs?, Absolute(5.1e-5))
        .source("independent program, four decimals");
    let mut stepped = Vec::new();
    for nu in RATIOS {
        for psi in [0.15, 0.6, 0.95, 1.4, 2.6, 3.8, 5.5] {
            stepped.push((rebound(nu, psi)?, -psi * spring_impact::restitution(chi(nu), psi)));
        }
    }
    figure
        .all_close("28 values, four ν", stepped, Absolute(2e-5))
        .source("springs with sliders, stepped in time");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("ψ₁, ψ₂", "κ = (2 - ν)/(2(1 - ν)), solid spheres (Maw, Barber, Fawcett 1976)");
    figure.assumed("ν", "0, 1/4, 0.3, 1/2");
    curves(&mut figure)?;
    degrees(&mut figure)?;
    limit_claims(&mut figure)?;
    zero_claims(&mut figure)?;
    value_claims(&mut figure)?;
    figure.deviation(
        "curves by steps in time and concentric rings (1976), without a table",
        "the exact walk; their points are not available to the project",
        "the paper prints curves only",
    );
    Ok(figure)
}
