//! Moves one surface along a straight line until it touches another.

use nalgebra::Vector3;

use super::{SearchError, nearest};
use crate::placed::Placed;

const MAX_STEPS: usize = 500;

/// A gap below this fraction of the distance of the centres is rounding error.
const ROUND_OFF: f64 = 8.0 * f64::EPSILON;

/// Moves surface 1 along `course`, without rotation, until the gap is within `allowed`.
///
/// The gap of convex bodies is a convex function of the distance moved: Newton steps start outside
/// and never go beyond first contact. For other bodies a step is as long as the gap, which is
/// always safe.
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
        // Separated and not closing (a convex gap only grows from there), or overlapping.
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

// The rate at which the gap closes.
fn closing_speed(points: &[Vector3<f64>; 2], gap: f64, course: &Vector3<f64>) -> f64 {
    let normal = (points[0] - points[1]) / gap;
    -course.dot(&normal)
}
