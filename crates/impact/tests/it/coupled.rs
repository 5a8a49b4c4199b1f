//! Coupled oblique impacts against independent reference values and invariants.

use carom_drawn::{Congruential, Draw as _};
use carom_impact::Mobility;
use carom_impact::coupled::{
    CoupledError, CoupledImpact, CoupledOutcome, ImpactLaw, ImpactMethod, Stage, TurningLaw,
};
use carom_impact::oblique::Regime;
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::sliders::SlipLines;
use carom_laws::stiffness::ContactStiffness;
use nalgebra::{Matrix3, Rotation3, Vector3};
use proptest::prelude::*;
use serde_json::Value;

use crate::data::{numbers, public, vector};

fn cases() -> Vec<(String, CoupledImpact, Value)> {
    let solutions = public("coupled_spring_solutions").as_object().unwrap().clone();
    let case = |(name, case): (String, Value)| {
        let rows: Vec<f64> = case["D"].as_array().unwrap().iter().flat_map(numbers).collect();
        let mobility = Mobility::from_matrix(Matrix3::from_row_slice(&rows)).unwrap();
        let c = numbers(&case["c"]);
        let stiffness = ContactStiffness::new(c[0], c[1], c[2]).unwrap();
        let friction = Friction::new(case["f"].as_f64().unwrap()).unwrap();
        let velocity = vector(&case["v0"]);
        let impact = CoupledImpact::new(mobility, stiffness, friction, velocity).unwrap();
        (name, impact, case["results"].clone())
    };
    solutions.into_iter().map(case).collect()
}

#[test]
fn spring_solutions_of_the_incremental_law() {
    for (name, impact, results) in cases() {
        let outcome = impact.solve(TurningLaw::Coulomb).unwrap();
        let reference = &results["coulomb"];
        let error = (outcome.velocity - vector(&reference["v_end"])).norm();
        println!("{name}: {:e} {:?}", error / impact.velocity().norm(), outcome);
        assert!(error < 1e-5 * impact.velocity().norm(), "{name}: {error:e}");
        let ratio = |own: f64, key: &str| own / reference[key].as_f64().unwrap() - 1.0;
        assert!(ratio(outcome.duration, "T").abs() < 1e-5, "{name}");
        assert!(ratio(outcome.maximal_approach, "zeta_max").abs() < 1e-5, "{name}");
        assert!(ratio(outcome.maximal_force, "F_max").abs() < 1e-5, "{name}");
        assert_eq!(outcome.compressions, 1);
        assert!(outcome.error_estimate <= 1e-5);
    }
}

#[test]
fn the_fixed_direction_law_stays_within_one_per_cent() {
    for (name, impact, results) in cases() {
        let outcome = impact.solve(TurningLaw::FixedDirection).unwrap();
        let error = (outcome.velocity - vector(&results["coulomb"]["v_end"])).norm();
        println!("{name}: {:e}", error / impact.velocity().norm());
        assert!(error < 0.01 * impact.velocity().norm(), "{name}: {error:e}");
        if let Some(radial) = results.get("radial") {
            let error = (outcome.velocity - vector(&radial["v_end"])).norm();
            println!("radial {name}: {:e}", error / impact.velocity().norm());
        }
    }
}

fn matrix(a: [f64; 6]) -> Mobility {
    // L L^T with a dominant diagonal: positive definite.
    let lower = Matrix3::new(1.0 + a[0], 0.0, 0.0, a[1], 1.0 + a[2], 0.0, a[3], a[4], 1.0 + a[5]);
    Mobility::from_matrix(lower * lower.transpose()).unwrap()
}

fn impact(a: [f64; 6], c: [f64; 2], f: f64, v: [f64; 2]) -> CoupledImpact {
    let stiffness = ContactStiffness::new(c[0], c[1], 1.0).unwrap();
    let velocity = Vector3::new(v[0], v[1], 1.0);
    CoupledImpact::new(matrix(a), stiffness, Friction::new(f).unwrap(), velocity).unwrap()
}

