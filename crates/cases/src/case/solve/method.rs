//! The solution method: `contact.method`.

use crate::case::error::CaseError;
use crate::case::field::{Default as Unless, Field, Form};
use crate::case::section::Section;
use carom_special::WordError;
use std::str::FromStr;

/// The field `method` of a case.
pub(super) const METHOD: Field = Field::new(
    "method",
    Form::Word(&[
        (SolveMethod::Newton.name(), "Newton's method on sets of sticking and slipping cells"),
        (SolveMethod::GaussSeidel.name(), "the program of 1992, chapter 12"),
        (
            SolveMethod::Discs.name(),
            "Gauss-Seidel, with the exact friction problem in one cell after the other",
        ),
        (SolveMethod::Johnson.name(), "Kalker's NORM, then TANG; bodies of similar material"),
        (SolveMethod::Panagiotopoulos.name(), "NORM and TANG in turn"),
        (SolveMethod::Kombi.name(), "normal and tangential problem at once"),
    ]),
    "how each step is solved; all but the first take shifts only",
)
.default(Unless::Word(SolveMethod::Newton.name()));

/// The numerical method that solves each step of a case.
///
/// ```
/// use carom_cases::case::SolveMethod;
/// assert_eq!("kombi".parse(), Ok(SolveMethod::Kombi));
/// assert_eq!(SolveMethod::default().name(), "newton");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SolveMethod {
    /// Newton's method on sets of sticking and slipping cells.
    #[default]
    Newton,
    /// The Gauss-Seidel program of chapter 12.
    GaussSeidel,
    /// Gauss-Seidel with the exact friction problem in each cell.
    Discs,
    /// Johnson's process: NORM, then TANG.
    Johnson,
    /// Panagiotopoulos's process: NORM and TANG in turn.
    Panagiotopoulos,
    /// KOMBI: normal and tangential problem at once.
    Kombi,
}

impl SolveMethod {
    /// All methods.
    pub const ALL: [Self; 6] = [
        Self::Newton,
        Self::GaussSeidel,
        Self::Discs,
        Self::Johnson,
        Self::Panagiotopoulos,
        Self::Kombi,
    ];
    const NAMES: [&'static str; 6] = {
        let (mut names, mut i) = ([""; 6], 0);
        while i < names.len() {
            names[i] = Self::ALL[i].name();
            i += 1;
        }
        names
    };

    /// Its name in case files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Newton => "newton",
            Self::GaussSeidel => "gauss_seidel",
            Self::Discs => "discs",
            Self::Johnson => "johnson",
            Self::Panagiotopoulos => "panagiotopoulos",
            Self::Kombi => "kombi",
        }
    }
}

impl FromStr for SolveMethod {
    type Err = WordError;

    /// # Errors
    /// [`WordError`], which lists the allowed words.
    fn from_str(word: &str) -> Result<Self, WordError> {
        let method = Self::ALL.into_iter().find(|method| method.name() == word);
        method.ok_or_else(|| WordError::new("method", word, &Self::NAMES))
    }
}

pub(super) fn read(contact: &Section<'_>) -> Result<SolveMethod, CaseError> {
    // The reader has rejected other words.
    Ok(contact.word(&METHOD)?.parse().unwrap_or_default())
}
