//! What a fit needs of a theory: predictions of measured values by the unknowns.

use crate::FitError;
use carom_cases::case::Unknown;
use nalgebra::DMatrix;

/// An unknown of a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Parameter {
    /// Its field with the path.
    pub(crate) field: &'static str,
    /// Its unit; empty for a pure number.
    pub(crate) unit: &'static str,
    /// Its bounds and what is known of it.
    pub(crate) unknown: Unknown,
}

/// Bounds of a ratio of this size are searched by the logarithm.
const WIDE: f64 = 30.0;
/// How much farther from its mean a prior's bound is moved.
const FARTHER: f64 = 8.0;
/// Part of the range that counts as the size of a number that may be 0.
const PART: f64 = 0.05;

impl Parameter {
    /// The value at a place from 0, the lower bound, to 1.
    pub(crate) fn at(&self, x: f64) -> f64 {
        let Unknown { low, high, .. } = self.unknown;
        let value = match self.is_wide() {
            true => libm::exp(libm::log(low) + x * libm::log(high / low)),
            false => low + x * (high - low),
        };
        value.clamp(low, high)
    }

    /// The place of a value of a range that is not searched by its logarithm.
    pub(crate) fn place(&self, value: f64) -> f64 {
        let Unknown { low, high, .. } = self.unknown;
        ((value - low) / (high - low)).clamp(0.0, 1.0)
    }

    /// The derivative of the value by the place.
    pub(crate) fn slope(&self, x: f64) -> f64 {
        let Unknown { low, high, .. } = self.unknown;
        if self.is_wide() { self.at(x) * libm::log(high / low) } else { high - low }
    }

    /// Moves a bound that is but where the search of a prior began outwards, if the best place is there; whether it did.
    pub(crate) fn widen(&mut self, place: f64) -> bool {
        let Unknown { low, high, prior, widest } = &mut self.unknown;
        let Some([mean, _]) = *prior else { return false };
        let [below, above] = [place <= 0.0 && *low > widest[0], place >= 1.0 && *high < widest[1]];
        if below {
            *low = (mean - FARTHER * (mean - *low)).max(widest[0]);
        }
        if above {
            *high = (mean + FARTHER * (*high - mean)).min(widest[1]);
        }
        below || above
    }

    fn is_wide(&self) -> bool {
        let Unknown { low, high, prior, .. } = self.unknown;
        prior.is_none() && low > 0.0 && high / low > WIDE
    }

    /// The size of a change that matters.
    fn size(&self, value: f64) -> f64 {
        let Unknown { low, high, .. } = self.unknown;
        if self.is_wide() {
            return value;
        }
        if low >= 0.0 { value.max(1e-6 * (high - low)) } else { PART * (high - low) }
    }
}

/// Predictions of measured values by unknowns.
pub(crate) trait Model: Sync {
    /// The unknowns.
    fn parameters(&self) -> &[Parameter];
    /// The number of measured values.
    fn count(&self) -> usize;
    /// The predicted values, in the order of the measured ones.
    ///
    /// # Errors
    /// If one cannot be computed.
    fn predict(&self, values: &[f64], into: &mut [f64]) -> Result<(), FitError>;
    /// The relative step of differences of the predictions: the cube root of their relative error.
    fn step(&self) -> f64;
    /// Relative changes of the sum of squares that mean nothing, since the predictions are not smooth below them.
    fn jitter(&self) -> f64;

    /// The derivatives of the predicted values by the unknowns: central differences, one-sided at a bound.
    ///
    /// # Errors
    /// If a prediction cannot be computed.
    fn derivatives(&self, values: &[f64], into: &mut DMatrix<f64>) -> Result<(), FitError> {
        let mut moved = values.to_vec();
        let [mut above, mut below] = [vec![0.0; self.count()], vec![0.0; self.count()]];
        for (j, parameter) in self.parameters().iter().enumerate() {
            let Unknown { low, high, .. } = parameter.unknown;
            let step = self.step() * parameter.size(values[j]);
            let ends = [(values[j] - step).max(low), (values[j] + step).min(high)];
            moved[j] = ends[1];
            self.predict(&moved, &mut above)?;
            moved[j] = ends[0];
            self.predict(&moved, &mut below)?;
            moved[j] = values[j];
            let inverse = 1.0 / (ends[1] - ends[0]);
            for i in 0..self.count() {
                into[(i, j)] = (above[i] - below[i]) * inverse;
            }
        }
        Ok(())
    }
}
