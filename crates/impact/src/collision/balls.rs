//! Two balls in contact as a code for particles has them: their centres move, and the line of centres turns.

use carom_laws::coulomb::Tolerance;
use carom_laws::grains::{Grain, GrainContact, Meeting};
use carom_laws::shift_law::ShiftLaw;
use carom_special::RangeError;
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::Collision;
use crate::body::Body;
use crate::coupled::TurningLaw;
use crate::motion::Motion;

/// Steps of an elastic impact, in two runs.
pub(super) const STEPS: [usize; 2] = [48, 96];
/// Steps of a contact, at most, over those of an elastic impact.
const PATIENCE: usize = 64;
/// The greatest part of the tangential velocity that its damping takes in a step. The steps are stable below 1.
const DAMPED: f64 = 0.5;
/// The greatest frequency of the tangential motion times the step; the steps are stable below sqrt 3.
const TURNED: f64 = 1.0;
/// The steps are made finer by no more than this.
const FINEST: f64 = 64.0;

/// Two balls in contact.
pub(super) struct Balls<'a> {
    pub(super) collision: &'a Collision,
    pub(super) radii: [f64; 2],
    pub(super) relaxation: f64,
    /// The duration of the elastic impact.
    pub(super) free: f64,
    /// How many times as many steps as [`STEPS`] are taken.
    pub(super) pace: f64,
}

/// What a contact gives beside the motions after it: numbers that combine linearly.
pub(super) type Numbers = [f64; 3];

/// Motions after a contact, what it gave body 1; duration, greatest approach and normal force.
#[derive(Clone, Copy)]
pub(super) struct Followed {
    pub(super) motions: [Motion; 2],
    pub(super) numbers: Numbers,
}

impl Followed {
    /// This one and a part of the way to another one.
    pub(super) fn combined(&self, part: f64, other: &Self) -> Self {
        let sum = |one: &Vector3<f64>, two: &Vector3<f64>| one + part * (two - one);
        let motion = |i: usize| Motion {
            velocity: sum(&self.motions[i].velocity, &other.motions[i].velocity),
            spin: sum(&self.motions[i].spin, &other.motions[i].spin),
        };
        let number = |i: usize| self.numbers[i] + part * (other.numbers[i] - self.numbers[i]);
        Self { motions: [motion(0), motion(1)], numbers: std::array::from_fn(number) }
    }

    pub(super) fn less(&self, other: &Self) -> Self {
        let motion = |i: usize| Motion {
            velocity: self.motions[i].velocity - other.motions[i].velocity,
            spin: self.motions[i].spin - other.motions[i].spin,
        };
        Self {
            motions: [motion(0), motion(1)],
            numbers: std::array::from_fn(|i| self.numbers[i] - other.numbers[i]),
        }
    }
}

/// An instant of a contact, in contact axes that turn with the line of centres.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Moment {
    pub(super) time: f64,
    pub(super) shift: Vector3<f64>,
    pub(super) velocity: Vector3<f64>,
    pub(super) force: Vector3<f64>,
    /// The turn of the axes since the first contact, about an axis of space.
    pub(super) turn: Vector3<f64>,
}

impl Moment {
    /// The sum with a multiple of another one.
    pub(super) fn plus(self, part: f64, other: &Self) -> Self {
        Self {
            time: self.time + part * other.time,
            shift: self.shift + part * other.shift,
            velocity: self.velocity + part * other.velocity,
            force: self.force + part * other.force,
            turn: self.turn + part * other.turn,
        }
    }
}

/// The moment at this share of the duration, straight between those that are known.
pub(super) fn moment_at(moments: &[Moment], share: f64) -> Moment {
    let time = share * moments.last().map_or(0.0, |last| last.time);
    let after = moments.partition_point(|moment| moment.time < time);
    let Some(to) = moments.get(after) else { return moments.last().copied().unwrap_or_default() };
    let Some(from) = after.checked_sub(1).map(|before| &moments[before]) else { return *to };
    let part = (time - from.time) / (to.time - from.time);
    from.plus(part, &to.plus(-1.0, from))
}

