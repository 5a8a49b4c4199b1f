//! The kinds of cases.

use super::error::{CaseError, CaseFault};
use super::field::{Field, Need, Schema};
use super::reader::Case;
use super::section::{parse, survey};
use super::{
    HertzCase, HistoryCase, ImpactFile, RollCase, SceneCase, ShellCase, SolveCase, StressCase,
};
use carom_special::{WordError, nearest};
use std::ops::Deref;
use std::str::FromStr;

/// Makes the kinds from their readers.
macro_rules! kinds {
    ($($(#[$meaning:meta])* $kind:ident: $case:ident,)*) => {
        /// A kind of case, named like the command that takes it, with its [`Schema`].
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum CaseKind {
            $($(#[$meaning])* $kind,)*
        }

        impl CaseKind {
            const NAMES: &'static [&'static str] = &[$($case::SCHEMA.name),*];

            /// All kinds.
            pub const ALL: [Self; Self::NAMES.len()] = [$(Self::$kind),*];

            /// Checks that the file is a valid case of this kind, with all values in their ranges.
            ///
            /// # Errors
            /// As the reader of the kind; if it looks like a case of another kind, that alone.
            pub fn check(self, source: &str) -> Result<(), CaseError> {
                match self {
                    $(Self::$kind => $case::parse(source).map(|_| ()),)*
                }
                .map_err(|error| meant(&self, source, error))
            }
        }

        impl Deref for CaseKind {
            type Target = Schema;

            fn deref(&self) -> &Schema {
                match self {
                    $(Self::$kind => &$case::SCHEMA,)*
                }
            }
        }
    };
}

kinds! {
    /// An impact of two bodies, a sweep of impacts, or a distribution of impacts.
    Impact: ImpactFile,
    /// A contact under normal load.
    Hertz: HertzCase,
    /// A contact under a history of shifts.
    History: HistoryCase,
    /// A ball that bounces between walls.
    Scene: SceneCase,
    /// A contact on a grid.
    Solve: SolveCase,
    /// A rolling contact.
    Roll: RollCase,
    /// The stresses below a contact.
    Stress: StressCase,
    /// A bellows, or a flange on a tube.
    Shell: ShellCase,
}

impl FromStr for CaseKind {
    type Err = WordError;

    /// # Errors
    /// [`WordError`] with the names of all kinds.
    fn from_str(word: &str) -> Result<Self, WordError> {
        let kind = Self::ALL.into_iter().find(|kind| kind.name == word);
        kind.ok_or_else(|| WordError::new("kind", word, Self::NAMES))
    }
}

impl CaseKind {
    /// The kind of a file, guessed from its tables; misspelt names count as well.
    ///
    /// # Errors
    /// If the text is not TOML.
    pub fn of(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let names: Vec<&str> =
            table.get_ref().iter().map(|(name, _)| name.get_ref().as_ref()).collect();
        let fit = |kind: Self| -> i32 {
            let is_there = |field: &&Field| names.contains(&field.name);
            let (there, lacking): (Vec<&Field>, Vec<&Field>) =
                kind.fields.iter().partition(is_there);
            let valid: Vec<&str> = lacking.iter().map(|field| field.name).collect();
            let unknown =
                names.iter().filter(|name| there.iter().all(|field| field.name != **name));
            let like: Vec<_> = unknown.map(|name| nearest(name, &valid)).collect();
            let missed = lacking.iter().filter(|field| {
                matches!(field.need, Need::Must) && !like.contains(&Some(field.name))
            });
            let of_unknown = |like: &Option<_>| if like.is_some() { 1 } else { -1 };
            // Of tables that replace one another one must be there.
            let is_one_of = |field: &&Field| matches!(field.need, Need::Or(_));
            let is_none_there = kind.fields.iter().any(|field| is_one_of(&field))
                && !there.iter().any(is_one_of)
                && !lacking
                    .iter()
                    .any(|field| is_one_of(field) && like.contains(&Some(field.name)));
            2 * (there.len() as i32 - missed.count() as i32 - i32::from(is_none_there))
                + like.iter().map(of_unknown).sum::<i32>()
        };
        // The first of those that fit best.
        let best = Self::ALL.into_iter().rev().max_by_key(|kind| fit(*kind));
        Ok(best.unwrap_or(Self::Impact))
    }
}

/// The error of a text that was read as a case of this kind; if it looks like one of another kind, that alone.
pub(crate) fn meant(schema: &Schema, source: &str, error: CaseError) -> CaseError {
    let count = match &error.fault {
        CaseFault::Syntax { .. } => return error,
        CaseFault::Several(errors) => errors.len(),
        _ => 1,
    };
    match other_kind(schema.name, source, count) {
        Some(likely) => CaseFault::OtherKind { kind: schema.name, likely }.at("", 0),
        None => error,
    }
}

/// The name of the kind of case of which this text has at most half as many errors.
fn other_kind(kind: &str, source: &str, count: usize) -> Option<&'static str> {
    let likely = CaseKind::of(source).ok()?;
    let is_known = |name: &str| likely.fields.iter().any(|field| field.name == name);
    let table = parse(source).ok()?;
    // An empty text is like no kind.
    if !table.get_ref().iter().any(|(name, _)| is_known(name.get_ref().as_ref())) {
        return None;
    }
    let is_likelier = likely.name != kind && 2 * survey::survey(&likely, source).len() <= count;
    is_likelier.then_some(likely.name)
}
