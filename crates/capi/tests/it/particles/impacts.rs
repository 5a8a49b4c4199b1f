//! Impacts of spheres, stepped like a particle code: compared with the exact one and with those of the library, their
//! energy, and contacts that go through numbers in the middle.

use std::ptr::null;

use super::*;

const RADII: [f64; 2] = [0.5, 0.35];
const SPEED: f64 = 1e-3;
const NORMAL: Vector = [0.36, 0.48, 0.8];
const ALONG: Vector = [0.8, -0.6, 0.0];

fn mass(radius: f64) -> f64 {
    2500.0 * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3)
}

fn relative() -> f64 {
    1.0 / RADII.map(|radius| 1.0 / radius).iter().sum::<f64>()
}

/// Two solid spheres of a density of 2500 kg/m^3 on their way through an impact, by leapfrog.
#[derive(Clone)]
struct Impact<'a> {
    law: &'a Made,
    friction: f64,
    touch: Touch,
    bodies: [CaromGrain; 2],
    load: CaromGrainLoad,
    heats: CaromHeats,
    dt: f64,
    steps: usize,
}

impl<'a> Impact<'a> {
    /// With so many steps in the contact, they touch after a part of a step. `lambda`: the tangential velocity over f
    /// times the normal one; `spin`: that about the normal, times the greatest contact radius, over the same.
    fn new(
        law: &'a Made,
        friction: f64,
        [lambda, spin]: [f64; 2],
        (steps, part): (usize, f64),
    ) -> Self {
        // Of Hertz's impact: 2.943275 zeta_max/v.
        let time = law.impact_time(RADII, RADII.map(mass), SPEED).unwrap();
        let deepest = time * SPEED / 2.943_275_184;
        let dt = 2.943_275 * deepest / SPEED / steps as f64;
        let gap = part * dt * SPEED;
        let slip = friction * SPEED;
        let about = spin * slip / (relative() * deepest).sqrt();
        let body = |sign: f64, radius: f64| {
            let place = NORMAL.map(|n| sign * n * (radius + 0.5 * gap));
            let down = NORMAL.map(|n| -0.5 * sign * SPEED * n);
            let velocity = plus(down, ALONG, 0.5 * sign * lambda * slip);
            grain(place, velocity, NORMAL.map(|n| 0.5 * sign * about * n), radius)
        };
        let bodies = [body(1.0, RADII[0]), body(-1.0, RADII[1])];
        let (load, heats) = (CaromGrainLoad::default(), CaromHeats::default());
        Self { law, friction, touch: law.touch(), bodies, load, heats, dt, steps }
    }

    fn kick(&mut self) {
        let torques = [self.load.torque_1, self.load.torque_2];
        for ((body, sign), torque) in self.bodies.iter_mut().zip([1.0, -1.0]).zip(torques) {
            let mass = mass(body.radius);
            let inertia = 0.4 * mass * body.radius * body.radius;
            body.velocity = plus(body.velocity, self.load.force, sign * 0.5 * self.dt / mass);
            body.spin = plus(body.spin, torque, 0.5 * self.dt / inertia);
        }
    }

    fn step(&mut self, is_accounted: bool) {
        self.kick();
        for body in &mut self.bodies {
            body.place = plus(body.place, body.velocity, self.dt);
        }
        let [one, two] = self.bodies;
        let heats = is_accounted.then_some(&mut self.heats);
        let bodies = (&one, &Second::Grain(two));
        self.load = self.touch.tried(self.law, bodies, self.dt, heats).unwrap();
        self.kick();
    }

    fn run(mut self) -> Self {
        (0..self.steps + self.steps / 10).for_each(|_| self.step(false));
        self
    }

    /// The velocity of body 1 against body 2 where they touch, along, across and normal, and the spin about the normal.
    fn velocity(&self) -> [f64; 4] {
        let [one, two] = &self.bodies;
        let apart = plus(one.place, two.place, -1.0);
        let normal = apart.map(|x| x / dot(apart, apart).sqrt());
        let rolling = plus(one.spin.map(|w| w * RADII[0]), two.spin, RADII[1]);
        let slip = plus(plus(one.velocity, two.velocity, -1.0), cross(rolling, normal), -1.0);
        let about = dot(plus(one.spin, two.spin, -1.0), NORMAL);
        [dot(slip, ALONG), dot(slip, cross(NORMAL, ALONG)), dot(slip, NORMAL), about]
    }

