//! Motions in a plane with half and a quarter of the angles, compared with all of them.

use carom_drawn::{Congruential, Draw as _};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Dissipative, Shift};
use carom_laws::rings::{AlikePlane, Plane, RingConstants, RingLaw, Tolerance};

use super::common::{law_of, shift};

const CLOSE: f64 = 1e-6;

/// A path that presses, lifts and slides to and fro.
fn path(seed: u64) -> impl Iterator<Item = Shift> {
    let mut random = Congruential(seed);
    let (mut zeta, mut xi) = (0.0_f64, 0.0);
    (0..120).map(move |_| {
        zeta = (zeta + 0.05 * (random.signed() + 0.3)).clamp(0.01, 1.5);
        xi += 0.06 * random.signed();
        shift([zeta, xi, 0.0, 0.0])
    })
}

fn compare<L: ContactLaw + Dissipative, O: ContactLaw + Dissipative>(mut one: L, mut other: O)
where
    L::Error: std::fmt::Debug,
    O::Error: std::fmt::Debug,
{
    for (step, to) in path(3).enumerate() {
        let [heat, same] = [one.dissipation(to), other.dissipation(to)];
        let (a, b) = (one.advance(to).unwrap(), other.advance(to).unwrap());
        let room = 60.0 * CLOSE;
        assert!(
            (a.f_x - b.f_x).abs() < room && (a.f_z - b.f_z).abs() < room,
            "{step}: {a:?} {b:?}"
        );
        assert!((heat - same).abs() < room, "{step}: {heat} {same}");
        assert!((one.stored_energy() - other.stored_energy()).abs() < room);
        assert!(a.f_y == 0.0 && a.m_z == 0.0 && b.f_y.abs() < room && b.m_z.abs() < room);
    }
}

fn constants(kappa: f64, gamma: f64) -> RingConstants {
    RingConstants { c_z: 4.0, radius: 1.0, kappa, gamma }
}

#[test]
fn half_of_the_angles_are_enough_in_a_plane() {
    let close = Tolerance::new(CLOSE).unwrap();
    for [kappa, gamma, f] in [[1.2, 0.25, 0.2], [1.0, -0.4, 0.05], [1.4, 0.1, 3.0]] {
        let friction = Friction::new(f).unwrap();
        let half = RingLaw::<6, 5, Plane>::in_plane(constants(kappa, gamma), friction, close);
        compare(half.unwrap(), law_of::<6, 8>([kappa, gamma, f], CLOSE));
        let half = RingLaw::<4, 9, Plane>::in_plane(constants(kappa, gamma), friction, close);
        compare(half.unwrap(), law_of::<4, 16>([kappa, gamma, f], CLOSE));
    }
}

#[test]
fn a_quarter_of_the_angles_is_enough_in_a_plane_without_coupling() {
    let close = Tolerance::new(CLOSE).unwrap();
    for [kappa, f] in [[1.2, 0.2], [1.0, 0.05], [1.5, f64::INFINITY]] {
        let friction = Friction::new(f).unwrap();
        // Coupling is left out.
        let of = constants(kappa, 0.3);
        let quarter = RingLaw::<6, 3, AlikePlane>::alike_in_plane(of, friction, close);
        compare(quarter.unwrap(), law_of::<6, 8>([kappa, 0.0, f], CLOSE));
        let quarter = RingLaw::<4, 5, AlikePlane>::alike_in_plane(of, friction, close);
        compare(quarter.unwrap(), law_of::<4, 16>([kappa, 0.0, f], CLOSE));
    }
}

#[test]
fn shifts_out_of_the_plane_and_twists_are_refused() {
    let friction = Friction::new(0.2).unwrap();
    let mut law =
        RingLaw::<6, 5, Plane>::in_plane(constants(1.2, 0.2), friction, Tolerance::FINE).unwrap();
    law.advance(shift([1.0, 0.1, 0.0, 0.0])).unwrap();
    let before = law.load();
    for (to, field) in [([1.0, 0.1, 0.1, 0.0], "eta"), ([1.0, 0.1, 0.0, 0.1], "omega")] {
        assert!(law.advance(shift(to)).unwrap_err().to_string().contains(field));
    }
    assert_eq!(law.load(), before);
}

/// With either sign of gamma: for gamma < 0 the law takes the bodies in the other order.
#[test]
fn tractions_by_half_of_the_angles_are_those_by_all() {
    let close = Tolerance::new(CLOSE).unwrap();
    for gamma in [0.3, -0.3] {
        let friction = Friction::new(0.2).unwrap();
        let mut half =
            RingLaw::<6, 5, Plane>::in_plane(constants(1.2, gamma), friction, close).unwrap();
        let mut whole = law_of::<6, 8>([1.2, gamma, 0.2], CLOSE);
        let mut largest = 0.0_f64;
        for to in path(7) {
            half.advance(to).unwrap();
            whole.advance(to).unwrap();
            for (ring, angle) in (0..6).flat_map(|ring| (0..5).map(move |angle| (ring, angle))) {
                let [a, b] = [half.traction(ring, angle), whole.traction(ring, angle)];
                let ([radial, around], [same, turned]) = (a.unwrap(), b.unwrap());
                let off = (radial - same).abs().max((around - turned).abs());
                assert!(off < 1e-3, "{gamma}, {ring}, {angle}: {a:?} {b:?}");
                largest = largest.max(radial.abs().min(around.abs()));
            }
        }
        assert!(largest > 0.05, "{largest}");
    }
}
