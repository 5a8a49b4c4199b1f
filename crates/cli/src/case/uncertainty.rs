//! `[uncertainty]` of a case whose numbers are distributions.

use super::error::CaseError;
use super::range::Range;
use super::section::Section;
use super::varied::Input;
use carom_impact::uncertain::Sampling;

const SETTINGS: &[&str] = &["samples", "seed", "bins", "quantiles"];
/// The largest whole number that a floating-point number holds with all before it.
const MOST_SEED: f64 = 9_007_199_254_740_992.0;

/// How uncertain inputs are sampled and summed up.
#[derive(Debug, Clone, PartialEq)]
pub struct Uncertainty {
    /// How many samples, from which seed.
    pub sampling: Sampling,
    /// Bins of the histograms.
    pub bins: usize,
    /// Quantiles to give, in [0, 1].
    pub quantiles: Vec<f64>,
}

impl Uncertainty {
    /// None if no field is uncertain.
    pub(super) fn read(case: &Section<'_>, inputs: &[Input]) -> Result<Option<Self>, CaseError> {
        let is_uncertain = inputs.iter().any(|input| input.distribution().is_some());
        match (is_uncertain, case.has("uncertainty")) {
            (false, false) => return Ok(None),
            (false, true) => {
                let field = "contact.friction";
                let reason = "no field is uncertain; give one as a distribution";
                return Err(case.conflict("uncertainty", field, reason));
            }
            (true, _) => {}
        }
        let (sampling, bins, quantiles) = read_settings(&case.section("uncertainty", SETTINGS)?)?;
        if let Some(sweep) = inputs.iter().find(|input| input.sweep().is_some()) {
            let reason = "a sweep has no single impact to vary";
            return Err(case.conflict("uncertainty", sweep.field, reason));
        }
        Ok(Some(Self { sampling, bins, quantiles }))
    }
}

fn read_settings(settings: &Section<'_>) -> Result<(Sampling, usize, Vec<f64>), CaseError> {
    let samples = settings.number("samples", Range::Count)?;
    let seed = settings.number("seed", Range::NonNegative)?;
    if seed.fract() != 0.0 || seed > MOST_SEED {
        return Err(settings.out_of_range("seed", seed, "a whole number from 0 to 2^53"));
    }
    let sampling = Sampling::new(samples as usize, seed as u64)
        .map_err(|error| settings.out_of_range("samples", error.value, error.allowed))?;
    let bins = match settings.has("bins") {
        true => settings.number("bins", Range::Whole)? as usize,
        false => 40,
    };
    if !settings.has("quantiles") {
        return Ok((sampling, bins, vec![0.05, 0.25, 0.5, 0.75, 0.95]));
    }
    let quantiles = settings.list("quantiles", Range::NonNegative)?;
    match quantiles.iter().find(|part| **part > 1.0) {
        Some(part) => Err(settings.out_of_range("quantiles", *part, "in [0, 1]")),
        None => Ok((sampling, bins, quantiles)),
    }
}
