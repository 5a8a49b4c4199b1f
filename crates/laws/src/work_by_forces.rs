//! The work of a force in a straight step, from its values at five times.

use crate::memory::Lateral;

/// The times within a step of Lobatto's rule with five points, as fractions.
const TIMES: [f64; 3] = [0.172_673_164_646_011_43, 0.5, 0.827_326_835_353_988_57];
/// Largest error of this rule if the force has one kink in the step, over the work.
const MAX_ERROR: f64 = 1e-4;
/// The third difference of the five forces counts by this weight; see [`work_by_forces`].
const WEIGHT_OF_THIRD_DIFFERENCE: f64 = 0.1;

/// The scalar product of a way and the mean force along it, by Lobatto's rule with five points: the forces at both ends
/// and `at` times between 0 and 1.
///
/// A polynomial of the seventh degree in time has no error. A kink shows in the difference to Simpson's rule, which is
/// even about the middle, or in the third difference, which is odd: wherever it is, the error is below the larger of
/// the one and a tenth of the other. `None` if that exceeds 1e-4 of the work.
pub(crate) fn work_by_forces<V: Lateral>(
    ends: [V; 2],
    way: V,
    at: impl Fn(f64) -> V,
) -> Option<f64> {
    let [low, middle, high] = TIMES.map(|time| at(time).dot(way));
    let [first, last] = ends.map(|force| force.dot(way));
    let work = (9.0 * (first + last) + 49.0 * (low + high) + 64.0 * middle) / 180.0;
    let simpson = (first + 4.0 * middle + last) / 6.0;
    let third = (last - first) - (high - low) / (TIMES[2] - TIMES[0]);
    let error = (work - simpson).abs().max(WEIGHT_OF_THIRD_DIFFERENCE * third.abs());
    (error <= MAX_ERROR * work.abs()).then_some(work)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_to_the_seventh_degree_are_exact() {
        for degree in 0..8 {
            let power = |time: f64| 1.0 + 1e-4 * time.powi(degree);
            let work = work_by_forces([power(0.0), power(1.0)], 3.0, power).unwrap();
            let exact = 3.0 * (1.0 + 1e-4 / f64::from(degree + 1));
            assert!((work - exact).abs() < 1e-15, "{degree}: {work} {exact}");
        }
    }

    #[test]
    fn a_kink_is_refused_or_leaves_a_small_error() {
        let mut taken = 0;
        for place in (0..=1000).map(|part| f64::from(part) / 1000.0) {
            for size in [1e-5, 1e-4, 1e-3, 1e-2, 1.0] {
                let force = |time: f64| 1.0 + size * (time - place).max(0.0);
                let exact = 1.0 + 0.5 * size * (1.0 - place).powi(2);
                if let Some(work) = work_by_forces([force(0.0), force(1.0)], 1.0, force) {
                    assert!((work - exact).abs() < 1e-4, "{place} {size}: {work} {exact}");
                    taken += 1;
                }
            }
        }
        assert!(taken > 3000, "{taken} taken");
        let turned = |time: f64| if time < 0.3 { 1.0 } else { -1.0 };
        assert_eq!(work_by_forces([turned(0.0), turned(1.0)], 1.0, turned), None);
    }
}
