//! Foerster, Louge, Chang and Allia's impacts of two glass spheres, one by one.

use super::models::{Spring, bars, constant, elastic, rms, spring};
use crate::reference::rows;
use crate::spheres::kappa;
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series, linspace};

const NU: f64 = 0.22;
const FRICTION: f64 = 0.092;
const NORMAL: f64 = 0.97;
const BETA: f64 = 0.44;
/// Of the slip after, m/s.
const ERROR: f64 = 0.06;

struct Impact {
    normal: f64,
    tangential: f64,
    slip_after: f64,
    reference: f64,
}

impl Impact {
    fn lambda(&self) -> f64 {
        self.tangential / (FRICTION * self.normal)
    }
}

fn read() -> Result<Vec<Impact>, Failure> {
    let impact = |[normal, tangential, _, slip_after, reference]: [f64; 5]| Impact {
        normal,
        tangential,
        slip_after,
        reference,
    };
    let rows = rows(include_str!("../../../data/measured/glass_pairs.csv"))?;
    Ok(rows.into_iter().map(impact).collect())
}

fn curves(panel: &mut Panel) -> Result<(), Failure> {
    let slopes = linspace(0.01, 1.7, 170);
    let walk = |slope: &f64| Ok((*slope, -slope * elastic(kappa(NU), slope / FRICTION, NORMAL)?));
    let exact: Result<Vec<(f64, f64)>, Failure> = slopes.iter().map(walk).collect();
    panel.add(Series::line("carom, no number fitted", exact?));
    let line = |model: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        slopes.iter().map(|slope| (*slope, -slope * model(slope / FRICTION))).collect()
    };
    panel.add(Series::dashed("constant coefficients", line(&|l| constant(BETA, l, NORMAL))));
    let hertz = line(&|l| spring(Spring::Hertzian, kappa(NU), l));
    panel.add(Series::dotted("code: Hertz and a spring, e = 1", hertz));
    let linear = line(&|l| spring(Spring::Linear, kappa(NU), l));
    panel.add(Series::dotted("code: two linear springs, e = 1", linear).coloured(4));
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("bodies", "two spheres of soda-lime glass, 3.18 mm");
    figure.stated("coefficients", "e = 0.97 ± 0.01, f = 0.092 ± 0.006, β₀ = 0.44 ± 0.07");
    figure.stated("measured", "Foerster, Louge, Chang and Allia 1994, Physics of Fluids 6, 1108");
    figure.assumed("ν", "0.22, of soda-lime glass");
    figure.assumed("e in carom", "the friction impulse is (1 + e)/2 of the elastic one");
    let impacts = read()?;
    let mut panel = Panel::new("ψ₁ = v_t/v_n before", "ψ₂ = slip after over v_n")
        .titled("Slip after against slip before");
    curves(&mut panel)?;
    let ends = impacts.iter().map(|one| {
        let (x, y) = (one.tangential / one.normal, one.slip_after / one.normal);
        [x, y - ERROR / one.normal, y + ERROR / one.normal]
    });
    bars(ends).into_iter().for_each(|bar| panel.add(bar));
    let dots = impacts.iter().map(|one| (one.tangential / one.normal, one.slip_after / one.normal));
    panel.add(Series::markers("measured", Marker::Dot, dots).coloured(6));
    figure.panel(panel);
    claims(&mut figure, &impacts)?;
    Ok(figure)
}

fn claims(figure: &mut Figure, impacts: &[Impact]) -> Result<(), Failure> {
    let (mut found, mut walton, mut pairs) = (Vec::new(), Vec::new(), Vec::new());
    for one in impacts {
        let after = -one.tangential * elastic(kappa(NU), one.lambda(), NORMAL)?;
        found.push(after - one.slip_after);
        walton.push(-one.tangential * constant(BETA, one.lambda(), NORMAL) - one.slip_after);
        pairs.push((after / one.normal, one.reference));
    }
    let source = "Foerster et al. 1994; the error of one impact is about 0.06 m/s";
    figure.at_most("slip after: rms in m/s, 24 impacts", rms(&found), 0.067).source(source);
    let mean = found.iter().sum::<f64>() / found.len() as f64;
    let limit = 2.0 * ERROR / (found.len() as f64).sqrt();
    figure
        .at_most("slip after: size of the mean in m/s", mean.abs(), limit)
        .source("two errors of the mean of 24 impacts");
    figure
        .all_close("slip after over v_n, each impact", pairs, Absolute(1.5e-3))
        .source("independent program, by reduced dimensionality");
    figure
        .close(
            "constant coefficients, fitted to these impacts: rms in m/s",
            rms(&walton),
            0.062,
            Absolute(1e-3),
        )
        .source("the same in an independent program; not better than theory with nothing fitted");
    Ok(())
}
