//! The search for the nearest points of two bodies, compared with scans of both surfaces, closed
//! forms and rigid motions.

use crate::random::{attitude, direction};
use crate::shapes::*;
use carom_drawn::{Draw as _, Splitmix};
use carom_geometry::curvature::{CurvatureError, PrincipalRadii};
use carom_geometry::{
    Attitude, BodySide, Certainty, ContactPoint, FrameError, NearestPoints, Placed, SearchError,
    Surface, SurfaceError, nearest_points,
};
use nalgebra::Vector3;

// Two bodies in any attitude, 0.05 apart.
fn apart(one: &Shape, two: &Shape, numbers: &mut Splitmix) -> [Placed; 2] {
    let floor = |shape: &Shape| matches!(shape.name, "plane" | "explicit waves");
    let up = Attitude::about([1.0, 0.4, 0.0], numbers.between(-0.3, 0.3)).unwrap();
    let attitude = |shape: &Shape, numbers: &mut Splitmix| {
        if floor(shape) { up } else { attitude(numbers) }
    };
    let (turn_1, turn_2) = (attitude(one, numbers), attitude(two, numbers));
    let away = if floor(one) {
        -up.to_space(&Vector3::z())
    } else if floor(two) {
        up.to_space(&Vector3::z())
    } else {
        direction(numbers)
    };
    let body_2 = placed(two, Vector3::new(0.3, -0.2, 0.1), turn_2);
    let far = placed(one, away * 5.0, turn_1);
    let near = nearest_points(&far, &body_2).unwrap();
    let shift = (near.points[1] - near.points[0]) * (1.0 - 0.05 / near.gap);
    [placed(one, away * 5.0 + shift, turn_1), body_2]
}

fn moved(body: &Placed, turn: &Attitude, shift: &Vector3<f64>) -> Placed {
    let turned = turn.matrix() * body.attitude().matrix();
    let attitude = Attitude::from_matrix(turned.transpose()).unwrap();
    let centre = turn.to_space(&body.centre()) + shift;
    body.clone().turned(attitude).at(centre.into()).unwrap()
}

fn check_pair(one: &Shape, two: &Shape, numbers: &mut Splitmix) {
    let bodies = apart(one, two, numbers);
    let near = nearest_points(&bodies[0], &bodies[1]).unwrap();
    let names = [one.name, two.name];
    let walked = walked_distance((one, &bodies[0]), (two, &bodies[1]));
    assert!((near.gap - walked).abs() < 1e-10, "{names:?} {} {walked}", near.gap);
    // Both points lie on their surfaces, that far apart.
    let off = near.points[0] - near.points[1];
    assert!((off.norm() - near.gap).abs() < 1e-14, "{names:?}");
    for (body, point) in bodies.iter().zip(&near.points) {
        let own = body.attitude().to_body(&(point - body.centre()));
        match body.surface().local(&own) {
            Ok(local) => {
                let normal = body.attitude().to_space(&local.normal());
                assert!(normal.cross(&off).norm() < 1e-8 * off.norm(), "{names:?}");
            }
            Err(error) => assert!(
                matches!(error, SurfaceError::Edge { .. } | SurfaceError::Seam { .. }),
                "{names:?} {error}"
            ),
        }
    }
    let swapped = nearest_points(&bodies[1], &bodies[0]).unwrap();
    assert_same(&near, [swapped.points[1], swapped.points[0]], swapped.gap, names);
    assert_eq!(near.certainty, swapped.certainty);
    // Both moved alike.
    let (turn, shift) = (attitude(numbers), direction(numbers) * 3.0);
    let [body_1, body_2] = bodies.map(|body| moved(&body, &turn, &shift));
    let elsewhere = nearest_points(&body_1, &body_2).unwrap();
    let back = elsewhere.points.map(|p| turn.matrix().tr_mul(&(p - shift)));
    assert_same(&near, back, elsewhere.gap, names);
}

fn assert_same(near: &NearestPoints, points: [Vector3<f64>; 2], gap: f64, names: [&str; 2]) {
    assert!((near.gap - gap).abs() < 1e-13, "{names:?} {:e}", near.gap - gap);
    for (own, other) in near.points.iter().zip(&points) {
        assert!((own - other).norm() < 1e-7, "{names:?} {:e}", (own - other).norm());
    }
}

