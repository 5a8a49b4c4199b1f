//! The kinds of cases that can be fitted.

use crate::FitError;
use crate::columns::{Known, Read};
use crate::estimate::Estimate;
use crate::hertz::{Contacts, Pressing};
use crate::history::Histories;
use crate::impact::Impacts;
use crate::measured::Measurement;
use crate::model::{Model, Parameter};
use crate::observable::{Observable, Part};
use carom_cases::case::{HertzCase, HistoryCase, ImpactCase, OpenCase, Renewed};
use carom_cases::history::Step;

/// A kind of case that can be fitted.
pub(crate) trait Kind {
    type Case: Renewed;
    type Known: Known + Copy;
    type Model<'a>: Model;
    /// Whether predictions along an input stand for themselves.
    const HAS_CURVE: bool = true;

    fn model<'a>(
        case: &'a OpenCase<'a, Self::Case>,
        unknowns: (Vec<Parameter>, Vec<usize>),
        read: &Read<Self::Known>,
        measured: &[Measurement],
    ) -> Result<Self::Model<'a>, FitError>;

    /// Sentences of this kind.
    fn told(_: &Self::Model<'_>, _: &Estimate) -> Vec<String> {
        Vec::new()
    }
}

pub(crate) struct OfImpacts;
pub(crate) struct OfContacts;
pub(crate) struct OfHistories;

impl Kind for OfImpacts {
    type Case = ImpactCase;
    type Known = Observable;
    type Model<'a> = Impacts<'a>;

    fn model<'a>(
        case: &'a OpenCase<'a, ImpactCase>,
        unknowns: (Vec<Parameter>, Vec<usize>),
        read: &Read<Observable>,
        measured: &[Measurement],
    ) -> Result<Impacts<'a>, FitError> {
        Impacts::new(case, unknowns, read, measured)
    }

    fn told(model: &Impacts<'_>, estimate: &Estimate) -> Vec<String> {
        match model.sliding(&estimate.values) {
            Some([count, all]) if count == all && !estimate.open.is_empty() => {
                let words = "All impacts of the data slide throughout: they depend on friction and on no stiffness.";
                vec![words.to_owned()]
            }
            _ => Vec::new(),
        }
    }
}

impl Kind for OfContacts {
    type Case = HertzCase;
    type Known = Pressing;
    type Model<'a> = Contacts<'a>;

    fn model<'a>(
        case: &'a OpenCase<'a, HertzCase>,
        unknowns: (Vec<Parameter>, Vec<usize>),
        read: &Read<Pressing>,
        measured: &[Measurement],
    ) -> Result<Contacts<'a>, FitError> {
        Contacts::new(case, unknowns, read, measured)
    }
}

impl Kind for OfHistories {
    type Case = HistoryCase;
    type Known = Part<Step>;
    type Model<'a> = Histories<'a>;
    const HAS_CURVE: bool = false;

    fn model<'a>(
        case: &'a OpenCase<'a, HistoryCase>,
        unknowns: (Vec<Parameter>, Vec<usize>),
        read: &Read<Part<Step>>,
        measured: &[Measurement],
    ) -> Result<Histories<'a>, FitError> {
        Histories::new(case, unknowns, read, measured)
    }
}
