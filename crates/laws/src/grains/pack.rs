//! Stores the contact of two grains as plain numbers.

use carom_special::RangeError;

use super::contact::GrainContact;
use super::vector::{Vector, dot};
use crate::coulomb::packed_numbers;
use crate::memory::VertexStack;

/// Tangent, normal, friction, drag, velocity and lead.
const BESIDE: usize = 13;

/// Number of values of a stored grain contact with this many vertices: 79 for 12.
///
/// ```
/// assert_eq!(carom_laws::grains::grain_numbers(12), 79);
/// ```
#[must_use]
pub const fn grain_numbers(vertices: usize) -> usize {
    packed_numbers(vertices) + BESIDE
}

impl<S: VertexStack<[f64; 2]>> GrainContact<S> {
    /// Writes the state of the contact as numbers: those of the law
    /// ([`crate::shift_law::ShiftLaw::pack`]), the first of which is not zero, then tangent,
    /// normal, the forces of the last step and its velocity. All zeros represent two separated
    /// grains. The constants of the contact are not stored.
    ///
    /// # Errors
    /// [`RangeError`] if `numbers` is too short; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let room = numbers.len();
        RangeError::check("numbers", room as f64, room >= BESIDE, "enough for the contact")?;
        let (law, beside) = numbers.split_at_mut(room - BESIDE);
        self.law.pack(law)?;
        beside[..3].copy_from_slice(&self.tangent);
        beside[3..6].copy_from_slice(&self.normal);
        beside[6..8].copy_from_slice(&self.friction);
        beside[8] = self.drag;
        beside[9..11].copy_from_slice(&self.velocity);
        beside[11..].copy_from_slice(&self.lead);
        Ok(())
    }

    /// Restores what [`GrainContact::pack`] of a contact with the same constants wrote into a slice
    /// of the same length. Loads are the same bits.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are not a stored contact; the contact is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let room = numbers.len();
        RangeError::check("numbers", room as f64, room >= BESIDE, "enough for the contact")?;
        let (law, beside) = numbers.split_at(room - BESIDE);
        let vector = |i: usize| [beside[i], beside[i + 1], beside[i + 2]];
        let (tangent, normal): (Vector, Vector) = (vector(0), vector(3));
        for (field, vector) in [("tangent", tangent), ("normal", normal)] {
            let square = dot(vector, vector);
            let holds = square == 0.0 || (square - 1.0).abs() < 1e-9;
            RangeError::check(field, square.sqrt(), holds, "of length 0 or 1")?;
        }
        for (field, values) in [("force", &beside[6..9]), ("velocity", &beside[9..])] {
            for value in values {
                RangeError::finite(field, *value)?;
            }
        }
        self.law.unpack(law)?;
        (self.tangent, self.normal) = (tangent, normal);
        let pair = |i: usize| [beside[i], beside[i + 1]];
        (self.friction, self.drag) = (pair(6), beside[8]);
        (self.velocity, self.lead) = (pair(9), pair(11));
        Ok(())
    }
}
