//! Histories of an impact against their own rates and impulses, logs and warnings against what
//! they describe.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use carom_halfspace::Material;
use carom_impact::coupled::{CoupledImpact, ImpactMethod, Sample, TurningLaw};
use carom_impact::oblique::Regime;
use carom_impact::{Body, Collision, HistoryPoint, Mobility, Motion, NormalRestitution};
use carom_laws::friction::Friction;
use carom_laws::sliders::sliding_direction;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::validity::Limit;
use nalgebra::{Matrix3, Vector3};

const RADIUS: f64 = 0.01;

/// A rubber ball on a steel table.
fn collision(velocity: [f64; 3]) -> Collision {
    let rubber = Material::from_young(5e6, 0.45).unwrap();
    let table = Body::plane(Material::from_young(210e9, 0.3).unwrap());
    let ball = Body::sphere(RADIUS, rubber, 0.005).unwrap();
    let ball = ball.moving(Motion::new(velocity, [0.0; 3]).unwrap());
    Collision::new(ball, table, Friction::new(0.3).unwrap()).unwrap()
}

#[test]
fn the_shift_of_a_history_is_the_integral_of_its_velocity() {
    let points = collision([0.2, 0.0, -0.5]).history(4001).unwrap();
    let mut shift = 0.0;
    let mut largest = 0.0_f64;
    for pair in points.windows(2) {
        let mean = 0.5 * (pair[0].velocity.x + pair[1].velocity.x);
        shift += mean * (pair[1].time - pair[0].time);
        largest = largest.max(shift.abs());
        assert_abs_diff_eq!(pair[1].shift.x, shift, epsilon = 1e-5 * largest);
    }
}

/// Given times are those of an even history, and beyond the contact the bodies move on without a force.
#[test]
fn a_history_is_given_at_any_times() {
    let exact = collision([0.2, 0.0, -0.5]);
    let damped = exact.clone().with_normal_restitution(NormalRestitution::new(0.7).unwrap());
    for collision in [exact, damped] {
        let even = collision.history(41).unwrap();
        let duration = even[40].time;
        let times: Vec<f64> = even.iter().map(|point| point.time).collect();
        let points = collision.history(times.as_slice()).unwrap();
        for (point, even) in points.iter().zip(&even).take(40).skip(1) {
            assert_abs_diff_eq!(point.force, even.force, epsilon = 1e-12 * even.force.z);
            assert_abs_diff_eq!(point.shift, even.shift, epsilon = 1e-15);
        }
        let beyond = [-0.1 * duration, 0.0, duration, 1.1 * duration];
        let [before, touch, end, after] =
            collision.history(&beyond[..]).unwrap().try_into().unwrap();
        let apart = |point: &HistoryPoint| point.force.norm() + point.semi_axes[0];
        assert!([before, touch, end, after].iter().all(|point| apart(point) == 0.0));
        assert_relative_eq!(before.shift.z, -0.05 * duration, epsilon = 1e-15);
        assert_eq!((touch.time, after.time), (0.0, beyond[3]));
        let moved = even[40].velocity * 0.1 * duration;
        assert_abs_diff_eq!(after.shift - end.shift, moved, epsilon = 1e-15);
        assert!(collision.history(&[1e-6, 0.0][..]).is_err());
        assert!(collision.history(&[f64::NAN][..]).is_err());
    }
}

#[test]
fn the_stick_radius_follows_the_regime() {
    let [mut adhered, mut slipped, mut slid] = [0; 3];
    for velocity in [[0.1, 0.0, -0.5], [0.6, 0.0, -0.5]] {
        for HistoryPoint { regime, stick_radius, semi_axes, shift, .. } in
            collision(velocity).history(201).unwrap().into_iter().skip(1)
        {
            let (contact_radius, stick_radius) = (semi_axes[0], stick_radius.unwrap());
            assert_relative_eq!(
                contact_radius,
                (RADIUS * shift.z).sqrt(),
                max_relative = 1e-9,
                epsilon = 1e-12
            );
            match regime {
                Regime::SlideForward | Regime::SlideBackward => {
                    slid += 1;
                    assert_eq!(stick_radius, 0.0);
                }
                Regime::SlipForward | Regime::SlipBackward => {
                    slipped += 1;
                    assert!(stick_radius < contact_radius && stick_radius >= 0.0);
                }
                Regime::Adhesion => {
                    adhered += 1;
                    assert_relative_eq!(stick_radius, contact_radius, max_relative = 1e-9);
                }
            }
        }
    }
    assert!(adhered > 20 && slipped > 20 && slid > 20, "{adhered} {slipped} {slid}");
}

#[test]
fn a_log_tells_the_regimes_of_the_history_in_time() {
    let collision = collision([0.6, 0.0, -0.5]);
    let outcome = collision.solve().unwrap();
    let rebound = outcome.rebound().unwrap();
    let log = &rebound.log;
    assert!(log.len() > 2 && log[0].time == 0.0);
    assert!(log.is_sorted_by(|one, other| one.time < other.time));
    for point in collision.history(301).unwrap().iter().take(300).skip(1) {
        let entry = log.iter().rfind(|entry| entry.time <= point.time).unwrap();
        let near = log.iter().any(|e| (e.time - point.time).abs() < 1e-6 * rebound.duration);
        assert!(near || entry.regime == point.regime, "{entry:?} {point:?}");
    }
}

