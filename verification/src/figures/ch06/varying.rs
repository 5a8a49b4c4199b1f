//! Figs. 6.6 to 6.10: the shift increases while the approach increases or decreases.

use super::history::{
    Place, add_terms, follow, force_panel, path, profile, reference_claim, springs_claim, stress,
    stress_claims, stress_panel, sum, virgin, virgin_force,
};
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Series, linspace};

/// P_1 of all five figures: X_1 = 0.5, so that (a_1*)² = 0.5.
const FIRST: [Place; 2] = [(1.0, 0.0), (1.0, 0.5)];

fn after(places: &[Place]) -> Vec<Place> {
    FIRST.iter().chain(places).copied().collect()
}

fn assume_first(figure: &mut Figure, zeta: f64) {
    figure.assumed("ξ₁/(f κ ζ₁)", "0.5");
    figure.assumed("ζ/ζ₁", format!("{zeta}"));
}

/// Goes from (1, 0.5) to (1.2, 0.6) in `steps` steps, each a compression and then a shift.
fn staircase(steps: u32) -> Vec<Place> {
    let mut places = Vec::new();
    for step in 0..steps {
        let [from, to] = [step, step + 1].map(|i| f64::from(i) / f64::from(steps));
        places.push((1.0 + 0.2 * to, 0.5 + 0.1 * from));
        places.push((1.0 + 0.2 * to, 0.5 + 0.1 * to));
    }
    after(&places)
}

/// Fig. 6.6.
pub(super) fn within_cone() -> FigureResult {
    let mut figure = Figure::new();
    assume_first(&mut figure, 1.2);
    figure.assumed("Δξ/(f κ Δζ)", "0.5: less than 1");
    let first = follow(&FIRST)?;
    let one_step = [(1.0, 1.2, 1.1)];
    let mut panel = stress_panel("Additional stress, Δξ < f κ Δζ");
    let added = |steps: u32| -> Result<Vec<(f64, f64)>, Failure> {
        let memory = follow(&staircase(steps))?;
        Ok(profile(&[1.0, 1.1, 1.2], |rho| stress(&memory, rho) - stress_at(&first, rho)))
    };
    panel.add(Series::line("σ_CM(a, a*): ζ first, then ξ", added(1)?));
    panel.add(Series::dashed("in four steps", added(4)?));
    let straight = follow(&after(&[(1.2, 0.6)]))?;
    panel.add(Series::line(
        "both together (6.27)",
        profile(&[1.0, 1.2], |rho| stress(&straight, rho) - stress_at(&first, rho)),
    ));
    panel.add(Series::dotted("σ_zx1", profile(&[0.5, 1.0], |rho| stress_at(&first, rho))));
    figure.panel(panel);

    let terms = [(1.0, 1.0, 0.5), one_step[0]];
    stress_claims(&mut figure, "ζ first", &staircase(1), &terms, "σ_zx1 + σ_CM(a, a*), (6.23)")?;
    let terms = [(1.0, 1.0, 0.5), (0.5, 1.2, 1.0)];
    stress_claims(
        &mut figure,
        "both together",
        &after(&[(1.2, 0.6)]),
        &terms,
        "(6.27), corrected, integrated for a straight path: (Δξ/f κ Δζ) σ_CM(a, a₁)",
    )?;
    let memory = follow(&staircase(1))?;
    figure
        .close("(a*/a₁)² = (ζ - ΔX)/ζ₁", memory.stick_depth(), 1.1, Absolute(1e-15))
        .source("(6.23)");
    // The step in adhesion: dF/dX is that of the added discs, (6.27).
    let tangent = straight.tangent();
    let chord = (libm::pow(1.2, 1.5) - 1.0) / 0.2;
    figure
        .all_close(
            "both together: dF_x/dX and dF_x/dζ of the step",
            [
                (tangent.by_shift[0][0], chord),
                (tangent.by_approach[0], 0.5 * (1.5 * 1.2_f64.sqrt() - chord)),
            ],
            Absolute(1e-13),
        )
        .source("derivatives of F₁ + (ΔX/Δζ) (ζ^(3/2) - ζ₁^(3/2)), (6.27)");
    let distance = |steps: u32| -> Result<f64, Failure> {
        let memory = follow(&staircase(steps))?;
        let radii = linspace(0.0, 1.0, 41);
        Ok(radii
            .iter()
            .map(|&r| (stress(&memory, r) - stress(&straight, r)).abs())
            .fold(0.0, f64::max))
    };
    let distances: Result<Vec<f64>, Failure> = [1, 4, 16, 64].into_iter().map(distance).collect();
    figure
        .decreasing("smaller steps approach (6.27)", distances?)
        .source("text: complete adhesion is the limit of small steps");
    springs_claim(&mut figure, "both together", &after(&[(1.2, 0.6)]))?;
    figure.deviation(
        "∫₀^a … dξ da in (6.27)",
        "∫_ρ^a (dξ/da') da'/sqrt(a'² - ρ²)",
        "misprint: contact radii below ρ carry nothing at ρ",
    );
    Ok(figure)
}

