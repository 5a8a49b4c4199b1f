//! The best values of the unknowns, the errors of the measured values where they are not known, and what is left open.

use crate::FitError;
use crate::loss::Loss;
use crate::measured::Measurement;
use crate::model::Model;
use crate::settled::Settled;
use crate::squares::{Found, Squares, Tangent};
use crate::starts::starts;
use nalgebra::{DMatrix, DVector};

/// A direction is open if its standard error exceeds this part of what the bounds allow.
const OPEN: f64 = 0.5;
/// An unknown takes part in a direction if its component is at least this part of the largest.
const SHARE: f64 = 0.2;
/// An estimated error is at least this part of the largest measured value; up to the other part there is no scatter.
const LEAST_ERROR: f64 = 1e-12;
const NO_SCATTER: f64 = 1e-9;

/// The best values, and the state of the fit there.
#[derive(Debug, Clone)]
pub(crate) struct Estimate {
    pub(crate) found: Found,
    pub(crate) values: Vec<f64>,
    pub(crate) predicted: Vec<f64>,
    /// The standard error of each measured value, given or estimated.
    pub(crate) errors: Vec<f64>,
    /// How much each measured value determines its own prediction, from 0 to 1.
    pub(crate) leverage: Vec<f64>,
    /// The covariance of the places, without the open directions.
    pub(crate) covariance: DMatrix<f64>,
    /// The derivatives of the residuals by the places.
    pub(crate) derivatives: DMatrix<f64>,
    /// The directions of places that neither data nor priors determine.
    pub(crate) open: Vec<DVector<f64>>,
    /// Those that the data do not determine.
    pub(crate) open_to_data: Vec<DVector<f64>>,
    /// Measured values and priors less what they determine.
    pub(crate) freedom: usize,
    /// Whether a standard error was estimated.
    pub(crate) is_estimated: bool,
    /// The quantities whose error should be estimated, but whose values do not scatter.
    pub(crate) without_scatter: Vec<usize>,
}

impl Estimate {
    /// Whether data and priors determine this unknown.
    pub(crate) fn is_determined(&self, unknown: usize) -> bool {
        is_outside(&self.open, unknown)
    }

    /// Whether the data alone determine it.
    pub(crate) fn is_determined_by_data(&self, unknown: usize) -> bool {
        is_outside(&self.open_to_data, unknown)
    }
}

fn is_outside(open: &[DVector<f64>], unknown: usize) -> bool {
    !open.iter().any(|direction| takes_part(direction, unknown))
}

/// Whether an unknown changes noticeably along a direction.
pub(crate) fn takes_part(direction: &DVector<f64>, unknown: usize) -> bool {
    direction[unknown].abs() >= SHARE * direction.amax()
}

/// The fit of a model to measured values, from these places, or from several starts.
pub(crate) fn estimate<M: Model + ?Sized>(
    model: &M,
    measured: &[Measurement],
    loss: Loss,
    begin: Option<DVector<f64>>,
) -> Result<Estimate, FitError> {
    let unknowns = model.parameters().len();
    let priors = model.parameters().iter().filter(|one| one.unknown.prior.is_some()).count();
    if measured.len() + priors < unknowns || measured.is_empty() {
        return Err(FitError::TooFew { measured: measured.len(), unknowns });
    }
    let values: Vec<f64> = measured.iter().map(|one| one.value).collect();
    let is_estimated = measured.iter().any(|one| one.error.is_none());
    let start = |squares: &Squares<'_, M>| match &begin {
        Some(places) => squares.minimum(places, &[]),
        None => squares.least(&starts(unknowns)),
    };
    let mut squares = Squares {
        model,
        measured: &values,
        errors: first_errors(measured),
        loss,
        has_priors: true,
    };
    let found = start(&squares)?;
    let mut settled = Settled::from(&mut squares, measured, found)?;
    if is_estimated && priors > 0 {
        settled = settled.or_better(&mut squares, measured, start)?;
    }
    let Settled { found, state, errors } = settled;
    let n = measured.len();
    let freedom = (n + priors).saturating_sub(unknowns - state.open.len());
    let values = squares.values(found.places());
    let without_scatter = if freedom > 0 { without_scatter(measured, &errors) } else { Vec::new() };
    Ok(Estimate {
        without_scatter,
        values,
        predicted: found.tangent.predicted.clone(),
        errors,
        leverage: state.leverage,
        covariance: state.covariance,
        derivatives: state.derivatives,
        open: state.open,
        open_to_data: state.open_to_data,
        freedom,
        is_estimated,
        found,
    })
}

/// The given errors; in the place of others the spread of the quantity.
pub(crate) fn first_errors(measured: &[Measurement]) -> Vec<f64> {
    let spread = |quantity: usize| -> f64 {
        let own = || measured.iter().filter(|one| one.quantity == quantity);
        let count = own().count() as f64;
        let mean = own().map(|one| one.value).sum::<f64>() / count;
        let spread = (own().map(|one| (one.value - mean).powi(2)).sum::<f64>() / count).sqrt();
        if spread > 0.0 { spread } else { mean.abs().max(1.0) }
    };
    let most = measured.iter().map(|one| one.quantity).max().unwrap_or(0);
    let spreads: Vec<f64> = (0..=most).map(spread).collect();
    measured.iter().map(|one| one.error.unwrap_or(spreads[one.quantity])).collect()
}

