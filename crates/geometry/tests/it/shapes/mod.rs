//! Surfaces with their parametrisations, and the distance between two by walking over both.

use carom_drawn::{Draw as _, Splitmix};
use carom_geometry::{Attitude, BodySide, Placed, Surface};
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

type Parametrisation = Arc<dyn Fn([f64; 3]) -> Vector3<f64> + Send + Sync>;

/// A surface and a map of three numbers onto it, or onto the solid with flat faces inside it: a
/// step along an edge is then one with a number at its bound. From 0 to 1 they reach all of it.
#[derive(Clone)]
pub(crate) struct Shape {
    pub(crate) name: &'static str,
    pub(crate) surface: Surface,
    pub(crate) point: Parametrisation,
}

fn shape(
    name: &'static str,
    surface: Surface,
    point: impl Fn(f64, f64) -> Vector3<f64> + Send + Sync + 'static,
) -> Shape {
    Shape { name, surface, point: Arc::new(move |[u, v, _]| point(u, v)) }
}

fn solid(
    name: &'static str,
    surface: Surface,
    point: impl Fn(f64, f64, f64) -> Vector3<f64> + Send + Sync + 'static,
) -> Shape {
    Shape { name, surface, point: Arc::new(move |[u, v, w]| point(u, v, w)) }
}

fn ray(u: f64, v: f64) -> Vector3<f64> {
    let (sin, cos) = (PI * v).sin_cos();
    let (s, c) = (TAU * u).sin_cos();
    Vector3::new(sin * c, sin * s, cos)
}

fn clamped(u: f64) -> f64 {
    u.clamp(0.0, 1.0)
}

// A profile (rim, c) turned about axis c.
fn turned(u: f64, rim: f64, c: f64) -> Vector3<f64> {
    let (sin, cos) = (TAU * u).sin_cos();
    Vector3::new(rim * cos, rim * sin, c)
}

pub(crate) fn sphere() -> Shape {
    shape("sphere", Surface::sphere(0.8).unwrap(), |u, v| ray(u, v) * 0.8)
}

pub(crate) fn ellipsoid() -> Shape {
    let axes = [1.5, 1.0, 0.6];
    let point = move |u, v| ray(u, v).component_mul(&Vector3::from(axes));
    shape("ellipsoid", Surface::ellipsoid(axes).unwrap(), point)
}

pub(crate) fn cylinder() -> Shape {
    let point = |u: f64, v: f64, w| {
        let across = Vector3::new(u - 0.5, v - 0.5, 0.0);
        let disc = across / (across.norm() / 0.5).max(1.0);
        disc + Vector3::z() * (1.2 * (2.0 * clamped(w) - 1.0))
    };
    solid("cylinder", Surface::cylinder(0.5, 2.4).unwrap(), point)
}

pub(crate) fn capsule() -> Shape {
    let point = |u, v: f64| {
        let arc = 0.5 * PI;
        let (angle, middle) = match clamped(v) * (2.0 * arc + 1.0) {
            s if s < arc => (s, 0.9),
            s if s < arc + 1.0 => (arc, 0.9 - 1.8 * (s - arc)),
            s => (s - 1.0, -0.9),
        };
        turned(u, 0.4 * angle.sin(), middle + 0.4 * angle.cos())
    };
    shape("capsule", Surface::capsule(0.4, 1.8).unwrap(), point)
}

pub(crate) fn cuboid() -> Shape {
    let point = |u, v, w| {
        let centred = Vector3::new(clamped(u), clamped(v), clamped(w)).add_scalar(-0.5);
        centred.component_mul(&Vector3::new(1.6, 1.2, 2.0))
    };
    solid("box", Surface::cuboid([1.6, 1.2, 2.0]).unwrap(), point)
}

pub(crate) fn torus() -> Shape {
    let point = |u, v: f64| {
        let (sin, cos) = (TAU * v).sin_cos();
        turned(u, 1.4 + 0.35 * cos, 0.35 * sin)
    };
    shape("torus", Surface::torus(1.4, 0.35).unwrap(), point)
}

