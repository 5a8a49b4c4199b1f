//! The books of a grain that bounces on a wall, with spin about all axes: kinetic energy, elastic energy and loss are
//! constant.

use carom_drawn::{Congruential, Draw as _};
use carom_laws::coulomb::Tolerance;
use carom_laws::friction::Friction;
use carom_laws::grains::{Grain, GrainContact, Heats, Meeting, Wall};
use carom_laws::law::{ContactLaw, Dissipative, Shift};
use carom_laws::memory::{Fixed, VertexStack};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::turning_law::TurningLaw;

const RADIUS: f64 = 0.005;
const MASS: f64 = 1.3e-3;
const GRAVITY: f64 = 9.81;
const C_Z: f64 = 7.5e5;

/// What the books miss over the energy at the start, after as many steps as 4 to 10 impacts take. `compressed` is the
/// fraction of the approach that is the grain's.
fn missed(law: TurningLaw, steps_in_impact: f64, compressed: f64) -> f64 {
    let stiffness = ContactStiffness::new(0.85 * C_Z, 0.85 * C_Z, C_Z).unwrap();
    let friction = Friction::new(0.3).unwrap();
    let law = ShiftLaw::chosen(law, stiffness, friction, Tolerance::PARTICLES);
    let fresh = GrainContact::<ShiftLaw<[f64; 2], Fixed<[f64; 2], 12>>>::new(law, 0.0).unwrap();
    let wall = Wall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: [0.0; 3] };
    let (place, velocity, spin) =
        ([0.0, 0.0, 1.002 * RADIUS], [0.3, -0.2, -0.5], [60.0, -90.0, 130.0]);
    let mut grain = Grain { place, velocity, spin, radius: RADIUS, mass: MASS };
    let inertia = 0.4 * MASS * RADIUS * RADIUS;
    let energy = |grain: &Grain| {
        let square = |v: [f64; 3]| v.iter().map(|v| v * v).sum::<f64>();
        0.5 * (MASS * square(grain.velocity) + inertia * square(grain.spin))
            + MASS * GRAVITY * grain.place[2]
    };
    let duration = 3.218 * (MASS / C_Z).powf(0.4) / 0.5_f64.powf(0.2);
    let dt = duration / steps_in_impact;
    let (start, mut heats, mut contact) = (energy(&grain), Heats::default(), fresh);
    let (mut force, mut torque) = ([0.0, 0.0, -MASS * GRAVITY], [0.0; 3]);
    let (mut impacts, mut worst) = (0, 0.0_f64);
    for _ in 0..(300.0 * steps_in_impact) as usize {
        for k in 0..3 {
            grain.velocity[k] += 0.5 * dt * force[k] / MASS;
            grain.spin[k] += 0.5 * dt * torque[k] / inertia;
            grain.place[k] += dt * grain.velocity[k];
        }
        (force, torque) = ([0.0, 0.0, -MASS * GRAVITY], [0.0; 3]);
        let meeting = Meeting::on_wall(&grain, &wall, compressed);
        let stored = if meeting.zeta > 0.0 {
            let load = contact.advance_accounted(&meeting, dt, &mut heats).unwrap();
            force = [0, 1, 2].map(|k| force[k] + load.force[k]);
            torque = load.torques[0];
            contact.stored_energy()
        } else {
            impacts += usize::from(contact != fresh);
            contact = fresh;
            0.0
        };
        for k in 0..3 {
            grain.velocity[k] += 0.5 * dt * force[k] / MASS;
            grain.spin[k] += 0.5 * dt * torque[k] / inertia;
        }
        if stored == 0.0 {
            worst = worst.max((energy(&grain) + heats.friction - start).abs() / start);
        }
    }
    assert!(impacts > 3 && heats.friction > 0.01 * start, "{impacts}");
    worst
}

/// Velocities belong to the middle of a step. Where the lever arm of friction is that of its end, the books miss a share
/// of the first order: 7e-6 at 400 steps. Where the merges of a full memory are not booked, they miss 2e-5 at any step
/// with one direction of traction, and 1e-4 at 1600 steps with Coulomb's law.
#[test]
fn books_of_a_spinning_grain_close_to_the_second_order() {
    for (law, compressed) in [(TurningLaw::FixedDirection, 0.3), (TurningLaw::Coulomb, 1.0)] {
        let [coarse, fine] = [100.0, 400.0].map(|steps| missed(law, steps, compressed));
        println!("{law:?}: {coarse:e} {fine:e}");
        assert!(fine < 1.5e-6 && fine < 0.06 * coarse, "{law:?}: {coarse:e} {fine:e}");
    }
}

/// What the work of the force on a drawn path, by small steps and trapezoids, exceeds the stored energy and the summed
/// losses, over the work of all steps.
fn unbalanced<V: carom_laws::memory::Lateral, S: VertexStack<V>>(
    mut law: ShiftLaw<V, S>,
    seed: u64,
    parts: u32,
) -> f64 {
    let mut draw = Congruential(seed);
    let (mut at, mut lost, mut work, mut all) = (Shift::default(), 0.0, 0.0, 0.0);
    let mut load = law.load();
    for _ in 0..25 {
        let eta = if V::DIMENSION > 1 { 0.25 * draw.signed() } else { 0.0 };
        let to =
            Shift { zeta: 0.55 + 0.45 * draw.signed(), xi: 0.25 * draw.signed(), eta, omega: 0.0 };
        for part in 1..=parts {
            let part = f64::from(part) / f64::from(parts);
            let between = |from: f64, to: f64| from + part * (to - from);
            let next = Shift {
                zeta: between(at.zeta, to.zeta),
                xi: between(at.xi, to.xi),
                eta: between(at.eta, to.eta),
                omega: 0.0,
            };
            lost += law.loss(next);
            let before = law.shift();
            let now = law.advance(next).unwrap();
            let step = 0.5 * (load.f_x + now.f_x) * (next.xi - before.xi)
                + 0.5 * (load.f_y + now.f_y) * (next.eta - before.eta)
                + 0.5 * (load.f_z + now.f_z) * (next.zeta - before.zeta);
            (work, all, load) = (work + step, all + step.abs(), now);
        }
        at = to;
    }
    (work - law.stored_energy() - lost).abs() / all
}

#[test]
fn work_is_stored_or_lost_also_in_full_storage() {
    let stiffness = ContactStiffness::new(1.1, 0.8, 1.3).unwrap();
    let turning = |law| {
        ShiftLaw::<[f64; 2], Fixed<[f64; 2], 6>>::chosen(
            law,
            stiffness,
            Friction::new(0.4).unwrap(),
            Tolerance::PARTICLES,
        )
    };
    let in_line = ShiftLaw::<f64, Fixed<f64, 4>>::new(stiffness, Friction::new(0.4).unwrap());
    let sticking = ShiftLaw::<[f64; 2], Fixed<[f64; 2], 4>>::new(stiffness, Friction::INFINITE);
    for seed in 1..4 {
        let missed = [
            unbalanced(turning(TurningLaw::FixedDirection), seed, 60),
            unbalanced(turning(TurningLaw::Coulomb), seed, 60),
            unbalanced(in_line, seed, 60),
            unbalanced(sticking, seed, 60),
        ];
        println!("{seed}: {missed:?}");
        assert!(missed.iter().all(|missed| *missed < 1e-5), "{seed}: {missed:?}");
    }
}
