//! Impacts of spheres of like materials: restitution, energy, momentum and Coulomb's limit.

use carom_drawn::{Draw as _, Splitmix};
use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, NormalRestitution, Rebound};
use carom_laws::friction::Friction;
use nalgebra::Vector3;

use crate::Done;
use crate::draw::{of_case, power};
use crate::worst::Worst;

/// Allowed rounding, relative.
const ROUNDING: f64 = 1e-12;

/// Two spheres that meet at the origin; body 1 lies along the normal.
struct Meeting {
    normal: Vector3<f64>,
    radii: [f64; 2],
    masses: [f64; 2],
    motions: [Motion; 2],
    friction: f64,
    poisson: f64,
    restitution: f64,
}

pub(crate) fn run(count: u64, seed: u64) -> Done {
    let mut worst = Worst::default();
    for seed in seed..seed + count {
        check(seed, &mut worst).map_err(|error| format!("--seed {seed} --count 1: {error}"))?;
    }
    Ok(worst)
}

fn check(seed: u64, worst: &mut Worst) -> Result<(), String> {
    let meeting = Meeting::drawn(&mut of_case(seed))?;
    let Some(rebound) = meeting.rebound()? else {
        return Err("bodies that approach do not collide".to_owned());
    };
    meeting.normal_motion(&rebound, worst)?;
    meeting.kept(&rebound, worst)?;
    meeting.limit(&rebound, worst)
}

impl Meeting {
    fn drawn(draw: &mut Splitmix) -> Result<Self, String> {
        let normal = direction(draw);
        let radii = [(); 2].map(|()| power(draw, -3.0, 0.0));
        let masses = [(); 2].map(|()| power(draw, -3.0, 3.0));
        let approach = power(draw, -3.0, 2.0);
        let parts: [Vector3<f64>; 4] = std::array::from_fn(|_| part(draw));
        let along = |v: Vector3<f64>| v - normal * v.dot(&normal);
        let motion = |v: Vector3<f64>, w: Vector3<f64>| {
            Motion::new(v.into(), w.into()).map_err(|error| error.to_string())
        };
        let motions = [
            motion(along(parts[0]) - normal * approach, parts[1] / radii[0])?,
            motion(along(parts[2]), parts[3] / radii[1])?,
        ];
        let friction = match draw.pick(&[0, 1, 2, 2, 2, 2, 3, 3]) {
            0 => 0.0,
            1 => f64::INFINITY,
            2 => draw.part(),
            _ => power(draw, -6.0, 3.0),
        };
        let restitution = if draw.part() < 0.5 { 1.0 } else { draw.part() };
        let poisson = draw.between(-0.5, 0.5);
        Ok(Self { normal, radii, masses, motions, friction, poisson, restitution })
    }

    fn rebound(&self) -> Result<Option<Rebound>, String> {
        let told = |error: &dyn std::fmt::Display| error.to_string();
        let material = Material::from_shear(1e9, self.poisson).map_err(|e| told(&e))?;
        let body = |i: usize| {
            let body = Body::sphere(self.radii[i], material, self.masses[i]);
            body.map(|body| body.moving(self.motions[i])).map_err(|e| told(&e))
        };
        let friction = Friction::new(self.friction).map_err(|e| told(&e))?;
        let mut collision = Collision::along(body(0)?, body(1)?, self.normal.into(), friction)
            .map_err(|e| told(&e))?;
        if self.restitution < 1.0 {
            let restitution = NormalRestitution::new(self.restitution).map_err(|e| told(&e))?;
            collision = collision.with_normal_restitution(restitution);
        }
        Ok(collision.solve().map_err(|e| told(&e))?.rebound().cloned())
    }

    /// The greatest velocities that are about: roundings are measured against them.
    fn speed(&self) -> f64 {
        let of = |i: usize| {
            self.motions[i].velocity.norm() + self.motions[i].spin.norm() * self.radii[i]
        };
        of(0) + of(1)
    }