fn solve(impact: &CoupledImpact) -> CoupledOutcome {
    impact.solve(TurningLaw::Coulomb).unwrap()
}

#[test]
fn any_law_may_be_given() {
    let impact = impact([0.3, 0.2, 0.5, 0.1, -0.2, 0.0], [0.9, 0.8], 0.3, [0.5, 0.2]);
    let impact = impact.within(1e-7).unwrap();
    let stiffness = ContactStiffness::new(0.9, 0.8, 1.0).unwrap();
    let friction = Friction::new(0.3).unwrap();
    let given = impact
        .solve_with(|_| ShiftLaw::<[f64; 2]>::with_fixed_direction(stiffness, friction))
        .unwrap();
    let own = impact.solve(TurningLaw::FixedDirection).unwrap();
    assert!((given.velocity - own.velocity).norm() < 1e-9);
}

/// Log and history as of a law at hand: the same stages at the same times.
#[test]
fn a_given_law_has_log_and_history() {
    let impact = impact([0.3, 0.2, 0.5, 0.1, -0.2, 0.0], [0.9, 0.8], 0.3, [0.5, 0.2]);
    let stiffness = ContactStiffness::new(0.9, 0.8, 1.0).unwrap();
    let law =
        |_| ShiftLaw::<[f64; 2]>::with_fixed_direction(stiffness, Friction::new(0.3).unwrap());
    let (outcome, log) = impact.solve_with_law_and_log(law).unwrap();
    let (own, expected) = impact.solve_with_log(TurningLaw::FixedDirection).unwrap();
    assert!((outcome.velocity - own.velocity).norm() < 1e-9);
    assert!(log.len() > 2 && log.len() == expected.len(), "{log:?} {expected:?}");
    for (one, other) in log.iter().zip(&expected) {
        assert_eq!((one.event, one.regime), (other.event, other.regime));
        assert!((one.time - other.time).abs() < 1e-9 * own.duration);
    }
    let samples = impact.history_with(law).unwrap();
    let expected = impact.history(TurningLaw::FixedDirection).unwrap();
    assert_eq!(samples.len(), expected.len());
    for (one, other) in samples.iter().zip(&expected) {
        assert_eq!(one.stage, other.stage);
        assert!((one.force - other.force).norm() < 1e-9 && (one.time - other.time).abs() < 1e-9);
    }
}

/// A law that fails in its n-th step.
#[derive(Debug, Clone)]
struct Brittle {
    law: ShiftLaw<f64>,
    left: usize,
}

#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("broken at {zeta}")]
struct Broken {
    zeta: f64,
}

impl ContactLaw for Brittle {
    type Error = Broken;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, Broken> {
        self.left = self.left.checked_sub(1).ok_or(Broken { zeta: shift.zeta })?;
        Ok(self.law.advance(shift).unwrap())
    }

    fn shift(&self) -> Shift {
        self.law.shift()
    }

    fn load(&self) -> ContactLoad {
        self.law.load()
    }
}

impl ImpactLaw for Brittle {}

#[test]
fn a_law_that_fails_in_mid_impact_says_why_and_where() {
    let impact = impact([0.3, 0.0, 0.5, 0.1, 0.0, 0.0], [0.9, 0.8], 0.3, [0.5, 0.0]);
    let stiffness = ContactStiffness::new(0.9, 0.8, 1.0).unwrap();
    let brittle = |left| {
        let law = ShiftLaw::<f64>::new(stiffness, Friction::new(0.3).unwrap());
        impact.solve_with(move |_| Brittle { law: law.clone(), left })
    };
    let error = brittle(5).unwrap_err();
    let CoupledError::Law(failure) = &error else { panic!("{error:?}") };
    assert_eq!(failure.step, 5);
    assert!(failure.time > 0.0 && failure.source.zeta > 0.0);
    // The cause is the law's own error, the message says where.
    let cause = std::error::Error::source(&error).unwrap();
    assert_eq!(cause.downcast_ref::<Broken>(), Some(&failure.source));
    assert!(error.to_string().starts_with("step 5 of the contact law"), "{error}");
    assert!(brittle(usize::MAX).is_ok());
}

