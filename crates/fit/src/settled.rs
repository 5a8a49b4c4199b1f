//! A minimum together with standard errors that are not known and follow from its residuals.

use crate::FitError;
use crate::estimate::{State, first_errors};
use crate::measured::Measurement;
use crate::model::Model;
use crate::squares::{Found, Squares};

/// Rounds in which errors are estimated, and their relative change at the end.
const ROUNDS: usize = 30;
const STEADY: f64 = 1e-10;
/// Degrees of freedom from which data alone tell their error: nearly 1, for the round-off of leverages.
const LEAST_FREEDOM: f64 = 0.999;
/// Errors, over the spread of the data, beside which these tell next to nothing.
const LARGE: f64 = 1e3;

/// A minimum with the errors that its residuals tell.
pub(crate) struct Settled {
    pub(crate) found: Found,
    pub(crate) state: State,
    pub(crate) errors: Vec<f64>,
}

impl Settled {
    /// From a minimum with the errors of `squares`.
    pub(crate) fn from<M: Model + ?Sized>(
        squares: &mut Squares<'_, M>,
        measured: &[Measurement],
        mut found: Found,
    ) -> Result<Self, FitError> {
        let is_estimated = measured.iter().any(|one| one.error.is_none());
        let mut state = State::of(squares, &found.tangent);
        for _ in 0..if is_estimated { ROUNDS } else { 0 } {
            let change = state.renew_errors(squares, &found.tangent.predicted, measured);
            found = squares.minimum_from(found.tangent, &[])?;
            state = State::of(squares, &found.tangent);
            if change < STEADY {
                break;
            }
        }
        Ok(Self { found, state, errors: squares.errors.clone() })
    }

    /// The best of this one and of those that are reached from the values of the data alone and from those of the priors.
    ///
    /// A prior that contradicts data of unknown error leaves two: small errors far from the prior, or large ones near it.
    /// The better one has the greater posterior with the error integrated out, of Student's form: S^(-nu/2) for a sum S of
    /// squares with nu degrees of freedom.
    pub(crate) fn or_better<M: Model + ?Sized>(
        self,
        squares: &mut Squares<'_, M>,
        measured: &[Measurement],
        start: impl FnOnce(&Squares<'_, M>) -> Result<Found, FitError>,
    ) -> Result<Self, FitError> {
        squares.has_priors = false;
        squares.errors = first_errors(measured);
        let begin = start(squares)?;
        let alone = Self::from(squares, measured, begin)?;
        squares.has_priors = true;
        let leverages = measured.iter().zip(&alone.state.leverage);
        let free = leverages.map(|(one, own)| if one.error.is_some() { 0.0 } else { 1.0 - own });
        let free: Vec<f64> = free.collect();
        // Data without freedom of their own tell nothing of their error.
        if free.iter().sum::<f64>() < LEAST_FREEDOM {
            return Ok(self);
        }
        let mut of_priors = alone.found.places().clone();
        for (place, one) in of_priors.iter_mut().zip(squares.model.parameters()) {
            *place = one.unknown.prior.map_or(*place, |[mean, _]| one.place(mean));
        }
        let large = |one: &Measurement, first: f64| one.error.unwrap_or(LARGE * first);
        let all = measured.iter().zip(first_errors(measured));
        let large: Vec<f64> = all.map(|(one, first)| large(one, first)).collect();
        let mut best = self;
        for (places, errors) in [(alone.found.tangent.places, alone.errors), (of_priors, large)] {
            squares.errors = errors;
            let found = squares.minimum(&places, &[])?;
            let other = Self::from(squares, measured, found)?;
            if other.misfit(&free) < best.misfit(&free) {
                best = other;
            }
        }
        Ok(best)
    }

    /// -2 times the logarithm of the posterior, with degrees of freedom for each measured value.
    fn misfit(&self, free: &[f64]) -> f64 {
        let logs = free.iter().zip(&self.errors).map(|(free, error)| free * libm::log(*error));
        self.found.sum + 2.0 * logs.sum::<f64>()
    }
}
