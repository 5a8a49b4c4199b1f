//! What all impacts say in `[contact]`: friction, law, torsion.

use super::error::CaseError;
use super::range::Range;
use super::section::{Section, Words};
use carom_impact::coupled::VectorLaw;

/// The fields of `[contact]` that every impact may have.
pub(super) const FIELDS: [&str; 3] = ["friction", "law", "torsion"];
pub(super) const LAWS: Words = Words {
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
    /// The line of `torsion = true`; none if the spin about the normal is left alone.
    pub torsion: Option<usize>,
}

impl Contact {
    /// Reads the fields.
    pub(super) fn read(contact: &Section<'_>) -> Result<Self, CaseError> {
        let friction = contact.number("friction", Range::NonNegativeOrInfinite)?;
        let law = match contact.has("law") {
            true => match contact.word("law", LAWS)? {
                "fixed-direction" => VectorLaw::FixedDirection,
                _ => VectorLaw::Coulomb,
            },
            false => VectorLaw::default(),
        };
        let torsion = contact.switch("torsion")?.then(|| contact.line("torsion"));
        Ok(Self { friction, law, torsion })
    }
}
