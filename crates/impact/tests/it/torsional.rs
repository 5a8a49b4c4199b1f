//! Torsional impact against reference values, limits and invariants.

use approx::assert_relative_eq;
use carom_geometry::Inertia;
use carom_halfspace::{Material, MaterialPair};
use carom_impact::normal::DURATION;
use carom_impact::torsional::{
    SpinCollision, Spinner, TorsionalGroups, TorsionalImpact, TorsionalPhase, limits,
};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::torsion::history::TwistHistory;
use proptest::prelude::*;
use serde_json::Value;

fn data() -> Value {
    serde_json::from_str(include_str!("../data/torsional.json")).unwrap()
}

fn solve(epsilon: f64, omega: f64) -> TorsionalImpact {
    TorsionalImpact::new(TorsionalGroups::new(epsilon, omega).unwrap()).unwrap()
}

/// Velocities of instants evenly spaced on the circle of the normal motion.
fn velocities(count: usize) -> Vec<f64> {
    let angle = |i: usize| std::f64::consts::PI * i as f64 / (count - 1) as f64;
    (0..count).map(|i| angle(i).cos()).collect()
}

#[test]
fn ratios_and_onsets_agree_with_the_reference() {
    for row in data()["torsional_impact"].as_array().unwrap() {
        let get = |key: &str| row[key].as_f64().unwrap();
        let impact = solve(get("eps"), get("Omega"));
        let (ratio, onset) = (impact.spin_ratio(), impact.onset_radius());
        // Two runs of the reference, stepped, differ by up to 8e-12; collocation goes further.
        assert!((ratio - get("ratio_betaT_over_beta0")).abs() < 8e-12, "{row}: {ratio}");
        assert!((onset - get("alpha_onset")).abs() < 2e-15, "{row}: {onset}");
    }
}

#[test]
fn small_epsilon_loss_agrees_with_the_reference() {
    for row in data()["torsional_impact_eps0_h"].as_array().unwrap() {
        let get = |key: &str| row[key].as_f64().unwrap();
        let h = limits::first_order_loss(get("Omega")).unwrap();
        // Two runs of the reference differ by up to 1.6e-11 of h.
        assert!((h / get("h") - 1.0).abs() < 1.6e-11, "{row}: {h}");
        // The loss of second order is less than (eps h)^2.
        let (epsilon, impact) = (1e-6, solve(1e-6, get("Omega")));
        let off = impact.spin_ratio() - (1.0 - epsilon * h);
        assert!(off.abs() < (epsilon * h).powi(2) + impact.error_estimate(), "{off:e}");
    }
    // The impulse of a spin that stays constant, by quadrature in 20 digits.
    let h = limits::first_order_loss(0.01).unwrap();
    assert_relative_eq!(h, 1.487_173_681_152_877_6, max_relative = 1e-13);
}

#[test]
fn constants_agree_with_the_reference() {
    let data = data();
    let get = |key: &str| -> f64 { data["constants"][key].as_str().unwrap().parse().unwrap() };
    assert_relative_eq!(limits::SLIDING_LOSS, get("slide_d_coeff_corrected_15"), epsilon = 1e-15);
    let gamma = libm::tgamma(1.2) / libm::tgamma(1.7);
    let closed = 15.0 / 32.0 * std::f64::consts::PI.powf(1.5) * gamma;
    assert_relative_eq!(limits::SLIDING_LOSS, closed, max_relative = 1e-14);
    let h = get("h0_small_spin=(8/5)(T-2)");
    assert_relative_eq!(limits::SMALL_SPIN_LOSS, h, max_relative = 1e-15);
    assert_relative_eq!(2.0 * DURATION, get("bound_10_1_2T"), max_relative = 1e-15);
    // (10.18): y_1 = 1 + eps v_1(1) + eps^2 v_2(1), with v_2(1) of (10.22) corrected.
    let epsilon = 1e-3;
    let y_1 = (0.5 * (1.0 + limits::no_slip(epsilon).unwrap())).sqrt();
    let series = 1.0 + epsilon * get("v1_at_1") + epsilon * epsilon * 0.028_148_690_25;
    assert_relative_eq!(y_1, series, epsilon = 2e-12);
}