/// The quantities whose estimated errors are round-off of their values.
fn without_scatter(measured: &[Measurement], errors: &[f64]) -> Vec<usize> {
    let most = measured.iter().map(|one| one.quantity).max().unwrap_or(0);
    let is_without = |quantity: &usize| {
        let own = || {
            measured
                .iter()
                .zip(errors)
                .filter(|(one, _)| one.quantity == *quantity && one.error.is_none())
        };
        let size = own().map(|(one, _)| one.value.abs()).fold(f64::MIN_POSITIVE, f64::max);
        own().next().is_some_and(|(_, error)| *error <= NO_SCATTER * size)
    };
    (0..=most).filter(is_without).collect()
}

/// What the derivatives at a minimum tell.
pub(crate) struct State {
    pub(crate) leverage: Vec<f64>,
    pub(crate) covariance: DMatrix<f64>,
    pub(crate) derivatives: DMatrix<f64>,
    pub(crate) open: Vec<DVector<f64>>,
    pub(crate) open_to_data: Vec<DVector<f64>>,
}

impl State {
    pub(crate) fn of<M: Model + ?Sized>(squares: &Squares<'_, M>, tangent: &Tangent) -> Self {
        let n = squares.measured.len();
        let (_, all) = squares.linear(tangent);
        let own = Split::of(&all);
        let leverage = (0..n).map(|i| own.leverage(i)).collect();
        let open_to_data = Split::of(&all.rows(0, n).into_owned()).open;
        let (covariance, open) = (own.covariance, own.open);
        Self { leverage, covariance, derivatives: all, open, open_to_data }
    }

    /// Estimates the errors of quantities for which none are given, and returns their largest relative change.
    pub(crate) fn renew_errors<M: Model + ?Sized>(
        &self,
        squares: &mut Squares<'_, M>,
        predicted: &[f64],
        measured: &[Measurement],
    ) -> f64 {
        let most = measured.iter().map(|one| one.quantity).max().unwrap_or(0);
        let mut change: f64 = 0.0;
        for quantity in 0..=most {
            let own = || {
                let all = measured.iter().enumerate();
                all.filter(move |(_, one)| one.quantity == quantity && one.error.is_none())
            };
            let size = own().map(|(_, one)| one.value.abs()).fold(f64::MIN_POSITIVE, f64::max);
            let rest = |i: usize| predicted[i] - squares.measured[i];
            let estimated = match squares.loss {
                Loss::Squares => {
                    let sum: f64 = own().map(|(i, _)| rest(i).powi(2)).sum();
                    let free: f64 = own().map(|(i, _)| 1.0 - self.leverage[i]).sum();
                    // Without freedom nothing is known of the error.
                    if free > 1e-9 { (sum / free).sqrt() } else { 0.0 }
                }
                Loss::Huber => middle(own().map(|(i, _)| rest(i).abs()).collect()) / NORMAL_MIDDLE,
            };
            let estimated = estimated.max(LEAST_ERROR * size);
            let places: Vec<usize> = own().map(|(i, _)| i).collect();
            for i in places {
                change = change.max((estimated / squares.errors[i] - 1.0).abs());
                squares.errors[i] = estimated;
            }
        }
        change
    }
}

/// The size that half of normal deviates exceed.
const NORMAL_MIDDLE: f64 = 0.674_489_750_196_081_7;

fn middle(mut sizes: Vec<f64>) -> f64 {
    sizes.sort_by(f64::total_cmp);
    let half = sizes.len() / 2;
    match sizes.len() % 2 {
        _ if sizes.is_empty() => 0.0,
        0 => 0.5 * (sizes[half - 1] + sizes[half]),
        _ => sizes[half],
    }
}

/// Derivatives by their singular values.
struct Split {
    /// Rows of left singular vectors of what is determined.
    left: DMatrix<f64>,
    covariance: DMatrix<f64>,
    open: Vec<DVector<f64>>,
}

impl Split {
    fn of(derivatives: &DMatrix<f64>) -> Self {
        let unknowns = derivatives.ncols();
        // Of a matrix with fewer rows than columns not all right vectors are found.
        let rows = derivatives.nrows().max(unknowns);
        let svd = derivatives.clone().resize(rows, unknowns, 0.0).svd(true, true);
        let [Some(u), Some(v_t)] = [svd.u, svd.v_t] else {
            let left = DMatrix::zeros(rows, 0);
            return Self { left, covariance: DMatrix::zeros(unknowns, unknowns), open: Vec::new() };
        };
        let is_open = |k: usize| svd.singular_values[k] * OPEN < 1.0;
        let shut: Vec<usize> = (0..unknowns).filter(|k| !is_open(*k)).collect();
        let mut covariance = DMatrix::zeros(unknowns, unknowns);
        for k in &shut {
            let right = v_t.row(*k).transpose() / svd.singular_values[*k];
            covariance += &right * right.transpose();
        }
        let open = (0..unknowns).filter(|k| is_open(*k)).map(|k| v_t.row(k).transpose()).collect();
        Self { left: u.select_columns(&shut), covariance, open }
    }

    fn leverage(&self, row: usize) -> f64 {
        self.left.row(row).norm_squared().min(1.0)
    }
}