/// The stress of a contact at a radius that may lie outside of it.
fn stress_at(memory: &carom_laws::memory::ScalarMemory, rho: f64) -> f64 {
    if rho * rho < memory.zeta() { stress(memory, rho) } else { 0.0 }
}

/// Fig. 6.7.
pub(super) fn beyond_cone() -> FigureResult {
    let mut figure = Figure::new();
    assume_first(&mut figure, 1.2);
    figure.assumed("ξ/(f κ ζ₁)", "0.9: Δξ = 2 f κ Δζ");
    let terms = [(1.0, 1.0, 0.5), (1.0, 1.2, 1.0), (1.0, 0.5, 0.3)];
    let names = ["σ_zx1 = σ_CM(a₁, a₁*)", "σ' = σ_CM(a, a₁)", "σ'' = σ_CM(a₁*, a*)"];
    let mut panel = stress_panel("Parts of the stress, Δξ > f κ Δζ");
    add_terms(&mut panel, &names, &terms, "σ_zx = σ_CM(a, a*)");
    figure.panel(panel);
    let history = after(&[(1.2, 0.9)]);
    stress_claims(&mut figure, "sum", &history, &terms, "(6.10) + (6.28) + (6.30)")?;
    superposition_claim(&mut figure, &history, (1.2, 0.3))?;
    springs_claim(&mut figure, "path", &history)?;
    Ok(figure)
}

/// (6.9): the parts add up to one Cattaneo-Mindlin function.
fn superposition_claim(
    figure: &mut Figure,
    history: &[Place],
    (outer, inner): (f64, f64),
) -> Result<(), Failure> {
    let memory = follow(history)?;
    let pairs = linspace(0.0, 0.999 * outer.sqrt(), 121)
        .into_iter()
        .map(|rho| (stress(&memory, rho), sum(&[(1.0, outer, inner)], rho)));
    figure.all_close("the parts make σ_CM(a, a*)", pairs, Absolute(1e-14)).source("(6.9)");
    Ok(())
}

/// Fig. 6.8.
pub(super) fn force_growing() -> FigureResult {
    let mut figure = Figure::new();
    assume_first(&mut figure, 1.2);
    let zeta = 1.2_f64;
    let pressed = follow(&after(&[(zeta, 0.5)]))?;
    let to_two = path(&pressed, (zeta, 0.7))?;
    let second = follow(&after(&[(zeta, 0.5), (zeta, 0.7)]))?;
    let to_three = path(&second, (zeta, 1.1))?;
    let mut panel = force_panel("ζ grows at 1, then ξ");
    panel.add(Series::dotted("virgin curve of ζ₁", virgin(1.0)));
    panel.add(Series::dotted("virgin curve of ζ", virgin(zeta)));
    panel.add(Series::line("0-1", path(&follow(&FIRST[..1])?, FIRST[1])?));
    panel.add(Series::line("1-2: Δξ ≤ f κ Δζ", to_two.iter().copied()));
    panel.add(Series::line("2-3: as loaded once", to_three.iter().copied()));
    panel.add(Series::markers(
        "points 1, 2, 3",
        Marker::Circle,
        [to_two[0], to_two[100], to_three[100]],
    ));
    figure.panel(panel);

    let one = virgin_force(1.0, 0.5);
    figure
        .close("compression leaves the force", pressed.force(), one, Absolute(1e-15))
        .source("no tangential displacement");
    // Slip ring outside a_1: F = F_1 + zeta^(3/2) - (zeta - dX)^(3/2).
    let pairs =
        to_two[..100].iter().map(|&(shift, force)| (force, one + virgin_force(zeta, shift - 0.5)));
    figure.all_close("1-2", pairs, Absolute(1e-14)).source("(6.23) in (6.5)");
    let slope = (pressed.clone().advance(zeta, 0.5 + 1e-7)? - one) / 1e-7;
    figure
        .close("initial slope (3/2) a/a₁", slope, 1.5 * zeta.sqrt(), Absolute(1e-6))
        .source("(6.24): 8Ga/(2 - ν)");
    figure
        .close("at 2 the stick area is the old one", second.stick_depth(), 0.5, Absolute(1e-12))
        .source("(6.29)");
    let pairs = to_three.iter().map(|&(shift, force)| (force, virgin_force(zeta, shift)));
    figure.all_close("2-3 is the virgin curve of ζ", pairs, Absolute(1e-14)).source("(6.31)");
    let orders = [
        vec![(zeta, 0.0), (zeta, 0.9)],
        after(&[(zeta, 0.5), (zeta, 0.9)]),
        after(&[(zeta, 0.9)]),
        after(&[(1.1, 0.8), (zeta, 0.9)]),
    ];
    let mut pairs = Vec::new();
    for order in &orders {
        pairs.push((follow(order)?.force(), virgin_force(zeta, 0.9)));
    }
    figure
        .all_close("the order of ζ and ξ does not matter beyond 2", pairs, Absolute(1e-14))
        .source("text below (6.29)");
    springs_claim(&mut figure, "0-1-2-3", &after(&[(zeta, 0.5), (zeta, 0.7), (zeta, 1.1)]))?;
    reference_claim(
        &mut figure,
        "adhesion, then slip",
        include_str!("../../../data/laws/history_growing.csv"),
    )?;
    Ok(figure)
}

