//! Glancing impacts of two balls: their line of centres turns while they touch.
//!
//! The theory of impact keeps the contact axes. Two balls of radii R_1, R_2 that meet with a tangential velocity v_t of
//! their centres turn their line of centres by about `v_t T/(R_1 + R_2)` during the contact, T its duration, which changes
//! the normal velocity by that part of v_t (P. Mueller and T. Poeschel, Granular Matter 14, 115 (2012)). From an
//! angle of .007 on the same contact is followed with the centres moving, and with the axes kept; a growing part of the
//! difference, from .012 on all of it, is added to the rebound, whatever the method that found it. What is left out counts in
//! the estimate. Nothing jumps.

use carom_laws::coulomb::Tolerance;
use carom_laws::grains::{Grain, GrainContact, Heats, Meeting};
use carom_laws::shift_law::ShiftLaw;
use carom_special::RangeError;
use nalgebra::{Matrix3, Vector3};

use super::{Collision, CollisionError, velocity_at};
use crate::body::Body;
use crate::coupled::TurningLaw;
use crate::motion::Motion;
use crate::outcome::Rebound;
use crate::viscoelastic::ViscousLoss;
use crate::warning::Warning;

/// Angles of the turn from which it counts in part, and as a whole.
const ANGLES: [f64; 2] = [7e-3, 1.2e-2];
/// With radii this many times as large the axes are as good as kept.
const KEPT: f64 = 64.0;
/// Steps of an elastic impact, in two runs.
const STEPS: [usize; 2] = [48, 96];
/// Steps of a contact, at most, over those of an elastic impact.
const PATIENCE: usize = 64;
/// The share of the change that may be wrong: the contact law of the change neglects coupling and spin about the normal.
const LEFT: f64 = 0.03;

/// Two balls in contact, as a code for particles has them.
struct Balls<'a> {
    collision: &'a Collision,
    radii: [f64; 2],
    relaxation: f64,
}

/// Motions after a contact, what it gave body 1, and heats.
#[derive(Clone, Copy)]
struct Followed {
    motions: [Motion; 2],
    impulse: Vector3<f64>,
    friction_heat: f64,
}

impl Followed {
    fn combined(&self, part: f64, other: &Self) -> Self {
        let sum = |one: &Vector3<f64>, two: &Vector3<f64>| one + part * (two - one);
        let motion = |i: usize| Motion {
            velocity: sum(&self.motions[i].velocity, &other.motions[i].velocity),
            spin: sum(&self.motions[i].spin, &other.motions[i].spin),
        };
        Self {
            motions: [motion(0), motion(1)],
            impulse: sum(&self.impulse, &other.impulse),
            friction_heat: self.friction_heat + part * (other.friction_heat - self.friction_heat),
        }
    }

    fn less(&self, other: &Self) -> Self {
        let zero = self.combined(1.0, self);
        let motion = |i: usize| Motion {
            velocity: zero.motions[i].velocity - other.motions[i].velocity,
            spin: zero.motions[i].spin - other.motions[i].spin,
        };
        Self {
            motions: [motion(0), motion(1)],
            impulse: self.impulse - other.impulse,
            friction_heat: self.friction_heat - other.friction_heat,
        }
    }
}

/// What the contact axes of two balls do during an impact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Axes {
    /// They turn with the line of centres.
    #[default]
    Turning,
    /// They are kept, as in the theory.
    Kept,
}

