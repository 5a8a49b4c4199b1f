//! Grains through the C interface: an impact of spheres stepped like a particle code, compared with the exact
//! one, also with the contact packed and unpacked in the middle.

use std::mem::{MaybeUninit, zeroed};
use std::ptr::{null, null_mut};

use carom_capi::*;

pub(super) type Vector = [f64; 3];

pub(super) fn text(error: &CaromError) -> String {
    error.text.iter().take_while(|byte| **byte != 0).map(|byte| char::from(*byte as u8)).collect()
}

fn field(error: &CaromError) -> String {
    error.field.iter().take_while(|byte| **byte != 0).map(|byte| char::from(*byte as u8)).collect()
}

pub(super) fn error() -> CaromError {
    // SAFETY: plain numbers.
    unsafe { zeroed() }
}

pub(super) fn apart() -> CaromTouch {
    CaromTouch { mark: 0, words: [MaybeUninit::new(0); CAROM_TOUCH_WORDS] }
}

pub(super) fn made(
    poisson: [f64; 2],
    friction: f64,
    law: u32,
    relaxation: f64,
) -> Result<CaromGrains, String> {
    let bodies =
        poisson.map(|poisson| CaromMaterial { young_modulus: 70e9, poisson, yield_stress: 0.0 });
    // SAFETY: plain numbers; all pointers are references.
    unsafe {
        let (mut grains, mut error) = (zeroed(), error());
        let [one, two] = &bodies;
        let to = &raw mut grains;
        let status = carom_grains_of(one, two, friction, law, 0.0, relaxation, to, &raw mut error);
        if status == CaromStatus::Ok { Ok(grains) } else { Err(text(&error)) }
    }
}

pub(super) fn step(
    grains: &CaromGrains,
    touch: &mut CaromTouch,
    [one, two]: &[CaromGrain; 2],
    dt: f64,
    heats: Option<&mut CaromHeats>,
) -> CaromGrainLoad {
    let (mut load, mut error) = (CaromGrainLoad::default(), error());
    let heats = heats.map_or(null_mut(), |heats| &raw mut *heats);
    // SAFETY: all pointers are references or null.
    let status = unsafe {
        carom_touch_grains(grains, touch, one, two, dt, &raw mut load, heats, &raw mut error)
    };
    assert_eq!(status, CaromStatus::Ok, "{}", text(&error));
    load
}

pub(super) fn plus(a: Vector, b: Vector, by: f64) -> Vector {
    [a[0] + by * b[0], a[1] + by * b[1], a[2] + by * b[2]]
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Two solid spheres of a density of 2500 kg/m^3 on their way through an impact, by leapfrog.
#[derive(Clone, Copy)]
struct Impact {
    grains: CaromGrains,
    touch: CaromTouch,
    bodies: [CaromGrain; 2],
    load: CaromGrainLoad,
    heats: CaromHeats,
    dt: f64,
    steps: usize,
}

const SPEED: f64 = 1e-3;
pub(super) const RADII: [f64; 2] = [0.5, 0.35];

impl Impact {
    /// At rest against each other but for the normal velocity and lambda f times it along an axis of no
    /// coordinate system, a part of a step before they touch, with so many steps in the contact.
    fn new(grains: CaromGrains, lambda: f64, steps: usize) -> Self {
        Self::touching_after(0.05, grains, lambda, steps)
    }

    fn touching_after(part: f64, grains: CaromGrains, lambda: f64, steps: usize) -> Self {
        // The duration of Hertz's impact: 2.9432 zeta_max/v, zeta_max = (5 m v^2/(4 k))^(2/5), F = k zeta^1.5.
        let radius = 1.0 / RADII.map(|radius| 1.0 / radius).iter().sum::<f64>();
        let mass = 1.0 / RADII.map(|radius| 1.0 / mass(radius)).iter().sum::<f64>();
        let stiffness = 2.0 / 3.0 * grains.unit.c_z * radius.sqrt();
        let deepest = (1.25 * mass * SPEED * SPEED / stiffness).powf(0.4);
        let dt = 2.943_275 * deepest / SPEED / steps as f64;
        let normal = [0.36, 0.48, 0.8];
        let along = [0.8, -0.6, 0.0];
        let gap = part * dt * SPEED;
        let body = |sign: f64, radius: f64| CaromGrain {
            place: normal.map(|n| sign * n * (radius + 0.5 * gap)),
            velocity: plus(
                normal.map(|n| -0.5 * sign * SPEED * n),
                along,
                0.5 * sign * lambda * grains.unit.friction * SPEED,
            ),
            spin: [0.0; 3],
            radius,
            mass: 1.0,
        };
        let bodies = [body(1.0, RADII[0]), body(-1.0, RADII[1])];
        let (touch, load, heats) = (apart(), CaromGrainLoad::default(), CaromHeats::default());
        Self { grains, touch, bodies, load, heats, dt, steps }
    }

    fn kick(&mut self) {
        let [one, two] = &mut self.bodies;
        for (body, sign, torque) in
            [(one, 1.0, self.load.torque_1), (two, -1.0, self.load.torque_2)]
        {
            let mass = mass(body.radius);
            let inertia = 0.4 * mass * body.radius * body.radius;
            body.velocity = plus(body.velocity, self.load.force, sign * 0.5 * self.dt / mass);
            body.spin = plus(body.spin, torque, 0.5 * self.dt / inertia);
        }
    }

    fn step(&mut self, accounted: bool) {
        self.kick();
        for body in &mut self.bodies {
            body.place = plus(body.place, body.velocity, self.dt);
        }
        let mut heats = self.heats;
        let place = accounted.then_some(&mut heats);
        self.load = step(&self.grains, &mut self.touch, &self.bodies, self.dt, place);
        self.heats = heats;
        self.kick();
    }

    fn run(mut self) -> Self {
        for _ in 0..self.steps + self.steps / 10 {
            self.step(false);
        }
        self
    }

    /// The velocity of body 1 against body 2 where they touch.
    fn velocity(&self) -> Vector {
        let [one, two] = &self.bodies;
        let apart = plus(one.place, two.place, -1.0);
        let normal = apart.map(|x| x / dot(apart, apart).sqrt());
        let rolling = plus(one.spin.map(|w| w * RADII[0]), two.spin, RADII[1]);
        plus(plus(one.velocity, two.velocity, -1.0), cross(rolling, normal), -1.0)
    }

    fn energy(&self) -> f64 {
        let kinetic = |body: &CaromGrain| {
            let (mass, square) = (mass(body.radius), body.radius * body.radius);
            0.5 * mass
                * (dot(body.velocity, body.velocity) + 0.4 * square * dot(body.spin, body.spin))
        };
        let mut stored = 0.0;
        // SAFETY: all pointers are references or null.
        let status = unsafe { carom_touch_energy(&self.touch, &raw mut stored, null_mut()) };
        assert_eq!(status, CaromStatus::Ok);
        self.bodies.iter().map(kinetic).sum::<f64>()
            + stored
            + self.heats.friction
            + self.heats.damping
    }
}

fn mass(radius: f64) -> f64 {
    2500.0 * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3)
}

