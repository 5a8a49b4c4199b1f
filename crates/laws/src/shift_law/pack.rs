//! Stores the state of the law as plain numbers.

use carom_special::RangeError;

use super::{ShiftLaw, State, with_memory};
use crate::bounds::{LARGEST, in_contact, in_memory};
use crate::law::Shift;
use crate::memory::{Lateral, VertexStack};

/// The mark of a frictionless contact, whose state is its shift only.
const FRICTIONLESS: f64 = 3e4;
const HEAD: usize = 6;

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
        let room = numbers.len() as f64;
        RangeError::check("numbers", room, numbers.len() >= HEAD, ">= 6")?;
        numbers.fill(0.0);
        let Shift { zeta, xi, eta, .. } = self.shift;
        numbers[..4].copy_from_slice(&[FRICTIONLESS, zeta, xi, eta]);
        Ok(())
    }

    /// Restores what [`ShiftLaw::pack`] of a law with the same constants wrote. Forces are summed
    /// up again and may differ by rounding.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are not a state of this law; the law is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let shift = self.shift_in(numbers);
        with_memory!(
            &mut self.state,
            memory => shift.and_then(|_| memory.unpack(numbers))?,
            else return self.unpack_free(numbers)
        );
        self.shift = shift?;
        Ok(())
    }

    /// The shift of a stored memory, which is normalised there.
    fn shift_in(&self, numbers: &[f64]) -> Result<Shift, RangeError> {
        let Some(&[_, zeta, xi, eta]) = numbers.first_chunk() else {
            return Err(RangeError::new("numbers", numbers.len() as f64, ">= 6"));
        };
        let [x, y] = self.scale.shift.components();
        let eta = if V::DIMENSION == 1 { 0.0 } else { eta / y };
        let shift = Shift { zeta, xi: rounded_back(xi / x), eta: rounded_back(eta), omega: 0.0 };
        for number in &numbers[1..4] {
            in_memory("numbers", *number)?;
        }
        shift.check_finite()?;
        Ok(shift)
    }

    fn unpack_free(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let room = numbers.len() as f64;
        RangeError::check("numbers", room, numbers.len() >= HEAD, ">= 6")?;
        let known = numbers[0] == 0.0 || numbers[0] == FRICTIONLESS;
        RangeError::check("mark", numbers[0], known, "that of a contact without friction")?;
        let zeta = in_contact("approach", numbers[1])?;
        let xi = in_contact("shift", numbers[2])?;
        let eta = in_contact("shift", numbers[3])?;
        self.shift = Shift { zeta, xi, eta, omega: 0.0 };
        Ok(())
    }
}

/// A shift that was multiplied and divided by a scale: at the end of the range it may lie beyond by rounding.
fn rounded_back(shift: f64) -> f64 {
    match shift.abs() <= LARGEST * (1.0 + 4.0 * f64::EPSILON) {
        true => shift.clamp(-LARGEST, LARGEST),
        false => shift,
    }
}
