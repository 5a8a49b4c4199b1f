//! The contact point of two surfaces: its position, axes and lever arms.

use carom_special::RangeError;
use nalgebra::Vector3;

use crate::frame::ContactFrame;
use crate::nearest::{Certainty, SearchError, approach, nearest_points, origin_of_search};
use crate::placed::Placed;
use crate::surface::{LocalSurface, SurfaceError};

/// Greatest gap or overlap at which surfaces count as touching, relative to the size of the smaller
/// body.
pub const TOUCH_TOLERANCE: f64 = 1e-6;

/// The point where two surfaces touch.
///
/// ```
/// use carom_geometry::{ContactPoint, Placed, Surface};
/// use nalgebra::Vector3;
/// let ball = Placed::new(Surface::sphere(1.0)?).at([0.5, 0.0, 1.0])?;
/// let floor = Placed::new(Surface::plane());
/// let touch = ContactPoint::find(&ball, &floor)?;
/// assert_eq!(touch.point(), Vector3::new(0.5, 0.0, 0.0));
/// assert_eq!(touch.frame().z(), Vector3::z());
/// assert!(ContactPoint::find(&ball.at([0.0, 0.0, 1.1])?, &floor).is_err());
/// # Ok::<(), carom_geometry::SearchError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactPoint {
    point: Vector3<f64>,
    frame: ContactFrame,
    arms: [Vector3<f64>; 2],
    sharpest: f64,
    certainty: Certainty,
}

impl ContactPoint {
    /// Finds the contact point of two placed surfaces. The z axis points from surface 2 into
    /// surface 1.
    ///
    /// # Errors
    /// [`SearchError`] if the surfaces do not touch, if one touches with an edge, or if no search
    /// exists for the pair; otherwise as [`ContactPoint::at`].
    pub fn find(one: &Placed, two: &Placed) -> Result<Self, SearchError> {
        let origin = origin_of_search(one, two);
        let seen = [one.seen_from(&origin), two.seen_from(&origin)];
        let found = nearest_points(&seen[0], &seen[1])?;
        let allowed = allowed_gap(one, two);
        if found.gap.is_nan() || found.gap.abs() > allowed {
            return Err(SearchError::NotTouching { gap: found.gap, allowed });
        }
        let locals = locals(|i| seen[i].local(&found.points[i]))?;
        let point = 0.5 * (found.points[0] + found.points[1]);
        let arms = [point - seen[0].centre(), point - seen[1].centre()];
        Ok(Self { certainty: found.certainty, ..Self::of(&locals, origin + point, arms)? })
    }

    /// The contact at a given point of space; the point is not searched for.
    ///
    /// # Errors
    /// [`SearchError::Surface`] if the point does not lie on both surfaces or one has no tangent
    /// plane there, [`SearchError::Frame`] if the normals are not opposite, or the surfaces conform
    /// or touch along a line.
    pub fn at(one: &Placed, two: &Placed, point: [f64; 3]) -> Result<Self, SearchError> {
        let point = Vector3::from(point);
        let locals = locals(|i| [one, two][i].local(&point))?;
        Self::of(&locals, point, [point - one.centre(), point - two.centre()])
    }

    /// Moves the bodies into contact with a given common normal, from surface 2 into surface 1.
    /// Surface 2 stays, surface 1 is translated; a plane is rotated to face the other surface.
    ///
    /// # Errors
    /// [`SearchError::Range`] unless the normal is finite and not zero; otherwise as
    /// [`ContactPoint::find`].
    pub fn along(
        one: &Placed,
        two: &Placed,
        normal: [f64; 3],
    ) -> Result<([Placed; 2], Self), SearchError> {
        let vector = Vector3::from(normal);
        RangeError::positive("normal", vector.norm())?;
        let normal = vector.normalize();
        let ((one, point_1), (two, point_2)) = (one.facing(&-normal)?, two.facing(&normal)?);
        let (one, touch) = Self::at_own_points(&one, &two, [point_1.into(), point_2.into()])?;
        Ok(([one, two], touch))
    }

