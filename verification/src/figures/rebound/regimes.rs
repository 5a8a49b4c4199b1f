//! The sequence of regimes of an oblique impact in the plane of chi and psi.
//!
//! A sequence is written with A for adhesion, P for partial slip and S for complete sliding, each
//! with the sign of the traction on body 1: + against the first slip of body 2 over it.

use carom_impact::closed_form::phi;
use carom_impact::oblique::{Event, Groups, ObliqueImpact, Regime};
use carom_special::roots::try_bisect;
use rayon::prelude::*;

use crate::spheres::chi;
use crate::spring_impact;
use crate::{Absolute, Axis, Failure, Figure, FigureResult, Marker, Panel, Series};
use crate::{linspace, logspace};

const CHI_MAX: f64 = 8.0;
const PSI: (f64, f64) = (0.02, 20.0);
/// Above this psi no impact with chi below CHI_MAX ends forward after it has turned back.
const PSI_FORWARD: f64 = 6.5;
/// As above, for a slip that stops.
const PSI_STOP: (f64, f64) = (0.47, 5.7);

type Points = Vec<(f64, f64)>;

fn impact(chi: f64, psi: f64) -> Result<ObliqueImpact, Failure> {
    Ok(ObliqueImpact::new(Groups::new(chi, psi)?)?)
}

fn has(impact: &ObliqueImpact, regime: Regime) -> bool {
    impact.phases().iter().any(|phase| phase.regime == regime)
}

fn slides_throughout(impact: &ObliqueImpact) -> bool {
    impact.phases().len() == 1 && has(impact, Regime::SlideForward)
}

fn sticks(impact: &ObliqueImpact) -> bool {
    has(impact, Regime::Adhesion)
}

fn begins_stuck(impact: &ObliqueImpact) -> bool {
    impact.phases()[0].regime == Regime::Adhesion
}

/// Whether the sliding before separation has the sign of the first traction.
fn ends_forward(impact: &ObliqueImpact) -> bool {
    impact.phases().last().is_some_and(|phase| phase.regime == Regime::SlideForward)
}

/// Whether a slip stops before its ring has closed or grown over the contact.
fn slip_stops(impact: &ObliqueImpact) -> bool {
    impact.phases().iter().any(|phase| phase.began_by == Event::SlipStop)
}

/// Where `test` changes between two values that bracket one change.
fn boundary(
    low: f64,
    high: f64,
    test: impl Fn(f64) -> Result<bool, Failure>,
) -> Result<f64, Failure> {
    let at_low = test(low)?;
    if test(high)? == at_low {
        return Err(format!("no boundary between {low} and {high}").into());
    }
    let [low, high] = try_bisect([low, high], 34, |x| Ok::<_, Failure>(test(x)? == at_low))?;
    Ok(0.5 * (low + high))
}

/// chi from which on an impact with this psi, having turned back, ends forward.
fn forward_from(psi: f64) -> Result<f64, Failure> {
    let low = if psi < 1.0 { 1.5 } else { psi.max(1.0) + 1e-9 };
    boundary(low, CHI_MAX - 1e-3, |chi| Ok(ends_forward(&impact(chi, psi)?)))
}

/// chi from which on a slip stops in an impact with this psi.
fn stops_from(psi: f64) -> Result<f64, Failure> {
    boundary(4.5, CHI_MAX - 1e-3, |chi| Ok(slip_stops(&impact(chi, psi)?)))
}

fn curve(psis: &[f64], chi: fn(f64) -> Result<f64, Failure>) -> Result<Points, Failure> {
    psis.par_iter().map(|&psi| Ok((chi(psi)?, psi))).collect()
}

/// The numerical boundaries, as points (chi, psi).
struct Boundaries {
    /// From adhesion at touch, psi < 1.
    forward_stuck: Points,
    /// From sliding at touch, psi > 1.
    forward_slid: Points,
    stop: Points,
}

