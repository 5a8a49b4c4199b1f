//! The fit of a case to data, from file to result.

use crate::columns::{self, GivenError, Input, Read};
use crate::data::{Data, DataColumn};
use crate::estimate::{Estimate, estimate};
use crate::fitted::{Correlation, Curve, Determined, Fit, Knowledge, Point, Prediction, Quality};
use crate::interval::{deviation, profile, width};
use crate::kind::{Kind, OfContacts, OfHistories, OfImpacts};
use crate::loss::Loss;
use crate::measured::Measurement;
use crate::model::{Model, Parameter};
use crate::squares::Squares;
use crate::{FitError, told};
use carom_cases::case::{CaseError, CaseFault, CaseKind, OpenCase, Renewed};
use carom_cases::input::CaseFile;
use nalgebra::{DMatrix, DVector};

/// How a case is fitted.
#[derive(Debug, Clone, Default)]
pub struct Options<'a> {
    /// Standard errors of measured quantities that have no column of them.
    pub errors: &'a [GivenError],
    /// How residuals count.
    pub loss: Loss,
    /// Inputs of which predictions are asked for.
    pub predict: Option<&'a Data>,
    /// Points of the fitted curve; 0 for none.
    pub curve: usize,
}

/// Determines the unknowns of a case from data.
///
/// ```
/// use carom_cases::input::CaseFile;
/// use carom_fit::{Data, Options, fit};
/// let case = CaseFile::from_text("
///     body_1 = { shape = \"sphere\", radius = 0.0025, material = { young_modulus = 380e9, poisson = 0.23 }, density = 4000 }
///     body_2 = { shape = \"plane\", material = { young_modulus = 380e9, poisson = 0.23 }, fixed = true }
///     contact = { friction = { fit = [0.01, 1] } }
///     approach = { speed = 3.9, angle = 0 }
/// ");
/// // Sliding: the tangential velocity falls by f (1 + e) times the normal one.
/// let data = Data::from_csv("angle,body_1_tangential_ratio\n60,0.8848\n70,0.9265\n80,0.9645\n")?;
/// let fit = fit(&case, &data, &Options::default())?;
/// assert!((fit.parameters[0].value - 0.1).abs() < 1e-3);
/// # Ok::<(), carom_fit::FitError>(())
/// ```
///
/// # Errors
/// [`FitError`] if case or data have an error, the case has no unknown, there are fewer values than unknowns, or an outcome
/// cannot be computed.
pub fn fit(file: &CaseFile, data: &Data, options: &Options<'_>) -> Result<Fit, FitError> {
    let kind = file.told(CaseKind::of)?;
    match kind {
        CaseKind::Impact => run::<OfImpacts>(&file.parse()?, data, options),
        CaseKind::Hertz => run::<OfContacts>(&file.parse()?, data, options),
        CaseKind::History => run::<OfHistories>(&file.parse()?, data, options),
        other => {
            // A text that is like no kind of case has the errors of an impact.
            let is_other = |error: CaseError| matches!(error.fault, CaseFault::OtherKind { .. });
            if CaseKind::Impact.check(file.text()).is_err_and(|error| !is_other(error)) {
                file.told(|text| CaseKind::Impact.check(text))?;
            }
            Err(FitError::Kind { kind: other.name })
        }
    }
}

/// Sentences about inputs without a unit whose numbers are unusual, as angles in radians.
fn unusual(data: &Data, inputs: &[Input]) -> Vec<String> {
    let of_input = |input: &Input| {
        let bare = |column: &&DataColumn| {
            column.unit.is_empty() && input.field.ends_with(column.name.as_str())
        };
        let column = data.columns().iter().find(bare)?;
        let text = format!("{} = {:?}", input.field, input.values);
        let told = CaseKind::Impact.unusual(&text).pop()?;
        let (_, about) = told.split_once("` = ")?;
        let unit = "a unit may stand behind the name, as in \"angle (rad)\"";
        Some(format!("column `{}` = {about}; {unit}", column.name))
    };
    inputs.iter().filter_map(of_input).collect()
}

