//! A ball and a wall that moves: bounces, and being carried.

use carom_halfspace::Material;
use carom_impact::NormalRestitution;
use carom_impact::scene::{Ending, Limits, Scene, Wall, WallMotion};
use nalgebra::Vector3;

use crate::scene_edges::{between, corner};
use crate::scene_on_wall::{G, R, ball, floor, friction, near, run};

/// The place and the speed of a floor at a time.
type Moved<'a> = &'a dyn Fn(f64) -> [f64; 2];

/// Bounces on a moving floor: (time, velocity afterwards), by a scan in short steps and bisection.
fn scanned(e: f64, height: f64, floor: Moved<'_>, count: usize) -> Vec<[f64; 2]> {
    let (mut from, mut z, mut v, mut bounces) = (0.0, height - R, 0.0, Vec::new());
    while bounces.len() < count {
        let gap = |t: f64| z + t * v - 0.5 * G * t * t - floor(from + t)[0];
        let h = 1e-5;
        let mut t = if bounces.is_empty() { 0.0 } else { h };
        while gap(t + h) > 0.0 {
            t += h;
        }
        let (mut above, mut below) = (t, t + h);
        for _ in 0..80 {
            let middle = 0.5 * (above + below);
            if gap(middle) > 0.0 { above = middle } else { below = middle }
        }
        let [place, speed] = floor(from + above);
        (z, v) = (place, speed - e * (v - G * above - speed));
        from += above;
        bounces.push([from, v]);
    }
    bounces
}

