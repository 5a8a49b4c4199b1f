//! Gamma against 22-digit references.

use crate::common::Errors;
use crate::tabled::rows;
use carom_special::gamma::{gamma, ln_gamma, reciprocal};

#[test]
fn within_a_few_eps_of_the_reference() {
    let mut errors = [(); 4].map(|()| Errors::default());
    for [x, value, logarithm] in rows("special/gamma.csv") {
        errors[0].push(gamma(x), value, 0.0, || x.to_string());
        errors[1].push(reciprocal(x), 1.0 / value, 0.0, || x.to_string());
        let sign = if x > 0.0 { 2 } else { 3 };
        errors[sign].push(ln_gamma(x), logarithm, 1.0, || x.to_string());
    }
    let names = ["gamma", "1/gamma", "ln gamma, x > 0", "ln gamma, x < 0"];
    for ((errors, name), bound) in errors.into_iter().zip(names).zip([5.0, 5.0, 4.0, 20.0]) {
        assert!(errors.report(name) <= bound, "{name}");
    }
}
