//! Scenes: known kinematics, invariants and typed errors.

use approx::assert_relative_eq;
use carom_geometry::{Attitude, Inertia};
use carom_halfspace::Material;
use carom_impact::scene::{Ball, Ending, EventKind, Limits, Path, Scene, SceneError, Wall};
use carom_impact::{Body, Motion, NormalRestitution};
use carom_laws::friction::Friction;
use nalgebra::Vector3;
use proptest::prelude::*;

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const DOWN: [f64; 3] = [0.0, 0.0, -1.0];
const RADIUS: f64 = 0.022;
const MASS: f64 = 0.0446;

fn rubber() -> Material {
    Material::from_young(20e6, 0.5).unwrap()
}

fn rigid_wall(point: [f64; 3], normal: [f64; 3], friction: f64) -> Wall {
    Wall::new(point, normal, Material::RIGID, Friction::new(friction).unwrap()).unwrap()
}

fn ball(position: [f64; 3], velocity: [f64; 3], spin: [f64; 3]) -> Ball {
    let body = Body::sphere(RADIUS, rubber(), MASS).unwrap();
    Ball::new(body.moving(Motion::new(velocity, spin).unwrap()).at(position).unwrap()).unwrap()
}

fn limits(time: f64, bounces: usize) -> Limits {
    Limits::new(time, bounces).unwrap()
}

/// A ball thrown at 45 degrees between a table and a book above it, without gravity.
fn under_the_book(book: Wall) -> Path {
    let scene = Scene::new([0.0; 3]).unwrap().with(rigid_wall([0.0; 3], UP, 0.3)).with(book);
    scene.run(&ball([-0.1, 0.0, 0.1], [1.0, 0.0, -1.0], [0.0; 3]), limits(10.0, 3)).unwrap()
}

#[test]
fn the_edge_of_the_book_counts() {
    let book = |half: f64| {
        rigid_wall([0.2, 0.0, 0.2], DOWN, 0.3).rectangle([1.0, 0.0, 0.0], [half, 1.0]).unwrap()
    };
    // The second bounce is at x = -0.1 + 0.078 + 0.156 * 0.548286 = 0.06353: under the book, or
    // beside it, or so that its edge is met.
    assert_eq!(under_the_book(book(0.15)).bounces()[1].wall, 1);
    let past = under_the_book(book(0.09));
    assert_eq!((past.bounces().len(), past.ending()), (1, Ending::Time));
    let edge = under_the_book(book(0.13));
    assert_eq!((edge.bounces().len(), edge.ending()), (1, Ending::Edge { wall: 1 }));
    // There the centre is one radius from the edge at x = 0.07, z = 0.2.
    let centre = edge.last().position;
    assert_relative_eq!((centre.x - 0.07).hypot(centre.z - 0.2), RADIUS, max_relative = 1e-12);
}

#[test]
fn a_corner_is_an_edge_and_a_plate_has_two_sides() {
    let plate = rigid_wall([0.0; 3], UP, 0.3).rectangle([1.0, 1.0, 0.0], [0.1, 0.1]).unwrap();
    let scene = Scene::new([0.0, 0.0, -10.0]).unwrap().with(plate);
    let reach = 0.1 * 2f64.sqrt() + 0.5 * RADIUS;
    let corner = ball([reach, 0.0, 1.0], [0.0; 3], [0.0; 3]);
    let path = scene.run(&corner, limits(1.0, 9)).unwrap();
    assert_eq!(path.ending(), Ending::Edge { wall: 0 });
    let expected = (RADIUS * RADIUS * 0.75).sqrt();
    assert_relative_eq!(path.last().position.z, expected, max_relative = 1e-12);
    let below = ball([0.0, 0.0, -0.2], [0.0, 0.0, 3.0], [0.0; 3]);
    let path = scene.run(&below, limits(1.0, 9)).unwrap();
    assert_eq!(path.bounces().len(), 1);
    assert_eq!(path.bounces()[0].normal.z, -1.0);
}

