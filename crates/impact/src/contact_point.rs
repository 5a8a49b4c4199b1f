//! Where two bodies touch: a search for the contact point.

use nalgebra::Vector3;

use crate::attitude::Attitude;
use crate::surface::{Kind, Surface, SurfaceError, invert_in_plane};

/// How far apart (or into each other) bodies that touch may be, over the smaller one's size.
pub const TOUCH_TOLERANCE: f64 = 1e-6;

const MAX_STEPS: usize = 200;

/// Why no contact point was found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SearchError {
    /// The bodies are apart, or overlap.
    #[error("the bodies do not touch: gap = {gap:e} (negative: overlap), allowed {allowed:e}")]
    NotTouching {
        /// Distance between the surfaces, negative if they overlap.
        gap: f64,
        /// The largest gap or overlap that counts as touch.
        allowed: f64,
    },
    /// One surface has no tangent plane or curvature where they touch.
    #[error("body {body}: {source}")]
    Surface {
        /// 1 or 2.
        body: u8,
        /// What is wrong there.
        source: SurfaceError,
    },
    /// No search is known for these two kinds of surface.
    #[error("no contact search for {one} and {two}: give the contact point")]
    NoSearch {
        /// Kind of body 1.
        one: &'static str,
        /// Kind of body 2.
        two: &'static str,
    },
    /// The search did not converge.
    #[error("the search for the contact point did not converge: misfit = {misfit:e}")]
    NotConverged {
        /// Distance between the nearest points across the normal.
        misfit: f64,
    },
}

/// A surface somewhere in space.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placed<'a> {
    pub(crate) surface: &'a Surface,
    pub(crate) centre: Vector3<f64>,
    pub(crate) attitude: Attitude,
}

/// The nearest points of two bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Nearest {
    /// On body 1 and on body 2.
    pub(crate) points: [Vector3<f64>; 2],
    pub(crate) gap: f64,
}

impl Nearest {
    fn exchanged(self) -> Self {
        Self { points: [self.points[1], self.points[0]], gap: self.gap }
    }
}

impl Placed<'_> {
    fn space_point(&self, in_body: &Vector3<f64>) -> Vector3<f64> {
        self.centre + self.attitude.to_space(in_body)
    }

    fn body_point(&self, in_space: &Vector3<f64>) -> Vector3<f64> {
        self.attitude.to_body(&(in_space - self.centre))
    }
}

/// The nearest points of two bodies, whichever of the known searches applies.
pub(crate) fn nearest(one: &Placed<'_>, two: &Placed<'_>) -> Result<Nearest, SearchError> {
    let no_search = SearchError::NoSearch { one: one.surface.name(), two: two.surface.name() };
    let ordered = rank(one.surface) <= rank(two.surface);
    let (first, second) = if ordered { (one, two) } else { (two, one) };
    let found = match first.surface.kind() {
        Kind::Sphere { .. } | Kind::Capsule { .. } | Kind::Cylinder { .. } => {
            rolled(first, second).ok_or(no_search)?
        }
        Kind::Plane => on_plane(first, second).ok_or(no_search)?,
        Kind::Box { half } => on_box(half, first, second).ok_or(no_search)?,
        _ => convex(first, second, no_search)?,
    };
    Ok(if ordered { found } else { found.exchanged() })
}

// Which of two bodies leads the search.
fn rank(surface: &Surface) -> u8 {
    match surface.kind() {
        Kind::Sphere { .. } => 0,
        Kind::Capsule { .. } => 1,
        Kind::Plane => 2,
        Kind::Cylinder { .. } => 3,
        Kind::Box { .. } => 4,
        _ => 5,
    }
}

// A sphere, or a sphere swept along a segment: the distance to a body, convex along the segment,
// is least where the normal is at right angles to it, or at an end.
fn rolled(swept: &Placed<'_>, other: &Placed<'_>) -> Option<Nearest> {
    let (half_length, radius) = swept.surface.core()?;
    let axis = swept.attitude.to_space(&Vector3::z());
    let at = |t: f64| other.surface.closest(&other.body_point(&(swept.centre + axis * t)));
    let slope = |t: f64| at(t).map(|c| other.attitude.to_space(&c.normal).dot(&axis));
    let t = if half_length == 0.0 {
        0.0
    } else if slope(-half_length)? > 0.0 {
        -half_length
    } else if slope(half_length)? < 0.0 {
        half_length
    } else {
        let (mut low, mut high) = (-half_length, half_length);
        for _ in 0..MAX_STEPS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            let rising = slope(middle)?;
            if rising == 0.0 {
                (low, high) = (middle, middle);
            } else if rising > 0.0 {
                high = middle;
            } else {
                low = middle;
            }
        }
        0.5 * (low + high)
    };
    let closest = at(t)?;
    let normal = other.attitude.to_space(&closest.normal);
    let own = swept.centre + axis * t - normal * radius;
    Some(Nearest {
        points: [own, other.space_point(&closest.point)],
        gap: closest.distance - radius,
    })
}

