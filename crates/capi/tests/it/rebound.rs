//! Grains of the C interface rebound with the restitution that is given.

use std::mem::{MaybeUninit, zeroed};
use std::ptr::null_mut;

use carom_capi::*;

const GLASS: CaromMaterial = CaromMaterial { young_modulus: 70e9, poisson: 0.2, yield_stress: 0.0 };
const RUBBER: CaromMaterial =
    CaromMaterial { young_modulus: 1e7, poisson: 0.45, yield_stress: 0.0 };
const RADII: [f64; 2] = [2e-3, 3e-3];
const MASSES: [f64; 2] = [1e-4, 3e-4];
const SPEED: f64 = 0.05;

fn grains(two: &CaromMaterial, restitution: f64) -> CaromGrains {
    // SAFETY: plain numbers; all pointers are references or null.
    unsafe {
        let mut grains = zeroed();
        let law = CAROM_LAW_FIXED_DIRECTION;
        let made = carom_grains_of(&GLASS, two, 0.3, law, 0.0, 0.0, &mut grains, null_mut());
        assert_eq!(made, CaromStatus::Ok);
        let status = carom_grains_restitution(&mut grains, restitution, null_mut());
        assert_eq!(status, CaromStatus::Ok);
        grains
    }
}

fn apart() -> CaromTouch {
    CaromTouch { mark: 0, words: [MaybeUninit::new(0); CAROM_TOUCH_WORDS] }
}

/// Two grains about to touch that meet along z.
fn meeting() -> [CaromGrain; 2] {
    let [one, two] = MASSES;
    let part = [two / (one + two), one / (one + two)];
    let grain = |i: usize, z: f64, up: f64| CaromGrain {
        place: [0.0, 0.0, z],
        velocity: [1e-3 * up, 0.0, up * SPEED * part[i]],
        spin: [0.0; 3],
        radius: RADII[i],
        mass: MASSES[i],
    };
    [grain(0, RADII[0] + RADII[1], -1.0), grain(1, 0.0, 1.0)]
}

fn duration(grains: &CaromGrains) -> f64 {
    let mut time = 0.0;
    let ([a, b], [m, n]) = (RADII, MASSES);
    // SAFETY: all pointers are references or null.
    let status =
        unsafe { carom_grains_impact_time(grains, a, b, m, n, SPEED, &mut time, null_mut()) };
    assert_eq!(status, CaromStatus::Ok);
    time
}

/// Leapfrog until they part; the speed at which they do over that at which they met.
fn rebound(mut step: impl FnMut(&[CaromGrain; 2]) -> CaromGrainLoad, dt: f64) -> f64 {
    let mut bodies = meeting();
    let mut force = [0.0; 3];
    for _ in 0..2000 {
        for (body, sign) in bodies.iter_mut().zip([1.0, -1.0]) {
            let mass = body.mass;
            for ((place, velocity), force) in
                body.place.iter_mut().zip(&mut body.velocity).zip(force)
            {
                *velocity += sign * force * dt / mass;
                *place += *velocity * dt;
            }
        }
        let closing = bodies[1].velocity[2] - bodies[0].velocity[2];
        if bodies[0].place[2] - bodies[1].place[2] > RADII[0] + RADII[1] && closing < 0.0 {
            return -closing / SPEED;
        }
        force = step(&bodies).force;
    }
    panic!("they stay");
}

#[test]
fn fifty_steps_meet_the_restitution_alone_and_together() {
    for (two, restitution) in [(&GLASS, 0.2), (&RUBBER, 0.6), (&RUBBER, 0.95)] {
        let grains = grains(two, restitution);
        let (mut touch, dt) = (apart(), duration(&grains) / 50.0);
        let got = rebound(
            |[one, two]| {
                let mut load = CaromGrainLoad::default();
                // SAFETY: all pointers are references or null.
                let status = unsafe {
                    let to = &raw mut load;
                    carom_touch_grains(
                        &grains,
                        &mut touch,
                        one,
                        two,
                        dt,
                        to,
                        null_mut(),
                        null_mut(),
                    )
                };
                assert_eq!(status, CaromStatus::Ok);
                load
            },
            dt,
        );
        assert!((got - restitution).abs() < 3e-4, "{restitution}: {got}");
        let mut touches = [apart(); 4];
        let together = rebound(
            |[one, two]| {
                let load = CaromGrainLoad::default();
                let mut many = touches.each_mut().map(|touch| CaromEncounter {
                    grains: &raw const grains,
                    touch,
                    one: *one,
                    two: *two,
                    load,
                });
                // SAFETY: the encounters are in one array, their touches distinct.
                let status =
                    unsafe { carom_touch_many(many.as_mut_ptr(), 4, dt, null_mut(), null_mut()) };
                assert_eq!(status, CaromStatus::Ok);
                many[3].load
            },
            dt,
        );
        assert_eq!(got, together);
    }
}

