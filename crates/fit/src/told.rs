//! What data tell and leave open, in sentences.

use crate::estimate::{Estimate, takes_part};
use crate::fitted::{Determined, Knowledge, Quality};
use crate::model::Parameter;
use carom_table::short;
use nalgebra::DVector;

/// Correlations that are told.
const STRONG: f64 = 0.95;
/// chi^2 per degree beyond which theory or errors are doubted.
const DOUBTFUL: [f64; 2] = [0.25, 3.0];
/// Residuals, and distances from the mean of a prior, that are told.
const FAR: f64 = 4.0;

/// The last name of a field.
pub(crate) fn name(field: &str) -> &str {
    field.rsplit('.').next().unwrap_or(field)
}

/// Sentences on what is determined.
pub(crate) fn statements(
    parameters: &[Parameter],
    determined: &[Determined],
    estimate: &Estimate,
) -> Vec<String> {
    let mut told: Vec<String> = Vec::new();
    for direction in &estimate.open {
        told.push(open(parameters, direction, estimate));
    }
    for (j, one) in determined.iter().enumerate() {
        let of = name(one.parameter);
        match one.knowledge {
            Knowledge::Prior if estimate.is_determined_by_data(j) => told.push(format!(
                "The prior of {of} tells more than these data: its interval is for the greater part that of its prior."
            )),
            Knowledge::Prior => told.push(format!(
                "These data do not determine {of}: its interval is that of its prior."
            )),
            Knowledge::AtBound => told.push(format!(
                "The best {of} is its bound, {}: better values may lie beyond it, and it has no interval about the best value.",
                short(one.value)
            )),
            Knowledge::Data if !estimate.is_determined_by_data(j) => {
                let others = priors_beside(parameters, estimate, j);
                told.push(format!("These data determine {of} only with the prior of {others}."));
            }
            Knowledge::Data | Knowledge::Nothing => {}
        }
        if let Some(ends) = one.profile {
            let unknown = parameters.iter().find(|own| own.field == one.parameter);
            let Some(unknown) = unknown.map(|own| own.unknown) else { continue };
            let at = [ends[0] <= unknown.low, ends[1] >= unknown.high];
            if at.contains(&true) && one.knowledge == Knowledge::Data {
                let side = if at[0] { "lower" } else { "upper" };
                told.push(format!(
                    "The interval of {of} reaches its {side} bound: the data bound it on the other side only."
                ));
            }
        }
    }
    if estimate.freedom == 0 {
        told.push(
            "There are no degrees of freedom: as many values are measured as numbers determined, so that nothing tells how far \
             the numbers may be off."
                .to_owned(),
        );
    }
    told
}

/// The unknowns with a prior that the data determine only together with this one.
fn priors_beside(parameters: &[Parameter], estimate: &Estimate, unknown: usize) -> String {
    let open = || estimate.open_to_data.iter().filter(|open| takes_part(open, unknown));
    let has_prior = |j: &usize| parameters[*j].unknown.prior.is_some();
    let all: Vec<usize> = (0..parameters.len()).filter(has_prior).collect();
    let is_beside = |j: &usize| open().any(|open| takes_part(open, *j));
    let beside: Vec<usize> = all.iter().copied().filter(is_beside).collect();
    // A strong prior may close a direction in which it hardly takes part.
    let named = if beside.is_empty() { all } else { beside };
    named.iter().map(|j| name(parameters[*j].field)).collect::<Vec<_>>().join(" and ")
}

/// What is wrong with quantities whose measured values do not scatter.
pub(crate) fn without_scatter(names: &[&str]) -> Option<String> {
    (!names.is_empty()).then(|| {
        format!(
            "The values of {} do not scatter about the fit, as measured ones do: no error of theirs can be estimated, and nothing \
             has an interval. Give their standard error.",
            names.join(" and ")
        )
    })
}

/// A direction that nothing determines.
fn open(parameters: &[Parameter], direction: &DVector<f64>, estimate: &Estimate) -> String {
    let largest = direction.amax();
    let named: Vec<usize> = (0..parameters.len()).filter(|j| takes_part(direction, *j)).collect();
    let names: Vec<&str> = named.iter().map(|j| name(parameters[*j].field)).collect();
    let [first, others @ ..] = names.as_slice() else { return String::new() };
    if others.is_empty() {
        let unknown = parameters[named[0]].unknown;
        return format!(
            "These data do not determine {first}: any value from {} to {} meets them about as well.",
            short(unknown.low),
            short(unknown.high)
        );
    }
    let all = format!("{first} and {}", others.join(" and "));
    let step = |j: usize| {
        let slope = parameters[j].slope(estimate.found.places()[j]);
        0.1 * direction[j] / largest * slope * direction[named[0]].signum()
    };
    let steps =
        named.iter().map(|j| format!("{} by {}", name(parameters[*j].field), short(step(*j))));
    format!(
        "These data determine {all} only together: a change of {} leaves all fitted values about as they are.",
        steps.collect::<Vec<_>>().join(" and ")
    )
}

/// What should be looked at.
pub(crate) fn warnings(
    determined: &[Determined],
    estimate: &Estimate,
    quality: &Quality,
    residuals: &[f64],
) -> Vec<String> {
    let mut told = Vec::new();
    if let Some(per_degree) = quality.chi_squared_per_degree() {
        if per_degree > DOUBTFUL[1] {
            told.push(format!(
                "chi^2 is {} per degree of freedom: the theory does not meet the data within their errors, or these are larger; \
                 the intervals are too narrow",
                short(per_degree)
            ));
        } else if per_degree < DOUBTFUL[0] {
            told.push(format!(
                "chi^2 is {} per degree of freedom: the errors of the data are smaller than given",
                short(per_degree)
            ));
        }
    }
    let far = residuals.iter().filter(|residual| residual.abs() > FAR).count();
    if far > 0 {
        told.push(format!(
            "{far} of {} measured values are more than {FAR} standard errors from the fit",
            residuals.len()
        ));
    }
    for j in 0..determined.len() {
        for i in 0..j {
            let correlation = correlation(estimate, [i, j]);
            // What a prior adds is told in a sentence.
            let of_data = [i, j].iter().all(|k| determined[*k].knowledge != Knowledge::Prior);
            if of_data && correlation.is_some_and(|value| value.abs() > STRONG) {
                told.push(format!(
                    "{} and {} have correlation {}: the data hold little on each alone",
                    name(determined[i].parameter),
                    name(determined[j].parameter),
                    short(correlation.unwrap_or_default())
                ));
            }
        }
    }
    told
}

/// Unknowns whose data and prior contradict each other.
pub(crate) fn contradictions(
    parameters: &[Parameter],
    determined: &[Determined],
) -> impl Iterator<Item = String> {
    parameters.iter().zip(determined).filter_map(|(parameter, one)| {
        let [mean, sd] = parameter.unknown.prior?;
        let far = (one.value - mean).abs() / sd;
        let of = name(parameter.field);
        (far > FAR).then(|| {
            format!("{of} is {} standard deviations of its prior from the mean of it: the data contradict the prior", short(far))
        })
    })
}

/// The correlation of two unknowns; none unless both are determined.
pub(crate) fn correlation(estimate: &Estimate, [i, j]: [usize; 2]) -> Option<f64> {
    let of = &estimate.covariance;
    let both = estimate.is_determined(i) && estimate.is_determined(j);
    both.then(|| of[(i, j)] / (of[(i, i)] * of[(j, j)]).sqrt()).filter(|value| value.is_finite())
}
