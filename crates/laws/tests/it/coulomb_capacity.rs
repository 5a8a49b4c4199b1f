//! Coulomb's law in two directions with storage of fixed capacity, and stored as plain numbers.

use carom_drawn::{Draw as _, Splitmix};
use carom_laws::coulomb::{CoulombMemory, FixedCurve, Tolerance, packed_numbers};
use carom_laws::memory::{Fixed, Memory, VectorMemory};

use crate::common::rings::Rings;
use crate::common::turning::{Kind, divided};

fn off(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[derive(Debug, Default)]
struct Error {
    sum: f64,
    largest: f64,
    steps: f64,
}

impl Error {
    fn add(&mut self, error: f64) {
        self.sum += error;
        self.largest = self.largest.max(error);
        self.steps += 1.0;
    }
}

/// The errors of Coulomb's law in N vertices, and of chapter 7's against itself without bounds.
fn errors<const N: usize>(parts: usize) -> [f64; 4] {
    let (mut coulomb, mut chapter_7) = (Error::default(), Error::default());
    for kind in [Kind::Turning, Kind::TurningVarying, Kind::Corners, Kind::Collision, Kind::Noise] {
        for seed in 0..10 {
            let path = kind.path(&mut Splitmix(seed));
            let mut law =
                CoulombMemory::<[f64; 2], FixedCurve<[f64; 2], N>>::new(Tolerance::PARTICLES);
            let mut oracle = Rings::new(400, 1.3);
            let mut bounded = Memory::<[f64; 2], Fixed<[f64; 2], N>>::new();
            let mut exact = VectorMemory::new();
            for (i, &(zeta, x)) in divided(&path, parts).iter().enumerate() {
                let limit = if kind == Kind::Collision { 1.0 } else { zeta.powf(1.5) };
                let got = law.advance(zeta, x).unwrap();
                assert!(off(got, [0.0; 2]) <= law.normal_force() * (1.0 + 1e-12));
                let [one, two] = [bounded.advance(zeta, x), exact.advance(zeta, x)];
                chapter_7.add(off(one.unwrap(), two.unwrap()) / limit);
                if i % parts == 0 {
                    coulomb.add(off(got, oracle.advance(zeta, x)) / limit);
                }
            }
        }
    }
    let [a, b] = [coulomb, chapter_7].map(|e| [e.sum / e.steps, e.largest]);
    println!(
        "{N} vertices, {parts} parts: {:.1e} {:.1e}; chapter 7 {:.1e} {:.1e}",
        a[0], a[1], b[0], b[1]
    );
    [a[0], a[1], b[0], b[1]]
}

#[test]
fn few_vertices_keep_the_error() {
    for parts in [1, 16] {
        let eight = errors::<8>(parts);
        let twelve = errors::<12>(parts);
        let sixteen = errors::<16>(parts);
        // Twelve are enough for the tolerance, eight for thrice.
        assert!(eight[1] < 3e-2 && twelve[1] < 1e-2 && sixteen[1] < 1e-2);
        assert!(sixteen[0] <= twelve[0] + 1e-4 && twelve[0] <= eight[0] + 1e-4);
    }
}

/// Two contacts that turned alike, one of them off by 1e-14, tremble by so much for 20 000 steps: how
/// far their forces come apart over the limit, in Coulomb's law and in chapter 7's.
fn trembling<const N: usize>(size: f64) -> [f64; 2] {
    let mut worst = [0.0_f64; 2];
    for seed in 0..3 {
        let path = Kind::Turning.path(&mut Splitmix(seed));
        let [mut one, mut two] = [0; 2]
            .map(|_| CoulombMemory::<[f64; 2], FixedCurve<[f64; 2], N>>::new(Tolerance::PARTICLES));
        let [mut old, mut other] = [0; 2].map(|_| Memory::<[f64; 2], Fixed<[f64; 2], N>>::new());
        let mut follow = |zeta: f64, x: [f64; 2], count: bool| {
            let (near, limit) = ([x[0] + 1e-14, x[1]], zeta.powf(1.5));
            let new = off(one.advance(zeta, x).unwrap(), two.advance(zeta, near).unwrap());
            let old = off(old.advance(zeta, x).unwrap(), other.advance(zeta, near).unwrap());
            if count {
                worst = [worst[0].max(new / limit), worst[1].max(old / limit)];
            }
        };
        for &(zeta, x) in &path {
            follow(zeta, x, false);
        }
        let ((zeta, x), mut random) = (path[path.len() - 1], Splitmix(seed + 77));
        for _ in 0..20_000 {
            let by = [0; 3].map(|_| size * random.between(-1.0, 1.0));
            follow(zeta + by[2], [x[0] + by[0], x[1] + by[1]], true);
        }
    }
    println!("{N} vertices, steps of {size:e}: {:.1e}; chapter 7 {:.1e}", worst[0], worst[1]);
    worst
}

#[test]
fn round_off_does_not_grow_in_a_contact_at_rest() {
    for size in [1e-12, 1e-6] {
        // Eight vertices are fewer than these contacts want: each step joins for want of room.
        let few = trembling::<8>(size);
        assert!(few[0] < 1e-4 && few[1] < 1e-12, "{size:e}: {few:?}");
        for apart in [trembling::<12>(size), trembling::<16>(size)] {
            assert!(apart[0] < 1e-7 && apart[1] < 1e-12, "{size:e}: {apart:?}");
        }
    }
}

#[test]
fn zeros_are_apart_and_bad_numbers_are_named() {
    type Law = CoulombMemory<[f64; 2], FixedCurve<[f64; 2], 12>>;
    let mut law = Law::new(Tolerance::PARTICLES);
    law.advance(1.0, [0.3, 0.0]).unwrap();
    law.advance(1.0, [0.3, 0.4]).unwrap();
    let mut good = [0.0; packed_numbers(12)];
    law.pack(&mut good).unwrap();
    let before = law;
    for (place, value, field) in [
        (0, 20_303.0, "mark"),
        (0, 10_399.0, "vertices"),
        (0, 10_303.5, "mark"),
        (1, f64::NAN, "approach"),
        (6, 0.5, "depth"),
        (11, 2.0, "depth"),
        (12, f64::INFINITY, "numbers"),
    ] {
        let mut bad = good;
        bad[place] = value;
        assert_eq!(law.unpack(&bad).unwrap_err().field, field, "{place}");
        assert_eq!(law, before);
    }
    assert_eq!(law.unpack(&good[..5]).unwrap_err().field, "numbers");
    assert_eq!(law.pack(&mut [0.0; 8]).unwrap_err().field, "numbers");
    law.unpack(&[0.0; packed_numbers(12)]).unwrap();
    assert!(!law.is_touching() && law.force() == [0.0; 2]);
    let fresh = Law::new(Tolerance::PARTICLES).advance(1.0, [2.0, 0.0]).unwrap();
    assert_eq!(law.advance(1.0, [2.0, 0.0]).unwrap(), fresh);
}
