//! The contact of two grains moves with them.

use carom_laws::damping::HertzDamping;
use carom_laws::friction::Friction;
use carom_laws::grains::{
    Grain, GrainContact, GrainLoad, Heats, Meeting, TOGETHER, Touching, Wall, advance_together,
    grain_numbers,
};
use carom_laws::memory::Fixed;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use proptest::prelude::*;

type V = [f64; 3];
type Contact = GrainContact<ShiftLaw<[f64; 2], Fixed<[f64; 2], 12>>>;

fn fresh(relaxation: f64) -> Contact {
    let stiffness = ContactStiffness::new(0.85, 0.85, 1.0).unwrap();
    GrainContact::new(ShiftLaw::new(stiffness, Friction::new(0.4).unwrap()), relaxation).unwrap()
}

pub(crate) fn plus(a: V, b: V, by: f64) -> V {
    [a[0] + by * b[0], a[1] + by * b[1], a[2] + by * b[2]]
}

pub(crate) fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Rodrigues: a vector turned by the length of another about it.
fn turned(a: V, by: V) -> V {
    let angle = dot(by, by).sqrt();
    if angle == 0.0 {
        return a;
    }
    let axis = by.map(|b| b / angle);
    let (sine, cosine) = angle.sin_cos();
    let across = cross(axis, a);
    let along = dot(axis, a) * (1.0 - cosine);
    [0, 1, 2].map(|k| cosine * a[k] + sine * across[k] + along * axis[k])
}

fn vector(size: f64) -> impl Strategy<Value = V> {
    [-size..size, -size..size, -size..size]
}