fn convex() -> Vec<Shape> {
    vec![sphere(), ellipsoid(), cylinder(), capsule(), cuboid(), plane()]
}

fn others() -> Vec<Shape> {
    vec![torus(), egg(), clover(), waves()]
}

#[test]
fn convex_bodies() {
    let mut numbers = Splitmix(1);
    let kinds = convex();
    for (i, one) in kinds.iter().enumerate() {
        for two in kinds[i..].iter().filter(|two| (one.name, two.name) != ("plane", "plane")) {
            for _ in 0..2 {
                check_pair(one, two, &mut numbers);
            }
        }
    }
}

#[test]
fn a_crest_under_the_middle_of_a_face() {
    // Waves that rise higher beside the face than under it.
    for seed in [1_409_582, 5_519_543, 6_944_963, 7_673_511] {
        check_pair(&waves(), &cuboid(), &mut Splitmix(seed));
    }
}

#[test]
fn bodies_that_need_not_be_convex() {
    let mut numbers = Splitmix(2);
    let kinds: Vec<Shape> = convex().into_iter().chain(others()).collect();
    for (i, one) in others().iter().enumerate() {
        for two in &kinds[..=convex().len() + i] {
            if (one.name, two.name) != ("explicit waves", "explicit waves")
                && (one.name, two.name) != ("explicit waves", "plane")
            {
                check_pair(one, two, &mut numbers);
            }
        }
    }
}

fn body(surface: Surface, centre: [f64; 3]) -> Placed {
    Placed::new(surface).at(centre).unwrap()
}

fn flat() -> Placed {
    Placed::new(Surface::plane())
}

fn gap(one: &Placed, two: &Placed) -> f64 {
    nearest_points(one, two).unwrap().gap
}

#[test]
fn tori_in_closed_form() {
    let ring = |centre| body(Surface::torus(2.0, 0.3).unwrap(), centre);
    // BodySide by side in a plane.
    assert!((gap(&ring([5.0, 0.0, 0.0]), &ring([0.0; 3])) - 0.4).abs() < 1e-14);
    // Linked: each circle runs through the centre of the other, 2 from its rim.
    let turn = Attitude::about([1.0, 0.0, 0.0], std::f64::consts::FRAC_PI_2).unwrap();
    let link = ring([2.0, 0.0, 0.0]).turned(turn);
    assert!((gap(&link, &ring([0.0; 3])) - 1.4).abs() < 1e-14);
    // One above the other they come near along a circle.
    let stacked = nearest_points(&ring([0.0, 0.0, 1.0]), &ring([0.0; 3])).unwrap();
    assert!((stacked.gap - 0.4).abs() < 1e-14);
    assert_eq!(stacked.certainty, Certainty::Sampled);
    // A ball and an ellipsoid inside, off the centre; the ellipsoid's long end points outward.
    let ball = body(Surface::sphere(0.5).unwrap(), [0.0, -0.9, 0.0]);
    let inside = nearest_points(&ball, &ring([0.0; 3])).unwrap();
    assert!((inside.gap - 0.3).abs() < 1e-15 && inside.certainty == Certainty::Proven);
    let egg = body(Surface::ellipsoid([0.8, 0.4, 0.4]).unwrap(), [0.7, 0.0, 0.0]);
    assert!((gap(&egg, &ring([0.0; 3])) - 0.2).abs() < 1e-15);
    // A rod through the hole, tilted: distance of its axis from the tube's circle.
    let tilt = Attitude::about([0.0, 1.0, 0.0], 0.3).unwrap();
    let rod = body(Surface::cylinder(0.4, 6.0).unwrap(), [0.0; 3]).turned(tilt);
    assert!((gap(&rod, &ring([0.0; 3])) - (2.0 * 0.3_f64.cos() - 0.7)).abs() < 1e-14);
}

