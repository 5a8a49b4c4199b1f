//! The resistance of grains to rolling: spring, dashpot and slider, in axes that move with the grains.

use carom_laws::grains::{Grain, GrainRoll, Heats, Meeting, Rolling, RollingResistance, Surface};

use crate::grains::{cross, dot};

const RADII: [f64; 2] = [0.02, 0.03];
const RELATIVE: f64 = 1.0 / (1.0 / RADII[0] + 1.0 / RADII[1]);
const STIFFNESS: f64 = 3e4;
const DAMPING: f64 = 20.0;
const FRICTION: f64 = 0.02;
const PRESSED: f64 = 50.0;
const DT: f64 = 1e-4;

type V = [f64; 3];

fn resistance(damping: f64) -> RollingResistance {
    RollingResistance::new(STIFFNESS, damping, FRICTION).unwrap()
}

/// Two grains along a normal, so deep in each other and spinning.
fn meeting(normal: V, zeta: f64, spins: [V; 2]) -> Meeting {
    let grain = |height: f64, radius, spin| Grain {
        place: normal.map(|n| n * height),
        velocity: [0.0; 3],
        spin,
        radius,
        mass: 1.0,
    };
    let one = grain(RADII[0] + RADII[1] - zeta, RADII[0], spins[0]);
    Meeting::of_spheres(&one, &grain(0.0, RADII[1], spins[1]), [0.5; 2]).unwrap()
}

/// The torque on body 1 of a step on the z axis, and its heat.
fn step(roll: &mut GrainRoll, damping: f64, spins: [V; 2], heats: &mut Heats) -> V {
    let met = meeting([0.0, 0.0, 1.0], 1e-6, spins);
    let resistance = &resistance(damping);
    let mut rolling = Rolling { resistance, relative_radius: RELATIVE, roll };
    rolling.advance(&met, DT, PRESSED, Some(heats)).unwrap()
}

/// A slow roll: the torque is that of a spring of R^2 k and a dashpot of R^2 c.
#[test]
fn before_it_slips_it_is_a_spring_and_a_dashpot() {
    let (mut roll, mut heats) = (GrainRoll::default(), Heats::default());
    let [one, two] = [[0.01, 0.02, 0.7], [-0.02, 0.005, -0.7]];
    let mut torque = [0.0; 3];
    for _ in 0..10 {
        torque = step(&mut roll, DAMPING, [one, two], &mut heats);
    }
    let square = RELATIVE * RELATIVE;
    for (k, rate) in [one[0] - two[0], one[1] - two[1]].into_iter().enumerate() {
        let expected = -square * rate * (STIFFNESS * 10.0 * DT + DAMPING);
        assert!((torque[k] - expected).abs() < 1e-12, "{torque:?} {expected}");
    }
    assert!(torque[2].abs() < 1e-15, "none about the normal");
    // Of the heat the dashpot has its power times the time, but for half of the first step, whose force begins at 0.
    let way = ((one[0] - two[0]).powi(2) + (one[1] - two[1]).powi(2)) * square;
    let expected = DAMPING * way * 9.5 * DT;
    assert!((heats.rolling - expected).abs() < 1e-9 * expected, "{heats:?} {expected}");
    assert_eq!([heats.friction, heats.damping], [0.0; 2]);
}

/// A fast roll slips at friction times the pressure, and stores at most the energy of the limit.
#[test]
fn it_slips_at_its_limit() {
    let (mut roll, mut heats, rate) = (GrainRoll::default(), Heats::default(), 40.0);
    let (mut torque, mut work) = ([0.0; 3], 0.0);
    let spring = |roll: &GrainRoll| (2.0 * STIFFNESS * roll.stored_energy(&resistance(0.0))).sqrt();
    for _ in 0..2000 {
        let before = torque[1];
        torque = step(&mut roll, DAMPING, [[0.0, rate, 0.0], [0.0; 3]], &mut heats);
        work -= 0.5 * (before + torque[1]) * rate * DT;
        let energy = roll.stored_energy(&resistance(0.0));
        assert!(heats.rolling >= 0.0 && (work - energy - heats.rolling).abs() <= 1e-12 * work);
    }
    let limit = FRICTION * PRESSED;
    assert!((torque[1] + RELATIVE * limit).abs() < 1e-12 * limit, "{torque:?} {limit}");
    // The dashpot has come to rest: the spring carries the limit.
    assert!((spring(&roll) - limit).abs() < 1e-9 * limit);
    // While it comes to rest, spring and dashpot carry the force together.
    let numbers = roll.packed();
    let before = [numbers[0], numbers[1], numbers[2]];
    step(&mut roll, DAMPING, [[rate, 0.0, 0.0], [0.0; 3]], &mut heats);
    let numbers = roll.packed();
    for i in 0..3 {
        let dashpot = DAMPING * (numbers[i] - before[i]) / DT;
        assert!((numbers[6 + i] + STIFFNESS * numbers[i] + dashpot).abs() < 1e-9, "{numbers:?}");
    }
}

