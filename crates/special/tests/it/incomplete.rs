//! Incomplete elliptic integrals against 22-digit references, the corners included.

use crate::common::{Errors, Table};
use carom_special::AxisRatio;
use carom_special::elliptic::{Amplitude, incomplete};

#[test]
fn within_eight_eps_of_the_reference() {
    let table = Table::read("incomplete.csv");
    type Function = fn(AxisRatio, Amplitude) -> f64;
    let functions: [(&str, Function); 3] =
        [("F", incomplete::f), ("E", incomplete::e), ("D", incomplete::d)];
    for (name, function) in functions {
        let column = table.column(name);
        let mut errors = Errors::default();
        for row in table.rows() {
            let ratio = AxisRatio::new(row[0]).expect("positive");
            let amplitude = if row[3] == 1.0 {
                Amplitude::from_sine(row[1])
            } else {
                Amplitude::from_cosine(row[2])
            };
            let amplitude = amplitude.expect("in range");
            errors.push(function(ratio, amplitude), row[column], 0.0, || format!("{row:?}"));
        }
        assert!(errors.report(name) <= 8.0, "{name}");
    }
}

#[test]
fn the_arguments_may_be_an_angle_and_a_modulus() {
    let mut errors = Errors::default();
    for row in Table::read("incomplete_by_modulus.csv").rows() {
        let &[phi, modulus, f, e] = row else { panic!("four columns") };
        let amplitude = Amplitude::from_angle(phi).expect("in range");
        let ratio = AxisRatio::from_modulus(modulus).expect("in range");
        errors.push(incomplete::f(ratio, amplitude), f, 0.0, || format!("F {row:?}"));
        errors.push(incomplete::e(ratio, amplitude), e, 0.0, || format!("E {row:?}"));
    }
    assert!(errors.report("by angle and modulus") <= 8.0);
}