#[test]
fn no_slip_is_the_limit_of_small_spin() {
    assert_relative_eq!(limits::no_slip(0.0625).unwrap(), 0.907_213_33, epsilon = 5e-9);
    // It vanishes where y_1^2 = 1/2.
    assert!(limits::no_slip(0.825_860_760_372_876).unwrap().abs() < 1e-12);
    for epsilon in [0.01, 0.0625, 0.5, 0.8, 1.5] {
        let limit = limits::no_slip(epsilon).unwrap();
        assert!((solve(epsilon, 0.0).spin_ratio() - limit).abs() < 1e-15);
        let near = solve(epsilon, 1e-5).spin_ratio() - limit;
        let nearer = solve(epsilon, 1e-6).spin_ratio() - limit;
        assert!((near - 10.0 * nearer).abs() < 1e-9, "{epsilon}: {near:e} {nearer:e}");
        let first = limits::no_slip_first_order(epsilon);
        assert!((first - limit).abs() < 0.16 * epsilon * epsilon);
    }
    // The printed form is wrong at first order: 3/4 of the loss.
    let small = 1e-5;
    let losses = [limits::no_slip_as_printed(small), limits::no_slip(small).unwrap()];
    assert_relative_eq!((1.0 - losses[0]) / (1.0 - losses[1]), 0.75, epsilon = 1e-5);
}

#[test]
fn sliding_is_the_limit_of_large_spin() {
    for (omega, tolerance) in [(10.0, 2e-9), (100.0, 1e-12), (1e6, 1e-15)] {
        let ratio = solve(0.5, omega).spin_ratio();
        assert!((ratio - limits::sliding(0.5, omega)).abs() < tolerance);
    }
    assert!(limits::sliding_as_printed(0.5, 2.0) < limits::sliding(0.5, 2.0));
}

/// The general history of a twisted contact, driven by the same course, gives the same torque.
#[test]
fn torque_agrees_with_the_general_history() {
    for (epsilon, omega) in [(0.0625, 0.5), (0.5, 0.1), (0.8, 0.3), (0.3, 3.0)] {
        let groups = TorsionalGroups::new(epsilon, omega).unwrap();
        let trace = TorsionalImpact::trace(groups, &velocities(2001)).unwrap();
        let mut history = TwistHistory::new();
        for point in &trace[..trace.len() - 1] {
            let torque = history.advance(point.radius, omega * point.twist).unwrap();
            assert_eq!(history.ring_steps(), 0);
            let difference = (torque / omega - point.torque).abs();
            assert!(difference < 1e-3, "{epsilon} {omega} {point:?}: {difference:e}");
        }
    }
}

#[test]
fn trace_is_consistent() {
    let groups = TorsionalGroups::new(0.5, 0.4).unwrap();
    let trace = TorsionalImpact::trace(groups, &velocities(4001)).unwrap();
    let impact = TorsionalImpact::new(groups).unwrap();
    assert!((trace[4000].spin - impact.spin_ratio()).abs() < 1e-12);
    assert_eq!(trace[0].phase, TorsionalPhase::Adhesion);
    for pair in trace.windows(2) {
        let (p, q) = (pair[0], pair[1]);
        let dt = q.time - p.time;
        assert!((q.spin - p.spin + 0.25 * (p.torque + q.torque) * dt).abs() < 1e-6);
        assert!((q.twist - p.twist - 0.5 * (p.spin + q.spin) * dt).abs() < 1e-6);
        assert!(q.phase != TorsionalPhase::PartialSlip || q.stick_radius <= q.radius);
        let slipped = p.phase != TorsionalPhase::Adhesion;
        assert!(!slipped || q.stick_radius <= p.stick_radius * (1.0 + 1e-9));
    }
}

fn rubber(a: f64, b: f64) -> Hertz {
    let rubber = Material::from_shear(1e6, 0.4).unwrap();
    let gap = RelativeCurvature::from_coefficients(a, b).unwrap();
    Hertz::new(gap, MaterialPair::new(rubber, rubber).unwrap()).unwrap()
}

