//! Why a plot cannot be drawn.

/// Why a plot cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlotError {
    /// A coordinate is not a finite number.
    #[error("series `{label}`: point {index} is ({x}, {y}), not finite")]
    NotFinite {
        /// Label of the series.
        label: String,
        /// Place of the point in it.
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
    /// A field has no grid, or not one finite value for each of its nodes.
    #[error(
        "field `{label}`: two or more finite, increasing nodes along each axis and a finite value \
         for each pair are needed"
    )]
    Grid {
        /// Label of the field.
        label: String,
    },
    /// A series cannot move through the frames that it has.
    #[error("series `{label}` cannot move: {reason}")]
    Motion {
        /// Label of the series.
        label: String,
        /// Why.
        reason: &'static str,
    },
    /// The pixels of an image could not be made.
    #[error("cannot make the image: {0}")]
    Raster(String),
    /// No panel, or one without a point.
    #[error("nothing to plot")]
    Empty,
}