fn on_plane(plane: &Placed<'_>, other: &Placed<'_>) -> Option<Nearest> {
    let normal = plane.attitude.to_space(&Vector3::z());
    let lowest = match other.surface.core() {
        // A cylinder's lower end, or its middle where it lies flat.
        Some((half_length, radius)) => {
            let axis = other.attitude.to_space(&Vector3::z());
            let down = axis.dot(&normal);
            let end = if down == 0.0 { 0.0 } else { -half_length * down.signum() };
            let across = axis * down - normal;
            other.centre + axis * end + across.try_normalize(0.0).unwrap_or(-normal) * radius
        }
        None => {
            let direction = other.attitude.to_body(&-normal);
            other.space_point(&other.surface.support(&direction)?.point)
        }
    };
    let gap = (lowest - plane.centre).dot(&normal);
    Some(Nearest { points: [lowest - normal * gap, lowest], gap })
}

// The face that separates the most; where the other body reaches beyond it an edge is nearer.
fn on_box(half: &Vector3<f64>, cuboid: &Placed<'_>, other: &Placed<'_>) -> Option<Nearest> {
    let mut best: Option<Nearest> = None;
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let normal = cuboid.attitude.to_space(&Vector3::ith(axis, sign));
            let direction = other.attitude.to_body(&-normal);
            let lowest = other.space_point(&other.surface.support(&direction)?.point);
            let gap = (lowest - cuboid.centre).dot(&normal) - half[axis];
            if best.is_none_or(|b| gap > b.gap) {
                let foot = cuboid.body_point(&(lowest - normal * gap));
                let inside = foot.zip_map(half, |x, h| x.clamp(-h, h));
                best = Some(Nearest { points: [cuboid.space_point(&inside), lowest], gap });
            }
        }
    }
    best
}

// The separating direction n, from body 2 into body 1, that maximises the gap
// g(n) = n.(p_1(-n) - p_2(n)) of the supports: Newton's method on the sphere, where
// grad g = tangential part of p_1 - p_2 and hess g = -(W_1 + W_2) - g I.
fn convex(
    one: &Placed<'_>,
    two: &Placed<'_>,
    no_search: SearchError,
) -> Result<Nearest, SearchError> {
    let torus = |p: &Placed<'_>| matches!(p.surface.kind(), Kind::Torus { .. });
    if torus(one) || torus(two) {
        return Err(no_search);
    }
    let state = |n: &Vector3<f64>| {
        let p_1 = one.surface.support(&one.attitude.to_body(&-n))?;
        let p_2 = two.surface.support(&two.attitude.to_body(n))?;
        let points = [one.space_point(&p_1.point), two.space_point(&p_2.point)];
        let turn = |p: &Placed<'_>, w| p.attitude.matrix() * w * p.attitude.matrix().transpose();
        let turning = turn(one, p_1.turning) + turn(two, p_2.turning);
        Some((Nearest { points, gap: n.dot(&(points[0] - points[1])) }, turning))
    };
    let start = (one.centre - two.centre).try_normalize(0.0).unwrap_or(Vector3::z());
    let mut normal = start;
    let (mut now, mut turning) = state(&normal).ok_or(no_search)?;
    let size = one.surface.size().max(two.surface.size());
    let across = |near: &Nearest, n: &Vector3<f64>| {
        let off = near.points[0] - near.points[1];
        off - n * n.dot(&off)
    };
    for _ in 0..MAX_STEPS {
        let gradient = across(&now, &normal);
        let misfit = gradient.norm();
        if misfit <= 1e-15 * size {
            break;
        }
        let step = invert_in_plane(&turning, now.gap.max(0.0), &normal)
            .map_or(gradient / size, |inverse| inverse * gradient);
        let mut share = 1.0;
        let better = loop {
            let next = (normal + step * share).normalize();
            let (trial, trial_turning) =
                state(&next).ok_or(SearchError::NotConverged { misfit })?;
            // At the last digits only the misfit still tells better from worse.
            if trial.gap > now.gap || across(&trial, &next).norm() < 0.5 * misfit {
                break Some((next, trial, trial_turning));
            }
            share *= 0.5;
            if share < 1e-9 {
                break None;
            }
        };
        let Some((next, trial, trial_turning)) = better else { break };
        (normal, now, turning) = (next, trial, trial_turning);
    }
    let misfit = across(&now, &normal).norm();
    if misfit <= 1e-9 * size { Ok(now) } else { Err(SearchError::NotConverged { misfit }) }
}