fn run<K: Kind>(
    case: &OpenCase<'_, K::Case>,
    data: &Data,
    options: &Options<'_>,
) -> Result<Fit, FitError> {
    let read = columns::read::<K::Case, K::Known>(case, data, options.errors)?;
    let mut unknowns = unknowns(case, &read.inputs)?;
    let (model, estimate) = loop {
        let model = K::model(case, unknowns.clone(), &read, &read.measured)?;
        let begin = begin::<K>(case, &unknowns, &read, options.loss)?;
        let found = estimate(&model, &read.measured, options.loss, begin)?;
        let places = unknowns.0.iter_mut().zip(found.found.places());
        let widened = places.filter_map(|(one, place)| one.widen(*place).then_some(())).count();
        if widened == 0 {
            break (model, found);
        }
    };
    let (values, errors) = (measured(&read.measured), estimate.errors.clone());
    let loss = options.loss;
    let squares = Squares { model: &model, measured: &values, errors, loss, has_priors: true };
    let parameters = determined(&squares, &estimate)?;
    let quality = quality(&read, &estimate, options.loss, parameters.len());
    let points = points(&read, &estimate, options.loss);
    let residuals: Vec<f64> = points.iter().map(Point::residual).collect();
    let mut statements = K::told(&model, &estimate);
    statements.extend(told::statements(model.parameters(), &parameters, &estimate));
    let name = |quantity: &usize| read.quantities[*quantity].0.name.as_str();
    let without: Vec<&str> = estimate.without_scatter.iter().map(name).collect();
    statements.extend(told::without_scatter(&without));
    let mut warnings = told::warnings(&parameters, &estimate, &quality, &residuals);
    warnings.extend(told::contradictions(model.parameters(), &parameters));
    warnings.extend(unusual(data, &read.inputs));
    warnings.extend(read.unused.iter().map(|name| format!("column `{name}` is not used")));
    let ahead = |inputs: Vec<Input>| ahead::<K>(case, &unknowns, &read, inputs, &estimate);
    let curve = curve(&read, if K::HAS_CURVE { options.curve } else { 0 }, ahead)?;
    let predictions = match options.predict {
        Some(data) => {
            let predicted = columns::inputs::<K::Case, K::Known>(case, data).and_then(ahead);
            predicted.map_err(|error| FitError::Inputs(Box::new(error)))?
        }
        None => Vec::new(),
    };
    Ok(Fit {
        correlations: correlations(&parameters, &estimate),
        curve,
        parameters,
        points,
        quality,
        statements,
        warnings,
        predictions,
    })
}

/// The best places for a part of many measured values, so that several starts do not take long.
fn begin<K: Kind>(
    case: &OpenCase<'_, K::Case>,
    unknowns: &(Vec<Parameter>, Vec<usize>),
    read: &Read<K::Known>,
    loss: Loss,
) -> Result<Option<DVector<f64>>, FitError> {
    let apart = read.measured.len() / PART;
    if apart < 2 {
        return Ok(None);
    }
    let is_chosen = |one: &&Measurement| one.row.is_multiple_of(apart);
    let chosen: Vec<Measurement> = read.measured.iter().filter(is_chosen).copied().collect();
    let model = K::model(case, unknowns.clone(), read, &chosen)?;
    Ok(Some(estimate(&model, &chosen, loss, None)?.found.tangent.places))
}

/// Measured values that several starts are compared by, at least.
const PART: usize = 100;

fn measured(all: &[Measurement]) -> Vec<f64> {
    all.iter().map(|one| one.value).collect()
}

/// The unknowns of a case and their offsets in it; every other number that varies must be replaced by the data.
fn unknowns<C: Renewed>(
    case: &OpenCase<'_, C>,
    replaced: &[Input],
) -> Result<(Vec<Parameter>, Vec<usize>), FitError> {
    let mut found = (Vec::new(), Vec::new());
    for input in case.inputs() {
        if replaced.iter().any(|own| own.place == input.place()) {
            continue;
        }
        let Some(unknown) = input.unknown() else {
            return Err(FitError::Varies { field: input.field });
        };
        found.0.push(Parameter { field: input.field, unit: input.unit, unknown });
        found.1.push(input.place());
    }
    if found.0.is_empty() { Err(FitError::NoUnknown) } else { Ok(found) }
}

