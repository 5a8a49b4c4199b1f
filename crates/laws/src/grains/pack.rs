//! Stores the contact of two grains as plain numbers.

use carom_special::RangeError;

use super::contact::GrainContact;
use super::drag_heat::DragHeat;
use super::vector::{Vector, dot};
use crate::coulomb::packed_numbers;
use crate::memory::VertexStack;

/// Number of values beside those of the law: tangent, normal, friction, drag, velocity, lead, what the heat
/// of damping needs, and the approach.
pub(super) const BESIDE: usize = 16;

/// Number of values of a stored grain contact with this many vertices: 82 for 12.
///
/// ```
/// assert_eq!(carom_laws::grains::grain_numbers(12), 82);
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
        let (tangent, normal, friction, drag) =
            (self.tangent, self.normal, self.friction, self.drag);
        let (velocity, lead, drag_heat) = (self.velocity, self.lead, self.drag_heat);
        let approach = self.approach;
        let its = Beside { tangent, normal, friction, drag, velocity, lead, drag_heat, approach };
        its.write(beside);
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
        let beside = Beside::read(beside)?;
        self.law.unpack(law)?;
        let Beside { tangent, normal, friction, drag, velocity, lead, drag_heat, approach } =
            beside;
        (self.tangent, self.normal, self.friction) = (tangent, normal, friction);
        (self.drag, self.velocity, self.lead) = (drag, velocity, lead);
        (self.drag_heat, self.approach) = (drag_heat, approach);
        Ok(())
    }
}

/// The stored values of a contact beside those of its law.
pub(super) struct Beside {
    pub(super) tangent: Vector,
    pub(super) normal: Vector,
    pub(super) friction: [f64; 2],
    pub(super) drag: f64,
    pub(super) velocity: [f64; 2],
    pub(super) lead: [f64; 2],
    pub(super) drag_heat: DragHeat,
    pub(super) approach: f64,
}

impl Beside {
    pub(super) fn write(&self, numbers: &mut [f64]) {
        numbers[..3].copy_from_slice(&self.tangent);
        numbers[3..6].copy_from_slice(&self.normal);
        numbers[6..8].copy_from_slice(&self.friction);
        numbers[8] = self.drag;
        numbers[9..11].copy_from_slice(&self.velocity);
        numbers[11..13].copy_from_slice(&self.lead);
        (numbers[13], numbers[14]) = (self.drag_heat.drag, self.drag_heat.speed);
        numbers[15] = self.approach;
    }

    pub(super) fn read(numbers: &[f64]) -> Result<Self, RangeError> {
        let vector = |i: usize| [numbers[i], numbers[i + 1], numbers[i + 2]];
        let (tangent, normal): (Vector, Vector) = (vector(0), vector(3));
        for (field, vector) in [("tangent", tangent), ("normal", normal)] {
            let square = dot(vector, vector);
            let holds = square == 0.0 || (square - 1.0).abs() < 1e-9;
            RangeError::check(field, square.sqrt(), holds, "of length 0 or 1")?;
        }
        for (field, values) in [("force", &numbers[6..9]), ("velocity", &numbers[9..])] {
            for value in values {
                RangeError::finite(field, *value)?;
            }
        }
        let pair = |i: usize| [numbers[i], numbers[i + 1]];
        let (friction, drag, velocity, lead) = (pair(6), numbers[8], pair(9), pair(11));
        let drag_heat = DragHeat { drag: numbers[13], speed: numbers[14] };
        let approach = numbers[15];
        Ok(Self { tangent, normal, friction, drag, velocity, lead, drag_heat, approach })
    }
}
