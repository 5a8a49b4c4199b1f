//! Errors in case files. Each message names the field and what is allowed.

use carom_impact::{CollisionError, NormalSpinError};
use carom_laws::curvature::CurvatureError;
use std::fmt;

/// An error in a case file, and its place.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseError {
    /// The field that is wrong, with its path; empty if there is no single one.
    pub field: String,
    /// The line of the file, from 1; 0 if there is no single one.
    pub line: usize,
    /// What is wrong.
    pub fault: CaseFault,
}

/// What is wrong in a case file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CaseFault {
    /// The text is not TOML.
    #[error("{message}")]
    Syntax {
        /// The character of the line at which the parser stopped, from 0.
        column: usize,
        /// Message of the parser, and what may be meant.
        message: String,
    },
    /// Several errors, in the order of their lines; missing fields come last.
    #[error("{} errors{}", .0.len(), .0.iter().map(|error| format!("\n{error}")).collect::<String>())]
    Several(Vec<CaseError>),
    /// The text is a case of another kind.
    #[error("this looks like a case for `carom {likely}`, not for `carom {kind}`")]
    OtherKind {
        /// The name of the kind as which it was read.
        kind: &'static str,
        /// The kind that it looks like.
        likely: &'static str,
    },
    /// An unknown field.
    #[error("{} {table} takes {valid}", nearest.as_ref().map_or_else(|| ";".to_owned(), |name| format!(", did you mean `{name}`{hint}?")))]
    Unknown {
        /// The table that contains it.
        table: String,
        /// The most similar valid name, if one is similar, or the one in a table of the table.
        nearest: Option<String>,
        /// What of the value belongs there, after a comma, or an empty text.
        hint: &'static str,
        /// All valid names.
        valid: String,
    },
    /// A necessary field is missing; the line is that of the table that lacks it, and this is what it must be.
    #[error(" is missing: must be {0}")]
    Missing(String),
    /// A value of the wrong kind.
    #[error(" = {found} is not allowed: must be {allowed}")]
    Kind {
        /// The value as written.
        found: String,
        /// What it must be.
        allowed: String,
    },
    /// A number out of its range.
    #[error(" = {} is out of range: must be {allowed}", carom_special::Readable(*value))]
    Range {
        /// The value.
        value: f64,
        /// What it must be.
        allowed: String,
    },
    /// Two fields that exclude each other.
    #[error(" excludes `{other}`: {reason}")]
    Conflict {
        /// The field that is excluded.
        other: String,
        /// Why.
        reason: &'static str,
    },
    /// The surfaces have no elliptical contact.
    #[error("{others}: {source}{}", line_contact(source))]
    Curvature {
        /// Further fields of radii, after a comma.
        others: &'static str,
        /// Why.
        source: CurvatureError,
    },
    /// The bodies have no contact that can be computed.
    #[error(": {source}{hint}")]
    Collision {
        /// Why.
        source: Box<CollisionError>,
        /// A hint for the user, or an empty text.
        hint: &'static str,
    },
    /// A torsional impact was requested but cannot be computed.
    #[error(": {0}")]
    Torsion(Box<NormalSpinError>),
}

impl CaseFault {
    /// The error of this fault at a field.
    #[must_use]
    pub fn at(self, field: impl Into<String>, line: usize) -> CaseError {
        CaseError { field: field.into(), line, fault: self }
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { field, line, fault } = self;
        if *line > 0 {
            write!(f, "line {line}: ")?;
        }
        match fault {
            CaseFault::Syntax { .. } | CaseFault::Several(_) | CaseFault::OtherKind { .. } => {
                write!(f, "{fault}")
            }
            CaseFault::Unknown { .. } => write!(f, "unknown field `{field}`{fault}"),
            _ => write!(f, "`{field}`{fault}"),
        }
    }
}

impl std::error::Error for CaseError {}

/// What to do with a line contact, which is not elliptical.
const fn line_contact(error: &CurvatureError) -> &'static str {
    match error {
        CurvatureError::LineContact { .. } => {
            "; a line contact needs `contact.length`, for `carom hertz` and `carom stress`, or a grid: `carom solve` with \
             gap.shape = \"cylinder\""
        }
        _ => "",
    }
}

impl CaseError {
    /// The message, with the lines of the file that are wrong and marks under the fields.
    #[must_use]
    pub fn shown_in(&self, source: &str) -> String {
        match &self.fault {
            CaseFault::Several(errors) => {
                let shown = errors.iter().map(|error| format!("\n{}", error.shown_in(source)));
                format!("{} errors{}", errors.len(), shown.collect::<String>())
            }
            CaseFault::Syntax { column, .. } => {
                format!("{self}{}", marked(source, self.line, *column, 1))
            }
            _ => format!("{self}{}", excerpt(source, self.line, &self.field)),
        }
    }
}

/// Longest line of a file that a message shows, in characters.
const LONGEST_SHOWN: usize = 90;

/// The line of the file with a mark under the name of the field; empty if there is none to show.
fn excerpt(source: &str, line: usize, field: &str) -> String {
    let text = line.checked_sub(1).and_then(|above| source.lines().nth(above)).unwrap_or("");
    let names = field.rsplit('.').map(|name| name.split('[').next().unwrap_or(name));
    let place = names.filter_map(|name| Some((named(text, name)?, name.chars().count()))).next();
    place.map_or_else(String::new, |(place, length)| marked(source, line, place, length))
}

/// The line with marks under `length` characters from the one at `place`.
fn marked(source: &str, line: usize, place: usize, length: usize) -> String {
    let text = line.checked_sub(1).and_then(|above| source.lines().nth(above)).unwrap_or("");
    let is_control = |letter: char| letter.is_control();
    if text.is_empty() || text.chars().count() > LONGEST_SHOWN || text.contains(is_control) {
        return String::new();
    }
    let number = line.to_string();
    let margin = " ".repeat(number.len());
    format!("\n  {number} | {text}\n  {margin} | {}{}", " ".repeat(place), "^".repeat(length))
}

/// Characters of the line before the name of a field, standing alone.
fn named(text: &str, name: &str) -> Option<usize> {
    let is_letter = |letter: char| letter.is_alphanumeric() || letter == '_';
    let found = text.match_indices(name).find(|(at, _)| {
        let (before, after) =
            (text[..*at].chars().next_back(), text[at + name.len()..].chars().next());
        !name.is_empty() && !before.is_some_and(is_letter) && !after.is_some_and(is_letter)
    });
    found.map(|(at, _)| text[..at].chars().count())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mark_is_under_the_name_and_not_under_a_longer_one() {
        let source = "body = { outer_radius = 1, radius_2 = 3, radius = -1 }";
        let under = |field: &str| {
            let text = excerpt(source, 1, field);
            let marks = text.lines().last().unwrap().split_once("| ").unwrap().1.to_owned();
            (marks.find('^').unwrap(), marks.matches('^').count())
        };
        assert_eq!(under("body.radius"), (source.find("radius = -1").unwrap(), 6));
        assert_eq!(under("body.outer_radius"), (9, 12));
        assert_eq!(under("radius_2"), (source.find("radius_2").unwrap(), 8));
        // A name that does not stand there leaves the mark to the one around it.
        assert_eq!(under("body.mass"), (0, 4));
        assert_eq!(excerpt(source, 1, "mass"), "");
        assert_eq!(excerpt(source, 2, "body"), "");
    }
}
