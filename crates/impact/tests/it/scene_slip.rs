//! A ball that begins to slip from rest or rolling, and one whose spin ends before its slip: scenes at the edge of round-off.

use carom_drawn::{Draw as _, Splitmix};
use carom_halfspace::Material;
use carom_impact::scene::{Ball, Ending, EventKind, Limits, Manner, Path, PathPoint, Scene, Wall};
use carom_impact::{Body, ImpactFriction, Motion, NormalRestitution};
use carom_laws::slip_speed::SlipSpeedFriction;
use nalgebra::{Rotation3, Vector3};

use crate::scene_on_wall::{G, R, ball, begins, friction, integrated, run};

/// Above 3.5 times the friction of these tests.
const STEEP: f64 = 0.47;

/// Down the steep slope, and its normal.
fn slope() -> (Vector3<f64>, Vector3<f64>) {
    let (sin, cos) = STEEP.sin_cos();
    (Vector3::new(cos, 0.0, -sin), Vector3::new(sin, 0.0, cos))
}

fn steep(law: impl Into<ImpactFriction>, mu: f64) -> Wall {
    let (_, normal) = slope();
    let wall = Wall::new([0.0; 3], normal.into(), Material::RIGID, law).unwrap();
    wall.with_rolling_resistance(mu).unwrap()
}

/// A ball that rolls down and across the steep slope with these speeds.
fn rolling(down: f64, across: f64) -> Ball {
    let (fall, n) = slope();
    let velocity = down * fall + across * Vector3::y();
    ball((R * n).into(), velocity.into(), (n.cross(&velocity) / R).into())
}

/// With a slip of 1e-12 m/s straight down, whose direction friction soon corrects.
fn slipping(mut at: PathPoint) -> PathPoint {
    at.motion.velocity += 1e-12 * slope().0;
    at
}

/// The same ball after an integration that begins with such a slip.
fn wanted(wall: &Wall, law: impl Fn(f64) -> f64, ball: &Ball, time: f64) -> PathPoint {
    let motion = ball.body().motion();
    let start = slipping(PathPoint { time: 0.0, position: ball.position(), motion });
    integrated(wall, law, start, time, 20_000)
}

fn same(found: &PathPoint, wanted: &PathPoint, within: f64) {
    for (found, wanted) in [
        (found.position, wanted.position),
        (found.motion.velocity, wanted.motion.velocity),
        (R * found.motion.spin, R * wanted.motion.spin),
    ] {
        assert!((found - wanted).norm() < within, "{found} {wanted} {:e}", (found - wanted).norm());
    }
}

/// Rolling across the slope, (k g_t + mu_r N v/|v|)/(1 + k) exceeds friction: the slip begins along that force, then turns.
#[test]
fn a_slip_that_begins_from_rolling_and_turns_is_that_of_an_integration() {
    for (mu, down, across) in
        [(0.05, 0.0, 1.0), (0.05, 0.0, 0.01), (0.02, -1.0, 0.3), (0.09, 0.2, -2.0)]
    {
        let (wall, ball) = (steep(friction(0.1), mu), rolling(down, across));
        let path = run(wall.clone(), &ball, 1.5);
        assert_eq!(path.ending(), Ending::Time);
        same(&path.last(), &wanted(&wall, |_| 0.1, &ball, 1.5), 1e-9);
    }
}

/// Rolling ends where friction no longer bears it, as the ball turns down: the slip begins there.
#[test]
fn a_slip_begins_where_friction_no_longer_bears_rolling() {
    for (f, mu, down, across) in [(0.16, 0.05, 0.0, 1.0), (0.17, 0.08, -1.0, 1.0)] {
        let (wall, ball) = (steep(friction(f), mu), rolling(down, across));
        let path = run(wall.clone(), &ball, 1.5);
        let (fall, n) = slope();
        let pull = G * STEEP.sin() * fall;
        let resistance = |v: &Vector3<f64>| mu * G * STEEP.cos() * v.normalize();
        let needed = |v: &Vector3<f64>| (0.4 * pull + resistance(v)).norm() / 1.4;
        let begin = begins(&path, Manner::Slides);
        let velocity = begin.motion.velocity;
        assert!((needed(&velocity) / (f * G * STEEP.cos()) - 1.0).abs() < 1e-9);
        // Small steps of rolling, then of sliding.
        let (mut v, mut x) = (ball.body().motion().velocity, R * n);
        let h = begin.time / 20_000.0;
        for _ in 0..20_000 {
            let middle = v + 0.5 * h * (pull - resistance(&v)) / 1.4;
            let rate = (pull - resistance(&middle)) / 1.4;
            x += h * v + 0.5 * h * h * rate;
            v += h * rate;
        }
        assert!((velocity - v).norm() < 1e-8 && (begin.position - x).norm() < 1e-8);
        let last = integrated(&wall, |_| f, slipping(begin), 1.5 - begin.time, 20_000);
        same(&path.last(), &last, 1e-5);
    }
}