/// A pair pressed and shifted, and then turned as a whole at this spin by steps of dt.
fn turned_as_a_whole(shift: V, spin: V, dt: f64, steps: usize) -> (f64, V, V) {
    let grain =
        Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
    let arm = [0.6, 0.0, 0.8];
    let one = Grain { place: arm.map(|x| 1.98 * x), velocity: shift, ..grain };
    let mut contact = fresh(0.0);
    let still = Grain { velocity: [0.0; 3], ..one };
    let mut before = GrainLoad::default();
    // Two steps at rest, so that nothing is accelerated any more.
    for body in [still, one, still, still] {
        let meeting = Meeting::of_spheres(&body, &grain, [0.5; 2]).unwrap();
        before = contact.advance(&meeting, 1.0).unwrap();
    }
    let mut load = before;
    for step in 1..=steps {
        // Velocities of a leapfrog: those of the middle of the step.
        let at = |t: f64| turned(one.place, spin.map(|w| w * t * dt));
        let (here, middle) = (at(step as f64), at(step as f64 - 0.5));
        let body =
            Grain { place: here, velocity: cross(spin, middle), spin, radius: 1.0, mass: 1.0 };
        let other = Grain { spin, ..grain };
        let meeting = Meeting::of_spheres(&body, &other, [0.5; 2]).unwrap();
        load = contact.advance(&meeting, dt).unwrap();
        // The axes stay a frame: what round-off does is of the last step alone.
        let tangent = contact.tangent();
        assert!(dot(tangent, meeting.normal).abs() < 1e-15);
        assert!((dot(tangent, tangent) - 1.0).abs() < 1e-15);
    }
    let angle = spin.map(|w| w * dt * steps as f64);
    let expected = turned(before.force, angle);
    let off = plus(load.force, expected, -1.0);
    (dot(off, off).sqrt() / dot(before.force, before.force).sqrt(), load.force, load.torques[0])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// A pair that turns as a whole keeps its load, which turns along: what is off falls with the
    /// square of the step.
    #[test]
    fn turning_as_a_whole_does_not_slip(shift in vector(3e-3), spin in vector(0.5)) {
        let off = |dt: f64| turned_as_a_whole(shift, spin, dt, (6.0 / dt) as usize).0;
        let (coarse, fine) = (off(1e-2), off(1e-3));
        prop_assert!(coarse < 1e-2, "{coarse:e}");
        prop_assert!(fine < 1e-4, "{fine:e}");
    }

    /// Actio est reactio, whichever is called the first; momenta balance.
    #[test]
    fn either_grain_may_be_the_first(
        places in (vector(0.3), vector(0.1)),
        velocities in (vector(1e-2), vector(1e-2)),
        spins in (vector(1e-2), vector(1e-2)),
        share in 0.0..1.0_f64,
    ) {
        let apart = plus([1.0, 0.7, 0.0], places.0, 1.0);
        let length = dot(apart, apart).sqrt();
        let one = Grain { place: places.1, velocity: velocities.0, spin: spins.0, radius: 0.5 * length, mass: 1.0 };
        let two = Grain {
            place: plus(places.1, apart, 1.0), velocity: velocities.1, spin: spins.1, radius: 0.55 * length, mass: 2.0,
        };
        let (mut contact, mut other) = (fresh(0.3), fresh(0.3));
        let (mut ways, dt) = ([one, two], 0.1);
        for _ in 0..30 {
            for body in &mut ways {
                body.place = plus(body.place, body.velocity, dt);
            }
            let [one, two] = &ways;
            let meeting = Meeting::of_spheres(one, two, [share, 1.0 - share]).unwrap();
            let exchanged = Meeting::of_spheres(two, one, [1.0 - share, share]).unwrap();
            let load = contact.advance(&meeting, dt).unwrap();
            let opposite = other.advance(&exchanged, dt).unwrap();
            let size = dot(load.force, load.force).sqrt();
            for k in 0..3 {
                prop_assert!((load.force[k] + opposite.force[k]).abs() <= 1e-9 * size);
                for i in 0..2 {
                    prop_assert!((load.torques[i][k] - opposite.torques[1 - i][k]).abs() <= 1e-9 * size);
                }
            }
            // The torque of both forces about the origin, with those on the bodies themselves.
            let moment = |body: &Grain, sign: f64, torque: V| {
                plus(cross(body.place, load.force.map(|f| sign * f)), torque, 1.0)
            };
            let sum = plus(moment(one, 1.0, load.torques[0]), moment(two, -1.0, load.torques[1]), 1.0);
            prop_assert!(dot(sum, sum).sqrt() <= 1e-14 * size, "{sum:?}");
        }
    }

    /// Heat is not made of nothing, but for what the contact gains where it simplifies its memory, and damping does not
    /// pull.
    #[test]
    fn heats_are_not_negative(walk in prop::collection::vec((vector(1e-2), vector(1e-2)), 1..60)) {
        let wall = Wall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: [0.0; 3] };
        let mut contact = fresh(0.5);
        let mut grain = Grain { place: [0.0, 0.0, 0.995], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
        let (mut heats, mut stored) = (Heats::default(), 0.0_f64);
        for (velocity, spin) in walk {
            (grain.velocity, grain.spin) = (velocity, spin);
            grain.place = plus(grain.place, velocity, 1.0);
            let meeting = Meeting::on_wall(&grain, &wall, 1.0);
            let (was, drag) = (heats, contact);
            let load = contact.advance_accounted(&meeting, 1.0, &mut heats).unwrap();
            prop_assert!(load.force[2] >= 0.0);
            stored = stored.max(contact.stored_energy());
            prop_assert!(heats.friction >= was.friction - 1e-4 * stored, "{heats:?} {was:?} {stored}");
            prop_assert_eq!(load, contact.load(&meeting));
            let mut numbers = [0.0; grain_numbers(12)];
            drag.pack(&mut numbers).unwrap();
            let mut again = fresh(0.5);
            again.unpack(&numbers).unwrap();
            prop_assert_eq!(again.load(&meeting), drag.load(&meeting));
        }
    }
}

