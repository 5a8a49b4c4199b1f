//! Many contacts in one call.

use super::*;
use crate::hostile::Random;

/// Every kind of law: with torsion, rolling, damping, and friction by the slip speed.
fn laws() -> Vec<Made> {
    let mut all = Vec::new();
    for law in SHIFTS {
        let usual = options(law);
        for its in [
            usual,
            CaromLawOptions { relaxation: 1e-7, ..usual },
            CaromLawOptions { restitution: 0.8, ..usual },
            CaromLawOptions { rolling: ROLLING, ..usual },
            CaromLawOptions { rolling: ROLLING, restitution: 0.8, ..usual },
            CaromLawOptions { slip_friction_b: 0.2, slip_friction_c: 1.0, ..usual },
        ] {
            let pair = [0.3, 0.2].map(|poisson| CaromMaterial { poisson, ..GLASS });
            all.push(Made::new(pair, 0.4, &its).unwrap());
        }
    }
    all
}

/// Many encounters in one call are those one by one, to the bit: new ones, ones that end, a rest that fills no
/// group. What cannot go on ends the call and is named, and those before it went on.
#[test]
fn encounters_go_through_one_call_as_one_by_one() {
    const PAIRS: usize = 11;
    let torsion = CaromLawOptions { torsion: 1, rolling: ROLLING, ..options(0) };
    let mut sets: Vec<Vec<Made>> = laws().chunks_mut(2).map(|_| Vec::new()).collect();
    for (i, law) in laws().into_iter().enumerate() {
        sets[i / 2].push(law);
    }
    sets.push(vec![Made::new([GLASS; 2], 0.4, &torsion).unwrap()]);
    sets.push(vec![Made::new([GLASS, STEEL], 0.4, &options(CAROM_LAW_RINGS)).unwrap()]);
    for set in &sets {
        let law: Vec<&Made> = set.iter().collect();
        let of = |i: usize| law[i % law.len()];
        let memories = || (0..PAIRS).map(|i| of(i).touch()).collect::<Vec<_>>();
        let (mut alone, mut many, dt) = (memories(), memories(), 1e-6);
        for now in 0..if law.len() == 1 { 60 } else { 400 } {
            let t = f64::from(now);
            let mut bodies: Vec<_> = (0..PAIRS)
                .map(|i| {
                    let phase = 0.05 * t + i as f64;
                    let x = [1e-6 * (0.03 * t).sin(), 2e-6 * (0.02 * phase).cos()];
                    let place = [x[0], x[1], 1.9 - 1e-5 + 3e-5 * phase.sin()];
                    let along =
                        [0.03 * phase.cos(), 0.02 * (0.02 * phase).sin(), 1.5 * phase.cos()];
                    let one = grain(place, along, [3.0 * phase.sin(), 1.0, 2.0], 1.0);
                    [one, grain([0.0; 3], [0.0; 3], [0.0; 3], 0.9)]
                })
                .collect();
            let (status, loads) = together(&law, &mut many, &bodies, dt, None);
            assert_eq!(status, Ok(()));
            let mut step = |i: usize, [one, two]: [CaromGrain; 2]| {
                alone[i].step(of(i), &one, &Second::Grain(two), dt)
            };
            for (i, load) in loads.into_iter().enumerate() {
                assert_eq!(step(i, bodies[i]), load, "step {now}, pair {i}");
            }
            if now == 30 {
                bodies[6][1].place = bodies[6][0].place;
                let told = together(&law, &mut many, &bodies, dt, None).0.unwrap_err();
                assert_eq!((told.status, told.index), (CaromStatus::OutOfRange, 6));
                for (i, pair) in bodies.iter().enumerate().take(6) {
                    step(i, *pair);
                }
            }
        }
        assert_eq!(alone.len(), many.len());
        for (i, (one, other)) in alone.iter().zip(&many).enumerate() {
            assert_eq!(one.packed(of(i)), other.packed(of(i)));
        }
    }
}