    fn energy(&self) -> f64 {
        let kinetic = |body: &CaromGrain| {
            let (mass, square) = (mass(body.radius), body.radius * body.radius);
            0.5 * mass
                * (dot(body.velocity, body.velocity) + 0.4 * square * dot(body.spin, body.spin))
        };
        let CaromHeats { friction, damping, rolling } = self.heats;
        self.bodies.iter().map(kinetic).sum::<f64>()
            + self.touch.energy(self.law, RADII)
            + (friction + damping + rolling)
    }

    /// The same by the library's impact.
    fn by_collision(&self, pair: [CaromMaterial; 2]) -> [f64; 4] {
        let body = |i: usize| {
            let CaromGrain { place, velocity, spin, radius, .. } = self.bodies[i];
            // SAFETY: zeros are what is usual.
            let usual: CaromBody = unsafe { zeroed() };
            let (sizes, mass, material) = ([radius, 0.0, 0.0], mass(radius), pair[i]);
            CaromBody { sizes, mass, material, centre: place, velocity, spin, ..usual }
        };
        let bodies = [&body(0), &body(1)];
        let rebound = collided(bodies, self.friction, Some(&NORMAL), None).unwrap();
        let [one, two] = self.bodies;
        let one =
            CaromGrain { velocity: rebound.body_1_velocity, spin: rebound.body_1_spin, ..one };
        let two =
            CaromGrain { velocity: rebound.body_2_velocity, spin: rebound.body_2_spin, ..two };
        Impact { bodies: [one, two], ..self.clone() }.velocity()
    }
}

