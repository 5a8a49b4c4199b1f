//! Calls of impacts and restitution.

use std::mem::{size_of, zeroed};
use std::ptr::null;

use carom_capi::*;

use super::super::world::{GLASS, World};
use super::answers::told;

pub(super) fn restitution(world: &mut World, which: usize) -> CaromStatus {
    let kappa = [world.number(0.75, 1.5), world.number(0.75, 1.5)];
    let (lambda, method, error) = (world.number(0.0, 9.0), world.pick(3) as u32, world.error());
    let (mut answer, stride, e) = ([0.0; 2], world.pick(17), world.number(0.0, 1.0));
    let to = world.point(answer.as_mut_ptr());
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe {
        match which {
            5 => carom_restitution(kappa[0], lambda, e, method, to, error),
            _ => {
                let stride = if stride > 8 { 8 } else { stride };
                let kappa = kappa.as_ptr();
                carom_restitution_many(2, kappa, 8, &lambda, 0, e, method, to, stride, error)
            }
        }
    };
    told(world, status, which, &answer)
}

pub(super) fn dissimilar(world: &mut World) -> CaromStatus {
    let (kappa, gamma) = (world.number(0.75, 1.5), world.number(-0.2, 0.2));
    let (friction, lambda) = (world.number(0.05, 1.0), world.number(0.0, 7.0));
    let (ratio, error) = (world.number(1.0, 6.0), world.error());
    let (mut answer, mut estimate, mut method) = (0.0, 0.0, 0);
    let (to, method) = (world.point(&raw mut answer), world.point(&raw mut method));
    let estimate = world.point(&raw mut estimate);
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    unsafe {
        carom_restitution_dissimilar(
            kappa, gamma, friction, lambda, ratio, to, estimate, method, error,
        )
    }
}

pub(super) fn body(world: &mut World) -> CaromBody {
    // SAFETY: zeros are a solid sphere at rest.
    let mut body: CaromBody = unsafe { zeroed() };
    (body.shape, body.hollow) = (world.pick(8) as u32, (world.pick(9) / 8) as u32);
    body.sizes = std::array::from_fn(|_| world.number(0.01, 0.03));
    (body.mass, body.material) = (world.number(0.1, 1.0), GLASS);
    (body.velocity, body.spin, body.centre) =
        (world.vector(2.0), world.vector(20.0), world.vector(0.02));
    if world.chance(0.3) {
        body.attitude = std::array::from_fn(|_| world.number(-1.0, 1.0));
    }
    body
}

pub(super) fn collide(world: &mut World) -> CaromStatus {
    let ([mut one, mut two], friction) = ([body(world), body(world)], world.number(0.0, 1.0));
    // Spheres and planes, but for a few: others take their time.
    if world.chance(0.9) {
        (one.shape, two.shape) = (CAROM_SHAPE_SPHERE, world.pick(2) as u32);
    }
    let normal = world.vector(1.0);
    let by = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    let normal = if world.chance(0.1) { normal } else { normal.map(|x| x / by) };
    let normal = if world.chance(0.1) { null() } else { normal.as_ptr() };
    let (mut rebound, error) = (CaromRebound::default(), world.error());
    let [one, two] = [world.point(&raw mut one), world.point(&raw mut two)];
    let size = [0, 8, 40, size_of::<CaromCollideOptions>()][world.pick(12).min(3)];
    let options = CaromCollideOptions {
        size,
        law: [0, 0, 0, 1, 2, 4][world.pick(6)],
        loss: world.pick(5) as u32,
        normal_restitution: world.number(0.0, 1.0),
        tolerance: if world.chance(0.8) { 0.0 } else { world.number(1e-4, 1e-2) },
        torsion: [0, 0, 1, 2, 3][world.pick(5)],
        relaxation: world.number(0.0, 1e-5),
        static_friction: if world.chance(0.8) { 0.0 } else { world.number(0.0, 1.0) },
        slip_friction_b: if world.chance(0.8) { 0.0 } else { world.number(-0.3, 1.0) },
        slip_friction_c: world.number(0.0, 2.0),
    };
    let options = if world.chance(0.5) { null() } else { &raw const options };
    // SAFETY: each pointer is null, misaligned or that of something that may be written, and none twice.
    let status = unsafe { carom_collide(one, two, friction, normal, options, &mut rebound, error) };
    let vectors = [
        rebound.body_1_velocity,
        rebound.body_1_spin,
        rebound.body_2_velocity,
        rebound.body_2_spin,
        rebound.impulse,
    ];
    let vectors = vectors.as_flattened().iter().sum();
    let energies = rebound.energy_after + rebound.energy_dissipated + rebound.energy_lost;
    told(world, status, 38, &[vectors, energies, rebound.duration, rebound.R_x])
}
