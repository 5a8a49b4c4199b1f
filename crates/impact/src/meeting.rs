//! Where two bodies meet that still lie apart: body 1 goes on straight towards body 2.

use nalgebra::Vector3;

use crate::contact_point::{SearchError, nearest};
use crate::placed_body::PlacedBody;
use crate::surface::{Kind, Surface};

const MAX_STEPS: usize = 500;

/// A gap below this part of the distance of the centres is round-off.
const ROUND_OFF: f64 = 8.0 * f64::EPSILON;

/// Body 1, moved along the velocity of its centre against that of body 2 until the gap is within
/// `allowed`. The bodies do not turn on the way.
///
/// The gap of convex bodies is a convex function of the way: Newton's steps come from outside and
/// never pass the touch. For others a step is as long as the gap, which is safe for all.
pub(crate) fn brought_together(
    body_1: PlacedBody,
    body_2: &PlacedBody,
    allowed: f64,
) -> Result<PlacedBody, SearchError> {
    let course = body_1.motion.velocity - body_2.motion.velocity;
    let is_convex = is_convex(&body_1.surface) && is_convex(&body_2.surface);
    let mut moved = body_1;
    let mut found = nearest(&moved.placed(), &body_2.placed())?;
    for _ in 0..MAX_STEPS {
        let round_off = ROUND_OFF * (moved.centre - body_2.centre).norm();
        if found.gap.abs() <= allowed.max(round_off) {
            return Ok(moved);
        }
        let closing = closing_speed(&found.points, found.gap, &course);
        // Apart and not closing in (convex gaps only grow from there), or overlapping.
        if found.gap.is_nan() || found.gap < 0.0 || (is_convex && closing <= 0.0) {
            break;
        }
        moved.centre += course * (found.gap / if is_convex { closing } else { course.norm() });
        if !moved.centre.iter().all(|x| x.is_finite()) {
            break;
        }
        found = nearest(&moved.placed(), &body_2.placed())?;
    }
    Err(SearchError::NotTouching { gap: found.gap, allowed })
}

// How fast the gap shrinks.
fn closing_speed(points: &[Vector3<f64>; 2], gap: f64, course: &Vector3<f64>) -> f64 {
    let normal = (points[0] - points[1]) / gap;
    -course.dot(&normal)
}

fn is_convex(surface: &Surface) -> bool {
    matches!(
        surface.kind(),
        Kind::Sphere { .. }
            | Kind::Ellipsoid { .. }
            | Kind::Plane
            | Kind::Cylinder { .. }
            | Kind::Capsule { .. }
            | Kind::Box { .. }
    )
}
