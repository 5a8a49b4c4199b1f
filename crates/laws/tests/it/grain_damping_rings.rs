//! Damped contacts with the law of rings: shift and twist lead, impacts are those of the law of shifts, books close.

use carom_laws::damping::HertzDamping;
use carom_laws::friction::Friction;
use carom_laws::grains::{Grain, GrainContact, Heats, Meeting, Wall};
use carom_laws::law::{ContactLaw as _, Shift};
use carom_laws::rings::{RingConstants, RingLaw, Tolerance};
use carom_laws::stiffness::ContactStiffness;
use carom_laws::viscous::{Viscosity, ViscousLaw};

use crate::grain_damping::{
    DURATION, FRICTION, RADIUS, WALL, exact, impact_within, rebound_of, thrown,
};

/// A contact with K = 1.
fn law(gamma: f64, friction: f64) -> RingLaw {
    let constants = RingConstants { c_z: 1.5, radius: 1.0, kappa: 1.2, gamma };
    let friction = Friction::new(friction).unwrap();
    RingLaw::from_constants(constants, friction, Tolerance::GRAINS).unwrap()
}

fn restituting(law: &RingLaw, e: f64) -> GrainContact<RingLaw> {
    let damping = HertzDamping::of_restitution(e).unwrap();
    GrainContact::new(law.clone(), 0.0).unwrap().with_restitution(damping).unwrap()
}

#[test]
fn impacts_are_those_of_viscous_spheres() {
    let law = law(0.0, FRICTION);
    for [_, e, lambda, exact] in exact().filter(|row| row[0] == 1.2) {
        let [r, left] = impact_within(1e-9, restituting(&law, e), lambda, (100.0, 0.4));
        assert!((r - exact).abs() < 0.035, "{e} {lambda}: {r} {exact}");
        assert!((left - e).abs() < 1e-3, "{e} {lambda}: {left}");
    }
}

/// Kinetic energy lost is friction heat and heat of damping, of dissimilar materials and with a spin about the normal.
#[test]
fn what_a_spinning_impact_loses_is_booked() {
    let law = law(0.25, 0.3);
    // So small an inertia that the torque about the normal counts.
    let inertia = 0.1;
    let energy = |ball: &Grain| {
        let square = |v: [f64; 3]| v.iter().map(|v| v * v).sum::<f64>();
        0.5 * square(ball.velocity) + 0.5 * inertia * square(ball.spin)
    };
    let viscous = GrainContact::new(law.clone(), 0.3).unwrap();
    for fresh in [restituting(&law, 0.9), restituting(&law, 0.5), viscous] {
        let missed = [100.0, 400.0].map(|steps| {
            let dt = DURATION / steps;
            // Its surface moves as its centre: the arm is that of a point.
            let mut ball = Grain { spin: [0.0, 0.0, 1.0], ..thrown(1.0, 0.4 * dt) };
            let (before, mut heats, mut contact) = (energy(&ball), Heats::default(), fresh.clone());
            rebound_of(&mut ball, inertia, dt, |meeting| {
                let mut load = contact.advance_accounted(meeting, dt, &mut heats).unwrap();
                load.torques[0] = [0.0, 0.0, load.torques[0][2]];
                load
            });
            let lost = before - energy(&ball);
            assert!(heats.friction > 0.0 && heats.damping > 0.0 && lost > 0.05 * before);
            (lost - heats.friction - heats.damping).abs() / before
        });
        assert!(missed[0] < 1e-4 && missed[1] < 6e-6, "{missed:?}");
    }
}

