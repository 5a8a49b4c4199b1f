//! Invariants of impacts of random ellipsoids.

use carom_geometry::{Attitude, Surface};
use carom_halfspace::Material;
use carom_impact::coupled::{CoupledError, ImpactMethod};
use carom_impact::{Body, Collision, CollisionError, Motion, Outcome, Rebound, Warning};
use carom_laws::friction::Friction;
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use std::cell::RefCell;
use std::collections::BTreeMap;

fn steel() -> Material {
    Material::from_shear(80e9, 0.3).unwrap()
}

/// The worst of each measure in a run.
#[derive(Default)]
struct Worst(RefCell<BTreeMap<&'static str, f64>>);

impl Worst {
    fn see(&self, measure: &'static str, value: f64, allowed: f64) -> Result<(), TestCaseError> {
        let mut seen = self.0.borrow_mut();
        let worst = seen.entry(measure).or_insert(0.0);
        *worst = worst.max(value);
        prop_assert!(value <= allowed, "{measure}: {value:e} > {allowed:e}");
        Ok(())
    }
}

/// One ellipsoid: semi-axes, mass, attitude and motion.
#[derive(Debug, Clone)]
struct Half {
    axes: [f64; 3],
    mass: f64,
    attitude: Attitude,
    velocity: [f64; 3],
    spin: [f64; 3],
}

/// Two ellipsoids that touch at the origin with this normal into body 1.
#[derive(Debug, Clone)]
struct Pair {
    one: Half,
    two: Half,
    normal: Vector3<f64>,
    friction: f64,
}

fn direction() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-1.0..1.0f64).prop_filter("not zero", |v| Vector3::from(*v).norm() > 0.1)
}

fn half() -> impl Strategy<Value = Half> {
    (
        prop::array::uniform3(0.5..2.0f64),
        0.1..10.0f64,
        (direction(), -3.0..3.0f64),
        prop::array::uniform3(-2.0..2.0f64),
        prop::array::uniform3(-2.0..2.0f64),
    )
        .prop_map(|(axes, mass, (axis, angle), velocity, spin)| Half {
            axes,
            mass,
            attitude: Attitude::about(axis, angle).unwrap(),
            velocity,
            spin,
        })
}

fn pair() -> impl Strategy<Value = Pair> {
    (half(), half(), direction(), 0.0..1.0f64).prop_map(|(one, two, normal, friction)| {
        let normal = Vector3::from(normal).normalize();
        Pair { one, two, normal, friction }.approaching()
    })
}

/// Each ellipsoid with a principal axis along the normal: the normal motion stands apart.
fn upright_pair() -> impl Strategy<Value = Pair> {
    (pair(), prop::array::uniform2(-3.0..3.0f64)).prop_map(|(mut pair, angles)| {
        pair.normal = Vector3::z();
        for (half, angle) in [&mut pair.one, &mut pair.two].into_iter().zip(angles) {
            half.attitude = Attitude::about([0.0, 0.0, 1.0], angle).unwrap();
        }
        pair.approaching()
    })
}

impl Half {
    fn body(&self) -> Body {
        let surface = Surface::ellipsoid(self.axes).unwrap();
        let inertia = surface.solid(self.mass).unwrap();
        Body::new(surface, steel(), inertia)
            .turned(self.attitude)
            .moving(Motion::new(self.velocity, self.spin).unwrap())
    }

    // The point with this outward normal, in space, from the centre.
    fn support(&self, normal: &Vector3<f64>) -> Vector3<f64> {
        let axes = Vector3::from(self.axes);
        let scaled = axes.component_mul(&self.attitude.to_body(normal));
        self.attitude.to_space(&axes.component_mul(&scaled)) / scaled.norm()
    }
}

impl Pair {
    // The same with all motion turned round if the bodies part.
    fn approaching(mut self) -> Self {
        let encounter = self.encounter();
        if encounter.velocity().z < 0.0 {
            for half in [&mut self.one, &mut self.two] {
                half.velocity = half.velocity.map(|v| -v);
                half.spin = half.spin.map(|w| -w);
            }
        }
        self
    }

