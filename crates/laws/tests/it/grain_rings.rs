//! Contacts of grains with the law of rings: against the law itself, with the bodies exchanged, through numbers.

use carom_drawn::{Congruential, Draw as _};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::grains::{
    Grain, GrainContact, GrainLoad, Heats, Meeting, Wall, compliance_shares, ring_grain_numbers,
};
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Dissipative as _, Shift};
use carom_laws::rings::{RingLaw, Tolerance};

use crate::grains::{cross, plus};

type V = [f64; 3];

const FRICTION: f64 = 0.3;

/// nu = 0 against nu = 1/2: gamma = -1/3 or, exchanged, 1/3.
fn materials(is_exchanged: bool) -> MaterialPair {
    let body = |poisson| Material::from_shear(2.0, poisson).unwrap();
    let pair = MaterialPair::new(body(0.5), body(0.0)).unwrap();
    if is_exchanged { pair.exchanged() } else { pair }
}

fn friction() -> Friction {
    Friction::new(FRICTION).unwrap()
}

/// A contact of relative radius 1.
fn hertz(pair: MaterialPair) -> Hertz {
    Hertz::new(RelativeCurvature::from_coefficients(0.5, 0.5).unwrap(), pair).unwrap()
}

fn rings(pair: MaterialPair) -> RingLaw {
    RingLaw::new(&hertz(pair), friction(), Tolerance::PARTICLES).unwrap()
}

/// The law is told the shifts by hand, of a grain that spins about the normal on a wall that moves along: the wall is
/// body 2, and `u = xi + y Omega` (12.2) is its displacement against the grain. With the materials exchanged the part
/// across the path, by coupling and twist together, is another.
#[test]
fn a_grain_on_a_wall_follows_the_law_of_its_materials() {
    let (zeta, dt, along, spin) = (1e-5, 0.1, [2e-6, -1e-6, 0.0], 1e-3);
    let mut largest = 0.0_f64;
    for is_exchanged in [false, true] {
        let pair = materials(is_exchanged);
        let [mut law, mut other] = [pair, pair.exchanged()].map(rings);
        let mut contact = GrainContact::new(rings(pair), 0.0).unwrap();
        let wall = Wall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: along };
        let place = [0.0, 0.0, 1.0 - zeta];
        let spins = [0.0, 0.0, spin];
        let grain = Grain { place, velocity: [0.0; 3], spin: spins, radius: 1.0, mass: 1.0 };
        for law in [&mut law, &mut other] {
            law.advance(Shift { zeta, ..Shift::default() }).unwrap();
        }
        for step in 1..=40 {
            let load = contact.advance(&Meeting::on_wall(&grain, &wall, 0.5), dt).unwrap();
            let t = dt * f64::from(step);
            // Seen from the grain the wall turns by -spin t, that is Omega = spin t.
            let to = Shift { zeta, xi: along[0] * t, eta: along[1] * t, omega: spin * t };
            let (expected, wrong) = (law.advance(to).unwrap(), other.advance(to).unwrap());
            let size = FRICTION * expected.f_z;
            let off = |x: f64, y: f64| (load.force[0] - x).hypot(load.force[1] - y) / size;
            assert!(off(expected.f_x, expected.f_y) < 3e-3, "{load:?} {expected:?}");
            largest = largest.max(off(wrong.f_x, wrong.f_y));
            assert!((load.force[2] / expected.f_z - 1.0).abs() < 1e-3);
            // M_z is the integral of y t_x - x t_y, clockwise.
            let torque = load.torques[0][2] + expected.m_z;
            assert!(torque.abs() < 3e-3 * size * zeta.sqrt(), "{load:?} {expected:?}");
        }
    }
    assert!(largest > 0.03, "{largest}");
}

/// Grains that press, slide, roll and twist; all that happens to both of them.
fn walk(steps: usize, mut each: impl FnMut(&[Grain; 2], f64)) {
    let mut draw = Congruential(7);
    let normal = [0.36, 0.48, 0.8];
    let mut grains = [0.5, 0.8].map(|radius| Grain {
        place: [0.0; 3],
        velocity: [0.0; 3],
        spin: [0.0; 3],
        radius,
        mass: 1.0,
    });
    grains[0].place = normal.map(|n| 1.299 * n);
    let dt = 0.02;
    for step in 0..steps {
        if step % 12 == 0 {
            for grain in &mut grains {
                grain.velocity = [0; 3].map(|_| 1e-3 * draw.signed());
                grain.spin = [0; 3].map(|_| 2e-3 * draw.signed());
            }
            // The spin about the normal counts as much as the slip.
            grains[0].spin = plus(grains[0].spin, normal, 0.05 * draw.signed());
        }
        for grain in &mut grains {
            grain.place = plus(grain.place, grain.velocity, dt);
        }
        each(&grains, dt);
    }
}