    /// The bodies part with the given restitution.
    fn normal_motion(&self, rebound: &Rebound, worst: &mut Worst) -> Result<(), String> {
        let [before, after] = [rebound.contact_velocity_before, rebound.contact_velocity_after]
            .map(|velocity| velocity.dot(&self.normal));
        let off = (after + self.restitution * before).abs() / self.speed();
        worst.check("normal_restitution_off", off, ROUNDING)
    }

    /// Momentum, angular momentum about the contact, and energy.
    fn kept(&self, rebound: &Rebound, worst: &mut Worst) -> Result<(), String> {
        let [before, after] = [&self.motions, &rebound.motions];
        let moment = |i: usize| 0.4 * self.masses[i] * self.radii[i] * self.radii[i];
        let arm = |i: usize| self.normal * if i == 0 { self.radii[0] } else { -self.radii[1] };
        let momentum = |m: &[Motion; 2], i: usize| m[i].velocity * self.masses[i];
        let angular =
            |m: &[Motion; 2], i: usize| arm(i).cross(&momentum(m, i)) + m[i].spin * moment(i);
        let energy = |m: &[Motion; 2], i: usize| {
            0.5 * (self.masses[i] * m[i].velocity.norm_squared()
                + moment(i) * m[i].spin.norm_squared())
        };
        // Rounding is that of the terms, which may cancel.
        let size = |m: &[Motion; 2], i: usize| momentum(m, i).norm();
        let turning =
            |m: &[Motion; 2], i: usize| self.radii[i] * size(m, i) + moment(i) * m[i].spin.norm();
        let all = |of: &dyn Fn(&[Motion; 2], usize) -> f64| {
            let each = [before, after].into_iter().flat_map(|m| [of(m, 0), of(m, 1)]);
            each.fold(f64::MIN_POSITIVE, f64::max)
        };
        let lost = |of: &dyn Fn(&[Motion; 2], usize) -> Vector3<f64>| {
            (of(before, 0) + of(before, 1) - of(after, 0) - of(after, 1)).norm()
        };
        worst.check("momentum_off", lost(&momentum) / all(&size), ROUNDING)?;
        worst.check("angular_momentum_off", lost(&angular) / all(&turning), ROUNDING)?;
        let [had, has] = [before, after].map(|m| energy(m, 0) + energy(m, 1));
        worst.check("energy_gained", has / had - 1.0, ROUNDING)?;
        let budget = rebound.energy;
        let off = (had - has - budget.dissipated - budget.lost).abs() / had;
        worst.check("energy_budget_off", off, ROUNDING)
    }

    /// The impulse presses, within Coulomb's limit.
    fn limit(&self, rebound: &Rebound, worst: &mut Worst) -> Result<(), String> {
        let normal = rebound.impulse.dot(&self.normal);
        let tangential = (rebound.impulse - self.normal * normal).norm();
        worst.check("pull", -normal, 0.0)?;
        if self.friction == f64::INFINITY {
            return Ok(());
        }
        // The rotation of the frame rounds, too.
        let excess = (tangential - self.friction * normal) / (tangential + normal);
        worst.check("impulse_above_limit", excess, ROUNDING)
    }
}

fn direction(draw: &mut Splitmix) -> Vector3<f64> {
    loop {
        let v = Vector3::from_fn(|_, _| draw.signed());
        if v.norm() > 0.1 && v.norm() < 1.0 {
            return v.normalize();
        }
    }
}

/// A part of a motion: nothing, or of a size over many decades.
fn part(draw: &mut Splitmix) -> Vector3<f64> {
    match draw.pick(&[0, 1, 1, 1, 2]) {
        0 => Vector3::zeros(),
        1 => Vector3::from_fn(|_, _| draw.signed()),
        _ => direction(draw) * power(draw, -30.0, 1.0),
    }
}
