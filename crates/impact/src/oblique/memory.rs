//! The memory of the contact: for each depth, the velocity, shift and traction at the time when the
//! annulus at the edge of that depth was last free of additional stress (the "old" state of section
//! 8.4).

use super::adhesion::Segment;
use super::position::Position;

/// How a stretch of depths was formed.
#[derive(Debug, Clone)]
pub(super) enum Shape {
    /// In complete adhesion while the contact grew.
    Adhesion(Box<Segment>),
    /// In slip: slope `sign` of the shift over depth.
    Slip(Frozen),
}

/// The stresses left by slip of one sign, frozen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frozen {
    pub(super) sign: f64,
    /// psi times the stored traction is `offset + sign z^(3/2)`.
    pub(super) offset: f64,
}

/// A stretch of depths of the memory.
#[derive(Debug, Clone)]
pub(super) struct Stretch {
    /// tau at the smallest and at the largest depth.
    pub(super) inner: f64,
    pub(super) outer: f64,
    /// The stored shift at the smallest depth.
    pub(super) shift: f64,
    pub(super) shape: Shape,
}

impl Stretch {
    /// chi psi times the stored traction of the depths up to that of `stick`.
    pub(super) fn pull(&self, chi: f64, psi: f64, stick: &Position) -> f64 {
        match &self.shape {
            Shape::Adhesion(segment) => psi * segment.at(stick).flux,
            Shape::Slip(frozen) => chi * (frozen.offset + frozen.sign * stick.cube()),
        }
    }
}
