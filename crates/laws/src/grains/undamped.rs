//! Steps of a contact of grains without damping: its law is driven by approach and shift.

use carom_special::RangeError;

use super::account::Account;
use super::contact::GrainContact;
use super::law::GrainLaw;
use super::load::{GrainLoad, check_beside};
use super::meeting::Meeting;
use super::step::{Ending, Step, first_step, leaves, on_the_way, one_step_before};
use super::twisted::{TwistState as _, turned};
use crate::law::{ContactLoad, Shift};
use crate::slip_lag::SlipLag;

impl<L: GrainLaw> GrainContact<L> {
    /// Where the law of an undamped contact goes in a step.
    #[inline(always)]
    fn end_of(law: &L, step: &Step, meeting: &Meeting, dt: f64) -> Shift {
        let to = step.to();
        match L::Twist::COUNTS {
            true => Shift { omega: law.shift().omega + turned(meeting, dt), ..to },
            false => to,
        }
    }

    #[inline(always)]
    pub(super) fn go_undamped(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
        account: &mut impl Account,
    ) -> Result<(), RangeError> {
        // A call that is not inlined gets a copy, so that the meeting itself stays in registers in all other steps.
        if self.is_new() {
            return self.begin(&{ *meeting }, dt, load, account);
        }
        if leaves(meeting, dt) {
            return self.leave(&{ *meeting }, dt, load, account);
        }
        let step = self.before().step(meeting, dt);
        let to = Self::end_of(&self.law, &step, meeting, dt);
        self.check_beside(meeting, to)?;
        let end = account.advance(&mut self.law, to, SlipLag::NONE)?;
        *load = self.keep(meeting, &step, end);
        Ok(())
    }

    #[inline(never)]
    fn begin(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
        account: &mut impl Account,
    ) -> Result<(), RangeError> {
        let (before, step) = (one_step_before(meeting, dt), first_step(meeting, dt));
        before.check_finite()?;
        step.to().check_finite()?;
        let mut law = self.law.clone();
        law.advance(before)?;
        let to = Self::end_of(&law, &step, meeting, dt);
        let end = account.advance(&mut law, to, SlipLag::NONE)?;
        check_beside(meeting.arms, 0.0)?;
        if meeting.is_apart() {
            *load = GrainLoad::default();
            return Ok(());
        }
        self.law = law;
        *load = self.keep(meeting, &step, end);
        Ok(())
    }

    /// A step in which friction is averaged over half a step before its end and half a step after
    /// it.
    #[inline(never)]
    fn leave(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
        account: &mut impl Account,
    ) -> Result<(), RangeError> {
        let step = self.before().step(meeting, dt);
        let (from, to) = (self.law.shift(), Self::end_of(&self.law, &step, meeting, dt));
        let between = |part: f64| on_the_way(from, to, part);
        self.check_beside(meeting, to)?;
        let (mut law, mut past) = (self.law.clone(), self.law.clone());
        let past = past.advance(between(0.5))?;
        let end = account.advance(&mut law, to, SlipLag::NONE)?;
        let mut ahead = law.clone();
        let ahead = ahead.advance(between(1.5))?;
        self.law = law;
        let ending = Ending::of(meeting, dt);
        let mean = |of: fn(&ContactLoad) -> f64| ending.mean(of(&past), of(&end), of(&ahead));
        let [f_x, f_y, m_z] = [mean(|load| load.f_x), mean(|load| load.f_y), mean(|load| load.m_z)];
        *load = self.keep(meeting, &step, ContactLoad { f_x, f_y, m_z, ..end });
        Ok(())
    }

    /// Checks that no part of the load of a step overflows, whose shift is this.
    #[inline(always)]
    fn check_beside(&self, meeting: &Meeting, to: Shift) -> Result<(), RangeError> {
        check_beside(meeting.arms, 0.0).map_err(|error| self.first_one(to, error))
    }

    /// The error of the law if it does not allow the step, which comes first.
    #[cold]
    fn first_one(&self, to: Shift, error: RangeError) -> RangeError {
        self.law.check(to).err().unwrap_or(error)
    }
}
