//! Complete elliptic integrals against 25-digit references; those over the whole range of axis ratios, with the derivatives,
//! are claims of the page `accuracy.special`.

use crate::common::Errors;
use crate::tabled::rows;
use carom_special::AxisRatio;
use carom_special::elliptic::complete;

/// References given by axis ratio (kind 0), modulus (1) and negative parameter (2).
#[test]
fn the_argument_may_be_a_modulus_or_a_parameter() {
    type Function = fn(AxisRatio) -> f64;
    let functions: [Function; 5] =
        [complete::k, complete::e, complete::d, complete::b, complete::c];
    let mut errors = Errors::default();
    for row in rows::<7>("special/complete_by_argument.csv") {
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
