//! A surface somewhere in space, and what a search asks of it.

use nalgebra::{Matrix3, Vector3};

use crate::attitude::Attitude;
use crate::surface::{Closest, Kind, LocalSurface, Surface};

/// A surface somewhere in space.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placed<'a> {
    pub(crate) surface: &'a Surface,
    pub(crate) centre: Vector3<f64>,
    pub(crate) attitude: Attitude,
}

impl Placed<'_> {
    pub(super) fn space_point(&self, in_body: &Vector3<f64>) -> Vector3<f64> {
        self.centre + self.attitude.to_space(in_body)
    }

    pub(super) fn body_point(&self, in_space: &Vector3<f64>) -> Vector3<f64> {
        self.attitude.to_body(&(in_space - self.centre))
    }

    pub(super) fn local(&self, in_space: &Vector3<f64>) -> Option<LocalSurface> {
        let local = self.surface.local(&self.body_point(in_space)).ok()?;
        Some(local.placed(&self.centre, &self.attitude))
    }

    pub(super) fn tensor(&self, in_body: &Matrix3<f64>) -> Matrix3<f64> {
        self.attitude.matrix() * in_body * self.attitude.matrix().transpose()
    }
}

/// A placed surface with the points from which searches over it start.
#[derive(Debug, Clone)]
pub(super) struct Target<'a> {
    pub(super) placed: Placed<'a>,
    pub(super) starts: Vec<Vector3<f64>>,
}

impl<'a> Target<'a> {
    pub(super) fn new(placed: &Placed<'a>) -> Self {
        Self { placed: *placed, starts: placed.surface.starts() }
    }

    /// The point closest to a point of space, all in space.
    pub(super) fn closest(&self, from: &Vector3<f64>) -> Option<Closest> {
        let found = self.placed.surface.closest(&self.placed.body_point(from), &self.starts)?;
        let point = self.placed.space_point(&found.point);
        let normal = self.placed.attitude.to_space(&found.normal);
        Some(Closest { point, normal, distance: found.distance })
    }

    pub(super) fn kind(&self) -> &Kind {
        self.placed.surface.kind()
    }

    pub(super) fn size(&self) -> f64 {
        self.placed.surface.size()
    }

    /// Smooth all over, with points to start from.
    pub(super) fn is_smooth(&self) -> bool {
        matches!(
            self.kind(),
            Kind::Ellipsoid { .. } | Kind::Implicit { .. } | Kind::Explicit { .. }
        )
    }

    /// Convex whatever its numbers.
    pub(super) fn is_convex(&self) -> bool {
        !matches!(
            self.kind(),
            Kind::Torus { .. } | Kind::Implicit { .. } | Kind::Explicit { .. } | Kind::Given { .. }
        )
    }
}
