//! A ball that slides and rolls on a wall, against closed forms and an integration of its own.

use carom_halfspace::Material;
use carom_impact::scene::{
    Ball, Ending, Event, EventKind, Limits, Manner, Path, PathPoint, Scene, Wall,
};
use carom_impact::{Body, Motion, NormalRestitution, TorsionMode};
use carom_laws::friction::Friction;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_laws::static_friction::StaticFriction;
use nalgebra::Vector3;

pub(crate) const R: f64 = 0.02;
pub(crate) const G: f64 = 9.81;

pub(crate) fn rubber() -> Material {
    Material::from_young(20e6, 0.5).unwrap()
}

pub(crate) fn friction(f: f64) -> Friction {
    Friction::new(f).unwrap()
}

pub(crate) fn ball(position: [f64; 3], velocity: [f64; 3], spin: [f64; 3]) -> Ball {
    let body = Body::sphere(R, rubber(), 0.03).unwrap().at(position).unwrap();
    Ball::new(body.moving(Motion::new(velocity, spin).unwrap())).unwrap()
}

/// The floor z = 0 turned by a slope that falls towards +x.
pub(crate) fn floor(slope: f64) -> Wall {
    let normal = [slope.sin(), 0.0, slope.cos()];
    Wall::new([0.0; 3], normal, Material::RIGID, friction(0.3)).unwrap()
}

pub(crate) fn run(wall: Wall, ball: &Ball, time: f64) -> Path {
    let scene = Scene::new([0.0, 0.0, -G]).unwrap().with(wall);
    scene.run(ball, Limits::new(time, 1000).unwrap()).unwrap()
}

pub(crate) fn begins(path: &Path, manner: Manner) -> PathPoint {
    let is = |event: &&Event| event.kind == EventKind::Moves { wall: 0, manner };
    path.events().iter().find(is).unwrap_or_else(|| panic!("{:?}", path.events())).at
}

pub(crate) fn near(found: f64, wanted: f64, within: f64) {
    assert!((found - wanted).abs() <= within * wanted.abs().max(1e-3), "{found} is not {wanted}");
}

/// u = v + s ends after 2 v/(7 f g): a solid ball then rolls at 5/7 of its speed.
#[test]
fn a_sliding_ball_comes_to_roll_at_five_sevenths_of_its_speed() {
    let path = run(floor(0.0), &ball([0.0, 0.0, R], [0.6, 0.8, 0.0], [0.0, 0.0, 5.0]), 10.0);
    let time = 2.0 / (7.0 * 0.3 * G);
    let (first, rolls) = (begins(&path, Manner::Slides), begins(&path, Manner::Rolls));
    assert_eq!(first.time, 0.0);
    near(rolls.time, time, 1e-12);
    near(rolls.motion.velocity.norm(), 5.0 / 7.0, 1e-12);
    // Without slip: v = omega x (R z), and the spin about the normal is what it was.
    let spin = rolls.motion.spin;
    near(spin.y * R, rolls.motion.velocity.x, 1e-12);
    near(-spin.x * R, rolls.motion.velocity.y, 1e-12);
    assert_eq!(spin.z, 5.0);
    let way = time * (1.0 - 0.5 * 0.3 * G * time);
    near(rolls.position.xy().norm(), way, 1e-12);
    assert_eq!(path.ending(), Ending::Time);
    near(path.last().position.xy().norm(), way + 5.0 / 7.0 * (10.0 - time), 1e-12);
    assert_eq!(path.last().position.z, R);
}

/// v - k s is kept: strong backspin brings the ball back.
#[test]
fn a_ball_with_backspin_returns() {
    let path = run(floor(0.0), &ball([0.0, 0.0, R], [1.0, 0.0, 0.0], [0.0, -300.0, 0.0]), 5.0);
    let rolls = begins(&path, Manner::Rolls).motion.velocity.x;
    near(rolls, (1.0 + 0.4 * R * -300.0) / 1.4, 1e-12);
    assert!(rolls < 0.0);
}

