//! Constants, shifts and approaches at the ends of their ranges: loads and energies stay finite, and states come back.

use carom_laws::coulomb::{CoulombMemory, Tolerance};
use carom_laws::memory::{AdhesionMemory, MemoryRegime, ScalarMemory, VectorMemory};

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
}
