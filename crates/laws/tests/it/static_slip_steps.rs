//! Steps of a law with static friction above kinetic friction: one as a thousand, along a line, in turned axes, from packed
//! numbers, refused, and of any size.

use approx::assert_relative_eq;
use carom_laws::accounted::Accounted;
use carom_laws::coulomb::{Tolerance, packed_numbers};
use carom_laws::law::{ContactLaw, Dissipative, Energies, Shift};
use carom_laws::memory::{Fixed, MemoryRegime};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::turning_law::TurningLaw::{self, Coulomb, FixedDirection};
use proptest::prelude::*;

use crate::static_slip::{C_X, F_K, F_S, at, between, friction, law, off, path, stiffness};

/// The law of shifts along a line.
fn on_a_line(turning: TurningLaw, (f_s, f_k): (f64, f64)) -> ShiftLaw<f64> {
    let friction = friction(f_s, f_k);
    ShiftLaw::with_static_friction(turning, stiffness(C_X), friction, Tolerance::default())
}

#[test]
fn along_a_line_it_is_the_law_of_a_line() {
    for turning in [Coulomb, FixedDirection] {
        for (f_s, f_k) in [(F_S, F_K), (0.4, 0.0), (0.4, 0.39), (1e3, 1e-20)] {
            let mut worst = 0.0_f64;
            for seed in 0..30 {
                let (sin, cos) = (0.3 * seed as f64).sin_cos();
                let mut turns = Accounted::new(law(turning, (f_s, f_k), C_X));
                let mut line = Accounted::new(on_a_line(turning, (f_s, f_k)));
                for Shift { zeta, xi, .. } in path(seed, 60, 3.2 * f_s) {
                    let to = at(zeta, cos * xi, sin * xi);
                    assert_eq!(turns.jumps(to), line.jumps(at(zeta, xi, 0.0)), "{seed} {to:?}");
                    let (got, want) =
                        (turns.advance(to).unwrap(), line.advance(at(zeta, xi, 0.0)).unwrap());
                    worst =
                        worst.max((got.f_x - cos * want.f_x).hypot(got.f_y - sin * want.f_x) / f_s);
                    assert_eq!(
                        turns.law().regime() == MemoryRegime::Sliding,
                        line.law().regime() == MemoryRegime::Sliding
                    );
                    assert_relative_eq!(
                        turns.stored_energy(),
                        line.stored_energy(),
                        max_relative = 1e-10,
                        epsilon = 1e-14
                    );
                    assert_relative_eq!(
                        turns.dissipated(),
                        line.dissipated(),
                        max_relative = 1e-9,
                        epsilon = 1e-12
                    );
                }
            }
            println!("{turning} {f_s} {f_k}: {worst:e}");
            assert!(worst < 1e-11, "{turning} {f_s} {f_k}: {worst:e}");
        }
    }
}

#[test]
fn one_step_along_a_line_is_a_thousand() {
    for seed in 0..20 {
        let [mut whole, mut parts] =
            [(); 2].map(|()| Accounted::new(on_a_line(FixedDirection, (F_S, F_K))));
        for to in path(seed, 40, 1.6) {
            let (from, to) = (whole.shift(), Shift { eta: 0.0, ..to });
            let one = whole.advance(to).unwrap();
            for i in 1..=1000 {
                parts.advance(between(from, to, f64::from(i) / 1000.0)).unwrap();
            }
            assert!(off(one, parts.load()) < 1e-11, "{seed} {to:?}: {one:?} {:?}", parts.load());
            let heats = [whole.dissipated(), parts.dissipated()];
            assert_relative_eq!(heats[0], heats[1], max_relative = 1e-8, epsilon = 1e-10);
        }
        assert!(whole.dissipated() > 0.0);
    }
}