/// Rolling, the torque mu_r R F_z brakes with mu_r g/(1 + k).
#[test]
fn rolling_resistance_brings_the_ball_to_rest_where_constant_deceleration_does() {
    for (mu, direction) in [(0.01, 0.0_f64), (0.1, 2.0)] {
        let wall = floor(0.0).with_rolling_resistance(mu).unwrap();
        let v = [0.5 * direction.cos(), 0.5 * direction.sin(), 0.0];
        let ball = ball([0.0, 0.0, R], v, [-v[1] / R, v[0] / R, 0.0]);
        let path = run(wall, &ball, 100.0);
        let braking = mu * G / 1.4;
        assert_eq!(path.ending(), Ending::Rest { wall: 0 });
        near(path.last().position.xy().norm(), 0.25 / (2.0 * braking), 1e-9);
        near(path.last().time, 0.5 / braking, 1e-12);
        assert_eq!(path.last().motion.velocity, Vector3::zeros());
        near(path.last().motion.spin.norm() + 1.0, 1.0, 1e-12);
    }
}

/// While it slides, the torque takes its part of the spin too: the slip ends after v/((1 + 1/k) f g - mu_r g/k).
#[test]
fn rolling_resistance_acts_on_a_sliding_ball() {
    let (f, mu) = (0.3, 0.05);
    let wall = floor(0.0).with_rolling_resistance(mu).unwrap();
    let path = run(wall, &ball([0.0, 0.0, R], [1.0, 0.0, 0.0], [0.0; 3]), 1.0);
    let rolls = begins(&path, Manner::Rolls);
    let time = 1.0 / ((3.5 * f - 2.5 * mu) * G);
    near(rolls.time, time, 1e-12);
    near(rolls.motion.velocity.x, 1.0 - f * G * time, 1e-12);
}

/// It climbs v^2/(2 a) with a = (5/7) g sin, and returns with its speed.
#[test]
fn a_ball_climbs_a_slope_and_returns_with_its_energy() {
    let slope = 0.2_f64;
    let (down, normal) =
        (Vector3::new(slope.cos(), 0.0, -slope.sin()), Vector3::new(slope.sin(), 0.0, slope.cos()));
    let start = R * normal;
    let velocity = -1.2 * down;
    let spin = normal.cross(&velocity) / R;
    let ball = ball(start.into(), velocity.into(), spin.into());
    let acceleration = G * slope.sin() / 1.4;
    let path = run(floor(slope), &ball, 2.0 * 1.2 / acceleration);
    assert_eq!(path.ending(), Ending::Time);
    near((path.last().position - start).norm() + 1.0, 1.0, 1e-12);
    near(path.last().motion.velocity.dot(&down), 1.2, 1e-12);
    let top = path.points(1001).unwrap();
    let highest = top.iter().map(|point| -(point.position - start).dot(&down)).fold(0.0, f64::max);
    near(highest, 1.44 / (2.0 * acceleration), 1e-12);
}

/// Rolling needs the friction (2/7) g sin: beyond tan = 7/2 f the ball slides down with g (sin - f cos).
#[test]
fn a_ball_on_a_steep_slope_slides() {
    for (slope, rolls) in [(0.79_f64, true), (0.82, false)] {
        let normal = Vector3::new(slope.sin(), 0.0, slope.cos());
        let path = run(floor(slope), &ball((R * normal).into(), [0.0; 3], [0.0; 3]), 0.5);
        let (acceleration, turning) = match rolls {
            true => (G * slope.sin() / 1.4, G * slope.sin() / 1.4),
            false => (G * (slope.sin() - 0.3 * slope.cos()), 2.5 * 0.3 * G * slope.cos()),
        };
        near(path.last().motion.velocity.norm(), 0.5 * acceleration, 1e-12);
        near(path.last().motion.spin.norm() * R, 0.5 * turning, 1e-12);
    }
}

/// Static friction holds the ball on a slope that its resistance to rolling bears.
#[test]
fn a_ball_rests_on_a_slope_that_its_resistance_bears() {
    for (slope, mu, rests) in [(0.02_f64, 0.03, true), (0.04, 0.03, false), (0.02, 0.0, false)] {
        let normal = Vector3::new(slope.sin(), 0.0, slope.cos());
        let wall = floor(slope).with_rolling_resistance(mu).unwrap();
        let path = run(wall, &ball((R * normal).into(), [0.0; 3], [0.0; 3]), 0.5);
        assert_eq!(path.ending() == Ending::Rest { wall: 0 }, rests, "{slope} {mu}");
        let acceleration = (G * slope.sin() - mu * G * slope.cos()) / 1.4;
        if !rests {
            near(path.last().motion.velocity.norm(), 0.5 * acceleration, 1e-12);
        }
    }
}

