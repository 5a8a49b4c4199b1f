//! Steps of a damped contact of grains: its law is driven by the effective approach and shift.
//!
//! The law of a damped contact holds the effective approach Z and the shift with its lead. Its normal force is the whole
//! one, its limit of friction f times that. Where the force is cut to 0 the law parts, though the bodies overlap; where
//! they press again, the contact begins anew.

use carom_special::RangeError;

use super::account::{Account, Accounted, Unaccounted};
use super::contact::GrainContact;
use super::dashpots::{Effective, Motion};
use super::drag_heat::DragHeat;
use super::frame::GrainFrame;
use super::law::GrainLaw;
use super::load::{GrainLoad, check_beside, compressed, elastic};
use super::meeting::Meeting;
use super::step::{Step, first_step, one_step_before};
use super::twisted::{TwistState, Twisted, turned};
use crate::bounds::LARGEST;
use crate::law::{ContactLoad, Shift};
use crate::slip_lag::SlipLag;
use crate::viscous::{Slides, arm};

/// A step of a damped contact.
pub(super) struct Damped {
    step: Step,
    /// Where the law goes: effective approach, shift and twist.
    to: Shift,
    lead: [f64; 2],
    twist_lead: f64,
    /// How slip lags.
    lag: SlipLag,
    /// The distance of the pressure from the centre ([`arm`]).
    arm: f64,
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

impl<L: GrainLaw> GrainContact<L> {
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
        self.go_on(meeting, &step, dt, load, &mut Unaccounted)
    }

    #[inline(never)]
    fn begin_damped(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
    ) -> Result<(), RangeError> {
        let mut next = self.clone();
        next.start(meeting, dt)?;
        let step = next.damped(meeting, dt);
        next.go_on(meeting, &step, dt, load, &mut Unaccounted)?;
        if !meeting.is_apart() {
            *self = next;
        }
        Ok(())
    }

    /// A step as [`GrainContact::advance_accounted`] of a copy, with the heat of damping.
    pub(super) fn go_damped_accounted(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
        account: &mut Accounted,
    ) -> Result<f64, RangeError> {
        if self.is_new() {
            self.start(meeting, dt)?;
        }
        let step = self.damped(meeting, dt);
        let (before, stored) = (self.frame, self.bent());
        self.go_on(meeting, &step, dt, load, account)?;
        let Damped { step: Step { velocity, speed, .. }, touches, .. } = step;
        let frame = &self.frame;
        let along = |k: usize| work([before.friction[k], frame.friction[k]], velocity[k] * dt);
        let mut ways = along(0) + along(1);
        if L::Twist::COUNTS {
            // The law counts twist and torque clockwise.
            let torques = [-before.twist.get().torque, -frame.twist.get().torque];
            ways += work(torques, turned(meeting, dt));
        }
        // What is neither stored nor heat of friction.
        let across = ways - (self.bent() - stored) - account.loss;
        let mut drag_heat = before.drag_heat;
        Ok(drag_heat.step([before.drag, frame.drag], speed, dt, touches) + across)
    }

    /// The energy of the tangential load, and of the pressures that it adds.
    fn bent(&self) -> f64 {
        self.law.stored_energy() - compressed(self.law.hertz_stiffness(), self.law.shift().zeta)
    }

    /// A new contact becomes what it was one step before.
    #[cold]
    fn start(&mut self, meeting: &Meeting, dt: f64) -> Result<(), RangeError> {
        let (before, step) = (one_step_before(meeting, dt), first_step(meeting, dt));
        before.check_finite()?;
        if before.zeta > 0.0 {
            self.law.advance(before)?;
        }
        let frame = &mut self.frame;
        (frame.tangent, frame.normal) = (step.tangent, meeting.normal);
        // Bodies that overlapped before touch in this step all the same.
        (frame.velocity, frame.approach) = (step.velocity, before.zeta.min(0.0));
        frame.drag_heat.speed = step.speed;
        frame.twist = TwistState::of(Twisted { rate: turning(meeting), ..frame.twist.get() });
        Ok(())
    }

