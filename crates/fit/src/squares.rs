//! The weighted sum of squares of a model, and its minimum between bounds by Levenberg's and Marquardt's method.
//!
//! The unknowns are scaled to places from 0 to 1 between their bounds. An unknown at a bound from which the sum falls outwards
//! only is held there. `levenberg-marquardt`, the one library of Rust for this, has no bounds, and another version of
//! `nalgebra`.

use crate::FitError;
use crate::loss::Loss;
use crate::model::Model;
use crate::starts::{FAR_STARTS, low};
use nalgebra::{DMatrix, DVector};

/// Largest number of steps.
const MOST_STEPS: usize = 200;
/// Change of a place at the end.
const SMALL: f64 = 1e-10;
/// Largest number of steps near a minimum, and the change of the sum at their end.
const MOST_CHORDS: usize = 8;
const NEARLY: f64 = 3e-3;
/// The first damping, and the largest.
const DAMPING: f64 = 1e-3;
const MOST_DAMPING: f64 = 1e12;

/// Measured values, their standard errors, and the model.
pub(crate) struct Squares<'a, M: ?Sized> {
    pub(crate) model: &'a M,
    pub(crate) measured: &'a [f64],
    pub(crate) errors: Vec<f64>,
    pub(crate) loss: Loss,
    /// Whether priors count.
    pub(crate) has_priors: bool,
}

/// Places with the predictions there, and the derivatives of these by the values of the unknowns.
#[derive(Debug, Clone)]
pub(crate) struct Tangent {
    pub(crate) places: DVector<f64>,
    pub(crate) predicted: Vec<f64>,
    by: DMatrix<f64>,
}

/// A minimum, and the sum of squares there.
#[derive(Debug, Clone)]
pub(crate) struct Found {
    pub(crate) tangent: Tangent,
    pub(crate) sum: f64,
}

impl Found {
    pub(crate) fn places(&self) -> &DVector<f64> {
        &self.tangent.places
    }
}