#[test]
fn a_touching_ellipsoid_inside_a_torus_makes_a_contact() {
    let ring = body(Surface::torus(2.0, 0.3).unwrap(), [0.0; 3]);
    let egg = body(Surface::ellipsoid([0.8, 0.6, 0.4]).unwrap(), [0.9, 0.0, 0.0]);
    let contact = ContactPoint::find(&egg, &ring).unwrap();
    assert!((contact.point() - Vector3::x() * 1.7).norm() < 1e-12);
    // k = A/C^2 + 1/r along c, A/B^2 - 1/(R - r) along b.
    let curvature = contact.frame().relative_curvature();
    assert!((2.0 * curvature.a() - (5.0 + 1.0 / 0.3)).abs() < 1e-12);
    assert!((2.0 * curvature.b() - (0.8 / 0.36 - 1.0 / 1.7)).abs() < 1e-12);
    // One that fits the hole conforms.
    let ring = body(Surface::torus(2.0, 0.3).unwrap(), [0.0; 3]);
    let fit = body(Surface::ellipsoid([1.7, 1.7, 0.4]).unwrap(), [0.0; 3]);
    let fit = ContactPoint::at(&fit, &ring, [1.7, 0.0, 0.0]).unwrap_err();
    assert!(matches!(fit, SearchError::Frame(FrameError::Curvature(_))), "{fit}");
}

#[test]
fn planes_rest_on_hollow_and_wavy_surfaces() {
    // The torus as an implicit surface and as itself.
    let round = |p: &Vector3<f64>| (p.xy().norm() - 2.0).hypot(p.z) - 0.5;
    let tilt = Attitude::about([1.0, 0.3, 0.2], 0.6).unwrap();
    let lift = |surface| body(surface, [0.3, 0.1, 4.0]).turned(tilt);
    let plane = flat();
    let exact = nearest_points(&lift(Surface::torus(2.0, 0.5).unwrap()), &plane).unwrap();
    let own = nearest_points(&lift(Surface::implicit(2.5, round).unwrap()), &plane).unwrap();
    let sin = tilt.to_body(&Vector3::z()).xy().norm();
    assert!((exact.gap - (3.5 - 2.0 * sin)).abs() < 1e-14);
    assert!((own.gap - exact.gap).abs() < 1e-12);
    assert!((own.points[0] - exact.points[0]).norm() < 1e-8);
    assert_eq!((exact.certainty, own.certainty), (Certainty::Proven, Certainty::Sampled));
    // Two bumps on a lower face, the second one deeper: found, with a ball on the first.
    let bumps = |a: f64, b: f64| {
        let bump = |x: f64, depth: f64| depth * (-4.0 * ((a - x).powi(2) + b * b)).exp();
        0.05 * (a * a + b * b) - bump(-1.0, 0.4) - bump(1.0, 0.5)
    };
    let bumpy = || Surface::explicit(1.0, BodySide::Above, bumps).unwrap();
    let near = nearest_points(&body(bumpy(), [0.0, 0.0, 2.0]), &plane).unwrap();
    // Where dc/da = 0 next to a = 1.
    let (mut low, mut high) = (0.9_f64, 1.1);
    for _ in 0..60 {
        let a = 0.5 * (low + high);
        let slope = 0.1 * a
            + 8.0 * (a - 1.0) * 0.5 * (-4.0 * (a - 1.0).powi(2)).exp()
            + 8.0 * (a + 1.0) * 0.4 * (-4.0 * (a + 1.0).powi(2)).exp();
        if slope > 0.0 { high = a } else { low = a }
    }
    assert!((near.gap - (2.0 + bumps(low, 0.0))).abs() < 1e-12, "{}", near.gap);
    assert!((near.points[0].x - low).abs() < 1e-8);
    let ball = body(Surface::sphere(0.2).unwrap(), [-1.0, 0.0, 0.0]);
    let above = nearest_points(&body(bumpy(), [0.0, 0.0, 2.0]), &ball).unwrap();
    assert!(above.points[0].x < -0.9 && above.gap < 2.0 - 0.2 - 0.35 + 0.06);
}

