//! Grains rebound with the restitution that is given.

use super::*;

const RUBBER: CaromMaterial =
    CaromMaterial { young_modulus: 1e7, poisson: 0.45, yield_stress: 0.0 };
const RADII: [f64; 2] = [2e-3, 3e-3];
const MASSES: [f64; 2] = [1e-4, 3e-4];
const SPEED: f64 = 0.05;

fn law(two: CaromMaterial, restitution: f64) -> Result<Made, Told> {
    let its = CaromLawOptions { restitution, ..options(CAROM_LAW_FIXED_DIRECTION) };
    Made::new([GLASS, two], 0.3, &its)
}

/// Two grains about to touch that meet along z.
fn meeting() -> [CaromGrain; 2] {
    let [one, two] = MASSES;
    let part = [two / (one + two), one / (one + two)];
    let grain = |i: usize, z: f64, up: f64| CaromGrain {
        mass: MASSES[i],
        ..grain([0.0, 0.0, z], [1e-3 * up, 0.0, up * SPEED * part[i]], [0.0; 3], RADII[i])
    };
    [grain(0, RADII[0] + RADII[1], -1.0), grain(1, 0.0, 1.0)]
}

/// Leapfrog until they part; the speed at which they do over that at which they met.
fn rebound(mut step: impl FnMut([CaromGrain; 2]) -> CaromGrainLoad, dt: f64) -> f64 {
    let (mut bodies, mut force) = (meeting(), [0.0; 3]);
    for _ in 0..2000 {
        for (body, sign) in bodies.iter_mut().zip([1.0, -1.0]) {
            body.velocity = plus(body.velocity, force, sign * dt / body.mass);
            body.place = plus(body.place, body.velocity, dt);
        }
        let closing = bodies[1].velocity[2] - bodies[0].velocity[2];
        if bodies[0].place[2] - bodies[1].place[2] > RADII[0] + RADII[1] && closing < 0.0 {
            return -closing / SPEED;
        }
        force = step(bodies).force;
    }
    panic!("they stay");
}

#[test]
fn fifty_steps_meet_the_restitution_alone_and_together() {
    for (two, restitution) in [(GLASS, 0.2), (RUBBER, 0.6), (RUBBER, 0.95)] {
        let law = law(two, restitution).unwrap();
        let dt = law.impact_time(RADII, MASSES, SPEED).unwrap() / 50.0;
        let mut touch = law.touch();
        let alone = |[one, two]: [CaromGrain; 2]| touch.step(&law, &one, &Second::Grain(two), dt);
        let got = rebound(alone, dt);
        assert!((got - restitution).abs() < 3e-4, "{restitution}: {got}");
        let mut touches = vec![law.touch(); 4];
        let many = |bodies| together(&[&law], &mut touches, &[bodies; 4], dt, None).1[3];
        assert_eq!(got, rebound(many, dt));
    }
}

#[test]
fn what_cannot_be_met_is_refused() {
    for restitution in [0.001, 1.5, -1.0, f64::NAN] {
        let said = law(GLASS, restitution).err().unwrap().text;
        assert!(said.contains("restitution") && said.contains("from 0.01 to 1"), "{said}");
    }
    // A relaxation time counts the same loss.
    let both = CaromLawOptions { relaxation: 1e-6, restitution: 0.9, ..options(0) };
    let told = Made::new([GLASS; 2], 0.3, &both).err().unwrap();
    assert_eq!((told.status, told.field.as_str()), (CaromStatus::OutOfRange, "relaxation"));
    let elastic = CaromLawOptions { restitution: 1.0, ..both };
    assert!(Made::new([GLASS; 2], 0.3, &elastic).is_ok());
}

/// A mass that a restitution cannot use is refused, in an array as alone, before and after the first touch.
#[test]
fn masses_are_asked_where_a_restitution_needs_them() {
    for rolling in [CaromRolling::default(), ROLLING] {
        let its = CaromLawOptions { restitution: 0.5, rolling, ..options(0) };
        let law = Made::new([GLASS, RUBBER], 0.3, &its).unwrap();
        let [mut one, two] = meeting();
        one.place[2] -= 1e-6;
        let mut pressed = law.touch();
        pressed.step(&law, &one, &Second::Grain(two), 1e-6);
        for (masses, part) in [
            ([0.0, 1.0], "mass = 0"),
            ([-1.0, 1.0], "mass = -1"),
            ([f64::NAN, 1.0], "mass = NaN"),
            ([f64::INFINITY; 2], "finite for one of both"),
        ] {
            let one = CaromGrain { mass: masses[0], ..one };
            let wrong = CaromGrain { mass: masses[1], ..two };
            for touch in [law.touch(), pressed.clone()] {
                let mut same = touch.clone();
                let told = same.tried(&law, (&one, &Second::Grain(wrong)), 1e-9, None).unwrap_err();
                assert!(told.text.contains(part), "{}", told.text);
                assert_eq!(same, touch);
                let told = touch.load(&law, &one, &Second::Grain(wrong)).unwrap_err();
                assert!(told.text.contains(part), "{}", told.text);
            }
            let mut bodies = [meeting(); 8];
            bodies[2] = [one, wrong];
            let told = together(&[&law], &mut vec![pressed.clone(); 8], &bodies, 1e-6, None).0;
            assert_eq!(told.unwrap_err().index, 2);
        }
    }
}