#[test]
fn a_frictionless_ball_keeps_its_tangential_motion() {
    let scene = Scene::new([0.0, 0.0, -9.81]).unwrap().with(rigid_wall([0.0; 3], UP, 0.0));
    let start = ball([0.0, 0.0, 1.0 + RADIUS], [0.7, -0.2, 0.0], [3.0, 4.0, 5.0]);
    let path = scene.run(&start, limits(20.0, 10)).unwrap();
    let fall = (2.0 / 9.81f64).sqrt();
    for (i, bounce) in path.bounces().iter().enumerate() {
        assert_relative_eq!(bounce.time, (2 * i + 1) as f64 * fall, max_relative = 1e-13);
        assert_eq!((bounce.after.velocity.x, bounce.after.velocity.y), (0.7, -0.2));
        assert_eq!(bounce.after.spin, start.body().motion().spin);
        assert_relative_eq!(bounce.after.velocity.z, (2.0 * 9.81f64).sqrt(), max_relative = 1e-13);
    }
    assert_eq!(path.bounces().len(), 10);
}

#[test]
fn a_ball_at_rest_on_the_floor_rests() {
    let scene = Scene::new([0.0, 0.0, -9.81]).unwrap().with(rigid_wall([0.0; 3], UP, 0.3));
    let path = scene.run(&ball([0.0, 0.0, RADIUS], [0.0; 3], [0.0, 0.0, 7.0]), limits(1.0, 9));
    assert_eq!(path.unwrap().ending(), Ending::Rest { wall: 0 });
    // It rises 1 mm: too little for a limit of 2 mm, enough for 0.5 mm.
    for (height, bounces) in [(2e-3, 1), (0.5e-3, 9)] {
        let limits = limits(10.0, 9).at_rest_below(height).unwrap();
        let low = ball([0.0, 0.0, RADIUS + 1e-3], [0.0; 3], [0.0; 3]);
        assert_eq!(scene.run(&low, limits).unwrap().bounces().len(), bounces);
    }
}

#[test]
fn points_join_and_lie_on_parabolas() {
    let path = under_the_book(rigid_wall([0.0, 0.0, 0.2], DOWN, 0.3));
    let points = path.points(5).unwrap();
    assert_eq!(points.len(), 15);
    for pair in points.chunks(5).collect::<Vec<_>>().windows(2) {
        assert_eq!(pair[0][4].time, pair[1][0].time);
        assert!((pair[0][4].position - pair[1][0].position).norm() < 1e-15);
    }
    assert!(path.points(1).is_err());
}

#[test]
fn impossible_scenes_are_refused() {
    let scene = Scene::new([0.0, 0.0, -9.81]).unwrap().with(rigid_wall([0.0; 3], UP, 0.3));
    let start = |z: f64| ball([0.0, 0.0, z], [0.0; 3], [0.0; 3]);
    let inside = scene.run(&start(0.02), limits(1.0, 1)).unwrap_err();
    let SceneError::Inside { wall: 0, gap } = inside else { panic!("{inside}") };
    assert_relative_eq!(gap, -0.002, max_relative = 1e-12);
    assert_eq!(Scene::new([0.0, f64::NAN, 0.0]).unwrap_err().field, "gravity");
    assert_eq!(Limits::new(f64::INFINITY, 1).unwrap_err().field, "time");
    assert_eq!(Limits::new(1.0, 0).unwrap_err().field, "bounces");
    assert!(limits(1.0, 1).at_rest_below(-1.0).is_err());
    let f = Friction::NONE;
    for (point, normal) in [([f64::NAN, 0.0, 0.0], UP), ([0.0; 3], [0.0; 3])] {
        assert!(Wall::new(point, normal, rubber(), f).is_err());
    }
    let plane = rigid_wall([0.0; 3], UP, 0.1);
    assert_eq!(plane.clone().rectangle(UP, [1.0, 1.0]).unwrap_err().field, "along");
    assert_eq!(plane.rectangle([1.0, 0.0, 0.0], [1.0, 0.0]).unwrap_err().field, "half length");
    let rigid = Body::sphere(RADIUS, Material::RIGID, MASS).unwrap();
    let rigid = Ball::new(rigid.at([0.0, 0.0, 1.0]).unwrap()).unwrap();
    // It is refused though it does not arrive.
    let refused = scene.run(&rigid, limits(1e-3, 1)).unwrap_err();
    assert!(matches!(refused, SceneError::Collision { wall: 0, .. }), "{refused}");
    let plane = Ball::new(Body::plane(rubber())).unwrap_err();
    assert_eq!(plane, SceneError::NotASphere { shape: "plane" });
    let heavy = Body::sphere(RADIUS, rubber(), f64::INFINITY).unwrap();
    assert!(matches!(Ball::new(heavy), Err(SceneError::Range(_))));
}

