//! The data of a hostile caller, and the numbers and pointers that it passes.

use std::collections::BTreeSet;
use std::mem::{MaybeUninit, size_of, zeroed};
use std::ptr::{null_mut, slice_from_raw_parts_mut};

use carom_capi::*;

use super::calls::meshes::tent;
use super::random::Random;

/// What the caller keeps of each kind.
pub(crate) struct World {
    pub(crate) random: Random,
    pub(crate) pairs: [CaromPair; 5],
    /// Whether bytes of contacts or of touches were changed: their laws are not checked in each step.
    pub(crate) are_damaged: bool,
    pub(crate) contacts: [CaromContact; 6],
    pub(crate) states: [CaromState; 6],
    /// Made once; freed at the end.
    pub(crate) laws: [*mut CaromLaw; LAWS],
    /// Made once; freed at the end.
    pub(crate) mesh: *mut CaromMesh,
    /// Each has room for any law.
    pub(crate) touches: [[u64; WORDS]; TOUCHES],
    pub(crate) packed: [[f64; NUMBERS]; LAWS],
    pub(crate) time: f64,
    pub(crate) error: CaromError,
    /// How often each status was told.
    pub(crate) told: [u64; 8],
    pub(crate) called: BTreeSet<&'static str>,
}

pub(crate) use crate::particles::GLASS;

/// Number of laws, and of touches: the first of each law, then the second.
pub(crate) const LAWS: usize = 8;
pub(crate) const TOUCHES: usize = 4 * LAWS;
/// More than any law asks for.
pub(crate) const WORDS: usize = 520;
pub(crate) const NUMBERS: usize = 400;

/// Laws of all kinds; the last two by rings.
fn laws() -> [*mut CaromLaw; LAWS] {
    let rubber = CaromMaterial { young_modulus: 1e9, poisson: 0.5, yield_stress: 0.0 };
    let rolling = CaromRolling { stiffness: 1e4, damping: 1e-3, friction: 0.05 };
    let usual = CaromLawOptions { size: size_of::<CaromLawOptions>(), ..Default::default() };
    let damped = CaromLawOptions { relaxation: 1e-7, ..usual };
    let all = [
        (0.4, damped),
        (0.4, CaromLawOptions { law: CAROM_LAW_FIXED_DIRECTION, ..damped }),
        (0.0, damped),
        (0.3, CaromLawOptions { slip_friction_b: 0.2, slip_friction_c: 1.0, rolling, ..usual }),
        (0.3, CaromLawOptions { static_friction: 0.5, restitution: 0.7, ..usual }),
        (0.3, CaromLawOptions { torsion: 1, rolling, ..damped }),
        (0.3, CaromLawOptions { law: CAROM_LAW_RINGS, ..damped }),
        (0.3, CaromLawOptions { law: CAROM_LAW_RINGS, rolling, ..usual }),
    ];
    all.map(|(friction, options)| {
        let mut law = null_mut();
        // SAFETY: all pointers are references or null.
        let made = unsafe {
            carom_law_make(&GLASS, &rubber, friction, &options, &raw mut law, null_mut())
        };
        assert_eq!(made, CaromStatus::Ok);
        law
    })
}

impl World {
    pub(crate) fn new(seed: u64) -> Self {
        // SAFETY: zeros are valid in all of its parts but the list of names, which is written.
        let mut world = unsafe {
            Self {
                random: Random::Seed(seed),
                pairs: zeroed(),
                are_damaged: false,
                contacts: zeroed(),
                states: zeroed(),
                laws: laws(),
                mesh: tent(),
                touches: [[0; WORDS]; TOUCHES],
                packed: zeroed(),
                time: 0.0,
                error: zeroed(),
                told: [0; 8],
                called: BTreeSet::new(),
            }
        };
        world.renew();
        world
    }

    /// Valid constants, and memories of bodies that just touch.
    pub(crate) fn renew(&mut self) {
        for (i, friction) in [0.4, 0.4, 0.05, 0.0, f64::INFINITY].into_iter().enumerate() {
            let (pair, law) = (&raw mut self.pairs[i], (i % 2) as u32);
            // SAFETY: all pointers are references or null.
            let made = unsafe {
                carom_pair_of_spheres(
                    &GLASS,
                    &GLASS,
                    1e-3,
                    2e-3,
                    friction,
                    law,
                    0.0,
                    pair,
                    null_mut(),
                )
            };
            assert_eq!(made, CaromStatus::Ok);
        }
        // SAFETY: zeros are bodies that just touch.
        unsafe { (self.contacts, self.states) = (zeroed(), zeroed()) };
        (self.touches, self.packed) = ([[0; WORDS]; TOUCHES], [[0.0; NUMBERS]; LAWS]);
        (self.time, self.are_damaged) = (0.0, false);
    }

    /// Begins anew with choices from these bytes.
    pub(crate) fn begin(&mut self, bytes: &[u8]) {
        self.renew();
        (self.random, self.told) = (Random::Bytes(bytes.to_vec(), 0), [0; 8]);
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.random.bits()
    }

    pub(crate) fn unit(&mut self) -> f64 {
        self.random.unit()
    }

    pub(crate) fn pick(&mut self, count: usize) -> usize {
        self.random.below(count)
    }