impl Collision {
    /// The same collision of two balls by the theory, which keeps the contact axes and counts no turn of the line of
    /// centres, not in the estimate either. Other bodies are always solved so.
    ///
    /// ```
    /// use carom_halfspace::Material;
    /// use carom_impact::{Body, Collision, Motion};
    /// use carom_laws::friction::Friction;
    /// let soft = Material::from_young(1e7, 0.3)?;
    /// let ball = Body::sphere(4.5e-3, soft, 9.5e-4)?;
    /// let comes = ball.clone().moving(Motion::new([0.48, 0.0, -0.13], [0.0; 3])?);
    /// let glancing = Collision::new(comes, ball, Friction::NONE)?;
    /// let speed = |collision: &Collision| -> Result<f64, Box<dyn std::error::Error>> {
    ///     let outcome = collision.solve()?;
    ///     Ok(outcome.motions()[0].velocity.z - outcome.motions()[1].velocity.z)
    /// };
    /// assert!((speed(&glancing.clone().keeping_axes())? - 0.13).abs() < 1e-12);
    /// assert!(speed(&glancing)? < 0.1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn keeping_axes(self) -> Self {
        Self { axes: Axes::Kept, ..self }
    }

    /// The angle by which the line of centres of two balls turns in this time; 0 for other bodies.
    pub(super) fn turn_of_centres(&self, duration: f64) -> f64 {
        let Some([one, two]) = self.radii() else { return 0.0 };
        let apart = self.bodies[1].motion().velocity - self.bodies[0].motion().velocity;
        let z = self.frame().z();
        (apart - z * apart.dot(&z)).norm() * duration / (one + two)
    }

    fn radii(&self) -> Option<[f64; 2]> {
        let radii = [self.bodies[0].height()?, self.bodies[1].height()?];
        radii.iter().all(|radius| *radius > 0.0).then_some(radii)
    }

    /// A rebound with axes that turn with the centres, from that with axes that are kept; warns if the given tolerance is
    /// missed by what this leaves out.
    pub(super) fn with_turning_centres(&self, rebound: Rebound) -> Result<Rebound, CollisionError> {
        let mut turned = self.turned(rebound)?;
        let is_told = |warning: &Warning| matches!(warning, Warning::NotSettled { .. });
        if !turned.warnings.iter().any(is_told) {
            turned.warnings.extend(self.missed_tolerance(turned.error_estimate));
        }
        Ok(turned)
    }

    fn turned(&self, rebound: Rebound) -> Result<Rebound, CollisionError> {
        let angle = self.turn_of_centres(rebound.duration);
        let counts = self.axes == Axes::Turning && angle > 0.0;
        let Some(radii) = self.radii().filter(|_| counts) else { return Ok(rebound) };
        let part = ((angle - ANGLES[0]) / (ANGLES[1] - ANGLES[0])).clamp(0.0, 1.0);
        // What is left out of the normal velocity: v_t^2 T/(R_1 + R_2).
        let across = angle * (radii[0] + radii[1]) / rebound.duration;
        let mut rebound = rebound;
        rebound.error_estimate += (1.0 - part) * angle * across / self.velocity().norm();
        if part == 0.0 {
            return Ok(rebound);
        }
        let pulse = self.pulse(self.velocity().z)?;
        let loss = self.normal_restitution.viscous(self.wave_share(&pulse), &pulse)?;
        let unit = pulse.time_unit() * libm::pow(1.25, -0.4);
        // What the turn changes is taken as in a Kelvin-Voigt material of the same restitution.
        let loss = loss.map(|loss| ViscousLoss::of_restitution(loss.restitution())).transpose()?;
        let relaxation = loss.map_or(0.0, |loss| unit * loss.relaxation());
        let balls = Balls { collision: self, radii, relaxation };
        let dt = pulse.duration();
        let change = |steps: usize| -> Result<Followed, RangeError> {
            let dt = dt / steps as f64;
            Ok(balls.followed(1.0, dt)?.less(&balls.followed(KEPT, dt)?))
        };
        let [coarse, fine] = STEPS.map(change);
        let (Ok(coarse), Ok(fine)) = (coarse, fine) else {
            // Sizes beyond those of particles: the turn is left out, and counts.
            rebound.error_estimate += part * angle * across / self.velocity().norm();
            return Ok(rebound);
        };
        // With large radii the axes turn by a 64th.
        let limit = coarse.combined(4.0 / 3.0, &fine);
        let spread = self.contact_velocity(&fine.motions) - self.contact_velocity(&coarse.motions);
        let part = part * KEPT / (KEPT - 1.0) * self.normal_restitution.part_of_yield();
        Ok(self.changed(rebound, (&limit, part), spread.norm()))
    }

    /// The velocity of body 2 against body 1 at the first contact point.
    fn contact_velocity(&self, motions: &[Motion; 2]) -> Vector3<f64> {
        velocity_at(motions, &self.levers, self.frame())
    }

    fn changed(&self, mut next: Rebound, (change, part): (&Followed, f64), spread: f64) -> Rebound {
        // The spin about the first normal is left to the torsional impact.
        let z = self.frame().z();
        for (motion, by) in next.motions.iter_mut().zip(&change.motions) {
            motion.velocity += part * by.velocity;
            motion.spin += part * (by.spin - z * by.spin.dot(&z));
        }
        next.impulse += part * change.impulse;
        self.book(&mut next, part * change.friction_heat);
        let after = self.contact_velocity(&next.motions);
        let before = self.velocity();
        next.contact_velocity_after = self.frame().to_space(&after);
        if next.r_x.is_some() {
            next.r_x = super::aftermath::along(&before, &after).or(next.r_x);
        }
        let size = self.contact_velocity(&change.motions).norm();
        next.error_estimate += (spread + LEFT * size) / before.norm();
        next
    }

    /// Energies after a change of the motions; without any loss the relative speed is that which keeps the energy.
    fn book(&self, rebound: &mut Rebound, friction_heat: f64) {
        let kinetic = |motions: &[Motion; 2]| {
            self.bodies[0].kinetic_energy(&motions[0]) + self.bodies[1].kinetic_energy(&motions[1])
        };
        let free = self.bodies.iter().all(|body| body.inertia().mass().is_finite());
        let is_elastic = rebound.energy.lost == 0.0;
        let mut lost = rebound.energy.before - kinetic(&rebound.motions);
        let keeps = is_elastic && self.friction.get() == 0.0;
        if free && (keeps || lost < 0.0) {
            self.scale_to(&mut rebound.motions, lost);
            lost = 0.0;
        }
        rebound.energy.after = kinetic(&rebound.motions);
        if !free {
            return;
        }
        let heat = (rebound.energy.dissipated + friction_heat).clamp(0.0, lost);
        rebound.energy.dissipated = if is_elastic { lost } else { heat };
        rebound.energy.lost = lost - rebound.energy.dissipated;
    }

    // Adds an energy to the motion of the centres against each other.
    fn scale_to(&self, motions: &mut [Motion; 2], missing: f64) {
        let masses = self.bodies.each_ref().map(|body| body.inertia().mass());
        let whole = masses[0] + masses[1];
        let middle = (masses[0] * motions[0].velocity + masses[1] * motions[1].velocity) / whole;
        let apart = motions[1].velocity - motions[0].velocity;
        let energy = 0.5 * masses[0] * masses[1] / whole * apart.norm_squared();
        let part = (1.0 + missing / energy).max(0.0).sqrt();
        for motion in motions {
            motion.velocity = middle + part * (motion.velocity - middle);
        }
    }
}

