//! Downward zero crossings of a polynomial of degree four or less.

use carom_special::roots::{ALL_DIGITS, bisect};

/// Calls `visit` with each point in `[0, end]`, in order, at which the polynomial with these coefficients (by
/// rising powers) changes from positive to negative.
pub(super) fn falls(coefficients: &[f64; 5], end: f64, mut visit: impl FnMut(f64)) {
    let (breaks, count) = stationary(coefficients, end);
    let mut low = 0.0;
    let mut at_low = evaluate(coefficients, low);
    for &high in breaks[..count].iter().chain(&[end]) {
        let at_high = evaluate(coefficients, high);
        if at_low > 0.0 && at_high <= 0.0 {
            visit(change(coefficients, low, high));
        }
        (low, at_low) = (high, at_high);
    }
}

/// The points in (0, end), in order, at which the derivative changes sign.
fn stationary(coefficients: &[f64; 5], end: f64) -> ([f64; 3], usize) {
    let mut derivative = [0.0; 5];
    for power in 1..5 {
        derivative[power - 1] = power as f64 * coefficients[power];
    }
    crossings(&derivative, 3, end)
}

/// The sign changes in (0, end) of a polynomial of degree `degree`, at most three, in order: at most one
/// between two sign changes of its derivative.
fn crossings(coefficients: &[f64; 5], degree: usize, end: f64) -> ([f64; 3], usize) {
    let (mut found, mut count) = ([0.0; 3], 0);
    if degree == 0 {
        return (found, count);
    }
    let mut derivative = [0.0; 5];
    for power in 1..=degree {
        derivative[power - 1] = power as f64 * coefficients[power];
    }
    let (breaks, break_count) = crossings(&derivative, degree - 1, end);
    let mut low = 0.0;
    for &high in breaks[..break_count].iter().chain(&[end]) {
        let (at_low, at_high) = (evaluate(coefficients, low), evaluate(coefficients, high));
        if (at_low > 0.0) != (at_high > 0.0) && count < degree {
            found[count] = change(coefficients, low, high);
            count += 1;
        }
        low = high;
    }
    (found, count)
}

/// The last number before the sign change in `[low, high]`: there a distance has not yet fallen below its
/// bound.
fn change(coefficients: &[f64; 5], low: f64, high: f64) -> f64 {
    let positive = evaluate(coefficients, low) > 0.0;
    let [before, _] =
        bisect([low, high], ALL_DIGITS, |x| (evaluate(coefficients, x) > 0.0) == positive);
    before
}

fn evaluate(coefficients: &[f64; 5], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(coefficients: [f64; 5], end: f64) -> Vec<f64> {
        let mut found = Vec::new();
        falls(&coefficients, end, |x| found.push(x));
        found
    }

    #[test]
    fn falls_of_a_quartic() {
        // (x - 1)(x - 2)(x - 3)(x - 4) has downward crossings at 1 and 3.
        let found = all([24.0, -50.0, 35.0, -10.0, 1.0], 10.0);
        assert_eq!(found.len(), 2);
        assert!((found[0] - 1.0).abs() < 1e-14 && (found[1] - 3.0).abs() < 1e-13);
        assert_eq!(all([24.0, -50.0, 35.0, -10.0, 1.0], 2.5).len(), 1);
        // x^4 + 1 has no zero; 1 - x has one; a double zero from above is no crossing.
        assert!(all([1.0, 0.0, 0.0, 0.0, 1.0], 10.0).is_empty());
        assert_eq!(all([1.0, -1.0, 0.0, 0.0, 0.0], 10.0).len(), 1);
        assert!(all([1.001, -2.0, 1.0, 0.0, 0.0], 10.0).is_empty());
    }
}