/// At rest too, where friction changes with the slip speed.
#[test]
fn a_slip_that_begins_from_rest_with_friction_by_slip_speed_is_that_of_an_integration() {
    for (a, b, c) in [(0.1, 0.02, 2.0), (0.12, -0.05, 3.0), (0.06, 0.06, 1e3)] {
        let law = SlipSpeedFriction::new(a, b, c).unwrap();
        let at = |slip: f64| a + b * (-c * slip).exp();
        for mu in [0.0, 0.05] {
            let (wall, ball) = (steep(law, mu), rolling(0.0, 0.0));
            let path = run(wall.clone(), &ball, 1.5);
            same(&path.last(), &wanted(&wall, at, &ball, 1.5), 1e-9);
            let way = |f: f64| 0.5 * G * (STEEP.sin() - f * STEEP.cos()) * 1.5 * 1.5;
            let found = (path.last().position - ball.position()).norm();
            assert!(found > way(a.max(a + b)) && found < way(a.min(a + b)), "{found}");
        }
    }
}

/// A ball thrown up the slope: its slip vanishes and begins anew downwards, at once, which is no event, or at rest.
#[test]
fn a_slip_that_changes_its_sign_goes_on() {
    let law = SlipSpeedFriction::new(0.1, 0.02, 2.0).unwrap();
    let at = |slip: f64| 0.1 + 0.02 * (-2.0 * slip).exp();
    let (fall, n) = slope();
    for mu in [0.0, 0.05] {
        let wall = steep(law, mu);
        let ball = ball((R * n).into(), (-2.0 * fall).into(), [0.0, -20.0, 0.0]);
        let path = run(wall.clone(), &ball, 1.5);
        let start = PathPoint { time: 0.0, position: R * n, motion: ball.body().motion() };
        same(&path.last(), &integrated(&wall, at, start, 1.5, 20_000), 1e-3);
        // With resistance the ball rolls up to its highest place and slides down.
        let names: Vec<&str> = path.events().iter().map(|event| event.kind.name()).collect();
        let wanted: &[&str] =
            if mu > 0.0 { &["slides", "rolls", "slides", "end"] } else { &["slides", "end"] };
        assert_eq!(names, wanted);
    }
}

/// Each vector of a scene on an infinite wall turned alike.
struct Thrown {
    wall: Wall,
    gravity: Vector3<f64>,
    start: Vector3<f64>,
    motion: Motion,
    limits: Limits,
}

impl Thrown {
    fn turned(&self, by: &Rotation3<f64>) -> Path {
        let wall = Wall::new(
            [0.0; 3],
            (by * self.wall.normal()).into(),
            Material::RIGID,
            self.wall.friction(),
        );
        let wall = wall.unwrap().with_normal_restitution(self.wall.normal_restitution().clone());
        let wall = wall.with_rolling_resistance(self.wall.rolling_resistance()).unwrap();
        let rubber = Material::from_young(20e6, 0.5).unwrap();
        let body = Body::sphere(R, rubber, 0.03).unwrap().at((by * self.start).into()).unwrap();
        let Motion { velocity, spin } = self.motion;
        let motion = Motion { velocity: by * velocity, spin: by * spin };
        let scene = Scene::new((by * self.gravity).into()).unwrap().with(wall);
        scene.run(&Ball::new(body.moving(motion)).unwrap(), self.limits).unwrap()
    }

