//! Steps of a damped contact: its law is driven by the effective approach and shift.
//!
//! The law of a damped contact holds the effective approach Z and the shift with its lead. Its normal force is the whole
//! one, its limit of friction f times that. Where the force is cut to 0 the law parts, though the bodies overlap; where
//! they press again, the contact begins anew.

use carom_special::RangeError;

use super::contact::{GrainContact, Heats};
use super::dashpots::{Effective, Motion};
use super::drag_heat::{DragHeat, check_heat};
use super::load::{GrainLoad, check_beside, compressed, elastic, load_in};
use super::meeting::Meeting;
use super::step::{Step, first_step, one_step_before};
use crate::bounds::LARGEST;
use crate::law::{Checked as _, ContactLaw as _, ContactLoad, Dissipative as _, Shift};
use crate::memory::VertexStack;
use crate::viscous::Slides;

/// A step of a damped contact.
pub(super) struct Damped {
    step: Step,
    /// Where the law goes: effective approach and shift.
    to: Shift,
    lead: [f64; 2],
    drag: f64,
    /// Whether the bodies touched in this step.
    touches: bool,
}

/// The part of a step, in which the approach grows from one to the other, with the bodies in contact.
pub(super) fn part_in_contact(from: f64, to: f64) -> f64 {
    match (from > 0.0, to > 0.0) {
        (true, _) => 1.0,
        (false, true) => to / (to - from),
        (false, false) => 0.0,
    }
}

/// The work of a force in a step: its mean times the way. A leapfrog takes it from the motion, to round-off.
pub(super) fn work([old, new]: [f64; 2], way: f64) -> f64 {
    0.5 * (old + new) * way
}

impl<S: VertexStack<[f64; 2]>> GrainContact<S> {
    /// A step as [`GrainContact::advance_into`].
    #[inline(always)]
    pub(super) fn advance_damped(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
    ) -> Result<(), RangeError> {
        if self.is_new() {
            return self.begin_damped(&{ *meeting }, dt, load);
        }
        let step = self.damped(meeting, dt);
        self.go_on(meeting, &step, dt, load)
    }

    #[inline(never)]
    fn begin_damped(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
    ) -> Result<(), RangeError> {
        let mut next = self.started(meeting, dt)?;
        let step = next.damped(meeting, dt);
        next.go_on(meeting, &step, dt, load)?;
        if !meeting.is_apart() {
            *self = next;
        }
        Ok(())
    }

    /// A step as [`GrainContact::advance_accounted`].
    pub(super) fn advance_damped_accounted(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        heats: &mut Heats,
    ) -> Result<GrainLoad, RangeError> {
        let mut next = if self.is_new() { self.started(meeting, dt)? } else { self.clone() };
        let step = next.damped(meeting, dt);
        let friction = next.law.loss(step.to);
        let (mut drag_heat, before, stored) = (next.drag_heat, next.clone(), next.bent());
        let mut load = GrainLoad::default();
        next.go_on(meeting, &step, dt, &mut load)?;
        let Damped { step: Step { velocity, speed, .. }, touches, .. } = step;
        let along = |k: usize| work([before.friction[k], next.friction[k]], velocity[k] * dt);
        // What is neither stored nor heat of friction.
        let damping = drag_heat.step([before.drag, next.drag], speed, dt, touches)
            + (along(0) + along(1) - (next.bent() - stored) - friction);
        check_heat(friction + damping)?;
        *self = next;
        heats.friction += friction;
        heats.damping += damping;
        Ok(load)
    }

    /// The energy of the tangential load.
    fn bent(&self) -> f64 {
        self.law.stored_energy() - compressed(self.law.stiffness().c_z, self.law.shift().zeta)
    }

