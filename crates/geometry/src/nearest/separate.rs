//! Two ellipsoids: the direction with the greatest separation.

use nalgebra::{Matrix3, Vector3};

use super::{Nearest, SearchError};
use crate::placed::Placed;
use crate::surface::{invert_in_plane, support_of_ellipsoid};

const MAX_STEPS: usize = 200;

/// Greatest rotation of the direction in one step, radians.
const LONGEST_STEP: f64 = 0.3;

/// A placed ellipsoid by its semi-axes.
pub(super) type Egg<'a> = (&'a Placed, &'a Vector3<f64>);

// Support points for a direction n from body 2 into body 1, and W_1 + W_2, their derivative.
fn supports(one: Egg<'_>, two: Egg<'_>, n: &Vector3<f64>) -> (Nearest, Matrix3<f64>) {
    let p_1 = support_of_ellipsoid(one.1, &one.0.attitude().to_body(&-n));
    let p_2 = support_of_ellipsoid(two.1, &two.0.attitude().to_body(n));
    let points = [one.0.space_point(&p_1.point), two.0.space_point(&p_2.point)];
    let turning = one.0.tensor(&p_1.turning) + two.0.tensor(&p_2.turning);
    (Nearest { points, gap: n.dot(&(points[0] - points[1])) }, turning)
}

fn across(near: &Nearest, n: &Vector3<f64>) -> Vector3<f64> {
    let off = near.points[0] - near.points[1];
    off - n * n.dot(&off)
}

/// The separating direction n, from body 2 into body 1, that maximises the gap g(n) = n.(p_1(-n) -
/// p_2(n)) of the support points, by Newton's method on the sphere, where grad g = tangential part
/// of p_1 - p_2 and hess g = -(W_1 + W_2) - g I.
pub(super) fn separate(one: Egg<'_>, two: Egg<'_>) -> Result<Nearest, SearchError> {
    let start = (one.0.centre() - two.0.centre()).try_normalize(0.0).unwrap_or(Vector3::z());
    let mut normal = start;
    let (mut now, mut turning) = supports(one, two, &normal);
    let size = one.1.max().max(two.1.max());
    for _ in 0..MAX_STEPS {
        let gradient = across(&now, &normal);
        let misfit = gradient.norm();
        if misfit <= 1e-15 * size {
            break;
        }
        let step = invert_in_plane(&turning, now.gap.max(0.0), &normal)
            .map_or(gradient / size, |inverse| inverse * gradient);
        // A thin ellipsoid hardly moves its support points: Newton's step may be far too long.
        let mut share = (LONGEST_STEP / step.norm()).min(1.0);
        let smallest = 1e-9 * share;
        let better = loop {
            let next = (normal + step * share).normalize();
            let (trial, trial_turning) = supports(one, two, &next);
            // At rounding level only the tangential distance still shows progress.
            if trial.gap > now.gap || across(&trial, &next).norm() < 0.5 * misfit {
                break Some((next, trial, trial_turning));
            }
            share *= 0.5;
            if share < smallest {
                break None;
            }
        };
        let Some((next, trial, trial_turning)) = better else { break };
        (normal, now, turning) = (next, trial, trial_turning);
    }
    let misfit = across(&now, &normal).norm();
    if misfit <= 1e-9 * size { Ok(now) } else { Err(SearchError::NotConverged { misfit }) }
}
