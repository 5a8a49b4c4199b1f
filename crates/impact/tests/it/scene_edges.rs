//! A ball on a wall that ends: at an edge, at the next wall and in a corner.

use carom_halfspace::Material;
use carom_impact::scene::{Ball, Ending, Limits, Path, PathPoint, Scene, Wall};
use carom_impact::{Body, Motion, NormalRestitution};
use nalgebra::Vector3;

use crate::scene_on_wall::{G, R, ball, floor, friction, near, rubber, run};

/// A ball rolls off a table: it comes to the edge, on a straight way and on a curved one.
#[test]
fn a_ball_comes_to_the_edge_of_its_wall() {
    let table = floor(0.0).rectangle([1.0, 0.0, 0.0], [0.5, 0.25]).unwrap();
    let path = run(table, &ball([0.0, 0.0, R], [0.3, 0.05, 0.0], [0.0; 3]), 100.0);
    assert_eq!(path.ending(), Ending::Edge { wall: 0 });
    near(path.last().position.x, 0.5, 1e-12);
    let slope = 0.1_f64;
    let sloped = floor(slope).with_rolling_resistance(0.02).unwrap();
    let sloped = sloped.rectangle([0.0, 1.0, 0.0], [0.5, 0.4]).unwrap();
    let n = Vector3::new(slope.sin(), 0.0, slope.cos());
    let path = run(sloped, &ball((R * n).into(), [0.0, 0.3, 0.0], [0.0; 3]), 100.0);
    assert_eq!(path.ending(), Ending::Edge { wall: 0 });
    let down = path.last().position.dot(&Vector3::new(slope.cos(), 0.0, -slope.sin()));
    near(down, 0.4, 1e-12);
}

/// A ball without friction leaves a rectangle by each of its edges.
#[test]
fn a_ball_leaves_by_any_edge() {
    let wall = Wall::new([0.0; 3], [0.0, 0.0, 1.0], Material::RIGID, friction(0.0)).unwrap();
    let wall = wall.rectangle([1.0, 0.0, 0.0], [0.5, 0.3]).unwrap();
    for (velocity, time, end) in [
        ([-1.0, 0.2, 0.0], 0.6, [-0.5, 0.17]),
        ([1.0, 0.2, 0.0], 0.4, [0.5, 0.13]),
        ([0.2, -1.0, 0.0], 0.35, [0.17, -0.3]),
        ([0.2, 1.0, 0.0], 0.25, [0.15, 0.3]),
    ] {
        let path = run(wall.clone(), &ball([0.1, 0.05, R], velocity, [0.0; 3]), 2.0);
        assert_eq!(path.ending(), Ending::Edge { wall: 0 }, "{velocity:?}");
        near(path.last().time, time, 1e-12);
        near(path.last().position.x, end[0], 1e-12);
        near(path.last().position.y, end[1], 1e-12);
    }
}

/// Rolling into a wall: it bounces, slides by its spin and rolls back; in a corner it is wedged.
#[test]
fn a_rolling_ball_bounces_off_the_next_wall() {
    let wall =
        Wall::new([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], Material::RIGID, friction(0.0)).unwrap();
    let scene = Scene::new([0.0, 0.0, -G]).unwrap().with(floor(0.0)).with(wall);
    let ball = ball([0.0, 0.0, R], [1.0, 0.0, 0.0], [0.0, 1.0 / R, 0.0]);
    let path = scene.run(&ball, Limits::new(5.0, 10).unwrap()).unwrap();
    let [bounce] = path.bounces() else { panic!("{:?}", path.events()) };
    assert_eq!(bounce.wall, 1);
    near(bounce.time, 1.0 - R, 1e-12);
    // It keeps its spin, so that v becomes -(5/7) + 2/7 of what it was.
    near(path.last().motion.velocity.x, -3.0 / 7.0, 1e-10);
    let names: Vec<&str> = path.events().iter().map(|event| event.kind.name()).collect();
    assert_eq!(names, ["rolls", "bounce", "slides", "rolls", "end"]);
    // On a slope that falls towards a wall, with loss, it ends in the corner.
    let slope = 0.1_f64;
    let down = Vector3::new(slope.cos(), 0.0, -slope.sin());
    let wall = Wall::new(down.into(), (-down).into(), Material::RIGID, friction(0.0)).unwrap();
    let wall = wall.with_normal_restitution(NormalRestitution::by_yield(0.3).unwrap());
    let scene = Scene::new([0.0, 0.0, -G]).unwrap().with(floor(slope)).with(wall);
    let n = Vector3::new(slope.sin(), 0.0, slope.cos());
    let ball = Ball::new(Body::sphere(R, rubber(), 0.03).unwrap().at((R * n).into()).unwrap());
    let path = scene.run(&ball.unwrap(), Limits::new(100.0, 1000).unwrap()).unwrap();
    assert_eq!(path.ending(), Ending::Wedged { wall: 0, other: 1 });
}