/// A bounce makes an error of its time some twenty times larger, so that six bounces are compared.
#[test]
fn bounces_on_an_oscillating_wall_are_those_of_a_scan() {
    let (a, period, phase) = (2e-3, 0.037, 0.4);
    let omega = std::f64::consts::TAU / period;
    let motion = WallMotion::oscillation([0.0, 0.0, a], period, phase).unwrap();
    let shaken = |t: f64| {
        let angle = omega * t + phase;
        [a * angle.sin(), a * omega * angle.cos()]
    };
    let table = [[0.0, 0.0], [0.3, 0.02], [0.35, -0.01], [0.9, 0.1], [2.0, 0.1], [2.5, 0.0]];
    let lifted = |t: f64| {
        let k = (0..table.len() - 2).rfind(|k| table[*k][0] <= t).unwrap();
        let [from, to] = [table[k], table[k + 1]];
        let speed = (to[1] - from[1]) / (to[0] - from[0]);
        [from[1] + speed * (t - from[0]), speed]
    };
    let rows = table.map(|[t, z]| [t, 0.0, 0.0, z]);
    let lift = WallMotion::positions(&rows).unwrap();
    let ways: [(WallMotion, Moved<'_>); 2] = [(motion, &shaken), (lift, &lifted)];
    for (motion, floor_at) in ways {
        let e = 0.85;
        let wall = floor(0.0).with_normal_restitution(NormalRestitution::by_yield(e).unwrap());
        let path =
            run(wall.with_motion(motion).unwrap(), &ball([0.0, 0.0, 0.3], [0.0; 3], [0.0; 3]), 2.4);
        let wanted = scanned(e, 0.3, floor_at, path.bounces().len().min(6));
        assert!(wanted.len() >= 5);
        for (bounce, [time, speed]) in path.bounces().iter().zip(wanted) {
            assert!((bounce.time - time).abs() < 1e-9, "{} {time}", bounce.time);
            assert!((bounce.after.velocity.z - speed).abs() < 1e-9);
        }
    }
}

/// A wall that moves steadily: what an observer on it sees is a bounce off a fixed wall.
#[test]
fn a_wall_that_moves_steadily_is_a_fixed_one_for_who_moves_along() {
    let drift = Vector3::new(0.3, -0.2, 0.15);
    let motion = WallMotion::positions(&[[0.0; 4], [10.0, 3.0, -2.0, 1.5]]).unwrap();
    let start = [0.0, 0.0, 0.4];
    let moving = run(
        floor(0.0).with_motion(motion).unwrap(),
        &ball(start, [0.9, 0.1, 0.0], [3.0, 4.0, 5.0]),
        2.0,
    );
    let seen = (Vector3::new(0.9, 0.1, 0.0) - drift).into();
    let still = run(floor(0.0), &ball(start, seen, [3.0, 4.0, 5.0]), 2.0);
    assert!(moving.bounces().len() >= 3 && moving.bounces().len() == still.bounces().len());
    for (one, other) in moving.bounces().iter().zip(still.bounces()) {
        near(one.time, other.time, 1e-12);
        assert!((one.after.velocity - drift - other.after.velocity).norm() < 1e-12);
        assert!((one.after.spin - other.after.spin).norm() < 1e-10);
        near(one.rebound.peak_pressure, other.rebound.peak_pressure, 1e-12);
    }
}

/// A ball that loses energy ends on a moving wall; a rectangle cannot move.
#[test]
fn a_moving_wall_carries_what_does_not_rise() {
    let shaker = WallMotion::oscillation([0.0, 0.0, 1e-5], 0.05, 0.0).unwrap();
    let wall = floor(0.0).with_normal_restitution(NormalRestitution::by_yield(0.3).unwrap());
    let path = run(
        wall.with_motion(shaker.clone()).unwrap(),
        &ball([0.0, 0.0, 0.1], [0.0; 3], [0.0; 3]),
        5.0,
    );
    assert_eq!(path.ending(), Ending::Carried { wall: 0 });
    let table = floor(0.0).rectangle([1.0, 0.0, 0.0], [0.5, 0.25]).unwrap();
    assert!(table.with_motion(shaker).is_err());
    assert!(WallMotion::oscillation([0.0; 3], 0.0, 0.0).is_err());
    assert!(WallMotion::positions(&[[0.0; 4]]).is_err());
    assert!(WallMotion::positions(&[[0.0; 4], [0.0; 4]]).is_err());
    assert!(WallMotion::positions(&[[0.0; 4], [1.0, f64::NAN, 0.0, 0.0]]).is_err());
}

/// A ball that lies on a moving wall is carried, at the start too; none falls through.
#[test]
fn a_ball_that_lies_on_a_moving_wall_is_carried() {
    let oscillation =
        |amplitude, period, phase| WallMotion::oscillation(amplitude, period, phase).unwrap();
    let table = |rows: &[[f64; 4]]| WallMotion::positions(rows).unwrap();
    for (motion, height, speed) in [
        (oscillation([1e-3, 0.0, 0.0], 0.02, 0.0), R, 0.0),
        (table(&[[1.0, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.1]]), R, 0.0),
        (table(&[[0.0; 4], [1.0, 0.0, 0.0, 0.1]]), R, 0.1),
        (oscillation([0.0, 0.0, 1e-3], 2.0, -std::f64::consts::FRAC_PI_2), R - 1e-3, 0.0),
    ] {
        let wall = floor(0.0).with_motion(motion).unwrap();
        let path = run(wall, &ball([0.0, 0.0, height], [0.0, 0.0, speed], [0.0; 3]), 1.0);
        assert_eq!((path.ending(), path.bounces().len()), (Ending::Carried { wall: 0 }, 0));
    }
}

/// Whenever a ball leaves the floor, it meets a ceiling that begins to move while it flies.
#[test]
fn a_wall_of_a_table_is_met_after_a_bounce_at_any_time() {
    let rows = [[0.0; 4], [1.8, 0.0, 0.0, 0.0], [2.8, 0.0, 0.0, -1.5]];
    let ceiling = Wall::new([0.0, 0.0, 3.0], [0.0, 0.0, -1.0], Material::RIGID, friction(0.3));
    let ceiling = ceiling.unwrap().with_motion(WallMotion::positions(&rows).unwrap()).unwrap();
    let scene = Scene::new([0.0; 3]).unwrap().with(floor(0.0)).with(ceiling);
    for height in (0..300).map(|i| 0.5 + f64::from(i) / 600.0) {
        let ball = ball([0.0, 0.0, R + height], [0.0, 0.0, -1.0], [0.0; 3]);
        let path = scene.run(&ball, Limits::new(2.75, 2).unwrap()).unwrap();
        let [first, second] = path.bounces() else { panic!("{height}: {:?}", path.bounces()) };
        let speed = first.after.velocity.z;
        let met = (3.0 - 2.0 * R + speed * height + 1.5 * 1.8) / (speed + 1.5);
        near(second.time, met, 1e-12);
    }
}

/// A shaken wall carries a ball only while it falls no faster than the ball would.
#[test]
fn a_wall_carries_while_it_does_not_fall_away() {
    let (a, period) = (1e-3, 0.05);
    let omega = std::f64::consts::TAU / period;
    for phase in (0..12).map(|i| f64::from(i) * std::f64::consts::FRAC_PI_6) {
        let motion = WallMotion::oscillation([0.0, 0.0, a], period, phase).unwrap();
        let wall = floor(0.0).with_normal_restitution(NormalRestitution::new(0.3).unwrap());
        let ball = ball([0.0, 0.0, R + 2e-3], [0.0, 0.0, -0.1], [0.0; 3]);
        let path = run(wall.with_motion(motion).unwrap(), &ball, 5.0);
        assert_eq!(path.ending(), Ending::Carried { wall: 0 }, "{phase}");
        let falls = a * omega * omega * (omega * path.last().time + phase).sin();
        assert!(falls < G, "{phase}: {falls}");
    }
}

/// A corner that moves steadily holds a ball as one at rest does.
#[test]
fn a_ball_is_wedged_in_a_corner_that_moves_along() {
    let drift = [0.1, 0.05, 0.02];
    let [x, y, z] = drift.map(|v| 10.0 * v);
    let motion = WallMotion::positions(&[[0.0; 4], [10.0, x, y, z]]).unwrap();
    let walls = corner(0.5, 0.0).map(|wall| wall.with_motion(motion.clone()).unwrap());
    let ball = ball([0.1 - R, 0.0, R], drift, [0.0; 3]);
    let path = between(&walls, [1.0, 0.0, -G], &ball, [1.0, 9.0]);
    assert_eq!(path.ending(), Ending::Wedged { wall: 0, other: 1 });
}

/// A slow ball meets an oscillating wall within its reach, however many oscillations that takes.
#[test]
fn a_slow_ball_meets_an_oscillating_wall() {
    for period in [1.0, 1e-3] {
        let motion = WallMotion::oscillation([0.0, 0.0, 1e-3], period, 0.0).unwrap();
        let wall = floor(0.0).with_motion(motion).unwrap();
        let scene = Scene::new([0.0; 3]).unwrap().with(wall);
        let slow = ball([0.0, 0.0, R + 1.1e-2], [0.0, 0.0, -1e-5], [0.0; 3]);
        let path = scene.run(&slow, Limits::new(2000.0, 1).unwrap()).unwrap();
        let [bounce] = path.bounces() else { panic!("{:?}", path.ending()) };
        assert!((bounce.time - 1000.0).abs() < 1.0, "{}", bounce.time);
    }
}

/// An oscillating wall is met at the first instant at which it is a radius away, wherever in its oscillation it begins.
#[test]
fn a_wall_that_begins_anywhere_meets_a_slow_ball_where_the_gap_closes() {
    let (a, speed, height) = (1e-3, 1e-3, 5e-4);
    for phase in (0..24).map(|i| f64::from(i) * std::f64::consts::PI / 12.0) {
        let gap =
            |t: f64| height - speed * t - a * (std::f64::consts::TAU / 0.02 * t + phase).sin();
        if gap(0.0) <= 0.0 {
            continue;
        }
        let motion = WallMotion::oscillation([0.0, 0.0, a], 0.02, phase).unwrap();
        let scene = Scene::new([0.0; 3]).unwrap().with(floor(0.0).with_motion(motion).unwrap());
        let ball = ball([0.0, 0.0, R + height], [0.0, 0.0, -speed], [0.0; 3]);
        let path = scene.run(&ball, Limits::new(1.0, 1).unwrap()).unwrap();
        let [bounce] = path.bounces() else { panic!("{phase}: {:?}", path.ending()) };
        assert!(gap(bounce.time).abs() < 1e-12, "{phase}: {}", bounce.time);
        assert!((0..1000).all(|i| gap(1e-3 * f64::from(i) * bounce.time) > 0.0), "{phase}");
    }
}