#[test]
fn what_touches_is_found_to_touch() {
    let mut numbers = Splitmix(3);
    let kinds: Vec<Shape> = convex().into_iter().chain(others()).collect();
    let mut made = 0;
    for (i, one) in kinds.iter().enumerate() {
        for two in &kinds[i + 1..] {
            if (one.name, two.name) == ("plane", "explicit waves") {
                continue;
            }
            let [body_1, body_2] = apart(one, two, &mut numbers);
            let near = nearest_points(&body_1, &body_2).unwrap();
            let shift = near.points[1] - near.points[0];
            let at =
                |share: f64| body_1.clone().at((body_1.centre() + shift * share).into()).unwrap();
            let names = [one.name, two.name];
            // Just touching, and a little into each other.
            let touching = nearest_points(&at(1.0), &body_2).unwrap();
            assert!(touching.gap.abs() < 1e-13, "{names:?} {:e}", touching.gap);
            let over = nearest_points(&at(1.0 + 2e-6), &body_2).unwrap();
            match ContactPoint::find(&at(1.0), &body_2) {
                Ok(contact) => {
                    made += 1;
                    assert!((over.gap + 1e-7).abs() < 2e-12, "{names:?} {:e}", over.gap);
                    assert!((contact.point() - near.points[1]).norm() < 1e-7, "{names:?}");
                    assert!(contact.frame().z().dot(&shift) < 0.0);
                }
                Err(SearchError::Surface { source, .. }) => {
                    // An edge may be less deep in the other body than it was pushed.
                    assert!(over.gap < -1e-8 && over.gap > -1.0001e-7, "{names:?} {:e}", over.gap);
                    let edge =
                        matches!(source, SurfaceError::Edge { .. } | SurfaceError::Seam { .. });
                    assert!(edge, "{names:?} {source}");
                }
                Err(error) => panic!("{names:?} {error}"),
            }
        }
    }
    assert!(made >= 20, "{made}");
}

#[test]
fn the_unit_of_length_does_not_matter() {
    for unit in [1.0 / 1024.0, 4096.0] {
        let pairs = |s: f64| {
            let clover = move |p: &Vector3<f64>| {
                let (length, d) = (p.norm() / s, p.normalize());
                length - 1.0 - 0.25 * (d.x * d.x * d.x - 3.0 * d.x * d.y * d.y)
            };
            let clover = || Surface::implicit(1.2 * s, clover).unwrap();
            let wave = move |a: f64, b: f64| 0.2 * s * (1.3 * a / s).sin() * (0.9 * b / s).cos();
            let wave = Surface::explicit(2.0 * s, BodySide::Below, wave).unwrap();
            let egg = || Surface::ellipsoid([1.5, 1.0, 0.6].map(|x| x * s)).unwrap();
            let at = |surface, centre: [f64; 3]| {
                let tilt = Attitude::about([0.3, 1.0, -0.2], 0.8).unwrap();
                body(surface, centre.map(|x| x * s)).turned(tilt)
            };
            let torus = Surface::torus(1.4 * s, 0.35 * s).unwrap();
            let cube = Surface::cuboid([s, s, s]).unwrap();
            let rod = Surface::cylinder(0.5 * s, 2.0 * s).unwrap();
            [
                (at(egg(), [0.3, 0.2, 2.5]), at(clover(), [0.0; 3])),
                (at(egg(), [0.3, 0.2, 2.5]), body(wave, [0.0; 3])),
                (at(torus, [0.3, 0.2, 3.5]), at(clover(), [0.0; 3])),
                (at(cube, [0.3, 0.2, 2.5]), at(egg(), [0.0; 3])),
                (at(rod, [1.3, 2.2, 0.5]), body(clover(), [0.0; 3])),
            ]
        };
        for ((one, two), (small_1, small_2)) in pairs(1.0).iter().zip(&pairs(unit)) {
            let (near, small) = (gap(one, two), gap(small_1, small_2));
            assert!(near > 0.1 && (near - small / unit).abs() < 1e-13, "{near} {small}");
        }
    }
}

// Needles and discs, semi-axes apart by factors up to 1e4: they touch at the origin by their
// supports, so that the gap is none.
#[test]
fn thin_ellipsoids_are_not_lost() {
    let mut numbers = Splitmix(11);
    for _ in 0..1000 {
        let normal = direction(&mut numbers);
        let [one, two] = [-normal, normal].map(|outward| {
            let axes = [(); 3].map(|()| 10_f64.powf(numbers.between(-2.0, 2.0)));
            let turn = attitude(&mut numbers);
            let scaled = Vector3::from(axes).component_mul(&turn.to_body(&outward));
            let support = turn.to_space(&Vector3::from(axes).component_mul(&scaled));
            let centre = -support / scaled.norm();
            body(Surface::ellipsoid(axes).unwrap(), centre.into()).turned(turn)
        });
        let near = nearest_points(&one, &two).unwrap();
        let size = one.surface().size().min(two.surface().size());
        assert!(near.gap.abs() < 1e-10 * size, "{near:?} {one:?} {two:?}");
        assert!(near.points[0].norm() < 1e-8 * size, "{near:?} {one:?} {two:?}");
    }
}

