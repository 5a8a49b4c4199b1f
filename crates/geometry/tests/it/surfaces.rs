//! Curvatures of surfaces compared with the same shapes given as functions, and contacts that
//! depend on them.

use crate::random::{attitude, direction};
use carom_drawn::{Draw as _, Splitmix};
use carom_geometry::curvature::CurvatureError;
use carom_geometry::{
    Attitude, BodySide, ContactPoint, FrameError, Height, Placed, SearchError, Surface,
    SurfaceError,
};
use nalgebra::Vector3;

// Both surfaces agree at the point of the first one next to `near`.
fn same(exact: &Surface, own: &Surface, point: &Vector3<f64>) {
    let (one, two) = (exact.local(point).unwrap(), own.local(point).unwrap());
    let name = exact.name();
    assert!((one.normal() - two.normal()).norm() < 1e-9, "{name}");
    let scale = one.curvatures()[0].abs();
    assert!((one.shape_operator() - two.shape_operator()).amax() < 1e-7 * scale, "{name}");
    for (k, l) in one.curvatures().iter().zip(two.curvatures()) {
        assert!((k - l).abs() < 1e-7 * scale, "{name} {k} {l}");
    }
}

#[test]
fn shapes_are_what_their_functions_say() {
    let mut numbers = Splitmix(8);
    let own = |f: fn(&Vector3<f64>) -> f64| Surface::implicit(1.0, f).unwrap();
    let torus = Surface::torus(2.0, 0.7).unwrap();
    let torus_function = own(|p| (p.xy().norm() - 2.0).hypot(p.z) - 0.7);
    let cylinder = Surface::cylinder(0.7, 4.0).unwrap();
    let cylinder_function = own(|p| p.xy().norm() - 0.7);
    let capsule = Surface::capsule(0.7, 4.0).unwrap();
    let cap_function = own(|p| (p - Vector3::z() * 2.0).norm() - 0.7);
    let sphere = Surface::sphere(0.7).unwrap();
    let sphere_function = own(|p| p.norm_squared() - 0.49);
    for _ in 0..100 {
        let (u, v) = (numbers.between(-3.1, 3.1), numbers.between(-3.1, 3.1));
        let around = Vector3::new(u.cos(), u.sin(), 0.0);
        // Outside, inside and on top of the tube.
        let on_tube = around * (2.0 + 0.7 * v.cos()) + Vector3::z() * (0.7 * v.sin());
        same(&torus, &torus_function, &on_tube);
        // The same anywhere in space.
        let (turn, centre) = (attitude(&mut numbers), direction(&mut numbers));
        let local = torus.local(&on_tube).unwrap();
        let placed = local.placed(&centre, &turn);
        assert!((placed.point() - centre - turn.to_space(&on_tube)).norm() < 1e-15);
        let shape = turn.matrix() * local.shape_operator() * turn.matrix().transpose();
        assert!((placed.shape_operator() - shape).amax() < 1e-14);
        let on_side = around * 0.7 + Vector3::z() * numbers.between(-1.9, 1.9);
        same(&cylinder, &cylinder_function, &on_side);
        same(&capsule, &cylinder_function, &on_side);
        let outward = direction(&mut numbers);
        same(&sphere, &sphere_function, &(outward * 0.7));
        let upward = Vector3::new(outward.x, outward.y, outward.z.abs().max(0.05)).normalize();
        same(&capsule, &cap_function, &(upward * 0.7 + Vector3::z() * 2.0));
    }
    // Flat ends and faces.
    let lid = cylinder.local(&Vector3::new(0.3, 0.1, -2.0)).unwrap();
    assert_eq!((lid.normal(), lid.curvatures()), (-Vector3::z(), [0.0; 2]));
    let cube = Surface::cuboid([2.0, 3.0, 4.0]).unwrap();
    let face = cube.local(&Vector3::new(0.3, -1.5, 1.0)).unwrap();
    assert_eq!((face.normal(), face.curvatures()), (-Vector3::y(), [0.0; 2]));
    // Where there is no tangent plane or no curvature.
    let part = |surface: &Surface, point: [f64; 3]| match surface.local(&point.into()) {
        Err(SurfaceError::Edge { part } | SurfaceError::Seam { part }) => part,
        other => panic!("{other:?}"),
    };
    assert_eq!(part(&cube, [1.0, -1.5, 0.3]), "the edge of a box");
    assert_eq!(part(&cube, [1.0, -1.5, 2.0]), "the corner of a box");
    assert_eq!(part(&cylinder, [0.7, 0.0, 2.0]), "the edge of a cylinder");
    assert_eq!(part(&capsule, [0.7, 0.0, 2.0]), "the seam of side and end of a capsule");
}