#[test]
fn a_sphere_on_a_plane_has_the_thesis_groups() {
    // (10.10): eps = (25/4) (1 - nu) zeta_max/R, Omega = ((1-nu)/f) (R beta'/zeta') sqrt(zeta/R).
    let (radius, spin, velocity, f) = (0.02, 31.0, 1.3, 0.7);
    let ball = Spinner::solid_sphere(0.04, radius).unwrap().spinning(spin).unwrap();
    let hertz = rubber(0.5 / radius, 0.5 / radius);
    let friction = Friction::new(f).unwrap();
    let bodies = [ball, Spinner::held_fast()];
    let collision = SpinCollision::new(&hertz, friction, bodies, velocity).unwrap();
    let delta = 0.6 * collision.normal().maximal_approach() / radius;
    let groups = collision.groups().unwrap().unwrap();
    assert_relative_eq!(groups.epsilon(), 6.25 * delta, max_relative = 1e-13);
    let omega = 0.6 / f * radius * spin / velocity * (delta / 0.6).sqrt();
    assert_relative_eq!(groups.omega(), omega, max_relative = 1e-13);
    let outcome = collision.solve().unwrap();
    let ratio = TorsionalImpact::new(groups).unwrap().spin_ratio();
    assert_relative_eq!(outcome.spins[0], spin * ratio, max_relative = 1e-14);
    // (10.64), corrected: the spin lost when all slides.
    let fast = ball.spinning(1e6).unwrap();
    let collision =
        SpinCollision::new(&hertz, friction, [fast, Spinner::held_fast()], velocity).unwrap();
    let lost = 1e6 - collision.solve().unwrap().spins[0];
    let zeta = collision.normal().maximal_approach();
    let d = f * velocity / radius * (zeta / radius).sqrt() * limits::SLIDING_LOSS;
    assert_relative_eq!(lost, d, max_relative = 1e-8);
}

#[test]
fn two_spheres_keep_their_angular_momentum() {
    let one = Spinner::new(0.05, 2e-5).unwrap().spinning(40.0).unwrap();
    let two = Spinner::new(0.2, 9e-5).unwrap().spinning(-25.0).unwrap();
    let spin_energy = |spins: [f64; 2]| 0.5 * (2e-5 * spins[0].powi(2) + 9e-5 * spins[1].powi(2));
    for f in [0.0, 0.2, 5.0, f64::INFINITY] {
        let friction = Friction::new(f).unwrap();
        let outcome =
            SpinCollision::new(&rubber(30.0, 70.0), friction, [one, two], 1.0).unwrap().solve();
        let outcome = outcome.unwrap();
        let momentum = 2e-5 * outcome.spins[0] + 9e-5 * outcome.spins[1];
        assert_relative_eq!(momentum, 2e-5 * 40.0 - 9e-5 * 25.0, max_relative = 1e-13);
        let lost = spin_energy([40.0, -25.0]) - spin_energy(outcome.spins);
        assert_relative_eq!(lost, outcome.energy_loss, epsilon = 1e-15);
        assert!(outcome.energy_loss >= 0.0 && (outcome.energy_loss > 0.0) == (f > 0.0));
        assert_eq!(outcome.spin_ratio == 1.0, f == 0.0);
    }
    // The same the other way round, and in a mirror.
    let friction = Friction::new(0.3).unwrap();
    let solve = |bodies| SpinCollision::new(&rubber(30.0, 70.0), friction, bodies, 1.0).unwrap();
    let mirrored = [one.spinning(-40.0).unwrap(), two.spinning(25.0).unwrap()];
    let spins = solve([one, two]).solve().unwrap().spins;
    assert_eq!(solve(mirrored).solve().unwrap().spins, spins.map(|spin| -spin));
    let exchanged = solve([two, one]).solve().unwrap().spins;
    assert_relative_eq!(exchanged[0], spins[1], max_relative = 1e-12);
}

#[test]
fn bad_input_is_named() {
    for (epsilon, omega, field) in [
        (f64::NAN, 1.0, "epsilon"),
        (-0.1, 1.0, "epsilon"),
        (101.0, 1.0, "epsilon"),
        (0.1, -1.0, "omega"),
        (0.1, f64::NAN, "omega"),
        (0.1, f64::INFINITY, "omega"),
    ] {
        assert_eq!(TorsionalGroups::new(epsilon, omega).unwrap_err().field, field);
    }
    assert!(limits::no_slip(f64::NAN).is_err() && limits::first_order_loss(-1.0).is_err());
    let fast = [Spinner::held_fast(), Spinner::held_fast()];
    let friction = Friction::new(0.1).unwrap();
    assert!(SpinCollision::new(&rubber(1.0, 1.0), friction, fast, 1.0).is_err());
    let ball = Spinner::solid_sphere(1.0, 1.0).unwrap();
    let bodies = [ball, Spinner::held_fast()];
    assert!(SpinCollision::new(&rubber(1.0, 1.0), friction, bodies, -1.0).is_err());
    assert!(Spinner::new(0.0, 1.0).is_err() && ball.spinning(f64::NAN).is_err());
}