#[test]
fn cylinders_touch_with_side_lid_and_edge() {
    let rod = |centre| body(Surface::cylinder(0.5, 2.0).unwrap(), centre);
    let egg = |centre| body(Surface::ellipsoid([1.0, 0.8, 0.6]).unwrap(), centre);
    let find = |one: Placed, two: Placed| ContactPoint::find(&one, &two);
    // On the side of a standing cylinder, beyond the middle.
    let side = find(egg([1.5, 0.0, 0.7]), rod([0.0; 3])).unwrap();
    assert!((side.point() - Vector3::new(0.5, 0.0, 0.7)).norm() < 1e-14);
    // On its lid: the ellipsoid's own curvatures.
    let lid = find(egg([0.1, 0.2, 1.6]), rod([0.0; 3])).unwrap();
    assert!((lid.point() - Vector3::new(0.1, 0.2, 1.0)).norm() < 1e-14);
    assert!((2.0 * lid.frame().relative_curvature().a() - 0.6 / 0.64).abs() < 1e-14);
    // On its edge: where the gradient of the ellipsoid points down and inward alike.
    let edge = Vector3::new(0.5, 0.0, 1.0);
    let tip = Vector3::new(-1.0, 0.0, -0.6) * 0.5_f64.sqrt();
    let refused = find(egg((edge - tip).into()), rod([0.0; 3])).unwrap_err();
    let at_edge = |error: &SearchError, own: u8| {
        matches!(
            error,
            SearchError::Surface {
                body,
                source: SurfaceError::Edge { part: "the edge of a cylinder" },
            } if *body == own
        )
    };
    assert!(at_edge(&refused, 2), "{refused}");
    // Two crossed, side on side, and a third of the way along one; a lid on a side.
    let lying = Attitude::about([0.0, 1.0, 0.0], std::f64::consts::FRAC_PI_2).unwrap();
    let crossed = find(rod([0.3, 1.0, -0.4]), rod([0.0; 3]).turned(lying)).unwrap();
    assert!((crossed.point() - Vector3::new(0.3, 0.5, 0.0)).norm() < 1e-14);
    // Flat on a plane along a line, standing on an area, tilted on an edge.
    let plane = || flat();
    let line = find(rod([0.0, 0.0, 0.5]).turned(lying), plane()).unwrap_err();
    let kind = |error: &SearchError| match error {
        SearchError::Frame(FrameError::Curvature(source)) => *source,
        other => panic!("{other}"),
    };
    assert!(matches!(kind(&line), CurvatureError::LineContact { .. }), "{line}");
    let standing = find(rod([0.3, 0.0, 1.0]), plane()).unwrap_err();
    assert!(matches!(kind(&standing), CurvatureError::LineContact { .. }), "{standing}");
    let tilt = Attitude::about([0.0, 1.0, 0.0], 0.3).unwrap();
    let height = 0.3_f64.cos() + 0.5 * 0.3_f64.sin();
    let tilted = find(rod([0.0, 0.0, height]).turned(tilt), plane()).unwrap_err();
    assert!(at_edge(&tilted, 1), "{tilted}");
    // A box on a box: face on face, and beside it nothing.
    let cube = |centre| body(Surface::cuboid([1.0, 1.0, 1.0]).unwrap(), centre);
    let stacked = find(cube([0.3, 0.4, 1.0]), cube([0.0; 3])).unwrap_err();
    assert!(matches!(kind(&stacked), CurvatureError::LineContact { .. }), "{stacked}");
    assert!((gap(&cube([1.3, 1.4, 0.0]), &cube([0.0; 3])) - 0.5).abs() < 1e-15);
}

