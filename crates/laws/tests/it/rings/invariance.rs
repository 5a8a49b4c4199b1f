//! Invariance under rotations, reflections, the exchange of bodies, and a shift of the origin.

use super::common::{law, law_of, path, shift, unlike};
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::rings::RingLaw;

fn follow(law: &RingLaw<6, 8>, path: &[Shift], by: impl Fn(&Shift) -> Shift) -> Vec<ContactLoad> {
    let mut law = law.clone();
    path.iter().map(|at| law.advance(by(at)).unwrap()).collect()
}

fn greatest(
    one: &[ContactLoad],
    two: &[ContactLoad],
    of: impl Fn(&ContactLoad) -> [f64; 4],
) -> f64 {
    let mut worst = 0.0_f64;
    for (a, b) in one.iter().zip(two) {
        let want = of(a);
        for (x, y) in want.into_iter().zip([b.f_x, b.f_y, b.f_z, b.m_z]) {
            worst = worst.max((x - y).abs());
        }
    }
    worst
}

#[test]
fn an_eighth_of_a_turn_turns_the_force() {
    let law = law::<6, 8>(&unlike(), 0.3, 1e-3);
    let path = path(3, 6, 10, [0.4, 0.4]);
    let straight = follow(&law, &path, |at| *at);
    let root = std::f64::consts::FRAC_1_SQRT_2;
    let turned = |x: f64, y: f64| [root * (x - y), root * (x + y)];
    let after = follow(&law, &path, |at| {
        let [xi, eta] = turned(at.xi, at.eta);
        Shift { xi, eta, ..*at }
    });
    let off = greatest(&straight, &after, |load| {
        let [x, y] = turned(load.f_x, load.f_y);
        [x, y, load.f_z, load.m_z]
    });
    assert!(off < 1e-11, "{off:e}");
}

#[test]
fn a_mirror_reverses_twist_and_what_is_across() {
    let law = law::<6, 8>(&unlike(), 0.3, 1e-3);
    let path = path(4, 6, 10, [0.4, 0.4]);
    let straight = follow(&law, &path, |at| *at);
    let mirrored = follow(&law, &path, |at| Shift { eta: -at.eta, omega: -at.omega, ..*at });
    let off = greatest(&straight, &mirrored, |load| [load.f_x, -load.f_y, load.f_z, -load.m_z]);
    assert!(off < 1e-11, "{off:e}");
}

#[test]
fn bodies_exchanged_feel_the_opposite() {
    // Seen from the other body z and, by a half turn about x, y are reversed: shifts (xi, -eta) of 1 against 2
    // are (-xi, eta) of 2 against 1, and the twist changes neither its sign nor its vector.
    let path = path(5, 6, 10, [0.4, 0.4]);
    let one = follow(&law_of([7.0 / 6.0, 0.3, 0.3], 1e-3), &path, |at| *at);
    let two = follow(&law_of([7.0 / 6.0, -0.3, 0.3], 1e-3), &path, |at| Shift {
        xi: -at.xi,
        eta: at.eta,
        zeta: at.zeta,
        omega: at.omega,
    });
    let off = greatest(&one, &two, |load| [-load.f_x, load.f_y, load.f_z, load.m_z]);
    assert!(off < 1e-10, "{off:e}");
    // The same sign instead is another contact.
    let same =
        follow(&law_of([7.0 / 6.0, 0.3, 0.3], 1e-3), &path, |at| Shift { xi: -at.xi, ..*at });
    let off = greatest(&one, &same, |load| [-load.f_x, load.f_y, load.f_z, load.m_z]);
    assert!(off > 0.01, "{off:e}");
}

#[test]
fn where_the_bodies_touch_does_not_matter() {
    let law = law::<6, 8>(&unlike(), 0.3, 1e-3);
    let path = path(6, 6, 10, [0.4, 0.4]);
    let here = follow(&law, &path, |at| *at);
    let mut there = law;
    there.advance(shift([-1.0, 5.0, -7.0, 3.0])).unwrap();
    there.advance(shift([0.0, 5.0, -7.0, 3.0])).unwrap();
    let there = follow(&there, &path, |at| Shift {
        xi: at.xi + 5.0,
        eta: at.eta - 7.0,
        omega: at.omega + 3.0,
        ..*at
    });
    assert!(greatest(&here, &there, |load| [load.f_x, load.f_y, load.f_z, load.m_z]) < 1e-10);
}

#[test]
fn size_does_not_matter() {
    let path = path(8, 4, 10, [0.4, 0.4]);
    let law = law_of::<6, 8>([1.2, 0.2, 0.3], 1e-3);
    let here = follow(&law, &path, |at| *at);
    // Approach and shifts 4 times, the radius and the twist by it 2 times, forces 8 times as large.
    let large =
        follow(&law, &path, |at| shift([4.0 * at.zeta, 4.0 * at.xi, 4.0 * at.eta, 2.0 * at.omega]));
    let off = greatest(&here, &large, |load| {
        [8.0 * load.f_x, 8.0 * load.f_y, 8.0 * load.f_z, 16.0 * load.m_z]
    });
    assert!(off < 1e-10, "{off:e}");
}

/// An exchange of the bodies turns the axes half about x, and reverses shift and force: the same bits.
#[test]
fn exchanged_bodies_have_the_same_bits() {
    let hertz = |poisson| super::common::hertz([2.0, 2.0], poisson);
    let mut one = law::<6, 8>(&hertz([0.0, 0.5]), 0.3, 1e-2);
    let mut other = law::<6, 8>(&hertz([0.5, 0.0]), 0.3, 1e-2);
    for at in path(21, 6, 10, [0.4, 0.4]) {
        let load = one.advance(at).unwrap();
        let exchanged = other.advance(Shift { xi: -at.xi, ..at }).unwrap();
        assert_eq!((load.f_x, load.f_y), (-exchanged.f_x, exchanged.f_y));
        assert_eq!((load.f_z, load.m_z), (exchanged.f_z, exchanged.m_z));
        for angle in 0..8 {
            let [radial, around] = one.traction(3, angle).unwrap();
            let opposite = other.traction(3, (8 - angle) % 8).unwrap();
            assert_eq!(opposite, [-radial, around]);
        }
    }
}