/// Resistance to rolling does not hold what friction does not: beyond tan = f the ball slides down with
/// g (sin - f cos), and does not turn if the torque that resists exceeds that of friction.
#[test]
fn a_ball_that_cannot_roll_slides_down_where_friction_does_not_hold_it() {
    for (slope, rests) in [(0.28_f64, true), (0.31, false), (0.5, false)] {
        for mu in [0.35, 2.0] {
            let normal = Vector3::new(slope.sin(), 0.0, slope.cos());
            let wall = floor(slope).with_rolling_resistance(mu).unwrap();
            let path = run(wall, &ball((R * normal).into(), [0.0; 3], [0.0; 3]), 0.5);
            assert_eq!(path.ending() == Ending::Rest { wall: 0 }, rests, "{slope} {mu}");
            let acceleration = if rests { 0.0 } else { G * (slope.sin() - 0.3 * slope.cos()) };
            near(path.last().motion.velocity.norm(), 0.5 * acceleration, 1e-12);
            assert_eq!(path.last().motion.spin, Vector3::zeros());
        }
    }
}

/// A ball that rolls faster than kinetic friction would let it: static friction holds it.
#[test]
fn static_friction_keeps_a_ball_rolling() {
    let slope = 0.5_f64;
    let law = StaticFriction::new(friction(0.2), friction(0.1)).unwrap();
    let normal = [slope.sin(), 0.0, slope.cos()];
    let wall = Wall::new([0.0; 3], normal, Material::RIGID, law).unwrap();
    let start = R * Vector3::from(normal);
    let path = run(wall, &ball(start.into(), [0.0; 3], [0.0; 3]), 0.5);
    near(path.last().motion.velocity.norm(), 0.5 * G * slope.sin() / 1.4, 1e-12);
}

/// The motion on a wall by steps of the whole equations, the first ones tiny: forces and torques of the contact point.
pub(crate) fn integrated(
    wall: &Wall,
    law: impl Fn(f64) -> f64,
    start: PathPoint,
    time: f64,
    steps: usize,
) -> PathPoint {
    let n = wall.normal();
    let gravity = Vector3::new(0.0, 0.0, -G);
    let pressing = -gravity.dot(&n);
    let mu = wall.rolling_resistance();
    // Over the mass; k R^2 is the moment of inertia over it.
    let rate = |v: Vector3<f64>, w: Vector3<f64>| {
        let arm = -R * n;
        let slip = v + w.cross(&arm);
        let slip = slip - slip.dot(&n) * n;
        let force = -law(slip.norm()) * pressing * slip / slip.norm();
        let along = w - w.dot(&n) * n;
        let resistance = if along.norm() > 0.0 {
            -mu * R * pressing * along / along.norm()
        } else {
            0.0 * along
        };
        let torque = arm.cross(&force) + resistance;
        (gravity + pressing * n + force, torque / (0.4 * R * R))
    };
    let at = |i: usize| time * (i as f64 / steps as f64).powi(3);
    let PathPoint { mut position, motion: Motion { mut velocity, mut spin }, .. } = start;
    for i in 0..steps {
        let h = at(i + 1) - at(i);
        let (a1, w1) = rate(velocity, spin);
        let (a2, w2) = rate(velocity + 0.5 * h * a1, spin + 0.5 * h * w1);
        let (a3, w3) = rate(velocity + 0.5 * h * a2, spin + 0.5 * h * w2);
        let (a4, w4) = rate(velocity + h * a3, spin + h * w3);
        position += h * velocity + h * h / 6.0 * (a1 + a2 + a3);
        velocity += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
        spin += h / 6.0 * (w1 + 2.0 * w2 + 2.0 * w3 + w4);
    }
    PathPoint { time: start.time + time, position, motion: Motion { velocity, spin } }
}

