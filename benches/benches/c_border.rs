//! Cost of the C interface: one step of a contact as a law and as a `carom_contact`, one by one and many
//! in a call.

use std::hint::black_box;
use std::mem::MaybeUninit;
use std::ptr::null_mut;

use carom_capi::{
    CAROM_CONTACT_WORDS, CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION, CaromContact, CaromLoad,
    CaromMaterial, CaromPair, CaromShift, CaromStatus, carom_contact_advance,
    carom_contact_advance_many, carom_pair_of_spheres,
};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::memory::Fixed;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

const CONTACTS: usize = 64;
const STEPS: usize = 256;

fn pair(law: u32) -> CaromPair {
    let glass = CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 };
    let mut pair = MaybeUninit::uninit();
    // SAFETY: all pointers are references; the pair is written where the status is Ok.
    unsafe {
        let made = pair.as_mut_ptr();
        let error = null_mut();
        let status = carom_pair_of_spheres(&glass, &glass, 1e-3, 1e-3, 0.3, law, 0.0, made, error);
        assert_eq!(status, CaromStatus::Ok);
        pair.assume_init()
    }
}

/// Shifts of all contacts, step by step: pressed and shifted in circles that slip in part.
fn shifts() -> Vec<[CaromShift; CONTACTS]> {
    let at = |step: usize, contact: usize| {
        let (t, phase) = (0.02 * step as f64, 0.7 * contact as f64);
        CaromShift {
            zeta: 1e-7 * (1.2 + 0.3 * (t + phase).sin()),
            xi: 1.5e-8 * (1.7 * t + 2.0 * phase).sin(),
            eta: 1.5e-8 * (1.3 * t + 3.0 * phase).cos(),
        }
    };
    (0..STEPS).map(|step| std::array::from_fn(|contact| at(step, contact))).collect()
}

/// A path of all contacts from the initial state, by the law itself.
fn by_law(pair: &CaromPair, path: &[[CaromShift; CONTACTS]]) -> f64 {
    let stiffness = ContactStiffness::new(pair.c_x, pair.c_y, pair.c_z).expect("a pair's");
    let friction = Friction::new(pair.friction).expect("a pair's");
    let fresh: ShiftLaw<[f64; 2], Fixed<_, 12>> = match pair.law {
        CAROM_LAW_FIXED_DIRECTION => ShiftLaw::with_fixed_direction(stiffness, friction),
        _ => ShiftLaw::new(stiffness, friction),
    };
    let mut laws = [fresh; CONTACTS];
    let mut sum = 0.0;
    for shifts in path {
        for (law, CaromShift { zeta, xi, eta }) in laws.iter_mut().zip(shifts) {
            let shift = Shift { zeta: *zeta, xi: *xi, eta: *eta, omega: 0.0 };
            sum += law.advance(shift).map_or(0.0, |load| load.f_x);
        }
    }
    sum
}

fn fresh_contacts() -> Vec<CaromContact> {
    let words = [MaybeUninit::new(0); CAROM_CONTACT_WORDS];
    vec![CaromContact { mark: 0, words }; CONTACTS]
}

/// The same by the C function for one contact.
fn one_by_one<K>(
    mut kept: Vec<K>,
    path: &[[CaromShift; CONTACTS]],
    step: impl Fn(&mut K, CaromShift, &mut CaromLoad),
) -> f64 {
    let (mut load, mut sum) = (CaromLoad::default(), 0.0);
    for shifts in path {
        for (kept, shift) in kept.iter_mut().zip(shifts) {
            step(kept, *shift, &mut load);
            sum += load.f_x;
        }
    }
    sum
}

/// The same by the C function for all contacts.
fn all_at_once<K>(
    mut kept: Vec<K>,
    path: &[[CaromShift; CONTACTS]],
    step: impl Fn(&mut [K], &[CaromShift], &mut [CaromLoad]),
) -> f64 {
    let (mut loads, mut sum) = ([CaromLoad::default(); CONTACTS], 0.0);
    for shifts in path {
        step(&mut kept, shifts, &mut loads);
        sum += loads.iter().map(|load| load.f_x).sum::<f64>();
    }
    sum
}

fn border(criterion: &mut Criterion) {
    let path = shifts();
    for (name, law) in
        [("fixed-direction", CAROM_LAW_FIXED_DIRECTION), ("coulomb", CAROM_LAW_COULOMB)]
    {
        let pair = pair(law);
        let mut group = criterion.benchmark_group(format!("C border, {name}"));
        group.throughput(Throughput::Elements((CONTACTS * STEPS) as u64));
        let shift = size_of::<CaromShift>();
        let load = size_of::<CaromLoad>();
        let error = null_mut();
        group.bench_function("law", |b| b.iter(|| by_law(&pair, black_box(&path))));
        group.bench_function(BenchmarkId::new("contact", "one by one"), |b| {
            // SAFETY: all pointers are references.
            let step = |kept: &mut _, shift, load: &mut _| unsafe {
                carom_contact_advance(&pair, kept, shift, load, error);
            };
            b.iter(|| one_by_one(fresh_contacts(), black_box(&path), step));
        });
        group.bench_function(BenchmarkId::new("contact", "many"), |b| {
            // SAFETY: the arrays have as many entries; the strides are theirs.
            let step = |kept: &mut [CaromContact], x: &[CaromShift], f: &mut [CaromLoad]| unsafe {
                let (stride, f) = (size_of::<CaromContact>(), f.as_mut_ptr());
                let (kept, x) = (kept.as_mut_ptr(), x.as_ptr());
                carom_contact_advance_many(&pair, CONTACTS, kept, stride, x, shift, f, load, error);
            };
            b.iter(|| all_at_once(fresh_contacts(), black_box(&path), step));
        });
        group.finish();
    }
}

criterion_group!(benches, border);
criterion_main!(benches);
