//! Figs. 7.9 to 7.11: torsion of an ellipse by the exponential law.

use super::super::mesh::{APPROACH, Mesh};
use crate::{
    Absolute, Axis, Failure, Figure, FigureResult, Panel, Relative, Series, linspace, logspace,
};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::law::Shift;
use carom_laws::torsion::adhesion::{AdhesiveTorsion, sliding_torque_arm};
use carom_laws::torsion::ellipse::EllipseTorsion;
use carom_laws::torsion::lubkin::{Lubkin, SLIDING_TORQUE};
use carom_special::elliptic::complete;
use std::f64::consts::PI;

fn pair(nu: f64) -> Result<MaterialPair, carom_special::RangeError> {
    MaterialPair::new(Material::from_shear(1.0, nu)?, Material::RIGID)
}

/// delta_T of (7.65): M_zA' = (3/8) G b^3 E delta_T, b the larger semi-axis.
fn delta(ratio: f64, nu: f64) -> Result<f64, carom_special::RangeError> {
    let ellipse = ContactEllipse::new(ratio, 1.0)?;
    let stiffness = AdhesiveTorsion::new(ellipse, pair(nu)?).stiffness();
    Ok(stiffness / (0.375 * complete::e(ellipse.axis_ratio())))
}

/// a/b, nu, delta_T to 15 digits, by 40-digit arithmetic.
const DELTA: [[f64; 3]; 5] = [
    [1.0, 0.3, 9.054_147_873_672_268],
    [0.5, 0.0, 4.945_209_787_844_932],
    [0.5, 0.3, 5.156_093_954_721_647],
    [0.1, 0.3, 2.546_983_452_061_335],
    [0.1, 0.5, 3.004_681_323_044_792],
];

pub(super) fn draw_stiffness() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("ν", "0, 0.25, 0.5");
    let mut panel = Panel::new(Axis::log("a/b"), "δ_T");
    for nu in [0.0, 0.25, 0.5] {
        let curve: Result<Vec<_>, _> = logspace(0.05, 1.0, 61)
            .into_iter()
            .map(|ratio| delta(ratio, nu).map(|value| (ratio, value)))
            .collect();
        panel.add(Series::line(format!("ν = {nu}"), curve?));
    }
    figure.panel(panel);
    let mut pairs = Vec::new();
    for [ratio, nu, want] in DELTA {
        pairs.push((delta(ratio, nu)?, want));
    }
    figure.all_close("δ_T at five ellipses", pairs, Relative(1e-14)).source("40-digit arithmetic");
    let mut circle = Vec::new();
    for nu in [0.0, 0.2, 0.5] {
        circle.push((delta(1.0, nu)?, 256.0 / (9.0 * PI)));
    }
    figure
        .all_close("256/(9π) for the circle, whatever ν", circle, Relative(1e-14))
        .source("Mindlin's 16 G a³/3");
    Ok(figure)
}

/// The law of an ellipse with f F_z = 1 and the larger semi-axis 1.
fn law(ratio: f64, nu: f64) -> Result<EllipseTorsion, carom_special::RangeError> {
    EllipseTorsion::of_contact(ContactEllipse::new(ratio, 1.0)?, pair(nu)?, 1.0)
}