#[test]
fn what_cannot_be_met_is_refused() {
    let told = |call: &dyn Fn(*mut CaromError) -> CaromStatus| {
        // SAFETY: plain numbers.
        let mut error: CaromError = unsafe { zeroed() };
        assert_eq!(call(&raw mut error), CaromStatus::OutOfRange);
        let bytes = error.text.iter().take_while(|byte| **byte != 0);
        bytes.map(|byte| char::from(*byte as u8)).collect::<String>()
    };
    let good = grains(&GLASS, 0.5);
    for restitution in [0.0, 1.5, f64::NAN] {
        let mut same = good;
        let place = &raw mut same;
        // SAFETY: all pointers are those of variables.
        let said = told(&|error| unsafe { carom_grains_restitution(place, restitution, error) });
        assert!(said.contains("restitution") && said.contains("from 0.01 to 1"), "{said}");
        assert_eq!(same, good);
    }
    // A relaxation time counts the same loss, also in constants that are written by hand.
    let mut viscous = CaromGrains { relaxation: 1e-6, restitution_ratio: 0.0, ..good };
    let (place, same) = (&raw mut viscous, viscous);
    // SAFETY: all pointers are those of variables.
    let said = told(&|error| unsafe { carom_grains_restitution(place, 0.9, error) });
    assert!(said.contains("relaxation = 0.000001") || said.contains("relaxation = 1e-6"), "{said}");
    assert_eq!(viscous, same);
    // SAFETY: all pointers are those of variables or null.
    assert_eq!(unsafe { carom_grains_restitution(place, 1.0, null_mut()) }, CaromStatus::Ok);
    let both = CaromGrains { relaxation: 1e-6, ..good };
    let (mut touch, mut load, bodies) = (apart(), CaromGrainLoad::default(), meeting());
    let (touch, load, [one, two], none) = (&raw mut touch, &raw mut load, &bodies, null_mut());
    // SAFETY: all pointers are those of variables or null.
    let said = told(&|error| unsafe {
        carom_touch_grains(&both, touch, one, two, 1e-9, load, none, error)
    });
    assert!(said.contains("relaxation"), "{said}");
    let cases = [([0.0, 1.0], "mass = 0"), ([f64::INFINITY; 2], "finite for one of both")];
    for (masses, part) in cases {
        let mut bodies = meeting();
        bodies[0].place[2] -= 1e-6;
        (bodies[0].mass, bodies[1].mass) = (masses[0], masses[1]);
        let (mut touch, mut load) = (apart(), CaromGrainLoad::default());
        let ([one, two], touch, load) = (&bodies, &raw mut touch, &raw mut load);
        let none = null_mut();
        // SAFETY: all pointers are those of variables or null.
        let call =
            |error| unsafe { carom_touch_grains(&good, touch, one, two, 1e-9, load, none, error) };
        let said = told(&call);
        assert!(said.contains(part), "{said}");
    }
}

/// A mass that a restitution cannot use is refused in an array as it is alone.
#[test]
fn masses_are_asked_in_arrays_too() {
    let grains = grains(&RUBBER, 0.5);
    let [mut one, two] = meeting();
    one.place[2] -= 1e-6;
    let pressed = || {
        let (mut touch, mut load) = (apart(), CaromGrainLoad::default());
        // SAFETY: all pointers are references or null.
        let status = unsafe {
            let (load, none) = (&mut load, null_mut());
            carom_touch_grains(&grains, &mut touch, &one, &two, 1e-6, load, none, null_mut())
        };
        assert_eq!(status, CaromStatus::Ok);
        touch
    };
    for mass in [0.0, -1.0, f64::NAN] {
        let mut touches = [(); 4].map(|()| pressed());
        let mut many = touches.each_mut().map(|touch| CaromEncounter {
            grains: &raw const grains,
            touch,
            one,
            two,
            load: CaromGrainLoad::default(),
        });
        many[2].two.mass = mass;
        // SAFETY: the encounters are in one array, their touches distinct.
        let status =
            unsafe { carom_touch_many(many.as_mut_ptr(), 4, 1e-6, null_mut(), null_mut()) };
        assert_eq!(status, CaromStatus::OutOfRange, "{mass}");
    }
}
