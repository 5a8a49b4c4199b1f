//! Intervals of 95 %: by Student's t about the best value, and by the profile of the sum of squares.

use crate::FitError;
use crate::estimate::Estimate;
use crate::model::Model;
use crate::squares::Squares;
use statrs::distribution::{ContinuousCDF as _, Normal, StudentsT};

/// The upper quantile of an interval of 95 %.
const UPPER: f64 = 0.975;
/// The largest number of minima for one end of a profile, and when an end is found: in standard errors.
const MOST: usize = 12;
const CLOSE: f64 = 2e-3;

/// The half width of an interval of 95 % in standard errors: by Student's t where the error of the measured values was
/// estimated, by the normal distribution where it was given. None without degrees of freedom, and without scatter by
/// which an error could be estimated.
pub(crate) fn width(estimate: &Estimate) -> Option<f64> {
    match (estimate.freedom, estimate.is_estimated) {
        (0, _) => None,
        _ if !estimate.without_scatter.is_empty() => None,
        (freedom, true) => {
            let of_freedom = StudentsT::new(0.0, 1.0, freedom as f64).ok()?;
            Some(of_freedom.inverse_cdf(UPPER))
        }
        (_, false) => Some(Normal::standard().inverse_cdf(UPPER)),
    }
}

/// The standard error of an unknown; none if it is not determined.
pub(crate) fn deviation<M: Model + ?Sized>(
    model: &M,
    estimate: &Estimate,
    unknown: usize,
) -> Option<f64> {
    let place = estimate.found.places()[unknown];
    let slope = model.parameters()[unknown].slope(place);
    estimate.is_determined(unknown).then(|| slope * estimate.covariance[(unknown, unknown)].sqrt())
}

/// The ends of the profile interval of an unknown: where the least sum of squares with the unknown kept there exceeds that of
/// the best values by the square of `width`. An end at a bound is that bound.
pub(crate) fn profile<M: Model + ?Sized>(
    squares: &Squares<'_, M>,
    estimate: &Estimate,
    unknown: usize,
    width: f64,
) -> Result<[f64; 2], FitError> {
    let parameter = &squares.model.parameters()[unknown];
    let mut ends = [0.0; 2];
    for (end, sign) in ends.iter_mut().zip([-1.0, 1.0]) {
        *end = parameter.at(profile_end(squares, estimate, unknown, sign * width)?);
    }
    Ok(ends)
}

/// The place where the root of the excess is `width`, by false position between places below and beyond.
fn profile_end<M: Model + ?Sized>(
    squares: &Squares<'_, M>,
    estimate: &Estimate,
    unknown: usize,
    width: f64,
) -> Result<f64, FitError> {
    let best = estimate.found.places()[unknown];
    let bound = if width > 0.0 { 1.0 } else { 0.0 };
    let deviation = estimate.covariance[(unknown, unknown)].sqrt();
    let target = width.abs();
    // The others follow as they are correlated.
    let follow = estimate.covariance.column(unknown) / estimate.covariance[(unknown, unknown)];
    let (mut warm, mut last) = (estimate.found.places().clone(), best);
    let mut excess = |place: f64| -> Result<f64, FitError> {
        warm += &follow * (place - last);
        warm.apply(|place| *place = place.clamp(0.0, 1.0));
        warm[unknown] = place;
        let (places, sum) = squares.minimum_near(&warm, unknown, &estimate.derivatives)?;
        (warm, last) = (places, place);
        Ok((sum - estimate.found.sum).max(0.0).sqrt())
    };
    let (mut below, mut beyond) = ((best, 0.0), None);
    let mut place = (best + width * deviation).clamp(0.0, 1.0);
    for _ in 0..MOST {
        let found = excess(place)?;
        if (found - target).abs() < CLOSE || (found < target && place == bound) {
            break;
        }
        if found < target {
            below = (place, found)
        } else {
            beyond = Some((place, found))
        }
        place = match beyond {
            Some((far, high)) => {
                let part = (target - below.1) / (high - below.1);
                below.0 + part.clamp(0.05, 0.95) * (far - below.0)
            }
            // Beyond what was tried, by the slope so far.
            None if below.1 > 0.0 => {
                (best + (below.0 - best) * (target / below.1).clamp(1.001, 4.0)).clamp(0.0, 1.0)
            }
            None => bound,
        };
    }
    Ok(place)
}
