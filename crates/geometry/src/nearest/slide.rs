//! Minima of the signed distance between two smooth surfaces, from many starts.

use nalgebra::{Matrix3, Vector3};

use super::parts::Face;
use super::target::Target;
use super::{Nearest, Touch};
use crate::placed::Placed;
use crate::surface::{Closest, Kind, LocalSurface, Objective, support_of_ellipsoid};

/// Number of minima searched for.
const MINIMA: usize = 6;

/// Least distance between two starts, relative to the size of the body.
const LEAST_SPACING: f64 = 0.25;

/// A search has converged if the sine of the angle between the normals is below this.
const PARALLEL: f64 = 1e-8;

/// The minima of the distance between two smooth bodies.
pub(super) fn slide(body: &Target<'_>, other: &Target<'_>) -> Vec<Touch> {
    let place = |point: &Vector3<f64>| {
        let closest = other.closest(point)?;
        Some((closest, bend(&closest, &other.placed.local(&closest.point).ok()?)))
    };
    minima(body, &body.starts, other.size(), &place)
}

/// The minima of the height of a smooth body above a face, those above the face first.
pub(super) fn lower(body: &Target<'_>, face: &Face) -> Vec<Touch> {
    if let Kind::Ellipsoid { semi_axes } = body.kind() {
        let down = body.placed.attitude().to_body(&-face.normal);
        let lowest = support_of_ellipsoid(semi_axes, &down).point;
        return vec![face.under(&body.placed.space_point(&lowest))];
    }
    let place = |point: &Vector3<f64>| {
        let distance = face.normal.dot(&(point - face.centre));
        let foot = point - face.normal * distance;
        Some((Closest { point: foot, normal: face.normal, distance }, Matrix3::zeros()))
    };
    // Points beside the face do not count, however low they are.
    let over = |start: &&Vector3<f64>| {
        face.beside(&body.placed.space_point(start)) < LEAST_SPACING * body.size()
    };
    let next_to = |spot: &Vector3<f64>| Some(body.placed.body_point(&body.closest(spot)?.point));
    let nearest = face.spots().into_iter().filter_map(|spot| next_to(&spot));
    let starts: Vec<_> = body.starts.iter().filter(over).copied().chain(nearest).collect();
    let found = minima(body, &starts, body.size(), &place);
    found.iter().map(|touch| face.under(&touch.near.points[0])).collect()
}

// Second derivatives of the distance from a surface, S/(1 + distance S).
fn bend(closest: &Closest, local: &LocalSurface) -> Matrix3<f64> {
    let [k_1, k_2] = local.curvatures();
    let at = |k: f64| k / (1.0 + closest.distance * k).max(0.1);
    let (one, two) = (local.direction(), local.direction_across());
    one * one.transpose() * at(k_1) + two * two.transpose() * at(k_2)
}

type Place<'a> = dyn Fn(&Vector3<f64>) -> Option<(Closest, Matrix3<f64>)> + 'a;

fn minima(
    body: &Target<'_>,
    starts: &[Vector3<f64>],
    size_of_other: f64,
    place: &Place<'_>,
) -> Vec<Touch> {
    let noise = 1e-14 * (body.size() + size_of_other);
    let objective = |point: &Vector3<f64>| {
        let (closest, hessian) = place(&body.placed.space_point(point))?;
        Some(Objective {
            value: closest.distance,
            gradient: body.placed.attitude().to_body(&closest.normal),
            hessian: turned_back(body.placed, &hessian),
            noise,
        })
    };
    let follow = |start: &Vector3<f64>| {
        let least = body.placed.surface().least(start, 1e-15, objective)?;
        let point = body.placed.space_point(&least.local.point());
        let closest = place(&point)?.0;
        let near = Nearest { points: [point, closest.point], gap: closest.distance };
        (least.rest <= PARALLEL).then_some(Touch { near, within: true })
    };
    let height = |start: &Vector3<f64>| objective(start).map(|o| o.value);
    low_starts(starts, body.size(), height).iter().filter_map(follow).collect()
}

// The lowest starts that are not close to each other.
fn low_starts(
    starts: &[Vector3<f64>],
    size: f64,
    height: impl Fn(&Vector3<f64>) -> Option<f64>,
) -> Vec<Vector3<f64>> {
    let with_height = |start: &Vector3<f64>| Some((height(start)?, *start));
    let mut ranked: Vec<_> = starts.iter().filter_map(with_height).collect();
    ranked.sort_by(|one, two| one.0.total_cmp(&two.0));
    let mut chosen: Vec<Vector3<f64>> = Vec::new();
    for (_, start) in ranked {
        if chosen.iter().all(|other| (other - start).norm() > LEAST_SPACING * size) {
            chosen.push(start);
        }
        if chosen.len() == MINIMA {
            break;
        }
    }
    chosen
}

fn turned_back(placed: &Placed, in_space: &Matrix3<f64>) -> Matrix3<f64> {
    let turned = placed.attitude().matrix();
    turned.transpose() * in_space * turned
}
