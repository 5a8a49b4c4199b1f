//! Stores the contact of two grains as plain numbers.

use carom_special::RangeError;

use super::contact::GrainContact;
use super::drag_heat::DragHeat;
use super::frame::GrainFrame;
use super::law::GrainLaw;
use super::twisted::{self, TwistState as _, Twisted};
use super::vector::{Vector, dot};
use crate::coulomb::packed_numbers;
use crate::rings;

/// Number of values beside those of the law: tangent, normal, friction, drag, velocity, lead, what the heat
/// of damping needs, and the approach.
const BESIDE: usize = 16;

/// Number of values of a stored grain contact with this many vertices: 82 for 12.
///
/// ```
/// assert_eq!(carom_laws::grains::grain_numbers(12), 82);
/// ```
#[must_use]
pub const fn grain_numbers(vertices: usize) -> usize {
    packed_numbers(vertices) + BESIDE
}

/// Number of values of a stored contact with this many rings and angles: 316 for 6 x 8.
///
/// ```
/// assert_eq!(carom_laws::grains::ring_grain_numbers(6, 8), 316);
/// ```
#[must_use]
pub const fn ring_grain_numbers(rings: usize, angles: usize) -> usize {
    1 + rings::packed_numbers(rings, angles) + BESIDE + Twisted::NUMBERS
}

impl<L: GrainLaw> GrainContact<L> {
    const AROUND: usize = BESIDE + L::Twist::NUMBERS;

    /// Writes the state of the contact as numbers: those of the law ([`GrainLaw::write`]), the first of which is not
    /// zero, then tangent, normal, the forces of the last step and its velocity, and torque and twist of a law that
    /// counts it. All zeros represent two separated grains. The constants of the contact are not stored.
    ///
    /// # Errors
    /// [`RangeError`] if `numbers` is too short; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let room = numbers.len();
        RangeError::check("numbers", room as f64, room >= Self::AROUND, "enough for the contact")?;
        let (law, around) = numbers.split_at_mut(room - Self::AROUND);
        self.law.write(law)?;
        let (beside, twist) = around.split_at_mut(BESIDE);
        write_beside(&self.frame, beside);
        twisted::write(self.frame.twist, twist);
        Ok(())
    }

    /// Restores what [`GrainContact::pack`] of a contact with the same constants wrote into a slice
    /// of the same length. Loads are the same but for the rounding of sums.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are not a stored contact; the contact is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let room = numbers.len();
        RangeError::check("numbers", room as f64, room >= Self::AROUND, "enough for the contact")?;
        let (law, around) = numbers.split_at(room - Self::AROUND);
        let (beside, twist) = around.split_at(BESIDE);
        let mut frame = self.frame;
        read_beside(&mut frame, beside)?;
        frame.twist = twisted::read(twist)?;
        self.law.read(law)?;
        self.frame = frame;
        Ok(())
    }
}

/// Writes the stored values of a contact beside those of its law.
fn write_beside<T>(frame: &GrainFrame<T>, numbers: &mut [f64]) {
    numbers[..3].copy_from_slice(&frame.tangent);
    numbers[3..6].copy_from_slice(&frame.normal);
    numbers[6..8].copy_from_slice(&frame.friction);
    numbers[8] = frame.drag;
    numbers[9..11].copy_from_slice(&frame.velocity);
    numbers[11..13].copy_from_slice(&frame.lead);
    (numbers[13], numbers[14]) = (frame.drag_heat.drag, frame.drag_heat.speed);
    numbers[15] = frame.approach;
}

fn read_beside<T>(frame: &mut GrainFrame<T>, numbers: &[f64]) -> Result<(), RangeError> {
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
    (frame.tangent, frame.normal) = (tangent, normal);
    (frame.friction, frame.drag) = (pair(6), numbers[8]);
    (frame.velocity, frame.lead) = (pair(9), pair(11));
    frame.drag_heat = DragHeat { drag: numbers[13], speed: numbers[14] };
    frame.approach = numbers[15];
    Ok(())
}