/// The moments of inertia of a ball are alike: any one that differs is told.
#[test]
fn a_ball_turns_alike_about_all_axes() {
    let theta = 0.4 * MASS * RADIUS * RADIUS;
    let body = |moments: [f64; 3]| {
        let body = Body::sphere(RADIUS, rubber(), MASS).unwrap();
        Ball::new(body.with_inertia(Inertia::new(MASS, moments).unwrap()))
    };
    assert!(body([theta; 3]).is_ok());
    for axis in 0..3 {
        let mut moments = [theta; 3];
        moments[axis] *= 1.25;
        let Err(SceneError::Range(error)) = body(moments) else { panic!("axis {axis}") };
        assert_eq!(error.field, "moment of inertia");
    }
}

/// The direction of a normal counts, not its length, however large or small it is.
#[test]
fn a_normal_of_any_length_is_a_direction() {
    for length in [1e-200, 1.0, 1e200] {
        let wall = rigid_wall([0.0; 3], [0.6 * length, 0.0, -0.8 * length], 0.3);
        assert!((wall.normal() - Vector3::new(0.6, 0.0, -0.8)).norm() < 1e-15, "{length:e}");
    }
}

/// A plate holds a ball on the side that gravity presses it to.
#[test]
fn a_ball_rests_below_a_plate_if_gravity_presses_it_upwards() {
    let plate = rigid_wall([0.0; 3], UP, 0.3).rectangle([1.0, 0.0, 0.0], [0.1, 0.1]).unwrap();
    for side in [1.0, -1.0] {
        let scene = Scene::new([0.0, 0.0, -9.81 * side]).unwrap().with(plate.clone());
        let still = ball([0.0, 0.0, RADIUS * side], [0.0; 3], [0.0; 3]);
        let path = scene.run(&still, limits(1.0, 9)).unwrap();
        assert_eq!(path.ending(), Ending::Rest { wall: 0 }, "{side}");
    }
}

/// A ball that falls into a right-angled groove meets both its sides at once. Rounding of a long flight puts it
/// into the second side, from which it bounces nevertheless: without friction it rises as high as it fell.
#[test]
fn a_ball_bounces_from_both_sides_of_a_groove_however_far_it_fell() {
    let side = |x: f64| rigid_wall([0.0; 3], [x, 0.0, 1.0], 0.0);
    let scene = Scene::new([0.0, 0.0, -9.81]).unwrap().with(side(1.0)).with(side(-1.0));
    for i in 0..50 {
        let height = 1e4 + 7.3 * f64::from(i);
        let above = ball([0.0, 0.0, height], [0.0; 3], [0.0; 3]);
        let path = scene.run(&above, limits(1e3, 2)).unwrap();
        let walls: Vec<usize> = path.bounces().iter().map(|bounce| bounce.wall).collect();
        assert!(walls == [0, 1] || walls == [1, 0], "{height}: {walls:?}");
        let speed = path.last().motion.velocity;
        let fall = (2.0 * 9.81 * (height - RADIUS * 2.0_f64.sqrt())).sqrt();
        assert!((speed - Vector3::new(0.0, 0.0, fall)).norm() < 1e-9 * fall, "{height}: {speed}");
    }
}

