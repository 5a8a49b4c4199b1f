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
    #[error("line {line}: unknown field `{field}`{} {table} takes {valid}", nearest.as_ref().map_or_else(|| ";".to_owned(), |name| format!(", did you mean `{name}`{hint}?")))]
    Unknown {
        /// The name with its path.
        field: String,
        /// Line, from 1.
        line: usize,
        /// The table that contains it.
        table: String,
        /// The most similar valid name, if one is similar, or the one in a table of the table.
        nearest: Option<String>,
        /// What of the value belongs there, after a comma, or an empty text.
        hint: &'static str,
        /// All valid names.
        valid: String,
    },
    /// A necessary field is missing.
    #[error("{}`{field}` is missing: must be {allowed}", of_line(*line))]
    Missing {
        /// The field with its path.
        field: String,
        /// Line of the table that lacks it, from 1; 0 for the whole file.
        line: usize,
        /// What it must be.
        allowed: String,
    },
    /// A value of the wrong kind.
    #[error("line {line}: `{field}` = {found} is not allowed: must be {allowed}")]
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
    #[error("{}`{field}`{others}: {source}{}", of_line(*line), line_contact(source))]
    Curvature {
        /// The field of the first radii, with its path.
        field: String,
        /// Further fields of radii, after a comma.
        others: &'static str,
        /// Line, from 1.
        line: usize,
        /// Why.
        source: CurvatureError,
    },
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

/// The line in words; nothing for 0.
fn of_line(line: usize) -> String {
    if line == 0 { String::new() } else { format!("line {line}: ") }
}

/// What to do with a line contact, which is not elliptical.
const fn line_contact(error: &CurvatureError) -> &'static str {
    match error {
        CurvatureError::LineContact { .. } => {
            "; a line contact is a case for `carom solve` with gap.shape = \"cylinder\""
        }
        _ => "",
    }
}

impl CaseError {
    /// The field that is wrong, with its path; empty if there is no single one.
    #[must_use]
    pub fn field(&self) -> &str {
        match self {
            Self::Unknown { field, .. }
            | Self::Missing { field, .. }
            | Self::Kind { field, .. }
            | Self::Range { field, .. }
            | Self::Conflict { field, .. }
            | Self::Curvature { field, .. }
            | Self::Collision { field, .. } => field,
            Self::Torsion { .. } => "contact.torsion",
            Self::Syntax { .. } | Self::Several(_) | Self::OtherKind { .. } => "",
        }
    }

    /// The line of the file, from 1; 0 if there is no single one.
    #[must_use]
    pub const fn line(&self) -> usize {
        match self {
            Self::Syntax { line, .. }
            | Self::Unknown { line, .. }
            | Self::Missing { line, .. }
            | Self::Kind { line, .. }
            | Self::Range { line, .. }
            | Self::Conflict { line, .. }
            | Self::Curvature { line, .. }
            | Self::Collision { line, .. }
            | Self::Torsion { line, .. } => *line,
            Self::Several(_) | Self::OtherKind { .. } => 0,
        }
    }

    /// The message, with the lines of the file that are wrong and marks under the fields.
    #[must_use]
    pub fn shown_in(&self, source: &str) -> String {
        match self {
            Self::Several(errors) => {
                let shown = errors.iter().map(|error| format!("\n{}", error.shown_in(source)));
                format!("{} errors{}", errors.len(), shown.collect::<String>())
            }
            Self::Syntax { line, column, .. } => {
                format!("{self}{}", marked(source, *line, *column, 1))
            }
            error => format!("{error}{}", excerpt(source, error.line(), error.field())),
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
