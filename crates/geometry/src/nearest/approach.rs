//! Where two surfaces meet that still lie apart: surface 1 goes on straight towards surface 2.

use nalgebra::Vector3;

use super::{SearchError, nearest};
use crate::placed::Placed;

const MAX_STEPS: usize = 500;

/// A gap below this part of the distance of the centres is round-off.
const ROUND_OFF: f64 = 8.0 * f64::EPSILON;

/// Surface 1, moved along `course` until the gap is within `allowed`. It does not turn on the way.
///
/// The gap of convex bodies is a convex function of the way: Newton's steps come from outside and
/// never pass the touch. For others a step is as long as the gap, which is safe for all.
pub(crate) fn brought_together(
    one: Placed,
    two: &Placed,
    course: &Vector3<f64>,
    allowed: f64,
) -> Result<Placed, SearchError> {
    let is_convex = one.surface().is_convex() && two.surface().is_convex();
    let mut moved = one;
    let mut found = nearest(&moved, two)?;
    for _ in 0..MAX_STEPS {
        let round_off = ROUND_OFF * (moved.centre() - two.centre()).norm();
        if found.gap.abs() <= allowed.max(round_off) {
            return Ok(moved);
        }
        let closing = closing_speed(&found.points, found.gap, course);
        // Apart and not closing in (convex gaps only grow from there), or overlapping.
        if found.gap.is_nan() || found.gap < 0.0 || (is_convex && closing <= 0.0) {
            break;
        }
        let way = course * (found.gap / if is_convex { closing } else { course.norm() });
        let centre = moved.centre() + way;
        if !centre.iter().all(|x| x.is_finite()) {
            break;
        }
        moved = moved.moved_to(centre);
        found = nearest(&moved, two)?;
    }
    Err(SearchError::NotTouching { gap: found.gap, allowed })
}

// How fast the gap shrinks.
fn closing_speed(points: &[Vector3<f64>; 2], gap: f64, course: &Vector3<f64>) -> f64 {
    let normal = (points[0] - points[1]) / gap;
    -course.dot(&normal)
}