impl<M: Model + ?Sized> Squares<'_, M> {
    /// The values of the unknowns at these places.
    pub(crate) fn values(&self, places: &DVector<f64>) -> Vec<f64> {
        let parameters = self.model.parameters();
        parameters.iter().zip(places).map(|(parameter, x)| parameter.at(*x)).collect()
    }

    fn priors(&self) -> impl Iterator<Item = (usize, [f64; 2])> {
        let parameters = self.model.parameters().iter().enumerate();
        let counted = parameters.filter(|_| self.has_priors);
        counted.filter_map(|(j, parameter)| Some((j, parameter.unknown.prior?)))
    }

    /// The number of residuals: of measured values, then of priors.
    pub(crate) fn count(&self) -> usize {
        self.measured.len() + self.priors().count()
    }

    /// The residuals over their standard errors, as their loss counts them, and the derivatives of the counted by these.
    fn residuals(&self, places: &DVector<f64>, predicted: &[f64]) -> (DVector<f64>, Vec<f64>) {
        let values = self.values(places);
        let mut all = DVector::zeros(self.count());
        let mut slopes = vec![1.0; self.count()];
        let n = self.measured.len();
        for i in 0..n {
            let residual = (predicted[i] - self.measured[i]) / self.errors[i];
            [all[i], slopes[i]] = self.loss.seen(residual);
        }
        for (k, (j, [mean, sd])) in self.priors().enumerate() {
            all[n + k] = (values[j] - mean) / sd;
        }
        (all, slopes)
    }

    fn predict(&self, places: &DVector<f64>) -> Result<Vec<f64>, FitError> {
        let mut predicted = vec![0.0; self.measured.len()];
        self.model.predict(&self.values(places), &mut predicted)?;
        Ok(predicted)
    }

    fn sum(&self, places: &DVector<f64>, predicted: &[f64]) -> f64 {
        self.residuals(places, predicted).0.norm_squared()
    }

    /// The predictions with the sum of squares; none where the theory has no values of a row, which a step on the way need
    /// not have.
    fn tried(&self, places: &DVector<f64>) -> Result<Option<(Vec<f64>, f64)>, FitError> {
        match self.predict(places) {
            Err(FitError::Row { .. }) => Ok(None),
            predicted => predicted.map(|predicted| {
                let sum = self.sum(places, &predicted);
                Some((predicted, sum))
            }),
        }
    }

    /// The predictions and their derivatives.
    fn tangent(&self, places: &DVector<f64>) -> Result<Tangent, FitError> {
        self.tangent_of(places.clone(), self.predict(places)?)
    }

    fn tangent_of(&self, places: DVector<f64>, predicted: Vec<f64>) -> Result<Tangent, FitError> {
        let mut by = DMatrix::zeros(predicted.len(), places.len());
        self.model.derivatives(&self.values(&places), &mut by)?;
        Ok(Tangent { places, predicted, by })
    }

    /// The residuals, and their derivatives by the places.
    pub(crate) fn linear(&self, tangent: &Tangent) -> (DVector<f64>, DMatrix<f64>) {
        let Tangent { places, predicted, by } = tangent;
        let (residuals, slopes) = self.residuals(places, predicted);
        let (n, parameters) = (self.measured.len(), self.model.parameters());
        let mut all = DMatrix::zeros(self.count(), parameters.len());
        for (j, parameter) in parameters.iter().enumerate() {
            let slope = parameter.slope(places[j]);
            for i in 0..n {
                all[(i, j)] = slopes[i] * slope * by[(i, j)] / self.errors[i];
            }
        }
        for (k, (j, [_, sd])) in self.priors().enumerate() {
            all[(n + k, j)] = parameters[j].slope(places[j]) / sd;
        }
        (residuals, all)
    }

    /// The minimum that is reached from these places, with those unknowns kept that are `held`.
    pub(crate) fn minimum(&self, start: &DVector<f64>, held: &[usize]) -> Result<Found, FitError> {
        self.minimum_from(self.tangent(start)?, held)
    }

    /// The same from places with their derivatives.
    pub(crate) fn minimum_from(
        &self,
        mut tangent: Tangent,
        held: &[usize],
    ) -> Result<Found, FitError> {
        let (mut residuals, mut derivatives) = self.linear(&tangent);
        let (mut damping, mut growth) = (DAMPING, 2.0);
        let error = self.model.jitter();
        for _ in 0..MOST_STEPS {
            let sum = residuals.norm_squared();
            let places = &tangent.places;
            let gradient = derivatives.tr_mul(&residuals);
            let is_free = |j: usize| {
                let is_held = (places[j] <= 0.0 && gradient[j] >= 0.0)
                    || (places[j] >= 1.0 && gradient[j] <= 0.0);
                !is_held && !held.contains(&j)
            };
            let free: Vec<usize> = (0..places.len()).filter(|j| is_free(*j)).collect();
            let own = derivatives.select_columns(&free);
            let normal = own.tr_mul(&own);
            let largest = normal.diagonal().max();
            if free.is_empty() || largest == 0.0 {
                break;
            }
            let is_settled;
            let mut taken = None;
            loop {
                let mut damped = normal.clone();
                for j in 0..free.len() {
                    damped[(j, j)] += damping * (normal[(j, j)] + 1e-9 * largest);
                }
                let right = -own.tr_mul(&residuals);
                let Some(step) = damped.cholesky().map(|factor| factor.solve(&right)) else {
                    damping *= 10.0;
                    if damping > MOST_DAMPING {
                        is_settled = true;
                        break;
                    }
                    continue;
                };
                // What the sum would fall by if the residuals were linear; errors of the predictions hide less.
                let fall = 2.0 * step.dot(&right) - (&own * &step).norm_squared();
                if fall <= error * (1.0 + sum) {
                    is_settled = true;
                    break;
                }
                let mut next = places.clone();
                for (k, j) in free.iter().enumerate() {
                    next[*j] = (next[*j] + step[k]).clamp(0.0, 1.0);
                }
                let moved = (&next - places).amax();
                let reached = self.tried(&next)?;
                if let Some((predicted, reached)) = reached.filter(|(_, reached)| *reached < sum) {
                    is_settled = sum - reached <= error * (1.0 + sum) || moved <= SMALL;
                    taken = Some((next, predicted));
                    damping = (damping * 0.2).max(1e-15);
                    growth = 2.0;
                    break;
                }
                damping *= growth;
                growth *= 2.0;
                if moved <= SMALL || damping > MOST_DAMPING {
                    is_settled = true;
                    break;
                }
            }
            if let Some((places, predicted)) = taken {
                tangent = self.tangent_of(places, predicted)?;
                (residuals, derivatives) = self.linear(&tangent);
            }
            if is_settled {
                break;
            }
        }
        Ok(Found { sum: residuals.norm_squared(), tangent })
    }

    /// The minimum near a start with one unknown `held`, by the derivatives at the best places, for the ends of profiles: it
    /// need not be exact. Where that does not lead to it, as [`Squares::minimum`].
    pub(crate) fn minimum_near(
        &self,
        start: &DVector<f64>,
        held: usize,
        derivatives: &DMatrix<f64>,
    ) -> Result<(DVector<f64>, f64), FitError> {
        let mut places = start.clone();
        let (mut residuals, _) = self.residuals(&places, &self.predict(&places)?);
        let mut sum = residuals.norm_squared();
        for _ in 0..MOST_CHORDS {
            let is_free = |j: &usize| *j != held && derivatives.column(*j).amax() > 0.0;
            let free: Vec<usize> = (0..places.len()).filter(is_free).collect();
            let own = derivatives.select_columns(&free);
            let right = -own.tr_mul(&residuals);
            let Some(step) = own.tr_mul(&own).cholesky().map(|factor| factor.solve(&right)) else {
                break;
            };
            let mut next = places.clone();
            for (k, j) in free.iter().enumerate() {
                next[*j] = (next[*j] + step[k]).clamp(0.0, 1.0);
            }
            let Ok(predicted) = self.predict(&next) else { break };
            let (found, _) = self.residuals(&next, &predicted);
            let reached = found.norm_squared();
            // Where the derivatives are slightly others, the sum may rise a little at its least.
            let is_settled = (sum - reached).abs() < NEARLY;
            if reached > sum && !is_settled {
                break;
            }
            if reached < sum {
                (places, residuals, sum) = (next, found, reached);
            }
            if is_settled {
                return Ok((places, sum));
            }
        }
        let found = self.minimum(&places, &[held])?;
        Ok((found.tangent.places, found.sum))
    }

    /// The least of the minima that are reached from several starts, with those unknowns kept that are `held` at their
    /// `places`.
    pub(crate) fn least(&self, starts: &[DVector<f64>]) -> Result<Found, FitError> {
        let mut tried: Vec<(f64, usize)> = Vec::with_capacity(starts.len());
        for (n, start) in starts.iter().enumerate() {
            tried.push((self.tried(start)?.map_or(f64::INFINITY, |(_, sum)| sum), n));
        }
        tried.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut best: Option<Found> = None;
        for (_, n) in tried.iter().take(CHOSEN) {
            let found = self.minimum(&starts[*n], &[])?;
            if best.as_ref().is_none_or(|best| found.sum < best.sum) {
                best = Some(found);
            }
        }
        let mut best = best.ok_or(FitError::NoUnknown)?;
        // Where an unknown does next to nothing, as friction that no slip reaches, and where residuals are large, better
        // values may be far away.
        let (_, derivatives) = self.linear(&best.tangent);
        let unknowns = best.places().len();
        let of_data = derivatives.rows(0, self.measured.len());
        // Less than a standard error for a change as large as its distance from its lower bound.
        let does_nothing = |j: &usize| of_data.column(*j).amax() * best.places()[*j] < 1.0;
        let is_poor = best.sum > POOR * self.count() as f64;
        let doubtful: Vec<usize> = (0..unknowns).filter(|j| is_poor || does_nothing(j)).collect();
        for j in doubtful {
            let mut far = Vec::with_capacity(FAR_STARTS as usize);
            for mut start in (1..=FAR_STARTS).map(|n| low(unknowns, j, n)) {
                (0..unknowns).filter(|i| *i != j).for_each(|i| start[i] = best.places()[i]);
                far.push((self.tried(&start)?.map_or(f64::INFINITY, |(_, sum)| sum), start));
            }
            far.sort_by(|a, b| a.0.total_cmp(&b.0));
            for (_, start) in far.iter().filter(|(sum, _)| sum.is_finite()).take(CHOSEN) {
                let found = self.minimum(start, &[])?;
                if found.sum < best.sum {
                    best = found;
                }
            }
        }
        Ok(best)
    }
}

