//! Energies, tangents, frames and limits of the law.

use super::*;
use crate::accounted::Accounted;
use crate::law::Energies;
use crate::memory::Fixed;
use approx::assert_relative_eq;

fn law<V: Lateral>(friction: f64) -> ShiftLaw<V> {
    let stiffness = ContactStiffness::new(0.9, 0.7, 1.1).unwrap();
    ShiftLaw::with_fixed_direction(stiffness, Friction::new(friction).unwrap())
}

fn accounted(friction: f64) -> Accounted<ShiftLaw<[f64; 2]>> {
    Accounted::new(law(friction))
}

fn at(zeta: f64, xi: f64, eta: f64) -> Shift {
    Shift { zeta, xi, eta, omega: 0.0 }
}

const PATH: [(f64, f64, f64); 6] = [
    (1.0, 0.0, 0.0),
    (1.0, 0.25, 0.1),
    (1.2, 0.2, 0.3),
    (0.9, -0.3, 0.2),
    (0.5, -1.2, 0.4),
    (0.6, -1.15, 0.4),
];

#[test]
fn work_is_stored_or_lost_in_every_limit_of_friction() {
    for friction in [0.0, 0.3, 5.0, f64::INFINITY] {
        balance(accounted(friction), 4000, 3e-7);
        // What joins change is within the tolerance.
        balance(Accounted::new(turning(friction, 1e-5)), 150, 5e-5);
    }
}

fn turning(friction: f64, tolerance: f64) -> ShiftLaw<[f64; 2]> {
    let stiffness = ContactStiffness::new(0.9, 0.7, 1.1).unwrap();
    let friction = Friction::new(friction).unwrap();
    ShiftLaw::with_tolerance(stiffness, friction, Tolerance::new(tolerance).unwrap())
}

fn balance(mut law: Accounted<ShiftLaw<[f64; 2]>>, n: u32, tolerance: f64) {
    let frictionless = matches!(law.law().state, State::Frictionless);
    let mut work = 0.0;
    for (zeta, xi, eta) in PATH {
        let from = law.shift();
        for i in 1..=n {
            let t = f64::from(i) / f64::from(n);
            let mix = |a: f64, b: f64| a + t * (b - a);
            let to = at(mix(from.zeta, zeta), mix(from.xi, xi), mix(from.eta, eta));
            let (p, s) = (law.load(), law.shift());
            let q = law.advance(to).unwrap();
            work += 0.5
                * ((p.f_x + q.f_x) * (to.xi - s.xi)
                    + (p.f_y + q.f_y) * (to.eta - s.eta)
                    + (p.f_z + q.f_z) * (to.zeta - s.zeta));
        }
    }
    let balance = law.stored_energy() + law.dissipated();
    assert_relative_eq!(work, balance, max_relative = tolerance);
    if frictionless {
        assert_eq!((law.load().f_x, law.dissipated()), (0.0, 0.0));
    } else {
        assert!(law.dissipated() > 0.0);
    }
}

#[test]
fn heat_of_a_step_is_that_of_its_parts() {
    let (mut whole, mut parts) = (accounted(0.3), accounted(0.3));
    for (zeta, xi, eta) in PATH {
        let from = whole.shift();
        whole.advance(at(zeta, xi, eta)).unwrap();
        for i in 1..=16 {
            let t = f64::from(i) / 16.0;
            let mix = |a: f64, b: f64| a + t * (b - a);
            let to = at(mix(from.zeta, zeta), mix(from.xi, xi), mix(from.eta, eta));
            parts.advance(to).unwrap();
        }
        assert_relative_eq!(whole.dissipated(), parts.dissipated(), max_relative = 1e-9);
        assert_relative_eq!(whole.load().f_x, parts.load().f_x, max_relative = 1e-12);
    }
}

#[test]
fn infinite_friction_is_the_limit_of_much() {
    let (mut much, mut stuck) = (Accounted::new(turning(1e9, 1e-2)), accounted(f64::INFINITY));
    for (zeta, xi, eta) in PATH {
        much.advance(at(zeta, xi, eta)).unwrap();
        stuck.advance(at(zeta, xi, eta)).unwrap();
        assert_relative_eq!(much.load().f_x, stuck.load().f_x, max_relative = 1e-8);
        assert_relative_eq!(much.load().f_y, stuck.load().f_y, max_relative = 1e-8);
        assert_relative_eq!(much.stored_energy(), stuck.stored_energy(), max_relative = 1e-8);
        // Slip of the order 1/f remains at finite friction.
        assert!((much.dissipated() - stuck.dissipated()).abs() < 1e-8 * much.stored_energy());
    }
}

