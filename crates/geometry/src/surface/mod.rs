//! Surfaces of bodies, and their shape near a point (section 8.1).
//!
//! Points and directions are given in the body's own axes (a, b, c): the principal axes of inertia,
//! with the centre of mass as origin.

mod closest;
mod error;
mod evaluate;
mod jet;
mod least;
mod local;
mod moments;
mod outside;
mod sample;
mod volume;

pub use error::SurfaceError;
pub use jet::Height;
pub use local::LocalSurface;

pub(crate) use closest::{Closest, invert_in_plane, support_of_ellipsoid};
pub(crate) use least::Objective;

use crate::curvature::PrincipalRadii;
use carom_special::RangeError;
use jet::{Field, Source};
use nalgebra::Vector3;

/// The surface of a body, in its own axes.
///
/// ```
/// use carom_geometry::Surface;
/// use nalgebra::Vector3;
/// let egg = Surface::ellipsoid([3.0, 2.0, 1.5])?;
/// let bottom = egg.local(&Vector3::new(0.0, 0.0, -1.5))?;
/// // k = c/a^2 and c/b^2 at the end of axis c.
/// assert!((bottom.curvatures()[0] - 0.375).abs() < 1e-15);
/// assert!((bottom.curvatures()[1] - 1.0 / 6.0).abs() < 1e-15);
/// # Ok::<(), carom_geometry::SurfaceError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Surface {
    kind: Kind,
}

#[derive(Debug, Clone)]
pub(crate) enum Kind {
    Sphere { radius: f64 },
    Ellipsoid { semi_axes: Vector3<f64> },
    Plane,
    Cylinder { radius: f64, half_length: f64 },
    Capsule { radius: f64, half_length: f64 },
    Torus { major: f64, minor: f64 },
    Box { half: Vector3<f64> },
    Implicit { size: f64, function: Source },
    Explicit { size: f64, side: BodySide, function: Source },
    Given { local: LocalSurface },
}

/// On which side of an explicit surface c(a, b) the body lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BodySide {
    /// The body lies where c is larger: its lower face can touch.
    Above,
    /// The body lies where c is smaller: its upper face can touch.
    Below,
}

impl BodySide {
    /// The sign of c(a, b) - c outside the body.
    const fn sign(self) -> f64 {
        match self {
            Self::Above => 1.0,
            Self::Below => -1.0,
        }
    }
}

impl Surface {
    fn of(kind: Kind) -> Self {
        Self { kind }
    }

    /// A sphere.
    ///
    /// # Errors
    /// [`RangeError`] unless the radius is finite and positive.
    pub fn sphere(radius: f64) -> Result<Self, RangeError> {
        RangeError::positive("radius", radius)?;
        Ok(Self::of(Kind::Sphere { radius }))
    }

    /// The ellipsoid `(a/A)^2 + (b/B)^2 + (c/C)^2 = 1` with semi-axes A, B, C.
    ///
    /// # Errors
    /// [`RangeError`] unless all are finite and positive.
    pub fn ellipsoid(semi_axes: [f64; 3]) -> Result<Self, RangeError> {
        for value in semi_axes {
            RangeError::positive("semi_axis", value)?;
        }
        Ok(Self::of(Kind::Ellipsoid { semi_axes: semi_axes.into() }))
    }

    /// The plane c = 0; the body is the half-space c < 0. Its velocity is given at the contact
    /// point.
    #[must_use]
    pub fn plane() -> Self {
        Self::of(Kind::Plane)
    }

    /// A circular cylinder about axis c with flat ends.
    ///
    /// # Errors
    /// [`RangeError`] unless radius and length are finite and positive.
    pub fn cylinder(radius: f64, length: f64) -> Result<Self, RangeError> {
        RangeError::positive("radius", radius)?;
        RangeError::positive("length", length)?;
        Ok(Self::of(Kind::Cylinder { radius, half_length: 0.5 * length }))
    }

    /// A circular cylinder about axis c with hemispherical ends; `length` is that of the straight
    /// part.
    ///
    /// # Errors
    /// [`RangeError`] unless radius and length are finite and positive.
    pub fn capsule(radius: f64, length: f64) -> Result<Self, RangeError> {
        RangeError::positive("radius", radius)?;
        RangeError::positive("length", length)?;
        Ok(Self::of(Kind::Capsule { radius, half_length: 0.5 * length }))
    }

    /// A torus about axis c: a tube of radius `minor` around a circle of radius `major`.
    ///
    /// # Errors
    /// [`RangeError`] unless both are finite and positive and minor < major.
    pub fn torus(major: f64, minor: f64) -> Result<Self, RangeError> {
        RangeError::positive("major radius", major)?;
        RangeError::positive("minor radius", minor)?;
        RangeError::check("minor radius", minor, minor < major, "< the major radius")?;
        Ok(Self::of(Kind::Torus { major, minor }))
    }

    /// A box with these edge lengths along a, b and c. Only its faces can be in contact; a contact
    /// at an edge or a corner, which have no tangent plane, is an error.
    ///
    /// # Errors
    /// [`RangeError`] unless all edges are finite and positive.
    pub fn cuboid(edges: [f64; 3]) -> Result<Self, RangeError> {
        for value in edges {
            RangeError::positive("edge", value)?;
        }
        Ok(Self::of(Kind::Box { half: 0.5 * Vector3::from(edges) }))
    }