/// What rounding makes of a velocity or of gravity along a wall is none, in whatever frame: a ball that slides
/// down a slope stays on it, without gravity it glides on, and beside a wall along gravity it falls.
#[test]
fn nothing_bounces_or_rests_by_rounding() {
    for i in 0..60 {
        let turn = Attitude::about([0.4, -0.7, 0.2], 0.1 * f64::from(i)).unwrap();
        let seen = |v: [f64; 3]| -> [f64; 3] { turn.to_space(&v.into()).into() };
        for e in [1.0, 0.5, 0.0] {
            let restitution = NormalRestitution::new(e).unwrap();
            let wall = |normal: [f64; 3]| {
                rigid_wall([0.0; 3], seen(normal), 0.3).with_normal_restitution(restitution.clone())
            };
            let run = |gravity: [f64; 3], walls: &[Wall], place: [f64; 3], velocity: [f64; 3]| {
                let scene = Scene::new(seen(gravity)).unwrap();
                let scene = walls.iter().fold(scene, |scene, wall| scene.with(wall.clone()));
                scene.run(&ball(seen(place), seen(velocity), [0.0; 3]), limits(1.0, 50)).unwrap()
            };
            let weight = [0.0, 0.0, -9.81];
            let slope = run(
                weight,
                &[wall([0.6, 0.0, 0.8])],
                [0.6 * RADIUS, 0.0, 0.8 * RADIUS],
                [0.8, 0.0, -0.6],
            );
            assert_eq!((slope.ending(), slope.bounces().len()), (Ending::Time, 0));
            assert!(slope.events().iter().all(|event| event.kind != EventKind::Apex));
            let gliding = run([0.0; 3], &[wall(UP)], [0.0, 0.0, RADIUS], [0.8, 0.6, 0.0]);
            assert_eq!((gliding.ending(), gliding.bounces().len()), (Ending::Time, 0));
            let walls = [wall([1.0, 0.0, 0.0]), wall(UP)];
            for (place, velocity) in [(RADIUS, 0.0), (0.1, -1.0)] {
                let path = run(weight, &walls, [place, 0.0, 0.5], [velocity, 0.0, 0.0]);
                let floor = path.bounces().iter().find(|bounce| bounce.wall == 1);
                let time = (2.0_f64 * (0.5 - RADIUS) / 9.81).sqrt();
                // A ball thrown at the wall may slip or stick there first: it turns and falls as fast.
                assert!(floor.is_some_and(|bounce| bounce.time < 1.5 * time), "{i} {e} {path:?}");
            }
        }
    }
}

/// A box of six infinite walls with tilted floor: everything can be met.
fn cell(friction: f64, gravity: [f64; 3]) -> Scene {
    let walls = [
        ([0.0, 0.0, -1.0], [0.2, 0.1, 1.0]),
        ([0.0, 0.0, 1.0], DOWN),
        ([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ([1.0, 0.0, 0.0], [-1.0, 0.1, 0.0]),
        ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]),
        ([0.0, 1.0, 0.0], [0.0, -1.0, 0.3]),
    ];
    walls.into_iter().fold(Scene::new(gravity).unwrap(), |scene, (point, normal)| {
        scene.with(rigid_wall(point, normal, friction))
    })
}

/// Friction, velocity and spin of a ball in the cell, and gravity down and aside.
fn thrown() -> impl Strategy<Value = (f64, [[f64; 3]; 2], [f64; 2])> {
    let friction = prop_oneof![Just(0.0), 0.01..2.0f64];
    let velocity = proptest::array::uniform3(-5.0..5.0f64);
    let motion = (velocity, proptest::array::uniform3(-200.0..200.0f64));
    (friction, motion.prop_map(<[_; 2]>::from), [0.0..20.0f64, -5.0..5.0])
}