/// Of a slow roll whose axis turns with the pair by .2 a step, the heat of the slider is force times way.
#[test]
fn a_roll_that_slips_while_the_pair_turns_heats_by_its_limit() {
    let (mut roll, mut heats, rate, turn) = (GrainRoll::default(), Heats::default(), 40.0, 0.2);
    let mut at = |k: usize| {
        let angle = turn * k as f64;
        let spins = [[rate * angle.cos(), rate * angle.sin(), turn / DT], [0.0, 0.0, turn / DT]];
        step(&mut roll, 0.0, spins, &mut heats);
        heats.rolling
    };
    let before = (0..10).map(&mut at).last().unwrap();
    let after = (10..110).map(&mut at).last().unwrap();
    let expected = FRICTION * PRESSED * RELATIVE * rate * DT * 100.0;
    assert!(((after - before) / expected - 1.0).abs() < 1e-3, "{after} {before} {expected}");
}

/// As its normal turns by .3 in a step, what it has rolled stays in the plane of contact, to the last digits.
#[test]
fn a_roll_lies_in_the_plane_of_contact() {
    let mut roll = GrainRoll::default();
    for k in 0..4 {
        let (sin, cos) = (0.3 * f64::from(k)).sin_cos();
        let met = meeting([sin, 0.0, cos], 1e-6, [[3.0, 20.0, 0.0], [0.0; 3]]);
        let resistance = &resistance(DAMPING);
        let mut rolling = Rolling { resistance, relative_radius: RELATIVE, roll: &mut roll };
        rolling.advance(&met, DT, PRESSED, None).unwrap();
        let [shift, normal, force] = [0, 3, 6].map(|i| <V>::try_from(&roll.packed()[i..i + 3]));
        let normal = normal.unwrap();
        for vector in [shift, force].map(Result::unwrap) {
            let size = dot(vector, vector).sqrt();
            assert!(
                size > 0.0 && dot(vector, normal).abs() < 1e-14 * size,
                "{vector:?} {normal:?}"
            );
        }
    }
}

/// A contact that pulls has no friction to roll with; one that is apart rolls no more, though no time has passed.
#[test]
fn what_is_not_pressed_does_not_roll() {
    let mut roll = GrainRoll::default();
    step(&mut roll, DAMPING, [[1.0, 0.0, 0.0], [0.0; 3]], &mut Heats::default());
    let resistance = &resistance(DAMPING);
    for (zeta, dt, force) in [(1e-6, DT, -PRESSED), (-1e-6, 0.0, PRESSED)] {
        let met = meeting([0.0, 0.0, 1.0], zeta, [[1.0, 0.0, 0.0], [0.0; 3]]);
        let mut rolling = Rolling { resistance, relative_radius: RELATIVE, roll: &mut roll };
        assert_eq!(rolling.advance(&met, dt, force, None).unwrap().map(f64::abs), [0.0; 3]);
    }
    assert_eq!(roll, GrainRoll::default());
}

/// A pair that rotates as a whole does not roll, and keeps its torque in its own axes.
#[test]
fn a_pair_that_rotates_as_a_whole_does_not_roll() {
    let (dt, rate) = (1e-3, 1.0);
    // About an axis that leans on the normal.
    let axis: V = [0.0, 0.8, 0.6];
    let turned = |v: V, angle: f64| -> V {
        let (along, across) = (dot(axis, v), cross(axis, v));
        std::array::from_fn(|k| {
            v[k] * angle.cos() + across[k] * angle.sin() + axis[k] * along * (1.0 - angle.cos())
        })
    };
    let (mut roll, mut torque, mut first) = (GrainRoll::default(), [0.0; 3], [0.0; 3]);
    for k in 0..=1000 {
        let normal = turned([0.0, 0.0, 1.0], rate * dt * f64::from(k));
        let spin = axis.map(|w| w * rate);
        let own = if k == 0 { 0.1 } else { 0.0 };
        let met = meeting(normal, 1e-6, [[spin[0] + own, spin[1], spin[2]], spin]);
        let rolling = &mut Rolling {
            resistance: &resistance(0.0),
            relative_radius: RELATIVE,
            roll: &mut roll,
        };
        torque = rolling.advance(&met, dt, PRESSED, None).unwrap();
        if k == 0 {
            first = torque;
        }
    }
    let (expected, size) = (turned(first, 1.0), dot(first, first).sqrt());
    for k in 0..3 {
        assert!((torque[k] - expected[k]).abs() < 1e-6 * size, "{torque:?} {expected:?}");
    }
}

