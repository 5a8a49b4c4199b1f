//! Static friction and friction by the slip speed through the C interface: contacts of grains, and impacts.

use std::mem::{MaybeUninit, size_of, zeroed};
use std::ptr::{null, null_mut};

use carom_capi::*;

const GLASS: CaromMaterial = CaromMaterial { young_modulus: 70e9, poisson: 0.2, yield_stress: 0.0 };
const RADIUS: f64 = 1e-3;
const DEEP: f64 = 1e-7;
const DT: f64 = 1e-7;
const F_S: f64 = 0.5;
const F_K: f64 = 0.3;
const BY_SPEED: [f64; 3] = [0.1, 0.4, 2.0];

fn words(field: &[std::ffi::c_char]) -> String {
    field.iter().take_while(|byte| **byte != 0).map(|byte| char::from(*byte as u8)).collect()
}

fn failed(call: impl FnOnce(*mut CaromError) -> CaromStatus) -> (String, String) {
    // SAFETY: plain numbers.
    let mut error: CaromError = unsafe { zeroed() };
    assert_eq!(call(&raw mut error), CaromStatus::OutOfRange);
    (words(&error.field), words(&error.text))
}

fn grains(law: u32) -> CaromGrains {
    // SAFETY: plain numbers; all pointers are references or null.
    unsafe {
        let mut grains = zeroed();
        let made = carom_grains_of(&GLASS, &GLASS, F_K, law, 0.0, 0.0, &mut grains, null_mut());
        assert_eq!(made, CaromStatus::Ok);
        grains
    }
}

fn gripping(law: u32) -> CaromGrains {
    let mut grains = grains(law);
    // SAFETY: all pointers are references or null.
    let status = unsafe { carom_grains_static_friction(&mut grains, F_S, null_mut()) };
    assert_eq!(status, CaromStatus::Ok);
    grains
}

fn by_speed(law: u32) -> CaromGrains {
    let (mut grains, [a, b, c]) = (grains(law), BY_SPEED);
    // SAFETY: all pointers are references or null.
    let status = unsafe { carom_grains_slip_friction(&mut grains, a, b, c, null_mut()) };
    assert_eq!(status, CaromStatus::Ok);
    grains
}

fn coefficient(speed: f64) -> f64 {
    let [a, b, c] = BY_SPEED;
    a + b * (-c * speed).exp()
}

fn apart() -> CaromTouch {
    CaromTouch { mark: 0, words: [MaybeUninit::new(0); CAROM_TOUCH_WORDS] }
}

/// Two equal grains, the upper one this deep in the lower one and moving along x.
fn bodies(deep: f64, x: f64, velocity: [f64; 3]) -> [CaromGrain; 2] {
    let one = CaromGrain {
        place: [x, 0.0, 2.0 * RADIUS - deep],
        velocity,
        spin: [0.0; 3],
        radius: RADIUS,
        mass: 1e-5,
    };
    [one, CaromGrain { place: [0.0; 3], velocity: [0.0; 3], ..one }]
}

fn step(
    grains: &CaromGrains,
    touch: &mut CaromTouch,
    [one, two]: &[CaromGrain; 2],
    dt: f64,
) -> [f64; 2] {
    let mut load = CaromGrainLoad::default();
    // SAFETY: all pointers are references or null.
    let status = unsafe {
        carom_touch_grains(grains, touch, one, two, dt, &mut load, null_mut(), null_mut())
    };
    assert_eq!(status, CaromStatus::Ok);
    [load.force[0].hypot(load.force[1]), load.force[2]]
}

fn friction_of(touch: &CaromTouch) -> f64 {
    let mut friction = -1.0;
    // SAFETY: all pointers are references or null.
    let status = unsafe { carom_touch_friction(touch, &mut friction, null_mut()) };
    assert_eq!(status, CaromStatus::Ok);
    friction
}