#[test]
fn the_methods_are_told_apart() {
    let method = |matrix: Matrix3<f64>, c_y: f64, v: [f64; 2], f: f64| {
        let stiffness = ContactStiffness::new(0.9, c_y, 1.0).unwrap();
        let mobility = Mobility::from_matrix(matrix).unwrap();
        let velocity = Vector3::new(v[0], v[1], 1.0);
        let friction = Friction::new(f).unwrap();
        CoupledImpact::new(mobility, stiffness, friction, velocity).unwrap().method().name()
    };
    let diagonal = Matrix3::from_diagonal(&Vector3::new(3.0, 2.0, 1.0));
    let mut planar = diagonal;
    (planar.m13, planar.m31) = (0.3, 0.3);
    assert_eq!(method(diagonal, 0.8, [1.0, 0.0], 0.3), "uncoupled");
    assert_eq!(method(diagonal, 0.8, [0.0, 0.0], 0.3), "uncoupled");
    assert_eq!(method(diagonal, 0.9, [1.0, 0.1], 0.3), "spatial");
    assert_eq!(method(planar, 0.8, [1.0, 0.0], 0.3), "planar");
    assert_eq!(method(planar, 0.8, [0.0, 0.0], 0.3), "planar");
    assert_eq!(method(planar, 0.8, [0.0, 1.0], 0.3), "spatial");
    assert_eq!(method(planar, 0.8, [0.0, 1.0], 0.0), "frictionless");
}

#[test]
fn planar_and_spatial_laws_meet_in_a_plane() {
    // A plane turned by an angle of the isotropic contact: the rings see two directions.
    let mut d = Matrix3::from_diagonal(&Vector3::new(3.0, 2.0, 1.0));
    (d.m13, d.m31) = (0.5, 0.5);
    let stiffness = ContactStiffness::new(0.8, 0.8, 1.0).unwrap();
    let friction = Friction::new(0.3).unwrap();
    let straight = Vector3::new(0.7, 0.0, 1.0);
    let make = |d: Matrix3<f64>, v| {
        let mobility = Mobility::from_matrix(d).unwrap();
        CoupledImpact::new(mobility, stiffness, friction, v).unwrap().within(1e-7).unwrap()
    };
    let planar = make(d, straight);
    assert!(matches!(planar.method(), ImpactMethod::Planar { .. }));
    let planar = solve(&planar).velocity;
    // A disturbance of 1e-9 leaves the plane.
    let aside = solve(&make(d, Vector3::new(0.7, 1e-9, 1.0)));
    assert!(matches!(aside.method, ImpactMethod::Spatial { .. }));
    assert!((aside.velocity - planar).norm() < 3e-6, "{}", (aside.velocity - planar).norm());
    // The turned plane is the same plane.
    let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), 0.7).into_inner();
    let turned = solve(&make(turn * d * turn.transpose(), turn * straight));
    assert!((turned.velocity - turn * planar).norm() < 1e-12);
}

/// Along each axis of a contact with two stiffnesses the exact impact is the one that is stepped in time beside it.
#[test]
fn exact_impacts_along_both_axes_are_the_stepped_ones_beside_them() {
    let mobility = Matrix3::from_diagonal(&Vector3::new(3.0, 2.0, 1.0));
    let mobility = Mobility::from_matrix(mobility).unwrap();
    let stiffness = ContactStiffness::new(0.8, 0.5, 1.0).unwrap();
    for (f, speed) in [(0.3, 0.2), (0.3, 0.7), (0.3, 2.0), (5.0, 0.5)] {
        let friction = Friction::new(f).unwrap();
        for axis in 0..2 {
            let make = |aside: f64| {
                let mut velocity = Vector3::z();
                (velocity[axis], velocity[1 - axis]) = (speed, aside);
                let impact = CoupledImpact::new(mobility, stiffness, friction, velocity).unwrap();
                impact.within(1e-7).unwrap()
            };
            let (exact, stepped) = (make(0.0), make(1e-9));
            assert!(matches!(exact.method(), ImpactMethod::Uncoupled { .. }));
            assert!(matches!(stepped.method(), ImpactMethod::Spatial { .. }));
            let off = (solve(&exact).velocity - solve(&stepped).velocity).norm();
            assert!(off < 3e-6, "f = {f}, speed {speed}, axis {axis}: {off:e}");
        }
    }
}