impl Boundaries {
    fn find() -> Result<Self, Failure> {
        Ok(Self {
            forward_stuck: curve(&logspace(PSI.0, 1.0 - 1e-9, 25), forward_from)?,
            forward_slid: curve(&logspace(1.0 + 1e-9, PSI_FORWARD, 33), forward_from)?,
            stop: curve(&logspace(PSI_STOP.0, PSI_STOP.1, 41), stops_from)?,
        })
    }
}

fn between(low: f64, high: f64, height: fn(f64) -> f64) -> Points {
    linspace(low, high, 57).into_iter().map(|chi| (chi, height(chi))).collect()
}

fn reversed(mut points: Points) -> Points {
    points.reverse();
    points
}

fn map(boundaries: &Boundaries) -> Panel {
    let mut panel = Panel::new(
        Axis::linear("χ = D_xx c_x/(D_zz c_z)").between(0.0, CHI_MAX),
        Axis::log("ψ = c_x |ξ'|/(f c_z ζ')").between(PSI.0, PSI.1),
    )
    .titled("Sequence of regimes: A adhesion, P partial slip, S sliding");
    let (stuck, slid) = (&boundaries.forward_stuck, &boundaries.forward_slid);
    let last = [(CHI_MAX, PSI_FORWARD)];
    let areas: [(&str, Points); 7] = [
        (
            "S+",
            [
                vec![(0.0, 1.0)],
                between(1.0, CHI_MAX, |chi| 2.0 * chi - 1.0),
                vec![(CHI_MAX, PSI.1), (0.0, PSI.1)],
            ]
            .concat(),
        ),
        (
            "S+ P- S-",
            [
                between(1.0, CHI_MAX, |chi| chi),
                reversed(between(1.0, CHI_MAX, |chi| 2.0 * chi - 1.0)),
            ]
            .concat(),
        ),
        (
            "S+ A P- S-",
            [
                vec![(1.0, 1.0)],
                slid.clone(),
                last.to_vec(),
                reversed(between(1.0, CHI_MAX, |chi| chi)),
            ]
            .concat(),
        ),
        ("S+ A P- .. S+", [slid.clone(), last.to_vec(), vec![(CHI_MAX, 1.0)]].concat()),
        ("A P+ S+", vec![(0.0, PSI.0), (1.0, PSI.0), (1.0, 1.0), (0.0, 1.0)]),
        ("A P- S-", [vec![(1.0, PSI.0)], stuck.clone(), vec![(1.0, 1.0)]].concat()),
        ("A P- P+ .. S+", [stuck.clone(), vec![(CHI_MAX, 1.0), (CHI_MAX, PSI.0)]].concat()),
    ];
    for (label, outline) in areas {
        panel.add(Series::area(label, outline));
    }
    panel.add(Series::dashed("right of it a slip stops", boundaries.stop.clone()).coloured(7));
    for (i, chi) in [7.0 / 3.0, 3.5].into_iter().enumerate() {
        let label = if i == 0 { "spheres, ν = 1/2 to 0" } else { "" };
        panel.add(Series::dotted(label, [(chi, PSI.0), (chi, PSI.1)]).coloured(8));
    }
    panel.add(Series::markers("χ = 3: limit for ψ → 0", Marker::Triangle, [(3.0, PSI.0)]));
    panel
}

/// Interpolated chi of a boundary at psi, if it reaches there.
fn chi_at(points: &[(f64, f64)], psi: f64) -> Option<f64> {
    let pair = points.windows(2).find(|pair| pair[0].1 <= psi && psi <= pair[1].1)?;
    let part = (psi - pair[0].1) / (pair[1].1 - pair[0].1);
    Some(pair[0].0 + part * (pair[1].0 - pair[0].0))
}

