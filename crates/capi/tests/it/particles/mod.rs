//! Contacts of particles through the C interface, of all laws by the same tests.

mod apart;
mod friction;
mod garbled;
mod impacts;
mod limits;
mod many;
mod parts;
mod restitution;
mod walls;
mod wrong;

use std::ffi::{CStr, c_char};
use std::mem::zeroed;
use std::ptr::{null, null_mut};

use carom_capi::*;

pub(super) type Vector = [f64; 3];

pub(super) const GLASS: CaromMaterial =
    CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 };
pub(super) const STEEL: CaromMaterial =
    CaromMaterial { young_modulus: 208e9, poisson: 0.3, yield_stress: 0.0 };
pub(super) const SHIFTS: [u32; 2] = [CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION];
pub(super) const LAWS: [u32; 3] = [CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION, CAROM_LAW_RINGS];
pub(super) const ROLLING: CaromRolling =
    CaromRolling { stiffness: 3e4, damping: 20.0, friction: 0.02 };

/// What a failed call told.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Told {
    pub(super) status: CaromStatus,
    pub(super) field: String,
    pub(super) text: String,
    pub(super) index: i64,
}

/// A text of an error.
pub(super) fn words(bytes: &[c_char]) -> String {
    // SAFETY: ends with a zero.
    unsafe { CStr::from_ptr(bytes.as_ptr()) }.to_string_lossy().into_owned()
}

/// The value that a call writes, or what it told.
pub(super) fn told<T>(
    made: T,
    call: impl FnOnce(&mut T, *mut CaromError) -> CaromStatus,
) -> Result<T, Told> {
    // SAFETY: plain numbers.
    let (mut made, mut error): (T, CaromError) = (made, unsafe { zeroed() });
    error.index = -7;
    match call(&mut made, &raw mut error) {
        CaromStatus::Ok => Ok(made),
        status => {
            let (field, text) = (words(&error.field), words(&error.text));
            Err(Told { status, field, text, index: error.index })
        }
    }
}

/// An impact of two bodies, or what was told.
pub(super) fn collided(
    [one, two]: [&CaromBody; 2],
    friction: f64,
    normal: Option<&Vector>,
    options: Option<CaromCollideOptions>,
) -> Result<CaromRebound, Told> {
    let normal = normal.map_or(null(), |normal| normal.as_ptr());
    let size = size_of::<CaromCollideOptions>();
    let options = options.map(|options| CaromCollideOptions { size, ..options });
    let options = options.as_ref().map_or(null(), std::ptr::from_ref);
    // SAFETY: all pointers are references or null.
    told(CaromRebound::default(), |to, error| unsafe {
        carom_collide(one, two, friction, normal, options, to, error)
    })
}

pub(super) fn options(law: u32) -> CaromLawOptions {
    CaromLawOptions { size: size_of::<CaromLawOptions>(), law, ..CaromLawOptions::default() }
}

/// Body 2.
#[derive(Debug, Clone, Copy)]
pub(super) enum Second {
    Grain(CaromGrain),
    Wall(CaromSurface),
}

impl Second {
    fn pointers(&self) -> (*const CaromGrain, *const CaromSurface) {
        match self {
            Self::Grain(two) => (two, null()),
            Self::Wall(wall) => (null(), wall),
        }
    }

    fn radius(&self) -> f64 {
        match self {
            Self::Grain(two) => two.radius,
            Self::Wall(_) => f64::INFINITY,
        }
    }
}

/// A law, freed at the end.
pub(super) struct Made(pub(super) *mut CaromLaw);

impl Drop for Made {
    fn drop(&mut self) {
        // SAFETY: made by the library, and freed once.
        unsafe { carom_law_free(self.0) };
    }
}

impl Made {
    pub(super) fn new(
        [one, two]: [CaromMaterial; 2],
        friction: f64,
        options: &CaromLawOptions,
    ) -> Result<Self, Told> {
        // SAFETY: all pointers are references.
        told(null_mut(), |law, error| unsafe {
            carom_law_make(&one, &two, friction, options, law, error)
        })
        .map(Self)
    }

    pub(super) fn curved(&self, radius: f64, [x, y]: [f64; 2]) -> Result<Self, Told> {
        // SAFETY: all pointers are references.
        told(null_mut(), |law, error| unsafe {
            carom_law_on_curved_wall(self.0, radius, x, y, law, error)
        })
        .map(Self)
    }

    /// The memory of two bodies that are apart.
    pub(super) fn touch(&self) -> Touch {
        // SAFETY: a law.
        Touch { words: vec![0; unsafe { carom_touch_size(self.0) } / 8] }
    }

    pub(super) fn impact_time(
        &self,
        [a, b]: [f64; 2],
        [m, n]: [f64; 2],
        speed: f64,
    ) -> Result<f64, Told> {
        // SAFETY: all pointers are references.
        told(0.0, |time, error| unsafe {
            carom_law_impact_time(self.0, a, b, m, n, speed, time, error)
        })
    }

    pub(super) fn validity(&self, [a, b]: [f64; 2], zeta: f64) -> Result<CaromValidity, Told> {
        // SAFETY: all pointers are references.
        told(CaromValidity::default(), |to, error| unsafe {
            carom_law_validity(self.0, a, b, zeta, to, error)
        })
    }
}

