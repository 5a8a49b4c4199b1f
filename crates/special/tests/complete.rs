//! Complete elliptic integrals against 25-digit references over the whole range of axis ratios.

mod common;

use carom_special::AxisRatio;
use carom_special::elliptic::complete;
use common::{Errors, Table};

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
