//! Figs. 6.4 and 6.5: the shift decreases at constant approach.

use carom_special::roots::try_bisect;

use super::history::{
    Place, add_terms, follow, force_panel, path, profile, reference_claim, springs_claim,
    stress_claims, stress_panel, virgin, virgin_force,
};
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Relative, Series};

const PEAK: f64 = 0.6;

/// Fig. 6.4.
pub(super) fn stress() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("ξ₁, ξ over f κ ζ₁", "0.6, 0.2");
    let history = [(1.0, 0.0), (1.0, PEAK), (1.0, 0.2)];
    // zeta* = zeta - (X_1 - X)/2, (6.19).
    let terms = [(1.0, 1.0, 0.4), (-2.0, 1.0, 0.8)];
    let mut panel = stress_panel("While unloading (6.17)");
    add_terms(&mut panel, &["σ_CM(a, a₁*)", "-2 σ_CM(a, a*)"], &terms, "σ_zx");
    panel.add(Series::dotted("-f p_z", profile(&[1.0], |rho| -(1.0 - rho * rho).max(0.0).sqrt())));
    figure.panel(panel);
    stress_claims(&mut figure, "X = 0.2", &history, &terms, "(6.17)")?;
    let memory = follow(&history)?;
    figure.close("(a*/a)²", memory.stick_depth(), 0.8, Absolute(1e-15)).source("(6.20), corrected");
    let inner: Vec<f64> = memory.instantaneous_adhesions().collect();
    figure
        .close("live points of instantaneous adhesion", inner.len() as f64, 1.0, Absolute(0.0))
        .source("P₁ of (6.17)");
    let outside = super::history::stress(&memory, 0.95) + (1.0 - 0.95_f64 * 0.95).sqrt();
    figure.close("-f p_z in the outer ring", outside, 0.0, Absolute(1e-15)).source("Coulomb");
    figure.deviation(
        "the square root of (6.20) with ξ/ζ confused",
        "a* = sqrt(R ζ) sqrt(1 - |ξ₁ - ξ|/(2 f κ ζ))",
        "misread symbols",
    );
    Ok(figure)
}