#[test]
fn what_is_no_contact_is_refused() {
    let grain =
        Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
    assert_eq!(Meeting::of_spheres(&grain, &grain, [0.5; 2]).unwrap_err().field, "distance");
    let stiffness = ContactStiffness::new(1.0, 1.0, 1.0).unwrap();
    let law = ShiftLaw::<_, Fixed<_, 12>>::new(stiffness, Friction::new(0.4).unwrap());
    assert_eq!(GrainContact::new(law, -1.0).unwrap_err().field, "relaxation");
    let mut contact = fresh(0.0);
    let mut numbers = [0.0; grain_numbers(12)];
    for (at, field) in [(66, "tangent"), (69, "normal"), (74, "force"), (78, "lead"), (0, "mark")] {
        numbers[at] = if at >= 74 { f64::NAN } else { 2.0 };
        assert_eq!(contact.unpack(&numbers).unwrap_err().field, field);
        assert_eq!(contact, fresh(0.0));
        numbers[at] = 0.0;
    }
    assert!(contact.unpack(&numbers[..5]).is_err());
}

/// The normal turns right round in one step, or nearly so: the axes stay of length 1 and across it.
#[test]
fn normal_may_turn_right_round() {
    let grain =
        Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
    for lean in [0.0, 1e-14, 1e-9, 1e-4, 0.3, 1.5] {
        let mut contact = fresh(0.0);
        let angle = std::f64::consts::PI - lean;
        for along in [[0.0, 0.0, 1.98], [0.0, 1.98 * angle.sin(), 1.98 * angle.cos()]] {
            let body = Grain { place: along, ..grain };
            let meeting = Meeting::of_spheres(&body, &grain, [0.5; 2]).unwrap();
            let load = contact.advance(&meeting, 0.1).unwrap();
            let tangent = contact.tangent();
            assert!((dot(tangent, tangent) - 1.0).abs() < 1e-12, "{lean}: {tangent:?}");
            assert!(dot(tangent, meeting.normal).abs() < 1e-12, "{lean}: {tangent:?}");
            assert!(dot(load.force, load.force) > 0.0 && load.force.iter().all(|f| f.is_finite()));
        }
    }
}

/// A grain that swings on a wall without slip, by leapfrog: its period is that of the spring, which the
/// leapfrog alone misses by y/24 with y = (omega dt)^2, and it loses y^2/24 of its amplitude a step.
#[test]
fn swing_without_slip_keeps_its_period_and_gains_nothing() {
    let stiffness = ContactStiffness::new(0.85, 0.85, 1.0).unwrap();
    let law = ShiftLaw::<[f64; 2]>::new(stiffness, Friction::INFINITE);
    let mut contact = GrainContact::new(law, 0.0).unwrap();
    let wall = Wall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: [0.0; 3] };
    let zeta = 0.01_f64;
    let y = 0.1;
    // Steps of 1: the mass is stiffness over y.
    let mass = 0.85 * zeta.sqrt() / y;
    let (mut x, mut v) = (0.0, 1e-6);
    let (mut crossings, mut highest) = (Vec::new(), Vec::new());
    for step in 0..2000 {
        let before = x;
        x += v;
        let place = [x, 0.0, 1.0 - zeta];
        let body = Grain { place, velocity: [v, 0.0, 0.0], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
        let load = contact.advance(&Meeting::on_wall(&body, &wall, 1.0), 1.0).unwrap();
        v += load.force[0] / mass;
        if before < 0.0 && x >= 0.0 {
            crossings.push(f64::from(step) - x / (x - before));
            highest.push(v);
        }
    }
    let count = crossings.len() - 1;
    let span = crossings[count] - crossings[0];
    let period = span / count as f64;
    let expected = 2.0 * std::f64::consts::PI / y.sqrt();
    assert!((period / expected - 1.0).abs() < 3e-4, "{period} for {expected}");
    let loss = -(highest[count] / highest[0]).ln() / span;
    assert!(loss > 0.0 && (loss / (y * y / 24.0) - 1.0).abs() < 0.1, "{loss}");
}

