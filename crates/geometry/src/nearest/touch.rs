//! Pairs of nearest points of two bodies.

use nalgebra::Vector3;

/// The nearest points of two bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Nearest {
    /// On body 1 and on body 2.
    pub(crate) points: [Vector3<f64>; 2],
    pub(crate) gap: f64,
}

impl Nearest {
    pub(super) fn exchanged(self) -> Self {
        Self { points: [self.points[1], self.points[0]], gap: self.gap }
    }
}

/// Nearest points of two parts of bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Touch {
    pub(super) near: Nearest,
    /// Whether they lie inside both parts, not at the border of one.
    pub(super) within: bool,
}

impl Touch {
    pub(super) fn exchanged(self) -> Self {
        Self { near: self.near.exchanged(), within: self.within }
    }
}