    fn bodies(&self) -> [Body; 2] {
        let at = |half: &Half, outward: Vector3<f64>| {
            half.body().at((-half.support(&outward)).into()).unwrap()
        };
        [at(&self.one, -self.normal), at(&self.two, self.normal)]
    }

    fn encounter(&self) -> Collision {
        let [one, two] = self.bodies();
        meet(one, two, self.friction)
    }

    // Sum of the speeds that a velocity afterwards is made of.
    fn speed(&self) -> f64 {
        self.encounter().velocity().norm()
            + self.one.velocity.iter().chain(&self.two.velocity).map(|v| v.abs()).sum::<f64>()
    }
}

fn meet(one: Body, two: Body, f: f64) -> Collision {
    Collision::at(one, two, [0.0; 3], Friction::new(f).unwrap()).unwrap()
}

fn rebound(encounter: &Collision) -> Rebound {
    match encounter.solve().unwrap() {
        Outcome::Rebound(rebound) => *rebound,
        Outcome::NoImpact { .. } => panic!("no impact"),
    }
}

fn tensor(body: &Body) -> Matrix3<f64> {
    let turned = body.placed().attitude();
    let moments = Matrix3::from_diagonal(&Vector3::from(body.inertia().moments()));
    turned.matrix() * moments * turned.matrix().transpose()
}

fn conserves(encounter: &Collision, rebound: &Rebound, worst: &Worst) -> Result<(), TestCaseError> {
    let bodies = encounter.bodies();
    let before = [bodies[0].motion(), bodies[1].motion()];
    let (mut linear, mut linear_scale) = (Vector3::zeros(), 0.0);
    let (mut angular, mut angular_scale) = (Vector3::zeros(), 0.0);
    for (sign, motions) in [(-1.0, &before), (1.0, &rebound.motions)] {
        for (body, motion) in bodies.iter().zip(motions) {
            let momentum = body.inertia().mass() * motion.velocity;
            let turn = tensor(body) * motion.spin;
            let arm = body.placed().centre() - encounter.point();
            linear += sign * momentum;
            linear_scale += momentum.norm();
            angular += sign * (turn + arm.cross(&momentum));
            angular_scale += turn.norm() + arm.norm() * momentum.norm();
        }
    }
    worst.see("momentum", linear.norm() / linear_scale, 1e-13)?;
    worst.see("angular momentum", angular.norm() / angular_scale, 1e-13)?;
    let energy = rebound.energy;
    worst.see("energy gained", energy.after / energy.before - 1.0, 1e-13)?;
    let balance = energy.before - energy.after - energy.dissipated;
    worst.see("energy balance", balance.abs() / energy.before, 1e-13)
}

// |F_t| <= f F_n at every output, and no pull.
fn check_friction(pair: &Pair, worst: &Worst) -> Result<(), TestCaseError> {
    let f = pair.friction;
    for sample in pair.encounter().history(401).unwrap() {
        let force = sample.force;
        prop_assert!(force.z >= 0.0, "pull {force}");
        let excess = force.xy().norm() - f * force.z;
        let scale = force.norm().max(f64::MIN_POSITIVE);
        worst.see("friction beyond f F_n", excess / scale, 1e-14)?;
    }
    Ok(())
}

fn check_alone(pair: &Pair, worst: &Worst) -> Result<(), TestCaseError> {
    let given = pair.encounter();
    let [one, two] = pair.bodies();
    let found = Collision::touching(one, two, Friction::new(pair.friction).unwrap()).unwrap();
    worst.see("found point", found.point().norm(), 1e-9)?;
    let a = |e: &Collision| e.frame().relative_curvature().a();
    worst.see("found curvature", (a(&found) / a(&given) - 1.0).abs(), 1e-7)?;
    let rebound = rebound(&given);
    prop_assert!(rebound.duration > 0.0 && rebound.duration.is_finite());
    let away = rebound.contact_velocity_after.dot(&given.frame().z());
    prop_assert!(away <= 0.0, "still approaching: {away}");
    conserves(&given, &rebound, worst)?;
    // Without friction the normal velocity turns round.
    let smooth = given.frame().z();
    let [one, two] = pair.bodies();
    let outcome = meet(one, two, 0.0).solve().unwrap();
    let outcome = outcome.rebound().unwrap();
    let sum = (outcome.contact_velocity_after + outcome.contact_velocity_before).dot(&smooth);
    worst.see("frictionless restitution", sum.abs() / outcome.contact_velocity_before.norm(), 1e-14)
}