/// The memory of a contact.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Touch {
    pub(super) words: Vec<u64>,
}

impl Touch {
    fn place(&mut self) -> *mut CaromTouch {
        self.words.as_mut_ptr().cast()
    }

    fn at(&self) -> *const CaromTouch {
        self.words.as_ptr().cast()
    }

    /// Whether it has no contact.
    fn is_new(&self) -> bool {
        self.words[0] == 0
    }

    pub(super) fn tried(
        &mut self,
        law: &Made,
        (one, second): (&CaromGrain, &Second),
        dt: f64,
        heats: Option<&mut CaromHeats>,
    ) -> Result<CaromGrainLoad, Told> {
        let heats = heats.map_or(null_mut(), |heats| &raw mut *heats);
        let (two, wall) = second.pointers();
        // SAFETY: all pointers are references or null, and the touch is of this law.
        told(CaromGrainLoad::default(), |load, error| unsafe {
            carom_touch_step(law.0, self.place(), one, two, wall, dt, load, heats, error)
        })
    }

    pub(super) fn step(
        &mut self,
        law: &Made,
        one: &CaromGrain,
        second: &Second,
        dt: f64,
    ) -> CaromGrainLoad {
        self.tried(law, (one, second), dt, None).unwrap()
    }

    pub(super) fn load(
        &self,
        law: &Made,
        one: &CaromGrain,
        second: &Second,
    ) -> Result<CaromGrainLoad, Told> {
        let (two, wall) = second.pointers();
        // SAFETY: as above.
        told(CaromGrainLoad::default(), |load, error| unsafe {
            carom_touch_load(law.0, self.at(), one, two, wall, load, error)
        })
    }

    pub(super) fn energy(&self, law: &Made, [a, b]: [f64; 2]) -> f64 {
        // SAFETY: as above.
        let made = told(0.0, |energy, error| unsafe {
            carom_touch_energy(law.0, self.at(), a, b, energy, error)
        });
        made.unwrap()
    }

    pub(super) fn report(&self, law: &Made) -> CaromReport {
        let apart = CaromReport { sticking: -1.0, regime: CaromRegime::Separated };
        // SAFETY: as above.
        let made = told(apart, |report, error| unsafe {
            carom_touch_report(law.0, self.at(), report, error)
        });
        made.unwrap()
    }

    pub(super) fn packed(&self, law: &Made) -> Vec<f64> {
        // SAFETY: a law, and room for all numbers.
        let room = vec![7.0; unsafe { carom_touch_pack_size(law.0) }];
        let made = told(room, |numbers, error| unsafe {
            carom_touch_pack(law.0, self.at(), numbers.as_mut_ptr(), error)
        });
        made.unwrap()
    }

    pub(super) fn unpacked(law: &Made, [a, b]: [f64; 2], numbers: &[f64]) -> Result<Self, Told> {
        // SAFETY: all pointers are references, and there are as many numbers as the law has.
        told(law.touch(), |touch, error| unsafe {
            assert_eq!(numbers.len(), carom_touch_pack_size(law.0));
            carom_touch_unpack(law.0, a, b, numbers.as_ptr(), touch.place(), error)
        })
    }

    /// A copy through numbers.
    pub(super) fn copied(&self, law: &Made, radii: [f64; 2]) -> Self {
        Self::unpacked(law, radii, &self.packed(law)).unwrap()
    }

    /// The coefficient that a contact with friction by the slip speed keeps: its last number.
    pub(super) fn friction(&self, law: &Made) -> f64 {
        *self.packed(law).last().unwrap()
    }
}

pub(super) fn plus(a: Vector, b: Vector, by: f64) -> Vector {
    [0, 1, 2].map(|k| a[k] + by * b[k])
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn grain(place: Vector, velocity: Vector, spin: Vector, radius: f64) -> CaromGrain {
    CaromGrain { place, velocity, spin, radius, mass: 1.0 }
}

/// A wall with the normal z.
pub(super) fn wall(velocity: Vector, spin: Vector, axis: Vector) -> Second {
    let (place, normal) = ([0.0; 3], [0.0, 0.0, 1.0]);
    Second::Wall(CaromSurface { place, normal, velocity, spin, axis })
}

/// Encounters of grains in one call: the loads, or what was told.
pub(super) fn together(
    laws: &[&Made],
    touches: &mut [Touch],
    bodies: &[[CaromGrain; 2]],
    dt: f64,
    heats: Option<&mut CaromHeats>,
) -> (Result<(), Told>, Vec<CaromGrainLoad>) {
    let mut all: Vec<_> = touches
        .iter_mut()
        .zip(bodies)
        .enumerate()
        .map(|(i, (touch, &[one, two]))| {
            let (law, touch, wall) = (laws[i % laws.len()].0.cast_const(), touch.place(), null());
            CaromEncounter { law, touch, wall, one, two, load: CaromGrainLoad::default() }
        })
        .collect();
    let heats = heats.map_or(null_mut(), |heats| &raw mut *heats);
    // SAFETY: pointers to what lives on or null, each touch once.
    let status = told((), |(), error| unsafe {
        carom_touch_step_many(all.as_mut_ptr(), all.len(), dt, heats, error)
    });
    (status, all.iter().map(|met| met.load).collect())
}
