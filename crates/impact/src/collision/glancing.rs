//! Glancing impacts of two balls: their line of centres turns while they touch.
//!
//! The theory of impact keeps the contact axes. Two balls of radii R_1, R_2 that meet with a tangential velocity v_t of
//! their centres turn their line of centres by about `v_t T/(R_1 + R_2)` during the contact, T its duration, which changes
//! the normal velocity by that part of v_t (P. Mueller and T. Poeschel, Granular Matter 14, 115 (2012)). From an
//! angle of .007 on the same contact is followed with the centres moving, and with the axes kept; a growing part of the
//! difference, from .012 on all of it, is added to the rebound, whatever the method that found it. What is left out counts in
//! the estimate. Nothing jumps.

use carom_special::RangeError;
use nalgebra::{Rotation3, Vector3};

use super::balls::{Balls, Followed, Moment, STEPS, moment_at};
use super::{Collision, CollisionError, velocity_at};
use crate::motion::Motion;
use crate::outcome::{EnergyBudget, HistoryPoint, Rebound};
use crate::viscoelastic::ViscousLoss;
use crate::warning::Warning;

/// Angles of the turn from which it counts in part, and as a whole.
const ANGLES: [f64; 2] = [7e-3, 1.2e-2];
/// With radii this many times as large the axes are as good as kept.
const KEPT: f64 = 64.0;
/// What the axes turn in a contact over how much more than with large radii.
const WHOLE: f64 = KEPT / (KEPT - 1.0);
/// The share of the change that may be wrong: the contact law of the change neglects coupling and spin about the normal.
const LEFT: f64 = 0.03;

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

    fn turned(&self, mut rebound: Rebound) -> Result<Rebound, CollisionError> {
        let angle = self.turn_of_centres(rebound.duration);
        let part = self.part_of_turn(rebound.duration);
        let Some(radii) = self.radii().filter(|_| self.axes == Axes::Turning) else {
            return Ok(rebound);
        };
        // What is left out of the normal velocity: v_t^2 T/(R_1 + R_2).
        let across = angle * (radii[0] + radii[1]) / rebound.duration;
        let whole = angle * across / self.velocity().norm();
        rebound.error_estimate += (1.0 - part) * whole;
        if part == 0.0 {
            return Ok(rebound);
        }
        let changes = self.balls(radii)?.map(|balls| {
            STEPS.map(|steps| {
                let run = |scale| balls.followed(scale, balls.step(steps), |_, _, _| ());
                Ok::<_, RangeError>(run(1.0)?.less(&run(KEPT)?))
            })
        });
        let Some([Ok(coarse), Ok(fine)]) = changes else {
            // Sizes beyond those of particles: the turn is left out, and counts.
            rebound.error_estimate += part * whole;
            return Ok(rebound);
        };
        let limit = coarse.combined(4.0 / 3.0, &fine);
        let spread = self.contact_velocity(&fine.motions) - self.contact_velocity(&coarse.motions);
        self.changed(rebound, (&limit, part * WHOLE), spread.norm())
    }

    /// Whether the line of centres turns enough in this time that it counts.
    pub(super) fn turns_centres(&self, duration: f64) -> bool {
        self.radii().is_some() && self.part_of_turn(duration) > 0.0
    }

    /// How much of the turn in this time counts, from 0 to 1.
    fn part_of_turn(&self, duration: f64) -> f64 {
        let angle = self.turn_of_centres(duration);
        match self.axes {
            Axes::Turning => ((angle - ANGLES[0]) / (ANGLES[1] - ANGLES[0])).clamp(0.0, 1.0),
            Axes::Kept => 0.0,
        }
    }

    /// The contact whose axes turn; what the turn changes is taken as in a Kelvin-Voigt material of the same restitution.
    /// None if balls would pass through each other, or the contact bends too fast to be followed.
    fn balls(&self, radii: [f64; 2]) -> Result<Option<Balls<'_>>, RangeError> {
        let speed = self.velocity().z;
        let pulse = self.pulse(speed)?;
        let unit = pulse.time_unit() * libm::pow(1.25, -0.4);
        let loss = self.viscous_loss(speed)?;
        let loss = loss.map(|loss| ViscousLoss::of_restitution(loss.restitution())).transpose()?;
        let relaxation = loss.map_or(0.0, |loss| unit * loss.relaxation());
        let is_shallow = pulse.maximal_approach() < radii[0] + radii[1];
        let pace = Balls::pace_of(self, relaxation)?.filter(|_| is_shallow);
        let free = pulse.duration();
        Ok(pace.map(|pace| Balls { collision: self, radii, relaxation, free, pace }))
    }

    /// A history in axes that turn with the centres, from that with axes that are kept.
    pub(super) fn in_turning_axes(
        &self,
        points: Vec<HistoryPoint>,
    ) -> Result<Vec<HistoryPoint>, CollisionError> {
        let duration = points.last().map_or(0.0, |last| last.time);
        let part = self.part_of_turn(duration);
        let Some(radii) = self.radii().filter(|_| part > 0.0) else { return Ok(points) };
        let courses = self.balls(radii)?.map(|balls| {
            STEPS.map(|steps| [1.0, KEPT].map(|scale| balls.moments(scale, balls.step(steps))))
        });
        let Some([[Ok(one), Ok(two)], [Ok(three), Ok(four)]]) = courses else {
            // Sizes beyond those of particles.
            return Ok(points);
        };
        let change = |share: f64| {
            let [one, two, three, four] =
                [&one, &two, &three, &four].map(|moments| moment_at(moments, share));
            let (coarse, fine) = (one.plus(-1.0, &two), three.plus(-1.0, &four));
            coarse.plus(4.0 / 3.0, &fine.plus(-1.0, &coarse))
        };
        let turned = |point: HistoryPoint| {
            let change = change(point.time / duration);
            self.moved(point, &Moment::default().plus(part * WHOLE, &change))
        };
        points.into_iter().map(turned).collect()
    }

    fn moved(
        &self,
        mut point: HistoryPoint,
        change: &Moment,
    ) -> Result<HistoryPoint, CollisionError> {
        point.time += change.time;
        point.shift += change.shift;
        point.velocity += change.velocity;
        point.force += change.force;
        point.shift.z = point.shift.z.max(0.0);
        point.force.z = point.force.z.max(0.0);
        let friction = self.static_friction.map_or(self.friction, |both| both.threshold());
        let (pull, limit) = (point.force.xy().norm(), friction.get() * point.force.z);
        if pull > limit {
            point.force.x *= limit / pull;
            point.force.y *= limit / pull;
        }
        point.semi_axes = self.semi_axes(point.shift.z)?;
        point.stick_radius = point.stick_radius.map(|radius| radius.min(point.semi_axes[0]));
        point.normal = Rotation3::new(change.turn) * self.frame().z();
        Ok(point)
    }

    /// The velocity of body 2 against body 1 at the first contact point.
    fn contact_velocity(&self, motions: &[Motion; 2]) -> Vector3<f64> {
        velocity_at(motions, &self.levers, self.frame())
    }

    fn changed(
        &self,
        mut next: Rebound,
        (change, whole): (&Followed, f64),
        spread: f64,
    ) -> Result<Rebound, CollisionError> {
        let [duration, approach, force] = change.numbers.map(|number| whole * number);
        next.duration += duration;
        let pressed = next.maximal_contact.peak_pressure(next.maximal_force);
        next.maximal_approach = (next.maximal_approach + approach).max(f64::MIN_POSITIVE);
        next.maximal_force = (next.maximal_force + force).max(0.0);
        next.maximal_contact = self.hertz.ellipse(next.maximal_approach)?;
        if pressed > 0.0 {
            next.peak_pressure *= next.maximal_contact.peak_pressure(next.maximal_force) / pressed;
        }
        let part = whole * self.normal_restitution.part_of_yield();
        // The spin about the first normal is left to the torsional impact.
        let z = self.frame().z();
        let by = change.motions.map(|by| Motion {
            velocity: part * by.velocity,
            spin: part * (by.spin - z * by.spin.dot(&z)),
        });
        let allowed = self.share_without_gain(&next, &by);
        let kept = next.motions;
        for (motion, by) in next.motions.iter_mut().zip(&by) {
            motion.velocity += allowed * by.velocity;
            motion.spin += allowed * by.spin;
        }
        self.book(&mut next);
        next.impulse += self.momentum(&kept, &next.motions);
        let after = self.contact_velocity(&next.motions);
        let before = self.velocity();
        next.contact_velocity_after = self.frame().to_space(&after);
        if next.r_x.is_some() {
            next.r_x = super::aftermath::along(&before, &after).or(next.r_x);
        }
        let size = self.contact_velocity(&change.motions).norm();
        next.error_estimate += (spread + (LEFT + 1.0 - allowed) * size) / before.norm();
        Ok(next)
    }

    /// The momentum that body 1 gains from these motions to those.
    fn momentum(&self, from: &[Motion; 2], to: &[Motion; 2]) -> Vector3<f64> {
        let [one, two] = self.inverse_masses();
        match one > 0.0 {
            true => (to[0].velocity - from[0].velocity) / one,
            false => (from[1].velocity - to[1].velocity) / two,
        }
    }

    fn inverse_masses(&self) -> [f64; 2] {
        self.bodies.each_ref().map(|body| body.inertia().inverse_mass())
    }

    /// Whether no body that is held moves, which would do work on the other one.
    fn keeps_energies(&self) -> bool {
        self.bodies.iter().all(|body| {
            let Motion { velocity, spin } = body.motion();
            body.inertia().mass().is_finite() || velocity.amax().max(spin.amax()) == 0.0
        })
    }

    fn kinetic(&self, motions: &[Motion; 2]) -> f64 {
        self.bodies[0].kinetic_energy(&motions[0]) + self.bodies[1].kinetic_energy(&motions[1])
    }

    /// The share of a change of the motions with which they gain no energy, where the centres would have to lose more than
    /// half their speed against each other to keep it.
    fn share_without_gain(&self, rebound: &Rebound, by: &[Motion; 2]) -> f64 {
        let sum = [0, 1].map(|i| Motion {
            velocity: rebound.motions[i].velocity + by[i].velocity,
            spin: rebound.motions[i].spin + by[i].spin,
        });
        let [kept, whole, own] = [&rebound.motions, &sum, by].map(|motions| self.kinetic(motions));
        if !self.keeps_energies()
            || whole - rebound.energy.before <= 0.75 * self.energy_of_centres(&sum)
        {
            return 1.0;
        }
        // kept + p slope + p^2 own is the energy with the share p.
        let (slope, room) = (whole - kept - own, (rebound.energy.before - kept).max(0.0));
        let root = (slope * slope + 4.0 * own * room).sqrt();
        ((root - slope) / (2.0 * own)).clamp(0.0, 1.0)
    }

    /// The kinetic energy of the motion of the centres against each other.
    fn energy_of_centres(&self, motions: &[Motion; 2]) -> f64 {
        let [one, two] = self.inverse_masses();
        0.5 * (motions[1].velocity - motions[0].velocity).norm_squared() / (one + two)
    }

    /// Energies after a change of the motions; without any loss the relative speed is that which keeps the energy. Friction
    /// has the same part of the loss as without the turn.
    fn book(&self, rebound: &mut Rebound) {
        let kept = self.keeps_energies();
        let is_elastic = rebound.energy.lost == 0.0;
        let mut lost = rebound.energy.before - self.kinetic(&rebound.motions);
        let keeps = is_elastic && self.friction.get() == 0.0;
        if kept && (keeps || lost < 0.0) {
            self.scale_to(&mut rebound.motions, lost);
            lost = 0.0;
        }
        rebound.energy.after = self.kinetic(&rebound.motions);
        if !kept {
            return;
        }
        let EnergyBudget { dissipated, lost: in_material, .. } = rebound.energy;
        let by_friction = if is_elastic { 1.0 } else { dissipated / (dissipated + in_material) };
        rebound.energy.dissipated = by_friction * lost;
        rebound.energy.lost = lost - rebound.energy.dissipated;
    }

    // Adds an energy to the motion of the centres against each other.
    fn scale_to(&self, motions: &mut [Motion; 2], missing: f64) {
        let [one, two] = self.inverse_masses();
        let middle = (two * motions[0].velocity + one * motions[1].velocity) / (one + two);
        let part = (1.0 + missing / self.energy_of_centres(motions)).max(0.0).sqrt();
        for motion in motions {
            motion.velocity = middle + part * (motion.velocity - middle);
        }
    }
}
