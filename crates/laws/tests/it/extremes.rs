//! Constants, shifts and approaches at the ends of their ranges: loads and energies stay finite, and states come back.

use carom_laws::coulomb::{CoulombMemory, Tolerance};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Dissipative, Shift};
use carom_laws::memory::{AdhesionMemory, MemoryRegime, ScalarMemory, VectorMemory};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;

/// The energies of a soft contact with much friction were infinite, and their product with an energy of zero no number.
#[test]
fn energies_of_extreme_constants_are_finite() {
    for c_x in [1e-60, 1e-30, 1.0, 1e30, 1e60] {
        for c_z in [1e-60, 1e-30, 1.0, 1e30, 1e60] {
            let Ok(stiffness) = ContactStiffness::new(c_x, c_x, c_z) else {
                assert!(!(1e-30..=1e30).contains(&(c_x / c_z)));
                continue;
            };
            for friction in [1e-30, 1.0, 1e30, f64::INFINITY] {
                let friction = Friction::new(friction).unwrap();
                finite_energies(&ShiftLaw::with_fixed_direction(stiffness, friction));
                finite_energies(&ShiftLaw::new(stiffness, friction));
            }
        }
    }
    let error = ContactStiffness::new(1e-32, 1.0, 1.0).unwrap_err();
    assert_eq!(
        error.to_string(),
        "c_x = 1e-32 is out of range: must be from 1e-30 to 1e30 times c_z"
    );
    let error = ContactStiffness::new(1.0, 1.0, 1e61).unwrap_err();
    assert_eq!(error.to_string(), "c_z = 1e61 is out of range: must be from 1e-60 to 1e60");
}

fn finite_energies(fresh: &ShiftLaw<[f64; 2]>) {
    let mut law = fresh.clone();
    for [zeta, xi, eta] in
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1e60, 1e60, -1e60], [1e60, -1e60, 1e60]]
    {
        let to = Shift { zeta, xi, eta, omega: 0.0 };
        let heat = law.dissipation(to);
        assert!(heat.is_finite() && heat >= 0.0, "{heat} {law:?}");
        if let Ok(load) = law.advance(to) {
            assert!(load.f_x.is_finite() && load.f_y.is_finite() && load.f_z.is_finite());
        }
        let stored = law.stored_energy();
        assert!(stored.is_finite() && stored >= 0.0, "{stored} {law:?}");
    }
}

/// A shift whose square underflows counted as less than the approach, and where the approach did not change as sliding.
#[test]
fn the_smallest_shifts_and_approaches_stay_within_the_cone() {
    for approach in [1e-170, 1e-140, 1e-129, 1e-100] {
        for ratio in [0.5, 0.99, 1.01, 10.0, 1e5] {
            let mut line = ScalarMemory::new();
            let mut plane = VectorMemory::new();
            let mut coulomb = CoulombMemory::<[f64; 2]>::new(Tolerance::FINE);
            let shift = ratio * approach;
            let forces = [
                line.advance(approach, shift).unwrap(),
                plane.advance(approach, [shift, 0.0]).unwrap()[0],
                coulomb.advance(approach, [shift, 0.0]).unwrap()[0],
            ];
            let limit = approach * approach.sqrt();
            let want = if approach < 1e-130 { 0.0 } else { limit * ratio.min(1.0) };
            // The shift has round-off, which is as much larger against the approach.
            let room = (1e-12 + 1e-15 * ratio) * want;
            for force in forces {
                assert!((force - want).abs() <= room, "{approach:e} {ratio}: {forces:?}");
            }
            assert_eq!(line.regime(), plane.regime());
        }
    }
    for shift in [1e-200, 1e-170, 1e-160, 1e-150] {
        for across in [0.0, 0.3] {
            let mut plane = VectorMemory::new();
            plane.advance(1.0, [across, 0.0]).unwrap();
            let before = plane.force();
            let after = plane.advance(1.0, [across, shift]).unwrap();
            assert_ne!(plane.regime(), MemoryRegime::Sliding, "{shift:e} {across}");
            assert!((after[0] - before[0]).abs() <= 1e-15 && after[1].abs() < 1e-100);
        }
    }
}

/// Anchors lie beyond the shifts by the approach, and without slip slopes and forces have no limit.
#[test]
fn the_largest_states_come_back() {
    let mut numbers = [0.0; 96];
    let path = [[1e100, 1e100, -1e100], [0.9e100, -1e100, 1e100], [1e100, 0.7e100, 1e100]];
    let (mut fixed, mut coulomb) =
        (VectorMemory::new(), CoulombMemory::<[f64; 2]>::new(Tolerance::FINE));
    let mut stuck = AdhesionMemory::<[f64; 2]>::new();
    for [zeta, x, y] in [[1e-40, 1e90, 0.0]].into_iter().chain(path) {
        fixed.advance(zeta, [x, y]).unwrap();
        fixed.pack(&mut numbers).unwrap();
        VectorMemory::new().unpack(&numbers).unwrap();
        coulomb.advance(zeta, [x, y]).unwrap();
        coulomb.pack(&mut numbers).unwrap();
        coulomb.clone().unpack(&numbers).unwrap();
        stuck.advance(zeta, [x, y]).unwrap();
        stuck.pack(&mut numbers).unwrap();
        stuck.clone().unpack(&numbers).unwrap();
    }
    for (zeta, x) in [(8e-309, 0.1), (1e-320, 0.1), (1e-200, 1e100)] {
        let mut stuck = AdhesionMemory::<[f64; 2]>::new();
        stuck.advance(zeta, [x, 0.0]).unwrap();
        stuck.pack(&mut numbers).unwrap();
        stuck.clone().unpack(&numbers).unwrap();
    }
    let stiffness = ContactStiffness::new(3.0, 7.0, 1.1).unwrap();
    let fresh = ShiftLaw::<[f64; 2]>::new(stiffness, Friction::new(0.3).unwrap());
    let mut law = fresh.clone();
    law.advance(Shift { zeta: 1.0, xi: 1e60, eta: -1e60, omega: 0.0 }).unwrap();
    law.pack(&mut numbers).unwrap();
    fresh.clone().unpack(&numbers).unwrap();
}