/// Pairs that meet, slide, turn fast, part and meet again: together they go as alone, to the bit, whichever
/// begin or end in a step; where one cannot make it, none does.
#[test]
fn together_each_goes_as_alone() {
    let restituting =
        |e: f64| fresh(0.0).with_restitution(HertzDamping::of_restitution(e).unwrap()).unwrap();
    go_as_alone([0; TOGETHER].map(|_| fresh(0.0)));
    go_as_alone(std::array::from_fn(|i| fresh(0.2 * i as f64)));
    go_as_alone(std::array::from_fn(|i| fresh(0.1 + 0.2 * i as f64)));
    go_as_alone([0.2, 0.5, 0.7, 0.95].map(restituting));
    go_as_alone([fresh(0.1), restituting(0.5), fresh(0.3), restituting(0.9)]);
}

fn go_as_alone(mut alone: [Contact; TOGETHER]) {
    let mut together = alone;
    let (mut sum, mut apart) = (0.0, 0);
    let shares = [0.5, 0.25, 1.0, 0.0].map(|share| [share, 1.0 - share]);
    for step in 0..2000 {
        let t = 0.05 * f64::from(step);
        let bodies: [[Grain; 2]; TOGETHER] = std::array::from_fn(|i| {
            let (i, still) = (i as f64, [0.0; 3]);
            let place =
                [0.3 * (0.21 * t + i).sin(), 0.2 * (0.3 * t).cos(), 1.99 + 0.02 * (t + i).sin()];
            let velocity =
                [0.063 * (0.21 * t + i).cos(), -0.06 * (0.3 * t).sin(), 0.02 * (t + i).cos()];
            let spin = [0.02 * (0.7 * t).sin(), 0.01, 0.4 * (0.5 * t * i).sin()];
            let radius = 1.0 + 0.02 * (0.1 * t).sin();
            [
                Grain { place, velocity, spin, radius, mass: 1.0 },
                Grain { place: still, velocity: still, spin, radius: 1.0, mass: 1.0 },
            ]
        });
        let dt = if step % 7 == 0 { 0.0 } else { 0.05 };
        let mut loads = [GrainLoad::default(); TOGETHER];
        let mut pairs: Vec<_> = together
            .iter_mut()
            .zip(&mut loads)
            .enumerate()
            .map(|(i, (contact, load))| {
                let [one, two] = &bodies[i];
                Touching { contact, bodies: [one, two], shares: shares[i], rolling: None, load }
            })
            .collect();
        let mut pairs: [_; TOGETHER] = std::mem::take(&mut pairs).try_into().unwrap();
        let before = pairs.each_ref().map(|pair| *pair.contact);
        let fast = Grain { velocity: [0.0, 1e300, 0.0], ..bodies[2][0] };
        pairs[2].bodies[0] = &fast;
        assert!(advance_together(&mut pairs, 1.0, |_| {}).is_err());
        pairs[2].bodies[0] = &bodies[2][0];
        assert!(advance_together(&mut pairs, f64::NAN, |_| {}).is_err());
        assert_eq!(pairs.each_ref().map(|pair| *pair.contact), before);
        assert!(pairs.iter().all(|pair| *pair.load == GrainLoad::default()));
        advance_together(&mut pairs, dt, |_| {}).unwrap();
        for (i, load) in loads.into_iter().enumerate() {
            let [one, two] = &bodies[i];
            let meeting = Meeting::of_spheres(one, two, shares[i]).unwrap();
            assert_eq!(load, alone[i].advance(&meeting, dt).unwrap());
            assert_eq!(together[i], alone[i], "step {step}, pair {i}");
            sum += load.force[0].abs();
            apart += usize::from(meeting.zeta < 0.0);
        }
    }
    assert!(sum > 1.0 && apart > 100, "{sum} {apart}");
}

