//! The search for the nearest points and the contact point of two bodies.
//!
//! Spheres, capsules and tori are swept by a ball along a curve: the distance of the other body
//! from that curve is a function of one variable ([`scan`]). For two ellipsoids the separating
//! direction is found ([`separate`]). Other bodies are treated by [`parts`]: faces, curved sides
//! and edges; a smooth surface is moved down the distance function of the other body ([`slide`]).

pub(crate) mod approach;
mod parts;
mod scan;
mod separate;
mod slide;
mod support;
mod target;
mod touch;

use carom_special::RangeError;
use nalgebra::Vector3;

use crate::frame::FrameError;
use crate::placed::Placed;
use crate::surface::{Kind, SurfaceError};
use parts::Face;
use scan::Rail;
use target::Target;
use touch::{Nearest, Touch};

/// Why two surfaces have no contact point.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SearchError {
    /// The bodies are separated, or overlap.
    #[error("the bodies do not touch: gap = {gap:e} (negative: overlap), allowed {allowed:e}")]
    NotTouching {
        /// Distance between the surfaces, negative if they overlap.
        gap: f64,
        /// The largest gap or overlap that counts as contact.
        allowed: f64,
    },
    /// One surface has no tangent plane or no curvature at the contact point.
    #[error("body {body}: {source}")]
    Surface {
        /// 1 or 2.
        body: u8,
        /// The reason.
        source: SurfaceError,
    },
    /// The surfaces touch, but the contact is not elliptical.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// A position or attitude is out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// No search exists for these two kinds of surface.
    #[error("no contact search for {one} and {two}, since {why}: give the contact point")]
    NoSearch {
        /// Kind of body 1.
        one: &'static str,
        /// Kind of body 2.
        two: &'static str,
        /// The reason.
        why: &'static str,
    },
    /// No ray from the origin of an implicit surface meets it, or an explicit surface has no finite
    /// point near its origin.
    #[error(
        "body {body}: no point of its surface within 4 sizes = {reach} of its origin: check the \
         function and its size, or give the contact point"
    )]
    NoPoints {
        /// 1 or 2.
        body: u8,
        /// The distance searched.
        reach: f64,
    },
    /// The search did not converge.
    #[error("the search for the contact point did not converge: misfit = {misfit:e}")]
    NotConverged {
        /// Distance between the nearest points perpendicular to the normal.
        misfit: f64,
    },
    /// No search found a place where the surfaces face each other.
    #[error("no place found where the {one} and the {two} face each other: give the contact point")]
    NothingFound {
        /// Kind of body 1.
        one: &'static str,
        /// Kind of body 2.
        two: &'static str,
    },
}

/// Whether the nearest points found may be only a local minimum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Certainty {
    /// No other points are nearer: both bodies are convex, or one is a sphere and the other's
    /// distance function is known everywhere.
    Proven,
    /// The nearest of the local minima found from many starts. A body that may not be convex can be
    /// nearer elsewhere.
    Sampled,
}

/// The nearest points of two bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearestPoints {
    /// Nearest point of body 1 and of body 2, in space.
    pub points: [Vector3<f64>; 2],
    /// Distance between the points. It is negative if the bodies overlap: the depth of the overlap
    /// or, where an edge meets the other body, the depth of the edge inside it.
    pub gap: f64,
    /// Whether other points may be nearer.
    pub certainty: Certainty,
}

/// The nearest points of two bodies, in contact or not.
///
/// All pairs of spheres, ellipsoids, planes, cylinders, capsules, boxes, tori, implicit and
/// explicit surfaces are supported, with the exceptions below. A surface that may not be convex is
/// searched from many starts within four sizes of its origin, an explicit one also near the other
/// body.
///
/// ```
/// use carom_geometry::{Certainty, Placed, Surface, nearest_points};
/// let ring = Placed::new(Surface::torus(3.0, 0.5)?);
/// let ball = Placed::new(Surface::sphere(1.0)?).at([1.0, 0.0, 0.0])?;
/// let near = nearest_points(&ring, &ball)?;
/// assert!((near.gap - 0.5).abs() < 1e-15);
/// assert!((near.points[0].x - 2.5).abs() < 1e-15);
/// assert_eq!(near.certainty, Certainty::Proven);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`SearchError::NoSearch`] for two planes and for a surface given at one point,
/// [`SearchError::NoPoints`] for a function without a surface near its origin,
/// [`SearchError::NotConverged`] and [`SearchError::NothingFound`] if the search fails.
pub fn nearest_points(one: &Placed, two: &Placed) -> Result<NearestPoints, SearchError> {
    let origin = origin_of_search(one, two);
    let [one, two] = [one.seen_from(&origin), two.seen_from(&origin)];
    let Nearest { points, gap } = nearest(&one, &two)?;
    let points = points.map(|point| origin + point);
    Ok(NearestPoints { points, gap, certainty: certainty(&one, &two) })
}

/// The centre of the smaller body, used as origin of the search: then neither a distant position
/// nor a large other body reduces the accuracy of the contact point on it.
pub(crate) fn origin_of_search(one: &Placed, two: &Placed) -> Vector3<f64> {
    let sizes = [one, two].map(|placed| placed.surface().size());
    // A plane has no size.
    let first = sizes[1] == 0.0 || (sizes[0] > 0.0 && sizes[0] <= sizes[1]);
    if first { one.centre() } else { two.centre() }
}