#[test]
fn packed_numbers_go_on() {
    for turning in [Coulomb, FixedDirection] {
        type Stored = ShiftLaw<[f64; 2], Fixed<[f64; 2], 12>>;
        let (tolerance, f) = (Tolerance::PARTICLES, friction(F_S, F_K));
        let fresh = Stored::with_static_friction(turning, stiffness(0.7), f, tolerance);
        let (mut one, mut slid) = (fresh, 0);
        for to in path(21, 400, 1.4) {
            let mut numbers = [0.0; packed_numbers(12)];
            one.pack(&mut numbers).unwrap();
            let mut two = fresh;
            two.unpack(&numbers).unwrap();
            assert_eq!(one.regime(), two.regime());
            assert!(off(one.load(), two.load()) < 1e-12);
            slid += usize::from(one.regime() == MemoryRegime::Sliding);
            one.advance(to).unwrap();
            two.advance(to).unwrap();
            assert!(off(one.load(), two.load()) < 1e-9, "{turning} {to:?}");
        }
        assert!(slid > 30, "{slid}");
        assert_eq!(one.friction(), f.threshold());
    }
}

#[test]
fn a_failed_step_leaves_the_state() {
    let mut law = law(Coulomb, (F_S, F_K), C_X);
    law.advance(at(1.0, 0.1, 0.2)).unwrap();
    let before = law.clone();
    assert_eq!(law.advance(at(f64::NAN, 0.1, 0.0)).unwrap_err().field, "zeta");
    assert_eq!(law.advance(at(1.0, 0.1, f64::INFINITY)).unwrap_err().field, "eta");
    assert!(!law.jumps(at(1.0, f64::NAN, 0.0)) && law == before);
    assert_eq!(law.dissipation(at(1.0, f64::NAN, 0.0)), 0.0);
    let mut line = on_a_line(FixedDirection, (F_S, F_K));
    line.advance(at(1.0, 0.1, 0.0)).unwrap();
    let (before, across) = (line.clone(), at(1.0, 0.1, 0.1));
    assert_eq!(line.advance(across).unwrap_err().field, "eta");
    assert!(!line.jumps(across) && line == before);
}

/// Where a shift has no digits for a stretch, a slide back kept the traction of the way there, and its stored state was
/// refused.
#[test]
fn a_slide_back_from_afar_turns_the_traction() {
    let (approach, room) = (0.12, packed_numbers(100));
    for turning in [FixedDirection, Coulomb] {
        for far in [1e3, 1e12, 1e15, 1e16, 1e17, 1e20, 7e38] {
            let mut law = law(turning, (F_S, F_K), C_X);
            law.advance(at(approach, -0.11, 0.0)).unwrap();
            for (to, sign) in [(far, 1.0), (0.0, -1.0), (far, 1.0), (-far, -1.0), (-0.5 * far, 1.0)]
            {
                let load = law.advance(at(approach, -0.11, to)).unwrap();
                assert_relative_eq!(load.f_y, sign * F_K * load.f_z, max_relative = 1e-6);
                assert!(load.f_x.abs() < 1e-2 * load.f_z, "{far:e} {to:e}: {load:?}");
                let mut numbers = vec![0.0; room];
                law.pack(&mut numbers).unwrap();
                law.unpack(&numbers).unwrap();
            }
        }
    }
}

/// Shifts and approaches of any size give numbers.
#[test]
fn extremes_give_numbers() {
    for turning in [Coulomb, FixedDirection] {
        for (f_s, f_k) in [(F_S, F_K), (0.4, 0.0), (1e30, 1e-30)] {
            let mut law = Accounted::new(law(turning, (f_s, f_k), C_X));
            for size in [1e-300, 1e-30, 1.0, 1e20] {
                for to in path(4, 20, 2.0) {
                    let load = law
                        .advance(at(size * to.zeta, size * to.xi, 1e-3 * size * to.eta))
                        .unwrap();
                    assert!(
                        load.f_x.is_finite() && load.f_y.is_finite(),
                        "{turning} {f_s} {size} {load:?}"
                    );
                    assert!(law.dissipated().is_finite() && law.stored_energy().is_finite());
                    assert!(law.law().tangent().iter().flatten().all(|rate| rate.is_finite()));
                }
            }
        }
    }
}

fn corners() -> impl Strategy<Value = Vec<Shift>> {
    let corner = (-0.05..1.15_f64, -1.0..1.0_f64, -1.0..1.0_f64);
    prop::collection::vec(corner, 2..12)
        .prop_map(|corners| corners.into_iter().map(|(zeta, xi, eta)| at(zeta, xi, eta)).collect())
}