fn keeps_energy_and_walls(
    friction: f64,
    [velocity, spin]: [[f64; 3]; 2],
    [down, aside]: [f64; 2],
) -> Result<(), TestCaseError> {
    let gravity = [aside, 0.0, -down];
    let scene = cell(friction, gravity);
    let start = ball([0.0; 3], velocity, spin);
    let path = scene.run(&start, limits(20.0, 60)).unwrap();
    let energy = |point: &carom_impact::scene::PathPoint| {
        start.body().kinetic_energy(&point.motion) - MASS * scene.gravity().dot(&point.position)
    };
    let points = path.points(4).unwrap();
    let scale = energy(&points[0]).abs() + MASS * scene.gravity().norm();
    for pair in points.windows(2) {
        prop_assert!(energy(&pair[1]) <= energy(&pair[0]) + 1e-12 * scale);
        if friction == 0.0 {
            prop_assert!((energy(&pair[1]) - energy(&pair[0])).abs() <= 1e-12 * scale);
        }
    }
    for point in &points {
        for wall in scene.walls() {
            prop_assert!(wall.gap(&point.position, RADIUS) >= -1e-12);
        }
    }
    for bounce in path.bounces() {
        // The impulse lies in the friction cone.
        let normal = bounce.rebound.impulse.dot(&bounce.normal);
        let tangential = (bounce.rebound.impulse - normal * bounce.normal).norm();
        prop_assert!(tangential <= friction * normal * (1.0 + 1e-9) + 1e-15);
        prop_assert!(
            (bounce.after.velocity.dot(&bounce.normal)
                + bounce.before.velocity.dot(&bounce.normal))
            .abs()
                < 1e-13
        );
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20))]

    #[test]
    fn energy_never_grows_and_no_wall_is_passed((friction, motion, gravity) in thrown()) {
        keeps_energy_and_walls(friction, motion, gravity)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    #[ignore = "half a minute"]
    fn energy_of_many_balls_never_grows_and_no_wall_is_passed((friction, motion, gravity) in thrown()) {
        keeps_energy_and_walls(friction, motion, gravity)?;
    }
}

/// A ball that falls far has rounding of the height it fell from; at a bounce it touches the wall all the same.
#[test]
fn a_ball_from_far_away_touches_the_wall_that_it_bounces_off() {
    let tilted = [0.6, 0.0, 0.8];
    let floor = rigid_wall([0.0; 3], tilted, 0.0);
    let scene = Scene::new(tilted.map(|n| -9.81 * n)).unwrap().with(floor);
    for height in [1e2, 1e5, 3e6] {
        let start = tilted.map(|n| height * n);
        let path = scene.run(&ball(start, [0.0; 3], [0.0; 3]), limits(1e9, 5)).unwrap();
        assert_eq!(path.bounces().len(), 5);
        for bounce in path.bounces() {
            let [x, _, z]: [f64; 3] = bounce.position.into();
            let off = 0.6 * x + 0.8 * z - RADIUS;
            // Five bounces on a frictionless wall leave the ball where it fell.
            assert!(off.abs() < 1e-16, "{height}: {off:e}");
        }
    }
}

/// A side that is given almost along the normal still lies in the plate.
#[test]
fn the_side_of_a_plate_is_at_right_angles_to_its_normal() {
    for tilt in [1e-7, 1e-5, 1e-3, 0.1] {
        let normal = [0.6, 0.0, 0.8];
        let along = [0.6 + 0.8 * tilt, 0.3 * tilt, 0.8 - 0.6 * tilt];
        let plate = rigid_wall([0.0; 3], normal, 0.3).rectangle(along, [0.1, 0.03]).unwrap();
        let corners = plate.corners().unwrap();
        let off = (corners[1] - corners[0]).dot(&Vector3::from(normal));
        assert!(off.abs() < 1e-16, "{tilt}: {off:e}");
    }
}