/// Starts that are followed to their minima, of those that are tried.
const CHOSEN: usize = 3;
/// The mean square of residuals over their standard errors that is large.
const POOR: f64 = 9.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::estimate;
    use crate::interval::deviation;
    use crate::measured::Measurement;
    use crate::model::Parameter;
    use carom_cases::case::Unknown;

    /// Misra1a of NIST's reference data for nonlinear regression: y = b1 (1 - exp(-b2 x)).
    struct Misra {
        x: Vec<f64>,
        parameters: Vec<Parameter>,
    }

    impl Model for Misra {
        fn parameters(&self) -> &[Parameter] {
            &self.parameters
        }

        fn count(&self) -> usize {
            self.x.len()
        }

        fn predict(&self, values: &[f64], into: &mut [f64]) -> Result<(), FitError> {
            for (y, x) in into.iter_mut().zip(&self.x) {
                *y = -values[0] * libm::expm1(-values[1] * x);
            }
            Ok(())
        }

        fn step(&self) -> f64 {
            6e-6
        }

        fn jitter(&self) -> f64 {
            1e-15
        }
    }

    #[test]
    fn the_certified_values_of_a_reference_are_met() {
        let x = [
            77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1,
            689.1, 760.0,
        ];
        let y = [
            10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40,
            75.47, 81.78,
        ];
        let unknown = |low, high| Unknown { low, high, prior: None, widest: [low, high] };
        let parameters = vec![
            Parameter { field: "b1", unit: "", unknown: unknown(1.0, 1000.0) },
            Parameter { field: "b2", unit: "", unknown: unknown(1e-5, 1e-1) },
        ];
        let model = Misra { x: x.to_vec(), parameters };
        let one = |(row, value): (usize, &f64)| Measurement {
            row,
            quantity: 0,
            value: *value,
            error: None,
        };
        let measured: Vec<Measurement> = y.iter().enumerate().map(one).collect();
        let found = estimate(&model, &measured, Loss::Squares, None).unwrap();
        let is_close = |value: f64, certified: f64| {
            assert!((value / certified - 1.0).abs() < 1e-6, "{value} {certified}");
        };
        is_close(found.values[0], 2.389_421_291_8e2);
        is_close(found.values[1], 5.501_564_318_1e-4);
        is_close(found.errors[0], 1.018_787_633_0e-1);
        is_close(deviation(&model, &found, 0).unwrap(), 2.707_007_524_1);
        is_close(deviation(&model, &found, 1).unwrap(), 7.266_868_843_6e-6);
    }
}