/// The first step of a contact has seen the touch, wherever in it that was: on a way that rises and shifts
/// alike, all sticks, and F_x = (2/3) c_x (xi/zeta) zeta^1.5.
#[test]
fn a_contact_begins_where_its_first_step_touched() {
    let wall = Wall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: [0.0; 3] };
    let (slope, dt) = (0.1, 0.5);
    for (part, accounted) in [(1e-3, false), (0.3, true), (0.5, false), (1.0, true)] {
        let by = 1e-3;
        let zeta = part * by;
        let velocity = [slope * by / dt, 0.0, -by / dt];
        let place = [0.0, 0.0, 1.0 - zeta];
        let grain = Grain { place, velocity, spin: [0.0; 3], radius: 1.0, mass: 1.0 };
        let meeting = Meeting::on_wall(&grain, &wall, 1.0);
        let (mut contact, mut heats) = (fresh(0.0), Heats::default());
        let load = match accounted {
            true => contact.advance_accounted(&meeting, dt, &mut heats),
            false => contact.advance(&meeting, dt),
        };
        let [x, y, z] = load.unwrap().force;
        let normal = 2.0 / 3.0 * zeta.powf(1.5);
        assert!((z / normal - 1.0).abs() < 1e-10, "{part}: {z:e} for {normal:e}");
        assert!((x / (-0.85 * slope * normal) - 1.0).abs() < 1e-10, "{part}: {x:e}");
        assert!(y.abs() < 1e-14 * normal && heats.friction.abs() < 1e-12 * normal * by);
    }
}

/// A viscous contact that is pulled apart pushes as an elastic one that is ahead by what the approach loses in the
/// relaxation time; one that is pressed, by the same to first order.
#[test]
fn damping_is_ahead_by_the_relaxation_time() {
    let wall = Wall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: [0.0; 3] };
    let pushed = |zeta: f64, speed: f64, relaxation: f64| {
        let (place, velocity) = ([0.0, 0.0, 1.0 - zeta], [0.0, 0.0, -speed]);
        let grain = Grain { place, velocity, spin: [0.0; 3], radius: 1.0, mass: 1.0 };
        let meeting = Meeting::on_wall(&grain, &wall, 1.0);
        fresh(relaxation).advance(&meeting, 1e-3).unwrap().force[2]
    };
    let (zeta, relaxation) = (1e-2, 0.3);
    for speed in [-1e-5, -1e-3, -1e-2, -0.03] {
        let (force, elastic) =
            (pushed(zeta, speed, relaxation), pushed(zeta + relaxation * speed, 0.0, 0.0));
        assert!((force / elastic - 1.0).abs() < 1e-12, "{speed}: {force:e} for {elastic:e}");
    }
    assert_eq!(pushed(zeta, -0.034, relaxation), 0.0);
    for speed in [1e-5, 1e-3, 1e-2] {
        let elastic = pushed(zeta, 0.0, 0.0);
        let rate = 1.5 * elastic / zeta * relaxation * speed;
        let drag = pushed(zeta, speed, relaxation) - elastic;
        assert!((drag / rate - 1.0).abs() < 1e-9, "{speed}: {drag:e} for {rate:e}");
    }
}

/// A pair that accelerates, kept as numbers between any two steps, goes on as the one that was never stored.
#[test]
fn a_pair_kept_in_numbers_accelerates_on() {
    let wall = Wall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: [0.0; 3] };
    let (mut contact, mut numbers) = (fresh(0.1), [0.0; grain_numbers(12)]);
    let mut place = 0.0;
    for step in 0..40 {
        let t = 0.3 * f64::from(step);
        let velocity = 1e-4 * (t.sin() + 0.5 * (2.3 * t).cos());
        place += velocity;
        let body = Grain {
            place: [place, 0.0, 0.99],
            velocity: [velocity, -0.4 * velocity, 0.0],
            spin: [0.0; 3],
            radius: 1.0,
            mass: 1.0,
        };
        let meeting = Meeting::on_wall(&body, &wall, 1.0);
        let load = contact.advance(&meeting, 1.0).unwrap();
        let mut kept = fresh(0.1);
        kept.unpack(&numbers).unwrap();
        let again = kept.advance(&meeting, 1.0).unwrap();
        kept.pack(&mut numbers).unwrap();
        for (one, other) in load.force.iter().zip(again.force) {
            assert!((one - other).abs() <= 1e-12 * load.force[2], "{step}: {load:?} {again:?}");
        }
    }
}
