//! Numbers from outside: those stored by a law are accepted, invalid ones are errors.

use carom_drawn::{Draw as _, Splitmix};
use carom_laws::coulomb::{Tolerance, packed_numbers};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Dissipative, Shift};
use carom_laws::memory::{Fixed, Growing, Lateral, VertexStack};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::static_friction::StaticFriction;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::torsion::law::{TorsionConstants, TorsionLaw};
use carom_laws::turning_law::TurningLaw;

const STIFFNESS: ContactStiffness = ContactStiffness { c_x: 3e9, c_y: 2.6e9, c_z: 4e9 };

fn friction(f: f64) -> Friction {
    Friction::new(f).unwrap()
}

/// Steps of many sizes that press, slip, turn, recede, part and touch again, now and then far from the origin.
fn path(random: &mut Splitmix, steps: usize, drift: f64) -> Vec<Shift> {
    let mut at = Shift { zeta: -1e-7, xi: drift, eta: -0.3 * drift, omega: 0.0 };
    let size = 10_f64.powf(-9.0 + 3.0 * random.part());
    (0..steps)
        .map(|_| {
            let by = size * 10_f64.powf(-4.0 * random.part() * random.part());
            let part = |random: &mut Splitmix| by * (2.0 * random.part() - 1.0);
            match (10.0 * random.part()) as u8 {
                0..=2 => at.zeta += part(random),
                3 => at.zeta = (at.zeta * (0.2 + random.part())).max(1e-12),
                4 => at.xi += 20.0 * part(random),
                5 => (at.xi, at.eta) = (at.xi + part(random), at.eta),
                6 if random.part() < 0.1 => at.zeta = -part(random).abs(),
                7 => {
                    let growth = part(random).abs();
                    (at.zeta, at.xi) = (at.zeta + growth, at.xi + 0.3 * growth);
                }
                _ => (at.xi, at.eta) = (at.xi + part(random), at.eta + part(random)),
            }
            at.zeta = at.zeta.min(20.0 * size);
            at
        })
        .collect()
}

/// Every state on a path is taken, and packs to the same bits again.
fn all_are_taken<V: Lateral, S: VertexStack<V>>(
    fresh: &ShiftLaw<V, S>,
    path: &[Shift],
    each: usize,
) {
    let mut law = fresh.clone();
    let room = 6 + each * law_room(fresh);
    let (mut one, mut two) = (vec![0.0; room], vec![0.0; room]);
    for (i, shift) in path.iter().enumerate() {
        let shift = if V::DIMENSION == 1 { Shift { eta: 0.0, ..*shift } } else { *shift };
        law.advance(shift).unwrap();
        if law.pack(&mut one).is_err() {
            continue; // a growing one, of more vertices than are asked for here
        }
        let mut again = fresh.clone();
        if let Err(error) = again.unpack(&one) {
            panic!("step {i}: {error}: {one:?}");
        }
        let off = again.shift().xi - shift.xi;
        assert!(off.abs() <= 1e-15 * shift.xi.abs(), "{off}");
        again.pack(&mut two).unwrap();
        assert!(one.iter().zip(&two).all(|(a, b)| a.to_bits() == b.to_bits()), "{one:?} {two:?}");
    }
}

fn law_room<V: Lateral, S: VertexStack<V>>(_: &ShiftLaw<V, S>) -> usize {
    S::default().capacity().min(90)
}

