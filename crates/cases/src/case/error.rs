//! Errors in case files. Each message names the field and what is allowed.

use carom_impact::{CollisionError, NormalSpinError};
use carom_laws::curvature::CurvatureError;

/// An error in a case file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CaseError {
    /// The text is not TOML.
    #[error("line {line}: {message}")]
    Syntax {
        /// Line, from 1.
        line: usize,
        /// Message of the parser.
        message: String,
    },
    /// An unknown field.
    #[error("line {line}: unknown field `{field}`{}; {table} takes {valid}", nearest.as_ref().map_or_else(String::new, |name| format!(", did you mean `{name}`?")))]
    Unknown {
        /// The name with its path.
        field: String,
        /// Line, from 1.
        line: usize,
        /// The table that contains it.
        table: String,
        /// The most similar valid name, if one is similar.
        nearest: Option<&'static str>,
        /// All valid names.
        valid: String,
    },
    /// A necessary field is missing.
    #[error("`{field}` is missing: must be {allowed}")]
    Missing {
        /// The field with its path.
        field: String,
        /// What it must be.
        allowed: String,
    },
    /// A value of the wrong kind.
    #[error("line {line}: `{field}` = {found} is out of range: must be {allowed}")]
    Kind {
        /// The field with its path.
        field: String,
        /// Line, from 1.
        line: usize,
        /// The value as written.
        found: String,
        /// What it must be.
        allowed: String,
    },
    /// A number out of its range.
    #[error("line {line}: `{field}` = {} is out of range: must be {allowed}", carom_special::Readable(*value))]
    Range {
        /// The field with its path.
        field: String,
        /// Line, from 1.
        line: usize,
        /// The value.
        value: f64,
        /// What it must be.
        allowed: String,
    },
    /// Two fields that exclude each other.
    #[error("line {line}: `{field}` excludes `{other}`: {reason}")]
    Conflict {
        /// The field with its path.
        field: String,
        /// Line, from 1.
        line: usize,
        /// The field it excludes.
        other: String,
        /// Why.
        reason: &'static str,
    },
    /// The surfaces have no elliptical contact.
    #[error("`body_1.radii`, `body_2.radii`: {0}")]
    Curvature(CurvatureError),
    /// The bodies have no contact that can be computed.
    #[error("line {line}: `{field}`: {source}{hint}")]
    Collision {
        /// The field that causes it, with its path.
        field: String,
        /// Line, from 1.
        line: usize,
        /// Why.
        source: Box<CollisionError>,
        /// A hint for the user, or an empty text.
        hint: &'static str,
    },
    /// A torsional impact was requested but cannot be computed.
    #[error("line {line}: `contact.torsion`: {source}")]
    Torsion {
        /// Line, from 1.
        line: usize,
        /// Why.
        source: Box<NormalSpinError>,
    },
}