/// Fig. 6.9.
pub(super) fn stress_shrinking() -> FigureResult {
    let mut figure = Figure::new();
    assume_first(&mut figure, 0.8);
    figure.assumed("ξ/(f κ ζ₁)", "0.6");
    let terms = [(1.0, 1.0, 0.5), (-1.0, 1.0, 0.8), (1.0, 0.5, 0.2)];
    let names = ["σ_zx1 = σ_CM(a₁, a₁*)", "σ' = -σ_CM(a₁, a)", "σ'' = σ_CM(a₁*, a*)"];
    let mut panel = stress_panel("Parts of the stress, falling ζ (6.35)");
    add_terms(&mut panel, &names, &terms, "σ_zx = σ_CM(a, a*)");
    figure.panel(panel);
    let history = after(&[(0.8, 0.6)]);
    stress_claims(&mut figure, "sum", &history, &terms, "(6.35)")?;
    superposition_claim(&mut figure, &history, (0.8, 0.2))?;
    springs_claim(&mut figure, "path", &history)?;
    figure.deviation(
        "heading 6.4: decreasing ξ, increasing ξ",
        "decreasing ζ, increasing ξ",
        "misread symbol",
    );
    Ok(figure)
}

/// Fig. 6.10.
pub(super) fn force_shrinking() -> FigureResult {
    let mut figure = Figure::new();
    assume_first(&mut figure, 0.8);
    figure.assumed("ξ/(f κ ζ₁)", "0.6 at 3");
    let zeta = 0.8_f64;
    let one = virgin_force(1.0, 0.5);
    // sigma' alone has the force and the shift of the annulus that leaves contact, (6.5).
    let two = (0.5 - (1.0 - zeta), one - (1.0 - zeta * zeta.sqrt()));
    let direct = path(&follow(&FIRST)?, (zeta, 0.6))?;
    let mut panel = force_panel("ζ falls while ξ grows");
    panel.add(Series::dotted("virgin curve of ζ₁", virgin(1.0)));
    panel.add(Series::dotted("virgin curve of ζ", virgin(zeta)));
    panel.add(Series::dashed("1-2: part σ'", [(0.5, one), two]));
    let rest = virgin(zeta).filter(|point| (two.0..=0.6).contains(&point.0));
    panel.add(Series::dashed("2-3: part σ''", rest));
    panel.add(Series::line("1-3, straight path", direct.iter().copied()));
    panel.add(Series::markers("points 1, 2, 3", Marker::Circle, [(0.5, one), two, direct[100]]));
    figure.panel(panel);

    figure
        .close(
            "straight to 2, which lies on the virgin curve of ζ",
            follow(&after(&[(zeta, two.0)]))?.force(),
            two.1,
            Absolute(1e-14),
        )
        .source("(6.5), (6.36)");
    let pairs = linspace(0.0, 1.0, 101)
        .into_iter()
        .zip(&direct)
        .map(|(part, point)| (point.1, virgin_force(1.0 - 0.2 * part, point.0)));
    figure
        .all_close("every point lies on the virgin curve of its ζ", pairs, Absolute(1e-14))
        .source("(6.36)");
    let orders = [vec![(0.8, 0.6)], vec![(1.0, 0.6), (0.8, 0.6)], vec![(0.9, 0.6), (0.8, 0.6)]];
    let mut pairs = Vec::new();
    for order in &orders {
        pairs.push((follow(&after(order))?.force(), virgin_force(zeta, 0.6)));
    }
    figure
        .all_close("whatever the function ζ(ξ)", pairs, Absolute(1e-14))
        .source("text below (6.35)");
    let memory = follow(&FIRST)?;
    let (step, rate) = (1e-6, -2.0);
    let slope = (memory.clone().advance(1.0 + rate * step, 0.5 + step)? - one) / step;
    let stick = 0.5_f64.sqrt();
    figure
        .close(
            "slope at 1 for dζ/dX = -2",
            slope,
            1.5 * (rate + stick * (1.0 - rate)),
            Absolute(1e-5),
        )
        .source("(6.37)");
    springs_claim(&mut figure, "1-3", &after(&[(0.8, 0.6)]))?;
    reference_claim(
        &mut figure,
        "falling ζ",
        include_str!("../../../data/laws/history_shrinking.csv"),
    )?;
    figure.deviation(
        "reference to (6.7) before (6.36), to (6.30) in the caption",
        "(6.5), (6.36)",
        "slips of the text",
    );
    Ok(figure)
}
