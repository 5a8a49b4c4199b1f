//! Distributions of one input.

use carom_special::RangeError;
use statrs::distribution::{ContinuousCDF as _, Normal};

/// The distribution of one input.
///
/// ```
/// use carom_impact::uncertain::Distribution;
/// let friction = Distribution::uniform(0.05, 0.15)?;
/// assert!((friction.quantile(0.25)? - 0.075).abs() < 1e-16);
/// assert!(Distribution::normal(0.09, -0.01).is_err());
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distribution(Kind);

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Normal { mean: f64, deviation: f64 },
    LogNormal { log_mean: f64, log_deviation: f64 },
    Uniform { low: f64, high: f64 },
    Triangular { low: f64, mode: f64, high: f64 },
}

impl Distribution {
    /// The normal distribution with this mean and standard deviation.
    ///
    /// # Errors
    /// [`RangeError`] unless the mean is finite and the deviation finite and positive.
    pub fn normal(mean: f64, deviation: f64) -> Result<Self, RangeError> {
        RangeError::finite("mean", mean)?;
        RangeError::positive("sd", deviation)?;
        Ok(Self(Kind::Normal { mean, deviation }))
    }

    /// The log-normal distribution with this mean and standard deviation of the quantity itself, not of its
    /// logarithm: sigma^2 = ln(1 + (sd/mean)^2), mu = ln mean - sigma^2/2.
    ///
    /// # Errors
    /// [`RangeError`] unless both are finite and positive.
    pub fn log_normal(mean: f64, deviation: f64) -> Result<Self, RangeError> {
        RangeError::positive("mean", mean)?;
        RangeError::positive("sd", deviation)?;
        let ratio = deviation / mean;
        let allowed = "such that its ratio to the mean can be squared";
        RangeError::check("sd", deviation, (ratio * ratio).is_finite(), allowed)?;
        let variance = libm::log1p(ratio * ratio);
        let log_mean = libm::log(mean) - 0.5 * variance;
        Ok(Self(Kind::LogNormal { log_mean, log_deviation: variance.sqrt() }))
    }

    /// The uniform distribution from `low` to `high`.
    ///
    /// # Errors
    /// [`RangeError`] unless both are finite and `low < high`.
    pub fn uniform(low: f64, high: f64) -> Result<Self, RangeError> {
        ends(low, high)?;
        Ok(Self(Kind::Uniform { low, high }))
    }

    /// The triangular distribution from `low` to `high` with its peak at `mode`: a density with two straight
    /// parts.
    ///
    /// # Errors
    /// [`RangeError`] unless all are finite, `low < high` and the mode lies between them.
    pub fn triangular(low: f64, mode: f64, high: f64) -> Result<Self, RangeError> {
        ends(low, high)?;
        RangeError::check("mode", mode, low <= mode && mode <= high, "from low to high")?;
        Ok(Self(Kind::Triangular { low, mode, high }))
    }

    /// The value below which a sample lies with this probability.
    ///
    /// # Errors
    /// [`RangeError`] unless the probability lies in (0, 1).
    pub fn quantile(&self, probability: f64) -> Result<f64, RangeError> {
        let holds = probability > 0.0 && probability < 1.0;
        RangeError::check("probability", probability, holds, "in (0, 1)")?;
        Ok(self.inverse(probability))
    }

    /// [`Distribution::quantile`] of a probability known to lie in (0, 1).
    pub(super) fn inverse(&self, p: f64) -> f64 {
        match self.0 {
            Kind::Normal { mean, deviation } => mean + deviation * standard_normal(p),
            Kind::LogNormal { log_mean, log_deviation } => {
                libm::exp(log_mean + log_deviation * standard_normal(p))
            }
            Kind::Uniform { low, high } => low + (high - low) * p,
            Kind::Triangular { low, mode, high } => {
                let (rise, fall, width) = (mode - low, high - mode, high - low);
                if p * width < rise {
                    low + (rise * width * p).sqrt()
                } else {
                    high - (fall * width * (1.0 - p)).sqrt()
                }
            }
        }
    }

    /// The mean.
    #[must_use]
    pub fn mean(&self) -> f64 {
        match self.0 {
            Kind::Normal { mean, .. } => mean,
            Kind::LogNormal { log_mean, log_deviation } => {
                libm::exp(log_mean + 0.5 * log_deviation * log_deviation)
            }
            Kind::Uniform { low, high } => low + 0.5 * (high - low),
            Kind::Triangular { low, mode, high } => (low + mode + high) / 3.0,
        }
    }
}

fn ends(low: f64, high: f64) -> Result<(), RangeError> {
    RangeError::finite("low", low)?;
    RangeError::check("high", high, high > low && (high - low).is_finite(), "finite and > low")?;
    Ok(())
}

fn standard_normal(p: f64) -> f64 {
    Normal::standard().inverse_cdf(p)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_have_known_values() {
        let normal = Distribution::normal(2.0, 0.5).unwrap();
        // The 97.5 % point of the standard normal distribution.
        let expected = 2.0 + 0.5 * 1.959_963_984_540_054;
        assert!((normal.quantile(0.975).unwrap() - expected).abs() < 1e-12);
        let log = Distribution::log_normal(2.0, 0.5).unwrap();
        // Its median is mean/sqrt(1 + (sd/mean)^2).
        let median = 2.0 / (1.0 + 0.0625f64).sqrt();
        assert!((log.quantile(0.5).unwrap() - median).abs() < 1e-14);
        let triangle = Distribution::triangular(0.0, 1.0, 4.0).unwrap();
        assert_eq!(triangle.quantile(0.25).unwrap(), 1.0);
        assert_eq!(triangle.quantile(0.0625).unwrap(), 0.5);
    }

    #[test]
    fn means_are_those_of_the_quantiles() {
        for distribution in [
            Distribution::normal(1.0, 0.3).unwrap(),
            Distribution::log_normal(1.0, 0.3).unwrap(),
            Distribution::uniform(0.2, 1.1).unwrap(),
            Distribution::triangular(0.2, 0.3, 1.1).unwrap(),
        ] {
            let count = 200_000;
            let sum: f64 =
                (0..count).map(|i| distribution.inverse((i as f64 + 0.5) / count as f64)).sum();
            assert!((sum / count as f64 / distribution.mean() - 1.0).abs() < 2e-6);
        }
    }

    #[test]
    fn bad_parameters_are_named() {
        assert_eq!(Distribution::normal(f64::NAN, 1.0).unwrap_err().field, "mean");
        assert_eq!(Distribution::normal(1.0, 0.0).unwrap_err().field, "sd");
        assert_eq!(Distribution::log_normal(0.0, 1.0).unwrap_err().field, "mean");
        assert_eq!(Distribution::uniform(1.0, 1.0).unwrap_err().field, "high");
        assert_eq!(Distribution::triangular(0.0, 2.0, 1.0).unwrap_err().field, "mode");
        let normal = Distribution::normal(1.0, 1.0).unwrap();
        assert!([0.0, 1.0, f64::NAN].iter().all(|p| normal.quantile(*p).is_err()));
    }
}
