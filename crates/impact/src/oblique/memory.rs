//! What the contact remembers: for each depth the velocity, the shift and the traction when the
//! ring that touches at that depth was last free of additional stress (the "old" state of section
//! 8.4).

use super::adhesion::Segment;
use super::place::Place;

/// How a stretch of depths was laid down.
#[derive(Debug, Clone)]
pub(super) enum Shape {
    /// In complete adhesion while the contact grew.
    Adhesion(Box<Segment>),
    /// In slip: slope `sign`.
    Slip(Frozen),
}

/// The stresses that slip of one sign left behind, frozen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frozen {
    pub(super) sign: f64,
    /// psi times the stored traction is this + sign z^(3/2).
    pub(super) offset: f64,
}

/// A stretch of depths of the memory.
#[derive(Debug, Clone)]
pub(super) struct Stretch {
    /// tau where it is least deep and where it is deepest.
    pub(super) inner: f64,
    pub(super) outer: f64,
    /// The stored shift where it is least deep.
    pub(super) shift: f64,
    pub(super) shape: Shape,
}

impl Stretch {
    /// chi psi times the stored traction within the depth of `stick`.
    pub(super) fn pull(&self, chi: f64, psi: f64, stick: &Place) -> f64 {
        match &self.shape {
            Shape::Adhesion(segment) => psi * segment.at(stick).flux,
            Shape::Slip(frozen) => chi * (frozen.offset + frozen.sign * stick.cube()),
        }
    }
}
