//! Coefficients of eleven pairs: the measured beta_0 of sticking impacts beside the mean one of the elastic
//! theory.

use carom_halfspace::{Material, MaterialPair};

use super::models::{bars, elastic};
use crate::reference::reader;
use crate::{
    Absolute, Axis, Cell, Failure, Figure, FigureResult, Marker, Panel, Series, Table, linspace,
};

struct Measured {
    name: String,
    normal: [f64; 2],
    beta: [f64; 2],
    friction: [f64; 2],
    kappa: f64,
    reference: f64,
}

fn read() -> Result<Vec<Measured>, Failure> {
    let mut reader = reader(include_str!("../../../data/measured/coefficients.csv"));
    let parse = |record: csv::StringRecord| -> Result<Measured, Failure> {
        let field = |i: usize| -> Result<f64, Failure> {
            Ok(record.get(i).ok_or("a row is short")?.parse()?)
        };
        let body = |i| -> Result<Material, Failure> {
            Ok(Material::from_young(1e9 * field(i)?, field(i + 1)?)?)
        };
        Ok(Measured {
            name: record.get(0).unwrap_or_default().to_owned(),
            normal: [field(1)?, field(2)?],
            beta: [field(3)?, field(4)?],
            friction: [field(5)?, field(6)?],
            kappa: MaterialPair::new(body(7)?, body(9)?)?.kappa(),
            reference: field(11)?,
        })
    };
    reader.records().map(|record| parse(record?)).collect()
}

/// The line through the origin that fits the slip after against the slip before best, over the
/// branch that sticks: up to lambda = 7/(1 + beta_0), each lambda alike.
fn fitted(kappa: f64) -> Result<f64, Failure> {
    let mut beta = 0.4;
    for _ in 0..12 {
        let (mut above, mut below) = (0.0, 0.0);
        for lambda in linspace(0.0, 7.0 / (1.0 + beta), 201).into_iter().skip(1) {
            above += lambda * lambda * elastic(kappa, lambda, 1.0)?;
            below += lambda * lambda;
        }
        beta = above / below;
    }
    Ok(beta)
}

/// The names of a pair as short as they are below an axis.
fn short(pair: &Measured) -> String {
    let mut name = pair.name.replace(" on itself", "");
    for (long, short) in
        [("smooth aluminium plate", "aluminium"), ("Zerodur plate in air", "Zerodur")]
    {
        name = name.replace(long, short);
    }
    name
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated(
        "measured",
        "Cornell impact chart of 1999; Joseph and Hunt 2004, J. Fluid Mech. 510, 71",
    );
    figure.assumed("moduli and ν", "usual ones of the materials, listed with the data");
    figure.assumed("β₀ of theory", "fitted to the elastic curve, not to the measurements");
    let pairs = read()?;
    let mut table = Table::new(
        "Measured coefficients, and the β₀ of elastic theory",
        ["pair", "e", "f", "β₀ measured", "±", "β₀ elastic", "deviations"],
    )
    .shown_to(3);
    let (mut deviations, mut references) = (Vec::new(), Vec::new());
    let (mut dots, mut ends, mut lines) = (Vec::new(), Vec::new(), Vec::new());
    for (i, one) in pairs.iter().enumerate() {
        let (beta, row) = (fitted(one.kappa)?, i as f64 + 1.0);
        let deviation = (one.beta[0] - beta) / one.beta[1];
        let with_error = |[value, error]: [f64; 2]| Cell::from(format!("{value} ± {error}"));
        table.row([
            one.name.as_str().into(),
            with_error(one.normal),
            with_error(one.friction),
            one.beta[0].into(),
            one.beta[1].into(),
            beta.into(),
            deviation.into(),
        ]);
        references.push((beta, one.reference));
        dots.push((row, one.beta[0]));
        ends.push([row, one.beta[0] - one.beta[1], one.beta[0] + one.beta[1]]);
        lines.push((row, beta));
        if !one.name.starts_with("polyurethane") {
            deviations.push((one.name.clone(), deviation));
        }
    }
    let mut panel = Panel::new(Axis::named("", pairs.iter().map(short)), "β₀");
    panel.add(Series::markers("elastic theory", Marker::Square, lines));
    bars(ends).into_iter().for_each(|bar| panel.add(bar));
    panel.add(Series::markers("measured", Marker::Dot, dots).coloured(6));
    figure.panel(panel);
    figure.table(table);
    claims(&mut figure, &deviations, references);
    figure.deviation(
        "chrome steel: β₀ = 0.54 ± 0.05",
        "0.40 by elastic theory, 2.8 deviations below",
        "unknown; its printed friction has no uncertainty",
    );
    Ok(figure)
}

fn claims(figure: &mut Figure, deviations: &[(String, f64)], references: Vec<(f64, f64)>) {
    figure
        .all_close("β₀ of the elastic curve", references, Absolute(4e-3))
        .source("independent program, by reduced dimensionality");
    let near = deviations.iter().filter(|(_, deviation)| deviation.abs() <= 1.6).count();
    figure
        .close(
            "pairs of the ten but for polyurethane within 1.6 deviations",
            near as f64,
            9.0,
            Absolute(0.0),
        )
        .source("chart and paper; nothing fitted");
    let steel = deviations.iter().find(|(name, _)| name.starts_with("chrome steel"));
    figure
        .close(
            "chrome steel, in deviations",
            steel.map_or(f64::NAN, |(_, deviation)| *deviation),
            2.8,
            Absolute(0.1),
        )
        .source("chart, and an independent program");
}