fn certainty(one: &Placed, two: &Placed) -> Certainty {
    let unknown =
        |p: &Placed| matches!(p.surface().kind(), Kind::Implicit { .. } | Kind::Explicit { .. });
    let torus = |p: &Placed| matches!(p.surface().kind(), Kind::Torus { .. });
    let round = |p: &Placed| matches!(p.surface().kind(), Kind::Sphere { .. } | Kind::Plane);
    let hollow = (torus(one) && !round(two)) || (torus(two) && !round(one));
    if hollow || unknown(one) || unknown(two) { Certainty::Sampled } else { Certainty::Proven }
}

/// The nearest points of two bodies, by the search for their kinds.
pub(crate) fn nearest(one: &Placed, two: &Placed) -> Result<Nearest, SearchError> {
    searchable(one, two)?;
    if let (Kind::Ellipsoid { semi_axes: axes_1 }, Kind::Ellipsoid { semi_axes: axes_2 }) =
        (one.surface().kind(), two.surface().kind())
    {
        let found = separate::separate((one, axes_1), (two, axes_2));
        return apart_or_again(found, one, two);
    }
    let (target_1, target_2) = (prepared(one, 1)?, prepared(two, 2)?);
    let found = match (parts::swept(one), parts::swept(two)) {
        (Some(rail_1), Some(rail_2)) if rail_2.is_simpler_than(&rail_1) => {
            first(rail_2.scan(&target_1)).map(Nearest::exchanged)
        }
        (Some(rail), _) => first(rail.scan(&target_2)),
        (None, Some(rail)) => first(rail.scan(&target_1)).map(Nearest::exchanged),
        (None, None) => by_parts(&target_1, &target_2),
    };
    let (one, two) = (one.surface().name(), two.surface().name());
    found.ok_or(SearchError::NothingFound { one, two })
}

// A separating direction is its own proof. If none was found, the ellipsoids overlap, or they are
// so thin that the search failed: sliding one over the other decides. If they do not overlap, they
// face each other at one place only.
fn apart_or_again(
    found: Result<Nearest, SearchError>,
    one: &Placed,
    two: &Placed,
) -> Result<Nearest, SearchError> {
    let slack = 1e-12 * one.surface().size().min(two.surface().size());
    if found.is_ok_and(|near| near.gap >= -slack) {
        return found;
    }
    let (target_1, target_2) = (Target::new(one), Target::new(two));
    let mut touches = slide::slide(&target_1, &target_2);
    touches.extend(slide::slide(&target_2, &target_1).into_iter().map(Touch::exchanged));
    let facing = |near: &Nearest| {
        let normal = |body: &Placed, i: usize| Some(body.local(&near.points[i]).ok()?.normal());
        let normals = (normal(one, 0)?, normal(two, 1)?);
        Some(normals.0.dot(&normals.1) < 0.0)
    };
    let near = touches.into_iter().map(|touch| touch.near).filter(|n| facing(n) == Some(true));
    let best = near.chain(found.ok()).max_by(|a, b| a.gap.total_cmp(&b.gap));
    best.map_or(found, Ok)
}

fn searchable(one: &Placed, two: &Placed) -> Result<(), SearchError> {
    let why = match (one.surface().kind(), two.surface().kind()) {
        (Kind::Given { .. }, _) | (_, Kind::Given { .. }) => {
            "a surface given at one point is known nowhere else"
        }
        (Kind::Plane, Kind::Plane) => "two half-spaces have no single contact point",
        _ => return Ok(()),
    };
    Err(SearchError::NoSearch { one: one.surface().name(), two: two.surface().name(), why })
}

fn prepared<'a>(placed: &'a Placed, body: u8) -> Result<Target<'a>, SearchError> {
    let target = Target::new(placed);
    if target.is_smooth() && target.starts.is_empty() {
        return Err(SearchError::NoPoints { body, reach: 4.0 * target.size() });
    }
    Ok(target)
}

fn first(touches: Vec<Touch>) -> Option<Nearest> {
    touches.into_iter().map(|touch| touch.near).min_by(|a, b| a.gap.total_cmp(&b.gap))
}

/// Two bodies that are not swept by a ball: by faces, curved sides and smooth surfaces. Their edges
/// are used if none of these meet, or if the other body may have several nearest points.
fn by_parts(one: &Target<'_>, two: &Target<'_>) -> Option<Nearest> {
    let mut touches = of_first(one, two);
    touches.extend(of_first(two, one).into_iter().map(Touch::exchanged));
    for face in parts::faces(one.placed) {
        let onto = |other: &Face| face.onto(other);
        touches.extend(parts::faces(two.placed).iter().filter_map(onto));
    }
    touches.retain(|touch| touch.within);
    let convex = one.is_convex() && two.is_convex();
    if convex && !touches.is_empty() {
        // Every part contains its body, so that the greatest separation is the true one.
        return touches.into_iter().map(|t| t.near).max_by(|a, b| a.gap.total_cmp(&b.gap));
    }
    let along = |edges: Vec<Rail<'_>>, other: &Target<'_>| -> Vec<Touch> {
        edges.iter().flat_map(|edge| edge.scan(other)).collect()
    };
    touches.extend(along(parts::edges(one.placed), two));
    let exchanged = along(parts::edges(two.placed), one).into_iter().map(Touch::exchanged);
    touches.extend(exchanged);
    first(touches)
}

// Parts of body 1 against the whole of body 2, ordered as (1, 2).
fn of_first(one: &Target<'_>, two: &Target<'_>) -> Vec<Touch> {
    let mut touches = Vec::new();
    if one.is_smooth() && two.is_smooth() {
        touches.extend(slide::slide(one, two));
    }
    if two.is_smooth() {
        touches.extend(parts::faces(one.placed).iter().flat_map(|face| slide::lower(two, face)));
    }
    if let Some(side) = parts::side(one.placed) {
        touches.extend(side.scan(two));
    }
    touches
}