#[test]
fn pressed_together_again() {
    // A slender rod touching with a steep tip: sliding turns it back into the contact.
    let mut found = 0;
    for i in 0..40 {
        let slope = 0.5 + 0.05 * f64::from(i);
        let mut d = Matrix3::from_diagonal(&Vector3::new(0.3 + slope * slope, 1.0, 1.1));
        (d.m13, d.m31) = (slope, slope);
        let Ok(mobility) = Mobility::from_matrix(d) else { continue };
        let stiffness = ContactStiffness::new(0.8, 0.8, 1.0).unwrap();
        for v in [-4.0, -2.0, -1.0, 1.0, 2.0] {
            let velocity = Vector3::new(v, 0.0, 1.0);
            let friction = Friction::new(2.0).unwrap();
            let impact = CoupledImpact::new(mobility, stiffness, friction, velocity).unwrap();
            let outcome = solve(&impact);
            assert!(outcome.velocity.z < 0.0);
            assert!(mobility.energy(&outcome.velocity) <= mobility.energy(&velocity));
            found += outcome.compressions - 1;
        }
    }
    println!("{found}");
    assert!(found > 0);
}

/// At touch and at separation nothing bears a load: the stage there is that beside them, as in the
/// log.
#[test]
fn a_history_begins_and_ends_as_its_log() {
    let slides = impact([0.3, 0.2, 0.5, 0.1, -0.2, 0.0], [0.9, 0.8], 0.1, [2.0, 1.5]);
    let mut planar = [0.3, 0.0, 0.5, 0.2, 0.0, 0.0];
    let straight = impact(planar, [0.9, 0.8], 0.1, [2.0, 0.0]);
    assert!(matches!(straight.method(), ImpactMethod::Planar { .. }));
    planar[3] = -0.2;
    let sticks = impact(planar, [0.9, 0.8], 1.0, [0.1, 0.0]);
    for (impact, first) in
        [(slides, Stage::Slide), (straight, Stage::Slide), (sticks, Stage::Adhesion)]
    {
        for law in [TurningLaw::Coulomb, TurningLaw::FixedDirection] {
            let samples = impact.history(law).unwrap();
            let (_, log) = impact.solve_with_log(law).unwrap();
            assert_eq!(log[0].regime == Regime::Adhesion, first == Stage::Adhesion);
            assert_eq!(samples[0].stage, first);
            let count = samples.len();
            assert_eq!(samples[count - 1].stage, samples[count - 2].stage);
            let slides =
                matches!(log.last().unwrap().regime, Regime::SlideForward | Regime::SlideBackward);
            assert_eq!(samples[count - 1].stage == Stage::Slide, slides);
        }
    }
}