    /// Moves surface 1 so that both touch at given points, each in the axes of its own body. The
    /// centres need not be known; surface 2 stays.
    ///
    /// # Errors
    /// As [`ContactPoint::at`].
    pub fn at_own_points(
        one: &Placed,
        two: &Placed,
        points: [[f64; 3]; 2],
    ) -> Result<(Placed, Self), SearchError> {
        let points = points.map(Vector3::from);
        let arms = [one.attitude().to_space(&points[0]), two.attitude().to_space(&points[1])];
        let point = two.centre() + arms[1];
        let one = one.clone().moved_to(point - arms[0]);
        let at = |placed: &Placed, in_body: &Vector3<f64>| {
            Ok(placed.surface().local(in_body)?.placed(&placed.centre(), placed.attitude()))
        };
        let locals = locals(|i| at([&one, two][i], &points[i]))?;
        let touch = Self::of(&locals, point, arms)?;
        Ok((one, touch))
    }

    /// Moves surface 1 along `course`, without rotation, until it first touches surface 2.
    ///
    /// # Errors
    /// [`SearchError::NotTouching`] if they overlap or miss each other; otherwise as
    /// [`ContactPoint::find`].
    pub fn approaching(
        one: &Placed,
        two: &Placed,
        course: &Vector3<f64>,
    ) -> Result<(Placed, Self), SearchError> {
        // The last digits of the distance decide whether the surfaces touch.
        let allowed = 1e-6 * allowed_gap(one, two);
        let origin = two.centre();
        let two = two.seen_from(&origin);
        let one = approach::brought_together(one.seen_from(&origin), &two, course, allowed)?;
        let touch = Self::find(&one, &two)?;
        Ok((one.seen_from(&-origin), Self { point: touch.point + origin, ..touch }))
    }

    fn of(
        locals: &[LocalSurface; 2],
        point: Vector3<f64>,
        arms: [Vector3<f64>; 2],
    ) -> Result<Self, SearchError> {
        let frame = ContactFrame::new(&locals[0], &locals[1])?;
        let curvatures = locals.iter().flat_map(LocalSurface::curvatures);
        let sharpest = curvatures.map(f64::abs).fold(0.0, f64::max);
        Ok(Self { point, frame, arms, sharpest, certainty: Certainty::Proven })
    }

    /// The contact point in space.
    #[must_use]
    pub const fn point(&self) -> Vector3<f64> {
        self.point
    }

    /// The contact axes.
    #[must_use]
    pub const fn frame(&self) -> &ContactFrame {
        &self.frame
    }

    /// Vectors from the centre of each surface to the contact point, in space.
    #[must_use]
    pub const fn arms(&self) -> &[Vector3<f64>; 2] {
        &self.arms
    }

    /// The smallest radius of curvature of the two surfaces at the contact point.
    #[must_use]
    pub fn smallest_radius(&self) -> f64 {
        1.0 / self.sharpest
    }

    /// Whether the bodies may also touch elsewhere.
    #[must_use]
    pub const fn certainty(&self) -> Certainty {
        self.certainty
    }
}

// The largest gap or overlap that counts as contact.
fn allowed_gap(one: &Placed, two: &Placed) -> f64 {
    let sizes = [one, two].map(|placed| placed.surface().size());
    let size = sizes.into_iter().filter(|size| *size > 0.0).fold(f64::INFINITY, f64::min);
    TOUCH_TOLERANCE * size
}

fn locals(
    local: impl Fn(usize) -> Result<LocalSurface, SurfaceError>,
) -> Result<[LocalSurface; 2], SearchError> {
    let named = |body, i| local(i).map_err(|source| SearchError::Surface { body, source });
    Ok([named(1, 0)?, named(2, 1)?])
}