/// The floor, and a wall across x = 0.1, with a loss.
pub(crate) fn corner(e: f64, mu: f64) -> [Wall; 2] {
    let across = Wall::new([0.1, 0.0, 0.0], [-1.0, 0.0, 0.0], Material::RIGID, friction(0.2));
    let lossy = |wall: Wall| {
        let wall = wall.with_normal_restitution(NormalRestitution::new(e).unwrap());
        wall.with_rolling_resistance(mu).unwrap()
    };
    [lossy(floor(0.0)), lossy(across.unwrap())]
}

pub(crate) fn between(walls: &[Wall], gravity: [f64; 3], ball: &Ball, limits: [f64; 2]) -> Path {
    let scene = Scene::new(gravity).unwrap();
    let scene = walls.iter().fold(scene, |scene, wall| scene.with(wall.clone()));
    scene.run(ball, Limits::new(limits[0], limits[1] as usize).unwrap()).unwrap()
}

/// Paths end in corners, whatever the losses, and energy does not rise.
#[test]
fn corners_end_or_are_followed() {
    let ball = ball([0.05, 0.0, R], [0.3, 0.2, 0.0], [0.0; 3]);
    for (e, gravity, ending) in [
        (0.5, [1.0, 0.0, -G], Some(Ending::Wedged { wall: 0, other: 1 })),
        (0.0, [0.5, 0.3, -G], Some(Ending::Wedged { wall: 0, other: 1 })),
        (0.0, [0.0, 0.0, -G], None),
        (0.5, [0.0, 0.0, -G], None),
        (1.0, [0.0, 0.0, -G], None),
    ] {
        let path = between(&corner(e, 0.01), gravity, &ball, [3.0, 50.0]);
        assert!(path.bounces().len() <= 50);
        assert!(ending.is_none_or(|ending| path.ending() == ending), "{e} {:?}", path.ending());
        let energy = |at: &PathPoint| {
            let Motion { velocity, spin } = at.motion;
            0.5 * velocity.norm_squared() + 0.2 * R * R * spin.norm_squared()
                - Vector3::from(gravity).dot(&at.position)
        };
        let energies: Vec<f64> = path.events().iter().map(|event| energy(&event.at)).collect();
        assert!(energies.windows(2).all(|two| two[1] <= two[0] + 1e-9), "{energies:?}");
    }
    // A groove, with friction and without.
    for f in [0.0, 0.2] {
        let side = |x: f64| {
            let wall = Wall::new([0.0; 3], [x, 0.0, 0.866], Material::RIGID, friction(f)).unwrap();
            wall.with_normal_restitution(NormalRestitution::new(0.5).unwrap())
        };
        let ball =
            Ball::new(Body::sphere(R, rubber(), 0.03).unwrap().at([1e-3, 0.0, 0.05]).unwrap());
        let path = between(&[side(0.5), side(-0.5)], [0.0, 0.0, -G], &ball.unwrap(), [20.0, 100.0]);
        assert!(path.bounces().len() <= 100);
        assert!(matches!(path.ending(), Ending::Wedged { .. } | Ending::Bounces));
    }
}

/// A wall leans over the ball and turns its spin into a push along the floor: it bounces off both in turn, a hundred times
/// within a thousandth of what one contact lasts.
#[test]
fn bounces_faster_than_contacts_last_hold_a_ball_between_two_walls() {
    let soft = Material::from_young(1e8, 0.3).unwrap();
    let wall = |point: [f64; 3], normal: [f64; 3], f: f64, e: f64| {
        let wall = Wall::new(point, normal, soft, friction(f)).unwrap();
        wall.with_normal_restitution(NormalRestitution::by_yield(e).unwrap())
    };
    let leans = wall([-0.391045, 0.084166, 0.0], [0.978, -0.21, -0.348], 0.44, 0.17);
    let walls = [wall([0.0; 3], [-0.057, 0.129, 0.99], 0.25, 0.73), leans];
    let motion = Motion {
        velocity: Vector3::new(-0.0415079, -0.217721, 0.0285574),
        spin: Vector3::new(8.21031, -3.37436, -15.1948),
    };
    let body = Body::spherical_shell(0.03, soft, 0.1).unwrap().moving(motion);
    let ball = Ball::new(body.at([-0.311013, 0.362537, -0.0348207]).unwrap()).unwrap();
    let path = between(&walls, [0.0, 0.0, -G], &ball, [4.0, 1000.0]);
    assert_eq!(path.ending(), Ending::Wedged { wall: 0, other: 1 });
    assert!(path.bounces().len() < 100, "{}", path.bounces().len());
}