/// Sideways on a slope, with resistance and with friction by slip speed, where the slip turns.
#[test]
fn a_turning_slip_is_that_of_an_integration_by_small_steps() {
    let slope = 0.15_f64;
    let normal = [slope.sin(), 0.0, slope.cos()];
    let falling = SlipSpeedFriction::new(0.1, 0.2, 0.8).unwrap();
    let plane = |law: carom_impact::ImpactFriction, mu| {
        let wall = Wall::new([0.0; 3], normal, Material::RIGID, law).unwrap();
        wall.with_rolling_resistance(mu).unwrap()
    };
    let constant = friction(0.25);
    for (wall, law) in [
        (plane(constant.into(), 0.0), Box::new(|_| 0.25) as Box<dyn Fn(f64) -> f64>),
        (plane(constant.into(), 0.04), Box::new(|_| 0.25)),
        (plane(falling.into(), 0.02), Box::new(|slip: f64| 0.1 + 0.2 * (-0.8 * slip).exp())),
    ] {
        let start = R * Vector3::from(normal);
        let side = Vector3::new(slope.cos(), 0.0, -slope.sin());
        let velocity: Vector3<f64> = 0.7 * side + 1.9 * Vector3::y();
        let ball = ball(start.into(), velocity.into(), [40.0, 10.0, -20.0]);
        let begin = PathPoint { time: 0.0, position: start, motion: ball.body().motion() };
        let rolls = begins(&run(wall.clone(), &ball, 5.0), Manner::Rolls);
        let time = 0.95 * rolls.time;
        let (found, wanted) =
            (run(wall.clone(), &ball, time).last(), integrated(&wall, &law, begin, time, 20_000));
        for (found, wanted) in [
            (found.position, wanted.position),
            (found.motion.velocity, wanted.motion.velocity),
            (R * found.motion.spin, R * wanted.motion.spin),
        ] {
            assert!((found - wanted).norm() < 1e-9, "{found} {wanted}");
        }
        // Then it rolls without slip.
        let PathPoint { motion: Motion { velocity, spin }, .. } = rolls;
        assert!((velocity - R * spin.cross(&Vector3::from(normal))).norm() < 1e-11);
    }
}