    /// The path, which has the same events however all is turned.
    fn turns(&self, count: usize, within: f64) -> Path {
        let path = self.turned(&Rotation3::identity());
        let mut draw = Splitmix(11);
        for _ in 0..count {
            let axis = Vector3::from_fn(|_, _| draw.between(-3.0, 3.0));
            let by = Rotation3::new(axis);
            let turned = self.turned(&by);
            let kinds = |path: &Path| path.events().iter().map(|e| e.kind).collect::<Vec<_>>();
            assert_eq!(kinds(&turned), kinds(&path), "{axis}");
            let PathPoint { time, position, motion: Motion { velocity, spin } } = path.last();
            let motion = Motion { velocity: by * velocity, spin: by * spin };
            same(&turned.last(), &PathPoint { time, position: by * position, motion }, within);
        }
        path
    }
}

fn along(n: &Vector3<f64>, vector: Vector3<f64>) -> Vector3<f64> {
    vector - vector.dot(n) * n
}

/// Friction below the resistance to rolling ends the spin along the wall. What is left of it by rounding is zero, whatever the
/// spin about the normal.
#[test]
fn a_ball_whose_spin_along_the_wall_has_ended_slides_on() {
    for (f, e, height, count) in [(0.02, 0.5, 0.0, 20), (0.02, 1.0, 0.1, 4), (0.0, 1.0, 0.1, 4)] {
        let normal = [0.4, -0.2, 1.0];
        let wall = Wall::new([0.0; 3], normal, Material::RIGID, friction(f)).unwrap();
        let thrown = Thrown {
            wall: wall
                .with_normal_restitution(NormalRestitution::by_yield(e).unwrap())
                .with_rolling_resistance(0.05)
                .unwrap(),
            gravity: Vector3::new(0.0, 0.0, -G),
            start: Vector3::new(0.0, 0.0, 0.05),
            motion: Motion { velocity: Vector3::zeros(), spin: Vector3::new(0.0, 0.0, 50.0) },
            limits: Limits::new(1.5, 200).unwrap().at_rest_below(height).unwrap(),
        };
        let path = thrown.turns(count, 1e-8);
        assert_eq!(path.ending(), Ending::Time);
        let (n, last) = (thrown.wall.normal(), path.last().motion);
        assert!(R * along(&n, last.spin).norm() < 1e-12, "{}", last.spin);
        assert!(last.spin.dot(&n) > 10.0);
        // From the last bounce on it slides down with the acceleration of a block.
        let bounce = path.bounces().last().unwrap();
        let down = along(&n, thrown.gravity);
        let rate = down - f * G * n.z * down.normalize();
        let time = 1.5 - bounce.time;
        let gained = last.velocity - along(&n, bounce.after.velocity);
        assert!((gained.dot(&down) / down.norm() - rate.norm() * time).abs() < 0.02, "{gained}");
    }
}

/// A bounce that ends slip leaves of it what rounding leaves: on a steep slope it begins anew along the force.
#[test]
fn a_slip_that_a_bounce_has_ended_begins_along_the_force() {
    // Rings are solved to a tolerance: rounding decides on the last step of an iteration, with spin in 768 steps.
    for (spin, count, within) in [([0.0; 3], 20, 1e-5), ([3.0, -2.0, 40.0], 4, 1e-4)] {
        let normal = [-0.137, -0.407, 1.0];
        let wall = Wall::new([0.0; 3], normal, Material::RIGID, friction(0.1)).unwrap();
        let thrown = Thrown {
            wall: wall
                .with_normal_restitution(NormalRestitution::new(0.0).unwrap())
                .with_rolling_resistance(0.05)
                .unwrap(),
            gravity: Vector3::new(0.0, 0.0, -G),
            start: Vector3::new(0.0, 0.0, 0.13),
            motion: Motion { velocity: Vector3::new(-0.14, 0.3, 0.14), spin: spin.into() },
            limits: Limits::new(1.5, 200).unwrap(),
        };
        let path = thrown.turns(count, within);
        let slides = path.events().iter().any(|event| {
            matches!(event.kind, EventKind::Moves { .. }) && event.kind.name() == "slides"
        });
        assert!(slides && path.bounces().len() == 1, "{:?}", path.events());
    }
}
