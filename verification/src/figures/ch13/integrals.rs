//! Table 13.1: the integrals of the convergence estimates.

use crate::{Absolute, Cell, Figure, FigureResult, Table};
use carom_halfspace::{Offset, Rectangle, RectangleIntegrals};
use carom_special::RangeError;

/// What the thesis prints.
const PRINTED_E: [f64; 9] = [7.051, 2.0761, 1.0102, 0.6697, 0.5013, 0.4007, 0.3372, 0.2860, 0.2502];
const PRINTED_F: [f64; 9] =
    [0.0, -1.9692, -0.9990, -0.6653, -0.5000, -0.4000, -0.3333, -0.2857, -0.2500];

/// Values of 30-digit arithmetic, rounded to ten.
const EXACT_E: [f64; 9] = [
    7.050988696,
    2.076099472,
    1.010183966,
    0.669722740,
    0.501294915,
    0.400664323,
    0.333718195,
    0.285956805,
    0.250162537,
];
const EXACT_F: [f64; 9] = [
    0.0,
    -1.969144912,
    -0.998963717,
    -0.666529633,
    -0.499967458,
    -0.399989335,
    -0.333329047,
    -0.285712303,
    -0.249998983,
];

/// Square cells of half side 1 in a row, at k cells from the receiver.
fn integrals() -> Result<Vec<RectangleIntegrals>, RangeError> {
    let cell = Rectangle::new(2.0, 2.0)?;
    (0..9).map(|k| cell.integrals(Offset { x: 2.0 * f64::from(k), y: 0.0 })).collect()
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("cells", "squares in one row, distance k cells; unit Δx");
    let found = integrals()?;
    let e: Vec<f64> = found.iter().map(|i| i.inverse_distance).collect();
    let f: Vec<f64> = found.iter().map(|i| -i.log_x).collect();
    let mut table = Table::new(
        "e = ∫dS/r, f = ∫∂(ln r)/∂x dS, g = 4a²/r",
        ["k", "e", "e printed", "f", "f printed", "g"],
    );
    for k in 0..9 {
        let g = if k == 0 { Cell::from("∞") } else { Cell::from(2.0 / k as f64) };
        let row = [k as f64, e[k], PRINTED_E[k], f[k], PRINTED_F[k]].map(Cell::from);
        table.row(row.into_iter().chain([g]));
    }
    figure.table(table);

    let pairs = |a: &[f64], b: [f64; 9]| a.iter().copied().zip(b).collect::<Vec<_>>();
    let ten = Absolute(6e-10);
    figure.all_close("e", pairs(&e, EXACT_E), ten).source("30-digit arithmetic");
    figure.all_close("f", pairs(&f, EXACT_F), ten).source("30-digit arithmetic");
    let wrong = wrong_digits(&e, PRINTED_E).chain(wrong_digits(&f, PRINTED_F)).count();
    figure
        .close("three printed values are wrong", wrong as f64, 3.0, Absolute(0.0))
        .source("errors above half of the last printed digit");
    for (name, values, printed) in [("e", &e, PRINTED_E), ("f", &f, PRINTED_F)] {
        for k in wrong_digits(values, printed) {
            figure.deviation(
                format!("{name}({k}) = {:.4}", printed[k]),
                format!("{:.4}", values[k]),
                "a digit, in the thesis or in its scan",
            );
        }
    }
    // (13.5) replaces e and f by g: for k = 1 the ratio f/e is off by less than 6 %.
    let ratio = (f[1] / e[1]).abs();
    figure
        .at_most("error of (13.5) for k = 1 below 6 %", 1.0 - ratio, 0.06)
        .source("text below Table 13.1");
    let falling = (1..9).map(|k| 1.0 - (f[k] / e[k]).abs());
    figure.decreasing("and it decreases with k", falling).source("text below Table 13.1");
    Ok(figure)
}

/// Where a value does not round to the printed one.
fn wrong_digits(values: &[f64], printed: [f64; 9]) -> impl Iterator<Item = usize> + use<'_> {
    let off = move |(k, (value, print)): (usize, (f64, f64))| {
        ((value - print).abs() > 0.5001e-4).then_some(k)
    };
    values.iter().copied().zip(printed).enumerate().filter_map(off)
}
