//! Why triangles are no mesh.

use carom_special::{RangeError, Readable};

/// Why triangles are no mesh.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// Angle, period or number of triangles out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// A coordinate of a triangle is not a finite number.
    #[error("triangle {number} is not valid: a coordinate is not a finite number below 1e50")]
    NotFinite {
        /// Which triangle, from 1.
        number: usize,
    },
    /// A triangle has no area.
    #[error("triangle {number} is not valid: its corners lie on a line: must have an area")]
    NoArea {
        /// Which triangle, from 1.
        number: usize,
    },
    /// The surface is longer than the period with which it repeats itself.
    #[error(
        "length of the surface along {} = {} is out of range: must be at most {}, the period with \
         which it repeats itself",
        ["x", "y", "z"][*axis], Readable(*length), Readable(*period)
    )]
    TooLong {
        /// The axis, 0 to 2.
        axis: usize,
        /// The length.
        length: f64,
        /// The period.
        period: f64,
    },
    /// The computation was ended from outside.
    #[error("the mesh was not completed: it was interrupted")]
    Interrupted,
}