#[test]
fn warnings_carry_the_numbers_they_speak_of() {
    let outcome = collision([0.0, 0.0, -6.0]).solve().unwrap();
    let rebound = outcome.rebound().unwrap();
    let mut seen = 0;
    for warning in &rebound.warnings {
        if let Some(bound) = warning.ratio(Limit::Coupling) {
            seen += 1;
            // Against a body as good as rigid: gamma = (1 - 2 nu)/(2 (1 - nu)) (15.2).
            let gamma = 0.1 / 1.1;
            let over = (gamma / 0.3_f64).powi(2);
            let expected = over / (4.0 + over) + gamma * gamma;
            assert_relative_eq!(bound, expected, max_relative = 3e-3);
        }
        if let Some(ratio) = warning.ratio(Limit::LargeContact) {
            seen += 1;
            assert_relative_eq!(
                ratio * RADIUS,
                rebound.maximal_contact.semi_axis_b(),
                max_relative = 1e-12
            );
        }
    }
    assert_eq!(seen, 2, "{:?}", rebound.warnings);
}

/// Velocity by the shift, and the impulse of the forces by the change of velocity.
fn check(impact: &CoupledImpact, mobility: &Mobility, samples: &[Sample], tolerance: f64) {
    let (mut shift, mut impulse) = (Vector3::zeros(), Vector3::zeros());
    let (mut size, mut force) = (0.0_f64, 0.0_f64);
    for pair in samples.windows(2) {
        let step = pair[1].time - pair[0].time;
        let moved = 0.5 * step * (pair[0].velocity + pair[1].velocity);
        shift += moved;
        impulse += 0.5 * step * (pair[0].force + pair[1].force);
        size = size.max(shift.amax());
        force = force.max(impulse.amax());
        let expected = pair[1].shift - samples[0].shift;
        assert!((expected - shift).amax() <= tolerance * size, "{expected} {shift}");
    }
    let lost = impact.velocity() - samples[samples.len() - 1].velocity;
    let caused = mobility.matrix() * impulse;
    assert!((lost - caused).amax() <= tolerance * lost.amax(), "{lost} {caused}");
    assert!(force > 0.0);
}

/// The coupled mobility is that of a body that is hit off its centre.
fn impact(coupling: f64, velocity: [f64; 3]) -> (CoupledImpact, Mobility) {
    let matrix = Matrix3::new(70.0, 0.0, coupling, 0.0, 50.0, 0.0, coupling, 0.0, 20.0);
    let mobility = Mobility::from_matrix(matrix).unwrap();
    let stiffness = ContactStiffness::new(0.9e7, 0.7e7, 1.1e7).unwrap();
    let friction = Friction::new(0.4).unwrap();
    let impact = CoupledImpact::new(mobility, stiffness, friction, velocity.into()).unwrap();
    (impact, mobility)
}

#[test]
fn histories_of_coupled_impacts_balance_impulse_and_shift() {
    for (coupling, velocity) in [
        (0.0, [0.3, 0.0, 1.5]),
        (0.0, [0.0, 0.9, 1.5]),
        (9.0, [0.4, 0.0, 1.5]),
        (9.0, [0.4, 0.3, 1.5]),
    ] {
        let (impact, mobility) = impact(coupling, velocity);
        let samples = impact.history(TurningLaw::Coulomb).unwrap();
        check(&impact, &mobility, &samples, 2e-3);
    }
}

#[test]
fn unequal_stiffness_across_the_motion_is_a_spatial_impact() {
    let (aslant, _) = impact(0.0, [0.4, 0.3, 1.5]);
    assert_eq!(aslant.method(), ImpactMethod::Spatial { coupled: false });
    let (along, _) = impact(0.0, [0.0, 0.3, 1.5]);
    assert_eq!(along.method(), ImpactMethod::Uncoupled { direction: Vector3::y() });
    // A mobility alike in all directions turns nothing; unequal stiffnesses still do.
    let mobility = Mobility::from_matrix(Matrix3::from_diagonal(&[7.0, 7.0, 2.0].into())).unwrap();
    let stiffness = ContactStiffness::new(0.9, 0.7, 1.1).unwrap();
    let friction = Friction::new(0.4).unwrap();
    let velocity = Vector3::new(0.4, 0.3, 1.5);
    let impact = CoupledImpact::new(mobility, stiffness, friction, velocity).unwrap();
    assert_eq!(impact.method(), ImpactMethod::Spatial { coupled: false });
}

#[test]
fn the_first_traction_of_a_fast_approach_solves_its_equation() {
    let stiffness = ContactStiffness::new(0.9, 0.7, 1.0).unwrap();
    for z in [0.5, 2.0, 7.0] {
        let velocity = Vector3::new(0.8 * z, 0.5 * z, z);
        let [cos, sin] = sliding_direction(&stiffness, 0.3, velocity.into()).unwrap();
        // (8.58), corrected
        let residue =
            velocity.y * cos - velocity.x * sin + 0.3 * z * sin * cos * (1.0 / 0.9 - 1.0 / 0.7);
        assert_abs_diff_eq!(residue, 0.0, epsilon = 1e-14 * z);
        // It adheres below the limit (8.50).
        let slow = Vector3::new(0.3 * z, 0.05 * z, z);
        assert_eq!(sliding_direction(&stiffness, 0.3, slow.into()), None);
    }
}
