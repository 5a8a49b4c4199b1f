//! Grains with the law of rings through the C interface: impacts of dissimilar spheres, stepped like a
//! particle code, compared with those of the library.

use std::mem::{MaybeUninit, zeroed};
use std::ptr::null_mut;

use carom_capi::*;

type Vector = [f64; 3];

const STEEL: [f64; 2] = [210e9, 0.3];
const GLASS: [f64; 2] = [70e9, 0.22];
const ALUMINA: [f64; 2] = [380e9, 0.23];
const SILICA: [f64; 2] = [72e9, 0.17];
const ALUMINIUM: [f64; 2] = [70e9, 0.33];
const RADII: [f64; 2] = [0.5, 0.35];
const SPEED: f64 = 1e-3;
const NORMAL: Vector = [0.36, 0.48, 0.8];
const ALONG: Vector = [0.8, -0.6, 0.0];

fn plus(a: Vector, b: Vector, by: f64) -> Vector {
    [0, 1, 2].map(|k| a[k] + by * b[k])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn material([young_modulus, poisson]: [f64; 2]) -> CaromMaterial {
    CaromMaterial { young_modulus, poisson, yield_stress: 0.0 }
}

fn mass(radius: f64) -> f64 {
    2500.0 * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3)
}

/// Constants and matrices, given back at the end.
struct Made {
    grains: CaromGrains,
    rings: *mut CaromRings,
}

impl Made {
    fn new(pair: [[f64; 2]; 2], friction: f64, relaxation: f64) -> Self {
        let [one, two] = pair.map(material);
        // SAFETY: plain numbers; all pointers are references or null.
        unsafe {
            let (mut grains, mut rings): (CaromGrains, _) = (zeroed(), null_mut());
            let law = CAROM_LAW_RINGS;
            let to = &raw mut grains;
            let status =
                carom_grains_of(&one, &two, friction, law, 0.0, relaxation, to, null_mut());
            assert_eq!(status, CaromStatus::Ok);
            let status = carom_rings_of(&raw const grains.unit, &raw mut rings, null_mut());
            assert_eq!(status, CaromStatus::Ok);
            Self { grains, rings }
        }
    }
}

impl Drop for Made {
    fn drop(&mut self) {
        // SAFETY: made by `carom_rings_of`.
        unsafe { carom_rings_free(self.rings) };
    }
}

/// Two solid spheres on their way through an impact, by leapfrog.
struct Impact<'a> {
    made: &'a Made,
    touch: CaromRingTouch,
    bodies: [CaromGrain; 2],
    load: CaromGrainLoad,
    heats: CaromHeats,
    dt: f64,
    steps: usize,
}

fn apart() -> CaromRingTouch {
    CaromRingTouch { mark: 0, words: [MaybeUninit::new(0); CAROM_RING_TOUCH_WORDS] }
}

impl<'a> Impact<'a> {
    /// `lambda`: the tangential velocity over f times the normal one; `spin`: that about the normal, times the
    /// greatest contact radius, over the same.
    fn new(made: &'a Made, [lambda, spin]: [f64; 2], steps: usize) -> Self {
        // The duration of Hertz's impact: 2.9432 zeta_max/v, zeta_max = (5 m v^2/(4 k))^(2/5), F = k zeta^1.5.
        let radius = 1.0 / RADII.map(|radius| 1.0 / radius).iter().sum::<f64>();
        let reduced = 1.0 / RADII.map(|radius| 1.0 / mass(radius)).iter().sum::<f64>();
        let stiffness = 2.0 / 3.0 * made.grains.unit.c_z * radius.sqrt();
        let deepest = (1.25 * reduced * SPEED * SPEED / stiffness).powf(0.4);
        let dt = 2.943_275 * deepest / SPEED / steps as f64;
        let gap = 0.05 * dt * SPEED;
        let slip = made.grains.unit.friction * SPEED;
        let about = spin * slip / (radius * deepest).sqrt();
        let body = |sign: f64, radius: f64| CaromGrain {
            place: NORMAL.map(|n| sign * n * (radius + 0.5 * gap)),
            velocity: plus(
                NORMAL.map(|n| -0.5 * sign * SPEED * n),
                ALONG,
                0.5 * sign * lambda * slip,
            ),
            spin: NORMAL.map(|n| 0.5 * sign * about * n),
            radius,
            mass: 1.0,
        };
        let bodies = [body(1.0, RADII[0]), body(-1.0, RADII[1])];
        let (load, heats) = (CaromGrainLoad::default(), CaromHeats::default());
        Self { made, touch: apart(), bodies, load, heats, dt, steps }
    }