    /// The surface f(a, b, c) = 0 of a body in which f < 0. Derivatives are computed by five-point
    /// differences over 1/400 of `size` (relative error about 1e-10). The search for a contact
    /// considers points within four sizes of the origin.
    ///
    /// ```
    /// use carom_geometry::Surface;
    /// use nalgebra::Vector3;
    /// let ball = Surface::implicit(2.0, |p| p.norm_squared() - 4.0)?;
    /// let local = ball.local(&Vector3::new(0.0, 0.0, -2.0))?;
    /// assert!((local.curvatures()[1] - 0.5).abs() < 1e-9);
    /// # Ok::<(), carom_geometry::SurfaceError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] unless the size is finite and positive.
    pub fn implicit(
        size: f64,
        function: impl Fn(&Vector3<f64>) -> f64 + Send + Sync + 'static,
    ) -> Result<Self, RangeError> {
        RangeError::positive("size", size)?;
        let function = Source::Bare { function: Field::new(function), size };
        Ok(Self::of(Kind::Implicit { size, function }))
    }

    /// The surface c(a, b) of a body on the given side of it, with derivatives by differences as in
    /// [`Surface::implicit`]. Where c is not finite there is no surface. The search for a contact
    /// starts in |a|, |b| <= 2 sizes and next to the other body.
    ///
    /// # Errors
    /// [`RangeError`] unless the size is finite and positive.
    pub fn explicit(
        size: f64,
        side: BodySide,
        function: impl Fn(f64, f64) -> f64 + Send + Sync + 'static,
    ) -> Result<Self, RangeError> {
        RangeError::positive("size", size)?;
        let flat = move |p: &Vector3<f64>| function(p.x, p.y);
        let function = Source::Bare { function: Field::new(flat), size };
        Ok(Self::of(Kind::Explicit { size, side, function }))
    }

    /// The surface c(a, b) with its exact derivatives (8.13)-(8.16).
    ///
    /// # Errors
    /// [`RangeError`] unless the size is finite and positive.
    pub fn explicit_with(
        size: f64,
        side: BodySide,
        function: impl Fn(&[f64; 2]) -> Height + Send + Sync + 'static,
    ) -> Result<Self, RangeError> {
        RangeError::positive("size", size)?;
        let flat = move |p: &Vector3<f64>| function(&[p.x, p.y]).jet();
        let function = Source::Exact(Field::new(flat));
        Ok(Self::of(Kind::Explicit { size, side, function }))
    }

    /// A surface known at one point only, by its outward normal, its principal radii and the
    /// direction of the first radius (which is made perpendicular to the normal).
    ///
    /// # Errors
    /// [`RangeError`] unless the point is finite, the normal not zero, and the direction not
    /// parallel to it.
    pub fn given(
        point: [f64; 3],
        normal: [f64; 3],
        direction: [f64; 3],
        radii: PrincipalRadii,
    ) -> Result<Self, RangeError> {
        let point = Vector3::from(point);
        RangeError::finite("contact point", point.sum())?;
        let normal = Vector3::from(normal);
        RangeError::positive("normal", normal.norm())?;
        let normal = normal.normalize();
        let direction = Vector3::from(direction);
        let tangent = direction - normal * normal.dot(&direction);
        let share = tangent.norm() / direction.norm();
        RangeError::check("principal direction", share, share > 1e-9, "not along the normal")?;
        let local = LocalSurface::new(point, normal, radii.curvatures(), tangent.normalize());
        Ok(Self::of(Kind::Given { local }))
    }

    pub(crate) const fn kind(&self) -> &Kind {
        &self.kind
    }

    /// The radius of a sphere; `None` for any other surface.
    #[must_use]
    pub const fn radius(&self) -> Option<f64> {
        match &self.kind {
            Kind::Sphere { radius } => Some(*radius),
            _ => None,
        }
    }

    /// Whether it is a plane.
    #[must_use]
    pub const fn is_plane(&self) -> bool {
        matches!(self.kind, Kind::Plane)
    }

    /// Whether surfaces of this kind are always convex.
    pub(crate) const fn is_convex(&self) -> bool {
        !matches!(
            self.kind,
            Kind::Torus { .. } | Kind::Implicit { .. } | Kind::Explicit { .. } | Kind::Given { .. }
        )
    }

    /// The name of the kind of surface.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match &self.kind {
            Kind::Sphere { .. } => "sphere",
            Kind::Ellipsoid { .. } => "ellipsoid",
            Kind::Plane => "plane",
            Kind::Cylinder { .. } => "cylinder",
            Kind::Capsule { .. } => "capsule",
            Kind::Torus { .. } => "torus",
            Kind::Box { .. } => "box",
            Kind::Implicit { .. } => "implicit surface",
            Kind::Explicit { .. } => "explicit surface",
            Kind::Given { .. } => "surface given at a point",
        }
    }

    /// A length of the body: its greatest half-width, or the given size.
    #[must_use]
    pub fn size(&self) -> f64 {
        match &self.kind {
            Kind::Sphere { radius } => *radius,
            Kind::Ellipsoid { semi_axes } => semi_axes.max(),
            Kind::Plane => 0.0,
            Kind::Cylinder { radius, half_length } => libm::hypot(*radius, *half_length),
            Kind::Capsule { radius, half_length } => radius + half_length,
            Kind::Torus { major, minor } => major + minor,
            Kind::Box { half } => half.norm(),
            Kind::Implicit { size, .. } | Kind::Explicit { size, .. } => *size,
            Kind::Given { local } => local.point().norm(),
        }
    }
}