#[test]
fn an_exchange_of_the_grains_gives_the_same_bits() {
    let pairs = [false, true].map(materials);
    let shares = pairs.each_ref().map(compliance_shares);
    // Body 1 gives way as it does on a rigid one.
    let alone = MaterialPair::new(pairs[0].body_1(), Material::RIGID).unwrap();
    let own = pairs[0].contact_modulus() / alone.contact_modulus();
    assert!((shares[0][0] - own).abs() < 1e-15 && shares[0][0] + shares[0][1] == 1.0);
    let [mut contact, mut other] = pairs.map(|pair| GrainContact::new(rings(pair), 0.3).unwrap());
    let mut largest = 0.0_f64;
    walk(120, |grains, dt| {
        let meeting = Meeting::of_spheres(&grains[0], &grains[1], shares[0]).unwrap();
        let exchanged = Meeting::of_spheres(&grains[1], &grains[0], shares[1]).unwrap();
        let load = contact.advance(&meeting, dt).unwrap();
        let opposite = other.advance(&exchanged, dt).unwrap();
        assert_eq!(load.force, opposite.force.map(|f| -f));
        assert_eq!(load.torques, [opposite.torques[1], opposite.torques[0]]);
        // Forces and torques leave no moment.
        let moment = |grain: &Grain, sign: f64, torque: V| {
            plus(cross(grain.place, load.force.map(|f| sign * f)), torque, 1.0)
        };
        let [upper, lower] = load.torques;
        let sum = plus(moment(&grains[0], 1.0, upper), moment(&grains[1], -1.0, lower), 1.0);
        let size = load.force.iter().map(|f| f.abs()).sum::<f64>();
        assert!(sum.iter().all(|m| m.abs() <= 1e-14 * size), "{sum:?}");
        largest = largest.max(load.torques[0].iter().map(|m| m.abs()).sum());
    });
    assert!(largest > 0.0);
}

fn is_same(one: &GrainContact<RingLaw>, two: &GrainContact<RingLaw>) -> bool {
    one.law().memory() == two.law().memory() && one.frame() == two.frame()
}

#[test]
fn what_was_packed_goes_on_to_the_same_bits() {
    let fresh = GrainContact::new(rings(materials(false)), 0.1).unwrap();
    let (mut contact, mut kept) = (fresh.clone(), fresh.clone());
    let mut heats = Heats::default();
    walk(60, |[one, two], dt| {
        let meeting = Meeting::of_spheres(one, two, [0.5; 2]).unwrap();
        let load = contact.advance_accounted(&meeting, dt, &mut heats).unwrap();
        assert_eq!(contact.load(&meeting), load);
        let mut numbers = [0.0; ring_grain_numbers(6, 8)];
        contact.pack(&mut numbers).unwrap();
        let mut again = fresh.clone();
        again.unpack(&numbers).unwrap();
        assert_eq!(again.load(&meeting), load);
        // One that was never packed.
        assert_eq!(kept.advance(&meeting, dt).unwrap(), load);
        assert_eq!(kept.frame(), again.frame());
        contact = again;
    });
    assert!(heats.friction > 0.0);
    let mut numbers = [0.0; ring_grain_numbers(6, 8)];
    contact.pack(&mut numbers).unwrap();
    let mut refuse = |at: usize, value: f64, field: &str| {
        let (mut bad, before) = (numbers, contact.clone());
        bad[at] = value;
        assert_eq!(contact.unpack(&bad).map_err(|error| error.field), Err(field), "{at}");
        assert!(is_same(&contact, &before));
    };
    refuse(0, 20_001.0, "mark");
    refuse(0, 30_001.0, "mark");
    refuse(1, f64::NAN, "zeta");
    refuse(7, 2.0, "centre");
    refuse(12 + 96, 40.0, "traction");
    refuse(300, 2.0, "tangent");
    refuse(303, 2.0, "normal");
    refuse(308, f64::INFINITY, "force");
    refuse(312, f64::NAN, "lead");
    refuse(314, f64::NAN, "velocity");
    refuse(315, f64::NAN, "approach");
    refuse(316, f64::NAN, "torque");
    refuse(317, f64::NAN, "twist");
    refuse(318, f64::INFINITY, "twist");
    assert_eq!(contact.unpack(&numbers[1..]).unwrap_err().field, "mark");
}

/// A contact that has not stepped carries Hertz's force, one that has parted nothing.
#[test]
fn a_contact_begins_and_ends() {
    let pair = materials(false);
    let mut contact = GrainContact::new(rings(pair), 0.0).unwrap();
    assert_eq!(GrainContact::new(rings(pair), -1.0).unwrap_err().field, "relaxation");
    let wall = Wall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: [0.0; 3] };
    let meeting = |zeta: f64, velocity: V| {
        let place = [0.0, 0.0, 1.0 - zeta];
        Meeting::on_wall(
            &Grain { place, velocity, spin: [0.0, 0.0, 0.01], radius: 1.0, mass: 1.0 },
            &wall,
            0.5,
        )
    };
    let still = contact.load(&meeting(1e-3, [0.0; 3]));
    assert!((still.force[2] / hertz(pair).force(1e-3) - 1.0).abs() < 1e-14);
    assert_eq!([still.force[0], still.force[1]], [0.0; 2]);
    let pressed = contact.advance(&meeting(1e-3, [2e-3, 0.0, -1e-3]), 0.1).unwrap();
    assert!(pressed.force[0] < 0.0 && pressed.torques[0][2] < 0.0);
    // No torque on the wall.
    assert_eq!(pressed.torques[1], [0.0; 3]);
    let left = contact.advance(&meeting(-1e-4, [0.0, 0.0, 0.011]), 0.1).unwrap();
    assert!(left.force.iter().chain(&left.torques[0]).all(|f| f.abs() < 0.3 * pressed.force[2]));
    let gone = contact.advance(&meeting(-1e-3, [0.0, 0.0, 0.011]), 0.1).unwrap();
    assert_eq!(gone, GrainLoad::default());
    assert_eq!(contact.law().stored_energy(), 0.0);
}
