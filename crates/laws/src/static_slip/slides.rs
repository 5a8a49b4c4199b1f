//! What static friction above kinetic friction needs of a memory.

use carom_special::RangeError;

use crate::memory::{Lateral, MemoryRegime, Tangent};

/// A memory whose contact can slide as a whole.
pub(crate) trait Slides: Clone {
    /// The shift.
    type V: Lateral;
    /// The storage of its vertices.
    type Stack;

    fn approach(&self) -> f64;

    /// The shift X.
    fn place(&self) -> Self::V;

    fn phi(&self) -> Self::V;

    /// The tangent of the last step.
    fn rates(&self) -> Tangent;

    fn stage(&self) -> MemoryRegime;

    fn set_stage(&mut self, stage: MemoryRegime);

    fn is_in_contact(&self) -> bool;

    fn vertices(&self) -> &Self::Stack;

    fn stick_share(&self) -> f64;

    /// Moves a separated pair to the point of first contact on its path.
    fn begin(&mut self, zeta: f64, shift: Self::V);

    /// A step with one coefficient of friction.
    fn go(&mut self, zeta: f64, shift: Self::V);

    /// Depth and stretch X - W of as many annuli as tell whether all of them slip, the centre first.
    fn annuli(&self) -> impl Iterator<Item = (f64, Self::V)> + '_;

    /// Multiplies all stretches by a factor below 1.
    fn shrink(&mut self, by: f64);

    /// Moves the origin of the shifts.
    fn move_by(&mut self, by: Self::V);

    /// The elastic energy per direction.
    fn elastic(&self) -> Self::V;

    /// The heat of a straight step, in the given units of energy per direction.
    fn heat_of(&self, zeta: f64, shift: Self::V, unit: Self::V) -> f64;

    /// The heat, and what simplifying the memory loses or gains.
    fn loss_of(&self, zeta: f64, shift: Self::V, unit: Self::V) -> f64;

    /// The traction at a squared elliptical radius.
    fn traction_at(&self, q: f64) -> Self::V;

    /// Writes the state as numbers.
    fn write(&self, numbers: &mut [f64]) -> Result<(), RangeError>;

    /// Reads what was written.
    fn read(&mut self, numbers: &[f64]) -> Result<(), RangeError>;
}

/// The methods of [`Slides`] that forward to fields and methods which both memories have under the same names.
macro_rules! slides_by_own_names {
    () => {
        fn approach(&self) -> f64 {
            self.zeta
        }

        fn place(&self) -> Self::V {
            self.shift
        }

        fn phi(&self) -> Self::V {
            self.force
        }

        fn rates(&self) -> crate::memory::Tangent {
            self.tangent()
        }

        fn stage(&self) -> crate::memory::MemoryRegime {
            self.regime
        }

        fn is_in_contact(&self) -> bool {
            self.is_touching()
        }

        fn vertices(&self) -> &Self::Stack {
            &self.stack
        }

        fn stick_share(&self) -> f64 {
            self.stick_fraction()
        }

        fn begin(&mut self, zeta: f64, shift: Self::V) {
            self.touch(zeta, shift);
        }

        fn go(&mut self, zeta: f64, shift: Self::V) {
            self.step(zeta, shift);
        }

        fn move_by(&mut self, by: Self::V) {
            self.translate(by);
        }

        fn elastic(&self) -> Self::V {
            self.stored_energy()
        }

        fn heat_of(&self, zeta: f64, shift: Self::V, unit: Self::V) -> f64 {
            self.heat(zeta, shift, unit)
        }

        fn loss_of(&self, zeta: f64, shift: Self::V, unit: Self::V) -> f64 {
            self.lost(zeta, shift, unit)
        }

        fn traction_at(&self, q: f64) -> Self::V {
            self.traction(q)
        }

        fn write(&self, numbers: &mut [f64]) -> Result<(), carom_special::RangeError> {
            self.pack(numbers)
        }

        fn read(&mut self, numbers: &[f64]) -> Result<(), carom_special::RangeError> {
            self.unpack(numbers)
        }
    };
}
pub(crate) use slides_by_own_names;
