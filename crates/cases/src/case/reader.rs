//! What every kind of case has: its schema and its reader.

use super::error::CaseError;
use super::field::Schema;
use super::section::survey;

/// A kind of case, read from the text of its file.
pub trait Case<'a>: Sized {
    /// Its name and its fields.
    const SCHEMA: Schema;

    /// Reads a case up to its first error.
    ///
    /// # Errors
    /// As [`Case::parse`], but the first one only.
    fn read(source: &'a str) -> Result<Self, CaseError>;

    /// Reads a case from the text of its file.
    ///
    /// # Errors
    /// All errors: if the text is not TOML, a field is missing, unknown, out of range or in conflict with
    /// another, or what the fields describe cannot be computed.
    fn parse(source: &'a str) -> Result<Self, CaseError> {
        Self::read(source).map_err(|first| survey::all(&Self::SCHEMA, source, first))
    }
}