/// Fig. 6.5.
pub(super) fn force_loop() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("ξ₁/(f κ ζ₁)", "0.6, to -0.6 and back");
    let loaded = follow(&[(1.0, 0.0), (1.0, PEAK)])?;
    let unloading = path(&loaded, (1.0, -PEAK))?;
    let turned = follow(&[(1.0, 0.0), (1.0, PEAK), (1.0, -PEAK)])?;
    let reloading = path(&turned, (1.0, PEAK))?;
    let set = permanent_set(PEAK)?;
    let mut panel = force_panel("Loading, unloading, reloading");
    panel.add(Series::dashed("virgin curve (6.14)", virgin(1.0)));
    panel.add(Series::line("unloading (6.18)", unloading.iter().copied()));
    panel.add(Series::line("reloading", reloading.iter().copied()));
    panel.add(Series::markers("permanent set", Marker::Circle, [(set, 0.0)]));
    figure.panel(panel);

    let force = |shift: f64| {
        let stick = 1.0 - 0.5 * (PEAK - shift);
        2.0 * stick * stick.sqrt() - 1.0 - 0.4 * 0.4_f64.sqrt()
    };
    let pairs = unloading.iter().map(|&(shift, f)| (f, force(shift)));
    figure.all_close("unloading", pairs, Absolute(1e-14)).source("(6.18), (6.20), corrected");
    let mirrored = unloading.iter().zip(&reloading).map(|(down, up)| (up.1, -down.1));
    figure
        .all_close("reloading is unloading turned by 180°", mirrored, Absolute(1e-14))
        .source("Masing's rule");
    figure
        .close("F(-ξ₁) = -F(ξ₁)", turned.force(), -virgin_force(1.0, PEAK), Absolute(1e-15))
        .source("(6.14), (6.18)");
    let slope = |points: &[(f64, f64)], i: usize| {
        (points[i + 1].1 - points[i].1) / (points[i + 1].0 - points[i].0)
    };
    let step = PEAK * 0.02;
    let virgin_slope = (virgin_force(1.0, PEAK) - virgin_force(1.0, PEAK - step)) / step;
    figure
        .close(
            "tangent to the virgin curve at -ξ₁",
            slope(&unloading, 99),
            virgin_slope,
            Absolute(0.01),
        )
        .source("(6.21), corrected: 8Ga*/(2 - ν) with a* = a₁*");
    let first = loaded.clone().advance(1.0, PEAK - 1e-7)?;
    figure
        .close("initial slope of unloading", (loaded.force() - first) / 1e-7, 1.5, Absolute(1e-6))
        .source("text below (6.21): that of first loading");
    set_claims(&mut figure)?;
    let area: f64 = [&unloading, &reloading]
        .iter()
        .flat_map(|side| side.windows(2))
        .map(|w| 0.5 * (w[0].1 + w[1].1) * (w[1].0 - w[0].0))
        .sum();
    // int F dX over the loop of (6.18): per half 2 X_1 F_1 - 2 int ... in closed form.
    figure
        .close("work lost in the loop", area, loop_work(PEAK), Relative(1e-3))
        .source("closed form of ∮F dξ (Mindlin)");
    let history: Vec<Place> = [0.0, 0.6, 0.2, -0.6, 0.1, 0.6].map(|shift| (1.0, shift)).to_vec();
    springs_claim(&mut figure, "loop", &history)?;
    reference_claim(
        &mut figure,
        "loops within loops",
        include_str!("../../../data/laws/history_loop.csv"),
    )?;
    figure.deviation(
        "|ΔF_x| = -(4πμ/3)(a³ - a*³) in (6.18)",
        "F_x - F_x1 = -(4πμ/3)(a³ - a*³)",
        "misprint: a magnitude cannot be negative",
    );
    figure.deviation(
        "dF_x/dξ = -8Ga*/(2 - ν) in (6.21)",
        "+8Ga*/(2 - ν)",
        "misprint of the sign; the text says that the slope equals that of loading",
    );
    Ok(figure)
}

/// `oint F dX`: with s = 1 - (X_1 - X)/2 each side is a power of s.
fn loop_work(peak: f64) -> f64 {
    let rest = 1.0 - peak;
    let power = |x: f64| x * x * x.sqrt();
    // Unloading: int_{-X_1}^{X_1} (2 s^{3/2} - 1 - r^{3/2}) dX, and the same on the way back.
    let side = 1.6 * (1.0 - power(rest)) - 2.0 * peak * (1.0 + rest * rest.sqrt());
    -2.0 * side
}

/// The shift at which the force vanishes on unloading from `peak`, by bisection.
fn permanent_set(peak: f64) -> Result<f64, Failure> {
    let loaded = follow(&[(1.0, 0.0), (1.0, peak)])?;
    let pulls = |shift: f64| Ok::<_, Failure>(loaded.clone().advance(1.0, shift)? > 0.0);
    let [low, high] = try_bisect([-peak, peak], 60, |shift| Ok::<_, Failure>(!pulls(shift)?))?;
    Ok(0.5 * (low + high))
}

fn set_claims(figure: &mut Figure) -> Result<(), Failure> {
    let mut pairs = Vec::new();
    for (peak, expected) in
        [(0.3, 0.013_235_6), (0.5, 0.041_677_7), (0.6, 0.064_333_3), (0.9, 0.186_344_5)]
    {
        pairs.push((permanent_set(peak)?, expected));
    }
    figure
        .all_close("permanent set after ξ₁ = 0.3, 0.5, 0.6, 0.9", pairs, Absolute(1e-7))
        .source("F_x = 0 in (6.18)");
    Ok(())
}
