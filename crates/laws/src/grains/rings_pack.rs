//! Stores the contact of two grains with the law of rings as plain numbers.

use std::ops::Range;

use carom_special::RangeError;

use super::pack::{BESIDE, Beside};
use super::rings::GrainRings;
use crate::rings::{Rings, packed_numbers};

/// Number of values beside those of the law: the mark, those of [`super::GrainContact`], the torque, and rate and lead of
/// the twist.
const AROUND: usize = 1 + BESIDE + 3;
/// The first number of a stored contact; it distinguishes this law from others.
pub const RING_GRAIN_MARK: f64 = 30_002.0;

/// Number of values of a stored contact with this many rings and angles: 314 for 6 x 8.
///
/// ```
/// assert_eq!(carom_laws::grains::ring_grain_numbers(6, 8), 314);
/// ```
#[must_use]
pub const fn ring_grain_numbers(rings: usize, angles: usize) -> usize {
    packed_numbers(rings, angles) + AROUND
}

impl<const N: usize, const M: usize> GrainRings<N, M> {
    /// Writes the state of the contact as numbers: a mark, which is not zero, those of the law
    /// ([`crate::rings::RingMemory::pack`]), then tangent, normal, and force, velocity, torque and twist of the
    /// last step. All zeros represent two separated grains. The constants of the contact are not stored.
    ///
    /// # Errors
    /// [`RangeError`] if `numbers` is too short; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let (mark, law, beside, twist) = parts::<N, M>(numbers.len())?;
        self.memory.pack(&mut numbers[law])?;
        numbers[mark] = RING_GRAIN_MARK;
        let (tangent, normal, friction, drag) =
            (self.tangent, self.normal, self.friction, self.drag);
        let (velocity, lead, drag_heat) = (self.velocity, self.lead, self.drag_heat);
        let approach = self.approach;
        let its = Beside { tangent, normal, friction, drag, velocity, lead, drag_heat, approach };
        its.write(&mut numbers[beside]);
        numbers[twist].copy_from_slice(&[self.torque, self.twisting, self.twist_lead]);
        Ok(())
    }

    /// Restores what [`GrainRings::pack`] of a contact with the same constants wrote. Loads are the same bits.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are not a stored contact; the contact is then unchanged.
    pub fn unpack(&mut self, rings: &Rings<'_, N, M>, numbers: &[f64]) -> Result<(), RangeError> {
        let (mark, law, beside, twist) = parts::<N, M>(numbers.len())?;
        let mark = numbers[mark];
        RangeError::check(
            "mark",
            mark,
            mark == RING_GRAIN_MARK,
            "30002, the mark of a contact with the law of rings",
        )?;
        let beside = Beside::read(&numbers[beside])?;
        let [torque, twisting, twist_lead] = [0, 1, 2].map(|i| numbers[twist.start + i]);
        for (field, value) in [("torque", torque), ("twist", twisting), ("twist", twist_lead)] {
            RangeError::finite(field, value)?;
        }
        self.memory.unpack(rings, &numbers[law])?;
        let Beside { tangent, normal, friction, drag, velocity, lead, drag_heat, approach } =
            beside;
        (self.tangent, self.normal, self.friction) = (tangent, normal, friction);
        (self.drag, self.velocity, self.lead) = (drag, velocity, lead);
        (self.drag_heat, self.approach) = (drag_heat, approach);
        (self.torque, self.twisting, self.twist_lead) = (torque, twisting, twist_lead);
        Ok(())
    }
}

type Parts = (usize, Range<usize>, Range<usize>, Range<usize>);

/// The index ranges of mark, law, contact, and torque and twist.
fn parts<const N: usize, const M: usize>(room: usize) -> Result<Parts, RangeError> {
    let whole = ring_grain_numbers(N, M);
    RangeError::check("numbers", room as f64, room >= whole, "enough for the contact")?;
    let law = 1 + packed_numbers(N, M);
    let twist = law + BESIDE;
    Ok((0, 1..law, law..twist, twist..twist + 3))
}
