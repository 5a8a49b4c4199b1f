//! Why a file is not a height map.

/// Why a file is not a height map, with its place.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SurfaceError {
    /// The file does not have the structure of its format.
    #[error("this {format} file is damaged: {reason}")]
    Damaged {
        /// The format.
        format: &'static str,
        /// What is wrong.
        reason: String,
    },
    /// The file is well formed, but it holds something else than one map of heights.
    #[error("this {format} file {reason}")]
    Unsupported {
        /// The format.
        format: &'static str,
        /// What it holds, and what is needed.
        reason: String,
    },
    /// A value of a text is not a number.
    #[error("line {line}, column {column}: `{found}` is not a finite number{hint}")]
    Value {
        /// Line, from 1.
        line: usize,
        /// Value in the line, from 1.
        column: usize,
        /// The value as written.
        found: String,
        /// What may be meant, or an empty text.
        hint: &'static str,
    },
    /// A line of a text has more or fewer values than the first.
    #[error(
        "line {line} has {found} values, line {first} has {expected}: every row must have as many"
    )]
    Ragged {
        /// Line, from 1.
        line: usize,
        /// Number of its values.
        found: usize,
        /// Line of the first row.
        first: usize,
        /// Number of values of the first row.
        expected: usize,
    },
    /// A height is infinite.
    #[error(
        "the height in row {row}, column {column} is {value}: must be finite, or NaN where a point is missing"
    )]
    NotFinite {
        /// The row, from 1.
        row: usize,
        /// The column, from 1.
        column: usize,
        /// The value.
        value: f64,
    },
    /// A list of points x, y, z is not a regular grid.
    #[error("line {line}: {reason}")]
    Points {
        /// Line, from 1.
        line: usize,
        /// What is wrong.
        reason: String,
    },
    /// There are no heights, or none is measured.
    #[error("there is no height in this file{hint}")]
    Empty {
        /// What may be meant, or an empty text.
        hint: &'static str,
    },
    /// The map has more points than allowed.
    #[error("this map has {columns} x {rows} points: at most {most} are read")]
    TooMany {
        /// Number of columns.
        columns: usize,
        /// Number of rows.
        rows: usize,
        /// Largest number of points.
        most: usize,
    },
    /// The map has another size than its grid.
    #[error("the height map has {} x {} values, the grid {} x {} cells", .found[0], .found[1], .wanted[0], .wanted[1])]
    OtherSize {
        /// Columns and rows of the map.
        found: [usize; 2],
        /// Columns and rows of the grid.
        wanted: [usize; 2],
    },
    /// A height times a factor is infinite.
    #[error(
        "the height in row {row}, column {column} is {value:e} times the scale {factor:e}: must be finite"
    )]
    Scaled {
        /// The row, from 1.
        row: usize,
        /// The column, from 1.
        column: usize,
        /// The height.
        value: f64,
        /// The factor.
        factor: f64,
    },
    /// A part that is cut out of a map does not lie in it.
    #[error(
        "`crop` = {crop:?} is out of range: must be [left, lower, right, upper] in points, from 0 to {columns} and {rows}, \
             with at least one point between"
    )]
    Crop {
        /// The part.
        crop: [usize; 4],
        /// Number of columns.
        columns: usize,
        /// Number of rows.
        rows: usize,
    },
    /// An option does not belong to this format.
    #[error("`{option}` {reason}")]
    Option {
        /// The option.
        option: &'static str,
        /// Why not, and what to do.
        reason: &'static str,
    },
}

impl SurfaceError {
    pub(crate) fn damaged(format: &'static str, reason: impl Into<String>) -> Self {
        Self::Damaged { format, reason: reason.into() }
    }

    pub(crate) fn unsupported(format: &'static str, reason: impl Into<String>) -> Self {
        Self::Unsupported { format, reason: reason.into() }
    }
}