    pub(crate) fn chance(&mut self, part: f64) -> bool {
        self.unit() < part
    }

    /// A number that means something, now and then an extreme one or none.
    pub(crate) fn number(&mut self, low: f64, high: f64) -> f64 {
        match self.pick(60) {
            0 => [
                f64::NAN,
                f64::INFINITY,
                -f64::INFINITY,
                0.0,
                -0.0,
                5e-324,
                1e60,
                -1e61,
                1e100,
                f64::MAX,
            ][self.pick(10)],
            1 => f64::from_bits(self.bits()),
            2 => 10_f64.powf(600.0 * self.unit() - 300.0),
            3 => -(low + (high - low) * self.unit()),
            4 => high * 10_f64.powf(12.0 * self.unit() - 6.0),
            _ => low + (high - low) * self.unit(),
        }
    }

    pub(crate) fn vector(&mut self, size: f64) -> [f64; 3] {
        std::array::from_fn(|_| self.number(-size, size))
    }

    /// A pointer, now and then a null or a misaligned one.
    pub(crate) fn point<T>(&mut self, to: *mut T) -> *mut T {
        match self.pick(150) {
            0 => null_mut(),
            1 => to.wrapping_byte_add(1 + self.pick(7)),
            _ => to,
        }
    }

    pub(crate) fn error(&mut self) -> *mut CaromError {
        let place = &raw mut self.error;
        self.point(place)
    }

    pub(crate) fn shift(&mut self) -> CaromShift {
        let zeta = self.number(-0.2e-7, 3e-7);
        CaromShift { zeta, xi: self.number(-2e-7, 2e-7), eta: self.number(-2e-7, 2e-7) }
    }

    /// Two grains that go through each other's rims.
    pub(crate) fn meeting(&mut self) -> [CaromGrain; 2] {
        self.time += self.number(0.0, 2e-8);
        if !self.time.is_finite() || self.time > 1e-5 || self.time < 0.0 {
            self.time = 0.0;
        }
        let (time, high) = (self.time, self.number(-2e-8, 2e-7));
        let place = [0.3 * time, self.number(-1e-8, 1e-8), 2e-3 - high];
        let one = CaromGrain {
            place,
            velocity: self.vector(0.5),
            spin: self.vector(100.0),
            radius: self.number(1e-3, 1.0001e-3),
            mass: 1.0,
        };
        let two = CaromGrain {
            place: self.vector(1e-9),
            velocity: self.vector(0.1),
            spin: self.vector(10.0),
            radius: 1e-3,
            mass: 1.0,
        };
        [one, two]
    }

    /// Changes bytes anywhere in what is kept: some of one, or all of one by those of another.
    pub(crate) fn garble(&mut self) {
        let parts: [(*mut u8, usize, usize); 5] = [
            (self.pairs.as_mut_ptr().cast(), self.pairs.len(), size_of::<CaromPair>()),
            (self.contacts.as_mut_ptr().cast(), self.contacts.len(), size_of::<CaromContact>()),
            (self.states.as_mut_ptr().cast(), self.states.len(), size_of::<CaromState>()),
            (self.touches.as_mut_ptr().cast(), TOUCHES, 8 * WORDS),
            (self.packed.as_mut_ptr().cast(), LAWS, 8 * NUMBERS),
        ];
        // Memories more often than constants, which few calls then take.
        let kind = [0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 3, 3, 3, 4, 4, 4][self.pick(16)];
        let (first, count, size) = parts[kind];
        let (at, from) = (self.pick(count), self.pick(count));
        self.are_damaged |= [1, 3].contains(&kind);
        // SAFETY: within the array; all are plain bytes, of which any are values.
        let bytes = unsafe {
            if self.chance(0.05) {
                first.add(from * size).copy_to(first.add(at * size), size);
            }
            &mut *slice_from_raw_parts_mut(first.add(at * size).cast::<MaybeUninit<u8>>(), size)
        };
        for _ in 0..1 + self.pick(3) {
            let word = 8 * self.pick(size / 8);
            // The tags of a memory are likely to stand in front, or behind.
            let word = match self.pick(4) {
                0 => word.min(8 * self.pick(24)),
                1 => size - 8 - 8 * self.pick(24).min(size / 8 - 1),
                _ => word,
            };
            let new = match self.pick(5) {
                0 => self.bits(),
                1 => self.number(-1e-7, 1e-7).to_bits(),
                2 => self.pick(9) as u64,
                3 => [0x5a5a_5a5a_5a5a_5a5a, u64::MAX, 0, f64::NAN.to_bits()][self.pick(4)],
                _ => {
                    bytes[word + self.pick(8)] = MaybeUninit::new(self.bits() as u8);
                    continue;
                }
            };
            for (byte, new) in bytes[word..word + 8].iter_mut().zip(new.to_ne_bytes()) {
                *byte = MaybeUninit::new(new);
            }
        }
    }
}

impl Drop for World {
    fn drop(&mut self) {
        for law in self.laws {
            // SAFETY: made by the library, and freed once.
            unsafe { carom_law_free(law) };
        }
        // SAFETY: made by the library, and freed once.
        unsafe { carom_mesh_free(self.mesh) };
    }
}
