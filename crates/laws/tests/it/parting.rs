//! Bodies that part, and grains on a wall: what the end of a contact gives, by the law itself and by energy.

use carom_halfspace::{Material, MaterialPair};
use carom_laws::coulomb::{self, CoulombMemory};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::grains::{Grain, GrainContact, Heats, Meeting, Wall};
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::rings::{RingLaw, Tolerance};
use carom_laws::viscous::{Viscosity, ViscousLaw};

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const WALL: Wall = Wall { place: [0.0; 3], normal: UP, velocity: [0.0; 3] };

fn grain(height: f64, velocity: f64, spin: [f64; 3]) -> Grain {
    Grain {
        place: [0.0, 0.0, height],
        velocity: [0.0, 0.0, velocity],
        spin,
        radius: 1.0,
        mass: 1.0,
    }
}

fn friction() -> Friction {
    Friction::new(0.3).unwrap()
}

/// A contact of relative radius 1 of like bodies.
fn hertz() -> Hertz {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    Hertz::new(RelativeCurvature::from_coefficients(0.5, 0.5).unwrap(), pair).unwrap()
}

fn rings(hertz: &Hertz) -> RingLaw {
    RingLaw::new(hertz, friction(), Tolerance::PARTICLES).unwrap()
}

/// Where the gap opens within four steps the torque, as friction, is the mean over half a step before the end
/// and half a step after it; the last step in contact also has what is left for the next one.
#[test]
fn the_torque_of_a_grain_that_leaves_is_a_mean_about_the_end() {
    let (hertz, zeta, dt, spin) = (hertz(), 1e-4, 0.1, 2e-3);
    let mut contact = GrainContact::new(rings(&hertz), 0.0).unwrap();
    let mut law = rings(&hertz);
    let at = |zeta: f64, t: f64| Shift { zeta, omega: spin * t, ..Shift::default() };
    law.advance(at(zeta, 0.0)).unwrap();
    for k in 1..=10 {
        let meeting = Meeting::on_wall(&grain(1.0 - zeta, 0.0, UP.map(|n| spin * n)), &WALL, 0.5);
        let torque = contact.advance(&meeting, dt).unwrap().torques[0][2];
        let want = -law.advance(at(zeta, dt * f64::from(k))).unwrap().m_z;
        assert!((torque / want - 1.0).abs() < 1e-9, "{k}: {torque} {want}");
    }
    // Up by a part of the approach: gone in two steps, or in one, which then has what is left of the mean.
    for (rise, left) in [(0.4, 0.25), (0.6, 0.5)] {
        let (mut contact, mut law) = (contact.clone(), law.clone());
        let up = grain(1.0 - (1.0 - rise) * zeta, rise * zeta / dt, UP.map(|n| spin * n));
        let got = contact.advance(&Meeting::on_wall(&up, &WALL, 0.5), dt).unwrap().torques[0][2];
        let mut past = law.clone();
        let past = past.advance(at((1.0 - 0.5 * rise) * zeta, 10.5 * dt)).unwrap().m_z;
        let now = law.advance(at((1.0 - rise) * zeta, 11.0 * dt)).unwrap().m_z;
        let ahead = law.advance(at((1.0 - 1.5 * rise) * zeta, 11.5 * dt)).unwrap().m_z;
        let want = -(0.5 * now + 0.25 * past + left * ahead);
        assert!((got / want - 1.0).abs() < 1e-9, "{got} {want}");
        assert!((got / -now - 1.0).abs() > 1e-3, "a mean that is the middle shows nothing");
    }
}

/// A ball that falls on a wall of viscous material: what its kinetic energy lost is the heat of damping.
#[test]
fn the_heat_of_damping_by_rings_is_the_kinetic_energy_lost() {
    let hertz = hertz();
    let c_z = hertz.stiffness().c_z;
    // Unit mass, approach up to 1e-4: v^2/2 = (4/15) c_z zeta^2.5.
    let deepest = 1e-4_f64;
    let speed = (8.0 / 15.0 * c_z * deepest.powf(2.5)).sqrt();
    let time = 2.943 * deepest / speed;
    let lost = |steps: usize| {
        let mut contact = GrainContact::new(rings(&hertz), 0.04 * time).unwrap();
        let dt = time / steps as f64;
        let (mut height, mut velocity, mut heats) = (1.0, -speed, Heats::default());
        for _ in 0..2 * steps {
            height += dt * velocity;
            let meeting = Meeting::on_wall(&grain(height, velocity, [0.0; 3]), &WALL, 0.5);
            let load = contact.advance_accounted(&meeting, dt, &mut heats).unwrap();
            velocity += dt * load.force[2];
        }
        assert!(velocity > 0.0 && height > 1.0);
        (0.5 * (speed * speed - velocity * velocity), heats.damping)
    };
    let (energy, heat) = lost(200);
    assert!(energy > 0.05 * speed * speed, "{energy}");
    assert!((heat / energy - 1.0).abs() < 2e-4, "{heat} {energy}");
}

