//! Static friction and friction by the slip speed of grains.

use super::*;

const RADIUS: f64 = 1e-3;
const DEEP: f64 = 1e-7;
const DT: f64 = 1e-7;
const F_S: f64 = 0.5;
const F_K: f64 = 0.3;
const BY_SPEED: [f64; 3] = [0.1, 0.4, 2.0];

fn constant(law: u32) -> Made {
    Made::new([GLASS; 2], F_K, &options(law)).unwrap()
}

fn gripping(law: u32) -> Made {
    Made::new([GLASS; 2], F_K, &CaromLawOptions { static_friction: F_S, ..options(law) }).unwrap()
}

fn by_speed(law: u32) -> Made {
    let [a, slip_friction_b, slip_friction_c] = BY_SPEED;
    let its = CaromLawOptions { slip_friction_b, slip_friction_c, ..options(law) };
    Made::new([GLASS; 2], a, &its).unwrap()
}

fn coefficient(speed: f64) -> f64 {
    let [a, b, c] = BY_SPEED;
    a + b * (-c * speed).exp()
}

/// Two equal grains, the upper one this deep in the lower one and moving along x.
fn bodies(deep: f64, x: f64, velocity: Vector) -> [CaromGrain; 2] {
    let one = grain([x, 0.0, 2.0 * RADIUS - deep], velocity, [0.0; 3], RADIUS);
    [one, CaromGrain { place: [0.0; 3], velocity: [0.0; 3], ..one }]
}

fn step(law: &Made, touch: &mut Touch, [one, two]: [CaromGrain; 2], dt: f64) -> [f64; 2] {
    let CaromGrainLoad { force, .. } = touch.step(law, &one, &Second::Grain(two), dt);
    [force[0].hypot(force[1]), force[2]]
}

/// Pressed, then pulled along x in short steps: the largest share of friction in the normal force, and that at the end.
fn pulled(law: &Made, speed: f64) -> [f64; 2] {
    let mut touch = law.touch();
    step(law, &mut touch, bodies(DEEP, 0.0, [0.0, 0.0, -DEEP / DT]), DT);
    let (mut most, mut last) = (0.0_f64, 0.0);
    for i in 1..=400 {
        let at = bodies(DEEP, f64::from(i) * 4e-10, [speed, 0.0, 0.0]);
        let [friction, normal] = step(law, &mut touch, at, 4e-10 / speed);
        last = friction / normal;
        most = most.max(last);
    }
    [most, last]
}

#[test]
fn a_grain_holds_by_static_friction_and_slides_by_kinetic_friction() {
    for law in SHIFTS {
        let [most, last] = pulled(&gripping(law), 1.0);
        println!("law {law}: at most {most}, at last {last}");
        assert!(most < F_S * (1.0 + 1e-9) && most > 0.98 * F_S, "{law}: {most}");
        assert!((last / F_K - 1.0).abs() < 1e-3, "{law}: {last}");
        // With one coefficient it is that of before.
        let [most, last] = pulled(&constant(law), 1.0);
        assert!((most / F_K - 1.0).abs() < 1e-3 && (last / F_K - 1.0).abs() < 1e-3);
    }
}

#[test]
fn the_friction_of_a_contact_is_that_of_its_first_slip_speed() {
    for its in SHIFTS {
        let law = by_speed(its);
        for speed in [0.0, 0.3, 2.0] {
            let mut touch = law.touch();
            step(&law, &mut touch, bodies(DEEP, 0.0, [speed, 0.0, -DEEP / DT]), DT);
            let want = coefficient(speed);
            assert!((touch.friction(&law) / want - 1.0).abs() < 1e-12, "{speed}");
            // It is kept at any other speed.
            let away = bodies(DEEP, 1e-6, [5.0, 0.0, 0.0]);
            let [friction, normal] = step(&law, &mut touch, away, 2e-7);
            assert!((friction / normal / want - 1.0).abs() < 1e-2, "{speed} {}", friction / normal);
            let kept = touch.friction(&law);
            // Parted and touching again, it has that of the new first touch; alone and with others.
            step(&law, &mut touch, bodies(-DEEP, 1e-6, [0.0, 0.0, 2.0 * DEEP / DT]), DT);
            let again = bodies(DEEP, 0.0, [1.0, 0.0, -2.0 * DEEP / DT]);
            let mut touches = vec![touch.clone(); 4];
            step(&law, &mut touch, again, DT);
            together(&[&law], &mut touches, &[again; 4], DT, None).0.unwrap();
            for touch in touches.iter().chain([&touch]) {
                assert!((touch.friction(&law) / coefficient(1.0) - 1.0).abs() < 1e-12);
            }
            assert!(speed == 1.0 || kept != touch.friction(&law));
        }
        assert_eq!(law.touch().friction(&law), 0.0);
    }
}

