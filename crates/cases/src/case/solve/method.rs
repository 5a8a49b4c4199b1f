//! The method of solution: `contact.method`.

use crate::case::error::CaseError;
use crate::case::field::{Default, Field, Form};
use crate::case::section::Section;

const NEWTON: &str = "newton";
const GAUSS_SEIDEL: &str = "gauss_seidel";
const DISCS: &str = "discs";
const JOHNSON: &str = "johnson";
const PANAGIOTOPOULOS: &str = "panagiotopoulos";
const KOMBI: &str = "kombi";

/// The field of a case.
pub(super) const METHOD: Field = Field::new(
    "method",
    Form::Word(&[
        (NEWTON, "of today: Newton's on sets of sticking and slipping cells"),
        (GAUSS_SEIDEL, "the program of 1992, chapter 12"),
        (DISCS, "Gauss and Seidel's, the friction of one cell after the other solved exactly"),
        (JOHNSON, "Kalker's NORM, then TANG; bodies of similar material"),
        (PANAGIOTOPOULOS, "NORM and TANG in turn"),
        (KOMBI, "both at once"),
    ]),
    "how each step is solved; all but the first take shifts only",
)
.default(Default::Word(NEWTON));

/// A method of solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SolveMethod {
    /// Newton's on active sets.
    Newton,
    /// The program of chapter 12.
    GaussSeidel,
    /// Gauss and Seidel's with exact friction in each cell.
    Discs,
    /// Johnson's process.
    Johnson,
    /// Panagiotopoulos's process.
    Panagiotopoulos,
    /// KOMBI.
    Kombi,
}

pub(super) fn read(contact: &Section<'_>) -> Result<SolveMethod, CaseError> {
    Ok(match contact.word(&METHOD)? {
        GAUSS_SEIDEL => SolveMethod::GaussSeidel,
        DISCS => SolveMethod::Discs,
        JOHNSON => SolveMethod::Johnson,
        PANAGIOTOPOULOS => SolveMethod::Panagiotopoulos,
        KOMBI => SolveMethod::Kombi,
        _ => SolveMethod::Newton,
    })
}
