//! Places from which minima are looked for.

use nalgebra::DVector;

/// Places spread evenly over all unknowns, Halton's sequence about the middle; and for each unknown places near its lower bound
/// by powers of ten, since a value that is positive may be far below its upper bound.
pub(crate) fn starts(unknowns: usize) -> Vec<DVector<f64>> {
    const PRIMES: [u32; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    let radical = |mut n: u32, base: u32| {
        let (mut sum, mut part) = (0.0, 1.0 / f64::from(base));
        while n > 0 {
            sum += part * f64::from(n % base);
            part /= f64::from(base);
            n /= base;
        }
        sum
    };
    let count = 8 * unknowns.min(8) as u32;
    let start = |n: u32| DVector::from_fn(unknowns, |j, _| radical(n, PRIMES[j % PRIMES.len()]));
    let low = (0..unknowns.min(8)).flat_map(|j| (1..=LOW_STARTS).map(move |n| low(unknowns, j, n)));
    (1..=count).map(start).chain(low).collect()
}

/// The middle of the bounds, but for one unknown, which is near its lower bound.
pub(crate) fn low(unknowns: usize, j: usize, n: i32) -> DVector<f64> {
    DVector::from_fn(unknowns, |i, _| if i == j { 0.1_f64.powi(n) } else { 0.5 })
}

/// Places near the lower bound of each unknown: a tenth of the range, a hundredth and so on.
const LOW_STARTS: i32 = 6;
/// The same where better values may be far away.
pub(crate) const FAR_STARTS: i32 = 24;
