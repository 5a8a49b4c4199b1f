//! Figs. 6.11 and 6.12: the first point of instantaneous adhesion and the second decrease.

use super::history::{
    Place, Terms, add_terms, follow, reference_claim, springs_claim, stress_claims, stress_panel,
};
use crate::{Absolute, Failure, Figure, FigureResult};

const FIRST: [Place; 2] = [(1.0, 0.0), (1.0, 0.5)];

/// Two steps after P_1 = (1, 0.5), for growing and for falling approach.
const GROWING: [Place; 2] = [(1.1, 0.0), (1.15, -0.2)];
const FALLING: [Place; 2] = [(0.9, 0.1), (0.85, -0.1)];

fn after(places: &[Place]) -> Vec<Place> {
    FIRST.iter().chain(places).copied().collect()
}

/// zeta* of (6.40) after P_1.
fn depth((zeta, shift): Place) -> f64 {
    zeta + 0.5 * (shift - 0.5 - zeta + 1.0)
}

/// (6.38c): the stress after P_1, whatever the path.
fn resulting(place: Place) -> [(f64, f64, f64); 2] {
    [(1.0, place.0, 0.5), (-2.0, place.0, depth(place))]
}

/// F_x of (6.39).
fn force(place: Place) -> f64 {
    let power = |x: f64| x * x.sqrt();
    let first = 1.0 - power(0.5);
    first + power(place.0) - 1.0 - 2.0 * power(place.0) + 2.0 * power(depth(place))
}

/// Parts of the stress with their names, and the equation of their sum.
struct Case<'a> {
    title: &'a str,
    names: &'a [&'a str],
    parts: Terms<'a>,
    history: &'a [Place],
}

fn add_case(figure: &mut Figure, case: &Case<'_>, equation: &str) -> Result<(), Failure> {
    let mut panel = stress_panel(case.title);
    add_terms(&mut panel, case.names, case.parts, "σ_zx");
    figure.panel(panel);
    stress_claims(figure, case.title, case.history, case.parts, equation)?;
    let last = case.history[case.history.len() - 1];
    let memory = follow(case.history)?;
    let total = resulting(last);
    let pairs = crate::linspace(0.0, 0.99 * last.0.sqrt(), 60)
        .into_iter()
        .map(|rho| (super::history::stress(&memory, rho), super::history::sum(&total, rho)));
    figure
        .all_close(
            format!("{}: σ_CM(a₂, a₁*) - 2 σ_CM(a₂, a₂*)", case.title),
            pairs,
            Absolute(1e-13),
        )
        .source("(6.38c)");
    figure
        .close(format!("{}: force", case.title), memory.force(), force(last), Absolute(1e-14))
        .source("(6.39)");
    let inner = memory.segments().find(|segment| segment.is_slip).map(|segment| segment.from);
    let outer: Vec<f64> = memory.instantaneous_adhesions().collect();
    let found = [inner.unwrap_or(f64::NAN), outer.first().copied().unwrap_or(f64::NAN)];
    figure
        .all_close(
            format!("{}: breaks at a₁* and a₂*", case.title),
            [(found[0], 0.5), (found[1], depth(last)), (memory.stick_depth(), depth(last))],
            Absolute(1e-14),
        )
        .source("(6.40)");
    springs_claim(figure, case.title, case.history)
}

fn assume(figure: &mut Figure) {
    figure.assumed("P₁", "ζ₁ = 1, ξ₁/(f κ) = 0.5");
    figure.assumed("a)", "ζ, ξ/(f κ) = 1.1, 0, then 1.15, -0.2");
    figure.assumed("b)", "0.9, 0.1, then 0.85, -0.1");
}