#[test]
fn tangent_is_the_derivative_of_the_step() {
    let mut law = law::<[f64; 2]>(0.3);
    let h = 1e-7;
    for (zeta, xi, eta) in PATH {
        let end = |z: f64, x: f64, y: f64| {
            let mut trial = law.clone();
            let load = trial.advance(at(z, x, y)).unwrap();
            ([load.f_x, load.f_y, load.f_z], trial.tangent(), trial.regime())
        };
        let (_, tangent, regime) = end(zeta, xi, eta);
        let difference =
            |i: usize, plus: [f64; 3], minus: [f64; 3]| (plus[i] - minus[i]) / (2.0 * h);
        for (i, row) in tangent.iter().enumerate() {
            let numeric = [
                difference(i, end(zeta, xi + h, eta).0, end(zeta, xi - h, eta).0),
                difference(i, end(zeta, xi, eta + h).0, end(zeta, xi, eta - h).0),
                difference(i, end(zeta + h, xi, eta).0, end(zeta - h, xi, eta).0),
            ];
            // Sliding reports the tangent of the last instant, not of the whole step.
            if regime != Regime::Sliding {
                for (got, want) in row.iter().zip(numeric) {
                    assert!((got - want).abs() < 1e-6, "{regime:?} row {i}: {got} {want}");
                }
            }
        }
        law.advance(at(zeta, xi, eta)).unwrap();
    }
}

#[test]
fn failed_step_leaves_the_state() {
    let mut law = law::<f64>(0.3);
    law.advance(at(1.0, 0.1, 0.0)).unwrap();
    let before = law.clone();
    assert_eq!(law.advance(at(1.0, 0.1, 0.1)).unwrap_err().field, "eta");
    assert_eq!(law.advance(at(f64::NAN, 0.1, 0.0)).unwrap_err().field, "zeta");
    assert_eq!(law.advance(at(1.0, f64::INFINITY, 0.0)).unwrap_err().field, "xi");
    assert_eq!(law, before);
}

#[test]
fn is_plain_data_on_a_fixed_stack() {
    fn plain<T: Copy + Send + Sync>() -> usize {
        size_of::<T>()
    }
    assert_eq!(plain::<ShiftLaw<f64, Fixed<f64, 16>>>(), 944);
    assert_eq!(plain::<ShiftLaw<[f64; 2], Fixed<[f64; 2], 16>>>(), 1440);
    assert_eq!(plain::<ShiftLaw<f64, Fixed<f64, 4>>>(), 368);
    assert!(size_of::<ShiftLaw<f64>>() <= 584 && size_of::<ShiftLaw<[f64; 2]>>() <= 864);
}

#[test]
fn the_smallest_growth_gives_no_nan() {
    let stiffness = ContactStiffness::new(0.9, 0.9, 1.1).unwrap();
    for friction in [0.3, f64::INFINITY] {
        let mut law =
            ShiftLaw::<[f64; 2]>::with_fixed_direction(stiffness, Friction::new(friction).unwrap());
        for zeta in [2.6e-309, 5e-309, 1.0] {
            let load = law.advance(at(zeta, 0.0, 0.0)).unwrap();
            assert!(load.f_x == 0.0 && load.f_y == 0.0, "{friction} {zeta}: {load:?}");
        }
        assert!(law.advance(at(1.0, 0.1, 0.0)).unwrap().f_x > 0.0);
    }
}

#[test]
fn turned_frame_carries_the_law_along() {
    for friction in [0.0, 0.3, f64::INFINITY] {
        let stiffness = ContactStiffness::new(0.9, 0.9, 1.1).unwrap();
        let round =
            ShiftLaw::<[f64; 2]>::with_fixed_direction(stiffness, Friction::new(friction).unwrap());
        let (mut fixed, mut turning) = (Accounted::new(round.clone()), Accounted::new(round));
        let mut angle = 0.0_f64;
        for (i, (zeta, xi, eta)) in PATH.into_iter().enumerate() {
            let (s, c) = angle.sin_cos();
            let want = fixed.advance(at(zeta, xi, eta)).unwrap();
            let got = turning.advance(at(zeta, c * xi + s * eta, c * eta - s * xi)).unwrap();
            assert_relative_eq!(got.f_x, c * want.f_x + s * want.f_y, epsilon = 1e-14);
            assert_relative_eq!(got.f_y, c * want.f_y - s * want.f_x, epsilon = 1e-14);
            let by = 0.4 + 0.3 * i as f64;
            turning.turn_frame(by);
            angle += by;
        }
        assert_relative_eq!(fixed.dissipated(), turning.dissipated(), max_relative = 1e-11);
        assert_relative_eq!(fixed.stored_energy(), turning.stored_energy(), epsilon = 1e-13);
    }
    // On an ellipse the load is the same vector, and the next step begins where the last ended.
    let mut law = law::<[f64; 2]>(0.3);
    for (zeta, xi, eta) in PATH {
        law.advance(at(zeta, xi, eta)).unwrap();
    }
    let (before, angle) = (law.load(), 0.7_f64);
    law.turn_frame(angle);
    let again = law.advance(law.shift()).unwrap();
    let (s, c) = angle.sin_cos();
    assert_relative_eq!(again.f_x, c * before.f_x + s * before.f_y, epsilon = 1e-14);
    assert_relative_eq!(again.f_y, c * before.f_y - s * before.f_x, epsilon = 1e-14);
}
