//! DIRT's bench of oblique impact with carom's contact, against the exact impact.

#[path = "../examples/compare/trial.rs"]
mod trial;

use trial::{Contact, FRICTION, Trial};

const PSI: [f64; 9] = [0.05, 0.3, 0.8, 1.2, 2.0, 3.3, 5.0, 7.0, 9.5];

/// The largest error of R_x.
fn error(psi: &[f64], approach: f64, step: f64) -> f64 {
    let error = |psi: &f64| {
        let trial = Trial { approach, step, ..Trial::elastic(*psi) };
        (trial.run(Contact::Caroms).r_x() - trial.exact()).abs()
    };
    psi.iter().map(error).fold(0.0, f64::max)
}

#[test]
fn r_x_is_that_of_the_exact_impact() {
    let error = error(&PSI, 1.0, 1e-7);
    assert!(error < 4e-3, "{error}");
}

/// At 1 m/s the spheres move on by 0.2 % of their distance during the contact, so that the normal turns; the exact impact
/// has a fixed normal. Slower, they move less, by (v/v_0)^(4/5).
#[test]
fn slow_impacts_are_nearer_to_the_exact_one() {
    let error = error(&[0.3, 2.0, 9.5], 0.1, 1e-6);
    assert!(error < 1e-3, "{error}");
}

/// 24 steps during the contact instead of 240.
#[test]
fn r_x_needs_few_steps() {
    let error = error(&PSI, 1.0, 1e-6);
    assert!(error < 4e-3, "{error}");
}

#[test]
fn a_steep_impact_without_damping_loses_no_normal_velocity() {
    let restitution = Trial::elastic(0.05).run(Contact::Caroms).restitution();
    assert!((restitution - 1.0).abs() < 1e-5, "{restitution}");
}

#[test]
fn no_impact_gains_energy_or_exceeds_coulombs_limit() {
    for psi in PSI {
        let bounce = Trial::elastic(psi).run(Contact::Caroms);
        assert!(bounce.energy() < 1.0, "psi {psi}: {}", bounce.energy());
        // The normal of the first touch is not quite that of the whole impulse.
        assert!(bounce.grip() < FRICTION * 1.03, "psi {psi}: {}", bounce.grip());
    }
}

/// It leaves the tangential velocity of steep impacts as it was, R_x = -1, where elastic spheres turn more than half of
/// it into spin.
#[test]
fn dirts_own_contact_does_not_grip_in_steep_impacts() {
    for psi in [0.05, 0.3] {
        let trial = Trial::elastic(psi);
        let (own, exact) = (trial.run(Contact::Dirts).r_x(), trial.exact());
        assert!(own < -0.99 && exact > -0.3, "psi {psi}: {own} for {exact}");
    }
}
