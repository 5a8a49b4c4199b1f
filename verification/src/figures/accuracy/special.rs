//! Errors of the special functions.

use crate::error_table::{ErrorTable, Errors, Reference};
use crate::{Failure, Figure, FigureResult};
use carom_special::elliptic::{Amplitude, complete, incomplete};
use carom_special::gamma::{gamma, ln_gamma};
use carom_special::hypergeometric::{Gauss, HypergeometricError, ThreeFTwo, UnitArgument};
use carom_special::{AxisRatio, RangeError};

/// Largest allowed error of hypergeometric functions: 1e-13, in units of eps.
const HYPERGEOMETRIC: f64 = 1e-13 / f64::EPSILON;

/// Near their zeros 2F1 and 3F2 are checked against an absolute error below this size.
const ZERO: f64 = 0.1;

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("axis ratios", "5e-324 to 1.8e308, log-spaced, denser about 1");
    figure.assumed("amplitudes", "sine or cosine from 1e-300 to 1, log-spaced and random");
    figure.assumed("φ of (9.16)", "1 to 60; S and 1 - S from 0 and 1e-300 to 1");
    let mut table = ErrorTable::new("Errors in units of 2.2e-16");
    complete_integrals(&mut table)?;
    incomplete_integrals(&mut table)?;
    hypergeometric(&mut table)?;
    gamma_function(&mut table)?;
    table.finish(&mut figure);
    Ok(figure)
}

type Done = Result<(), Failure>;

fn complete_integrals(table: &mut ErrorTable) -> Done {
    let reference = Reference::parse(include_str!("../../../data/special/complete.csv"))?;
    type Function = fn(AxisRatio) -> f64;
    let functions: [(&str, &str, Function); 9] = [
        ("K(k')", "K", complete::k),
        ("E(k')", "E", complete::e),
        ("D(k')", "D", complete::d),
        ("B(k')", "B", complete::b),
        ("C(k')", "C", complete::c),
        ("dK/dk'", "dK", complete::dk),
        ("dE/dk'", "dE", complete::de),
        ("dB/dk'", "dB", complete::db),
        ("dD/dk'", "dD", complete::dd),
    ];
    for (name, column, function) in functions {
        let column = reference.column(column)?;
        let mut errors = Errors::of(name, 0.0);
        for row in reference.rows() {
            let value = function(AxisRatio::new(row[0])?);
            errors.add(value, row[column], format!("k' = {:e}", row[0]));
        }
        table.add(errors, 4.0);
    }
    Ok(())
}

fn incomplete_integrals(table: &mut ErrorTable) -> Done {
    let reference = Reference::parse(include_str!("../../../data/special/incomplete.csv"))?;
    type Function = fn(AxisRatio, Amplitude) -> f64;
    let functions: [(&str, &str, Function); 3] = [
        ("F(k', φ)", "F", incomplete::f),
        ("E(k', φ)", "E", incomplete::e),
        ("D(k', φ)", "D", incomplete::d),
    ];
    for (name, column, function) in functions {
        let column = reference.column(column)?;
        let mut errors = Errors::of(name, 0.0);
        for row in reference.rows() {
            let (kc, sine, cosine) = (row[0], row[1], row[2]);
            let by_sine = row[3] == 1.0;
            let amplitude =
                if by_sine { Amplitude::from_sine(sine) } else { Amplitude::from_cosine(cosine) };
            let value = function(AxisRatio::new(kc)?, amplitude?);
            let end = if by_sine { "sin" } else { "cos" };
            let place = format!("k' = {kc:e}, {end} φ = {:e}", if by_sine { sine } else { cosine });
            errors.add(value, row[column], place);
        }
        table.add(errors, 8.0);
    }
    Ok(())
}

fn hypergeometric(table: &mut ErrorTable) -> Done {
    let gauss = [
        ("2F1, parameters of the thesis", include_str!("../../../data/special/gauss.csv")),
        ("2F1, random parameters to 5", include_str!("../../../data/special/gauss_wide.csv")),
    ];
    for (name, text) in gauss {
        let mut errors = Errors::of(name, ZERO);
        for row in Reference::parse(text)?.rows() {
            let &[a, b, c, x, y, expected] = row.as_slice() else { return Err("columns".into()) };
            match Gauss::new(a, b, c)?.at(argument(x, y)?) {
                // A reported cancellation is not a wrong digit.
                Err(HypergeometricError::Cancellation { .. }) => {}
                value => {
                    errors.add(value?, expected, format!("F({a}, {b}; {c}; {x}), 1 - x = {y:e}"))
                }
            }
        }
        table.add(errors, HYPERGEOMETRIC);
    }
    let three = [
        ("3F2, parameters of the thesis", include_str!("../../../data/special/three_f_two.csv")),
        (
            "3F2, excess next to an integer",
            include_str!("../../../data/special/three_f_two_logarithmic.csv"),
        ),
    ];
    for (name, text) in three {
        let mut errors = Errors::of(name, ZERO);
        for row in Reference::parse(text)?.rows() {
            let &[s, a, b, c, z, y, expected] = row.as_slice() else {
                return Err("columns".into());
            };
            let value = ThreeFTwo::new(s, a, b, c)?.at(argument(z, y)?)?;
            errors.add(value, expected, format!("3F2({s}, {a}, {b}; s + 1, {c}; {z})"));
        }
        table.add(errors, HYPERGEOMETRIC);
    }
    Ok(())
}

/// The argument x, whose complement y is the more exact one above 1/2.
fn argument(x: f64, y: f64) -> Result<UnitArgument, RangeError> {
    if x <= 0.5 { UnitArgument::new(x) } else { UnitArgument::from_complement(y) }
}

fn gamma_function(table: &mut ErrorTable) -> Done {
    let reference = Reference::parse(include_str!("../../../data/special/gamma.csv"))?;
    let mut values = Errors::of("Γ(x), -20 < x < 171", 0.0);
    let mut logarithms = Errors::of("ln Γ(x), x > 0", 1.0);
    for row in reference.rows() {
        let (x, place) = (row[0], format!("x = {}", row[0]));
        values.add(gamma(x), row[1], place.clone());
        if x > 0.0 {
            logarithms.add(ln_gamma(x), row[2], place);
        }
    }
    table.add(values, 5.0);
    table.add(logarithms, 4.0);
    Ok(())
}