/// How far R_x is off at so many steps in the contact, at the worst.
fn worst(law: u32, tolerance: f64, steps: usize, parts: &[f64]) -> f64 {
    let mut worst = 0.0_f64;
    for poisson in [0.0, 0.3, 0.5] {
        let mut grains = made([poisson; 2], 0.1, law, 0.0).unwrap();
        if tolerance > 0.0 {
            grains.unit.tolerance = tolerance;
        }
        let kappa = (2.0 - poisson) / (2.0 * (1.0 - poisson));
        for lambda in [0.1, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0] {
            let mut exact = 0.0;
            // SAFETY: all pointers are references or null.
            let status = unsafe {
                carom_restitution(kappa, lambda, CAROM_EXACT, &raw mut exact, null_mut())
            };
            assert_eq!(status, CaromStatus::Ok);
            for part in parts {
                let impact = Impact::touching_after(*part, grains, lambda, steps);
                let (before, after) = (impact.velocity(), impact.run().velocity());
                let along = [0.8, -0.6, 0.0];
                let measured = -dot(after, along) / dot(before, along);
                worst = worst.max((measured - exact).abs());
            }
        }
    }
    println!("law {law}, {steps} steps in the contact: R_x off by {worst:.1e}");
    worst
}

/// Wherever in a step the two touch.
#[test]
fn stepped_impact_meets_the_exact_one() {
    for (law, tolerance) in [(CAROM_LAW_FIXED_DIRECTION, 0.0), (CAROM_LAW_COULOMB, 3e-3)] {
        let parts = [0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95];
        assert!(worst(law, tolerance, 50, &parts) < 1.2e-3);
        assert!(worst(law, tolerance, 100, &parts) < 4e-4);
        assert!(worst(law, tolerance, 500, &[0.2, 0.5, 0.7]) < 1e-4);
        assert!(worst(law, tolerance, 2000, &[0.2, 0.5, 0.7]) < 1e-4);
    }
}