    fn kick(&mut self) {
        let [one, two] = &mut self.bodies;
        let torques = [self.load.torque_1, self.load.torque_2];
        for ((body, sign), torque) in [(one, 1.0), (two, -1.0)].into_iter().zip(torques) {
            let mass = mass(body.radius);
            let inertia = 0.4 * mass * body.radius * body.radius;
            body.velocity = plus(body.velocity, self.load.force, sign * 0.5 * self.dt / mass);
            body.spin = plus(body.spin, torque, 0.5 * self.dt / inertia);
        }
    }

    fn step(&mut self) {
        self.kick();
        for body in &mut self.bodies {
            body.place = plus(body.place, body.velocity, self.dt);
        }
        let ([one, two], made) = (&self.bodies, self.made);
        let (load, heats) = (&raw mut self.load, &raw mut self.heats);
        let (grains, touch) = (&raw const made.grains, &raw mut self.touch);
        // SAFETY: all pointers are references or null.
        let status = unsafe {
            let dt = self.dt;
            carom_ring_touch_grains(
                grains,
                made.rings,
                touch,
                one,
                two,
                dt,
                load,
                heats,
                null_mut(),
            )
        };
        assert_eq!(status, CaromStatus::Ok);
        self.kick();
    }

    fn run(mut self) -> Self {
        for _ in 0..self.steps + self.steps / 10 {
            self.step();
        }
        self
    }

    /// The velocity of body 1 against body 2 where they touch, and the spin about the normal.
    fn velocity(&self) -> [f64; 4] {
        let [one, two] = &self.bodies;
        let rolling = plus(one.spin.map(|w| w * RADII[0]), two.spin, RADII[1]);
        let slip = plus(plus(one.velocity, two.velocity, -1.0), cross(rolling, NORMAL), -1.0);
        let across = cross(NORMAL, ALONG);
        let about = dot(plus(one.spin, two.spin, -1.0), NORMAL);
        [dot(slip, ALONG), dot(slip, across), dot(slip, NORMAL), about]
    }

    fn energy(&self) -> f64 {
        let kinetic = |body: &CaromGrain| {
            let (mass, square) = (mass(body.radius), body.radius * body.radius);
            0.5 * mass
                * (dot(body.velocity, body.velocity) + 0.4 * square * dot(body.spin, body.spin))
        };
        let mut stored = 0.0;
        let (grains, touch) = (&raw const self.made.grains, &raw const self.touch);
        let ([one, two], rings, to) = (RADII, self.made.rings, &raw mut stored);
        // SAFETY: all pointers are references or null.
        let status =
            unsafe { carom_ring_touch_energy(grains, rings, touch, one, two, to, null_mut()) };
        assert_eq!(status, CaromStatus::Ok);
        self.bodies.iter().map(kinetic).sum::<f64>()
            + stored
            + self.heats.friction
            + self.heats.damping
    }

    /// The same by the library's impact.
    fn by_collision(&self, pair: [[f64; 2]; 2]) -> [f64; 4] {
        let body = |i: usize| {
            let CaromGrain { place, velocity, spin, radius, .. } = self.bodies[i];
            let material = material(pair[i]);
            // SAFETY: zeros are what is usual.
            let usual: CaromBody = unsafe { zeroed() };
            let sizes = [radius, 0.0, 0.0];
            CaromBody {
                sizes,
                mass: mass(radius),
                material,
                centre: place,
                velocity,
                spin,
                ..usual
            }
        };
        let mut rebound = CaromRebound::default();
        let friction = self.made.grains.unit.friction;
        // SAFETY: all pointers are references or null.
        let status = unsafe {
            let (normal, to) = (NORMAL.as_ptr(), &raw mut rebound);
            carom_collide(&body(0), &body(1), friction, normal, std::ptr::null(), to, null_mut())
        };
        assert_eq!(status, CaromStatus::Ok);
        let [one, two] = self.bodies;
        let one =
            CaromGrain { velocity: rebound.body_1_velocity, spin: rebound.body_1_spin, ..one };
        let two =
            CaromGrain { velocity: rebound.body_2_velocity, spin: rebound.body_2_spin, ..two };
        Impact { bodies: [one, two], ..*self }.velocity()
    }
}

const PAIRS: [([[f64; 2]; 2], f64); 6] = [
    ([ALUMINA, GLASS], 0.092),
    ([GLASS, ALUMINA], 0.092),
    ([STEEL, GLASS], 0.15),
    ([SILICA, STEEL], 0.08),
    ([STEEL, ALUMINIUM], 0.3),
    ([GLASS, GLASS], 0.2),
];

