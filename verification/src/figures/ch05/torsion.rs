//! Figs. 5.5 and 5.6: torsion with complete adhesion and with slip.

use crate::{Axis, Claim, Figure, FigureResult, Panel, Series, Tolerance, linspace, logspace};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::torsion::adhesion::AdhesiveTorsion;
use carom_laws::torsion::lubkin::{Lubkin, SLIDING_TORQUE, approximate_torque};

const POISSON: [f64; 4] = [0.0, 0.25, 0.3, 0.5];
/// a/b and 16 G b^3 beta/(3 M_z) for the four ratios of Poisson.
const COMPLIANCE: [[f64; 5]; 6] = [
    [1.0, 1.0, 1.0, 1.0, 1.0],
    [0.8, 1.371_771_7, 1.366_371_1, 1.365_105_5, 1.359_225_0],
    [0.5, 2.374_753_3, 2.295_620_2, 2.277_625_9, 2.196_608_8],
    [0.2, 4.807_447_9, 4.274_912_1, 4.162_639_6, 3.692_532_4],
    [0.1, 6.708_957_3, 5.701_710_6, 5.496_046_4, 4.658_843_2],
    [0.05, 8.554_139_3, 7.070_100_1, 6.771_152_6, 5.568_144_2],
];
/// Twist, a*/a, torque exact and by (5.42).
const SLIP: [[f64; 4]; 8] = [
    [0.02, 0.947_387_19, 0.098_503_331_31, 0.097_566_397_72],
    [0.05, 0.871_256_15, 0.218_903_088_3, 0.214_470_143_6],
    [0.1, 0.752_235_69, 0.361_861_948_0, 0.350_852_603_6],
    [0.15, 0.643_636_54, 0.452_723_224_5, 0.437_578_779_4],
    [0.2, 0.545_931_30, 0.508_952_288_8, 0.492_728_316_7],
    [0.3, 0.383_581_31, 0.562_871_321_5, 0.550_099_183_5],
    [0.4, 0.262_726_23, 0.580_960_435_2, 0.573_298_477_4],
    [0.5, 0.176_826_42, 0.586_639_615_2, 0.582_679_671_4],
];

/// 16 G b^3 beta/(3 M_z).
fn compliance(ratio: f64, nu: f64) -> Result<f64, carom_special::RangeError> {
    let pair = MaterialPair::new(Material::from_shear(1.0, nu)?, Material::RIGID)?;
    let torsion = AdhesiveTorsion::new(ContactEllipse::new(ratio, 1.0)?, pair);
    Ok(16.0 / (3.0 * torsion.stiffness()))
}

pub(super) fn draw_compliance() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("ν", "0, 0.25, 0.3, 0.5");
    figure.assumed("axes", "a/b, 16 G b³ β/(3 M_z)");
    let mut panel = Panel::new(Axis::log("a/b"), Axis::linear("16 G b³ β/(3 M_z)"));
    for nu in POISSON {
        let curve: Result<Vec<_>, _> = logspace(0.05, 1.0, 61)
            .into_iter()
            .map(|ratio| compliance(ratio, nu).map(|value| (ratio, value)))
            .collect();
        panel.add(Series::line(format!("ν = {nu}"), curve?));
    }
    figure.panel(panel);
    let mut pairs = Vec::new();
    let mut swapped = Vec::new();
    for row in COMPLIANCE {
        for (nu, want) in POISSON.into_iter().zip(&row[1..]) {
            pairs.push((compliance(row[0], nu)?, *want));
            // The same ellipse with its axes exchanged: b grows by b/a.
            let other = compliance(1.0 / row[0], nu)? / row[0].powi(3);
            swapped.push((other, compliance(row[0], nu)?));
        }
    }
    figure.claim(
        Claim::all_close("compliance at six ratios", pairs, Tolerance::Absolute(6e-8))
            .source("40-digit arithmetic, checked by quadrature"),
    );
    figure.claim(
        Claim::all_close("exchanging a and b changes nothing", swapped, Tolerance::Relative(1e-13))
            .source("symmetry"),
    );
    let falling: Result<Vec<_>, _> =
        linspace(0.0, 0.5, 11).into_iter().map(|nu| compliance(0.2, nu)).collect();
    figure.claim(Claim::decreasing("it falls with ν", falling?).source("(5.35)"));
    let pair = MaterialPair::new(Material::from_shear(1.0, 0.5)?, Material::RIGID)?;
    let [one, two] = AdhesiveTorsion::new(ContactEllipse::new(0.3, 1.0)?, pair).coefficients();
    figure.claim(
        Claim::close("T' = T'' for ν = 0.5", one, two, Tolerance::Relative(1e-14)).source("(5.34)"),
    );
    figure.deviation("σ_zy = T'' x/s", "σ_zy = −T'' x/s", "sign of (5.32)");
    Ok(figure)
}