/// Energy goes into heat as it is booked: what the balance misses falls with the square of the step.
#[test]
fn energy_of_a_damped_impact_is_accounted_for() {
    for law in [CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION] {
        let grains = made([0.2, 0.35], 0.3, law, 2e-5).unwrap();
        let missed = |steps: usize| {
            let mut impact = Impact::new(grains, 2.0, steps);
            let before = impact.energy();
            let mut worst = 0.0_f64;
            for _ in 0..steps + steps / 2 {
                impact.step(true);
                worst = worst.max((impact.energy() / before - 1.0).abs());
            }
            assert!(impact.heats.friction > 0.01 * before && impact.heats.damping > 0.01 * before);
            println!(
                "law {law}, {steps} steps: {worst:.1e}, heats {:?} of {before:e}",
                impact.heats
            );
            worst
        };
        assert!(missed(100) < 5e-3);
        assert!(missed(2000) < 2e-5);
    }
}

/// In numbers and back in the middle of the way: the load is the same to the bit, and so is what follows.
#[test]
fn kept_in_numbers_and_taken_up_again() {
    for law in [CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION] {
        for at in [0, 1, 13, 40, 75, 101, 110] {
            let mut impact = Impact::new(made([0.3; 2], 0.4, law, 1e-5).unwrap(), 1.7, 100);
            for _ in 0..at {
                impact.step(false);
            }
            let again = |touch: &CaromTouch| {
                let mut numbers = [0.0; CAROM_TOUCH_NUMBERS];
                let mut again = apart();
                // SAFETY: all pointers are references or null.
                unsafe {
                    let status = carom_touch_pack(touch, numbers.as_mut_ptr(), null_mut());
                    assert_eq!(status, CaromStatus::Ok);
                    let (grains, from) = (&impact.grains, numbers.as_ptr());
                    let to = &raw mut again;
                    let status =
                        carom_touch_unpack(grains, RADII[0], RADII[1], from, to, null_mut());
                    assert_eq!(status, CaromStatus::Ok);
                }
                (numbers, again)
            };
            let (numbers, touch) = again(&impact.touch);
            assert_eq!(numbers[0] > 0.0, at > 0);
            assert_eq!(again(&touch).0, numbers);
            if at > 0 {
                let mut load = CaromGrainLoad::default();
                let [one, two] = &impact.bodies;
                // SAFETY: all pointers are references or null.
                let status = unsafe {
                    let to = &raw mut load;
                    carom_touch_grains_load(&impact.grains, &touch, one, two, to, null_mut())
                };
                assert_eq!((status, load), (CaromStatus::Ok, impact.load));
            }
            let (mut copy, mut twin) = (Impact { touch, ..impact }, Impact { touch, ..impact });
            for _ in 0..60 {
                copy.step(false);
                twin.step(true);
                impact.step(false);
                assert_eq!(copy.bodies, twin.bodies);
                for (copy, body) in copy.bodies.iter().zip(&impact.bodies) {
                    let off = plus(copy.place, body.place, -1.0);
                    assert!(dot(off, off).sqrt() < 1e-14, "{off:?}");
                }
            }
        }
    }
}

#[test]
fn wall_is_a_sphere_without_end() {
    let grains = made([0.3; 2], 0.4, CAROM_LAW_COULOMB, 1e-5).unwrap();
    let one = |t: f64| CaromGrain {
        place: [1e-4 * t, 0.0, 0.5 - 1e-4 * t],
        velocity: [1e-4, 0.0, -1e-4],
        spin: [0.0, 1e-5, 2e-5],
        radius: 0.5,
        mass: 1.0,
    };
    let place = [3.0, -2.0, 0.0];
    let wall = CaromWall { place, normal: [0.0, 0.0, 1.0], velocity: [0.0, 5e-5, 0.0] };
    let (mut touch, mut other) = (apart(), apart());
    for t in 1..40 {
        let far = 1e7;
        let below = CaromGrain {
            place: [one(f64::from(t)).place[0], 0.0, -far],
            velocity: wall.velocity,
            spin: [0.0; 3],
            radius: far,
            mass: 1.0,
        };
        let (mut load, grain) = (CaromGrainLoad::default(), one(f64::from(t)));
        // SAFETY: all pointers are references or null.
        let status = unsafe {
            carom_touch_wall(
                &grains,
                &mut touch,
                &grain,
                &wall,
                1.0,
                &raw mut load,
                null_mut(),
                null_mut(),
            )
        };
        assert_eq!(status, CaromStatus::Ok);
        let expected = step(&grains, &mut other, &[grain, below], 1.0, None);
        for k in 0..3 {
            assert!(
                (load.force[k] / expected.force[2] - expected.force[k] / expected.force[2]).abs()
                    < 1e-3
            );
        }
        assert!(load.force[0] < 0.0 && load.force[1] > 0.0 && load.torque_2 == [0.0; 3]);
    }
}

