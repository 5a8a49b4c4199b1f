//! Fig. 5.3: the parameters of the Hertz contact.

use crate::{Axis, Claim, Figure, FigureResult, Panel, Series, Tolerance, logspace};
use carom_laws::hertz::HertzParameters;
use carom_special::AxisRatio;

/// a/b, alpha, beta, gamma, delta to eight digits, by 40-digit arithmetic.
const REFERENCE: [[f64; 5]; 9] = [
    [1.0, 0.75, 1.0, 0.5, 0.5],
    [0.8, 0.541_667_96, 0.809_984_47, 0.582_948_32, 0.527_820_91],
    [0.6, 0.365_647_32, 0.639_677_32, 0.683_150_40, 0.563_004_18],
    [0.5, 0.289_118_33, 0.561_579_99, 0.739_769_92, 0.584_560_02],
    [0.4, 0.219_759_04, 0.487_718_14, 0.799_930_55, 0.609_859_36],
    [0.2, 0.100_315_57, 0.348_296_77, 0.922_036_88, 0.678_857_54],
    [0.1, 0.048_510_12, 0.274_917_00, 0.973_358_98, 0.732_407_07],
    [0.05, 0.023_989_18, 0.229_202_46, 0.991_571_54, 0.772_729_37],
    [0.01, 0.004_775_96, 0.166_946_45, 0.999_500_96, 0.833_136_86],
];

fn parameters(ratio: f64) -> Result<[f64; 4], carom_special::RangeError> {
    let p = HertzParameters::of(AxisRatio::new(ratio)?);
    Ok([p.alpha, p.beta, p.gamma, p.delta])
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("a/b", "0.01 to 1");
    let ratios = logspace(0.01, 1.0, 121);
    let mut panel = Panel::new(Axis::log("a/b"), Axis::linear("α, β, γ, δ"));
    let mut curves = Vec::new();
    for (i, name) in ["α", "β", "γ", "δ"].into_iter().enumerate() {
        let curve: Vec<(f64, f64)> = ratios
            .iter()
            .map(|&ratio| Ok((ratio, parameters(ratio)?[i])))
            .collect::<Result<_, carom_special::RangeError>>()?;
        panel.add(Series::line(name, curve.clone()));
        curves.push(curve);
    }
    figure.panel(panel);
    let mut pairs = Vec::new();
    for row in REFERENCE {
        pairs.extend(parameters(row[0])?.into_iter().zip(row[1..].iter().copied()));
    }
    figure.claim(
        Claim::all_close("α, β, γ, δ at nine ratios", pairs, Tolerance::Absolute(6e-9))
            .source("40-digit arithmetic"),
    );
    let values = |i: usize| curves[i].iter().map(|point| point.1).collect::<Vec<_>>();
    figure.claim(Claim::increasing("α rises with a/b", values(0)).source("shape of the curve"));
    figure.claim(Claim::increasing("β rises with a/b", values(1)).source("shape of the curve"));
    figure.claim(Claim::decreasing("γ falls with a/b", values(2)).source("shape of the curve"));
    figure.claim(Claim::decreasing("δ falls with a/b", values(3)).source("shape of the curve"));
    let slender = parameters(1e-300)?;
    figure.claim(
        Claim::close("γ → 1 for a line contact", slender[2], 1.0, Tolerance::Absolute(1e-15))
            .source("limit of (5.12)"),
    );
    figure.claim(
        // delta = (L - 1)/L with L = ln(4 b/a)
        Claim::close(
            "δ → 1 like the logarithm",
            slender[3],
            1.0 - 1.0 / (4.0_f64.ln() + 300.0 * 10.0_f64.ln()),
            Tolerance::Absolute(1e-15),
        )
        .source("asymptotes of K and D"),
    );
    Ok(figure)
}