#[test]
fn the_end_of_a_contact_gives_its_energy_as_heat() {
    let (mut roll, mut heats) = (GrainRoll::default(), Heats::default());
    step(&mut roll, 0.0, [[0.0, 0.01, 0.0], [0.0; 3]], &mut heats);
    let energy = roll.stored_energy(&resistance(0.0));
    assert!(energy > 0.0 && heats.rolling.abs() < 1e-12 * energy);
    let apart = meeting([0.0, 0.0, 1.0], -0.01, [[0.0; 3]; 2]);
    let resistance = &resistance(0.0);
    let mut rolling = Rolling { resistance, relative_radius: RELATIVE, roll: &mut roll };
    let torque = rolling.advance(&apart, DT, 0.0, Some(&mut heats)).unwrap();
    assert_eq!((torque, roll), ([0.0; 3], GrainRoll::default()));
    assert!((heats.rolling - energy).abs() < 1e-12 * energy);
}

/// A step without time tells the torque of the last one; on a wall it is that of the grain's radius.
#[test]
fn what_was_packed_goes_on_to_the_same_bits() {
    let mut roll = GrainRoll::default();
    let one = Grain {
        place: [0.0, 0.0, RADII[0] - 1e-6],
        velocity: [0.0; 3],
        spin: [0.4, -0.3, 2.0],
        radius: RADII[0],
        mass: 1.0,
    };
    let wall = Surface {
        place: [0.0; 3],
        normal: [0.0, 0.0, 1.0],
        velocity: [0.0; 3],
        spin: [0.0, 0.1, 0.0],
        axis: [0.0; 3],
    };
    let met = Meeting::on_surface(&one, &wall, 0.5);
    let go = |roll: &mut GrainRoll, dt| {
        let resistance = &resistance(DAMPING);
        let mut rolling = Rolling { resistance, relative_radius: RADII[0], roll };
        rolling.advance(&met, dt, PRESSED, None).unwrap()
    };
    for _ in 0..20 {
        let torque = go(&mut roll, DT);
        let mut again = GrainRoll::unpacked(&roll.packed()).unwrap();
        assert_eq!(again, roll);
        assert_eq!([go(&mut again, 0.0), roll.torque(RADII[0], &met)], [torque; 2]);
        assert_eq!(again, roll);
    }
}

#[test]
fn what_is_wrong_is_named() {
    for (numbers, field) in [
        ([-1.0, 0.0, 0.1], "stiffness"),
        ([1.0, f64::NAN, 0.1], "damping"),
        ([1.0, 0.0, f64::INFINITY], "friction"),
    ] {
        let [stiffness, damping, friction] = numbers;
        let error = RollingResistance::new(stiffness, damping, friction).unwrap_err();
        assert_eq!(error.field, field);
    }
    let mut roll = GrainRoll::default();
    step(&mut roll, DAMPING, [[1.0, 0.0, 0.0], [0.0; 3]], &mut Heats::default());
    for (at, wrong) in [(0, f64::NAN), (5, 2.0), (6, f64::INFINITY)] {
        let mut numbers = roll.packed();
        numbers[at] = wrong;
        assert_eq!(GrainRoll::unpacked(&numbers).unwrap_err().field, "roll");
    }
    // Motions beyond all range change nothing.
    let before = roll;
    for (spin, dt) in [(1e200, DT), (f64::NAN, DT), (1.0, f64::NAN), (1.0, f64::INFINITY)] {
        let met = meeting([0.0, 0.0, 1.0], 1e-6, [[spin, 0.0, 0.0], [0.0; 3]]);
        let resistance = &resistance(DAMPING);
        let mut rolling = Rolling { resistance, relative_radius: RELATIVE, roll: &mut roll };
        let told = rolling.advance(&met, dt, PRESSED, None);
        assert_eq!(told.unwrap_err().field, "rolling resistance");
        assert_eq!(roll, before);
    }
}
