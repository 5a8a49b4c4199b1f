//! Stores the state of the law as plain numbers.

use carom_special::RangeError;

use super::{ShiftLaw, State, with_memory};
use crate::bounds::{LARGEST, in_contact};
use crate::law::Shift;
use crate::memory::{Lateral, VertexStack};
use crate::stored::{Reader, Writer, any};

/// The mark of a frictionless contact, whose state is its shift only.
const FRICTIONLESS: f64 = 3e4;

impl<V: Lateral, S: VertexStack<V>> ShiftLaw<V, S> {
    /// Writes the history of the law as numbers. [`crate::coulomb::packed_numbers`] for the
    /// capacity of its storage is always sufficient, except for infinite friction, which needs 6
    /// and 9 per vertex. All zeros represent two separated bodies. Neither the constants of the
    /// contact nor the twist are stored.
    ///
    /// ```
    /// use carom_laws::coulomb::packed_numbers;
    /// use carom_laws::friction::Friction;
    /// use carom_laws::law::{ContactLaw, Shift};
    /// use carom_laws::memory::Fixed;
    /// use carom_laws::shift_law::ShiftLaw;
    /// use carom_laws::stiffness::ContactStiffness;
    /// let stiffness = ContactStiffness::new(1.0, 1.0, 1.2)?;
    /// let fresh = ShiftLaw::<[f64; 2], Fixed<_, 12>>::new(stiffness, Friction::new(0.3)?);
    /// let mut law = fresh;
    /// law.advance(Shift { zeta: 1.0, ..Shift::default() })?;
    /// let load = law.advance(Shift { zeta: 1.0, xi: 0.1, ..Shift::default() })?;
    /// let mut numbers = [0.0; packed_numbers(12)];
    /// law.pack(&mut numbers)?;
    /// let mut again = fresh;
    /// again.unpack(&numbers)?;
    /// assert!((again.load().f_x - load.f_x).abs() < 1e-15);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if the slice is too short for the vertices; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        with_memory!(&self.state, memory => memory.pack(numbers), else self.pack_shift(numbers))
    }

    fn pack_shift(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let Shift { zeta, xi, eta, .. } = self.shift;
        let mut writer = Writer::new(numbers, 4, ">= 4")?;
        writer.write(&[FRICTIONLESS, zeta, xi, eta]);
        writer.rest().fill(0.0);
        Ok(())
    }

    /// Restores what [`ShiftLaw::pack`] of a law with the same constants wrote. Forces are summed
    /// up again and may differ by rounding.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are not a state of this law; the law is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let mut read = self.clone();
        let [x, y] = self.scale.shift.components();
        let (zeta, [xi, eta]) = with_memory!(&mut read.state, memory => {
            memory.unpack(numbers)?;
            let [xi, eta] = memory.shift().components();
            let eta = if V::DIMENSION == 1 { 0.0 } else { eta / y };
            (memory.zeta(), [xi / x, eta].map(rounded_back))
        }, else unpacked_shift(numbers)?);
        read.shift = Shift { zeta, xi, eta, omega: 0.0 };
        read.shift.check_finite()?;
        *self = read;
        Ok(())
    }
}

/// Approach and shift of a contact without friction.
fn unpacked_shift(numbers: &[f64]) -> Result<(f64, [f64; 2]), RangeError> {
    let mut reader = Reader::new(numbers, ">= 4");
    let [mark] = reader.read("mark", any)?;
    let known = mark == 0.0 || mark == FRICTIONLESS;
    RangeError::check("mark", mark, known, "that of a contact without friction")?;
    let [zeta] = reader.read("approach", in_contact)?;
    Ok((zeta, reader.read("shift", in_contact)?))
}

/// A shift that was multiplied and divided by a scale: at the end of the range it may lie beyond by rounding.
fn rounded_back(shift: f64) -> f64 {
    match shift.abs() <= LARGEST * (1.0 + 4.0 * f64::EPSILON) {
        true => shift.clamp(-LARGEST, LARGEST),
        false => shift,
    }
}