fn any_law() -> impl Strategy<Value = TurningLaw> {
    prop::sample::select(vec![Coulomb, FixedDirection])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// No force exceeds static friction, and what slides has kinetic friction, but for the turning of
    /// its tractions.
    #[test]
    fn the_force_keeps_its_limits(turning in any_law(), f_k in 0.0..0.5_f64, path in corners()) {
        let mut law = law(turning, (F_S, f_k), C_X);
        for to in path {
            let load = law.advance(to).unwrap();
            let size = load.f_x.hypot(load.f_y);
            let f = if law.regime() == MemoryRegime::Sliding { f_k } else { F_S };
            prop_assert!(size <= (f + 1e-9) * load.f_z, "{size} {load:?}");
        }
    }

    /// Axes that are turned turn the force and leave the energies.
    #[test]
    fn turned_axes_turn_the_force(turning in any_law(), angle in 0.0..6.3_f64, path in corners()) {
        let law = law(turning, (F_S, F_K), C_X);
        let (mut one, mut two, mut frame) =
            (Accounted::new(law.clone()), Accounted::new(law.clone()), law);
        let (sin, cos) = angle.sin_cos();
        let turn = |x: f64, y: f64| (cos * x + sin * y, cos * y - sin * x);
        for to in path {
            let (xi, eta) = turn(to.xi, to.eta);
            let (a, b) = (one.advance(to).unwrap(), two.advance(at(to.zeta, xi, eta)).unwrap());
            let (f_x, f_y) = turn(a.f_x, a.f_y);
            prop_assert!((f_x - b.f_x).hypot(f_y - b.f_y) < 1e-9, "{a:?} {b:?}");
            prop_assert!((one.stored_energy() - two.stored_energy()).abs() < 1e-9);
            prop_assert!((one.dissipated() - two.dissipated()).abs() < 1e-9);
            frame.advance(to).unwrap();
            frame.turn_frame(angle);
            prop_assert!(off(frame.load(), b) < 1e-9);
            frame.turn_frame(-angle);
        }
    }

    /// A straight step is a thousand of its parts.
    #[test]
    fn one_step_is_a_thousand(turning in any_law(), path in corners()) {
        let law = law(turning, (F_S, F_K), C_X);
        let (mut whole, mut parts) = (law.clone(), law);
        for to in path {
            let from = whole.shift();
            let one = whole.advance(to).unwrap();
            (1..=1000).for_each(|i| { parts.advance(between(from, to, f64::from(i) / 1e3)).unwrap(); });
            prop_assert!(off(one, parts.load()) < 2e-3, "{to:?}: {one:?} {:?}", parts.load());
        }
    }

    /// Work is stored or heat, in steps so short that the work of the force is known.
    #[test]
    fn work_is_stored_or_heat(turning in any_law(), f_k in 0.0..0.5_f64, path in corners()) {
        let mut law = Accounted::new(law(turning, (F_S, f_k), C_X));
        let (mut work, mut scale, mut unknown) = (0.0, 1e-2_f64, 0.0);
        for to in path {
            let from = law.shift();
            for i in 1..=200 {
                let (s, p) = (law.shift(), law.load());
                let next = between(from, to, f64::from(i) / 200.0);
                let (before, jumps) = (law.dissipated(), law.jumps(next));
                let q = law.advance(next).unwrap();
                prop_assert!(law.dissipated() >= before);
                // Where in the step the force drops, the trapezoid does not know.
                let way = (next.xi - s.xi).hypot(next.eta - s.eta);
                unknown += if jumps { 0.5 * off(p, q) * way } else { 0.0 };
                work += 0.5
                    * ((p.f_x + q.f_x) * (next.xi - s.xi)
                        + (p.f_y + q.f_y) * (next.eta - s.eta)
                        + (p.f_z + q.f_z) * (next.zeta - s.zeta));
            }
            scale = scale.max(work.abs());
            let balance = law.stored_energy() + law.dissipated();
            prop_assert!((work - balance).abs() < 1e-3 * scale + unknown, "{to:?}: {work} {balance}");
        }
    }
}
