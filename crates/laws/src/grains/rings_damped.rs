//! Steps of a damped contact with the law of rings, as those of [`super::damped`].

use carom_special::RangeError;

use super::damped::{part_in_contact, work};
use super::dashpots::{Effective, Motion};
use super::load::{GrainLoad, check_beside, compressed, elastic};
use super::meeting::Meeting;
use super::rings::{Given, GrainRings, turned};
use super::step::{Step, first_step, one_step_before};
use crate::law::Shift;
use crate::rings::Rings;
use crate::viscous::Slides;

/// Where the law of a damped contact goes in a step.
struct Driven {
    to: Shift,
    lead: [f64; 2],
    twist_lead: f64,
    /// Whether the bodies touched in this step.
    touches: bool,
}

impl<const N: usize, const M: usize> GrainRings<N, M> {
    /// Advances, and returns the load with the heats of friction and damping.
    pub(super) fn moved_damped(
        &mut self,
        rings: &Rings<'_, N, M>,
        meeting: &Meeting,
        dt: f64,
    ) -> Result<(GrainLoad, f64, f64), RangeError> {
        if self.is_new() {
            self.start(rings, meeting, dt)?;
        }
        let mut step = self.before().step(meeting, dt);
        step.to().check_finite()?;
        let driven = self.driven(rings, meeting, &step, dt);
        step.lead = driven.lead;
        let (old, stored) = (*self, self.bent(rings));
        let heat = self.memory.advance(rings, driven.to)?;
        let given = Given { load: self.memory.load(rings), heat };
        self.drag = given.load.f_z - elastic(rings.c_z(), step.zeta);
        check_beside(meeting.arms, self.drag)?;
        let load = self.keep(meeting, &step, given.load);
        (self.approach, self.twist_lead) = (step.zeta, driven.twist_lead);
        self.twisting = turning(meeting);
        let drags = [old.drag, self.drag];
        let along = |k: usize| work([old.friction[k], self.friction[k]], step.velocity[k] * dt);
        // The law counts twist and torque clockwise.
        let about = work([-old.torque, -self.torque], turned(meeting, dt));
        let across = along(0) + along(1) + about - (self.bent(rings) - stored) - heat;
        let damping = self.drag_heat.step(drags, step.speed, dt, driven.touches) + across;
        Ok((load, heat, damping))
    }

    /// A new contact becomes what it was one step before.
    fn start(
        &mut self,
        rings: &Rings<'_, N, M>,
        meeting: &Meeting,
        dt: f64,
    ) -> Result<(), RangeError> {
        let (before, step) = (one_step_before(meeting, dt), first_step(meeting, dt));
        before.check_finite()?;
        if before.zeta > 0.0 {
            self.memory.advance(rings, before)?;
        }
        (self.tangent, self.normal) = (step.tangent, meeting.normal);
        (self.velocity, self.twisting) = (step.velocity, turning(meeting));
        (self.approach, self.drag_heat.speed) = (before.zeta.min(0.0), step.speed);
        Ok(())
    }

    fn driven(&self, rings: &Rings<'_, N, M>, meeting: &Meeting, step: &Step, dt: f64) -> Driven {
        let (mut before, turn) = (self.before(), turning(meeting));
        let touches = before.zeta <= 0.0;
        let (mut last, mut last_turn, mut since) = (self.drag_heat.speed, self.twisting, 1.0);
        if touches {
            // Before the bodies touched, the motion was the same.
            (last, last_turn, since) = (step.speed, turn, 2.0);
            before.velocity = step.velocity;
        }
        let motion = Motion { zeta: step.zeta, speed: step.speed, before: last, since, dt };
        let mobility = || 1.0 / meeting.masses[0] + 1.0 / meeting.masses[1];
        let Effective { approach, theta } =
            self.dashpots.effective(motion, self.pressed(rings), mobility);
        let part = part_in_contact(before.zeta, step.zeta);
        let [lead, by] = before.led(step.velocity, theta, part, dt);
        let ways = step.velocity.map(|v| v * dt);
        let [x, y] = self.slid_on(rings, ways, [step.zeta, approach], by);
        let ahead = theta * (turn + 0.5 * (turn - last_turn));
        let twist_lead = if dt > 0.0 { ahead } else { self.twist_lead };
        let twisted = turned(meeting, dt) * part + (twist_lead - self.twist_lead);
        let omega = self.memory.shift().omega + twisted;
        let to = Shift { zeta: approach, xi: before.shift[0] + x, eta: before.shift[1] + y, omega };
        let kept = if approach > 0.0 { 1.0 } else { 0.0 };
        let (lead, twist_lead) = (lead.map(|lead| kept * lead), kept * twist_lead);
        Driven { to, lead, twist_lead, touches }
    }

    /// The constant c_z of Hertz's law that gives the force of the law; coupled materials are stiffer than without
    /// friction.
    fn pressed(&self, rings: &Rings<'_, N, M>) -> f64 {
        let zeta = self.memory.shift().zeta;
        let c_z = 1.5 * self.memory.load(rings).f_z / (zeta * zeta.sqrt());
        if zeta > 0.0 && c_z > 0.0 && c_z.is_finite() { c_z } else { rings.c_z() }
    }

    /// The growth of the shift of the law, as [`super::GrainContact::slid_on`].
    fn slid_on(
        &self,
        rings: &Rings<'_, N, M>,
        truly: [f64; 2],
        [zeta, approach]: [f64; 2],
        by: [f64; 2],
    ) -> [f64; 2] {
        let friction = rings.friction().get();
        let limit = friction * self.memory.load(rings).f_z;
        let its = self.memory.shift().zeta;
        match Slides::of(self.friction, limit, || [rings.kappa() * friction; 2]) {
            Some(slides) => slides.on(truly, [zeta - self.approach, approach - its], by),
            None => by,
        }
    }

    /// The energy of the tangential load, and of the pressures that it adds.
    fn bent(&self, rings: &Rings<'_, N, M>) -> f64 {
        self.memory.stored_energy(rings) - compressed(rings.c_z(), self.memory.shift().zeta)
    }
}

/// The rate of the twist, clockwise as in the law.
fn turning(meeting: &Meeting) -> f64 {
    turned(meeting, 1.0)
}
