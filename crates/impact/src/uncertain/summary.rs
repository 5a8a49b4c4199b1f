//! Mean, standard deviation, quantiles and histogram of a set of numbers.

use carom_special::RangeError;

/// The values of one quantity.
///
/// ```
/// use carom_impact::uncertain::Summary;
/// let summary = Summary::new(vec![3.0, 1.0, 2.0, 4.0]).unwrap();
/// assert_eq!((summary.mean(), summary.quantile(0.5)?), (2.5, 2.5));
/// assert!((summary.deviation() - (5.0f64 / 3.0).sqrt()).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    mean: f64,
    deviation: f64,
    sorted: Vec<f64>,
}

/// One bin of a histogram: values in `[low, high)`, in the last bin `[low, high]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bin {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Number of values in it.
    pub count: usize,
}

impl Summary {
    /// The summary of these values; None if there are none, or one is NaN.
    ///
    /// The sums run in the given order: the same values in the same order give the same bits.
    #[must_use]
    pub fn new(mut values: Vec<f64>) -> Option<Self> {
        if values.is_empty() || values.iter().any(|value| value.is_nan()) {
            return None;
        }
        let count = values.len() as f64;
        // Relative to the first value: no cancellation between large values that differ little.
        let origin = values[0];
        let shift = values.iter().map(|value| value - origin).sum::<f64>() / count;
        let mean = origin + shift;
        let squares: f64 = values.iter().map(|v| (v - origin - shift).powi(2)).sum();
        let deviation = if values.len() > 1 { (squares / (count - 1.0)).sqrt() } else { 0.0 };
        values.sort_by(f64::total_cmp);
        Some(Self { mean, deviation, sorted: values })
    }

    /// Number of values.
    #[must_use]
    pub fn count(&self) -> usize {
        self.sorted.len()
    }

    /// The mean.
    #[must_use]
    pub const fn mean(&self) -> f64 {
        self.mean
    }

    /// The standard deviation of the population, estimated with n - 1; zero for one value.
    #[must_use]
    pub const fn deviation(&self) -> f64 {
        self.deviation
    }

    /// The standard error of the mean: deviation/sqrt(n).
    #[must_use]
    pub fn standard_error(&self) -> f64 {
        self.deviation / (self.count() as f64).sqrt()
    }

    /// The values in rising order.
    #[must_use]
    pub fn sorted(&self) -> &[f64] {
        &self.sorted
    }

    /// The value below which this fraction of the values lies, interpolated linearly: 0 gives the smallest, 1
    /// the largest, 0.5 the median.
    ///
    /// # Errors
    /// [`RangeError`] unless the fraction lies in [0, 1].
    pub fn quantile(&self, part: f64) -> Result<f64, RangeError> {
        RangeError::check("quantile", part, (0.0..=1.0).contains(&part), "in [0, 1]")?;
        let place = part * (self.count() - 1) as f64;
        let index = (place as usize).min(self.count() - 1);
        let next = (index + 1).min(self.count() - 1);
        let (low, high) = (self.sorted[index], self.sorted[next]);
        Ok(low + (high - low) * (place - index as f64))
    }

    /// The number of values in each of `bins` bins of equal width, from the smallest to the largest. Equal
    /// values give one bin of zero width.
    ///
    /// # Errors
    /// [`RangeError`] for no bins.
    pub fn histogram(&self, bins: usize) -> Result<Vec<Bin>, RangeError> {
        RangeError::check("bins", bins as f64, bins >= 1, ">= 1")?;
        let (low, high) = (self.sorted[0], self.sorted[self.count() - 1]);
        if low == high {
            return Ok(vec![Bin { low, high, count: self.count() }]);
        }
        let end =
            |i: usize| if i == bins { high } else { low + (high - low) * (i as f64 / bins as f64) };
        let below = |i: usize| match i {
            0 => 0,
            i if i == bins => self.count(),
            i => self.sorted.partition_point(|value| *value < end(i)),
        };
        Ok((0..bins)
            .map(|i| Bin { low: end(i), high: end(i + 1), count: below(i + 1) - below(i) })
            .collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn histograms_count_every_value_once() {
        let summary = Summary::new((0..=100).map(f64::from).collect()).unwrap();
        let bins = summary.histogram(4).unwrap();
        assert_eq!(bins.iter().map(|bin| bin.count).collect::<Vec<_>>(), [25, 25, 25, 26]);
        assert_eq!((bins[0].low, bins[3].high), (0.0, 100.0));
        let same = Summary::new(vec![2.0; 5]).unwrap();
        assert_eq!(same.histogram(7).unwrap(), [Bin { low: 2.0, high: 2.0, count: 5 }]);
        assert_eq!(same.deviation(), 0.0);
        assert!(same.histogram(0).is_err());
    }

    #[test]
    fn quantiles_run_from_least_to_greatest() {
        let summary = Summary::new(vec![5.0, 1.0, 3.0]).unwrap();
        for (part, value) in [(0.0, 1.0), (0.25, 2.0), (0.5, 3.0), (1.0, 5.0)] {
            assert_eq!(summary.quantile(part).unwrap(), value);
        }
        assert!(summary.quantile(1.1).is_err() && summary.quantile(f64::NAN).is_err());
        assert!(Summary::new(vec![]).is_none() && Summary::new(vec![f64::NAN]).is_none());
    }

    #[test]
    fn large_values_keep_their_scatter() {
        let summary = Summary::new(vec![1e9 + 1.0, 1e9 + 2.0, 1e9 + 3.0]).unwrap();
        assert_eq!((summary.mean(), summary.deviation()), (1e9 + 2.0, 1.0));
    }
}