/// What the drawn map says: (slides throughout, sticks, begins stuck, ends forward, slip stops);
/// none next to a numerical boundary.
fn drawn(boundaries: &Boundaries, chi: f64, psi: f64) -> Option<[bool; 5]> {
    let begins = psi <= 1.0;
    let throughout = psi >= 1.0_f64.max(2.0 * chi - 1.0);
    let forward_from =
        chi_at(if begins { &boundaries.forward_stuck } else { &boundaries.forward_slid }, psi);
    let stops_from = chi_at(&boundaries.stop, psi);
    let is_near = |from: Option<f64>| from.is_some_and(|from| (chi - from).abs() < 0.03);
    if is_near(forward_from) || is_near(stops_from) {
        return None;
    }
    let beyond = |from: Option<f64>| from.is_some_and(|from| chi > from);
    Some([
        throughout,
        begins || (chi > 1.0 && psi < chi),
        begins,
        throughout || (begins && chi < 1.0) || beyond(forward_from),
        beyond(stops_from),
    ])
}

fn grid_claim(figure: &mut Figure, boundaries: &Boundaries) -> Result<(), Failure> {
    // Between the closed boundaries, whatever the grid.
    let chis: Vec<f64> = (0..53).map(|i| 0.05 + 0.149 * f64::from(i)).collect();
    let psis = logspace(0.0213, 19.0, 47);
    let places: Vec<(f64, f64)> =
        chis.iter().flat_map(|&chi| psis.iter().map(move |&psi| (chi, psi))).collect();
    let found: Result<Vec<Option<bool>>, Failure> = places
        .par_iter()
        .map(|&(chi, psi)| {
            let walk = impact(chi, psi)?;
            let tests = [slides_throughout, sticks, begins_stuck, ends_forward, slip_stops];
            let expected = drawn(boundaries, chi, psi);
            Ok(expected.map(|expected| expected == tests.map(|test| test(&walk))))
        })
        .collect();
    let judged: Vec<bool> = found?.into_iter().flatten().collect();
    let wrong = judged.iter().filter(|agrees| !**agrees).count();
    let statement = format!("{} impacts outside the drawn areas that they belong to", judged.len());
    figure.at_most(statement, wrong as f64, 0.0).source("the walks themselves");
    figure
        .at_least("judged of 2491", judged.len() as f64, 2400.0)
        .source("all but those within 0.03 of a numerical boundary");
    Ok(())
}

fn closed_claims(figure: &mut Figure) -> Result<(), Failure> {
    let chis = linspace(1.2, 7.6, 9);
    let (mut one, mut diagonal, mut double) = (Vec::new(), Vec::new(), Vec::new());
    for &chi in &chis {
        let edge = |low: f64, high: f64, test: fn(&ObliqueImpact) -> bool| {
            boundary(low, high, |psi| Ok(test(&impact(chi, psi)?)))
        };
        one.push((edge(0.5, 1.1, begins_stuck)?, 1.0));
        diagonal.push((edge(1.1, 12.0, sticks)?, chi));
        double.push((edge(1.0, 20.0, slides_throughout)?, 2.0 * chi - 1.0));
    }
    let tolerance = Absolute(1e-8);
    figure.all_close("sticks from touch up to ψ = 1", one, tolerance).source("(8.50)");
    figure
        .all_close("sticks at some time up to ψ = χ", diagonal, Absolute(1e-5))
        .source("sliding ends at w = (χ - ψ)/(χ - 1) > 0; the walk passes over w < 1e-6");
    figure
        .all_close("slides throughout from ψ = 2χ - 1 on", double, tolerance)
        .source("sliding ends before w = -1 if (χ - ψ)/(χ - 1) > -1");
    Ok(())
}

fn flip_claims(figure: &mut Figure) -> Result<(), Failure> {
    // psi -> 0: with y the shift since loading at the same compression, y'' = -K chi sqrt(zeta) y
    // from y = 0 at maximal compression, the odd solution of the equation of adhesion. It returns
    // to 0 at separation for phi = 19.
    figure
        .close(
            "the slip turns forward before separation from χ = 3 on, ψ = 1e-6",
            forward_from(1e-6)?,
            3.0,
            Absolute(1e-5),
        )
        .source("zero of 1/Γ((19 - φ)/20): the odd solution of the equation of adhesion");
    figure.close("φ there", phi(3.0), 19.0, Absolute(1e-14)).source("sqrt(1 + 120 · 3)");
    let walk = impact(chi(0.3), 0.3)?;
    figure
        .holds(
            "ν = 0.3, ψ = 0.3: ξ has a minimum in restitution (R_x < 0), the slip does not turn",
            walk.restitution() < 0.0 && !ends_forward(&walk),
            walk.restitution(),
        )
        .source("against the text below fig. 7.1");
    let nu = boundary(0.1, 0.4, |nu| Ok(ends_forward(&impact(chi(nu), 1e-6)?)))?;
    figure
        .close("of spheres those with ν < 1/4", nu, 0.25, Absolute(1e-5))
        .source("χ = 7 (1 - ν)/(2 - ν) = 3");
    Ok(())
}

