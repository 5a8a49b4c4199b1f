//! 2F1 and 3F2 against 22-digit references.

use crate::common::{Errors, Table};
use carom_special::hypergeometric::{Gauss, HypergeometricError, ThreeFTwo, UnitArgument};

/// 1e-13 in units of 2.2e-16.
const TARGET: f64 = 1e-13 / f64::EPSILON;

fn argument(x: f64, complement: f64) -> UnitArgument {
    let argument =
        if x <= 0.5 { UnitArgument::new(x) } else { UnitArgument::from_complement(complement) };
    argument.expect("in the unit interval")
}

/// The largest error and how many values were refused for cancellation.
fn gauss_errors(file: &str) -> (f64, usize) {
    let mut errors = Errors::default();
    let mut refused = 0;
    for row in Table::read(file).rows() {
        let &[a, b, c, x, complement, reference] = row else { panic!("six columns") };
        match Gauss::new(a, b, c).and_then(|f| f.at(argument(x, complement))) {
            Ok(value) => errors.push(value, reference, 0.1, || format!("{row:?}")),
            Err(HypergeometricError::Cancellation { .. }) => refused += 1,
            Err(error) => panic!("{error} at {row:?}"),
        }
    }
    println!("{refused} refused");
    (errors.report(file), refused)
}

#[test]
fn gauss_of_the_thesis() {
    let (largest, refused) = gauss_errors("gauss.csv");
    assert!(largest <= TARGET && refused == 0);
}

#[test]
fn gauss_of_a_wider_range() {
    let (largest, refused) = gauss_errors("gauss_wide.csv");
    assert!(largest <= TARGET && refused < 20);
}

fn three_f_two_errors(file: &str) -> f64 {
    let mut errors = Errors::default();
    for row in Table::read(file).rows() {
        let &[s, a, b, c, x, complement, reference] = row else { panic!("seven columns") };
        let function = ThreeFTwo::new(s, a, b, c).expect("in range");
        let value = function.at(argument(x, complement)).expect("finite");
        errors.push(value, reference, 0.1, || format!("{row:?}"));
    }
    errors.report(file)
}

#[test]
fn three_f_two_of_the_thesis() {
    assert!(three_f_two_errors("three_f_two.csv") <= TARGET);
}

#[test]
fn three_f_two_next_to_a_logarithm() {
    assert!(three_f_two_errors("three_f_two_logarithmic.csv") <= TARGET);
}

/// The functions of (9.16), (9.21) and (9.26) with phi and S as an impact gives them.
#[test]
fn functions_of_an_impact() {
    let table = Table::read("impact_functions.csv");
    let mut errors = Errors::default();
    for row in table.rows() {
        let (phi, s) = (row[0], row[1]);
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
        for (i, value) in values.into_iter().enumerate() {
            let reference = row[i + 2];
            if !reference.is_nan() {
                let value = value.expect("finite");
                errors.push(value, reference, 0.1, || format!("phi {phi} S {s} column {i}"));
            }
        }
    }
    assert!(errors.report("impact functions") <= TARGET);
}