/// Walls among them, which are given in place of body 2.
#[test]
fn an_encounter_may_be_with_a_wall() {
    let law = Made::new([GLASS; 2], 0.4, &options(0)).unwrap();
    let Second::Wall(on) = wall([0.1, 0.0, 0.0], [0.0; 3], [0.0; 3]) else { unreachable!() };
    let one = grain([0.0, 0.0, 1.0 - 1e-6], [0.0, 0.0, -1.0], [0.0; 3], 1.0);
    let (mut touches, mut alone) = ([(); 5].map(|()| law.touch()), law.touch());
    for _ in 0..3 {
        let expected = alone.step(&law, &one, &Second::Wall(on), 1e-6);
        let mut all = touches.each_mut().map(|touch| CaromEncounter {
            law: law.0,
            touch: touch.place(),
            wall: &on,
            one,
            two: grain([f64::NAN; 3], [0.0; 3], [0.0; 3], -1.0),
            load: CaromGrainLoad::default(),
        });
        // SAFETY: pointers to what lives on, each touch once.
        let status = told((), |(), error| unsafe {
            carom_touch_step_many(all.as_mut_ptr(), 5, 1e-6, null_mut(), error)
        });
        assert_eq!(status, Ok(()));
        assert!(all.iter().all(|met| met.load == expected) && expected.force[0] > 0.0);
    }
    // SAFETY: nothing is read.
    let status = unsafe { carom_touch_step_many(null_mut(), 1, 1e-6, null_mut(), null_mut()) };
    assert_eq!(status, CaromStatus::NullPointer);
}

/// A pair that touches or nearly does, in any place and motion; one in twelve is impossible.
fn drawn(random: &mut Random) -> [CaromGrain; 2] {
    let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
    let mut vector = |size: f64| [0; 3].map(|_: i32| between(-size, size));
    let (place, velocities) = (vector(1e-5), [vector(0.1), vector(0.1)]);
    let spins = [vector(3.0), vector(3.0)];
    let mut grains = [0, 1].map(|i| CaromGrain {
        mass: [1.0, 3.0][i],
        ..grain([0.0; 3], velocities[i], spins[i], [1.0, 0.9][i])
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

#[test]
fn impossible_encounters_fail_as_one_by_one() {
    fail_as_one_by_one(10_000);
}

#[test]
#[ignore = "seconds: a hundred thousand batches"]
fn many_impossible_encounters_fail_as_one_by_one() {
    fail_as_one_by_one(100_000);
}

/// So many batches of up to twelve encounters, impossible ones in any lane: status, place of the first failure, forces,
/// heats and contacts are those of single calls, to the bit.
fn fail_as_one_by_one(batches: usize) {
    let made = laws();
    let mut random = Random::Seed(591);
    let mut memories: [Vec<Touch>; 2] = [Vec::new(), Vec::new()];
    let mut first = 0;
    let mut told = [0; 2];
    for batch in 0..batches {
        if batch % 50 == 0 {
            first = random.below(made.len());
            let new = || (0..12).map(|i| made[(first + i) % made.len()].touch()).collect();
            memories = [new(), new()];
        }
        let law: Vec<&Made> = (0..made.len()).map(|i| &made[(first + i) % made.len()]).collect();
        let [alone, many] = &mut memories;
        let count = random.below(13);
        let dt = [1e-6, 1e-6, 1e-6, 0.0][random.below(4)];
        let is_accounted = random.below(4) == 0;
        let bodies: Vec<_> = (0..count).map(|_| drawn(&mut random)).collect();
        let mut sums = [CaromHeats::default(); 2];
        let [one_sum, many_sum] = &mut sums;
        let heats = is_accounted.then_some(many_sum);
        let (status, loads) = together(&law, &mut many[..count], &bodies, dt, heats);
        let mut expected = None;
        for (i, (&[one, two], touch)) in bodies.iter().zip(alone.iter_mut()).enumerate() {
            let heats = is_accounted.then_some(&mut *one_sum);
            match touch.tried(law[i], (&one, &Second::Grain(two)), dt, heats) {
                Ok(load) => {
                    let bits = |load: &CaromGrainLoad| {
                        [load.force, load.torque_1, load.torque_2].map(|v| v.map(f64::to_bits))
                    };
                    assert_eq!(bits(&load), bits(&loads[i]), "batch {batch}, pair {i}");
                    assert!(
                        bits(&load).into_iter().flatten().all(|b| f64::from_bits(b).is_finite())
                    );
                }
                Err(why) => {
                    expected = Some((why.status, i as i64));
                    break;
                }
            }
        }
        assert_eq!(status.as_ref().err().map(|why| (why.status, why.index)), expected, "{batch}");
        assert_eq!(sums[0], sums[1], "batch {batch}");
        if batch % 10 == 0 || expected.is_some() {
            for (i, (one, other)) in memories[0].iter().zip(&memories[1]).enumerate() {
                let bits = |touch: &Touch| -> Vec<u64> {
                    touch.packed(law[i]).into_iter().map(f64::to_bits).collect()
                };
                assert_eq!(bits(one), bits(other), "batch {batch}");
            }
        }
        told[usize::from(expected.is_some())] += 1;
    }
    assert!(told.iter().all(|count| *count > batches / 5), "{told:?}");
}
