//! Many encounters of grains in one call of the C interface.

use std::ptr::null_mut;

use carom_capi::*;

use super::grains::{apart, error, made, step};
use super::hostile::Random;

/// Many encounters in one call are those one by one, to the bit: new ones, ones that end, a rest that fills no
/// group. What cannot go on ends the call and is named, and those before it went on.
#[test]
fn encounters_go_through_one_call_as_one_by_one() {
    const PAIRS: usize = 11;
    let grains = [
        made([0.3, 0.2], 0.4, CAROM_LAW_FIXED_DIRECTION, 1e-7).unwrap(),
        made([0.1, 0.4], 0.2, CAROM_LAW_COULOMB, 0.0).unwrap(),
    ];
    let body = |radius: f64| CaromGrain {
        place: [0.0; 3],
        velocity: [0.0; 3],
        spin: [0.0; 3],
        radius,
        mass: 1.0,
    };
    let (mut alone, mut many) = (vec![apart(); PAIRS], vec![apart(); PAIRS]);
    let dt = 1e-6;
    let all = |encounters: &mut [CaromEncounter]| {
        let mut error = error();
        // SAFETY: pointers to what lives on, each touch once.
        let status = unsafe {
            carom_touch_many(encounters.as_mut_ptr(), PAIRS, dt, null_mut(), &raw mut error)
        };
        (status, error.index)
    };
    for now in 0..400 {
        let t = f64::from(now);
        let mut encounters: Vec<_> = many
            .iter_mut()
            .enumerate()
            .map(|(i, touch)| {
                let phase = 0.05 * t + i as f64;
                let place = [
                    1e-6 * (0.03 * t).sin(),
                    2e-6 * (0.02 * phase).cos(),
                    1.9 - 1e-5 + 3e-5 * phase.sin(),
                ];
                let velocity = [0.03 * phase.cos(), 0.02 * (0.02 * phase).sin(), 1.5 * phase.cos()];
                let one = CaromGrain {
                    place,
                    velocity,
                    spin: [3.0 * phase.sin(), 1.0, 2.0],
                    ..body(1.0)
                };
                let load = CaromGrainLoad::default();
                CaromEncounter {
                    grains: &raw const grains[i % 2],
                    touch,
                    one,
                    two: body(0.9),
                    load,
                }
            })
            .collect();
        assert_eq!(all(&mut encounters).0, CaromStatus::Ok);
        for ((i, met), touch) in encounters.iter().enumerate().zip(&mut alone) {
            let load = step(&grains[i % 2], touch, &[met.one, met.two], dt, None);
            assert_eq!(load, met.load, "step {now}, pair {i}");
        }
        if now == 200 {
            encounters[6].two.place = encounters[6].one.place;
            assert_eq!(all(&mut encounters), (CaromStatus::OutOfRange, 6));
            for ((i, met), touch) in encounters.iter().enumerate().zip(&mut alone).take(6) {
                step(&grains[i % 2], touch, &[met.one, met.two], dt, None);
            }
        }
    }
    // SAFETY: nothing is read.
    let status = unsafe { carom_touch_many(null_mut(), 1, dt, null_mut(), null_mut()) };
    assert_eq!(status, CaromStatus::NullPointer);
}

/// A pair that touches or nearly does, in any place and motion; one in twelve is impossible.
fn drawn(random: &mut Random) -> [CaromGrain; 2] {
    let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
    let mut vector = |size: f64| [0; 3].map(|_: i32| between(-size, size));
    let (place, velocities) = (vector(1e-5), [vector(0.1), vector(0.1)]);
    let spins = [vector(3.0), vector(3.0)];
    let mut grains = [0, 1].map(|i| CaromGrain {
        place: [0.0; 3],
        velocity: velocities[i],
        spin: spins[i],
        radius: [1.0, 0.9][i],
        mass: [1.0, 3.0][i],
    });
    grains[0].place = [place[0], place[1], 1.9 - 1.2e-5 + 2.0 * place[2]];
    let (at, axis) = (random.below(2), random.below(3));
    let grain = &mut grains[at];
    let any = [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e70, 1e100, 1e300][random.below(6)];
    match random.below(96) {
        0 => grain.spin[axis] = any,
        1 => grain.velocity[axis] = any,
        2 => grain.place[axis] = any,
        3 => grain.radius = any,
        4 => grain.mass = [0.0, -1.0, f64::NAN, f64::INFINITY][random.below(4)],
        5 => grains[0].place = grains[1].place,
        6 => grain.velocity = grain.velocity.map(|v| v * 1e68),
        7 => grain.spin = grain.spin.map(|v| v * 1e100),
        _ => {}
    }
    grains
}