#[test]
fn what_is_out_of_range_is_named() {
    let says = |result: Result<CaromGrains, String>, words: &str| {
        let text = result.unwrap_err();
        assert!(text.contains(words), "{text}");
    };
    says(made([0.7, 0.3], 0.1, 0, 0.0), "poisson = 0.7");
    says(made([0.3; 2], -0.1, 0, 0.0), "friction = -0.1");
    says(made([0.3; 2], f64::INFINITY, 0, 0.0), "friction = inf");
    says(made([0.3; 2], 0.1, 3, 0.0), "law = 3");
    says(made([0.3; 2], 0.1, 0, -1.0), "relaxation = -1");
    let grains = made([0.3; 2], 0.1, 0, 0.0).unwrap();
    let grain =
        CaromGrain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
    let tried = |grains: *const CaromGrains, touch: &mut CaromTouch, two: CaromGrain, dt: f64| {
        let (mut load, mut error) = (CaromGrainLoad::default(), error());
        // SAFETY: all pointers are references or null.
        let status = unsafe {
            let (to, why) = (&raw mut load, &raw mut error);
            carom_touch_grains(grains, touch, &grain, &two, dt, to, null_mut(), why)
        };
        (status, field(&error), load)
    };
    let near = CaromGrain { place: [0.0, 0.0, 1.9], ..grain };
    let mut touch = apart();
    let none = CaromGrainLoad::default();
    let cases = [
        (null(), near, 1.0, CaromStatus::NullPointer, "grains"),
        (&raw const grains, grain, 1.0, CaromStatus::OutOfRange, "distance"),
        (
            &raw const grains,
            CaromGrain { radius: -1.0, ..near },
            1.0,
            CaromStatus::OutOfRange,
            "radius_2",
        ),
        (&raw const grains, near, f64::NAN, CaromStatus::OutOfRange, "zeta"),
    ];
    for (grains, two, dt, status, name) in cases {
        assert_eq!(tried(grains, &mut touch, two, dt), (status, name.to_owned(), none));
        assert_eq!(touch.mark, 0, "left as it was");
    }
    touch.mark = 5;
    let (status, ..) = tried(&raw const grains, &mut touch, near, 1.0);
    assert_eq!(status, CaromStatus::BadState);
    let mut numbers = [0.0; CAROM_TOUCH_NUMBERS];
    numbers[0] = 7.0;
    // SAFETY: all pointers are references or null.
    let status = unsafe {
        carom_touch_unpack(&grains, 1.0, 1.0, numbers.as_ptr(), &raw mut touch, null_mut())
    };
    assert_eq!(status, CaromStatus::BadState);
}

/// Hertz: T = 2.94 zeta_max/v with zeta_max^5 = (15 m v^2/(16 E* sqrt(R)))^2, of a grain on a wall and of two grains.
#[test]
fn an_impact_lasts_as_hertz_says() {
    let glass = CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 };
    let time = |radii: [f64; 2], masses: [f64; 2], velocity: f64| {
        // SAFETY: plain numbers; all pointers are references.
        unsafe {
            let (mut grains, mut error, mut time) = (zeroed(), zeroed(), 0.0);
            let (law, to) = (CAROM_LAW_COULOMB, &raw mut grains);
            let made = carom_grains_of(&glass, &glass, 0.3, law, 0.0, 0.0, to, &raw mut error);
            assert_eq!(made, CaromStatus::Ok);
            let ([r_1, r_2], [m_1, m_2], to) = (radii, masses, &raw mut time);
            let told =
                carom_grains_impact_time(&grains, r_1, r_2, m_1, m_2, velocity, to, &raw mut error);
            (told, time, field(&error))
        }
    };
    let modulus = 70e9 / (2.0 * (1.0 - 0.22 * 0.22));
    let hertz = |radius: f64, mass: f64, velocity: f64| {
        let deep = 15.0 * mass * velocity * velocity / (16.0 * modulus * radius.sqrt());
        2.943_275_1 * deep.powf(0.4) / velocity
    };
    let inf = f64::INFINITY;
    for (radii, masses, velocity, expected) in [
        ([1e-3, inf], [1e-5, inf], 0.3, hertz(1e-3, 1e-5, 0.3)),
        ([1e-3, 3e-3], [1e-5, 3e-5], 2.0, hertz(0.75e-3, 0.75e-5, 2.0)),
    ] {
        let (status, told, _) = time(radii, masses, velocity);
        assert_eq!(status, CaromStatus::Ok);
        assert!((told / expected - 1.0).abs() < 1e-6, "{told} {expected}");
    }
    for (masses, velocity, at_fault) in [
        ([inf; 2], 1.0, "mass_2"),
        ([0.0, 1e-5], 1.0, "mass_1"),
        ([1e-5, 0.0], 1.0, "mass_2"),
        ([1e-5; 2], 0.0, "velocity"),
    ] {
        let (status, _, told) = time([1e-3; 2], masses, velocity);
        assert_eq!((status, told.as_str()), (CaromStatus::OutOfRange, at_fault));
    }
}
