//! Statistics of the deviations of a claim about many values.

use crate::claim::{Check, Claim};
use statrs::statistics::{Data, OrderStatistics, Statistics};

/// Distribution of the deviations |measured - expected|.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Number of values.
    pub count: usize,
    /// Their mean.
    pub mean: f64,
    /// Root mean square.
    pub rms: f64,
    /// 95th percentile.
    pub percentile_95: f64,
    /// The largest.
    pub max: f64,
}

/// The distribution of the deviations of a claim about at least two values; otherwise `None`.
#[must_use]
pub fn spread(claim: &Claim) -> Option<Spread> {
    let Check::AllClose { pairs, .. } = &claim.check else { return None };
    if pairs.len() < 2 {
        return None;
    }
    let deviations: Vec<f64> =
        pairs.iter().map(|pair| (pair.measured - pair.expected).abs()).collect();
    Some(Spread {
        count: deviations.len(),
        mean: Statistics::mean(&deviations),
        rms: Statistics::quadratic_mean(&deviations),
        max: Statistics::max(&deviations),
        percentile_95: Data::new(deviations).quantile(0.95),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::Tolerance;

    #[test]
    fn spread_of_known_deviations() {
        let pairs = (1..=101).map(|i| (f64::from(i), 1.0)); // deviations 0 to 100
        let spread = spread(&Claim::all_close("", pairs, Tolerance::Absolute(1.0))).unwrap();
        assert_eq!((spread.count, spread.mean, spread.max), (101, 50.0, 100.0));
        approx::assert_relative_eq!(spread.rms, (3350.0f64).sqrt(), max_relative = 1e-14);
        approx::assert_relative_eq!(spread.percentile_95, 95.0, max_relative = 1e-2);
        assert_eq!(super::spread(&Claim::at_most("", 1.0, 1.0)), None);
    }
}
