//! What can be wrong with a case file. Each message names the field and what is allowed.

use carom_impact::{CollisionError, NormalSpinError};
use carom_laws::curvature::CurvatureError;

/// What is wrong with a case file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CaseError {
    /// It is not TOML.
    #[error("line {line}: {message}")]
    Syntax {
        /// Line, from 1.
        line: usize,
        /// What the parser says.
        message: String,
    },
    /// A name that means nothing there.
    #[error("line {line}: unknown field `{field}`{}; {table} takes {valid}", nearest.as_ref().map_or_else(String::new, |name| format!(", did you mean `{name}`?")))]
    Unknown {
        /// The name with its path.
        field: String,
        /// Line, from 1.
        line: usize,
        /// The table it stands in.
        table: String,
        /// The valid name most like it, if one is.
        nearest: Option<&'static str>,
        /// All valid names.
        valid: String,
    },
    /// A field that must be there is not.
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
    #[error("line {line}: `{field}` cannot stand beside `{other}`: {reason}")]
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
    /// The surfaces make no elliptical contact.
    #[error("`body_1.radii`, `body_2.radii`: {0}")]
    Curvature(CurvatureError),
    /// The bodies make no contact that can be computed.
    #[error("line {line}: `{field}`: {source}{hint}")]
    Collision {
        /// The field to blame with its path.
        field: String,
        /// Line, from 1.
        line: usize,
        /// Why.
        source: Box<CollisionError>,
        /// What may help, or nothing.
        hint: &'static str,
    },
    /// The torsional impact that was asked for cannot be given.
    #[error("line {line}: `contact.torsion`: {source}")]
    Torsion {
        /// Line, from 1.
        line: usize,
        /// Why.
        source: Box<NormalSpinError>,
    },
}