/// The data tell less of an unknown than its prior if its standard error is more than this part of the prior's.
const MOSTLY: f64 = std::f64::consts::FRAC_1_SQRT_2;

fn determined<M: Model>(
    squares: &Squares<'_, M>,
    estimate: &Estimate,
) -> Result<Vec<Determined>, FitError> {
    let width = width(estimate);
    let one = |(j, parameter): (usize, &Parameter)| {
        let (value, place) = (estimate.values[j], estimate.found.places()[j]);
        let is_known = estimate.is_determined(j);
        let own = deviation(squares.model, estimate, j);
        let prior = parameter.unknown.prior.zip(own);
        let narrows = prior.is_none_or(|([_, prior], own)| own < MOSTLY * prior);
        // Without a prior of its own an unknown is known by the data, be it with the prior of another one.
        let is_of_data = parameter.unknown.prior.is_none() || estimate.is_determined_by_data(j);
        let knowledge = match (is_known, narrows && is_of_data) {
            (false, _) => Knowledge::Nothing,
            _ if place <= 0.0 || place >= 1.0 => Knowledge::AtBound,
            (true, false) => Knowledge::Prior,
            (true, true) => Knowledge::Data,
        };
        let deviation = own
            .filter(|_| estimate.freedom > 0 || !estimate.is_estimated)
            .filter(|_| estimate.without_scatter.is_empty())
            .filter(|_| knowledge != Knowledge::AtBound);
        let interval = width
            .zip(deviation)
            .map(|(width, deviation)| [value - width * deviation, value + width * deviation]);
        let profile = match width.filter(|_| is_known) {
            Some(width) => Some(profile(squares, estimate, j, width)?),
            None => None,
        };
        let (field, unit) = (parameter.field, parameter.unit);
        Ok(Determined { parameter: field, unit, value, deviation, interval, profile, knowledge })
    };
    squares.model.parameters().iter().enumerate().map(one).collect()
}

fn quality<O>(read: &Read<O>, estimate: &Estimate, loss: Loss, unknowns: usize) -> Quality {
    let of = |(k, (quantity, _)): (usize, &(crate::Quantity, O))| {
        let all = read.measured.iter().zip(&estimate.errors);
        let mut own = all.filter(|(one, _)| one.quantity == k && one.error.is_none());
        own.next().map(|(_, error)| (quantity.name.clone(), *error, quantity.unit))
    };
    let rest = |i: usize| (read.measured[i].value - estimate.predicted[i]) / estimate.errors[i];
    Quality {
        measured: read.measured.len(),
        unknowns,
        freedom: estimate.freedom,
        chi_squared: (0..read.measured.len()).map(|i| rest(i).powi(2)).sum(),
        has_errors: !estimate.is_estimated,
        estimated: read.quantities.iter().enumerate().filter_map(of).collect(),
        loss: loss.name(),
    }
}

fn points<O>(read: &Read<O>, estimate: &Estimate, loss: Loss) -> Vec<Point> {
    let point = |(i, one): (usize, &Measurement)| {
        let (error, fitted) = (estimate.errors[i], estimate.predicted[i]);
        Point {
            row: one.row + 1,
            quantity: read.quantities[one.quantity].0.name.clone(),
            unit: read.quantities[one.quantity].0.unit,
            measured: one.value,
            error,
            fitted,
            leverage: estimate.leverage[i],
            weight: loss.weight((one.value - fitted) / error),
        }
    };
    read.measured.iter().enumerate().map(point).collect()
}

fn correlations(parameters: &[Determined], estimate: &Estimate) -> Vec<Correlation> {
    let pairs = (0..parameters.len()).flat_map(|j| (0..j).map(move |i| [i, j]));
    let one = |[i, j]: [usize; 2]| {
        let value = told::correlation(estimate, [i, j])?;
        Some(Correlation { pair: [parameters[i].parameter, parameters[j].parameter], value })
    };
    pairs.filter_map(one).collect()
}