    /// The step, whose law is still to advance.
    #[inline(always)]
    fn damped(&self, meeting: &Meeting, dt: f64) -> Damped {
        let mut before = self.before();
        let step = before.step(meeting, dt);
        let touches = before.zeta <= 0.0;
        // Before the bodies touched, the motion was the same.
        let last = if touches { step.speed } else { self.frame.drag_heat.speed };
        let since = if touches { 2.0 } else { 1.0 };
        if touches {
            before.velocity = step.velocity;
        }
        let motion = Motion { zeta: step.zeta, speed: step.speed, before: last, since, dt };
        let mobility = || 1.0 / meeting.masses[0] + 1.0 / meeting.masses[1];
        let Effective { approach, theta } =
            self.frame.dashpots.effective(motion, self.law.pressed_stiffness(), mobility);
        let part = part_in_contact(before.zeta, step.zeta);
        let [lead, by] = before.led(step.velocity, theta, part, dt);
        let by = self.slid_on(step.velocity.map(|v| v * dt), [step.zeta, approach], by);
        let lag = match self.law.keeps_slip() {
            true => self.lag(meeting, (&step, touches), [part * dt, approach, theta]),
            false => SlipLag::NONE,
        };
        let [xi, eta] = [0, 1].map(|k| before.shift[k] + by[k]);
        let arm = if L::Twist::COUNTS { arm(step.zeta, approach) } else { 1.0 };
        let (twist_lead, omega) = self.twisted_on(meeting, touches, [theta, part, arm], dt);
        let to = Shift { zeta: approach, xi, eta, omega };
        let c_z = self.law.hertz_stiffness();
        let drag = elastic(c_z, approach) - elastic(c_z, step.zeta);
        let lag = lag.turned_by(twist_lead);
        Damped { step, to, lead, twist_lead, lag, arm, drag, touches }
    }

    /// How slip lags in a step of this duration to this effective approach, with this lead.
    fn lag(
        &self,
        meeting: &Meeting,
        (step, touches): (&Step, bool),
        [duration, approach, theta]: [f64; 3],
    ) -> SlipLag {
        let lag = SlipLag::after(duration, step.zeta, approach, theta);
        if touches {
            return lag;
        }
        let rates = |zeta: f64, [xi, eta]: [f64; 2], omega: f64| Shift { zeta, xi, eta, omega };
        let GrainFrame { velocity, drag_heat, twist, .. } = self.frame;
        let before = rates(drag_heat.speed, velocity, twist.get().rate);
        lag.bent_by(before, rates(step.speed, step.velocity, turning(meeting)), approach)
    }

    /// The lead of the twist at the end of a step, and the twist of the law.
    #[inline(always)]
    fn twisted_on(
        &self,
        meeting: &Meeting,
        touches: bool,
        [theta, part, arm]: [f64; 3],
        dt: f64,
    ) -> (f64, f64) {
        if !L::Twist::COUNTS {
            return (0.0, 0.0);
        }
        let (turn, twist) = (turning(meeting), self.frame.twist.get());
        let last = if touches { turn } else { twist.rate };
        let ahead = arm * theta * (turn + 0.5 * (turn - last));
        let lead = if dt > 0.0 { ahead } else { twist.lead };
        let by = arm * turned(meeting, dt) * part + (lead - twist.lead);
        (lead, self.law.shift().omega + by)
    }

    /// The growth of the shift of the law: as that of all of it that slides, while the bodies slide on.
    #[inline(always)]
    pub(super) fn slid_on(
        &self,
        truly: [f64; 2],
        [zeta, approach]: [f64; 2],
        by: [f64; 2],
    ) -> [f64; 2] {
        let Some(force) = self.law.sliding_force() else { return by };
        let (its, frame) = (self.law.shift().zeta, &self.frame);
        match Slides::of(frame.friction, force, || self.law.sliding_shift()) {
            Some(slides) => slides.on(truly, [zeta - frame.approach, approach - its], by),
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
        account: &mut impl Account,
    ) -> Result<(), RangeError> {
        // The effective approach of what is no approach is 0.
        let is_in_range = step.step.zeta.abs() <= LARGEST;
        if !is_in_range | check_beside(meeting.arms, step.drag).is_err() {
            return Err(self.first_error(&{ *meeting }, dt, step.drag));
        }
        let end = account.advance(&mut self.law, step.to, step.lag)?;
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
        let &Damped { ref step, to, lead, twist_lead, arm, drag, .. } = step;
        let end = ContactLoad { m_z: arm * end.m_z, ..end };
        let load = self.keep(meeting, step, end);
        let frame = &mut self.frame;
        frame.drag_heat = DragHeat { drag: frame.drag, speed: step.speed };
        // Coupling may change the normal force.
        frame.drag = match L::Twist::COUNTS {
            true => end.f_z - elastic(self.law.hertz_stiffness(), step.zeta),
            false => drag,
        };
        frame.approach = step.zeta;
        let is_pressed = to.zeta > 0.0;
        frame.lead = if is_pressed { lead } else { [0.0; 2] };
        let lead = if is_pressed { twist_lead } else { 0.0 };
        frame.twist = TwistState::of(Twisted { rate: turning(meeting), lead, ..frame.twist.get() });
        load
    }
}

/// The rate of the twist, clockwise as in the law.
#[inline(always)]
fn turning(meeting: &Meeting) -> f64 {
    turned(meeting, 1.0)
}