fn histories(count: u64) {
    for seed in 0..count {
        let random = &mut Splitmix(seed);
        let drift = [0.0, 1e-6, 1e-3, 1.0][(4.0 * random.part()) as usize];
        let f = 10_f64.powf(2.0 * random.part() - 1.5);
        let path = path(random, 120, drift);
        let fine = Tolerance::new(10_f64.powf(-1.0 - 4.0 * random.part())).unwrap();
        type Plane<S> = ShiftLaw<[f64; 2], S>;
        type Few = Fixed<[f64; 2], 4>;
        type Many = Fixed<[f64; 2], 12>;
        let (f, free, stuck) = (friction(f), Friction::NONE, Friction::INFINITE);
        all_are_taken(&Plane::<Few>::with_fixed_direction(STIFFNESS, f), &path, 5);
        all_are_taken(&Plane::<Many>::with_fixed_direction(STIFFNESS, f), &path, 5);
        all_are_taken(&Plane::<Growing<_>>::with_fixed_direction(STIFFNESS, f), &path, 5);
        all_are_taken(&Plane::<Few>::with_tolerance(STIFFNESS, f, fine), &path, 5);
        all_are_taken(&Plane::<Many>::with_tolerance(STIFFNESS, f, fine), &path, 5);
        all_are_taken(&Plane::<Many>::new(STIFFNESS, f), &path, 5);
        all_are_taken(&Plane::<Growing<_>>::with_tolerance(STIFFNESS, f, fine), &path, 5);
        all_are_taken(&ShiftLaw::<f64, Fixed<f64, 4>>::new(STIFFNESS, f), &path, 5);
        all_are_taken(&ShiftLaw::<f64, Fixed<f64, 12>>::new(STIFFNESS, f), &path, 5);
        all_are_taken(&Plane::<Few>::new(STIFFNESS, stuck), &path, 9);
        all_are_taken(&Plane::<Many>::new(STIFFNESS, stuck), &path, 9);
        all_are_taken(&Plane::<Growing<_>>::new(STIFFNESS, stuck), &path, 9);
        all_are_taken(&Plane::<Many>::new(STIFFNESS, free), &path, 5);
    }
}

#[test]
fn every_state_of_a_random_history_is_taken_and_packs_to_the_same_bits() {
    histories(60);
}

/// Hours of the same, on request.
#[test]
#[ignore = "takes minutes"]
fn every_state_of_many_random_histories_is_taken() {
    histories(20_000);
}

type Law = ShiftLaw<[f64; 2], Fixed<[f64; 2], 12>>;
const NUMBERS: usize = packed_numbers(12);

fn laws(f: f64) -> [Law; 2] {
    [Law::with_fixed_direction(STIFFNESS, friction(f)), Law::new(STIFFNESS, friction(f))]
}

/// The same with static friction above kinetic friction.
fn gripping(f: f64) -> [Law; 2] {
    let both = StaticFriction::new(friction(f), friction(0.6 * f)).unwrap();
    TurningLaw::ALL.map(|law| Law::with_static_friction(law, STIFFNESS, both, Tolerance::PARTICLES))
}

/// A state that has turned, as numbers.
fn turned(law: &mut Law) -> [f64; NUMBERS] {
    for i in 0..9 {
        let (sin, cos) = f64::from(i).sin_cos();
        let zeta = 1e-7 * (1.0 + 0.2 * cos);
        law.advance(Shift { zeta, xi: 3e-8 * sin, eta: 2e-8 * cos, omega: 0.0 }).unwrap();
    }
    let mut numbers = [0.0; NUMBERS];
    law.pack(&mut numbers).unwrap();
    numbers
}

#[test]
fn a_force_beyond_the_limit_is_refused() {
    let [mut law, _] = laws(0.4);
    let mut numbers = turned(&mut law);
    let before = law;
    // The slope of the force of the lowest ring.
    for value in [1e30, -1e30, 1.1, -2.0] {
        numbers[9] = value;
        assert_eq!(law.unpack(&numbers).unwrap_err().field, "slope of the force");
        assert_eq!(law, before);
    }
}

/// The slip of a contact that grows from next to nothing has turned all the way: its force once was no number.
#[test]
fn slip_that_grows_from_next_to_nothing_turns_and_has_a_force() {
    for first in [5e-324, 1e-320, 1e-310, 1e-300, 1e-100] {
        let [mut law, _] = laws(0.3);
        law.advance(Shift { zeta: first, xi: 1e-7, ..Shift::default() }).unwrap();
        let to = Shift { zeta: 1e-7, xi: 1e-6, eta: 1e-6, omega: 0.0 };
        let load = law.advance(to).unwrap();
        // From the touch on it slides along its path, in normalised shifts.
        let path = [STIFFNESS.c_x * 0.9e-6, STIFFNESS.c_y * 1e-6];
        let by = 0.3 * load.f_z / path[0].hypot(path[1]);
        assert!((load.f_x - by * path[0]).abs() <= 1e-12 * load.f_z, "{first:e}: {load:?}");
        assert!((load.f_y - by * path[1]).abs() <= 1e-12 * load.f_z, "{first:e}: {load:?}");
    }
}