fn stop_claims(figure: &mut Figure, boundaries: &Boundaries) {
    let least = boundaries.stop.iter().map(|point| point.0).fold(f64::INFINITY, f64::min);
    figure
        .at_least("least χ of a slip that stops: no sphere", least, 3.5)
        .source("χ ≤ 7/2 of spheres");
    figure.at_most("but upright ellipsoids", least, 6.0).source("χ ≤ 6, (15.7) and (15.8)");
}

fn spring_claim(figure: &mut Figure, boundaries: &Boundaries) -> Result<(), Failure> {
    let places: Vec<(f64, f64)> = [0.5, 2.0, 2.7, 4.3, 5.0, 6.0, 7.0]
        .iter()
        .flat_map(|&chi| [0.3, 0.7, 1.3, 2.2, 4.0, 9.0].map(|psi| (chi, psi)))
        .collect();
    let edges = [&boundaries.forward_stuck, &boundaries.forward_slid];
    let both: Result<Vec<_>, Failure> = places
        .par_iter()
        .map(|&(chi, psi)| Ok((impact(chi, psi)?, spring_impact::course(chi, psi))))
        .collect();
    let both = both?;
    let restitutions = both.iter().map(|(walk, step)| (walk.restitution(), step.restitution));
    let restitutions: Vec<(f64, f64)> = restitutions.collect();
    let is_clear = |&(chi, psi): &(f64, f64)| {
        let near = |from: f64| (chi - from).abs() < 0.5;
        !edges.iter().any(|edge| chi_at(edge, psi).is_some_and(near))
    };
    let clear: Vec<_> = places
        .iter()
        .zip(&both)
        .filter(|(place, _)| is_clear(place))
        .map(|(_, pair)| pair)
        .collect();
    let count = clear.len();
    let differs = clear.iter().filter(|(walk, step)| ends_forward(walk) != (step.last_force > 0.0));
    let wrong = differs.count();
    figure
        .at_most(
            format!("of {count} impacts with another last direction by springs"),
            wrong as f64,
            0.0,
        )
        .source("springs with sliders, stepped in time");
    figure
        .all_close("R_x of 42 impacts in all areas", restitutions, Absolute(1e-5))
        .source("springs with sliders, stepped in time");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.derived("χ of solid spheres", "7/3 (ν = 1/2) to 7/2 (ν = 0); ψ = λ/κ");
    figure.derived("χ of upright solid ellipsoids", "1/2 to 6");
    figure.assumed("χ, ψ", "0 to 8 and 0.02 to 20");
    let boundaries = Boundaries::find()?;
    figure.panel(map(&boundaries));
    closed_claims(&mut figure)?;
    flip_claims(&mut figure)?;
    stop_claims(&mut figure, &boundaries);
    grid_claim(&mut figure, &boundaries)?;
    spring_claim(&mut figure, &boundaries)?;
    figure.deviation(
        "complete sliding for λ ≥ 7, adhesion for λ < 1 (section 15.1)",
        "λ ≥ 7 - κ and λ < κ: ψ = 2χ - 1 and ψ = 1",
        "the elastic shift recedes in restitution; the limit of adhesion is c_x ξ' = f c_z ζ'",
    );
    figure.deviation(
        "after ξ has reached its minimum, the slip direction changes again (chapter 7)",
        "it does if χ > 3, for small ψ: spheres with ν < 1/4",
        "at the minimum the rim still recedes over stresses stored in loading, which keep the slip \
         going; it turns when its ring has closed",
    );
    Ok(figure)
}