impl Balls<'_> {
    fn contact(&self) -> Result<GrainContact, RangeError> {
        // The cheapest law: only the change by the turn is taken from it.
        let (stiffness, law) = (self.collision.hertz.stiffness(), TurningLaw::FixedDirection);
        let law = match self.collision.static_friction {
            Some(friction) => {
                ShiftLaw::with_static_friction(law, stiffness, friction, Tolerance::default())
            }
            None => ShiftLaw::with_fixed_direction(stiffness, self.collision.friction),
        };
        GrainContact::new(law, self.relaxation)
    }

    /// The contact in leapfrog steps, with radii `scale` times as large and spins as much slower, so that all velocities
    /// and mobilities at the contact are the same.
    fn followed(&self, scale: f64, dt: f64) -> Result<Followed, RangeError> {
        let collision = self.collision;
        let bodies = &collision.bodies;
        let mut grains = [0, 1].map(|i| self.grain(i, scale));
        let inverse = bodies.each_ref().map(|body| body.inertia().inverse_mass());
        let tensors: [Matrix3<f64>; 2] =
            [0, 1].map(|i| collision.levers[i].inverse_tensor() / (scale * scale));
        let mut contact = self.contact()?;
        let (mut impulse, mut heats) = (Vector3::zeros(), Heats::default());
        for _ in 0..PATIENCE * STEPS[1] {
            for grain in &mut grains {
                for k in 0..3 {
                    grain.place[k] += dt * grain.velocity[k];
                }
            }
            let meeting = Meeting::of_spheres(&grains[0], &grains[1], [0.5; 2])?;
            // Without a loss of the material the balance of energies tells the heat.
            let load = match self.relaxation > 0.0 {
                true => contact.advance_accounted(&meeting, dt, &mut heats)?,
                false => contact.advance(&meeting, dt)?,
            };
            if meeting.is_apart() && impulse != Vector3::zeros() {
                break;
            }
            let force = Vector3::from(load.force);
            impulse += dt * force;
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
        Ok(Followed { motions, impulse, friction_heat: heats.friction })
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