/// A slide that is opposite to the traction but for next to nothing: the tangent of half the angle between them is no
/// number. As the contact recedes the traction stays as it was; a long slide back turns it.
#[test]
fn tractions_opposite_to_a_slide_are_numbers_whatever_lies_beside() {
    for beside in [5e-324, 1e-320, 1e-313, 1e-300, 1e-160, 1e-155, 1e-150, 1e-100] {
        for mut law in laws(0.3) {
            law.advance(Shift { zeta: 1e-7, ..Shift::default() }).unwrap();
            let steps = [(1e-7, -1e-5, -1.0), (5e-8, -9.99e-6, -1.0), (4e-8, 5e-5, 1.0)];
            for (zeta, xi, way) in steps {
                let load = law.advance(Shift { zeta, xi, eta: beside, omega: 0.0 }).unwrap();
                let part = load.f_x / (0.3 * load.f_z);
                assert!((part - way).abs() < 1e-12, "{beside:e} {xi}: {load:?}");
                assert!(load.f_y.abs() < 1e-12 * load.f_z, "{beside:e} {xi}: {load:?}");
            }
        }
    }
}

/// Once no numbers: a force after a slide of 1e13 approaches, of which next to nothing was across; the heat of a slide at
/// next to no approach, whose stretch is zero to round-off.
#[test]
fn slides_with_next_to_nothing_across_have_forces_and_heat() {
    let least = 5e-324;
    let long: &[_] = &[
        (3.3e-3, -least, -9.4e-6),
        (3.3e-3, 4.6e-21, -9.4e-6),
        (4e-4, 4.6e-21, -4.1e-5),
        (4e-4, 1e-5, -4.1e-5),
        (3.4005599722540232e-6, -least, -5.119188113833143e-21),
        (3.4005599722540232e-6, -least, -33432617.567479074),
    ];
    let beside: &[_] = &[
        (1.2e-7, 2.3450539291062422e-8, 0.0),
        (1.0443043116597183e-39, 7.395737768706943e-9, -1.3470278740133708e-8),
        (2.6753573093748463e-24, 7.395737768706946e-9, -1.3470278740133708e-8),
    ];
    for steps in [long, beside] {
        for mut law in laws(0.4) {
            for &(zeta, xi, eta) in steps {
                let to = Shift { zeta, xi, eta, omega: 0.0 };
                assert!(law.dissipation(to).is_finite(), "{to:?}");
                let load = law.advance(to).unwrap();
                let force = load.f_x.hypot(load.f_y);
                assert!(force <= 0.4 * load.f_z * (1.0 + 1e-12), "{to:?}: {load:?}");
            }
        }
    }
}

/// Once no number: a slope of next to nothing, in a contact of next to no approach.
#[test]
fn a_slope_of_next_to_nothing_is_dragged_to_a_number() {
    let [mut law, _] = laws(0.4);
    let (at, beside) = (-1.976e-6, 1.642e-8);
    let mut numbers = [0.0; NUMBERS];
    numbers[..8].copy_from_slice(&[20101.0, 5e-324, at, beside, at, beside, 0.0, 4.3458e-311]);
    law.unpack(&numbers).unwrap();
    let Shift { xi, .. } = law.shift();
    let load = law.advance(Shift { zeta: 1e-12, xi, eta: 3.16e-7, omega: 0.0 }).unwrap();
    assert!((load.f_y / (0.4 * load.f_z) - 1.0).abs() < 1e-12, "{load:?}");
}

#[test]
fn anchors_beyond_the_friction_cone_are_refused() {
    let places: [&[(usize, &str)]; 2] = [
        &[(2, "anchor"), (3, "anchor"), (4, "anchor"), (7, "slope")],
        &[(2, "anchor"), (3, "anchor"), (7, "anchor"), (4, "front")],
    ];
    for (law, places) in laws(0.4).iter_mut().zip(places) {
        let numbers = turned(law);
        let before = *law;
        for &(at, field) in places {
            let mut wrong = numbers;
            wrong[at] += if field == "slope" { 3.0 } else { 3.0 * numbers[1] };
            assert_eq!(law.unpack(&wrong).unwrap_err().field, field, "{at}");
            assert_eq!(*law, before);
        }
    }
}