impl Balls<'_> {
    /// How many times as many steps as [`STEPS`] the tangential motion of this collision needs to be stable; None if it
    /// cannot be followed.
    ///
    /// The tangential stiffness is c_t sqrt(Z), and the law leads by theta, so that a step takes D_tt c_t sqrt(Z) theta dt
    /// of the velocity. As `Z^(3/2) - zeta^(3/2)` is (3/2) A sqrt(zeta) zeta' while the approach grows, and Z is less than zeta
    /// afterwards, sqrt(Z) theta is at most (3/2) A sqrt(zeta). The impulse of the damping alone, K A zeta^(3/2), is at most
    /// that of the impact, which bounds zeta beside the elastic impact.
    pub(super) fn pace_of(
        collision: &Collision,
        relaxation: f64,
    ) -> Result<Option<f64>, RangeError> {
        let (pulse, stiffness) = (collision.pulse(collision.velocity().z)?, collision.stiffness());
        let d = collision.mobility.matrix();
        let bends = (d.m11 * stiffness.c_x).max(d.m22 * stiffness.c_y);
        let viscous = 2.0 / 3.0 * stiffness.c_z * d.m33 * relaxation / pulse.velocity();
        let root = pulse.maximal_approach().sqrt().min(libm::cbrt(1.0 / viscous));
        let dt = pulse.duration() / STEPS[0] as f64;
        let damped = 1.5 * relaxation * bends * root * dt / DAMPED;
        let turned = (bends * root).sqrt() * dt / TURNED;
        let pace = damped.max(turned).max(1.0);
        Ok((pace <= FINEST).then_some(pace))
    }

    /// The duration of a step of a run.
    pub(super) fn step(&self, steps: usize) -> f64 {
        self.free / (self.pace * steps as f64)
    }

    fn contact(&self) -> Result<GrainContact, RangeError> {
        // The cheapest law: only the change by the turn is taken from it.
        let (stiffness, law) = (self.collision.stiffness(), TurningLaw::FixedDirection);
        let law = match self.collision.static_friction {
            Some(friction) => {
                ShiftLaw::with_static_friction(law, stiffness, friction, Tolerance::default())
            }
            None => ShiftLaw::with_fixed_direction(stiffness, self.collision.friction),
        };
        GrainContact::new(law, self.relaxation)
    }

    /// The contact in leapfrog steps, with radii `scale` times as large and spins as much slower, so that all velocities
    /// and mobilities at the contact are the same. `observe` sees each step: its share before separation, the bodies at its
    /// end with their velocities in its middle, and the force at its end.
    pub(super) fn followed(
        &self,
        scale: f64,
        dt: f64,
        mut observe: impl FnMut(f64, &Meeting, Vector3<f64>),
    ) -> Result<Followed, RangeError> {
        let collision = self.collision;
        let bodies = &collision.bodies;
        let mut grains = [0, 1].map(|i| self.grain(i, scale));
        let inverse = bodies.each_ref().map(|body| body.inertia().inverse_mass());
        let tensors: [Matrix3<f64>; 2] =
            [0, 1].map(|i| collision.levers[i].inverse_tensor() / (scale * scale));
        let mut contact = self.contact()?;
        let mut has_touched = false;
        let (mut loads, mut greatest, mut deepest, mut steps) = ([0.0; 2], 0.0, 0.0, 0.0);
        for _ in 0..(self.pace * (PATIENCE * STEPS[1]) as f64) as usize {
            for grain in &mut grains {
                for k in 0..3 {
                    grain.place[k] += dt * grain.velocity[k];
                }
            }
            let meeting = Meeting::of_spheres(&grains[0], &grains[1], [0.5; 2])?;
            let load = contact.advance(&meeting, dt)?;
            let force = Vector3::from(load.force);
            if force == Vector3::zeros() && has_touched {
                let part = left(loads);
                observe(part, &meeting, force);
                steps += part;
                break;
            }
            observe(1.0, &meeting, force);
            steps += 1.0;
            has_touched |= force != Vector3::zeros();
            loads = [loads[1], force.dot(&Vector3::from(meeting.normal))];
            greatest = loads[1].max(greatest);
            deepest = meeting.zeta.max(deepest);
            for (i, sign) in [1.0, -1.0].into_iter().enumerate() {
                let velocity = Vector3::from(grains[i].velocity) + force * (sign * dt * inverse[i]);
                let turn = tensors[i] * Vector3::from(load.torques[i]) * dt;
                grains[i].velocity = velocity.into();
                grains[i].spin = (Vector3::from(grains[i].spin) + turn).into();
            }
        }
        let motions = grains.map(|grain| Motion {
            velocity: grain.velocity.into(),
            spin: Vector3::from(grain.spin) * scale,
        });
        Ok(Followed { motions, numbers: [steps * dt, deepest, greatest] })
    }

    /// The moments of the same contact.
    pub(super) fn moments(&self, scale: f64, dt: f64) -> Result<Vec<Moment>, RangeError> {
        let first = *self.collision.frame().axes();
        let z = self.collision.frame().z();
        let mut moments = vec![Moment { velocity: self.collision.velocity(), ..Moment::default() }];
        let observe = |part: f64, meeting: &Meeting, force: Vector3<f64>| {
            let before = moments.last().copied().unwrap_or_default();
            let normal = Vector3::from(meeting.normal);
            let turn = Rotation3::rotation_between(&z, &normal).unwrap_or_default();
            let axes = turn * first;
            let [one, two] = meeting.spins.map(Vector3::from);
            let arms = self.radii.map(|radius| scale * radius);
            let slip = (one * arms[0] + two * arms[1]).cross(&normal);
            // The velocity in the middle of the step.
            let velocity = axes.tr_mul(&(Vector3::from(meeting.velocity) + slip));
            let mut shift = before.shift + part * dt * velocity;
            shift.z = before.shift.z + part * (meeting.zeta - before.shift.z);
            moments.push(Moment {
                time: before.time + part * dt,
                shift,
                velocity,
                force: axes.tr_mul(&force),
                turn: before.turn + part * (turn.scaled_axis() - before.turn),
            });
        };
        self.followed(scale, dt, observe)?;
        for k in 1..moments.len() - 1 {
            moments[k].velocity = 0.5 * (moments[k].velocity + moments[k + 1].velocity);
        }
        Ok(moments)
    }

    // Body 2 lies at the origin.
    fn grain(&self, i: usize, scale: f64) -> Grain {
        let body: &Body = &self.collision.bodies[i];
        let [one, two] = self.radii;
        let away = if i == 0 { scale * (one + two) } else { 0.0 };
        Grain {
            place: (self.collision.frame().z() * away).into(),
            velocity: body.motion().velocity.into(),
            spin: (body.motion().spin / scale).into(),
            radius: scale * self.radii[i],
            mass: body.inertia().mass(),
        }
    }
}

/// The share of the step after two normal forces in which the contact ends: its 2/3rd power falls evenly.
fn left(loads: [f64; 2]) -> f64 {
    let [before, last] = loads.map(|load| libm::cbrt(load).powi(2));
    if before > last { (last / (before - last)).min(1.0) } else { 0.5 }
}
