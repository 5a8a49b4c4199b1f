//! Sums over cells in lanes that do not wait for each other: one running sum takes the time of an addition for each
//! cell.

/// The number of lanes.
pub(crate) const LANES: usize = 4;

/// The sum of values.
pub(crate) fn total(values: &[f64]) -> f64 {
    let (whole, rest) = values.as_chunks::<LANES>();
    let mut sums = [0.0; LANES];
    for values in whole {
        for lane in 0..LANES {
            sums[lane] += values[lane];
        }
    }
    joined(sums, rest.iter().copied())
}

/// The sum of products of two fields of the same length.
pub(crate) fn product(a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<LANES>(), b.as_chunks::<LANES>());
    let mut sums = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    joined(sums, a_rest.iter().zip(b_rest).map(|(a, b)| a * b))
}

/// The same where the third field says so; elsewhere values may be infinite and do not count.
pub(crate) fn product_where(a: &[f64], b: &[f64], counts: &[bool]) -> f64 {
    let one = |(a, b): (f64, f64), counts: bool| if counts { a * b } else { 0.0 };
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<LANES>(), b.as_chunks::<LANES>());
    let (counts, counts_rest) = counts.as_chunks::<LANES>();
    let mut sums = [0.0; LANES];
    for ((a, b), counts) in a.iter().zip(b).zip(counts) {
        for lane in 0..LANES {
            sums[lane] += one((a[lane], b[lane]), counts[lane]);
        }
    }
    let rest = a_rest.iter().zip(b_rest).zip(counts_rest);
    joined(sums, rest.map(|((a, b), counts)| one((*a, *b), *counts)))
}

/// The lanes and the values that fill none.
fn joined(lanes: [f64; LANES], rest: impl Iterator<Item = f64>) -> f64 {
    lanes.into_iter().chain(rest).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cell_counts_once_and_none_that_must_not() {
        // Whole numbers, so that sums are exact in any order.
        for count in 0..=3 * LANES {
            let a: Vec<f64> = (1..=count).map(|i| i as f64).collect();
            let b: Vec<f64> = a.iter().map(|a| 3.0 - 2.0 * a).collect();
            assert_eq!(total(&a), (count * (count + 1) / 2) as f64);
            let whole: f64 = a.iter().zip(&b).map(|(a, b)| a * b).sum();
            assert_eq!(product(&a, &b), whole);
            assert_eq!(product_where(&a, &b, &vec![true; count]), whole);
            for left_out in 0..count {
                let (mut infinite, mut counts) = (b.clone(), vec![true; count]);
                (infinite[left_out], counts[left_out]) = (f64::INFINITY, false);
                let want = whole - a[left_out] * b[left_out];
                assert_eq!(product_where(&a, &infinite, &counts), want);
            }
        }
    }
}
