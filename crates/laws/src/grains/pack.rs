//! Stores the contact of two grains as plain numbers.

use carom_special::RangeError;

use super::contact::GrainContact;
use super::dashpots::Dashpots;
use super::drag_heat::DragHeat;
use super::frame::GrainFrame;
use super::law::GrainLaw;
use super::twisted::{self, TwistState, Twisted};
use super::vector::dot;
use crate::coulomb::packed_numbers;
use crate::rings;
use crate::stored::{Fields, Reader, Writer, is_unit_or_zero};

/// How many numbers a contact needs, in words.
pub(super) const ENOUGH: &str = "enough for the contact";

/// Number of values of a stored grain contact with this many vertices: 82 for 12.
///
/// ```
/// assert_eq!(carom_laws::grains::grain_numbers(12), 82);
/// ```
#[must_use]
pub const fn grain_numbers(vertices: usize) -> usize {
    packed_numbers(vertices) + GrainFrame::<()>::NUMBERS
}

/// Number of values of a stored contact with this many rings and angles: 319 for 6 x 8.
///
/// ```
/// assert_eq!(carom_laws::grains::ring_grain_numbers(6, 8), 319);
/// ```
#[must_use]
pub const fn ring_grain_numbers(rings: usize, angles: usize) -> usize {
    1 + rings::packed_numbers(rings, angles) + GrainFrame::<Twisted>::NUMBERS
}

impl<L: GrainLaw> GrainContact<L> {
    /// Writes the state of the contact as numbers: those of the law ([`GrainLaw::write`]), the first of which is not
    /// zero, then tangent, normal, the forces of the last step and its velocity, and torque and twist of a law that
    /// counts it. All zeros represent two separated grains. The constants of the contact are not stored.
    ///
    /// # Errors
    /// [`RangeError`] if `numbers` is too short; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let law = numbers.len().saturating_sub(GrainFrame::<L::Twist>::NUMBERS);
        let mut writer = Writer::new(numbers, GrainFrame::<L::Twist>::NUMBERS, ENOUGH)?;
        self.law.write(writer.part(law))?;
        let mut frame = self.frame;
        frame.stored(&mut writer)
    }

    /// Restores what [`GrainContact::pack`] of a contact with the same constants wrote into a slice
    /// of the same length. Loads are the same but for the rounding of sums.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are not a stored contact; the contact is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let mut reader = Reader::new(numbers, ENOUGH);
        let law = reader.part(numbers.len().saturating_sub(GrainFrame::<L::Twist>::NUMBERS))?;
        let mut frame = self.frame;
        frame.stored(&mut reader)?;
        for (field, vector) in [("tangent", frame.tangent), ("normal", frame.normal)] {
            let square = dot(vector, vector);
            RangeError::check(field, square.sqrt(), is_unit_or_zero(square), "of length 0 or 1")?;
        }
        self.law.read(law)?;
        self.frame = frame;
        Ok(())
    }
}

impl<T: TwistState> GrainFrame<T> {
    /// Number of numbers that are stored: all but the dashpots.
    const NUMBERS: usize = (size_of::<Self>() - size_of::<Dashpots>()) / size_of::<f64>();

    fn stored(&mut self, fields: &mut impl Fields) -> Result<(), RangeError> {
        fields.numbers("tangent", &mut self.tangent, RangeError::finite)?;
        fields.numbers("normal", &mut self.normal, RangeError::finite)?;
        let DragHeat { drag, speed } = &mut self.drag_heat;
        fields.numbers("force", &mut self.friction, RangeError::finite)?;
        fields.number("force", &mut self.drag, RangeError::finite)?;
        fields.numbers("velocity", &mut self.velocity, RangeError::finite)?;
        fields.numbers("lead", &mut self.lead, RangeError::finite)?;
        fields.number("force", drag, RangeError::finite)?;
        fields.number("velocity", speed, RangeError::finite)?;
        fields.number("approach", &mut self.approach, RangeError::finite)?;
        twisted::stored(&mut self.twist, fields)
    }
}