fn random() -> impl Strategy<Value = ([f64; 6], [f64; 2], f64, [f64; 2])> {
    (
        prop::array::uniform6(-0.4..0.8f64),
        prop::array::uniform2(0.6..1.1f64),
        prop_oneof![0.02..1.5f64, Just(f64::INFINITY), Just(0.0)],
        prop::array::uniform2(-3.0..3.0f64),
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]
    #[test]
    fn energy_and_friction_limit((a, c, f, v) in random()) {
        let impact = impact(a, c, f, v);
        for law in [TurningLaw::Coulomb, TurningLaw::FixedDirection] {
            let (outcome, log) = impact.solve_with_log(law).unwrap();
            let (before, after) =
                (matrix(a).energy(&impact.velocity()), matrix(a).energy(&outcome.velocity));
            prop_assert!(after <= before * (1.0 + 1e-13), "{before} {after} {outcome:?}");
            prop_assert!(outcome.velocity.z < 0.0 && !log.is_empty());
            for sample in impact.history(law).unwrap() {
                let force = sample.force;
                let bound = f * force.z * (1.0 + 1e-12);
                let normal = force.z >= 0.0;
                prop_assert!(normal && (force.z == 0.0 || force.xy().norm() <= bound));
            }
        }
    }

    #[test]
    fn speed_only_scales((a, c, f, v) in random(), speed in 1e-6..1e6f64) {
        let one = impact(a, c, f, v);
        let stiffness = ContactStiffness::new(c[0], c[1], 1.0).unwrap();
        let fast = CoupledImpact::new(
            matrix(a), stiffness, Friction::new(f).unwrap(), one.velocity() * speed,
        ).unwrap();
        let (slow, fast) = (solve(&one), solve(&fast));
        let scale = one.velocity().norm();
        prop_assert!((fast.velocity / speed - slow.velocity).norm() <= 1e-12 * scale);
        let ratio = fast.maximal_approach / slow.maximal_approach / speed.powf(0.8);
        prop_assert!((ratio - 1.0).abs() < 1e-12);
        let ratio = fast.duration / slow.duration * speed.powf(0.2);
        prop_assert!((ratio - 1.0).abs() < 1e-12);
    }

    #[test]
    fn mirrors_and_turns((a, c, f, v) in random(), angle in -3.0..3.0f64) {
        let one = impact(a, c, f, v);
        let stiffness = ContactStiffness::new(c[0], c[1], 1.0).unwrap();
        let friction = Friction::new(f).unwrap();
        let plain = solve(&one).velocity;
        let scale = one.velocity().norm();
        let other = |turn: Matrix3<f64>, stiffness| {
            let d = Mobility::from_matrix(turn * matrix(a).matrix() * turn.transpose()).unwrap();
            solve(&CoupledImpact::new(d, stiffness, friction, turn * one.velocity()).unwrap()).velocity
        };
        let mirror = Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, 1.0));
        prop_assert!((other(mirror, stiffness) - mirror * plain).norm() <= 1e-12 * scale);
        let half = Matrix3::from_diagonal(&Vector3::new(-1.0, -1.0, 1.0));
        prop_assert!((other(half, stiffness) - half * plain).norm() <= 1e-12 * scale);
        // Exchange of x and y with their stiffness.
        let swap = Matrix3::new(0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
        let swapped = ContactStiffness::new(c[1], c[0], 1.0).unwrap();
        prop_assert!((other(swap, swapped) - swap * plain).norm() <= 1e-12 * scale);
        // Any turn of an isotropic contact.
        let round = ContactStiffness::new(c[0], c[0], 1.0).unwrap();
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), angle).into_inner();
        let plain = solve(&CoupledImpact::new(matrix(a), round, friction, one.velocity()).unwrap());
        // Rounding may decide where steps are parted: what that changes is far below what they leave.
        let allowed = 1e-10 + 0.01 * plain.error_estimate;
        let off = (other(turn, round) - turn * plain.velocity).norm();
        prop_assert!(off <= allowed * scale, "{off:e} {allowed:e}");
    }
}

/// Where c_x = c_y the anchors lie on a curve: a line of them in its place, as where c_x and c_y
/// differ, leads to the same velocity.
#[test]
fn a_curve_and_a_line_of_anchors_are_one_law() {
    let mut random = Congruential(5);
    for _ in 0..20 {
        let mut unit = || random.part();
        let a = [0.0; 6].map(|_| 1.2 * unit() - 0.4);
        let (c, f) = (0.6 + 0.5 * unit(), 0.05 + 0.8 * unit());
        let one = impact(a, [c, c], f, [4.0 * unit() - 2.0, 4.0 * unit() - 2.0]);
        let one = one.within(1e-6).unwrap();
        let stiffness = ContactStiffness::new(c, c, 1.0).unwrap();
        let coarse = SlipLines::new(stiffness, f, 0.75).unwrap();
        let line = one.solve_with(|n| coarse.refined(n.saturating_pow(3))).unwrap();
        let apart = (line.velocity - solve(&one).velocity).norm() / one.velocity().norm();
        assert!(apart < 5e-6, "{apart:e} {one:?}");
    }
}