#[test]
fn packed_contacts_go_on_with_their_friction_to_the_bit() {
    for law in SHIFTS.map(by_speed).iter().chain(&SHIFTS.map(gripping)) {
        let mut touch = law.touch();
        step(law, &mut touch, bodies(DEEP, 0.0, [0.37, 0.0, -DEEP / DT]), DT);
        for i in (1..200).map(f64::from) {
            // Sums are formed anew where numbers are read; from then on all copies go on to the bit.
            let other = touch.copied(law, [RADIUS; 2]);
            let mut third = other.copied(law, [RADIUS; 2]);
            assert_eq!(touch.friction(law).to_bits(), third.friction(law).to_bits());
            let next = bodies(DEEP * (1.0 + 0.3 * (0.1 * i).sin()), 2e-10 * i, [2e-3, 1e-3, 0.0]);
            let before = step(law, &mut touch, next, DT);
            touch = other;
            let [one, two] = [&mut touch, &mut third].map(|touch| step(law, touch, next, DT));
            assert_eq!(one.map(f64::to_bits), two.map(f64::to_bits), "{i}");
            assert!((before[0] - one[0]).abs() < 1e-12 * one[1] && before[1] == one[1]);
        }
    }
    let law = by_speed(CAROM_LAW_COULOMB);
    let mut touch = law.touch();
    step(&law, &mut touch, bodies(DEEP, 0.0, [0.37, 0.0, -DEEP / DT]), DT);
    let mut numbers = touch.packed(&law);
    *numbers.last_mut().unwrap() = f64::INFINITY;
    let told = Touch::unpacked(&law, [RADIUS; 2], &numbers).unwrap_err();
    assert_eq!((told.status, told.field.as_str()), (CaromStatus::BadState, "friction"));
    assert!(told.text.contains("finite"), "{}", told.text);
}

/// What coupling changes at most is asked at every speed: also where friction grows with it, or falls towards nothing.
#[test]
fn the_bound_of_coupling_holds_at_every_slip_speed() {
    let rubber = CaromMaterial { young_modulus: 1e7, poisson: 0.45, yield_stress: 0.0 };
    let pair = {
        // SAFETY: all zero is a pair that nothing accepts; all pointers are references.
        let made = told(unsafe { zeroed::<CaromPair>() }, |pair, error| unsafe {
            carom_pair_of_spheres(&GLASS, &rubber, 1.0, 1.0, F_K, 0, 0.0, pair, error)
        });
        made.unwrap()
    };
    let bound = |f: f64| {
        let ratio = pair.gamma / f;
        ratio * ratio / (4.0 + ratio * ratio) + pair.gamma * pair.gamma
    };
    assert!((pair.coupling_bound / bound(F_K) - 1.0).abs() < 1e-9);
    for [a, b] in [[0.1, 0.4], [0.4, -0.3], [0.0, 0.4], [0.3, -0.3]] {
        let its = CaromLawOptions { slip_friction_b: b, slip_friction_c: 1.0, ..options(0) };
        let law = Made::new([GLASS, rubber], a, &its).unwrap();
        let speeds =
            (0..400).map(|i| if i == 0 { 0.0 } else { 10_f64.powf(0.03 * f64::from(i) - 10.0) });
        let largest = speeds.map(|speed| a + b * f64::exp(-speed)).filter(|f| *f > 0.0).map(bound);
        let largest = largest.fold(0.0, f64::max);
        let told = law.validity([1.0; 2], 0.0).unwrap().coupling;
        assert!(largest > 0.0 && (told / largest - 1.0).abs() < 1e-9, "{a} {b}: {told} {largest}");
    }
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let usual = options(CAROM_LAW_FIXED_DIRECTION);
    let rings = options(CAROM_LAW_RINGS);
    let grips = |static_friction, its| CaromLawOptions { static_friction, ..its };
    let slips = |b, c, its| CaromLawOptions { slip_friction_b: b, slip_friction_c: c, ..its };
    let torsion = CaromLawOptions { torsion: 1, ..usual };
    for (friction, its, field, part) in [
        (F_K, grips(0.2, usual), "static_friction", "at least"),
        (F_K, grips(-1.0, usual), "static_friction", ""),
        (F_K, grips(f64::NAN, usual), "static_friction", ""),
        (F_K, grips(f64::INFINITY, usual), "static_friction", "finite"),
        (F_K, grips(F_S, rings), "static_friction", "rings"),
        (F_K, grips(F_S, torsion), "static_friction", "torsion"),
        (-0.1, slips(0.3, 1.0, usual), "friction", ""),
        (0.1, slips(-0.2, 1.0, usual), "slip_friction_b", "a + b >= 0"),
        (0.1, slips(f64::NAN, 1.0, usual), "slip_friction_b", ""),
        (0.1, slips(0.2, -1.0, usual), "slip_friction_c", ""),
        (0.1, slips(0.2, 1.0, rings), "slip_friction_b", "rings"),
        (0.1, slips(0.2, 1.0, torsion), "slip_friction_b", "torsion"),
        (0.1, slips(0.2, 1.0, grips(0.9, usual)), "static_friction", "slip_friction_b"),
    ] {
        let told = Made::new([GLASS; 2], friction, &its).err().unwrap();
        assert_eq!((told.status, told.field.as_str()), (CaromStatus::OutOfRange, field));
        assert!(told.text.contains(part), "{}", told.text);
    }
    // Equal coefficients are one.
    for its in [rings, torsion] {
        assert!(Made::new([GLASS; 2], F_K, &grips(F_K, its)).is_ok());
    }
}
