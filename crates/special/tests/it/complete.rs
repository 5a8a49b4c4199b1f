//! Complete elliptic integrals against 25-digit references over the whole range of axis ratios.

use crate::common::{Errors, Table};
use carom_special::AxisRatio;
use carom_special::elliptic::complete;

#[test]
fn within_four_eps_of_the_reference() {
    let table = Table::read("complete.csv");
    type Function = fn(AxisRatio) -> f64;
    let functions: [(&str, Function); 9] = [
        ("K", complete::k),
        ("E", complete::e),
        ("D", complete::d),
        ("B", complete::b),
        ("C", complete::c),
        ("dK", complete::dk),
        ("dE", complete::de),
        ("dB", complete::db),
        ("dD", complete::dd),
    ];
    for (name, function) in functions {
        let column = table.column(name);
        let mut errors = Errors::default();
        for row in table.rows() {
            let ratio = AxisRatio::new(row[0]).expect("positive");
            errors.push(function(ratio), row[column], 0.0, || format!("{:e}", row[0]));
        }
        assert!(errors.report(name) <= 4.0, "{name}");
    }
}

/// References given by axis ratio (kind 0), modulus (1) and negative parameter (2).
#[test]
fn the_argument_may_be_a_modulus_or_a_parameter() {
    type Function = fn(AxisRatio) -> f64;
    let functions: [Function; 5] =
        [complete::k, complete::e, complete::d, complete::b, complete::c];
    let mut errors = Errors::default();
    for row in Table::read("complete_by_argument.csv").rows() {
        let constructors = [AxisRatio::new, AxisRatio::from_modulus, AxisRatio::from_parameter];
        let ratio = constructors[row[0] as usize](row[1]);
        if row[2].is_infinite() {
            assert!(ratio.is_err());
            continue;
        }
        let ratio = ratio.expect("in range");
        for (function, reference) in functions.into_iter().zip(&row[2..]) {
            errors.push(function(ratio), *reference, 0.0, || format!("{row:?}"));
        }
    }
    assert!(errors.report("by argument") <= 4.0);
}
