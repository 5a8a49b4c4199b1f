//! The queries of a search to a placed surface.

use nalgebra::Vector3;

use crate::placed::Placed;
use crate::surface::{Closest, Kind};

/// A placed surface with the starts for searches over it.
#[derive(Debug, Clone)]
pub(super) struct Target<'a> {
    pub(super) placed: &'a Placed,
    pub(super) starts: Vec<Vector3<f64>>,
}

impl<'a> Target<'a> {
    pub(super) fn new(placed: &'a Placed) -> Self {
        Self { placed, starts: placed.surface().starts() }
    }

    /// The surface point closest to a given point, both in space.
    pub(super) fn closest(&self, from: &Vector3<f64>) -> Option<Closest> {
        let found = self.placed.surface().closest(&self.placed.body_point(from), &self.starts)?;
        let point = self.placed.space_point(&found.point);
        let normal = self.placed.attitude().to_space(&found.normal);
        Some(Closest { point, normal, distance: found.distance })
    }

    pub(super) fn kind(&self) -> &Kind {
        self.placed.surface().kind()
    }

    pub(super) fn size(&self) -> f64 {
        self.placed.surface().size()
    }

    /// Whether the surface is smooth everywhere and has starts for a search.
    pub(super) fn is_smooth(&self) -> bool {
        matches!(
            self.kind(),
            Kind::Ellipsoid { .. } | Kind::Implicit { .. } | Kind::Explicit { .. }
        )
    }

    /// Whether surfaces of this kind are always convex.
    pub(super) fn is_convex(&self) -> bool {
        self.placed.surface().is_convex()
    }
}