/// Two slip rings at once, which no closed law covers: the answer comes in steps.
#[test]
fn spins_that_turn_back_have_an_answer() {
    for (epsilon, omega) in [(5.0, 1.0), (20.0, 3.0), (100.0, 0.5)] {
        let groups = TorsionalGroups::new(epsilon, omega).unwrap();
        let impact = TorsionalImpact::new(groups).unwrap();
        let estimate = impact.error_estimate();
        assert!(estimate > 1e-12 && estimate < 1e-4, "{estimate:e}");
        let trace = TorsionalImpact::trace(groups, &velocities(4001)).unwrap();
        assert!((trace[4000].spin - impact.spin_ratio()).abs() < 3.0 * estimate + 1e-9);
        let mut impulse = 0.0;
        for pair in trace.windows(2) {
            let (p, q) = (pair[0], pair[1]);
            let limit = 3.0 * std::f64::consts::PI / 32.0 * q.radius.powi(4) / omega;
            assert!(q.torque.abs() <= limit * (1.0 + 1e-9) + 1e-15, "{q:?}");
            impulse += 0.5 * (p.torque + q.torque) * (q.time - p.time);
            assert!((1.0 - epsilon * impulse - q.spin).abs() < 1e-9, "{q:?}");
        }
        assert!(trace.iter().any(|point| point.spin * point.torque < 0.0));
        assert!(trace[4000].spin.powi(2) < 1.0);
        // Continuous in Omega, whichever way it was found.
        let near = solve(epsilon, omega * 1.001);
        let jump = (near.spin_ratio() - impact.spin_ratio()).abs();
        assert!(jump < 3e-3 + 2.0 * estimate, "{jump:e}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn the_ratio_lies_above_both_asymptotes_and_no_energy_is_won(
        epsilon in 1e-4..0.825f64,
        log_omega in -9.0..4.0f64,
    ) {
        let omega = libm::pow(10.0, log_omega);
        let ratio = solve(epsilon, omega).spin_ratio();
        prop_assert!(ratio >= limits::no_slip(epsilon).unwrap() - 1e-12);
        prop_assert!(ratio >= limits::sliding(epsilon, omega) - 1e-12);
        prop_assert!((0.0..=1.0).contains(&ratio));
    }

    #[test]
    fn energy_falls_once_slip_begins(epsilon in 0.01..0.8f64, omega in 0.02..3.0f64) {
        let groups = TorsionalGroups::new(epsilon, omega).unwrap();
        let trace = TorsionalImpact::trace(groups, &velocities(401)).unwrap();
        let mut history = TwistHistory::new();
        let mut last = 0.5;
        for point in &trace[..400] {
            history.advance(point.radius, omega * point.twist).unwrap();
            // eps mu/Omega is conjugate to the twist by Omega.
            let stored = epsilon * history.stored_energy() / (omega * omega);
            let energy = 0.5 * point.spin * point.spin + stored;
            prop_assert!(energy <= last + 1e-3 * epsilon, "{} {energy} {last}", point.time);
            prop_assert!(point.torque.abs() * omega
                <= 3.0 * std::f64::consts::PI / 32.0 * point.radius.powi(4) * (1.0 + 1e-9));
            last = energy.min(last);
        }
    }

    #[test]
    fn the_ratio_rises_with_omega(epsilon in 0.01..0.8f64, omega in 0.001..10.0f64) {
        let (low, high) = (solve(epsilon, omega), solve(epsilon, 1.1 * omega));
        prop_assert!(low.spin_ratio() < high.spin_ratio());
    }
}

#[test]
fn a_spinner_is_the_solid_sphere() {
    let (mass, radius) = (0.04, 0.02);
    let theta = Inertia::solid_sphere(mass, radius).unwrap().moments()[2];
    let rubber = Material::from_shear(1e6, 0.4).unwrap();
    let sphere = PrincipalRadii::sphere(radius).unwrap();
    let gap = RelativeCurvature::new(sphere, PrincipalRadii::PLANE, 0.0).unwrap();
    let hertz = Hertz::new(gap, MaterialPair::new(rubber, rubber).unwrap()).unwrap();
    let groups = |ball: Spinner| {
        let bodies = [ball.spinning(31.0).unwrap(), Spinner::held_fast()];
        let friction = Friction::new(0.7).unwrap();
        SpinCollision::new(&hertz, friction, bodies, 1.3).unwrap().groups().unwrap()
    };
    let own = groups(Spinner::solid_sphere(mass, radius).unwrap());
    assert_eq!(own, groups(Spinner::new(mass, theta).unwrap()));
}
