//! Incomplete elliptic integrals against 22-digit references; the corners are claims of the page `accuracy.special`.

use crate::common::Errors;
use crate::tabled::rows;
use carom_special::AxisRatio;
use carom_special::elliptic::{Amplitude, incomplete};

#[test]
fn the_arguments_may_be_an_angle_and_a_modulus() {
    let mut errors = Errors::default();
    for row in rows("special/incomplete_by_modulus.csv") {
        let [phi, modulus, f, e] = row;
        let amplitude = Amplitude::from_angle(phi).expect("in range");
        let ratio = AxisRatio::from_modulus(modulus).expect("in range");
        errors.push(incomplete::f(ratio, amplitude), f, 0.0, || format!("F {row:?}"));
        errors.push(incomplete::e(ratio, amplitude), e, 0.0, || format!("E {row:?}"));
    }
    assert!(errors.report("by angle and modulus") <= 8.0);
}