/// A wall is a sphere of infinite radius that does not turn: axes of the contact turn with half of the grain's
/// spin.
#[test]
fn a_wall_is_a_sphere_of_infinite_radius() {
    let (radius, share) = (1e8, 0.5);
    let spin = [0.2, -0.3, 0.7];
    let one = Grain { velocity: [0.1, 0.2, -0.3], ..grain(1.0 - 1e-3, 0.0, spin) };
    let below = Grain {
        place: [0.0, 0.0, -radius],
        velocity: [-0.4, 0.1, 0.0],
        spin: [0.0; 3],
        radius,
        mass: 1.0,
    };
    let wall = Wall { velocity: below.velocity, ..WALL };
    let (flat, round) = (
        Meeting::on_wall(&one, &wall, share),
        Meeting::of_spheres(&one, &below, [share, 0.0]).unwrap(),
    );
    assert_eq!((flat.turning(), flat.twisting()), ([0.1, -0.15, 0.35], [-0.2, 0.3, -0.7]));
    for (flat, round, name) in [
        (flat.turning(), round.turning(), "turning"),
        (flat.twisting(), round.twisting(), "twisting"),
        (flat.spins[0], round.spins[0], "spin"),
        (flat.velocity, round.velocity, "velocity"),
        (flat.normal, round.normal, "normal"),
    ] {
        for (a, b) in flat.into_iter().zip(round) {
            assert!((a - b).abs() < 1e-7, "{name}: {flat:?} {round:?}");
        }
    }
    assert!((flat.zeta - round.zeta).abs() < 1e-7 && (flat.arms[0] - round.arms[0]).abs() < 1e-7);
}

/// Of a step that parts the bodies only the way up to separation counts, for work and heat.
#[test]
fn after_separation_a_step_takes_no_work_and_makes_no_heat() {
    let mut memory = CoulombMemory::<[f64; 2]>::new(coulomb::Tolerance::new(1e-6).unwrap());
    for (zeta, shift) in [(1.0, [0.0, 0.0]), (1.0, [0.4, 0.1]), (0.9, [0.2, 0.5])] {
        memory.advance(zeta, shift).unwrap();
    }
    let (from, to) = ([0.2, 0.5], [1.4, -0.7]);
    // From 0.9 to -0.3: three quarters of the way in contact.
    let touch = [0, 1].map(|i| from[i] + 0.75 * (to[i] - from[i]));
    let [work, want] = [memory.work(-0.3, to), memory.work(0.0, touch)];
    assert!((work - want).abs() < 1e-9 * want.abs(), "{work} {want}");
    let [heat, expected] = [memory.dissipation(-0.3, to), memory.dissipation(0.0, touch)];
    for (heat, expected) in heat.into_iter().zip(expected) {
        assert!((heat - expected).abs() < 1e-9 * expected && expected > 0.0, "{heat} {expected}");
    }
}

/// A torque is a mean if the gap opens within four steps, and the one at the end if it opens later.
#[test]
fn the_torque_is_a_mean_from_four_steps_before_the_gap_opens() {
    let (hertz, zeta, dt, spin) = (hertz(), 1e-4, 0.1, 2e-3);
    for (steps, is_mean) in [(1.5, true), (3.0, true), (3.9, true), (4.1, false), (8.0, false)] {
        let mut contact = GrainContact::new(rings(&hertz), 0.0).unwrap();
        let mut law = rings(&hertz);
        let at = |zeta: f64, t: f64| Shift { zeta, omega: spin * t, ..Shift::default() };
        law.advance(at(zeta, 0.0)).unwrap();
        let still = Meeting::on_wall(&grain(1.0 - zeta, 0.0, UP.map(|n| spin * n)), &WALL, 0.5);
        for k in 1..=10 {
            contact.advance(&still, dt).unwrap();
            law.advance(at(zeta, dt * f64::from(k))).unwrap();
        }
        // It rises evenly: gone `steps` after this one.
        let rise = zeta / (steps + 1.0);
        let up = grain(1.0 - zeta + rise, rise / dt, UP.map(|n| spin * n));
        let meeting = Meeting::on_wall(&up, &WALL, 0.5);
        let got = contact.advance(&meeting, dt).unwrap().torques[0][2];
        let mut past = law.clone();
        let past = past.advance(at(zeta - 0.5 * rise, 10.5 * dt)).unwrap().m_z;
        let now = law.advance(at(zeta - rise, 11.0 * dt)).unwrap().m_z;
        let ahead = law.advance(at(zeta - 1.5 * rise, 11.5 * dt)).unwrap().m_z;
        let mean = 0.5 * now + 0.25 * (past + ahead);
        assert!((mean / now - 1.0).abs() > 1e-5, "{mean} {now}");
        let want = if is_mean { mean } else { now };
        assert!((got / -want - 1.0).abs() < 1e-9, "{steps}: {got} {mean} {now}");
    }
}

/// A viscous law forgets by how much its shift led when the bodies part: the next touch is that of a new law.
#[test]
fn a_viscous_law_touches_anew_after_the_bodies_part() {
    let (hertz, zeta) = (hertz(), 1e-4);
    let viscosity = Viscosity::new(0.3).unwrap();
    let new = || ViscousLaw::new(rings(&hertz), viscosity, friction().get(), hertz.stiffness());
    let touch = |law: &mut ViscousLaw<RingLaw>| {
        [0.3, 0.7, 1.0, 0.8].map(|part| {
            let to = Shift { zeta: part * zeta, xi: 0.2 * part * zeta, ..Shift::default() };
            law.advance_at(to, Shift { zeta, xi: 0.2 * zeta, ..Shift::default() }, 0.1).unwrap()
        })
    };
    let (mut law, first) = (new(), touch(&mut new()));
    touch(&mut law);
    let leaving = Shift { zeta: -zeta, xi: 0.5 * zeta, eta: -0.4 * zeta, ..Shift::default() };
    assert_eq!(law.advance_at(Shift::default(), leaving, 0.1).unwrap().f_z, 0.0);
    assert_eq!(touch(&mut law), first);
}