#[test]
fn what_cannot_be_searched_says_why() {
    let radii = PrincipalRadii::sphere(1.0).unwrap();
    let known = Surface::given([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], radii).unwrap();
    let ball = || body(Surface::sphere(1.0).unwrap(), [0.0, 0.0, 1.0]);
    let error = nearest_points(&ball(), &body(known, [0.0; 3])).unwrap_err();
    assert!(matches!(error, SearchError::NoSearch { one: "sphere", .. }));
    assert!(error.to_string().ends_with("known nowhere else: give the contact point"), "{error}");
    let planes = nearest_points(&flat(), &flat());
    assert!(matches!(planes, Err(SearchError::NoSearch { one: "plane", two: "plane", .. })));
    // No surface at all, and one out of reach.
    let nothing = Surface::implicit(1.0, |p| p.norm_squared() + 1.0).unwrap();
    let error = nearest_points(&ball(), &body(nothing, [0.0; 3])).unwrap_err();
    assert_eq!(error, SearchError::NoPoints { body: 2, reach: 4.0 });
    let far = Surface::implicit(1.0, |p| (p - Vector3::x() * 30.0).norm() - 1.0).unwrap();
    let error = nearest_points(&body(far, [0.0; 3]), &ball()).unwrap_err();
    assert_eq!(error, SearchError::NoPoints { body: 1, reach: 4.0 });
    let nan = Surface::explicit(1.0, BodySide::Above, |_, _| f64::NAN).unwrap();
    assert!(matches!(
        nearest_points(&body(nan, [0.0; 3]), &ball()),
        Err(SearchError::NoPoints { body: 1, .. })
    ));
    // A slope that falls for ever has no lowest point.
    let slope = Surface::explicit(1.0, BodySide::Above, |a, _| 0.3 * a).unwrap();
    let error = nearest_points(&body(slope, [0.0; 3]), &flat()).unwrap_err();
    assert!(matches!(error, SearchError::NothingFound { one: "explicit surface", .. }));
}

/// Bodies touch if the gap left is small: the contact point is half-way, whichever body is the first.
#[test]
fn the_contact_point_lies_half_way_across_the_gap() {
    let floor = Placed::new(Surface::plane());
    let small = Placed::new(Surface::sphere(0.5).unwrap()).at([0.3, -0.2, 0.0]).unwrap();
    for gap in [4e-7, -4e-7] {
        let ball = Placed::new(Surface::sphere(1.0).unwrap());
        for (one, two, z) in [
            (ball.clone().at([0.3, -0.2, 1.0 + gap]).unwrap(), floor.clone(), 0.5 * gap),
            (ball.at([0.3, -0.2, 1.5 + gap / 2.0]).unwrap(), small.clone(), 0.5 + 0.25 * gap),
        ] {
            let places = [ContactPoint::find(&one, &two), ContactPoint::find(&two, &one)];
            let points = places.map(|place| place.unwrap().point());
            for point in points {
                assert!((point - Vector3::new(0.3, -0.2, z)).norm() < 1e-12, "{gap}: {point}");
            }
        }
    }
}

/// Around a box of three edges: the nearest point is the centre of the ball, put back into the box.
#[test]
fn a_ball_beside_an_oblong_box_is_as_far_as_its_faces_edges_and_corners() {
    let half = Vector3::new(0.5, 1.0, 1.7);
    let block = Placed::new(Surface::cuboid([1.0, 2.0, 3.4]).unwrap());
    let mut numbers = Splitmix(31);
    let mut faces = [0; 3];
    for _ in 0..400 {
        let place = Vector3::from_fn(|k, _| numbers.between(-1.0, 1.0) * (half[k] + 0.8));
        let inside = Vector3::from_fn(|k, _| place[k].clamp(-half[k], half[k]));
        let distance = (place - inside).norm();
        if distance < 0.25 {
            continue;
        }
        for (k, count) in faces.iter_mut().enumerate() {
            *count += usize::from((0..3).all(|i| (i == k) != (place[i] == inside[i])));
        }
        let ball = Placed::new(Surface::sphere(0.2).unwrap()).at(place.into()).unwrap();
        for (one, two, of_box) in [(&ball, &block, 1), (&block, &ball, 0)] {
            let near = nearest_points(one, two).unwrap();
            assert!((near.gap - (distance - 0.2)).abs() < 1e-10, "{place}: {}", near.gap);
            assert!((near.points[of_box] - inside).norm() < 1e-7, "{place}: {:?}", near.points);
        }
    }
    assert!(faces.iter().all(|count| *count > 5), "{faces:?}");
}