fn body(surface: Surface, centre: [f64; 3]) -> Placed {
    Placed::new(surface).at(centre).unwrap()
}

#[test]
fn two_explicit_surfaces_touch() {
    // a^2 + b^2/2 turned about c by 0.4 on -(a^2 + b^2) + 0.3 a^3, both with their vertex at zero.
    let upper = |p: &[f64; 2]| Height {
        c: p[0] * p[0] + 0.5 * p[1] * p[1],
        c_a: 2.0 * p[0],
        c_b: p[1],
        c_aa: 2.0,
        c_bb: 1.0,
        c_ab: 0.0,
    };
    let lower = |a: f64, b: f64| 0.3 * a * a * a - a * a - b * b;
    let turn = Attitude::about([0.0, 0.0, 1.0], 0.4).unwrap();
    let one = body(Surface::explicit_with(1.0, BodySide::Above, upper).unwrap(), [0.1, 0.2, 3.0]);
    let two = body(Surface::explicit(1.0, BodySide::Below, lower).unwrap(), [0.1, 0.2, 3.0]);
    let contact = ContactPoint::find(&one.turned(turn), &two).unwrap();
    assert!((contact.point() - Vector3::new(0.1, 0.2, 3.0)).norm() < 1e-9);
    let gap = contact.frame().relative_curvature();
    assert!((gap.a() - 2.0).abs() < 1e-8 && (gap.b() - 1.5).abs() < 1e-8);
    assert!(contact.frame().x().dot(&turn.to_space(&Vector3::x())).abs() > 1.0 - 1e-12);
}

#[test]
fn a_ball_in_a_bowl_and_in_a_tighter_one() {
    let bowl = |radius: f64| {
        let depth = move |a: f64, b: f64| -(radius * radius - a * a - b * b).sqrt();
        body(Surface::explicit(radius, BodySide::Below, depth).unwrap(), [0.0; 3])
    };
    // A ball of radius 0.6 on the wall of a bowl of radius 1, 50 degrees up.
    let (sin, cos) = 50_f64.to_radians().sin_cos();
    let out = Vector3::new(0.6 * sin, 0.8 * sin, -cos);
    let ball = |radius: f64, at: Vector3<f64>| body(Surface::sphere(radius).unwrap(), at.into());
    let contact = ContactPoint::find(&ball(0.6, out * 0.4), &bowl(1.0)).unwrap();
    // Differences of the steep wall: 2e-9 are measured.
    assert!((contact.point() - out).norm() < 1e-8);
    assert!((contact.frame().z() + out).norm() < 1e-8);
    let gap = contact.frame().relative_curvature();
    let expected = 0.5 * (1.0 / 0.6 - 1.0);
    assert!((gap.a() - expected).abs() < 1e-7 && (gap.b() - expected).abs() < 1e-7);
    // One that fits.
    let at = [0.0, 0.0, -1.0];
    let fit = ContactPoint::at(&ball(1.1, Vector3::z() * 0.1), &bowl(1.0), at);
    assert!(matches!(
        fit,
        Err(SearchError::Frame(FrameError::Curvature(CurvatureError::Conforming { .. })))
    ));
}

#[test]
fn rings_that_lie_flat_touch_along_a_circle() {
    let ring = |height: f64| body(Surface::torus(2.0, 0.5).unwrap(), [0.3, 0.1, height]);
    let along_circle = |found: Result<ContactPoint, SearchError>| {
        matches!(
            found,
            Err(SearchError::Frame(FrameError::Curvature(CurvatureError::LineContact { .. })))
        )
    };
    let plane = Placed::new(Surface::plane());
    assert!(along_circle(ContactPoint::find(&ring(0.5), &plane)));
    assert!(along_circle(ContactPoint::find(&ring(1.5), &ring(0.5))));
    let above = ContactPoint::find(&ring(0.75), &plane).unwrap_err();
    let SearchError::NotTouching { gap, allowed } = above else { panic!("{above}") };
    assert!(gap == 0.25 && (allowed - 2.5e-6).abs() < 1e-20);
}