/// Part of a standard error of a prediction that an open direction may change it by, over all that the bounds allow.
const SMALL_PART: f64 = 0.1;

/// Predictions of all measured quantities for each row of inputs.
fn ahead<K: Kind>(
    case: &OpenCase<'_, K::Case>,
    unknowns: &(Vec<Parameter>, Vec<usize>),
    read: &Read<K::Known>,
    inputs: Vec<Input>,
    estimate: &Estimate,
) -> Result<Vec<Prediction>, FitError> {
    let rows = inputs.first().map_or(0, |input| input.values.len());
    for input in &read.inputs {
        if !inputs.iter().any(|own| own.place == input.place) {
            let reason = "the data have it, and predictions need it as well";
            return Err(FitError::column(input.field, reason));
        }
    }
    let all = (0..rows).flat_map(|row| (0..read.quantities.len()).map(move |q| (row, q)));
    let measured: Vec<Measurement> =
        all.map(|(row, quantity)| Measurement { row, quantity, value: 0.0, error: None }).collect();
    let quantities = read.quantities.clone();
    let own = Read { inputs, quantities, measured: Vec::new(), unused: Vec::new() };
    let model = K::model(case, unknowns.clone(), &own, &measured)?;
    let mut values = vec![0.0; measured.len()];
    model.predict(&estimate.values, &mut values)?;
    let mut by = DMatrix::zeros(measured.len(), unknowns.0.len());
    model.derivatives(&estimate.values, &mut by)?;
    for (j, parameter) in unknowns.0.iter().enumerate() {
        by.column_mut(j).scale_mut(parameter.slope(estimate.found.places()[j]));
    }
    let width = width(estimate);
    let one = |(i, one): (usize, &Measurement)| {
        let row: DVector<f64> = by.row(i).transpose();
        let spread = row.dot(&(&estimate.covariance * &row)).max(0.0).sqrt();
        // What is not determined must not matter here.
        let is_known = estimate.open.iter().all(|open| row.dot(open).abs() <= SMALL_PART * spread);
        let ends = width
            .filter(|_| is_known)
            .map(|width| [values[i] - width * spread, values[i] + width * spread]);
        let of = &read.quantities[one.quantity].0;
        let (quantity, unit) = (of.name.clone(), of.unit);
        Prediction { row: one.row + 1, quantity, unit, value: values[i], interval: ends }
    };
    Ok(measured.iter().enumerate().map(one).collect())
}

/// The fit along the one input that varies.
fn curve<O>(
    read: &Read<O>,
    count: usize,
    ahead: impl Fn(Vec<Input>) -> Result<Vec<Prediction>, FitError>,
) -> Result<Option<Curve>, FitError> {
    let ends = |values: &[f64]| {
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        [least, values.iter().copied().fold(f64::NEG_INFINITY, f64::max)]
    };
    let varies = |input: &&Input| ends(&input.values)[0] < ends(&input.values)[1];
    let varied: Vec<&Input> = read.inputs.iter().filter(varies).collect();
    let ([input], true) = (varied.as_slice(), count > 1) else { return Ok(None) };
    let [least, most] = ends(&input.values);
    let along = carom_special::linspace(least, most, count);
    let renewed = read.inputs.iter().map(|own| Input {
        values: if own.place == input.place { along.clone() } else { vec![own.values[0]; count] },
        ..own.clone()
    });
    let all = ahead(renewed.collect())?;
    let line = |(quantity, _): &(crate::Quantity, O)| {
        let own = all.iter().filter(|one| one.quantity == quantity.name).cloned();
        (quantity.name.clone(), quantity.unit, own.collect())
    };
    let lines = read.quantities.iter().map(line).collect();
    let name = (input.field.to_owned(), input.unit);
    Ok(Some(Curve { input: name, given: input.values.clone(), along, lines }))
}