/// Two oblong boxes lie over each other with a corner of each: both points lie in both faces.
#[test]
fn faces_of_oblong_boxes_meet_where_they_overlap() {
    let lower = Placed::new(Surface::cuboid([2.0, 0.6, 0.4]).unwrap());
    let upper = Surface::cuboid([0.3, 1.0, 0.2]).unwrap();
    for (x, y) in [(0.9, 0.6), (-1.05, 0.7), (0.2, -0.75), (-0.95, -0.1)] {
        let gap = 0.05;
        let upper = Placed::new(upper.clone()).at([x, y, 0.3 + gap]).unwrap();
        let near = nearest_points(&upper, &lower).unwrap();
        assert!((near.gap - gap).abs() < 1e-10, "{x} {y}: {}", near.gap);
        for point in near.points {
            let [in_x, in_y] = [(point.x, x, 0.15, 1.0), (point.y, y, 0.5, 0.3)].map(
                |(at, middle, own, other)| {
                    (at - middle).abs() - own < 1e-7 && at.abs() - other < 1e-7
                },
            );
            assert!(in_x && in_y, "{x} {y}: {point}");
        }
    }
}

#[test]
fn the_smaller_of_two_balls_has_the_smallest_radius_and_bounds_the_gap() {
    let ball = |radius: f64, at: f64| body(Surface::sphere(radius).unwrap(), [0.0, 0.0, at]);
    for radii in [[2.0, 0.5], [0.5, 2.0]] {
        let touch = ContactPoint::find(&ball(radii[0], radii[0]), &ball(radii[1], -radii[1]));
        assert!((touch.unwrap().smallest_radius() - 0.5).abs() < 1e-12);
    }
    // A gap of 1e-4 of the small ball, 1e-8 of the large one.
    let apart = ContactPoint::find(&ball(0.01, 0.01 + 1e-6), &ball(100.0, -100.0));
    assert!(matches!(apart, Err(SearchError::NotTouching { .. })), "{apart:?}");
}

#[test]
fn a_surface_given_at_a_point_bends_by_its_radii() {
    let radii = PrincipalRadii::new(2.0, 5.0).unwrap();
    let known = Surface::given([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], radii).unwrap();
    let below = |x: f64, y: f64| {
        let met = body(known.clone(), [0.0; 3]).entry(&Vector3::new(x, y, 1.0), &-Vector3::z());
        met.unwrap() - 1.0
    };
    assert!((below(0.1, 0.0) - 0.01 / 4.0).abs() < 1e-9);
    assert!((below(0.0, 0.1) - 0.01 / 10.0).abs() < 1e-9);
}

/// A ball inside a cylinder or a box is as deep as the nearest of its faces.
#[test]
fn a_ball_inside_a_body_is_as_deep_as_its_nearest_face() {
    let mut numbers = Splitmix(29);
    let (radius, half) = (0.05, [1.0, 1.3, 0.8]);
    let rod = body(Surface::cylinder(1.0, 2.0 * 0.8).unwrap(), [0.0; 3]);
    let brick = body(Surface::cuboid(half.map(|half| 2.0 * half)).unwrap(), [0.0; 3]);
    for _ in 0..200 {
        let at = half.map(|half| half * numbers.between(-0.7, 0.7));
        let ball = body(Surface::sphere(radius).unwrap(), at);
        let inner = [0, 1, 2].map(|k| half[k] - at[k].abs());
        let side = 1.0 - at[0].hypot(at[1]);
        let nearest = inner.into_iter().fold(f64::INFINITY, f64::min);
        for (outer, depth) in [(&rod, side.min(inner[2])), (&brick, nearest)] {
            let found = nearest_points(&ball, outer).unwrap();
            assert!((found.gap + depth + radius).abs() < 1e-14, "{at:?}: {found:?} {depth}");
        }
    }
}

/// The gap at which bodies count as touching belongs to the length of a slender one, however it is rounded.
#[test]
fn slender_bodies_have_the_size_of_their_length() {
    for slender in [
        Surface::capsule(1e-3, 2.0),
        Surface::cylinder(1e-3, 2.0),
        Surface::ellipsoid([1e-3, 1e-3, 1.0]),
        Surface::cuboid([1e-3, 1e-3, 2.0]),
    ] {
        let size = slender.unwrap().size();
        assert!((size - 1.0).abs() <= 1e-3, "{size}");
    }
}
