//! Fig. 5.6: the twisting moment of a circle with slip, exact and approximate.

use std::f64::consts::{PI, TAU};

use carom_halfspace::{Material, MaterialPair};
use carom_laws::accounted::Accounted;
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Energies as _, Shift};
use carom_laws::torsion::history::TwistHistory;
use carom_laws::torsion::law::TorsionLaw;
use carom_laws::torsion::lubkin::{Lubkin, SLIDING_TORQUE, approximate_torque};
use carom_special::RangeError;
use carom_special::quadrature::{GaussLegendre, Tolerance as Within, adaptive, tanh_sinh};

use crate::reference::rows;
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Relative, Series, linspace};

fn exact(twist: f64) -> Result<f64, RangeError> {
    Ok(Lubkin::at_twist(twist)?.torque())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.derived("abscissa", "G a² β/(f F_z), from (5.42)");
    figure.assumed("range", "0 to 0.5");
    let twists = linspace(0.0, 0.5, 501);
    let curve: Vec<f64> = twists.iter().map(|&twist| exact(twist)).collect::<Result<_, _>>()?;
    let table = rows::<4>(include_str!("../../../data/laws/lubkin.csv"))?;
    let mut panel = Panel::new("G a² β / (f F_z)", "M_z / (f F_z a)").titled("Torsion of a circle");
    panel.add(Series::line("exact (5.41)", twists.iter().copied().zip(curve.iter().copied())));
    panel.add(Series::dashed(
        "approximate (5.42)",
        twists.iter().map(|&twist| (twist, approximate_torque(twist))),
    ));
    let inside = table.iter().filter(|row| row[1] <= 0.5);
    panel.add(Series::markers(
        "independent values",
        Marker::Circle,
        inside.map(|row| (row[1], row[2])),
    ));
    panel.add(Series::dotted("sliding, 3π/16", [(0.0, SLIDING_TORQUE), (0.5, SLIDING_TORQUE)]));
    figure.panel(panel);

    table_claims(&mut figure, &table)?;
    error_claims(&mut figure)?;
    traction_claims(&mut figure)?;
    history_claims(&mut figure, &table)?;
    energy_claims(&mut figure)?;
    figure.increasing("the torque rises", curve).source("its slope (16/3) G a*³ is positive");
    figure.deviation(
        "k'²/(4π) before the bracket of (5.41)",
        "k'k²/(4π)",
        "misprint; (10.27) has it right",
    );
    figure.deviation(
        "maximal error 3 % of (5.42)",
        "2.76 % of the sliding moment, 3.35 % of the moment itself",
        "true for the first reading only",
    );
    Ok(figure)
}

fn table_claims(figure: &mut Figure, table: &[[f64; 4]]) -> Result<(), Failure> {
    let (mut torques, mut twists, mut approximate) = (Vec::new(), Vec::new(), Vec::new());
    for &[stick, twist, torque, rough] in table {
        let state = Lubkin::at_stick_radius(stick)?;
        torques.push((state.torque(), torque));
        twists.push((state.twist(), twist));
        approximate.push((approximate_torque(twist), rough));
    }
    let source = "integration of (5.37) in 25 digits by an independent program";
    for (name, pairs) in
        [("torque", torques), ("twist", twists), ("approximate torque", approximate)]
    {
        figure
            .all_close(format!("{name} at 17 stick radii"), pairs, Relative(1e-13))
            .source(source);
    }
    let slopes = [exact(1e-7)? / 1e-7, approximate_torque(1e-7) / 1e-7];
    figure
        .all_close(
            "both begin with the slope 16/3",
            slopes.map(|slope| (slope, 16.0 / 3.0)),
            Relative(1e-5),
        )
        .source("(5.35) for the circle");
    let ends = [exact(10.0)?, approximate_torque(10.0)];
    figure
        .all_close("both end at 3π/16", ends.map(|end| (end, 3.0 * PI / 16.0)), Absolute(1e-12))
        .source("∫ρ f p_z dS");
    Ok(())
}

/// The claim of the text, "the maximal error is 3 %", in its two interpretations.
fn error_claims(figure: &mut Figure) -> Result<(), Failure> {
    let mut errors = Vec::new();
    for twist in linspace(1e-4, 2.0, 20_000) {
        let torque = exact(twist)?;
        let lack = torque - approximate_torque(twist);
        errors.push((twist, lack / SLIDING_TORQUE, lack / torque));
    }
    let none = (0.0, f64::NEG_INFINITY, f64::NEG_INFINITY);
    let (at, of_sliding, _) =
        errors.iter().copied().fold(none, |m, e| if e.1 > m.1 { e } else { m });
    let (at_own, _, of_itself) =
        errors.iter().copied().fold(none, |m, e| if e.2 > m.2 { e } else { m });
    let least = errors.iter().map(|e| e.1).fold(f64::INFINITY, f64::min);
    figure
        .at_most("error of (5.42) over the sliding moment", of_sliding, 0.03)
        .source("text: maximal error 3 %");
    figure.close("exactly", of_sliding, 0.027_560, Absolute(1e-6)).source("independent program");
    figure.close("at", at, 0.195_29, Absolute(1e-4)).source("independent program");
    figure
        .close("error over the moment itself", of_itself, 0.033_465, Absolute(1e-6))
        .source("independent program; the 3 % of the text do not hold for it");
    figure.close("at", at_own, 0.153_79, Absolute(1e-4)).source("independent program");
    figure
        .at_least("(5.42) lies below (5.41) everywhere", least, 0.0)
        .source("independent program");
    Ok(())
}

