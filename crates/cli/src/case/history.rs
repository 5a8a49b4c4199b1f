//! The case file of `carom history`.

use super::contact::LAWS_OF_SHIFTS;
use super::error::CaseError;
use super::pair;
use super::range::Range;
use super::section::{Section, parse};
use super::unit::Dimension;
use carom_laws::coulomb::Tolerance;
use carom_laws::hertz::Hertz;
use carom_laws::law::Shift;
use std::path::PathBuf;

const FIELDS: &[&str] = &["body_1", "body_2", "contact", "history"];
const FILE: &str =
    "the name of a CSV file with the columns zeta, xi, eta and perhaps omega (or give `steps`)";
const ROWS: &str = "a list of rows [zeta, xi, eta] or [zeta, xi, eta, omega]";

/// A contact and the shifts it goes through.
#[derive(Debug, Clone, PartialEq)]
pub struct HistoryCase {
    /// The contact.
    pub hertz: Hertz,
    /// Coefficient of friction; infinite for no slip.
    pub friction: f64,
    /// What is done where the direction of the shift turns.
    pub law: TurningLaw,
    /// The shifts.
    pub steps: Steps,
}

/// The law of a shift whose direction turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TurningLaw {
    /// Each ring slips by itself, to a tolerance.
    Coulomb(Tolerance),
    /// Chapter 7's, one direction of traction in a slip ring.
    FixedDirection,
}

/// Where the shifts are given.
#[derive(Debug, Clone, PartialEq)]
pub enum Steps {
    /// In the case file.
    Inline(Vec<Shift>),
    /// In a CSV file, relative to the case file.
    File(PathBuf),
}

impl HistoryCase {
    /// Reads a case from the text of its file.
    ///
    /// # Errors
    /// If the text is not TOML, or a field is missing, unknown, out of range or in conflict
    /// with another.
    pub fn parse(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let contact = case.section("contact", &["angle", "friction", "law", "tolerance"])?;
        let law = turning_law(&contact)?;
        let hertz = pair::read(&case, &contact)?;
        let friction = contact.number("friction", Range::NonNegativeOrInfinite)?;
        let history = case.section("history", &["steps", "file"])?;
        let steps = if history.has("steps") {
            if history.has("file") {
                return Err(history.conflict("file", "steps", "give one of them"));
            }
            let length = Range::Finite.of(Dimension::Length);
            let angle = Range::Finite.of(Dimension::Radians);
            let rows = history.rows("steps", [length, length, length, angle], ROWS)?;
            Steps::Inline(rows.into_iter().map(shift).collect())
        } else {
            Steps::File(history.text("file", FILE)?.into())
        };
        Ok(Self { hertz, friction, law, steps })
    }
}

fn turning_law(contact: &Section<'_>) -> Result<TurningLaw, CaseError> {
    let fixed = contact.has("law") && contact.word("law", LAWS_OF_SHIFTS)? == "fixed-direction";
    if !contact.has("tolerance") {
        let coulomb = TurningLaw::Coulomb(Tolerance::default());
        return Ok(if fixed { TurningLaw::FixedDirection } else { coulomb });
    }
    if fixed {
        return Err(contact.conflict("tolerance", "law", "a fixed direction needs none"));
    }
    let number = contact.number("tolerance", Range::Finite)?;
    Tolerance::new(number)
        .map(TurningLaw::Coulomb)
        .map_err(|error| contact.out_of_range("tolerance", error.value, error.allowed))
}

/// The shift of a row zeta, xi, eta, omega.
fn shift([zeta, xi, eta, omega]: [f64; 4]) -> Shift {
    Shift { zeta, xi, eta, omega }
}
