//! Rolling resistance through the C interface.

use std::mem::zeroed;
use std::ptr::null_mut;

use carom_capi::*;

const GLASS: CaromMaterial =
    CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 };
const ROLLING: CaromRolling = CaromRolling { stiffness: 3e4, damping: 20.0, friction: 0.02 };
const RADII: [f64; 2] = [0.02, 0.03];
const PRESSED: f64 = 50.0;
const DT: f64 = 1e-4;

fn constants() -> CaromGrains {
    // SAFETY: plain numbers; all pointers are references or null.
    unsafe {
        let mut grains = zeroed();
        let to = &raw mut grains;
        let status = carom_grains_of(&GLASS, &GLASS, 0.3, 1, 0.0, 0.0, to, null_mut());
        assert_eq!(status, CaromStatus::Ok);
        grains
    }
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

/// Two grains on the z axis, pressed together and spinning, and the torques on them.
fn step(
    roll: &mut CaromRoll,
    rolling: &CaromRolling,
    spins: [[f64; 3]; 2],
    dt: f64,
    heat: &mut f64,
) -> CaromGrainLoad {
    let grain = |height: f64, radius: f64, spin| CaromGrain {
        place: [0.0, 0.0, height],
        velocity: [0.0; 3],
        spin,
        radius,
        mass: 1.0,
    };
    let one = grain(RADII[0] + RADII[1] - 1e-6, RADII[0], spins[0]);
    let two = grain(0.0, RADII[1], spins[1]);
    let mut load = CaromGrainLoad { force: [3.0, 0.0, PRESSED], ..CaromGrainLoad::default() };
    let grains = constants();
    // SAFETY: all pointers are references or null.
    let status = unsafe {
        carom_touch_roll_grains(&grains, rolling, roll, &one, &two, dt, &mut load, heat, null_mut())
    };
    assert_eq!(status, CaromStatus::Ok);
    assert_eq!(load.force, [3.0, 0.0, PRESSED]);
    load
}

const RELATIVE: f64 = 1.0 / (1.0 / RADII[0] + 1.0 / RADII[1]);

/// A slow roll: the torque is that of a spring of R^2 k and a dashpot of R^2 c.
#[test]
fn before_it_slips_it_is_a_spring_and_a_dashpot() {
    let (mut roll, mut heat) = (CaromRoll::default(), 0.0);
    let spins = [[0.01, 0.02, 0.7], [-0.02, 0.005, -0.7]];
    let mut load = CaromGrainLoad::default();
    for _ in 0..10 {
        load = step(&mut roll, &ROLLING, spins, DT, &mut heat);
    }
    let square = RELATIVE * RELATIVE;
    let [one, two] = spins;
    for (k, rate) in [one[0] - two[0], one[1] - two[1]].into_iter().enumerate() {
        let expected = -square * rate * (ROLLING.stiffness * 10.0 * DT + ROLLING.damping);
        assert!((load.torque_1[k] - expected).abs() < 1e-12, "{load:?} {expected}");
        assert!((load.torque_2[k] + expected).abs() < 1e-12);
    }
    assert!(load.torque_1[2].abs() < 1e-15, "none about the normal");
    // Of the heat the dashpot has its power times the time, but for half of the first step, whose force begins at 0.
    let way = ((one[0] - two[0]).powi(2) + (one[1] - two[1]).powi(2)) * square;
    let expected = ROLLING.damping * way * 9.5 * DT;
    assert!((heat - expected).abs() < 1e-9 * expected, "{heat} {expected}");
}

/// A fast roll slips at friction times the pressure, and stores at most the energy of the limit.
#[test]
fn it_slips_at_its_limit() {
    let (mut roll, mut heat) = (CaromRoll::default(), 0.0);
    let rate = 40.0;
    let mut load = CaromGrainLoad::default();
    let mut work = 0.0;
    for k in 0..2000 {
        let before = if k == 0 { 0.0 } else { load.torque_1[1] };
        let shift = roll.shift;
        load = step(&mut roll, &ROLLING, [[0.0, rate, 0.0], [0.0; 3]], DT, &mut heat);
        // Spring and dashpot carry the force together, also while it slips.
        for (i, force) in roll.force.into_iter().enumerate() {
            let dashpot = ROLLING.damping * (roll.shift[i] - shift[i]) / DT;
            assert!((force + ROLLING.stiffness * roll.shift[i] + dashpot).abs() < 1e-9, "{roll:?}");
        }
        work -= 0.5 * (before + load.torque_1[1]) * rate * DT;
        let mut energy = 0.0;
        // SAFETY: all pointers are references or null.
        unsafe { carom_touch_roll_energy(&ROLLING, &roll, &mut energy, null_mut()) };
        assert!(heat >= 0.0 && (work - energy - heat).abs() <= 1e-12 * work);
    }
    let limit = RELATIVE * ROLLING.friction * PRESSED;
    assert!((load.torque_1[1] + limit).abs() < 1e-12 * limit, "{load:?} {limit}");
    // The dashpot has come to rest: the spring carries the limit.
    let shift = dot(roll.shift, roll.shift).sqrt() * ROLLING.stiffness;
    assert!((shift - ROLLING.friction * PRESSED).abs() < 1e-9 * shift);
}

/// A pair that rotates as a whole does not roll, and keeps its torque in its own axes.
#[test]
fn a_pair_that_rotates_as_a_whole_does_not_roll() {
    let (grains, dt, rate) = (constants(), 1e-3, 1.0);
    let (mut roll, mut heat) = (CaromRoll::default(), 0.0);
    let mut torque = [0.0; 3];
    // About an axis that leans on the normal.
    let spin = [0.0, 0.8 * rate, 0.6 * rate];
    let turned = |v: [f64; 3], angle: f64| {
        let axis = spin.map(|w| w / rate);
        let (along, across) = (dot(axis, v), cross(axis, v));
        std::array::from_fn(|k| {
            v[k] * angle.cos() + across[k] * angle.sin() + axis[k] * along * (1.0 - angle.cos())
        })
    };
    let mut first = [0.0; 3];
    for k in 0..=1000 {
        let normal: [f64; 3] = turned([0.0, 0.0, 1.0], rate * dt * f64::from(k));
        let far = RADII[0] + RADII[1] - 1e-6;
        let own = if k == 0 { [0.1, 0.0, 0.0] } else { [0.0; 3] };
        let one = CaromGrain {
            place: normal.map(|n| n * far),
            velocity: [0.0; 3],
            spin: std::array::from_fn(|k| spin[k] + own[k]),
            radius: RADII[0],
            mass: 1.0,
        };
        let two =
            CaromGrain { place: [0.0; 3], velocity: [0.0; 3], spin, radius: RADII[1], mass: 1.0 };
        let mut load = CaromGrainLoad { force: normal.map(|n| n * PRESSED), ..Default::default() };
        let rolling = CaromRolling { damping: 0.0, ..ROLLING };
        // SAFETY: all pointers are references or null.
        let status = unsafe {
            carom_touch_roll_grains(
                &grains,
                &rolling,
                &mut roll,
                &one,
                &two,
                dt,
                &mut load,
                &mut heat,
                null_mut(),
            )
        };
        assert_eq!(status, CaromStatus::Ok);
        torque = load.torque_1;
        if k == 0 {
            first = torque;
        }
    }
    let expected: [f64; 3] = turned(first, 1.0);
    let size = dot(first, first).sqrt();
    for k in 0..3 {
        assert!((torque[k] - expected[k]).abs() < 1e-6 * size, "{torque:?} {expected:?}");
    }
}

#[test]
fn the_end_of_a_contact_gives_its_energy_as_heat() {
    let (grains, mut heat) = (constants(), 0.0);
    let mut roll = CaromRoll::default();
    let rolling = CaromRolling { damping: 0.0, ..ROLLING };
    step(&mut roll, &rolling, [[0.0, 0.01, 0.0], [0.0; 3]], DT, &mut heat);
    let mut energy = 0.0;
    // SAFETY: all pointers are references or null.
    unsafe { carom_touch_roll_energy(&rolling, &roll, &mut energy, null_mut()) };
    assert!(energy > 0.0 && heat.abs() < 1e-12 * energy);
    let one = CaromGrain {
        place: [0.0, 0.0, 0.06],
        velocity: [0.0; 3],
        spin: [0.0; 3],
        radius: RADII[0],
        mass: 1.0,
    };
    let two = CaromGrain { place: [0.0; 3], radius: RADII[1], ..one };
    let mut load = CaromGrainLoad::default();
    // SAFETY: all pointers are references or null.
    let status = unsafe {
        carom_touch_roll_grains(
            &grains,
            &rolling,
            &mut roll,
            &one,
            &two,
            DT,
            &mut load,
            &mut heat,
            null_mut(),
        )
    };
    assert_eq!((status, roll), (CaromStatus::Ok, CaromRoll::default()));
    assert!((heat - energy).abs() < 1e-12 * energy);
}

#[test]
fn what_is_wrong_is_named() {
    let grains = constants();
    let one = CaromGrain {
        place: [0.0, 0.0, 0.0199],
        velocity: [0.0; 3],
        spin: [0.0; 3],
        radius: 0.02,
        mass: 1.0,
    };
    let wall = CaromSurface {
        place: [0.0; 3],
        normal: [0.0, 0.0, 1.0],
        velocity: [0.0; 3],
        spin: [0.0; 3],
        axis: [0.0; 3],
    };
    let call = |rolling: CaromRolling, mut roll: CaromRoll| {
        // SAFETY: plain numbers; all pointers are references.
        unsafe {
            let (mut load, mut error) = (CaromGrainLoad::default(), zeroed::<CaromError>());
            let mut heat = 0.0;
            let status = carom_touch_roll_surface(
                &grains, &rolling, &mut roll, &one, &wall, DT, &mut load, &mut heat, &mut error,
            );
            let field = error.field.iter().take_while(|b| **b != 0).map(|b| *b as u8 as char);
            (status, field.collect::<String>())
        }
    };
    let good = CaromRoll::default();
    for (rolling, field) in [
        (CaromRolling { stiffness: -1.0, ..ROLLING }, "stiffness"),
        (CaromRolling { damping: f64::NAN, ..ROLLING }, "damping"),
        (CaromRolling { friction: f64::INFINITY, ..ROLLING }, "friction"),
    ] {
        assert_eq!(call(rolling, good), (CaromStatus::OutOfRange, field.to_owned()));
    }
    for roll in [
        CaromRoll { normal: [0.0, 0.0, 2.0], ..good },
        CaromRoll { shift: [f64::NAN, 0.0, 0.0], ..good },
        CaromRoll { force: [f64::INFINITY, 0.0, 0.0], ..good },
    ] {
        assert_eq!(call(ROLLING, roll), (CaromStatus::BadState, "roll".to_owned()));
    }
    assert_eq!(call(ROLLING, good).0, CaromStatus::Ok);
}