/// Any number garbled in any way: refused, or loads that are numbers, within the limit, and steps from there.
fn garble(cases: u64, mut look: impl FnMut(&mut Splitmix)) {
    for seed in 0..cases {
        look(&mut Splitmix(seed ^ 0x9e37_79b9));
    }
}

fn garbled(random: &mut Splitmix, value: f64) -> f64 {
    match (8.0 * random.part()) as u8 {
        0 => f64::from_bits((random.part() * 1.8e19) as u64),
        1 => f64::from_bits(value.to_bits() ^ (1 << ((64.0 * random.part()) as u32).min(63))),
        2 => value * 10_f64.powf(200.0 * random.part() - 100.0),
        3 => -value,
        4 => [f64::NAN, f64::INFINITY, 0.0, -0.0, 1e99, 1e60, f64::MIN_POSITIVE, 5e-324]
            [(8.0 * random.part()) as usize],
        5 => value * (1.0 + 1e-3 * (random.part() - 0.5)),
        6 => random.part(),
        _ => value * (3.0 * random.part()),
    }
}

fn no_garbled_state_exerts_what_it_cannot(cases: u64) {
    let (mut taken, mut refused) = (0, 0);
    garble(cases, |random| {
        let f = 0.4;
        for mut law in laws(f).into_iter().chain(gripping(f)) {
            for shift in path(random, 12, 0.0) {
                law.advance(shift).unwrap();
            }
            let mut numbers = [0.0; NUMBERS];
            law.pack(&mut numbers).unwrap();
            for _ in 0..1 + (3.0 * random.part() * random.part()) as usize {
                let at = (numbers.len() as f64 * random.part() * random.part()) as usize;
                numbers[at] = garbled(random, numbers[at]);
            }
            let before = law;
            if law.unpack(&numbers).is_err() {
                refused += 1;
                assert_eq!(law, before);
                continue;
            }
            taken += 1;
            let look = |law: &Law, what: &str| {
                let load = law.load();
                let force = load.f_x.hypot(load.f_y);
                let limit = f * load.f_z;
                // By the shift's round-off too, where that is far greater than the approach.
                let zeta = law.shift().zeta.max(0.0);
                let far = law.shift().xi.abs() + law.shift().eta.abs();
                let off = 1e-2 * limit + 1e-8 * STIFFNESS.c_x * far * zeta.sqrt();
                assert!(force <= limit + off, "{what}: {force:e} > {limit:e} {numbers:?}");
                assert!(
                    !law.stored_energy().is_nan() && !law.stick_depth().is_nan(),
                    "{what} {numbers:?}"
                );
            };
            look(&law, "taken");
            for to in path(random, 4, law.shift().xi) {
                let heat = law.dissipation(to);
                if law.advance(to).is_ok() {
                    look(&law, "stepped");
                    assert!(!heat.is_nan(), "{numbers:?}");
                }
            }
        }
    });
    println!("{taken} taken, {refused} refused");
    assert!(taken > cases / 4 && refused > cases / 4);
}

#[test]
fn garbled_numbers_are_refused_or_exert_no_more_than_friction_can() {
    no_garbled_state_exerts_what_it_cannot(600);
}

#[test]
#[ignore = "takes minutes"]
fn many_garbled_numbers_are_refused_or_exert_no_more_than_friction_can() {
    no_garbled_state_exerts_what_it_cannot(1_000_000);
}

#[test]
fn a_twist_beyond_its_sliding_torque_is_refused() {
    let constants = TorsionConstants { c_z: 4e9, stiffness: 1e5, arm: 0.02 };
    let mut law = TorsionLaw::from_constants(constants, friction(0.3)).unwrap();
    for (zeta, omega) in [(1e-7, 0.0), (1e-7, 2e-4), (0.9e-7, 1e-4), (1.1e-7, 1.2e-4)] {
        law.advance(Shift { zeta, omega, ..Shift::default() }).unwrap();
    }
    let mut numbers = [0.0; 4 + 7 + 6 * 12];
    law.pack(&mut numbers).unwrap();
    let before = law.clone();
    for (at, by, field) in [(8, 1e30, "torque"), (8, 1e3, "torque"), (6, 1.01, "radius")] {
        let mut wrong = numbers;
        wrong[at] *= by;
        let error = law.unpack(&wrong).unwrap_err();
        assert_eq!(error.field, field, "{at} {error}");
        assert_eq!(law, before);
    }
}