// Velocities of both bodies against those expected; spins times the body's length.
fn agree(
    motions: &[Motion; 2],
    expected: &[Motion; 2],
    (measure, speed, allowed): (&'static str, f64, f64),
    worst: &Worst,
) -> Result<(), TestCaseError> {
    for (own, other) in motions.iter().zip(expected) {
        worst.see(measure, (own.velocity - other.velocity).norm() / speed, allowed)?;
        worst.see(
            measure,
            (own.spin - other.spin).norm() / (speed + other.spin.norm()),
            allowed,
        )?;
    }
    Ok(())
}

fn check_exchange(pair: &Pair, worst: &Worst) -> Result<(), TestCaseError> {
    let rebound = rebound(&pair.encounter());
    let [one, two] = pair.bodies();
    let [second, first] = meet(two, one, pair.friction).solve().unwrap().motions();
    agree(&[first, second], &rebound.motions, ("exchange", pair.speed(), 1e-11), worst)
}

fn check_speed(pair: &Pair, worst: &Worst) -> Result<(), TestCaseError> {
    let rebound = rebound(&pair.encounter());
    let factor = 37.0;
    let mut fast = pair.clone();
    for half in [&mut fast.one, &mut fast.two] {
        half.velocity = half.velocity.map(|v| v * factor);
        half.spin = half.spin.map(|w| w * factor);
    }
    let outcome = fast.encounter().solve().unwrap();
    let fast = outcome.rebound().unwrap();
    let slowed = fast
        .motions
        .map(|motion| Motion { velocity: motion.velocity / factor, spin: motion.spin / factor });
    agree(&slowed, &rebound.motions, ("speed", pair.speed(), 1e-12), worst)?;
    let scales = [
        fast.duration / rebound.duration * factor.powf(0.2),
        fast.maximal_approach / rebound.maximal_approach / factor.powf(0.8),
        fast.maximal_force / rebound.maximal_force / factor.powf(1.2),
        fast.energy.dissipated / rebound.energy.dissipated / (factor * factor),
    ];
    // The speed of approach may be a small difference of the velocities given.
    let encounter = pair.encounter();
    let approach = encounter.velocity().z;
    for ratio in &scales[..3] {
        worst.see("speed powers", (ratio - 1.0).abs() * approach / pair.speed(), 1e-12)?;
    }
    let share = rebound.energy.dissipated / rebound.energy.before;
    worst.see("speed heat", (scales[3] - 1.0).abs() * share, 1e-12)
}

// The whole scene seen through an orthogonal matrix; a mirror turns spins the other way.
fn check_seen_through(
    pair: &Pair,
    view: Matrix3<f64>,
    measure: (&'static str, f64),
    worst: &Worst,
) -> Result<(), TestCaseError> {
    let rebound = rebound(&pair.encounter());
    let hand = view.determinant().signum();
    let mut seen = pair.clone();
    seen.normal = view * pair.normal;
    for half in [&mut seen.one, &mut seen.two] {
        // An ellipsoid is its own mirror image.
        let to_space = view * half.attitude.matrix() * hand;
        half.attitude = Attitude::from_matrix(to_space.transpose()).unwrap();
        half.velocity = (view * Vector3::from(half.velocity)).into();
        half.spin = (view * Vector3::from(half.spin) * hand).into();
    }
    let outcome = seen.encounter().solve().unwrap().motions();
    let expected = rebound
        .motions
        .map(|motion| Motion { velocity: view * motion.velocity, spin: view * motion.spin * hand });
    agree(&outcome, &expected, (measure.0, pair.speed(), measure.1), worst)
}

fn check_mirror(pair: &Pair, worst: &Worst) -> Result<(), TestCaseError> {
    let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0));
    check_seen_through(pair, mirror, ("mirror", 1e-11), worst)
}