/// Fig. 6.11.
pub(super) fn first_point() -> FigureResult {
    let mut figure = Figure::new();
    assume(&mut figure);
    add_case(
        &mut figure,
        &Case {
            title: "a) Δζ₂ > 0",
            names: &["σ_zx1 = σ_CM(a₁, a₁*)", "σ' = σ_CM(a₂, a₁)", "σ'' = -2 σ_CM(a₂, a₂*)"],
            parts: &[(1.0, 1.0, 0.5), (1.0, 1.1, 1.0), (-2.0, 1.1, depth(GROWING[0]))],
            history: &after(&GROWING[..1]),
        },
        "(6.38a), (6.38b)",
    )?;
    add_case(
        &mut figure,
        &Case {
            title: "b) Δζ₂ < 0",
            names: &["σ_zx1 = σ_CM(a₁, a₁*)", "σ' = -σ_CM(a₁, a₂)", "σ'' = -2 σ_CM(a₂, a₂*)"],
            parts: &[(1.0, 1.0, 0.5), (-1.0, 1.0, 0.9), (-2.0, 0.9, depth(FALLING[0]))],
            history: &after(&FALLING[..1]),
        },
        "(6.38a), (6.38b)",
    )?;
    for (name, csv) in [
        ("growing ζ", include_str!("../../../data/laws/history_reversal_growing.csv")),
        ("falling ζ", include_str!("../../../data/laws/history_reversal_shrinking.csv")),
    ] {
        reference_claim(&mut figure, name, csv)?;
    }
    figure.deviation("σ' in (6.38b)", "σ''", "misprint: the second prime is lost");
    Ok(figure)
}

/// Fig. 6.12.
pub(super) fn second_decrease() -> FigureResult {
    let mut figure = Figure::new();
    assume(&mut figure);
    let [two, three] = GROWING;
    let before = resulting(two);
    let parts = [before[0], before[1], (-1.0, three.0, two.0), (-2.0, depth(two), depth(three))];
    let names =
        ["σ_CM(a₂, a₁*)", "-2 σ_CM(a₂, a₂*)", "σ' = -σ_CM(a₃, a₂)", "σ'' = -2 σ_CM(a₂*, a₃*)"];
    add_case(
        &mut figure,
        &Case { title: "a) Δζ > 0", names: &names, parts: &parts, history: &after(&GROWING) },
        "(6.41a), (6.41b)",
    )?;
    let [two, three] = FALLING;
    let before = resulting(two);
    let parts = [before[0], before[1], (1.0, two.0, three.0), (-2.0, depth(two), depth(three))];
    let names =
        ["σ_CM(a₂, a₁*)", "-2 σ_CM(a₂, a₂*)", "σ' = σ_CM(a₂, a₃)", "σ'' = -2 σ_CM(a₂*, a₃*)"];
    add_case(
        &mut figure,
        &Case { title: "b) Δζ < 0", names: &names, parts: &parts, history: &after(&FALLING) },
        "(6.41a), (6.41b)",
    )?;
    // (6.41c) written from P_2 is (6.39) written from P_1.
    let power = |x: f64| x * x.sqrt();
    let mut pairs = Vec::new();
    for [two, three] in [GROWING, FALLING] {
        let added =
            -power(three.0) + power(two.0) - 2.0 * power(depth(two)) + 2.0 * power(depth(three));
        pairs.push((follow(&after(&[two, three]))?.force(), force(two) + added));
    }
    figure.all_close("F_x3 = F_x2 + …", pairs, Absolute(1e-14)).source("(6.41c)");
    let mut slopes = Vec::new();
    for ([two, three], rate) in [(GROWING, -0.25), (FALLING, 0.25)] {
        let memory = follow(&after(&[two, three]))?;
        let step = -1e-6;
        let moved = memory.clone().advance(three.0 + rate * step, three.1 + step)?;
        let stick = depth(three).sqrt();
        let expected = 1.5 * (-three.0.sqrt() * rate + stick * (1.0 + rate));
        slopes.push(((moved - memory.force()) / step, expected));
    }
    figure.all_close("dF_x/dξ for dζ/dX = ∓1/4", slopes, Absolute(1e-5)).source("(6.41d)");
    Ok(figure)
}
