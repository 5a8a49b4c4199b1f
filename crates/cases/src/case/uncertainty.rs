//! The table `[uncertainty]` of a case with distributions.

use super::contact::FRICTION;
use super::error::CaseError;
use super::field::{Default, Field, Form};
use super::range::Range;
use super::section::Section;
use super::touch::CONTACT;
use super::varied::Input;
use carom_impact::uncertain::Sampling;

const SAMPLES: Field =
    Field::number("samples", Range::Count.pure(), "how many impacts are computed").such_as("10000");
const SEED: Field = Field::number(
    "seed",
    Range::Seed.pure(),
    "seed of the random numbers: the same seed gives the same results",
)
.such_as("1");
const BINS: Field = Field::number("bins", Range::Whole.pure(), "bins of the histograms")
    .default(Default::Number(40.0));
const QUANTILES: Field =
    Field::new("quantiles", Form::List(Range::Part.pure()), "quantiles that are printed")
        .default(Default::List(&[0.05, 0.25, 0.5, 0.75, 0.95]));
/// The field `uncertainty` of a case.
pub(super) const UNCERTAINTY: Field = Field::new(
    "uncertainty",
    Form::Table(&[SAMPLES, SEED, BINS, QUANTILES]),
    "how distributions are sampled, and which statistics are printed",
)
.may("no number is a distribution");

/// How distributions are sampled, and which statistics are computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Uncertainty {
    /// Number of samples and seed.
    pub sampling: Sampling,
    /// Bins of the histograms.
    pub bins: usize,
    /// Quantiles to compute, in [0, 1].
    pub quantiles: Vec<f64>,
}

impl Uncertainty {
    /// Reads the table; none if no field is uncertain.
    pub(super) fn read(case: &Section<'_>, inputs: &[Input]) -> Result<Option<Self>, CaseError> {
        let is_uncertain = inputs.iter().any(|input| input.distribution().is_some());
        match (is_uncertain, case.has(&UNCERTAINTY)) {
            (false, false) => return Ok(None),
            (false, true) => {
                let reason = "no field is uncertain; give one as a distribution";
                return Err(case.conflict(&UNCERTAINTY, [&CONTACT, &FRICTION], reason));
            }
            (true, false) => {
                let uncertain = inputs.iter().find(|input| input.distribution().is_some());
                let name = uncertain.map_or("", |input| input.field);
                let table = "a table, headed [uncertainty], with `samples` and `seed`";
                let why = format!("{table}, since `{name}` is a distribution");
                return Err(case.missing_as(&UNCERTAINTY, why));
            }
            (true, true) => {}
        }
        let settings = case.section(&UNCERTAINTY)?;
        let (samples, seed) = (settings.count(&SAMPLES)?, settings.number(&SEED)? as u64);
        let sampling = Sampling::new(samples, seed)
            .map_err(|error| settings.out_of_range(&SAMPLES, error.value, error.allowed))?;
        let (bins, quantiles) = (settings.count(&BINS)?, settings.list(&QUANTILES)?);
        if let Some(sweep) = inputs.iter().find(|input| input.sweep().is_some()) {
            let reason = "a sweep cannot be combined with distributions";
            return Err(case.excluded(&UNCERTAINTY, sweep.field.to_owned(), reason));
        }
        Ok(Some(Self { sampling, bins, quantiles }))
    }
}
