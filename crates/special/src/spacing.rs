//! Equally spaced values.

/// `count` values from `start` to `stop`, both included, equally spaced.
///
/// ```
/// assert_eq!(carom_special::linspace(0.0, 1.0, 3), [0.0, 0.5, 1.0]);
/// ```
#[must_use]
pub fn linspace(start: f64, stop: f64, count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|i| start + (stop - start) * (i as f64 / last)).collect()
}

/// `count` values from `start` to `stop`, both included and positive, in geometric progression.
///
/// ```
/// let decades = carom_special::logspace(1e-2, 1.0, 3);
/// assert!((decades[1] - 0.1).abs() < 1e-16);
/// ```
#[must_use]
pub fn logspace(start: f64, stop: f64, count: usize) -> Vec<f64> {
    let mut values: Vec<f64> =
        linspace(libm::log(start), libm::log(stop), count).into_iter().map(libm::exp).collect();
    if let Some(first) = values.first_mut() {
        *first = start;
    }
    if let (Some(last), true) = (values.last_mut(), count > 1) {
        *last = stop;
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_of_grids_are_exact() {
        for grid in [linspace(0.1, 0.7, 13), logspace(0.1, 0.7, 13)] {
            assert_eq!((grid[0], grid[12], grid.len()), (0.1, 0.7, 13));
            assert!(grid.windows(2).all(|w| w[0] < w[1]));
        }
        assert_eq!(linspace(2.0, 5.0, 1), [2.0]);
    }

    #[test]
    fn two_values_are_the_ends() {
        for stop in [0.7, 3.3, 17.0, 1e-9, 1e23] {
            assert_eq!(logspace(0.1, stop, 2), [0.1, stop]);
        }
        assert_eq!(logspace(0.1, 0.7, 1), [0.1]);
    }
}