/// How far R_x is off at so many steps in the contact, at the worst.
fn worst(law: u32, tolerance: f64, steps: usize, parts: &[f64]) -> f64 {
    let mut worst = 0.0_f64;
    for poisson in [0.0, 0.3, 0.5] {
        let material = CaromMaterial { poisson, ..GLASS };
        let its = CaromLawOptions { tolerance, ..options(law) };
        let made = Made::new([material; 2], 0.1, &its).unwrap();
        let kappa = (2.0 - poisson) / (2.0 * (1.0 - poisson));
        for lambda in [0.1, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0] {
            // SAFETY: all pointers are references.
            let exact = told(0.0, |to, error| unsafe {
                carom_restitution(kappa, lambda, 1.0, CAROM_EXACT, to, error)
            });
            for part in parts {
                let impact = Impact::new(&made, 0.1, [lambda, 0.0], (steps, *part));
                let (before, after) = (impact.velocity(), impact.run().velocity());
                worst = worst.max((-after[0] / before[0] - *exact.as_ref().unwrap()).abs());
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

const ALUMINA: CaromMaterial =
    CaromMaterial { young_modulus: 380e9, poisson: 0.23, yield_stress: 0.0 };
const SILICA: CaromMaterial =
    CaromMaterial { young_modulus: 72e9, poisson: 0.17, yield_stress: 0.0 };
const ALUMINIUM: CaromMaterial =
    CaromMaterial { young_modulus: 70e9, poisson: 0.33, yield_stress: 0.0 };
const PAIRS: [([CaromMaterial; 2], f64); 6] = [
    ([ALUMINA, GLASS], 0.092),
    ([GLASS, ALUMINA], 0.092),
    ([STEEL, GLASS], 0.15),
    ([SILICA, STEEL], 0.08),
    ([STEEL, ALUMINIUM], 0.3),
    ([GLASS, GLASS], 0.2),
];

fn rings(pair: [CaromMaterial; 2], friction: f64, relaxation: f64) -> Made {
    Made::new(pair, friction, &CaromLawOptions { relaxation, ..options(CAROM_LAW_RINGS) }).unwrap()
}

/// In 100 steps. At lambda = 0.1 what is off is divided by a tenth of f v_z.
#[test]
fn stepped_impacts_of_unlike_grains_meet_those_of_the_library() {
    let mut worst = [0.0_f64; 2];
    for (pair, friction) in PAIRS {
        let made = rings(pair, friction, 0.0);
        for lambda in [0.1, 0.5, 1.0, 2.0, 3.0, 5.0] {
            let impact = Impact::new(&made, friction, [lambda, 0.0], (100, 0.05));
            let (before, expected) = (impact.velocity(), impact.by_collision(pair));
            let off = (impact.run().velocity()[0] - expected[0]).abs() / before[0];
            worst[usize::from(lambda > 0.2)] = worst[usize::from(lambda > 0.2)].max(off);
        }
    }
    println!("R_x off by {:.4}, at lambda = 0.1 by {:.4}", worst[1], worst[0]);
    assert!(worst[1] < 0.01 && worst[0] < 0.08);
}

/// The spin about the normal and what coupling makes of it across the path: its sign tells which grain is which.
#[test]
fn spin_and_coupling_act_together() {
    let mut worst = [0.0_f64; 3];
    for (pair, friction) in PAIRS.into_iter().take(5) {
        let made = rings(pair, friction, 0.0);
        for start in [[0.5, 2.0], [1.5, 2.0], [3.0, 6.0], [1.5, -2.0]] {
            let impact = Impact::new(&made, friction, start, (100, 0.05));
            let (before, expected) = (impact.velocity(), impact.by_collision(pair));
            let after = impact.run().velocity();
            let off: [f64; 2] = [0, 1].map(|k| (after[k] - expected[k]) / (friction * SPEED));
            let braked = (before[3] - after[3]) / (before[3] - expected[3]) - 1.0;
            // With the materials exchanged the part across has the other sign.
            assert!(start[1].abs() > 2.0 || off[1].abs() < 0.015);
            for (worst, off) in worst.iter_mut().zip([off[0], off[1], braked]) {
                *worst = worst.max(off.abs());
            }
        }
    }
    println!("along {:.4}, across {:.4}, spin {:.4}", worst[0], worst[1], worst[2]);
    assert!(worst[0] < 0.025 && worst[1] < 0.03 && worst[2] < 0.01);
}

/// How much of the energy the books miss at the worst, over `per` of the heats and the energy before.
fn missed(
    law: &Made,
    friction: f64,
    start: [f64; 2],
    steps: usize,
    per: fn(&CaromHeats, f64) -> f64,
) -> f64 {
    let mut impact = Impact::new(law, friction, start, (steps, 0.05));
    let before = impact.energy();
    let mut worst = 0.0_f64;
    for _ in 0..steps + steps / 2 {
        impact.step(true);
        worst = worst.max((impact.energy() - before).abs());
    }
    assert!(impact.heats.friction > 0.0 && impact.heats.damping > 0.0, "{:?}", impact.heats);
    worst / per(&impact.heats, before)
}

/// Energy goes into heat as it is booked: what the balance misses falls with the step.
#[test]
fn energy_of_a_damped_impact_is_accounted_for() {
    for law in SHIFTS {
        let pair = [0.2, 0.35].map(|poisson| CaromMaterial { poisson, ..GLASS });
        let its = CaromLawOptions { relaxation: 2e-5, ..options(law) };
        let made = Made::new(pair, 0.3, &its).unwrap();
        let missed = |steps| {
            missed(&made, 0.3, [2.0, 0.0], steps, |heats, before| {
                assert!(heats.friction > 0.01 * before && heats.damping > 0.01 * before);
                before
            })
        };
        assert!(missed(100) < 5e-3 && missed(2000) < 2e-5);
    }
    for (pair, friction) in PAIRS {
        let made = rings(pair, friction, 2e-5);
        for (steps, bound) in [(100, 2e-2), (800, 3e-3)] {
            let part = missed(&made, friction, [2.0, 2.0], steps, |heats, _| heats.friction);
            assert!(part < bound, "{pair:?} {steps}: {part}");
        }
    }
}

/// With torsion and rolling too: three memories, one balance.
#[test]
fn energy_with_torsion_and_rolling_is_accounted_for() {
    for law in SHIFTS {
        let rolling = CaromRolling { stiffness: 1e7, damping: 1e3, friction: 0.05 };
        let its = CaromLawOptions { relaxation: 2e-5, torsion: 1, rolling, ..options(law) };
        let made = Made::new([GLASS; 2], 0.3, &its).unwrap();
        let missed = [100, 800].map(|steps| {
            missed(&made, 0.3, [2.0, 2.0], steps, |heats, before| {
                assert!(heats.rolling > 0.0);
                before
            })
        });
        println!("law {law}: {missed:?}");
        assert!(missed[0] < 5e-3 && missed[1] < 2e-4, "{missed:?}");
    }
}

/// All options whose contacts have other numbers, with their number.
fn kinds() -> Vec<(CaromLawOptions, usize)> {
    let (rolling, relaxation) = (ROLLING, 1e-5);
    let mut all = Vec::new();
    for law in LAWS {
        let numbers = if law == CAROM_LAW_RINGS { 319 } else { 82 };
        let usual = CaromLawOptions { relaxation, ..options(law) };
        all.push((usual, numbers));
        all.push((CaromLawOptions { rolling, ..usual }, numbers + 9));
        if law == CAROM_LAW_RINGS {
            // It counts the twist itself.
            all.push((CaromLawOptions { torsion: 1, ..usual }, numbers));
            continue;
        }
        all.push((CaromLawOptions { torsion: 1, ..usual }, numbers + 83));
        all.push((CaromLawOptions { torsion: 1, rolling, ..usual }, numbers + 92));
        all.push((CaromLawOptions { static_friction: 0.5, ..usual }, numbers));
        let slips = CaromLawOptions { slip_friction_b: 0.2, slip_friction_c: 1e3, ..usual };
        all.push((slips, numbers + 1));
        all.push((CaromLawOptions { rolling, ..slips }, numbers + 10));
    }
    all
}

/// In numbers and back in the middle of the way: the load is the same to the bit, and so is what follows.
#[test]
fn kept_in_numbers_and_taken_up_again() {
    for (its, count) in kinds() {
        let made = Made::new([STEEL, GLASS], 0.4, &its).unwrap();
        for at in [0, 1, 13, 40, 75, 101, 110] {
            let mut impact = Impact::new(&made, 0.4, [1.7, 1.0], (100, 0.05));
            (0..at).for_each(|_| impact.step(false));
            let numbers = impact.touch.packed(&made);
            let again = impact.touch.copied(&made, RADII);
            assert_eq!((numbers.len(), numbers[0] > 0.0), (count, at > 0), "{its:?}");
            assert_eq!(again.packed(&made), numbers);
            if at > 0 {
                let [one, two] = impact.bodies;
                let load = again.load(&made, &one, &Second::Grain(two)).unwrap();
                assert_eq!(load, impact.load, "{its:?} {at}");
            }
            let mut copy = Impact { touch: again, ..impact.clone() };
            let mut twin = copy.clone();
            for _ in 0..60 {
                copy.step(false);
                twin.step(true);
                impact.step(false);
                assert_eq!(copy.bodies, twin.bodies);
                for (copy, body) in copy.bodies.iter().zip(&impact.bodies) {
                    // Sums of a law of shifts are formed anew where numbers are read.
                    let off = plus(copy.place, body.place, -1.0);
                    assert!(dot(off, off).sqrt() < 1e-14, "{off:?}");
                    assert!(its.law != CAROM_LAW_RINGS || copy == body);
                }
            }
        }
    }
}

/// The size of a memory is that of what the law counts.
#[test]
fn a_touch_has_the_size_that_its_law_needs() {
    let size = |its| Made::new([GLASS; 2], 0.3, &its).unwrap().touch().words.len() * 8;
    for (law, least) in LAWS.into_iter().zip([1272, 1272, 3296]) {
        assert_eq!(size(options(law)), least);
        assert_eq!(size(CaromLawOptions { rolling: ROLLING, ..options(law) }), least + 72);
        let twist = if law == CAROM_LAW_RINGS { 0 } else { 752 };
        assert_eq!(size(CaromLawOptions { torsion: 1, ..options(law) }), least + twist);
    }
    // SAFETY: null is told.
    assert_eq!(unsafe { [carom_touch_size(null()), carom_touch_pack_size(null())] }, [0, 0]);
}
