//! The state of a contact stored as plain numbers.

use carom_laws::coulomb::{Tolerance, packed_numbers};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Dissipative, Shift};
use carom_laws::memory::Fixed;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use proptest::prelude::*;

type Law = ShiftLaw<[f64; 2], Fixed<[f64; 2], 12>>;
type Numbers = [f64; packed_numbers(12)];

fn laws(friction: f64) -> [Law; 2] {
    let stiffness = ContactStiffness::new(3e9, 2.6e9, 4e9).unwrap();
    let friction = Friction::new(friction).unwrap();
    [
        Law::with_fixed_direction(stiffness, friction),
        Law::with_tolerance(stiffness, friction, Tolerance::PARTICLES),
    ]
}

/// A random walk in approach and shift, in micrometres, that touches, slips, turns and parts.
fn walks() -> impl Strategy<Value = Vec<Shift>> {
    let step = (-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64, 0..4_u8);
    prop::collection::vec(step, 1..80).prop_map(|steps| {
        let (mut zeta, mut xi, mut eta) = (-0.1, 0.0, 0.0);
        let walk = steps.into_iter().map(|(dz, dx, dy, kind)| {
            let (along, across) = if kind == 0 { (0.5, 0.0) } else { (0.05, 0.3) };
            zeta = (zeta + along * dz).clamp(-0.2, 3.0);
            (xi, eta) = (xi + across * dx, eta + across * dy);
            Shift { zeta: 1e-6 * zeta, xi: 1e-6 * xi, eta: 1e-6 * eta, omega: 0.0 }
        });
        walk.collect()
    })
}

proptest! {
    /// One contact is kept as a law, the other as numbers between any two steps.
    #[test]
    fn a_contact_kept_in_numbers_goes_the_same_way(walk in walks(), friction in 0.05..1.0_f64) {
        for fresh in laws(friction) {
            let mut law = fresh;
            let mut numbers: Numbers = [0.0; packed_numbers(12)];
            for shift in &walk {
                let load = law.advance(*shift).unwrap();
                let mut other = fresh;
                other.unpack(&numbers).unwrap();
                let heat = other.dissipation(*shift);
                let again = other.advance(*shift).unwrap();
                other.pack(&mut numbers).unwrap();
                let size = 1e-9 * friction * 4e9 * 3e-6_f64.powf(1.5);
                prop_assert_eq!(load.f_z, again.f_z);
                prop_assert!((load.f_x - again.f_x).abs() <= size, "{load:?} {again:?}");
                prop_assert!((load.f_y - again.f_y).abs() <= size, "{load:?} {again:?}");
                prop_assert_eq!(law.regime(), other.regime());
                prop_assert!(heat.is_finite());
            }
        }
    }
}

/// Numbers whose annuli carry more than friction lets them, or a load without annuli, are no state.
#[test]
fn numbers_beyond_friction_are_refused() {
    let [fixed, mut law] = laws(0.3);
    let mut state = [0.0; packed_numbers(12)];
    for [xi, eta] in [[0.0, 0.0], [2.0, 0.3], [2.5, 1.0]] {
        law.advance(Shift { zeta: 1e-6, xi: 1e-6 * xi, eta: 1e-6 * eta, omega: 0.0 }).unwrap();
    }
    law.pack(&mut state).unwrap();
    let refused = |mut law: Law, numbers: Numbers| law.unpack(&numbers).unwrap_err().field;
    let mut shorter = state;
    shorter[5] = 0.0;
    assert_eq!(refused(law, shorter), "extent");
    // It slides: a tenth of the approach farther along the force, the force is beyond its limit.
    let mut farther = state;
    farther[2..4].iter_mut().for_each(|x| *x += 7e-8);
    farther[5] += 1e-7;
    assert_eq!(refused(law, farther), "force");
    let mut empty = [0.0; packed_numbers(12)];
    empty[..2].copy_from_slice(&[2e4, 1e-6]);
    assert_eq!(refused(fixed, empty), "approach");
}

#[test]
fn the_limits_of_friction() {
    let stiffness = ContactStiffness::new(1.0, 1.0, 1.2).unwrap();
    let mut numbers = [5.0; packed_numbers(12)];
    let mut free = Law::new(stiffness, Friction::NONE);
    let shift = Shift { zeta: 1.0, xi: 0.2, ..Shift::default() };
    free.advance(shift).unwrap();
    free.pack(&mut numbers).unwrap();
    let mut again = Law::new(stiffness, Friction::NONE);
    again.unpack(&numbers).unwrap();
    assert_eq!(again, free);
    let mut rubbing = Law::new(stiffness, Friction::new(0.3).unwrap());
    assert_eq!(rubbing.unpack(&numbers).unwrap_err().field, "mark");
}

/// Without slip a vertex takes more room, and comes back to the same bits.
#[test]
fn infinite_friction() {
    let stiffness = ContactStiffness::new(1.0, 0.8, 1.2).unwrap();
    let fresh = Law::new(stiffness, Friction::INFINITE);
    let mut law = fresh;
    for i in 1..30 {
        let t = f64::from(i);
        let zeta = 1.0 + 0.05 * t + 0.3 * t.sin();
        law.advance(Shift { zeta, xi: t.cos(), eta: (2.0 * t).sin(), omega: 0.0 }).unwrap();
    }
    assert_eq!(law.pack(&mut [0.0; packed_numbers(12)]).unwrap_err().field, "numbers");
    let mut numbers = [5.0; 6 + 9 * 12];
    law.pack(&mut numbers).unwrap();
    let mut again = fresh;
    again.unpack(&numbers).unwrap();
    assert_eq!(again.load(), law.load());
    let to = Shift { zeta: 0.7, xi: 0.1, eta: -0.3, omega: 0.0 };
    assert_eq!(again.advance(to), law.advance(to));
    assert_eq!(Law::new(stiffness, Friction::NONE).unpack(&numbers).unwrap_err().field, "mark");
}
