//! 2F1 and 3F2 of an impact against 22-digit references; other parameters are claims of the page `accuracy.special`.

use crate::common::Errors;
use crate::tabled::rows;
use carom_special::hypergeometric::{Gauss, ThreeFTwo, UnitArgument};

/// 1e-13 in units of 2.2e-16.
const TARGET: f64 = 1e-13 / f64::EPSILON;

/// The functions of (9.16), (9.21) and (9.26) with phi and S as an impact gives them.
#[test]
fn functions_of_an_impact() {
    let mut errors = Errors::default();
    for [phi, s, references @ ..] in rows::<10>("special/impact_functions.csv") {
        let (x, y) = (UnitArgument::new(s), UnitArgument::from_complement(s));
        let (x, y) = (x.expect("in range"), y.expect("in range"));
        let gauss = |i: f64, c: f64, argument: UnitArgument| {
            Gauss::new((i - phi) / 20.0, (i + phi) / 20.0, c).and_then(|f| f.at(argument))
        };
        let three = |s: f64, i: f64, c: f64| {
            ThreeFTwo::new(s, (i - phi) / 20.0, (i + phi) / 20.0, c).and_then(|f| f.at(x))
        };
        let values = [
            gauss(1.0, 0.6, x),
            gauss(9.0, 1.4, x),
            gauss(1.0, 0.5, y),
            gauss(11.0, 1.5, y),
            three(0.4, 11.0, 0.6),
            three(0.8, 19.0, 1.4),
            gauss(11.0, 1.6, x),
            gauss(-1.0, 0.4, x),
        ];
        for (i, (value, reference)) in values.into_iter().zip(references).enumerate() {
            if !reference.is_nan() {
                let value = value.expect("finite");
                errors.push(value, reference, 0.1, || format!("phi {phi} S {s} column {i}"));
            }
        }
    }
    assert!(errors.report("impact functions") <= TARGET);
}