fn traction_claims(figure: &mut Figure) -> Result<(), Failure> {
    let within = Within::relative(1e-11)?;
    let (mut moments, mut printed, mut slopes) = (Vec::new(), Vec::new(), Vec::new());
    for stick in [0.2_f64, 0.5, 0.8, 0.95] {
        let state = Lubkin::at_stick_radius(stick)?;
        let mut moment = 0.0;
        for (low, high) in [(0.0, stick), (stick, 1.0)] {
            moment += TAU
                * tanh_sinh(low, high, within, |at| {
                    at.position * at.position * state.traction(at.position)
                })?
                .value;
        }
        moments.push((moment, state.torque()));
        printed.push((formula(stick)?, state.torque()));
        let step = 1e-5;
        let slope = (exact(state.twist() + step)? - exact(state.twist() - step)?) / (2.0 * step);
        slopes.push((slope, 16.0 / 3.0 * stick * stick * stick));
    }
    figure
        .all_close("moment of the traction (5.37)", moments, Relative(1e-9))
        .source("quadrature over the contact area");
    figure
        .all_close("(5.41) with k'k²/(4π)", printed, Relative(1e-9))
        .source("(5.41) corrected, every integral by quadrature");
    figure
        .all_close("dM_z/dβ = (16/3) G a*³", slopes, Relative(1e-6))
        .source("a further slip ring twists the stick area as a rigid disc");
    Ok(())
}

/// The law of torsion in its first loading: M_z is 2 mu f F_z a, and G a² β/(f F_z) is 3/8 of its twist.
fn history_claims(figure: &mut Figure, table: &[[f64; 4]]) -> Result<(), Failure> {
    let mut pairs = Vec::new();
    for &[stick, twist, torque, _] in table {
        let mut history = TwistHistory::new();
        history.advance(1.0, 0.0)?;
        pairs.push((2.0 * history.advance(1.0, 8.0 / 3.0 * twist)?, torque));
        pairs.push((history.stick_radius(), stick));
        pairs.push((history.tangent(), stick * stick * stick));
    }
    figure
        .all_close(
            "torque, stick radius and slope by the memory of a twisted contact",
            pairs,
            Absolute(1e-9),
        )
        .source("integration of (5.37) in 25 digits; slope (16/3) G a*³");
    Ok(())
}

/// Energies of a first twist in physical units. Friction is constant and slip has one direction: the heat is
/// 2 ∫M dβ - M β, the stored energy M β - ∫M dβ.
fn energy_claims(figure: &mut Figure) -> Result<(), Failure> {
    let body = Material::from_shear(3.0, 0.3)?;
    let gap = RelativeCurvature::from_coefficients(1.0, 1.0)?;
    let hertz = Hertz::new(gap, MaterialPair::new(body, body)?)?;
    let (friction, zeta) = (0.4, 0.01);
    let state = hertz.at_approach(zeta)?;
    let (a, limit) = (state.ellipse.semi_axis_a(), friction * state.force);
    // β of G a² β/(f F_z) = 1; G of (4.7) is 3/2.
    let unit = limit / (1.5 * a * a);
    let rule = GaussLegendre::new(60)?;
    let mut pairs = Vec::new();
    for twist in [0.05, 0.2, 0.6] {
        let mut law = Accounted::new(TorsionLaw::new(&hertz, Friction::new(friction)?)?);
        law.advance(Shift { zeta, ..Shift::default() })?;
        let torque = law.advance(Shift { zeta, omega: twist * unit, ..Shift::default() })?.m_z;
        let end = exact(twist)?;
        let sum = rule.integrate(0.0, twist, |at| exact(at).unwrap_or(f64::NAN));
        let scale = limit * a * unit * twist;
        pairs.push((torque / (limit * a), end));
        pairs.push((law.law().twist_energy() / scale, (end * twist - sum) / twist));
        pairs.push((law.dissipated() / scale, (2.0 * sum - end * twist) / twist));
    }
    figure
        .all_close(
            "torque, energy stored and turned into heat by three twists",
            pairs,
            Absolute(1e-4),
        )
        .source("M β - ∫M dβ and 2 ∫M dβ - M β of (5.41)");
    Ok(())
}

/// (5.41), corrected, from its defining integrals.
fn formula(stick: f64) -> Result<f64, Failure> {
    let within = Within::relative(1e-12)?;
    let m = 1.0 - stick * stick;
    let delta = |t: f64| (1.0 - m * libm::sin(t) * libm::sin(t)).sqrt();
    let d = adaptive(0.0, PI / 2.0, within, |t| libm::sin(t) * libm::sin(t) / delta(t))?.value;
    let e = adaptive(0.0, PI / 2.0, within, delta)?.value;
    let end = libm::acos(stick);
    let arc =
        tanh_sinh(0.0, end, within, |at| libm::acos((stick / libm::cos(at.position)).min(1.0)))?
            .value;
    Ok(stick * m / (4.0 * PI) * (d * (1.0 + 2.0 * m) + 6.0 * e) + 3.0 / (4.0 * PI) * arc)
}