    /// A new contact as it was one step before.
    #[cold]
    fn started(&self, meeting: &Meeting, dt: f64) -> Result<Self, RangeError> {
        let (before, step) = (one_step_before(meeting, dt), first_step(meeting, dt));
        before.check_finite()?;
        let mut start = self.clone();
        if before.zeta > 0.0 {
            start.law.advance(before)?;
        }
        (start.tangent, start.normal) = (step.tangent, meeting.normal);
        // Bodies that overlapped before touch in this step all the same.
        (start.velocity, start.approach) = (step.velocity, before.zeta.min(0.0));
        start.drag_heat.speed = step.speed;
        Ok(start)
    }

    /// The step, whose law is still to advance.
    #[inline(always)]
    fn damped(&self, meeting: &Meeting, dt: f64) -> Damped {
        let mut before = self.before();
        let step = before.step(meeting, dt);
        let touches = before.zeta <= 0.0;
        // Before the bodies touched, the motion was the same.
        let (last, since) = if touches { (step.speed, 2.0) } else { (self.drag_heat.speed, 1.0) };
        if touches {
            before.velocity = step.velocity;
        }
        let c_z = self.law.stiffness().c_z;
        let motion = Motion { zeta: step.zeta, speed: step.speed, before: last, since, dt };
        let mobility = || 1.0 / meeting.masses[0] + 1.0 / meeting.masses[1];
        let Effective { approach, theta } = self.dashpots.effective(motion, c_z, mobility);
        let part = part_in_contact(before.zeta, step.zeta);
        let [lead, by] = before.led(step.velocity, theta, part, dt);
        let by = self.slid_on(step.velocity.map(|v| v * dt), [step.zeta, approach], by);
        let [xi, eta] = [0, 1].map(|k| before.shift[k] + by[k]);
        let to = Shift { zeta: approach, xi, eta, omega: 0.0 };
        let drag = elastic(c_z, approach) - elastic(c_z, step.zeta);
        Damped { step, to, lead, drag, touches }
    }

    /// The growth of the shift of the law: as that of all of it that slides, while the bodies slide on.
    #[inline(always)]
    pub(super) fn slid_on(
        &self,
        truly: [f64; 2],
        [zeta, approach]: [f64; 2],
        by: [f64; 2],
    ) -> [f64; 2] {
        let its = self.law.shift().zeta;
        match Slides::of(self.friction, self.law.sliding_force(), || self.law.sliding_shift()) {
            Some(slides) => slides.on(truly, [zeta - self.approach, approach - its], by),
            None => by,
        }
    }

    #[inline(always)]
    fn go_on(
        &mut self,
        meeting: &Meeting,
        step: &Damped,
        dt: f64,
        load: &mut GrainLoad,
    ) -> Result<(), RangeError> {
        // The effective approach of what is no approach is 0.
        let is_in_range = step.step.zeta.abs() <= LARGEST;
        if !is_in_range | check_beside(meeting.arms, step.drag).is_err() {
            return Err(self.first_error(&{ *meeting }, dt, step.drag));
        }
        let end = self.law.advance(step.to)?;
        *load = self.keep_damped(meeting, step, end);
        Ok(())
    }

    /// Why a step fails: for its shift, or else beside it.
    #[cold]
    #[inline(never)]
    fn first_error(&self, meeting: &Meeting, dt: f64, drag: f64) -> RangeError {
        let to = self.before().step(meeting, dt).to();
        let beside = check_beside(meeting.arms, drag);
        self.law.check(to).and(beside).err().unwrap_or(RangeError::new("zeta", to.zeta, "finite"))
    }

    #[inline(always)]
    fn keep_damped(&mut self, meeting: &Meeting, step: &Damped, end: ContactLoad) -> GrainLoad {
        let Damped { step, to, lead, drag, .. } = step;
        self.drag_heat = DragHeat { drag: self.drag, speed: step.speed };
        (self.drag, self.approach) = (*drag, step.zeta);
        (self.tangent, self.normal) = (step.tangent, meeting.normal);
        (self.friction, self.velocity) = ([end.f_x, end.f_y], step.velocity);
        self.lead = if to.zeta > 0.0 { *lead } else { [0.0; 2] };
        load_in([step.tangent, meeting.normal], meeting.arms, end.f_z, self.friction)
    }
}
