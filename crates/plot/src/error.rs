//! Why a plot cannot be drawn.

/// Why a plot cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlotError {
    /// A coordinate is not a finite number.
    #[error("series `{label}`: point {index} is ({x}, {y}), not finite")]
    NotFinite {
        /// Label of the series.
        label: String,
        /// Index of the point in the series.
        index: usize,
        /// Its abscissa.
        x: f64,
        /// Its ordinate.
        y: f64,
    },
    /// A coordinate on a logarithmic axis is not positive.
    #[error("axis `{label}` is logarithmic, but has the value {value}")]
    NotPositive {
        /// Label of the axis.
        label: String,
        /// The value.
        value: f64,
    },
    /// The limits of an axis are not finite, or not in order.
    #[error("axis `{label}`: limits {low} and {high} are not finite and increasing")]
    Limits {
        /// Label of the axis.
        label: String,
        /// Lower limit.
        low: f64,
        /// Upper limit.
        high: f64,
    },
    /// A field has no valid grid, or not one finite value for each node.
    #[error(
        "field `{label}`: two or more finite, increasing nodes along each axis and a finite value \
         for each pair are needed"
    )]
    Grid {
        /// Label of the field.
        label: String,
    },
    /// A cell of a map is of a kind that has no name.
    #[error("a cell is of kind {kind}, but there are names for {count} kinds, counted from 0")]
    Kind {
        /// The kind.
        kind: usize,
        /// Number of names.
        count: usize,
    },
    /// A series cannot be animated with its frames.
    #[error("series `{label}` cannot move: {reason}")]
    Motion {
        /// Label of the series.
        label: String,
        /// The reason.
        reason: &'static str,
    },
    /// The pixel image could not be created.
    #[error("cannot make the image: {0}")]
    Raster(String),
    /// There is no panel, or a panel has no point.
    #[error("nothing to plot")]
    Empty,
}
