//! Errors of an impact by rings.

use carom_special::RangeError;

use crate::collision::CollisionError;

/// Why an impact by rings failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RingImpactError {
    /// A value out of range, or bodies that are not spheres or planes.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The collision itself cannot be computed.
    #[error(transparent)]
    Collision(#[from] CollisionError),
    /// The bodies do not separate.
    #[error("the bodies do not separate within 64 times the duration of a free impact")]
    NoSeparation,
}