fn packed(touch: &CaromTouch) -> [u64; CAROM_TOUCH_NUMBERS] {
    let mut numbers = [0.0; CAROM_TOUCH_NUMBERS];
    // SAFETY: pointers to what lives on.
    let status = unsafe { carom_touch_pack(touch, numbers.as_mut_ptr(), null_mut()) };
    assert_eq!(status, CaromStatus::Ok);
    numbers.map(f64::to_bits)
}

/// A hundred thousand batches of up to twelve encounters, impossible ones in any lane: status, place of the first
/// failure, forces, heats and contacts are those of single calls, to the bit.
#[test]
fn impossible_encounters_fail_as_one_by_one() {
    const BATCHES: usize = 100_000;
    let mut made: Vec<_> = [CAROM_LAW_FIXED_DIRECTION, CAROM_LAW_COULOMB]
        .iter()
        .flat_map(|law| [0.0, 1e-7].map(|time| made([0.3, 0.2], 0.4, *law, time).unwrap()))
        .collect();
    for grains in made.clone().into_iter().filter(|grains| grains.relaxation == 0.0) {
        let mut damped = grains;
        // SAFETY: a pointer to what lives on.
        let status = unsafe { carom_grains_restitution(&raw mut damped, 0.8, null_mut()) };
        assert_eq!(status, CaromStatus::Ok);
        made.push(damped);
    }
    let mut random = Random::Seed(591);
    let (mut alone, mut many) = ([apart(); 12], [apart(); 12]);
    let mut told = [0; 2];
    for batch in 0..BATCHES {
        if batch % 50 == 0 {
            (alone, many) = ([apart(); 12], [apart(); 12]);
        }
        let (count, first) = (random.below(13), random.below(made.len()));
        let dt = [1e-6, 1e-6, 1e-6, 0.0][random.below(4)];
        let is_accounted = random.below(4) == 0;
        let mut encounters: Vec<_> = many[..count]
            .iter_mut()
            .enumerate()
            .map(|(i, touch)| {
                let [one, two] = drawn(&mut random);
                let grains = &raw const made[(first + i) % made.len()];
                CaromEncounter { grains, touch, one, two, load: CaromGrainLoad::default() }
            })
            .collect();
        let (mut sums, mut why) = ([CaromHeats::default(); 2], error());
        let heats =
            sums.each_mut().map(|sum| if is_accounted { &raw mut *sum } else { null_mut() });
        // SAFETY: pointers to what lives on or null, each touch once.
        let status =
            unsafe { carom_touch_many(encounters.as_mut_ptr(), count, dt, heats[0], &raw mut why) };
        let mut expected = (CaromStatus::Ok, 0);
        for (i, (met, touch)) in encounters.iter().zip(&mut alone).enumerate() {
            let mut load = CaromGrainLoad::default();
            let (one, two) = (&raw const met.one, &raw const met.two);
            // SAFETY: as above.
            let status = unsafe {
                let to = &raw mut load;
                carom_touch_grains(met.grains, touch, one, two, dt, to, heats[1], null_mut())
            };
            if status != CaromStatus::Ok {
                expected = (status, i);
                break;
            }
            let bits = |load: &CaromGrainLoad| {
                [load.force, load.torque_1, load.torque_2].map(|v| v.map(f64::to_bits))
            };
            assert_eq!(bits(&load), bits(&met.load), "batch {batch}, pair {i}");
            assert!(bits(&load).into_iter().flatten().all(|b| f64::from_bits(b).is_finite()));
        }
        assert_eq!(status, expected.0, "batch {batch}");
        assert!(
            status == CaromStatus::Ok || why.index == i64::try_from(expected.1).unwrap(),
            "batch {batch}"
        );
        assert_eq!(sums[0], sums[1], "batch {batch}");
        for (one, other) in alone.iter().zip(&many) {
            assert_eq!(packed(one), packed(other), "batch {batch}");
        }
        told[usize::from(status != CaromStatus::Ok)] += 1;
    }
    assert!(told.iter().all(|count| *count > BATCHES / 5), "{told:?}");
}
