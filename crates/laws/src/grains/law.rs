//! What the contact of two grains asks of its law.

use carom_special::RangeError;

use super::drag_heat::check_heat;
use super::load::elastic;
use super::pack::ENOUGH;
use super::twisted::{TwistState, Twisted};
use crate::law::{Checked, ContactLaw, ContactLoad, Dissipative, Shift};
use crate::memory::VertexStack;
use crate::rings::{RingLaw, packed_numbers as numbers_of_rings};
use crate::shift_law::ShiftLaw;
use crate::slip_lag::SlipLag;
use crate::stored::{Reader, Writer, any};

/// A contact law that can carry grains: [`ShiftLaw`], and [`RingLaw`], in which twist and coupling count too.
pub trait GrainLaw: ContactLaw<Error = RangeError> + Checked + Dissipative {
    /// What the contact keeps of the twist: nothing for a law of shifts alone.
    type Twist: TwistState;

    /// c_z of Hertz's force, `F_z = (2/3) c_z zeta^(3/2)`.
    fn hertz_stiffness(&self) -> f64;

    /// c_z of the force of Hertz that is the present one, which coupling may change.
    #[inline]
    fn pressed_stiffness(&self) -> f64 {
        self.hertz_stiffness()
    }

    /// The normal force at the end of the last step, of bodies whose approach is this, N.
    fn bears(&self, approach: f64) -> f64;

    /// The friction of a contact that slides as a whole at the present approach, N; none of a law that keeps the slip of
    /// each place.
    fn sliding_force(&self) -> Option<f64> {
        None
    }

    /// The shift over the approach of a contact of which all has slid, along x and y.
    fn sliding_shift(&self) -> [f64; 2] {
        [0.0; 2]
    }

    /// A step in a material in which slip lags, and the [loss](Dissipative::loss) in it.
    ///
    /// # Errors
    /// As [`ContactLaw::advance`], and [`RangeError`] of `heat` if it overflows.
    #[inline]
    fn advance_with_loss(
        &mut self,
        to: Shift,
        _lag: SlipLag,
    ) -> Result<(ContactLoad, f64), RangeError> {
        let loss = self.loss(to);
        check_heat(loss)?;
        Ok((self.advance(to)?, loss))
    }

    /// Writes the state as numbers, the first of which is above 0. The constants are not stored.
    ///
    /// # Errors
    /// [`RangeError`] if there are too few; nothing is then written.
    fn write(&self, numbers: &mut [f64]) -> Result<(), RangeError>;

    /// Restores what [`GrainLaw::write`] of a law with the same constants wrote.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are no state; the law is then unchanged.
    fn read(&mut self, numbers: &[f64]) -> Result<(), RangeError>;
}

impl<S: VertexStack<[f64; 2]>> GrainLaw for ShiftLaw<[f64; 2], S> {
    type Twist = ();

    #[inline(always)]
    fn hertz_stiffness(&self) -> f64 {
        self.stiffness().c_z
    }

    #[inline(always)]
    fn bears(&self, approach: f64) -> f64 {
        elastic(self.stiffness().c_z, approach)
    }

    #[inline(always)]
    fn sliding_force(&self) -> Option<f64> {
        Some(Self::sliding_force(self))
    }

    #[inline(always)]
    fn sliding_shift(&self) -> [f64; 2] {
        Self::sliding_shift(self)
    }

    fn write(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        self.pack(numbers).map(|_| ())
    }

    fn read(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        self.unpack(numbers)
    }
}

/// The first number of a stored contact by rings; it distinguishes this law from others.
const RINGS: f64 = 30_002.0;

impl<const N: usize, const M: usize> GrainLaw for RingLaw<N, M> {
    type Twist = Twisted;

    fn hertz_stiffness(&self) -> f64 {
        self.constants().c_z()
    }

    fn pressed_stiffness(&self) -> f64 {
        let zeta = self.shift().zeta;
        let c_z = 1.5 * self.load().f_z / (zeta * zeta.sqrt());
        if zeta > 0.0 && c_z > 0.0 && c_z.is_finite() { c_z } else { self.hertz_stiffness() }
    }

    fn bears(&self, _approach: f64) -> f64 {
        self.load().f_z
    }

    fn advance_with_loss(
        &mut self,
        to: Shift,
        lag: SlipLag,
    ) -> Result<(ContactLoad, f64), RangeError> {
        let heat = self.lagging_with_heat(to, lag)?;
        Ok((self.load(), heat))
    }

    fn write(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let mut writer = Writer::new(numbers, 1 + numbers_of_rings(N, M), ENOUGH)?;
        writer.write(&[RINGS]);
        self.pack(writer.rest())
    }

    fn read(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let mut reader = Reader::new(numbers, ENOUGH);
        let allowed = "30002, the mark of a contact with the law of rings";
        let [mark] = reader.read("mark", any)?;
        RangeError::check("mark", mark, mark == RINGS, allowed)?;
        self.unpack(reader.rest())
    }
}
