//! Why data cannot be fitted.

use carom_cases::Error;

/// Why data cannot be fitted.
#[derive(Debug, thiserror::Error)]
pub enum FitError {
    /// The case has an error, or an impact of it cannot be computed.
    #[error(transparent)]
    Case(#[from] Error),
    /// A row of the data has no outcome.
    #[error("row {row} of the data: {source}")]
    Row {
        /// The row, from 1.
        row: usize,
        /// Why.
        source: Error,
    },
    /// Bounds of several unknowns allow values that contradict each other.
    #[error("the bounds of {bounds} allow values that contradict each other: {source}")]
    Bounds {
        /// The unknowns with their bounds.
        bounds: String,
        /// Of the values that were tried.
        source: Error,
    },
    /// The bodies of a row do not meet.
    #[error(
        "row {row} of the data: the bodies do not approach each other, so that nothing of a rebound can be compared"
    )]
    NoImpact {
        /// The row, from 1.
        row: usize,
    },
    /// A measured quantity does not exist in the theory.
    #[error("row {row} of the data: a measured quantity is not defined for this impact")]
    Undefined {
        /// The row, from 1.
        row: usize,
    },
    /// The case has nothing to determine.
    #[error(
        "the case has no unknown: give a number of it as {{ fit = [low, high] }} or {{ prior = {{ mean, sd }} }}"
    )]
    NoUnknown,
    /// A number of the case varies, and the data do not replace it.
    #[error(
        "`{field}` is a sweep or a distribution: give one number, an unknown, or a column `{field}` of the data"
    )]
    Varies {
        /// The field.
        field: &'static str,
    },
    /// This kind of case has no fit.
    #[error(
        "a case for `carom {kind}` cannot be fitted, but one for `carom impact`, `carom hertz` or `carom history`"
    )]
    Kind {
        /// The kind.
        kind: &'static str,
    },
    /// A column of the data is not one of the case or of its outcome.
    #[error("column `{column}` of the data: {reason}")]
    Column {
        /// The column.
        column: String,
        /// What is wrong.
        reason: String,
    },
    /// An entry of the data is no number in its range.
    #[error("column `{column}` of the data, row {row}: {found} must be {allowed}")]
    Entry {
        /// The column.
        column: String,
        /// The row, from 1.
        row: usize,
        /// The entry.
        found: String,
        /// What is allowed.
        allowed: String,
    },
    /// The standard errors of a quantity are given in two ways.
    #[error(
        "the standard errors of `{column}` are given twice{}: give them once",
        if .beside.is_empty() { String::new() } else { format!(", as `sd` and by the column `{}`", .beside) }
    )]
    ErrorsTwice {
        /// The quantity.
        column: String,
        /// The column of the data that has them; empty if none does.
        beside: String,
    },
    /// The data are not a table.
    #[error("the data: {0}")]
    Table(String),
    /// The inputs of which predictions are asked for have an error.
    #[error("for predictions: {0}")]
    Inputs(Box<Self>),
    /// There are fewer measured values than unknowns.
    #[error(
        "{measured} measured values cannot determine {unknowns} unknowns: give more rows, or state numbers of the case"
    )]
    TooFew {
        /// The number of measured values.
        measured: usize,
        /// The number of unknowns.
        unknowns: usize,
    },
}

impl FitError {
    /// The error of a column.
    pub(crate) fn column(column: impl Into<String>, reason: impl Into<String>) -> Self {
        Self::Column { column: column.into(), reason: reason.into() }
    }

    /// Whether the input causes the error, not the computation or the system.
    #[must_use]
    pub fn is_bad_input(&self) -> bool {
        match self {
            Self::Case(error)
            | Self::Row { source: error, .. }
            | Self::Bounds { source: error, .. } => error.is_bad_input(),
            Self::Inputs(error) => error.is_bad_input(),
            _ => true,
        }
    }
}