/// A convex implicit surface: an ellipsoid written otherwise.
pub(crate) fn egg() -> Shape {
    let axes = Vector3::new(0.9, 1.3, 0.7);
    let surface = Surface::implicit(1.3, move |p| p.component_div(&axes).norm() - 1.0).unwrap();
    shape("implicit egg", surface, move |u, v| ray(u, v).component_mul(&axes))
}

/// An implicit surface with dents and three lobes.
pub(crate) fn clover() -> Shape {
    let radius =
        |d: &Vector3<f64>| 1.0 + 0.25 * (d.x * d.x * d.x - 3.0 * d.x * d.y * d.y) + 0.1 * d.z;
    let surface = Surface::implicit(1.2, move |p| {
        let length = p.norm();
        length - radius(&(p / length.max(1e-300)))
    });
    shape("implicit clover", surface.unwrap(), move |u, v| {
        let d = ray(u, v);
        d * radius(&d)
    })
}

/// A wavy floor.
pub(crate) fn waves() -> Shape {
    let height = |a: f64, b: f64| 0.2 * (1.3 * a).sin() * (0.9 * b).cos() + 0.02 * a * a;
    let surface = Surface::explicit(2.0, BodySide::Below, height).unwrap();
    shape("explicit waves", surface, move |u, v| {
        let (a, b) = (8.0 * u - 4.0, 8.0 * v - 4.0);
        Vector3::new(a, b, height(a, b))
    })
}

pub(crate) fn plane() -> Shape {
    shape("plane", Surface::plane(), |u, v| Vector3::new(12.0 * u - 6.0, 12.0 * v - 6.0, 0.0))
}

pub(crate) fn placed(shape: &Shape, centre: Vector3<f64>, attitude: Attitude) -> Placed {
    Placed::new(shape.surface.clone()).turned(attitude).at(centre.into()).unwrap()
}

/// The distance of two surfaces that lie apart, by a coarse net over both and a walk with ever
/// smaller random steps from the nearest pairs of it. No derivative, closest point or support.
pub(crate) fn walked_distance(one: (&Shape, &Placed), two: (&Shape, &Placed)) -> f64 {
    let at = |(shape, body): (&Shape, &Placed), place: [f64; 3]| {
        body.centre() + body.attitude().to_space(&(shape.point)(place))
    };
    let n = 20;
    let net = |pair| -> Vec<([f64; 3], Vector3<f64>)> {
        let place = |i: i32| (f64::from(i) + 0.5) / f64::from(n);
        let line = |i: i32| (0..n).flat_map(move |j| [0.0, 1.0].map(|w| [place(i), place(j), w]));
        (0..n).flat_map(line).map(|x| (x, at(pair, x))).collect()
    };
    let (net_1, net_2) = (net(one), net(two));
    let nearest = |(x, p): &([f64; 3], Vector3<f64>)| {
        let near = |q: &Vector3<f64>| (p - q).norm_squared();
        let best = net_2.iter().min_by(|a, b| near(&a.1).total_cmp(&near(&b.1))).unwrap();
        (near(&best.1), [*x, best.0])
    };
    let mut pairs: Vec<(f64, [[f64; 3]; 2])> = net_1.iter().map(nearest).collect();
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let distance = |x: &[[f64; 3]; 2]| (at(one, x[0]) - at(two, x[1])).norm();
    let walk = |start: &[[f64; 3]; 2]| {
        let (mut x, mut best, mut step) = (*start, distance(start), 0.5 / f64::from(n));
        let (mut numbers, mut failures) = (Splitmix(7), 0);
        while step > 1e-9 {
            let mut y = x;
            for value in y.iter_mut().flatten() {
                *value += step * numbers.between(-1.0, 1.0);
            }
            let trial = distance(&y);
            if trial < best {
                (x, best, failures) = (y, trial, 0);
                step *= 1.2;
            } else {
                failures += 1;
                if failures > 40 {
                    (step, failures) = (0.7 * step, 0);
                }
            }
        }
        best
    };
    pairs.iter().step_by(9).take(5).map(|(_, x)| walk(x)).fold(f64::INFINITY, f64::min)
}
