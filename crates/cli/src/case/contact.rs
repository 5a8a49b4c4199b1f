//! What all impacts say in `[contact]`: friction, law, torsion.

use super::error::CaseError;
use super::range::Range;
use super::section::{Section, Words};
use carom_impact::coupled::VectorLaw;

/// The fields of `[contact]` that every impact may have.
pub(super) const FIELDS: [&str; 3] = ["friction", "law", "torsion"];
const LAWS: Words = Words {
    words: &["coulomb", "fixed-direction", "numerical"],
    allowed: "\"coulomb\", \"fixed-direction\" or \"numerical\" (the laws that exist)",
};

/// The laws of a history of shifts, where these turn.
pub(super) const LAWS_OF_SHIFTS: Words = Words {
    words: &["coulomb", "fixed-direction"],
    allowed: "\"coulomb\" or \"fixed-direction\" (the laws that exist)",
};

/// Friction, law and torsion of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Coefficient of friction; infinite for no slip.
    pub friction: f64,
    /// The law where the direction of the tangential motion turns.
    pub law: VectorLaw,
    /// Whether the contact is solved on a grid instead.
    pub is_numerical: bool,
    /// The line of `torsion = true`; none if the spin about the normal is left alone.
    pub torsion: Option<usize>,
}

impl Contact {
    /// Reads the fields.
    pub(super) fn read(contact: &Section<'_>) -> Result<Self, CaseError> {
        let friction = contact.number("friction", Range::NonNegativeOrInfinite)?;
        let word = match contact.has("law") {
            true => contact.word("law", LAWS)?,
            false => "coulomb",
        };
        let law = match word {
            "fixed-direction" => VectorLaw::FixedDirection,
            _ => VectorLaw::Coulomb,
        };
        let is_numerical = word == "numerical";
        let torsion = contact.switch("torsion")?.then(|| contact.line("torsion"));
        if is_numerical && torsion.is_some() {
            let reason = "the numerical law leaves the spin about the normal alone";
            return Err(contact.conflict("torsion", "law", reason));
        }
        if is_numerical && friction.is_infinite() {
            let allowed = "finite with law = \"numerical\"";
            return Err(contact.out_of_range("friction", friction, allowed));
        }
        Ok(Self { friction, law, is_numerical, torsion })
    }
}