pub(super) fn draw_loading() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("a/b", "1 and 10");
    figure.assumed("G b²/(f F_z)", "1, ν = 0; torque over f F_z b");
    figure.assumed("numerical markers", "10 steps of 1.6° (circle, ζ/a = 0.1) and 0.2° (a/b = 10)");
    let mut panel = Panel::new("G b² β/(f F_z)", "M_z/(f F_z b)");
    for ratio in [1.0, 0.1] {
        let mut torsion = law(ratio, 0.0)?;
        let mut curve = Vec::new();
        for twist in linspace(0.0, 1.0, 101) {
            torsion.advance(twist)?;
            curve.push((twist, torsion.torque()));
        }
        panel.add(Series::line(format!("(7.65), ratio {}", 1.0 / ratio), curve));
    }
    let exact: Result<Vec<_>, _> = linspace(0.0, 1.0, 26)
        .into_iter()
        .map(|twist| Lubkin::at_twist(twist).map(|state| (twist, state.torque())))
        .collect();
    let exact = exact?;
    panel.add(Series::dotted("Lubkin, circle", exact.clone()));
    let circle = numerical([1.0, 1.0], 1.6, [40, 40])?;
    let (coarse, fine) =
        (numerical([10.0, 1.0], 0.2, [12, 5])?, numerical([10.0, 1.0], 0.2, [40, 20])?);
    for (name, marker, points) in [
        ("circle, 1264 elements", crate::Marker::Circle, &circle),
        ("ratio 10, 640 elements", crate::Marker::Square, &fine),
        ("ratio 10, 50 elements", crate::Marker::Cross, &coarse),
    ] {
        let inside = points.iter().copied().filter(|(twist, _)| *twist <= 1.0);
        panel.add(Series::markers(name, marker, inside));
    }
    figure.panel(panel);
    let mut misses = Vec::new();
    for ((ratio, points), miss) in [(1.0, &circle), (0.1, &fine)].into_iter().zip([0.028, 0.021]) {
        let mut torsion = law(ratio, 0.0)?;
        let mut worst = 0.0_f64;
        for &(twist, torque) in points {
            worst = worst.max((torsion.advance(twist)? - torque).abs());
        }
        misses.push((worst / torsion.sliding_torque(), miss));
    }
    figure
        .all_close(
            "what (7.65) misses of the numerical torque at most, over sliding: circle, ratio 10",
            misses,
            Absolute(0.002),
        )
        .source("an independent half-space program");
    let sliding = law(0.1, 0.0)?.sliding_torque();
    let apart = coarse.iter().zip(&fine).map(|(a, b)| (a.1 - b.1).abs() / sliding);
    figure
        .at_most("50 elements do nearly as well as 640", apart.fold(0.0, f64::max), 0.02)
        .source("the text; an independent program: 0.016");
    let mut worst = 0.0_f64;
    for (twist, want) in exact {
        let mut torsion = law(1.0, 0.0)?;
        torsion.advance(twist)?;
        worst = worst.max((torsion.torque() - want).abs() / SLIDING_TORQUE);
    }
    figure
        .at_most("on the circle (7.65) is within 2.76 % of sliding", worst, 0.0276)
        .source("Lubkin (5.39), (5.41)");
    let slender = ContactEllipse::new(0.1, 1.0)?;
    let sliding = law(0.1, 0.0)?.sliding_torque();
    figure
        .close("sliding torque, ratio 10", sliding, 0.380_997_579_384_459, Relative(1e-14))
        .source("(10.57), 40-digit arithmetic");
    figure
        .close(
            "the same with the axes exchanged",
            sliding_torque_arm(&slender.exchanged()),
            sliding,
            Relative(1e-14),
        )
        .source("symmetry");
    Ok(figure)
}

/// Twist and torque of the numerical solution with nu = 0 and f = 1, in the units of fig. 7.10.
fn numerical(
    semi_axes: [f64; 2],
    degrees: f64,
    elements: [usize; 2],
) -> Result<Vec<(f64, f64)>, Failure> {
    let mesh = Mesh::of(semi_axes, elements);
    let at = |i: u32| Shift {
        zeta: APPROACH,
        omega: (f64::from(i) * degrees).to_radians(),
        ..Shift::default()
    };
    let run = mesh.follow(&(0..=10).map(at).collect::<Vec<_>>())?;
    // The larger semi-axis, the combined modulus, Hertz's force.
    let b = semi_axes[0];
    let unit = mesh.materials()?.shear_modulus() * b * b / mesh.hertz()?.force(APPROACH);
    let force = mesh.hertz()?.force(APPROACH);
    let points =
        run.iter().zip(0..).map(|(step, i)| (unit * at(i).omega, step.load.m_z / (force * b)));
    Ok(points.collect())
}