/// A ball that rolls down a slope with resistance, first across it: small steps of v' = (g_t - mu_r N v/|v|)/(1 + k).
#[test]
fn a_ball_that_rolls_across_a_slope_turns_down() {
    let (slope, mu) = (0.1_f64, 0.05);
    let n = Vector3::new(slope.sin(), 0.0, slope.cos());
    let down = Vector3::new(slope.cos(), 0.0, -slope.sin());
    let velocity: Vector3<f64> = Vector3::y();
    let start = R * n;
    let ball = ball(start.into(), velocity.into(), (n.cross(&velocity) / R).into());
    let wall = floor(slope).with_rolling_resistance(mu).unwrap();
    let path = run(wall, &ball, 1.5);
    let rate =
        |v: Vector3<f64>| (G * slope.sin() * down - mu * G * slope.cos() * v / v.norm()) / 1.4;
    let (mut v, mut x, h) = (velocity, start, 1.5 / 20_000.0);
    for _ in 0..20_000 {
        let a1 = rate(v);
        let a2 = rate(v + 0.5 * h * a1);
        let a3 = rate(v + 0.5 * h * a2);
        let a4 = rate(v + h * a3);
        x += h * v + h * h / 6.0 * (a1 + a2 + a3);
        v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
    assert!((path.last().position - x).norm() < 1e-10);
    assert!((path.last().motion.velocity - v).norm() < 1e-10);
    // Each leg ends where the next begins.
    let points = path.points(5).unwrap();
    for legs in points.chunks(5).collect::<Vec<_>>().windows(2) {
        assert!((legs[0][4].position - legs[1][0].position).norm() < 1e-14);
    }
}

/// With restitution e the apexes are (h - r) e^(2 k) + r.
#[test]
fn apexes_are_those_of_constant_restitution() {
    let (e, height) = (0.8_f64, 1.0);
    let wall = floor(0.0).with_normal_restitution(NormalRestitution::by_yield(e).unwrap());
    let path = run(wall, &ball([0.0, 0.0, height], [0.3, 0.0, 0.0], [0.0; 3]), 1e3);
    let apexes = path.events().iter().filter(|event| event.kind == EventKind::Apex);
    let heights: Vec<f64> = apexes.map(|event| event.at.position.z).collect();
    assert!(heights.len() > 20);
    for (k, found) in heights.iter().enumerate().take(20) {
        let wanted = (height - R) * e.powi(2 * (k as i32 + 1)) + R;
        assert!((found - wanted).abs() < 1e-12, "{k}: {found} {wanted}");
    }
    // Afterwards it rolls on.
    assert_eq!(path.ending(), Ending::Time);
    let last = path.last().motion;
    near(last.spin.y * R, last.velocity.x, 1e-12);
}

/// Where the torque that resists exceeds that of friction, the ball slides without turning.
#[test]
fn a_ball_may_end_its_spin_and_slide() {
    for (f, mu) in [(0.15, 0.5), (0.15, 0.3), (0.01, 0.02)] {
        let wall = Wall::new([0.0; 3], [0.0, 0.0, 1.0], Material::RIGID, friction(f)).unwrap();
        let wall = wall.with_rolling_resistance(mu).unwrap();
        let path = run(wall, &ball([0.0, 0.0, R], [0.5, 0.3, 0.0], [20.0, 0.0, 0.0]), 100.0);
        assert_eq!(path.ending(), Ending::Rest { wall: 0 });
    }
}

/// Such a torque also ends a spin that turns along with the slip. Then the ball slides as a block: it rests after v/(f g).
#[test]
fn a_ball_with_backspin_rests_where_a_block_does() {
    let wall = Wall::new([0.0; 3], [0.0, 0.0, 1.0], Material::RIGID, friction(0.1)).unwrap();
    let wall = wall.with_rolling_resistance(0.3).unwrap();
    let path = run(wall, &ball([0.0, 0.0, R], [1.0, 0.0, 0.0], [0.0, -20.0, 0.0]), 2.0);
    assert_eq!(path.ending(), Ending::Rest { wall: 0 });
    near(path.last().time, 1.0 / (0.1 * G), 1e-12);
    near(path.last().position.x, 0.5 / (0.1 * G), 1e-12);
}

/// Infinite friction ends the slip at once; the moment of momentum about the place of contact stays.
#[test]
fn a_ball_on_infinite_friction_rolls_with_its_moment_of_momentum() {
    let wall = Wall::new([0.0; 3], [0.0, 0.0, 1.0], Material::RIGID, Friction::INFINITE).unwrap();
    let ball = ball([0.0, 0.0, R], [1.0, 0.3, 0.0], [-10.0, 25.0, 5.0]);
    let (before, after) = (ball.body().motion(), run(wall, &ball, 1.0).last().motion);
    let up = R * Vector3::z();
    let moment = |Motion { velocity, spin }: Motion| up.cross(&velocity) + 0.4 * R * R * spin;
    assert!((moment(after) - moment(before)).norm() < 1e-15);
    assert!((after.velocity - after.spin.cross(&up)).norm() < 1e-14);
}

/// Rolling with a torque near friction stays rolling: no event but its begin and the rest.
#[test]
fn rolling_is_not_interrupted_by_rounding() {
    let slope = 10.0_f64.to_radians();
    let n = Vector3::new(slope.sin(), 0.0, slope.cos());
    let velocity = Vector3::new(0.492403876506104, -0.6, -0.08682408883346517);
    let spin = n.cross(&velocity) / R;
    let wall = floor(slope).with_rolling_resistance(0.3).unwrap();
    let path = run(wall, &ball((R * n).into(), velocity.into(), spin.into()), 3.0);
    let names: Vec<&str> = path.events().iter().map(|event| event.kind.name()).collect();
    assert_eq!(names.last(), Some(&"rest"), "{names:?}");
    assert!(names.len() <= 3, "{names:?}");
}

/// Friction changes the spin about the normal unless that is left out.
#[test]
fn a_scene_leaves_the_spin_about_the_normal_if_it_is_told_to() {
    let ball = ball([0.0, 0.0, 0.1], [0.0, 0.0, -1.0], [0.0, 0.0, 300.0]);
    for mode in [TorsionMode::Included, TorsionMode::LeftOut] {
        let scene = Scene::new([0.0; 3]).unwrap().with(floor(0.0)).with_torsion_mode(mode);
        let path = scene.run(&ball, Limits::new(1.0, 9).unwrap()).unwrap();
        let is_left = path.last().motion.spin == Vector3::new(0.0, 0.0, 300.0);
        assert_eq!((path.bounces().len(), is_left), (1, mode == TorsionMode::LeftOut));
    }
}

/// On a floor without friction a ball slides to a wall and back: each time it begins to slide anew.
#[test]
fn a_bounce_begins_the_motion_on_the_floor_anew() {
    let wall = |place, normal| Wall::new(place, normal, Material::RIGID, Friction::NONE).unwrap();
    let (floor, end) = (wall([0.0; 3], [0.0, 0.0, 1.0]), wall([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]));
    let scene = Scene::new([0.0, 0.0, -G]).unwrap().with(floor).with(end);
    let ball = ball([0.0, 0.0, R], [1.0, 0.0, 0.0], [0.0; 3]);
    let path = scene.run(&ball, Limits::new(1.5, 9).unwrap()).unwrap();
    let names: Vec<&str> = path.events().iter().map(|event| event.kind.name()).collect();
    assert_eq!(names, ["slides", "bounce", "slides", "end"]);
}