/// The nearest point of a rectangle to a place, by its corners alone.
fn nearest_of(corners: &[Vector3<f64>; 4], place: &Vector3<f64>) -> Vector3<f64> {
    let [from, one, _, other] = corners;
    let along = |side: Vector3<f64>| {
        side * ((place - from).dot(&side) / side.norm_squared()).clamp(0.0, 1.0)
    };
    from + along(one - from) + along(other - from)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Flights past an oblong plate in any position, seen at 4000 instants: the first touch is where the scene says,
    /// on the face, at an edge or nowhere.
    #[test]
    fn an_oblong_plate_is_met_when_its_nearest_point_is_a_radius_away(
        normal in proptest::array::uniform3(-1.0..1.0f64),
        along in proptest::array::uniform3(-1.0..1.0f64),
        place in proptest::array::uniform3(-0.3..0.3f64),
        aim in proptest::array::uniform3(-0.12..0.12f64),
        from in proptest::array::uniform3(-0.5..0.5f64),
        gravity in proptest::array::uniform3(-3.0..3.0f64),
    ) {
        let (n, u): (Vector3<f64>, Vector3<f64>) = (normal.into(), along.into());
        prop_assume!(n.cross(&u).norm() > 0.1);
        let plate = rigid_wall(place, normal, 0.3).rectangle(along, [0.1, 0.03]).unwrap();
        let corners = plate.corners().unwrap();
        let [long, short] = [corners[1] - corners[0], corners[3] - corners[0]];
        prop_assert!((long.norm() - 0.2).abs() < 1e-15 && (short.norm() - 0.06).abs() < 1e-15);
        prop_assert!(long.dot(&n).abs() < 1e-15);
        prop_assert!(long.dot(&u) > 0.0);
        let centre: Vector3<f64> = place.into();
        prop_assert!((corners.iter().sum::<Vector3<f64>>() / 4.0 - centre).norm() < 1e-15);

        let start = centre + Vector3::from(from).map(|x| x + 0.2_f64.copysign(x));
        let velocity = 2.0 * (centre + Vector3::from(aim) - start);
        let flight = |t: f64| start + velocity * t + Vector3::from(gravity) * (0.5 * t * t);
        let gap = |t: f64| {
            let at = flight(t);
            (at - nearest_of(&corners, &at)).norm() - RADIUS
        };
        prop_assert!((plate.gap(&start, RADIUS) - gap(0.0)).abs() < 1e-14);
        let instants = (0..=4000).map(|i| f64::from(i) * 2.5e-4);
        let least = instants.clone().map(&gap).fold(f64::INFINITY, f64::min);
        prop_assume!(gap(0.0) > 0.0 && least.abs() > 1e-5);
        let first = instants.clone().find(|&t| gap(t) <= 0.0);

        let scene = Scene::new(gravity).unwrap().with(plate);
        let thrown = ball(start.into(), velocity.into(), [0.0; 3]);
        let path = scene.run(&thrown, limits(1.0, 1)).unwrap();
        let found = match path.ending() {
            Ending::Edge { .. } => Some(path.last()),
            _ => path.bounces().first().map(|bounce| {
                let nearest = nearest_of(&corners, &bounce.position);
                let side = (bounce.position - nearest).dot(&bounce.normal);
                assert!((side - RADIUS).abs() < 1e-12);
                carom_impact::scene::PathPoint {
                    time: bounce.time,
                    position: bounce.position,
                    motion: bounce.before,
                }
            }),
        };
        match (first, found) {
            (None, None) => {}
            (Some(seen), Some(point)) => {
                prop_assert!(point.time <= seen && point.time > seen - 2.6e-4);
                prop_assert!((point.position - flight(point.time)).norm() < 1e-12);
                let off = (point.position - nearest_of(&corners, &point.position)).norm() - RADIUS;
                prop_assert!(off.abs() < 1e-12, "{off:e}");
            }
            (seen, _) => prop_assert!(false, "seen at {seen:?}, {:?}", path.ending()),
        }
    }
}

/// A ball that touches the side of a thin plate has nothing below it.
#[test]
fn a_ball_beside_a_plate_falls() {
    let plate = rigid_wall([0.0; 3], UP, 0.3).rectangle([1.0, 0.0, 0.0], [0.1, 0.3]).unwrap();
    let scene = Scene::new([0.0, 0.0, -10.0]).unwrap().with(plate);
    for beside in [[0.1 + RADIUS, 0.0, 0.0], [0.0, -0.3 - RADIUS, 0.0]] {
        let path = scene.run(&ball(beside, [0.0; 3], [0.0; 3]), limits(0.4, 9)).unwrap();
        assert_eq!((path.ending(), path.bounces().len()), (Ending::Time, 0), "{beside:?}");
        assert_relative_eq!(path.last().position.z, -0.8, max_relative = 1e-12);
    }
}