/// Pressed, then pulled along x in short steps: the largest share of friction in the normal force, and that at the end.
fn pulled(grains: &CaromGrains, touch: &mut CaromTouch, speed: f64) -> [f64; 2] {
    step(grains, touch, &bodies(DEEP, 0.0, [0.0, 0.0, -DEEP / DT]), DT);
    let (mut most, mut last, parts) = (0.0_f64, 0.0, 400);
    for i in 1..=parts {
        let x = f64::from(i) * 4e-10;
        let [friction, normal] =
            step(grains, touch, &bodies(DEEP, x, [speed, 0.0, 0.0]), 4e-10 / speed);
        last = friction / normal;
        most = most.max(last);
    }
    [most, last]
}

#[test]
fn a_grain_holds_by_static_friction_and_slides_by_kinetic_friction() {
    for law in [CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION] {
        let [most, last] = pulled(&gripping(law), &mut apart(), 1.0);
        println!("law {law}: at most {most}, at last {last}");
        assert!(most < F_S * (1.0 + 1e-9) && most > 0.98 * F_S, "{law}: {most}");
        assert!((last / F_K - 1.0).abs() < 1e-3, "{law}: {last}");
        // With one coefficient it is that of before.
        let [most, last] = pulled(&grains(law), &mut apart(), 1.0);
        assert!((most / F_K - 1.0).abs() < 1e-3 && (last / F_K - 1.0).abs() < 1e-3);
        // A pair that is made alone does the same.
        // SAFETY: plain numbers; all pointers are references or null.
        let mut pair = unsafe { zeroed() };
        // SAFETY: as above.
        unsafe {
            carom_pair_of_stiffness(0.9, 0.9, 1.1, F_K, law, 0.0, &mut pair, null_mut());
            assert_eq!(carom_pair_static_friction(&mut pair, F_S, null_mut()), CaromStatus::Ok);
            let mut contact: CaromContact = zeroed();
            let mut load = CaromLoad::default();
            let mut share = |xi| {
                let shift = CaromShift { zeta: 1.0, xi, eta: 0.0 };
                carom_contact_advance(&pair, &mut contact, shift, &mut load, null_mut());
                load.f_x / load.f_z
            };
            share(0.0);
            assert!(share(0.6) > 0.49 && (share(0.7) / F_K - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn the_friction_of_a_contact_is_that_of_its_first_slip_speed() {
    for law in [CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION] {
        let grains = by_speed(law);
        for speed in [0.0, 0.3, 2.0] {
            let mut touch = apart();
            step(&grains, &mut touch, &bodies(DEEP, 0.0, [speed, 0.0, -DEEP / DT]), DT);
            let want = coefficient(speed);
            assert!((friction_of(&touch) / want - 1.0).abs() < 1e-12, "{speed}");
            // It is kept at any other speed.
            let [friction, normal] =
                step(&grains, &mut touch, &bodies(DEEP, 1e-6, [5.0, 0.0, 0.0]), 2e-7);
            assert!((friction / normal / want - 1.0).abs() < 1e-2, "{speed} {}", friction / normal);
            let kept = friction_of(&touch);
            // Parted and touching again, it has that of the new first touch; alone and with others.
            step(&grains, &mut touch, &bodies(-DEEP, 1e-6, [0.0, 0.0, 2.0 * DEEP / DT]), DT);
            let again = bodies(DEEP, 0.0, [1.0, 0.0, -2.0 * DEEP / DT]);
            let mut touches = [touch; 4];
            step(&grains, &mut touch, &again, DT);
            assert!((friction_of(&touch) / coefficient(1.0) - 1.0).abs() < 1e-12);
            let mut many = touches.each_mut().map(|touch| CaromEncounter {
                grains: &raw const grains,
                touch,
                one: again[0],
                two: again[1],
                load: CaromGrainLoad::default(),
            });
            // SAFETY: the encounters are in one array, their touches distinct.
            let status =
                unsafe { carom_touch_many(many.as_mut_ptr(), 4, DT, null_mut(), null_mut()) };
            assert_eq!(status, CaromStatus::Ok);
            for touch in &touches {
                assert!((friction_of(touch) / coefficient(1.0) - 1.0).abs() < 1e-12);
            }
            assert!(speed == 1.0 || kept != friction_of(&touch));
        }
        assert_eq!(friction_of(&apart()), 0.0);
    }
}

/// A contact that was packed and unpacked.
fn copy(grains: &CaromGrains, touch: &CaromTouch, is_by_speed: bool) -> CaromTouch {
    let (mut numbers, mut other) = ([0.0; CAROM_TOUCH_NUMBERS], apart());
    // SAFETY: all pointers are references or null.
    let status = unsafe {
        assert_eq!(carom_touch_pack(touch, numbers.as_mut_ptr(), null_mut()), CaromStatus::Ok);
        let (from, to) = (numbers.as_ptr(), &raw mut other);
        if is_by_speed {
            let f = friction_of(touch);
            carom_touch_unpack_with_friction(grains, RADIUS, RADIUS, f, from, to, null_mut())
        } else {
            carom_touch_unpack(grains, RADIUS, RADIUS, from, to, null_mut())
        }
    };
    assert_eq!(status, CaromStatus::Ok);
    other
}

#[test]
fn packed_contacts_go_on_with_their_friction_to_the_bit() {
    for (grains, is_by_speed) in [
        (by_speed(CAROM_LAW_COULOMB), true),
        (by_speed(CAROM_LAW_FIXED_DIRECTION), true),
        (gripping(CAROM_LAW_COULOMB), false),
        (gripping(CAROM_LAW_FIXED_DIRECTION), false),
    ] {
        let mut touch = apart();
        step(&grains, &mut touch, &bodies(DEEP, 0.0, [0.37, 0.0, -DEEP / DT]), DT);
        for i in 1..200 {
            let x = 2e-10 * f64::from(i);
            // Sums are formed anew where numbers are read; from then on all copies go on to the bit.
            let other = copy(&grains, &touch, is_by_speed);
            let mut third = copy(&grains, &other, is_by_speed);
            assert_eq!(friction_of(&touch).to_bits(), friction_of(&third).to_bits());
            let next =
                bodies(DEEP * (1.0 + 0.3 * (0.1 * f64::from(i)).sin()), x, [2e-3, 1e-3, 0.0]);
            let before = step(&grains, &mut touch, &next, DT);
            touch = other;
            let [one, two] = [&mut touch, &mut third].map(|touch| step(&grains, touch, &next, DT));
            assert_eq!(one.map(f64::to_bits), two.map(f64::to_bits), "{i}");
            assert!((before[0] - one[0]).abs() < 1e-12 * one[1] && before[1] == one[1]);
        }
        if is_by_speed {
            let mut numbers = [0.0; CAROM_TOUCH_NUMBERS];
            let (field, text) = failed(|error| {
                // SAFETY: all pointers are references.
                unsafe {
                    carom_touch_pack(&touch, numbers.as_mut_ptr(), null_mut());
                    carom_touch_unpack(
                        &grains,
                        RADIUS,
                        RADIUS,
                        numbers.as_ptr(),
                        &mut apart(),
                        error,
                    )
                }
            });
            assert_eq!(field, "slip_friction_b");
            assert!(text.contains("carom_touch_unpack_with_friction"), "{text}");
            let (field, text) = failed(|error| {
                let (f, from, to) = (f64::INFINITY, numbers.as_ptr(), &raw mut touch);
                // SAFETY: all pointers are references.
                unsafe {
                    carom_touch_unpack_with_friction(&grains, RADIUS, RADIUS, f, from, to, error)
                }
            });
            assert_eq!(field, "friction");
            assert!(text.contains("finite for a state that is stored"), "{text}");
        }
    }
}

/// What coupling changes at most is asked at every speed: also where friction grows with it, or falls towards nothing.
#[test]
fn the_bound_of_coupling_holds_at_every_slip_speed() {
    let rubber = CaromMaterial { young_modulus: 1e7, poisson: 0.45, yield_stress: 0.0 };
    for [a, b] in [[0.1, 0.4], [0.4, -0.3], [0.0, 0.4], [0.3, -0.3]] {
        // SAFETY: plain numbers; all pointers are references or null.
        let of: CaromGrains = unsafe {
            let (mut of, law) = (zeroed(), CAROM_LAW_COULOMB);
            carom_grains_of(&GLASS, &rubber, F_K, law, 0.0, 0.0, &mut of, null_mut());
            let status = carom_grains_slip_friction(&mut of, a, b, 1.0, null_mut());
            assert_eq!(status, CaromStatus::Ok);
            of
        };
        let speeds =
            (0..400).map(|i| if i == 0 { 0.0 } else { 10_f64.powf(0.03 * f64::from(i) - 10.0) });
        let largest = speeds.map(|speed| a + b * f64::exp(-speed)).filter(|f| *f > 0.0).map(|f| {
            let ratio = of.unit.gamma / f;
            ratio * ratio / (4.0 + ratio * ratio) + of.unit.gamma * of.unit.gamma
        });
        let largest = largest.fold(0.0, f64::max);
        let told = of.unit.coupling_bound;
        assert!(largest > 0.0 && (told / largest - 1.0).abs() < 1e-9, "{a} {b}: {told} {largest}");
    }
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let law = CAROM_LAW_FIXED_DIRECTION;
    for wrong in [0.2, -1.0, f64::NAN, f64::INFINITY] {
        let mut of = grains(law);
        // SAFETY: all pointers are references.
        let (field, _) =
            failed(|error| unsafe { carom_grains_static_friction(&mut of, wrong, error) });
        assert_eq!((field.as_str(), of), ("static_friction", grains(law)));
    }
    for ([a, b, c], name) in [
        ([-0.1, 0.3, 1.0], "a"),
        ([0.1, -0.2, 1.0], "b"),
        ([0.1, f64::NAN, 1.0], "b"),
        ([0.1, 0.2, -1.0], "c"),
    ] {
        let mut of = grains(law);
        // SAFETY: all pointers are references.
        let (field, _) =
            failed(|error| unsafe { carom_grains_slip_friction(&mut of, a, b, c, error) });
        assert_eq!((field.as_str(), of), (name, grains(law)));
    }
    // SAFETY: all pointers are references.
    unsafe {
        let mut rings = grains(CAROM_LAW_RINGS);
        let (field, text) = failed(|error| carom_grains_static_friction(&mut rings, F_S, error));
        assert!(field == "static_friction" && text.contains("rings"), "{text}");
        let (field, text) =
            failed(|error| carom_grains_slip_friction(&mut rings, 0.1, 0.2, 1.0, error));
        assert!(field == "b" && text.contains("rings"), "{text}");
        // Equal coefficients are one.
        assert_eq!(carom_grains_static_friction(&mut rings, F_K, null_mut()), CaromStatus::Ok);
        assert_eq!(rings, grains(CAROM_LAW_RINGS));
        let (field, _) =
            failed(|error| carom_grains_slip_friction(&mut gripping(law), 0.1, 0.2, 1.0, error));
        assert_eq!(field, "b");
        let (field, _) =
            failed(|error| carom_grains_static_friction(&mut by_speed(law), 0.9, error));
        assert_eq!(field, "static_friction");
        let [one, two] = &bodies(DEEP, 0.0, [0.0; 3]);
        for (grains, name) in
            [(gripping(law), "static_friction"), (by_speed(law), "slip_friction_b")]
        {
            let (mut twist, mut load) = (zeroed(), CaromGrainLoad::default());
            let (field, text) = failed(|error| {
                let heats = null_mut();
                carom_touch_twist_grains(&grains, &mut twist, one, two, DT, &mut load, heats, error)
            });
            assert!(field == name && text.contains("twist"), "{text}");
        }
    }
}

fn collide(
    friction: f64,
    more: CaromCollideOptions,
    slip: f64,
) -> (CaromStatus, CaromRebound, CaromError) {
    // SAFETY: zeros are a solid sphere at rest; plain numbers.
    let ([mut ball, mut floor], mut error): ([CaromBody; 2], CaromError) = unsafe { zeroed() };
    (ball.shape, ball.sizes[0], ball.mass) = (CAROM_SHAPE_SPHERE, 0.01, 0.02);
    (ball.material, floor.material, floor.shape) = (GLASS, GLASS, CAROM_SHAPE_PLANE);
    (ball.velocity, ball.centre) = ([slip, 0.0, -1.0], [0.0, 0.0, 0.01]);
    let mut told = CaromRebound::default();
    let options = CaromCollideOptions { size: size_of::<CaromCollideOptions>(), ..more };
    // SAFETY: all pointers are references.
    let status = unsafe {
        carom_collide(
            &ball,
            &floor,
            friction,
            [0.0, 0.0, 1.0].as_ptr(),
            &options,
            &mut told,
            &mut error,
        )
    };
    (status, told, error)
}

#[test]
fn impacts_have_both() {
    let none = CaromCollideOptions::default();
    let [a, b, c] = BY_SPEED;
    let by_speed = CaromCollideOptions { slip_friction_b: b, slip_friction_c: c, ..none };
    for slip in [0.2, 3.0] {
        let (status, got, _) = collide(a, by_speed, slip);
        let (_, want, _) = collide(coefficient(slip), none, slip);
        assert_eq!(status, CaromStatus::Ok);
        assert!((got.R_x - want.R_x).abs() < 1e-12 && got.has_R_x == 1, "{} {}", got.R_x, want.R_x);
    }
    let grips = CaromCollideOptions { static_friction: F_S, ..none };
    let [with, without, more] =
        [collide(F_K, grips, 1.2).1, collide(F_K, none, 1.2).1, collide(F_S, none, 1.2).1];
    assert!(
        with.R_x < without.R_x && with.R_x > more.R_x,
        "{} {} {}",
        with.R_x,
        without.R_x,
        more.R_x
    );
    for (friction, options, name) in [
        (F_K, CaromCollideOptions { static_friction: 0.2, ..none }, "static_friction"),
        (F_K, CaromCollideOptions { static_friction: f64::NAN, ..none }, "static_friction"),
        (a, CaromCollideOptions { static_friction: F_S, ..by_speed }, "static_friction"),
        (a, CaromCollideOptions { slip_friction_b: -0.2, ..none }, "slip_friction_b"),
        (a, CaromCollideOptions { slip_friction_c: -1.0, ..by_speed }, "slip_friction_c"),
        (-1.0, by_speed, "friction"),
        (F_K, CaromCollideOptions { law: CAROM_IMPACT_RINGS, ..grips }, "static_friction"),
        (F_K, CaromCollideOptions { torsion: CAROM_TORSION_INCLUDED, ..grips }, "static_friction"),
    ] {
        let (status, _, error) = collide(friction, options, 1.2);
        assert_eq!((status, words(&error.field).as_str()), (CaromStatus::OutOfRange, name));
    }
    // A smaller struct, of a caller of before, leaves them out.
    let old = std::mem::offset_of!(CaromCollideOptions, static_friction);
    // SAFETY: plain numbers.
    let ([mut ball, mut floor], options): ([CaromBody; 2], _) =
        unsafe { (zeroed(), CaromCollideOptions { size: old, static_friction: -7.0, ..none }) };
    (ball.shape, ball.sizes[0], ball.mass) = (CAROM_SHAPE_SPHERE, 0.01, 0.02);
    (ball.material, floor.material, floor.shape) = (GLASS, GLASS, CAROM_SHAPE_PLANE);
    (ball.velocity, ball.centre) = ([1.2, 0.0, -1.0], [0.0, 0.0, 0.01]);
    let mut told = CaromRebound::default();
    // SAFETY: all pointers are references or null.
    let status =
        unsafe { carom_collide(&ball, &floor, F_K, null(), &options, &mut told, null_mut()) };
    assert_eq!((status, told.R_x), (CaromStatus::Ok, without.R_x));
}
