//! Figs. 6.3, 6.5, 6.8, 6.10: tangential force against shift.

use super::path::led;
use crate::{Axis, Claim, Figure, FigureResult, Panel, Series, Tolerance, linspace};
use carom_laws::memory::ScalarMemory;

/// Force over that of sliding at ζ = 1 along a straight way, from a state that moves.
fn trace(
    memory: &mut ScalarMemory,
    to: (f64, f64),
    points: usize,
) -> Result<Vec<(f64, f64)>, carom_special::RangeError> {
    let from = (memory.zeta(), memory.shift());
    let mut curve = vec![(memory.shift(), memory.force())];
    for t in linspace(0.0, 1.0, points).into_iter().skip(1) {
        let zeta = from.0 + t * (to.0 - from.0);
        let x = from.1 + t * (to.1 - from.1);
        let force = memory.advance(zeta, x)?;
        curve.push((x, force));
    }
    Ok(curve)
}

fn virgin(zeta: f64, x: f64) -> f64 {
    zeta.powf(1.5) - (zeta - x).powf(1.5)
}

fn panel() -> Panel {
    Panel::new(Axis::linear("ξ/(f κ ζ)"), Axis::linear("F_x/(f F_z)"))
}

pub(super) fn draw_virgin() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("axes", "ξ/(f κ ζ), F_x/(f F_z)");
    let mut memory = led(&[(1.0, 0.0)])?;
    let curve = trace(&mut memory, (1.0, 1.2), 121)?;
    let mut plot = panel();
    plot.add(Series::line("(6.14)", curve.clone()));
    figure.panel(plot);
    let inside = curve.iter().filter(|p| p.0 <= 1.0).map(|p| (p.1, virgin(1.0, p.0.min(1.0))));
    figure.claim(
        Claim::all_close("F_x of (6.14)", inside, Tolerance::Absolute(1e-14)).source("closed form"),
    );
    let slope = led(&[(1.0, 0.0), (1.0, 1e-9)])?.force() / 1e-9;
    figure.claim(
        Claim::close("initial slope 3/2 (8 G a/(2 − ν))", slope, 1.5, Tolerance::Relative(1e-8))
            .source("Mindlin (5.30)"),
    );
    let end = led(&[(1.0, 0.0), (1.0, 1.0 - 1e-8)])?;
    figure.claim(
        Claim::at_most("horizontal tangent at sliding", end.tangent().by_shift[0][0], 2e-4)
            .source("(6.15)"),
    );
    Ok(figure)
}

pub(super) fn draw_loop() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("ξ₁/(f κ ζ)", "0.6");
    let mut memory = led(&[(1.0, 0.0)])?;
    let mut plot = panel();
    plot.add(Series::line("loading", trace(&mut memory, (1.0, 0.6), 61)?));
    let top = memory.force();
    let down = trace(&mut memory, (1.0, -0.6), 121)?;
    plot.add(Series::line("unloading", down.clone()));
    figure.claim(
        Claim::close("F(−ξ₁) = −F(ξ₁)", memory.force(), -top, Tolerance::Absolute(1e-14))
            .source("symmetry of the loop"),
    );
    plot.add(Series::line("reloading", trace(&mut memory, (1.0, 0.6), 121)?));
    figure.panel(plot);
    figure.claim(
        Claim::close("the loop closes", memory.force(), top, Tolerance::Absolute(1e-14))
            .source("return-point memory"),
    );
    let back = led(&[(1.0, 0.0), (1.0, 0.6), (1.0, 0.6 - 1e-8)])?;
    figure.claim(
        Claim::close(
            "the unloading starts as steeply as the loading",
            (top - back.force()) / 1e-8,
            1.5,
            Tolerance::Relative(1e-6),
        )
        .source("(6.21), sign corrected"),
    );
    let mut pairs = Vec::new();
    for (x, set) in [(0.3, 0.013_235_6), (0.5, 0.041_677_7), (0.6, 0.064_333_3), (0.9, 0.186_344_5)]
    {
        let force = led(&[(1.0, 0.0), (1.0, x), (1.0, set)])?.force();
        pairs.push((force, 0.0));
    }
    figure.claim(
        Claim::all_close(
            "permanent set at F = 0 for ξ₁ = 0.3, 0.5, 0.6, 0.9",
            pairs,
            Tolerance::Absolute(1e-7),
        )
        .source("ζ*/ζ = {[1 + (1 − x)^(3/2)]/2}^(2/3)"),
    );
    figure.deviation("dF_x/dξ = −8 G a*/(2 − ν)", "dF_x/dξ = +8 G a*/(2 − ν)", "sign of (6.21)");
    Ok(figure)
}