pub(super) fn draw_slip() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("axes", "G a² β/(f F_z), M_z/(f F_z a)");
    let twists = linspace(0.0, 0.6, 121);
    let exact: Vec<(f64, f64)> = twists
        .iter()
        .map(|&twist| Lubkin::at_twist(twist).map(|state| (twist, state.torque())))
        .collect::<Result<_, _>>()?;
    let mut panel = Panel::new(Axis::linear("G a² β/(f F_z)"), Axis::linear("M_z/(f F_z a)"));
    panel.add(Series::line("(5.41)", exact.clone()));
    let approximate = |&twist: &f64| (twist, approximate_torque(twist));
    panel.add(Series::dashed("(5.42)", twists.iter().map(approximate)));
    panel.add(Series::dotted("3π/16", [(0.0, SLIDING_TORQUE), (0.6, SLIDING_TORQUE)]));
    figure.panel(panel);
    let (mut pairs, mut approximations) = (Vec::new(), Vec::new());
    for [twist, stick, torque, formula] in SLIP {
        let state = Lubkin::at_twist(twist)?;
        pairs.push((state.torque(), torque));
        pairs.push((state.stick_radius(), stick));
        approximations.push((approximate_torque(twist), formula));
    }
    figure.claim(
        Claim::all_close("torque and stick radius", pairs, Tolerance::Absolute(6e-9))
            .source("40-digit arithmetic"),
    );
    figure.claim(
        Claim::all_close("approximation (5.42)", approximations, Tolerance::Absolute(6e-9))
            .source("40-digit arithmetic"),
    );
    let mut worst = [0.0_f64; 3];
    for twist in logspace(1e-4, 15.0, 4001) {
        let torque = Lubkin::at_twist(twist)?.torque();
        let short = torque - approximate_torque(twist);
        worst[0] = worst[0].max(short / SLIDING_TORQUE);
        worst[1] = worst[1].max(short / torque);
        worst[2] = worst[2].max(-short / torque);
    }
    figure.claim(
        Claim::close(
            "(5.42) is at most 2.756 % of the sliding torque off",
            worst[0],
            0.027_559_8,
            Tolerance::Absolute(1e-6),
        )
        .source("\"maximal error 3 %\", measured"),
    );
    figure.claim(
        Claim::close(
            "or 3.346 % of the torque itself",
            worst[1],
            0.033_464_5,
            Tolerance::Absolute(1e-6),
        )
        .source("40-digit scan"),
    );
    figure.claim(Claim::at_most("and never above", worst[2], 1e-14).source("40-digit scan"));
    let slope = Lubkin::at_twist(1e-9)?.torque() / 1e-9;
    figure.claim(
        Claim::close("initial slope", slope, 16.0 / 3.0, Tolerance::Relative(1e-8))
            .source("(5.35) for the circle"),
    );
    let last = Lubkin::at_twist(30.0)?.torque();
    figure.claim(
        Claim::close("sliding torque", last, SLIDING_TORQUE, Tolerance::Relative(1e-15))
            .source("3π/16"),
    );
    figure.deviation("k'²/(4π) in (5.41)", "k' k²/(4π)", "factor of (5.40), (5.41)");
    figure.deviation(
        "maximal error 3 %",
        "2.76 % of the sliding torque, 3.35 % of the torque itself",
        "measured",
    );
    Ok(figure)
}