/// Tractions of dissimilar bodies that slide are less than f F_z in sum, by their coupling. They slide on, though the
/// material lags behind, until the slip is nearly 0; it falls by 7/2 of the impulse of friction over the mass.
#[test]
fn dissimilar_bodies_slide_until_their_slip_ends() {
    let law = law(0.25, FRICTION);
    for e in [0.3, 0.6] {
        let (dt, lambda) = (DURATION / 200.0, 3.35);
        let (mut ball, mut contact) = (thrown(lambda, 0.4 * dt), restituting(&law, e));
        let (mut slip, mut least) = (lambda * FRICTION, f64::INFINITY);
        rebound_of(&mut ball, 0.4 * RADIUS * RADIUS, dt, |meeting| {
            let load = contact.advance(meeting, dt).unwrap();
            let [x, y, z] = load.force;
            slip -= 3.5 * x.hypot(y) * dt;
            if slip > 0.25 * lambda * FRICTION {
                least = least.min(x.hypot(y) / (FRICTION * z));
            }
            load
        });
        assert!(least > 0.98 && slip < 0.0, "{e}: {least} {slip}");
    }
}

/// At a constant approach shift and twist lead by the relaxation time: force and torque are those of an elastic contact
/// that is ahead by A times the rate. Its axes turn meanwhile.
#[test]
fn shift_and_twist_lead_by_the_relaxation_time() {
    let law = law(0.0, 1e3);
    let (dt, relaxation, rate) = (0.01, 0.3, [1e-3, -2e-3, 3e-3]);
    let contacts = [relaxation, 0.0].map(|time| GrainContact::new(law.clone(), time).unwrap());
    let loads = [0, 1].map(|i| {
        let mut contact = contacts[i].clone();
        let mut step = |zeta: f64, speed: f64, rate: [f64; 3]| {
            let wall = Wall { velocity: [rate[0], rate[1], 0.0], ..WALL };
            let ball = Grain {
                place: [0.0, 0.0, RADIUS - zeta],
                velocity: [0.0, 0.0, -speed],
                spin: [0.0, 0.0, rate[2]],
                radius: RADIUS,
                mass: 1.0,
            };
            contact.advance(&Meeting::on_wall(&ball, &wall, 0.0), dt).unwrap()
        };
        for n in 1..=50 {
            step(0.02 * f64::from(n), 1.0, [0.0; 3]);
        }
        for _ in 0..3 {
            step(1.0, 0.0, [0.0; 3]);
        }
        // The elastic contact goes on for the relaxation time.
        let steps = if i == 0 { 50 } else { 80 };
        (0..steps).map(|_| step(1.0, 0.0, rate)).last().unwrap()
    });
    let [damped, ahead] = loads.map(|load| [load.force[0], load.force[1], load.torques[0][2]]);
    for (k, most) in [(0, 1e-3), (1, 1e-3), (2, 1e-12)] {
        assert!((damped[k] / ahead[k] - 1.0).abs() < most, "{loads:?}");
    }
}

/// All slips in a fast spin while the contact is pressed: the torque is friction times the mean distance of the pressure, a
/// part of which is that of Hertz at the true approach, the rest that of a flat punch.
#[test]
fn a_spin_under_viscous_pressure_has_the_arm_of_the_pressure() {
    let stiffness = ContactStiffness::new(1.25, 1.25, 1.5).unwrap();
    let viscosity = Viscosity::new(2.0).unwrap();
    let mut law = ViscousLaw::new(law(0.0, FRICTION), viscosity, FRICTION, stiffness);
    let rates = Shift { zeta: 1.0, omega: 100.0, ..Shift::default() };
    let mut load = law.load();
    for n in 1..=100 {
        let zeta = 0.01 * f64::from(n);
        let to = Shift { zeta, omega: 100.0 * zeta, ..Shift::default() };
        load = law.advance_at(to, rates, 0.01).unwrap();
    }
    // It parts where zeta + A zeta' vanishes.
    let receding = Shift { zeta: -0.25, ..rates };
    assert_eq!([rates, receding].map(|rates| law.depth(law.shift(), rates)), [1.0, 0.5]);
    // K = 1 and a = zeta = 1: the force is Hertz's and three times as much of the material.
    assert!((load.f_z - 4.0).abs() < 1e-12, "{load:?}");
    let hertz = 1.0 / load.f_z;
    let arm = std::f64::consts::PI * (hertz * 3.0 / 16.0 + (1.0 - hertz) / 4.0);
    assert!((load.m_z.abs() / (FRICTION * load.f_z * arm) - 1.0).abs() < 0.02, "{load:?} {arm}");
}
