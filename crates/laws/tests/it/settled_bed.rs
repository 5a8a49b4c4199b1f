//! A bed of grains at rest with storage of fixed capacity: growth of rounding errors.
//!
//! Grains of unequal size settle in a box. Then two copies, one of them perturbed by a part in
//! 10^15, are continued. Merging of vertices must not make them diverge.

use carom_drawn::{Draw as _, Splitmix};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::memory::Fixed;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;

use crate::grains::{cross, dot};

type V = [f64; 3];

const SIDE: usize = 4;
const GRAINS: usize = SIDE * SIDE * SIDE;
const STEP: f64 = 2e-3;
const STIFFNESS: f64 = 2000.0;

fn plus(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn times(a: V, by: f64) -> V {
    a.map(|a| a * by)
}

fn minus(a: V, b: V) -> V {
    plus(a, times(b, -1.0))
}

fn unit(a: V) -> V {
    times(a, 1.0 / dot(a, a).sqrt())
}

/// A contact of two grains or of one and a wall, with the tangent x of its frame.
#[derive(Clone, Copy)]
struct Contact<L> {
    law: L,
    tangent: V,
    shift: [f64; 2],
}

#[derive(Clone)]
struct Bed<L> {
    fresh: L,
    radius: Vec<f64>,
    place: Vec<V>,
    velocity: Vec<V>,
    spin: Vec<V>,
    /// By first grain and second, or by grain and wall.
    contacts: std::collections::BTreeMap<(usize, usize), Contact<L>>,
}

impl<L: ContactLaw + Copy> Bed<L> {
    /// Grains of diameters from 0.8 to 1 on a loose lattice in a box open above, thrown about.
    fn loose(fresh: L) -> Self {
        let mut random = Splitmix(3);
        let mut between = |a: f64, b: f64| random.between(a, b);
        let radius: Vec<f64> = (0..GRAINS).map(|_| between(0.4, 0.5)).collect();
        let place = (0..GRAINS)
            .map(|i| {
                let at = [i % SIDE, i / SIDE % SIDE, i / (SIDE * SIDE)];
                at.map(|n| 0.55 + 1.03 * n as f64 + between(-0.02, 0.02))
            })
            .collect();
        let velocity = (0..GRAINS).map(|_| [0; 3].map(|_| between(-0.5, 0.5))).collect();
        let spin = vec![[0.0; 3]; GRAINS];
        Self { fresh, radius, place, velocity, spin, contacts: std::collections::BTreeMap::new() }
    }

    /// Approach and normal, out of the second grain or wall into the first.
    fn gap(&self, i: usize, j: usize) -> (f64, V) {
        let width = 1.03 * SIDE as f64 + 0.1;
        if j < GRAINS {
            let apart = minus(self.place[i], self.place[j]);
            let distance = dot(apart, apart).sqrt();
            return (self.radius[i] + self.radius[j] - distance, times(apart, 1.0 / distance));
        }
        let (axis, far) = ((j - GRAINS) / 2, (j - GRAINS) % 2 == 1);
        let mut normal = [0.0; 3];
        normal[axis] = if far { -1.0 } else { 1.0 };
        let at = self.place[i][axis];
        (self.radius[i] - if far { width - at } else { at }, normal)
    }

    /// One step with this damping of all motion.
    fn step(&mut self, damping: f64) {
        let mut force = vec![[0.0, 0.0, -1.0]; GRAINS];
        let mut torque = vec![[0.0; 3]; GRAINS];
        for i in 0..GRAINS {
            // Five walls: none above.
            for j in (0..i).chain(GRAINS..GRAINS + 5) {
                let (zeta, normal) = self.gap(i, j);
                if zeta <= 0.0 {
                    self.contacts.remove(&(i, j));
                    continue;
                }
                let (load, arm) = self.load(i, j, zeta, normal);
                force[i] = plus(force[i], load);
                torque[i] = plus(torque[i], cross(times(normal, -arm), load));
                if j < GRAINS {
                    force[j] = minus(force[j], load);
                    let arm = self.radius[j] - 0.5 * zeta;
                    torque[j] = plus(torque[j], cross(times(normal, -arm), load));
                }
            }
        }
        for i in 0..GRAINS {
            // Of unit density over 4 pi/3.
            let mass = 8.0 * self.radius[i].powi(3);
            let inertia = 0.4 * mass * self.radius[i] * self.radius[i];
            let keep = 1.0 - damping * STEP;
            let gravity_of_one = [force[i][0], force[i][1], force[i][2] + 1.0 - mass];
            self.velocity[i] =
                plus(times(self.velocity[i], keep), times(gravity_of_one, STEP / mass));
            self.spin[i] = plus(times(self.spin[i], keep), times(torque[i], STEP / inertia));
            self.place[i] = plus(self.place[i], times(self.velocity[i], STEP));
        }
    }

    /// The load on the first, and its arm.
    fn load(&mut self, i: usize, j: usize, zeta: f64, normal: V) -> (V, f64) {
        let arm = self.radius[i] - 0.5 * zeta;
        let mut speed = plus(self.velocity[i], cross(self.spin[i], times(normal, -arm)));
        if j < GRAINS {
            let other = self.radius[j] - 0.5 * zeta;
            let at = plus(self.velocity[j], cross(self.spin[j], times(normal, other)));
            speed = minus(speed, at);
        }
        let any = if normal[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let contact = self.contacts.entry((i, j)).or_insert(Contact {
            law: self.fresh,
            tangent: unit(cross(normal, any)),
            shift: [0.0; 2],
        });
        // The frame goes along with the normal.
        let along = contact.tangent;
        contact.tangent = unit(minus(along, times(normal, dot(along, normal))));
        let (x, y) = (contact.tangent, cross(normal, contact.tangent));
        contact.shift[0] += STEP * dot(speed, x);
        contact.shift[1] += STEP * dot(speed, y);
        let shift = Shift { zeta, xi: contact.shift[0], eta: contact.shift[1], omega: 0.0 };
        let load = contact.law.advance(shift).unwrap_or_default();
        let tangential = plus(times(x, load.f_x), times(y, load.f_y));
        (minus(times(normal, load.f_z), tangential), arm)
    }

    fn energy(&self) -> f64 {
        self.velocity.iter().map(|v| dot(*v, *v)).sum::<f64>() / GRAINS as f64
    }
}

/// How far two copies of a settled bed come apart in 500 steps, over a diameter, and how many contacts
/// it has.
fn growth<L: ContactLaw + Copy>(fresh: L) -> (f64, usize) {
    let mut bed = Bed::loose(fresh);
    for _ in 0..6000 {
        bed.step(2.0);
    }
    let mut other = bed.clone();
    for place in &mut other.place {
        place[0] *= 1.0 + 1e-15;
    }
    let mut apart = 0.0_f64;
    for _ in 0..500 {
        bed.step(0.0);
        other.step(0.0);
        for (a, b) in bed.place.iter().zip(&other.place) {
            let off = minus(*a, *b);
            apart = apart.max(dot(off, off).sqrt());
        }
    }
    assert!(bed.energy() < 1e-3, "settled: {:e}", bed.energy());
    (apart, bed.contacts.len())
}

fn both<const N: usize>() -> [f64; 2] {
    let stiffness = ContactStiffness::new(0.85 * STIFFNESS, 0.85 * STIFFNESS, STIFFNESS).unwrap();
    let friction = Friction::new(0.3).unwrap();
    let coulomb = growth(ShiftLaw::<[f64; 2], Fixed<_, N>>::new(stiffness, friction));
    let old = growth(ShiftLaw::<[f64; 2], Fixed<_, N>>::with_fixed_direction(stiffness, friction));
    for (name, (apart, contacts)) in [("Coulomb", coulomb), ("chapter 7", old)] {
        println!("{N} vertices, {name}: {apart:.1e} apart, {contacts} contacts");
    }
    [coulomb.0, old.0]
}

#[test]
fn a_settled_bed_in_fixed_storage_does_not_come_apart() {
    for apart in [both::<8>(), both::<16>()] {
        assert!(apart[0] < 1e-6 && apart[1] < 1e-6, "{apart:?}");
    }
}
