//! Calls of the C interface: results, and errors of all kinds.

use std::mem::{MaybeUninit, zeroed};
use std::ptr::{null, null_mut};

use carom_capi::*;
use proptest::prelude::*;

use crate::particles::{GLASS, collided, told, words};

fn error() -> CaromError {
    // SAFETY: plain numbers.
    unsafe { zeroed() }
}

fn field(error: &CaromError) -> String {
    words(&error.field)
}

fn state() -> CaromState {
    CaromState { numbers: [0.0; CAROM_STATE_NUMBERS] }
}

pub(crate) fn contact() -> CaromContact {
    CaromContact { mark: 0, words: [MaybeUninit::new(0); CAROM_CONTACT_WORDS] }
}

pub(crate) fn pair(friction: f64, law: u32) -> CaromPair {
    // SAFETY: all zero is a pair that nothing accepts; all pointers are references.
    let made = told(unsafe { zeroed() }, |pair, error| unsafe {
        carom_pair_of_spheres(&GLASS, &GLASS, 1e-3, 2e-3, friction, law, 0.0, pair, error)
    });
    made.unwrap()
}

/// A random walk of zeta, xi, eta in 0.1 micrometres.
fn walks() -> impl Strategy<Value = Vec<CaromShift>> {
    let step = (-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64);
    prop::collection::vec(step, 1..120).prop_map(|steps| {
        let mut at = [0.2, 0.0, 0.0];
        let walk = steps.into_iter().map(|(zeta, xi, eta)| {
            let next = [at[0] + 0.2 * zeta, at[1] + 0.1 * xi, at[2] + 0.1 * eta];
            at = [next[0].clamp(-0.3, 2.0), next[1], next[2]];
            let [zeta, xi, eta] = at.map(|x| 1e-7 * x);
            CaromShift { zeta, xi, eta }
        });
        walk.collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// One by one and many at once, and with a restart from numbers between any two steps.
    #[test]
    fn all_ways_to_advance_agree(walk in walks(), law in 0..2_u32, friction in 0.05..1.0_f64) {
        let pair = pair(friction, law);
        let (mut one, mut kept, mut many) = (contact(), contact(), [contact(); 3]);
        for shift in walk {
            let (mut load, mut again) = (CaromLoad::default(), CaromLoad::default());
            let mut of_many = [CaromLoad::default(); 3];
            let (mut packed, mut repacked) = (state(), state());
            // A contact that was another one before.
            let mut restarted = many[1];
            // SAFETY: all pointers are references, strides those of the arrays; stride 0 takes one shift.
            let statuses = unsafe {
                let (stride, of_load) = (size_of::<CaromContact>(), size_of::<CaromLoad>());
                let (error, all, loads) = (null_mut(), many.as_mut_ptr(), of_many.as_mut_ptr());
                [
                    carom_contact_advance(&pair, &mut one, shift, &mut load, error),
                    carom_contact_advance(&pair, &mut kept, shift, &mut again, error),
                    carom_contact_advance_many(&pair, 3, all, stride, &shift, 0, loads, of_load, error),
                    carom_contact_pack(&pair, &kept, &mut packed, error),
                    carom_contact_unpack(&pair, &packed, &mut restarted, error),
                    carom_contact_pack(&pair, &restarted, &mut repacked, error),
                ]
            };
            prop_assert_eq!(statuses, [CaromStatus::Ok; 6]);
            kept = restarted;
            prop_assert_eq!(of_many, [load; 3]);
            let size = 1e-9 * friction * pair.c_z * 2e-7_f64.powf(1.5);
            prop_assert_eq!(load.f_z, again.f_z);
            prop_assert!((load.f_x - again.f_x).abs() <= size, "{:?} {:?}", load, again);
            prop_assert!((load.f_y - again.f_y).abs() <= size, "{:?} {:?}", load, again);
            prop_assert_eq!(repacked.numbers.map(f64::to_bits), packed.numbers.map(f64::to_bits));
        }
    }
}

/// Work done on a way is stored or lost, and what is lost grows.
#[test]
fn energies_balance() {
    for law in [CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION] {
        let pair = pair(0.3, law);
        let mut kept = contact();
        let (mut work, mut lost, mut last) = (0.0, 0.0_f64, [0.0; 6]);
        for i in 1..=4000 {
            let t = f64::from(i) / 4000.0;
            let shift = CaromShift {
                zeta: 1e-7 * (6.0 * t).min(1.0),
                xi: 6e-8 * (9.0 * t).sin(),
                eta: if law == CAROM_LAW_COULOMB { 3e-8 * (1.0 - (7.0 * t).cos()) } else { 0.0 },
            };
            let (mut load, mut stored) = (CaromLoad::default(), 0.0);
            // SAFETY: all pointers are references.
            unsafe {
                let error = null_mut();
                let status = carom_contact_advance(&pair, &mut kept, shift, &mut load, error);
                assert_eq!(status, CaromStatus::Ok);
                let status = carom_contact_energy(&pair, &kept, &mut stored, error);
                assert_eq!(status, CaromStatus::Ok);
            }
            let now = [shift.zeta, shift.xi, shift.eta, load.f_z, load.f_x, load.f_y];
            work +=
                (0..3).map(|k| 0.5 * (now[k] - last[k]) * (now[k + 3] + last[k + 3])).sum::<f64>();
            last = now;
            // Coulomb's forces are within 1e-2 of the limit; chapter 7's law is exact on a straight path.
            let off = if law == CAROM_LAW_COULOMB { 2e-2 } else { 1e-4 };
            assert!(work - stored >= lost - off * lost.max(1e-3 * work), "{work} {stored} {lost}");
            lost = lost.max(work - stored);
        }
        assert!(lost > 0.2 * work, "{work} {lost}");
    }
}

/// A failed call leaves everything as it was.
#[test]
fn wrong_calls_are_told_and_do_no_harm() {
    let good = pair(0.3, CAROM_LAW_COULOMB);
    let mut error = error();
    let mut load = CaromLoad { f_x: 7.0, ..CaromLoad::default() };
    let shift = CaromShift { zeta: 1e-8, xi: 1e-9, eta: 0.0 };
    let mut contacts = [contact(); 4];
    // SAFETY: every pointer is null, misaligned, or a reference.
    unsafe {
        let first = contacts.as_mut_ptr();
        let status = carom_contact_advance(null(), first, shift, &mut load, &mut error);
        assert_eq!((status, field(&error)), (CaromStatus::NullPointer, "pair".into()));
        let odd = first.byte_add(4);
        let status = carom_contact_advance(&good, odd, shift, &mut load, &mut error);
        assert_eq!((status, field(&error)), (CaromStatus::Misaligned, "contact".into()));
        assert_eq!(
            carom_contact_advance(null(), first, shift, null_mut(), null_mut()),
            CaromStatus::NullPointer
        );

        let nan = CaromShift { eta: f64::NAN, ..shift };
        let status = carom_contact_advance(&good, first, nan, &mut load, &mut error);
        assert_eq!((status, field(&error)), (CaromStatus::OutOfRange, "eta".into()));
        assert!(
            error.value.is_nan()
                && error.index == -1
                && words(&error.text).contains("out of range")
        );

        let unmade: CaromPair = zeroed();
        let status = carom_contact_advance(&unmade, first, shift, &mut load, &mut error);
        assert_eq!((status, field(&error)), (CaromStatus::BadState, "pair".into()));

        let shifts = [shift, shift, nan, shift];
        let [size, step] = [size_of::<CaromContact>(), size_of::<CaromShift>()];
        let many = |states, stride, shifts: *const CaromShift, error| {
            carom_contact_advance_many(&good, 4, states, stride, shifts, step, null_mut(), 0, error)
        };
        assert_eq!(many(first, size, shifts.as_ptr(), &mut error), CaromStatus::OutOfRange);
        assert_eq!((error.index, field(&error)), (2, "eta".into()));
        assert_eq!(many(first, size - 8, shifts.as_ptr(), &mut error), CaromStatus::Misaligned);
        assert_eq!(many(first, size, null(), &mut error), CaromStatus::NullPointer);
        assert!(contacts.iter().all(|contact| contact.mark == 0));
        assert_eq!(load.f_x, 7.0);

        contacts[1].mark = 77;
        let shifts = [shift; 4];
        let first = contacts.as_mut_ptr();
        assert_eq!(many(first, size, shifts.as_ptr(), &mut error), CaromStatus::BadState);
        assert_eq!((error.index, field(&error)), (1, "contact".into()));
        let mut bad = state();
        bad.numbers[0] = 77.0;
        let mut none = contact();
        let status = carom_contact_unpack(&good, &bad, &mut none, &mut error);
        assert_eq!((status, field(&error)), (CaromStatus::BadState, "mark".into()));
        let mut strange = contact();
        strange.mark = 77;
        let status = carom_contact_advance(&good, &mut strange, shift, null_mut(), &mut error);
        assert_eq!(status, CaromStatus::BadState);
        assert_eq!(strange.mark, 77);
        let (no_contacts, no_loads, unasked) = (null_mut(), null_mut(), null_mut());
        let none =
            carom_contact_advance_many(&good, 0, no_contacts, 0, null(), 0, no_loads, 0, unasked);
        assert_eq!(none, CaromStatus::Ok);
    }
}

#[test]
fn bad_constants_are_named() {
    let mut error = error();
    // SAFETY: all zero is a pair that nothing accepts.
    let mut pair = unsafe { zeroed() };
    let mut make = |young_modulus: f64, radius: f64, friction: f64, law: u32, tolerance: f64| {
        let one = CaromMaterial { young_modulus, poisson: 0.3, yield_stress: 0.0 };
        // SAFETY: all pointers are references.
        let status = unsafe {
            let pair = &raw mut pair;
            carom_pair_of_spheres(
                &one,
                &one,
                radius,
                f64::INFINITY,
                friction,
                law,
                tolerance,
                pair,
                &mut error,
            )
        };
        (status, field(&error))
    };
    let bad = |name: &str| (CaromStatus::OutOfRange, name.to_owned());
    assert_eq!(make(-1.0, 1.0, 0.3, 0, 0.0), bad("young_modulus"));
    assert_eq!(make(1.0, 0.0, 0.3, 0, 0.0), bad("radius"));
    assert_eq!(make(1.0, 1.0, -0.3, 0, 0.0), bad("friction"));
    assert_eq!(make(1.0, 1.0, 0.3, 3, 0.0), bad("law"));
    assert_eq!(make(1.0, 1.0, 0.3, 0, 2.0), bad("tolerance"));
    assert_eq!(make(f64::INFINITY, 1.0, 0.3, 0, 0.0), bad("shear_modulus"));
    assert_eq!(make(1.0, f64::INFINITY, 0.3, 0, 0.0).0, CaromStatus::NoContact);
    assert_eq!(make(1.0, 1.0, 0.3, 1, 0.0).0, CaromStatus::Ok);
    // A sphere on a plane of the same material: a^2 = R zeta, F_z = (4/3) E* sqrt(R) zeta^1.5.
    assert!((pair.a_squared - 1.0).abs() < 1e-14 && (pair.b_squared - 1.0).abs() < 1e-14);
    let e_star = 0.5 / (1.0 - 0.09);
    assert!((pair.c_z - 2.0 * e_star).abs() < 1e-14 * pair.c_z, "{}", pair.c_z);
}

/// Any status has words, and the text is cut off at its room.
#[test]
fn words_are_there() {
    for status in -1..10 {
        let text = carom_status_text(status);
        // SAFETY: it ends with a zero.
        assert!(unsafe { std::ffi::CStr::from_ptr(text) }.to_bytes().len() > 5);
    }
    // SAFETY: it ends with a zero.
    let version = unsafe { std::ffi::CStr::from_ptr(carom_version()) };
    assert_eq!(version.to_str(), Ok(env!("CARGO_PKG_VERSION")));
}

#[test]
fn bodies_of_any_shape_collide() {
    // SAFETY: zeros are a solid sphere at rest.
    let mut egg: CaromBody = unsafe { zeroed() };
    (egg.shape, egg.sizes, egg.mass) = (CAROM_SHAPE_ELLIPSOID, [0.03, 0.02, 0.015], 0.296);
    (egg.material, egg.velocity) = (GLASS, [-0.6, -0.4, -2.0]);
    egg.centre = [0.0, 0.0, 0.015];
    // SAFETY: as above.
    let mut plane: CaromBody = unsafe { zeroed() };
    (plane.shape, plane.material) = (CAROM_SHAPE_PLANE, GLASS);
    let rebound = collided([&egg, &plane], 0.5, None, None).unwrap();
    assert_eq!(rebound.collides, 1);
    assert!((rebound.body_1_velocity[2] - 2.0).abs() < 1e-12);
    assert!(
        rebound.maximal_semi_axis_a < rebound.maximal_semi_axis_b
            && rebound.body_1_spin != [0.0; 3]
    );
    egg.velocity[2] = 1.0;
    assert_eq!(collided([&egg, &plane], 0.5, None, None).unwrap().collides, 0);
    egg.centre[2] = 1.0;
    let told = collided([&egg, &plane], 0.5, None, None).unwrap_err();
    assert_eq!(told.status, CaromStatus::NoContact, "{}", told.text);
    egg.shape = 99;
    let told = collided([&egg, &plane], 0.5, None, None).unwrap_err();
    assert_eq!((told.status, told.field.as_str()), (CaromStatus::OutOfRange, "shape"));
    assert_eq!(told.index, 0);
}
