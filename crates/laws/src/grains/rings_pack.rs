//! Stores the contact of two grains with the law of rings as plain numbers.

use carom_special::RangeError;

use super::pack::{BESIDE, Beside};
use super::rings::GrainRings;
use crate::rings::{Rings, packed_numbers};

/// Number of values beside those of the law: the mark, those of [`super::GrainContact`], and the torque.
const AROUND: usize = 1 + BESIDE + 1;
/// The first number of a stored contact; it distinguishes this law from others.
pub const RING_GRAIN_MARK: f64 = 30_001.0;

/// Number of values of a stored contact with this many rings and angles: 311 for 6 x 8.
///
/// ```
/// assert_eq!(carom_laws::grains::ring_grain_numbers(6, 8), 311);
/// ```
#[must_use]
pub const fn ring_grain_numbers(rings: usize, angles: usize) -> usize {
    packed_numbers(rings, angles) + AROUND
}

impl<const N: usize, const M: usize> GrainRings<N, M> {
    /// Writes the state of the contact as numbers: a mark, which is not zero, those of the law
    /// ([`crate::rings::RingMemory::pack`]), then tangent, normal, and force, velocity and torque of the last
    /// step. All zeros represent two separated grains. The constants of the contact are not stored.
    ///
    /// # Errors
    /// [`RangeError`] if `numbers` is too short; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let (mark, law, beside, torque) = parts::<N, M>(numbers.len())?;
        self.memory.pack(&mut numbers[law])?;
        numbers[mark] = RING_GRAIN_MARK;
        let (tangent, normal, friction, drag) =
            (self.tangent, self.normal, self.friction, self.drag);
        let (velocity, lead, drag_heat) = (self.velocity, self.lead, self.drag_heat);
        let its = Beside { tangent, normal, friction, drag, velocity, lead, drag_heat };
        its.write(&mut numbers[beside]);
        numbers[torque] = self.torque;
        Ok(())
    }

    /// Restores what [`GrainRings::pack`] of a contact with the same constants wrote. Loads are the same bits.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are not a stored contact; the contact is then unchanged.
    pub fn unpack(&mut self, rings: &Rings<'_, N, M>, numbers: &[f64]) -> Result<(), RangeError> {
        let (mark, law, beside, torque) = parts::<N, M>(numbers.len())?;
        let mark = numbers[mark];
        RangeError::check(
            "mark",
            mark,
            mark == RING_GRAIN_MARK,
            "30001, the mark of a contact with the law of rings",
        )?;
        let beside = Beside::read(&numbers[beside])?;
        let torque = RangeError::finite("torque", numbers[torque])?;
        self.memory.unpack(rings, &numbers[law])?;
        let Beside { tangent, normal, friction, drag, velocity, lead, drag_heat } = beside;
        *self =
            Self { tangent, normal, friction, drag, velocity, lead, drag_heat, torque, ..*self };
        Ok(())
    }
}

type Parts = (usize, std::ops::Range<usize>, std::ops::Range<usize>, usize);

/// The index ranges of mark, law, contact and torque.
fn parts<const N: usize, const M: usize>(room: usize) -> Result<Parts, RangeError> {
    let whole = ring_grain_numbers(N, M);
    RangeError::check("numbers", room as f64, room >= whole, "enough for the contact")?;
    let law = 1 + packed_numbers(N, M);
    Ok((0, 1..law, law..law + BESIDE, law + BESIDE))
}