fn check_turn(pair: &Pair, worst: &Worst) -> Result<(), TestCaseError> {
    let turn = Attitude::about([0.3, -0.5, 0.8], 1.1).unwrap();
    check_seen_through(pair, *turn.matrix(), ("turn", 1e-11), worst)
}

// A normal motion that stands apart is exactly elastic.
fn check_upright(pair: &Pair, worst: &Worst) -> Result<(), TestCaseError> {
    let given = pair.encounter();
    let rebound = rebound(&given);
    let method = given.impact().unwrap().unwrap().method();
    let measure = match method {
        ImpactMethod::Uncoupled { .. } => "upright, uncoupled",
        ImpactMethod::Spatial { coupled: false } => "upright, spatial",
        other => return Err(TestCaseError::fail(format!("{other:?}"))),
    };
    let z = given.frame().z();
    let (before, after) =
        (rebound.contact_velocity_before.dot(&z), rebound.contact_velocity_after.dot(&z));
    worst.see(measure, (after / before + 1.0).abs(), 1e-13)?;
    conserves(&given, &rebound, worst)
}

fn run(
    cases: u32,
    pairs: impl Strategy<Value = Pair>,
    check: impl Fn(&Pair, &Worst) -> Result<(), TestCaseError>,
) {
    let config = ProptestConfig { cases, source_file: Some(file!()), ..ProptestConfig::default() };
    let mut runner = TestRunner::new(config);
    let worst = Worst::default();
    let outcome = runner.run(&pairs, |pair| check(&pair, &worst));
    for (measure, value) in worst.0.borrow().iter() {
        println!("{measure}: {value:.1e} over {cases} pairs");
    }
    outcome.unwrap();
}

#[test]
fn each_alone() {
    run(60, pair(), check_alone);
}

#[test]
fn under_the_friction_limit() {
    run(40, pair(), check_friction);
}

#[test]
fn in_the_other_order() {
    run(25, pair(), check_exchange);
}

#[test]
fn at_another_speed() {
    run(25, pair(), check_speed);
}

#[test]
fn in_a_mirror() {
    run(25, pair(), check_mirror);
}

#[test]
fn turned_round() {
    run(25, pair(), check_turn);
}

#[test]
fn upright() {
    run(25, upright_pair(), check_upright);
}

#[test]
#[ignore = "minutes: run with --release -- --ignored"]
fn at_length() {
    run(40_000, pair(), check_alone);
    run(20_000, pair(), check_friction);
    for check in [check_exchange, check_speed, check_mirror, check_turn] {
        run(10_000, pair(), check);
    }
}

/// An egg that slides in its plane of symmetry, asked for more than steps can give.
#[test]
fn an_encounter_that_does_not_settle_is_refused_or_marked() {
    let egg = Half {
        axes: [0.03, 0.02, 0.015],
        mass: 0.296,
        attitude: Attitude::about([0.0, 1.0, 0.0], 0.4).unwrap(),
        velocity: [-0.6, 0.0, -2.0],
        spin: [0.0; 3],
    };
    let lowest = egg.support(&-Vector3::z());
    let body = egg.body().at((-lowest).into()).unwrap();
    let encounter = meet(body, Body::plane(steel()), 0.3).within(1e-18).unwrap();
    assert!(matches!(encounter.impact().unwrap().unwrap().method(), ImpactMethod::Planar { .. }));
    let Err(CollisionError::Coupled(CoupledError::NotSettled {
        error_estimate, tolerance, ..
    })) = encounter.solve()
    else {
        panic!("settled to 1e-18")
    };
    let accepted = encounter.accepting_unsettled().solve().unwrap();
    let Outcome::Rebound(rebound) = accepted else { panic!("no impact") };
    assert!(rebound.warnings.contains(&Warning::NotSettled { error_estimate, tolerance }));
    assert_eq!(rebound.error_estimate, error_estimate);
}