pub(super) fn draw_increasing() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("path", "shift 0.5 at ζ = 1, compression to ζ = 1.2, shift on to 0.7 and 1.1");
    let mut memory = led(&[(1.0, 0.0)])?;
    let mut plot = panel();
    plot.add(Series::line("0 − 1", trace(&mut memory, (1.0, 0.5), 51)?));
    memory.advance(1.2, 0.5)?;
    let begin = memory.force();
    plot.add(Series::line("1 − 2", trace(&mut memory, (1.2, 0.7), 41)?));
    figure.claim(
        Claim::close(
            "at ξ₁ + f κ dζ the stick radius is the old one",
            memory.stick_depth(),
            0.5,
            Tolerance::Absolute(1e-14),
        )
        .source("section 6.3"),
    );
    let on = trace(&mut memory, (1.2, 1.1), 41)?;
    plot.add(Series::line("2 − 3", on.clone()));
    let whole = linspace(0.0, 1.1, 111).into_iter().map(|x| (x, virgin(1.2, x)));
    plot.add(Series::dotted("virgin curve of ζ = 1.2", whole));
    figure.panel(plot);
    figure.claim(
        Claim::all_close(
            "from 2 on it is the virgin curve",
            on.iter().map(|p| (p.1, virgin(1.2, p.0))),
            Tolerance::Absolute(1e-14),
        )
        .source("(6.32)"),
    );
    let small = led(&[(1.0, 0.0), (1.0, 0.5), (1.2, 0.5), (1.2, 0.5 + 1e-8)])?;
    figure.claim(
        Claim::close(
            "1 − 2 starts with 8 G a/(2 − ν)",
            (small.force() - begin) / 1e-8,
            1.5 * 1.2_f64.sqrt(),
            Tolerance::Relative(1e-6),
        )
        .source("Mindlin (5.30)"),
    );
    Ok(figure)
}

pub(super) fn draw_decreasing() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("path", "shift 0.5 at ζ = 1, to (0.8, 0.55) by three ways, shift on to 0.75");
    let mut plot = panel();
    let ways: [&[(f64, f64)]; 3] =
        [&[(0.8, 0.55)], &[(0.8, 0.5), (0.8, 0.55)], &[(1.0, 0.55), (0.8, 0.55)]];
    let mut ends = Vec::new();
    for (i, way) in ways.into_iter().enumerate() {
        let mut memory = led(&[(1.0, 0.0), (1.0, 0.5)])?;
        let mut curve = Vec::new();
        for &to in way {
            curve.extend(trace(&mut memory, to, 21)?);
        }
        ends.push((memory.force(), virgin(0.8, 0.55)));
        curve.extend(trace(&mut memory, (0.8, 0.75), 21)?);
        ends.push((memory.force(), virgin(0.8, 0.75)));
        plot.add(Series::line(format!("way {}", i + 1), curve));
    }
    let whole = linspace(0.0, 0.8, 81).into_iter().map(|x| (x, virgin(0.8, x)));
    plot.add(Series::dotted("virgin curve of ζ = 0.8", whole));
    figure.panel(plot);
    figure.claim(
        Claim::all_close(
            "every way ends on the virgin curve of the smaller ζ",
            ends,
            Tolerance::Absolute(1e-14),
        )
        .source("(6.37)"),
    );
    Ok(figure)
}