/// In 100 steps. At lambda = 0.1 what is off is divided by a tenth of f v_z.
#[test]
fn stepped_impacts_of_unlike_grains_meet_those_of_the_library() {
    let mut worst = [0.0_f64; 2];
    for (pair, friction) in PAIRS {
        let made = Made::new(pair, friction, 0.0);
        for lambda in [0.1, 0.5, 1.0, 2.0, 3.0, 5.0] {
            let impact = Impact::new(&made, [lambda, 0.0], 100);
            let (before, expected) = (impact.velocity(), impact.by_collision(pair));
            let after = impact.run().velocity();
            let off = (after[0] - expected[0]).abs() / before[0];
            println!(
                "{pair:?} {lambda}: {:.4}, {:.4}",
                -after[0] / before[0],
                -expected[0] / before[0]
            );
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
    for (pair, friction) in &PAIRS[..5] {
        let made = Made::new(*pair, *friction, 0.0);
        for start in [[0.5, 2.0], [1.5, 2.0], [3.0, 6.0], [1.5, -2.0]] {
            let impact = Impact::new(&made, start, 100);
            let (before, expected) = (impact.velocity(), impact.by_collision(*pair));
            let after = impact.run().velocity();
            let scale = friction * SPEED;
            let off: [f64; 2] = [0, 1].map(|k| (after[k] - expected[k]) / scale);
            let braked = (before[3] - after[3]) / (before[3] - expected[3]) - 1.0;
            println!("{pair:?} {start:?}: {off:?} {:.4} {braked:.4}", expected[1] / scale);
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

#[test]
fn energy_of_an_impact_is_accounted_for() {
    for (pair, friction) in PAIRS {
        let made = Made::new(pair, friction, 2e-5);
        for (steps, bound) in [(100, 2e-2), (800, 3e-3)] {
            let mut impact = Impact::new(&made, [2.0, 2.0], steps);
            let before = impact.energy();
            let mut worst = 0.0_f64;
            for _ in 0..steps + steps / 2 {
                impact.step();
                worst = worst.max((impact.energy() - before).abs());
            }
            let part = worst / impact.heats.friction;
            println!("{pair:?} {steps}: {worst:.2e} {part:.4} of {:?}", impact.heats);
            assert!(impact.heats.friction > 0.0 && impact.heats.damping > 0.0);
            assert!(part < bound);
        }
    }
}

/// In numbers and back in the middle of the way: the load is the same to the bit, and so is what follows.
#[test]
fn kept_in_numbers_and_taken_up_again() {
    for at in [0, 1, 13, 40, 75, 101, 110] {
        let made = Made::new([STEEL, GLASS], 0.15, 1e-5);
        let mut impact = Impact::new(&made, [1.7, 1.0], 100);
        for _ in 0..at {
            impact.step();
        }
        let mut numbers = [0.0; CAROM_RING_TOUCH_NUMBERS];
        let mut again = apart();
        let ([one, two], rings, none) = (&impact.bodies, made.rings, null_mut());
        let mut load = CaromGrainLoad::default();
        // SAFETY: all pointers are references or null.
        unsafe {
            let status = carom_ring_touch_pack(&impact.touch, numbers.as_mut_ptr(), none);
            assert_eq!(status, CaromStatus::Ok);
            let (grains, from, to) = (&raw const made.grains, numbers.as_ptr(), &raw mut again);
            let status = carom_ring_touch_unpack(grains, rings, RADII[0], RADII[1], from, to, none);
            assert_eq!(status, CaromStatus::Ok);
            let to = &raw mut load;
            let status = carom_ring_touch_grains_load(grains, rings, &again, one, two, to, none);
            assert_eq!(status, CaromStatus::Ok);
        }
        assert_eq!(numbers[0] == CAROM_RING_TOUCH_MARK, at > 0);
        assert!(at == 0 || load == impact.load);
        let mut copy = Impact { touch: again, ..impact };
        for _ in 0..60 {
            copy.step();
            impact.step();
            assert_eq!(copy.bodies, impact.bodies);
        }
    }
}

/// A wall is a sphere without end, and takes no torque.
#[test]
fn wall_is_a_sphere_without_end() {
    let made = Made::new([STEEL, GLASS], 0.15, 1e-5);
    let (wall_at, normal) = ([3.0, -2.0, 0.0], [0.0, 0.0, 1.0]);
    let wall = CaromWall { place: wall_at, normal, velocity: [0.0, 5e-5, 0.0] };
    let (mut touch, mut other) = (apart(), apart());
    for t in 1..40 {
        let t = f64::from(t);
        let grain = CaromGrain {
            place: [1e-4 * t, 0.0, 0.5 - 1e-4 * t],
            velocity: [1e-4, 0.0, -1e-4],
            spin: [0.0, 1e-5, 2e-3],
            radius: 0.5,
            mass: 1.0,
        };
        let place = [grain.place[0], 0.0, -1e7];
        let below =
            CaromGrain { place, velocity: wall.velocity, spin: [0.0; 3], radius: 1e7, mass: 1.0 };
        let (mut load, mut expected) = (CaromGrainLoad::default(), CaromGrainLoad::default());
        let mut kept = CaromGrainLoad::default();
        let (grains, rings, none) = (&raw const made.grains, made.rings, null_mut());
        // SAFETY: all pointers are references or null.
        unsafe {
            let (to, heats) = (&raw mut load, null_mut());
            let status = carom_ring_touch_wall(
                grains, rings, &mut touch, &grain, &wall, 1.0, to, heats, none,
            );
            assert_eq!(status, CaromStatus::Ok);
            let (to, at) = (&raw mut expected, &mut other);
            let status =
                carom_ring_touch_grains(grains, rings, at, &grain, &below, 1.0, to, heats, none);
            assert_eq!(status, CaromStatus::Ok);
            let to = &raw mut kept;
            let status = carom_ring_touch_wall_load(grains, rings, &touch, &grain, &wall, to, none);
            assert_eq!(status, CaromStatus::Ok);
        }
        assert_eq!(kept, load);
        for k in 0..3 {
            let off = (load.force[k] - expected.force[k]).abs();
            assert!(off < 1e-3 * expected.force[2], "{t} {load:?} {expected:?}");
        }
        assert!(load.force[0] < 0.0 && load.torque_1[2] < 0.0 && load.torque_2 == [0.0; 3]);
        assert!((load.torque_1[2] / expected.torque_1[2] - 1.0).abs() < 0.02);
    }
    let mut report = CaromReport { sticking: -1.0, regime: CaromRegime::Separated };
    // SAFETY: all pointers are references or null.
    let status = unsafe { carom_ring_touch_report(made.rings, &touch, &mut report, null_mut()) };
    assert_eq!(status, CaromStatus::Ok);
    assert!(report.regime != CaromRegime::Separated && (0.0..=1.0).contains(&report.sticking));
}

/// Constants of one law, or matrices of other materials, are refused by name; nothing is changed.
#[test]
fn what_does_not_belong_together_is_refused() {
    let made = Made::new([STEEL, GLASS], 0.15, 0.0);
    let other = Made::new([STEEL, GLASS], 0.2, 0.0);
    let impact = Impact::new(&made, [1.0, 0.0], 100);
    let ([one, two], mut touch) = (&impact.bodies, apart());
    let mut load = CaromGrainLoad::default();
    // SAFETY: plain numbers; all pointers are references or null.
    unsafe {
        let mut error: CaromError = zeroed();
        let to = &raw mut error;
        let field = |status: CaromStatus, name: &str| {
            assert_eq!(status, CaromStatus::OutOfRange);
            let told: String =
                (*to).field.iter().take_while(|c| **c != 0).map(|c| *c as u8 as char).collect();
            assert_eq!(told, name);
        };
        let (at, put, none) = (&raw mut touch, &raw mut load, null_mut());
        let (grains, rings) = (&raw const made.grains, other.rings);
        field(carom_ring_touch_grains(grains, rings, at, one, two, 1e-3, put, none, to), "rings");
        assert_eq!(touch.mark, 0);
        let mut plain: CaromTouch = zeroed();
        let status = carom_touch_grains(grains, &raw mut plain, one, two, 1e-3, put, none, to);
        field(status, "law");
        let mut pair: CaromPair = zeroed();
        let law = CAROM_LAW_RINGS;
        let status = carom_pair_of_stiffness(1.0, 1.0, 1.2, 0.3, law, 0.0, &raw mut pair, to);
        field(status, "b_squared");
        let glass = material(GLASS);
        let place = &raw mut pair;
        let status = carom_pair_of_curvatures(&glass, &glass, 1.0, 2.0, 0.3, law, 0.0, place, to);
        field(status, "b_squared");
        let status = carom_pair_of_spheres(&glass, &glass, 1.0, 2.0, 0.3, 0, 0.0, place, to);
        assert_eq!((status, pair.coupling_bound), (CaromStatus::Ok, 0.0));
        let mut made = null_mut();
        field(carom_rings_of(place, &raw mut made, to), "law");
        assert!(made.is_null());
    }
    // What is neglected is told with the constants, of whichever law.
    assert!((made.grains.unit.coupling_bound - 0.35).abs() < 0.02);
}
