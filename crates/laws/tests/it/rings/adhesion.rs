//! Contacts that stick from the first contact on have closed forms.

use super::common::{alike, law, law_of, shift};
use carom_laws::law::ContactLaw;
use carom_laws::rings::RingLaw;

/// In adhesion dF = c_x zeta^(1/2) dxi, whatever the step: two thirds of the stiffness where the shift grows
/// with the approach.
fn oblique<const N: usize>(within: f64) {
    for kappa in [1.0, 7.0 / 6.0, 1.5] {
        for friction in [f64::INFINITY, 1e6, 5.0] {
            let mut law = law_of::<N, 8>([kappa, 0.0, friction], 1e-4);
            let load = law.advance(shift([0.7, 1.1, 0.5, 0.0])).unwrap();
            let want = 2.0 / 3.0 * 4.0 / kappa * 0.7_f64.sqrt();
            let off =
                (load.f_x / (want * 1.1) - 1.0).abs().max((load.f_y / (want * 0.5) - 1.0).abs());
            assert!(off < within, "{N} rings, kappa {kappa}, f {friction}: {off:e}");
            // In ten steps as in one.
            let mut law = law_of::<N, 8>([kappa, 0.0, friction], 1e-4);
            for k in 1..=10 {
                let part = f64::from(k) / 10.0;
                law.advance(shift([0.7 * part, 1.1 * part, 0.5 * part, 0.0])).unwrap();
            }
            let off = (law.load().f_x / load.f_x - 1.0).abs();
            assert!(off < 3e-3, "{N} rings, kappa {kappa}, f {friction}: {off:e} by ten steps");
        }
    }
}

#[test]
fn oblique_loading_without_slip_is_exact_in_one_step() {
    oblique::<6>(1e-3);
    oblique::<8>(1e-3);
    oblique::<16>(1e-3);
}

#[test]
fn stiffness_after_pressing_is_mindlins_and_reissners() {
    for poisson in [0.0, 0.3, 0.5] {
        let hertz = alike(poisson);
        let mut law = law::<8, 8>(&hertz, f64::INFINITY, 1e-4);
        law.advance(shift([1.0, 0.0, 0.0, 0.0])).unwrap();
        let load = law.advance(shift([1.0, 1e-3, 0.0, 1e-3])).unwrap();
        assert!((load.f_x / (1e-3 * hertz.stiffness().c_x) - 1.0).abs() < 2e-4);
        // (16/3) G a^3, G = 1 combined.
        assert!((load.m_z / (1e-3 * 16.0 / 3.0) - 1.0).abs() < 2e-4, "{}", load.m_z);
        assert!(load.f_y.abs() < 1e-16);
    }
}

/// Where a shift would part the coupled bodies their tension was left out of the normal force, which grew without limit.
/// The fuzzer found it.
#[test]
fn a_shift_without_slip_leaves_the_normal_force() {
    for gamma in [0.1, 0.3, -0.3] {
        let fresh = law_of::<6, 8>([1.2, gamma, f64::INFINITY], 1e-2);
        let pressed = fresh.clone().advance(shift([0.0014, 0.0, 0.0, 0.0])).unwrap().f_z;
        let mut law = fresh.clone();
        for at in [[0.0014, 0.005, -0.2, 0.0], [0.0014, 0.3, 0.5, 0.1]] {
            let f_z = law.advance(shift(at)).unwrap().f_z;
            assert!((f_z / pressed - 1.0).abs() < 1e-10, "{gamma} {at:?}: {f_z:e} {pressed:e}");
        }
        // What sticks while it is pressed is stiffer, by little.
        let more = pressed / (8.0 / 3.0 * 0.0014_f64.powf(1.5)) - 1.0;
        assert!(more > 0.0 && more < 0.03, "{gamma}: {more}");
    }
}

/// Without slip the axisymmetric part of the contact is similar to itself at each radius: F_z is Hertz's force times a
/// constant, on any path. The pressures by a shift have no mean; far beyond the approach their rounding exceeded F_z. The
/// fuzzer found it.
#[test]
fn without_slip_the_normal_force_is_hertzs_times_a_constant() {
    for gamma in [0.1_f64, 0.3, -0.3, 0.5] {
        let fresh = law_of::<6, 8>([1.2, gamma, f64::INFINITY], 1e-2);
        let over_hertz = |at: [f64; 4], law: &mut RingLaw<6, 8>| {
            law.advance(shift(at)).unwrap().f_z / (8.0 / 3.0 * at[0] * at[0].sqrt())
        };
        let pressed = over_hertz([1.0, 0.0, 0.0, 0.0], &mut fresh.clone());
        // Punches that stick, of growing radius, would be stiffer by atanh(gamma)/gamma.
        assert!(pressed > 1.0 && pressed < gamma.atanh() / gamma, "{gamma}: {pressed}");
        let mut law = fresh.clone();
        for at in [
            [0.3, 0.0, 0.0, 0.0],
            [0.3, 1e36, -3e35, 1e36],
            [0.7, 1e36, 2e35, 0.0],
            [0.01, 1.0, 0.0, 0.0],
            [0.02, 1.0, 0.0, 1e20],
        ] {
            let now = over_hertz(at, &mut law);
            assert!((now / pressed - 1.0).abs() < 1e-14, "{gamma} {at:?}: {now} {pressed}");
        }
    }
}