pub(super) fn draw_reversals() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("a/b, ν", "1/10, 0");
    figure.assumed(
        "turning points",
        "β = ± 0.5, with an inner loop at 0.1 and 0.3; G b²/(f F_z) = 1",
    );
    let mut torsion = law(0.1, 0.0)?;
    let mut curve = vec![(0.0, 0.0)];
    let mut at = Vec::new();
    for to in [0.5, 0.1, 0.3, 0.1, -0.5, 0.5] {
        let from = torsion.twist();
        for t in linspace(0.0, 1.0, 41).into_iter().skip(1) {
            torsion.advance(from + t * (to - from))?;
            curve.push((torsion.twist(), torsion.torque()));
        }
        at.push(torsion.torque());
    }
    let mut panel = Panel::new("G b² β/(f F_z)", "M_z/(f F_z b)");
    panel.add(Series::line("(7.66)", curve));
    figure.panel(panel);
    figure
        .close("M(−β₁) = −M₁", at[4], -at[0], Absolute(1e-15))
        .source("(7.66), exponent corrected");
    figure.close("the inner loop closes", at[3], at[1], Absolute(1e-15)).source("Madelung's rule");
    figure.close("the outer loop closes", at[5], at[0], Absolute(1e-15)).source("Madelung's rule");
    exponential_claims(&mut figure)?;
    let mut unload = law(0.1, 0.0)?;
    unload.advance(0.5)?;
    let first = unload.torque();
    unload.advance(0.5 - 1e-7)?;
    let slope = (first - unload.torque()) / 1e-7;
    figure
        .close("unloading starts with M_zA'", slope, unload.initial_stiffness(), Relative(1e-5))
        .source("Masing's rule");
    figure.deviation(
        "exp[+M_zA'(β₁ − β)/(2 M_zS)] in (7.66)",
        "exp[−M_zA'(β₁ − β)/(2 M_zS)]",
        "sign of the exponent",
    );
    Ok(figure)
}

/// (7.65), (7.66) written out: torque, slope and energies of loading, unloading and beyond the reversal.
fn exponential_claims(figure: &mut Figure) -> Result<(), Failure> {
    // By 40-digit arithmetic, a/b = 0.1: M_zS over f F_z b, and M_zA' = (3/8) E δ_T.
    let sliding = 0.380_997_579_384_459;
    let slope = law(0.1, 0.3)?.initial_stiffness();
    figure
        .close("initial stiffness at ν = 0.3", slope, sliding * DELTA[3][2], Relative(1e-13))
        .source("(7.65): (3/8) G b³ E δ_T in 40-digit arithmetic");
    let decay = |twist: f64| libm::exp(-slope * twist / sliding);
    let first = |twist: f64| sliding * (1.0 - decay(twist));
    let (mut torques, mut energies) = (Vec::new(), Vec::new());
    let mut torsion = law(0.1, 0.3)?;
    torsion.advance(0.5)?;
    torques.extend([(torsion.torque(), first(0.5)), (torsion.tangent(), slope * decay(0.5))]);
    // W = ∫M dβ; the heat of a first loading is 2 W - M β, that of a whole loop four times it.
    let work = sliding * 0.5 - sliding * sliding / slope * (1.0 - decay(0.5));
    let heat = 2.0 * work - 0.5 * first(0.5);
    energies.push((torsion.stored_energy(), 0.5 * first(0.5) - work));
    energies.push((torsion.dissipated(), heat));
    torsion.advance(0.1)?;
    // Masing: the branch is the first loading, twice as large.
    torques.push((torsion.torque(), first(0.5) - 2.0 * first(0.2)));
    torques.push((torsion.tangent(), slope * decay(0.2)));
    torsion.advance(-0.5)?;
    torsion.advance(0.5)?;
    energies.push((torsion.stored_energy(), 0.5 * first(0.5) - work));
    energies.push((torsion.dissipated(), 5.0 * heat));
    // Beyond the reversal points the first loading continues, in either direction.
    torsion.advance(0.7)?;
    torques.extend([(torsion.torque(), first(0.7)), (torsion.tangent(), slope * decay(0.7))]);
    torsion.advance(-0.9)?;
    torques.extend([(torsion.torque(), -first(0.9)), (torsion.tangent(), slope * decay(0.9))]);
    figure
        .all_close(
            "torque and slope in loading, unloading, and beyond both turning points",
            torques,
            Absolute(1e-13),
        )
        .source("(7.65), (7.66), corrected, written out; Masing's and Madelung's rules");
    figure
        .all_close(
            "energy stored and turned into heat, after loading and after a whole loop",
            energies,
            Absolute(1e-13),
        )
        .source("M β - ∫M dβ and 2 ∫M dβ - M β of (7.65); four times that for the loop");
    Ok(())
}
