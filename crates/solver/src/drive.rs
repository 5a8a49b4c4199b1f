//! The prescribed values of a step: for each of the four motions a shift or a load.

use carom_laws::law::Shift;
use carom_special::RangeError;

use crate::state::ContactState;

/// A change of approach or force by at most this fraction is small.
const SMALL_STEP: f64 = 0.1;

/// The largest shift or load: squares and products of such values are finite.
const LARGEST: f64 = 1e100;

/// The prescribed value of one relative motion of the bodies, at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Driven {
    /// The rigid shift or twist is prescribed; the load follows.
    Shift(f64),
    /// The load is prescribed; the rigid shift or twist follows.
    Load(f64),
}

impl Driven {
    /// The prescribed value, shift or load.
    #[must_use]
    pub const fn value(self) -> f64 {
        match self {
            Self::Shift(value) | Self::Load(value) => value,
        }
    }
}

/// The end of a step: approach, shifts along x and y, and twist, each prescribed as shift or as
/// load.
///
/// ```
/// use carom_solver::{Drive, Driven};
/// let pressed = Drive { normal: Driven::Load(10.0), ..Drive::default() };
/// assert!(pressed.check().is_ok());
/// let error = Drive { x: Driven::Shift(f64::NAN), ..pressed }.check().unwrap_err();
/// assert_eq!(error.field, "xi");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    /// Approach zeta or normal force F_z.
    pub normal: Driven,
    /// Shift xi or force F_x.
    pub x: Driven,
    /// Shift eta or force F_y.
    pub y: Driven,
    /// Twist Omega or torque M_z.
    pub twist: Driven,
}

impl Drive {
    /// Prescribes all four motions by their shifts.
    #[must_use]
    pub const fn by_shift(shift: Shift) -> Self {
        Self {
            normal: Driven::Shift(shift.zeta),
            x: Driven::Shift(shift.xi),
            y: Driven::Shift(shift.eta),
            twist: Driven::Shift(shift.omega),
        }
    }

    /// The shift after the step as far as it is prescribed; where a load is prescribed, the shift
    /// before the step.
    #[must_use]
    pub fn shift_after(&self, before: Shift) -> Shift {
        let given = |driven, before| match driven {
            Driven::Shift(shift) => shift,
            Driven::Load(_) => before,
        };
        Shift {
            zeta: given(self.normal, before.zeta),
            xi: given(self.x, before.xi),
            eta: given(self.y, before.eta),
            omega: given(self.twist, before.omega),
        }
    }

    /// Whether approach or force changes so little that the last pressures are a better start than the
    /// solution on coarser grids.
    pub(crate) fn is_small_step(&self, from: &ContactState) -> bool {
        let (last, next) = match self.normal {
            Driven::Shift(approach) => (from.shift.zeta, approach),
            Driven::Load(force) => (from.load().f_z, force),
        };
        (next - last).abs() <= SMALL_STEP * last.abs()
            && from.pressure.values().iter().any(|pressure| *pressure > 0.0)
    }

    /// Checks that all four values are finite, so that their squares are, and that a normal force is not negative.
    ///
    /// # Errors
    /// [`RangeError`] that names the first value out of range.
    pub fn check(&self) -> Result<(), RangeError> {
        let names = [("zeta", "F_z"), ("xi", "F_x"), ("eta", "F_y"), ("omega", "M_z")];
        for (driven, (shift, load)) in
            [self.normal, self.x, self.y, self.twist].into_iter().zip(names)
        {
            let name = if matches!(driven, Driven::Shift(_)) { shift } else { load };
            let within = driven.value().abs() <= LARGEST;
            RangeError::check(name, driven.value(), within, "finite, within +-1e100")?;
        }
        if let Driven::Load(force) = self.normal {
            RangeError::non_negative("F_z", force)?;
        }
        Ok(())
    }
}

impl Default for Drive {
    /// All shifts zero: the bodies are held where they just touch.
    fn default() -> Self {
        Self::by_shift(Shift::default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_value_is_named_by_what_drives() {
        let ok = Drive::by_shift(Shift { zeta: -1.0, xi: 2.0, ..Shift::default() });
        assert!(ok.check().is_ok());
        let field = |drive: Drive| drive.check().unwrap_err().field;
        assert_eq!(field(Drive { normal: Driven::Load(-1.0), ..ok }), "F_z");
        assert_eq!(field(Drive { normal: Driven::Shift(f64::NAN), ..ok }), "zeta");
        assert_eq!(field(Drive { y: Driven::Load(f64::INFINITY), ..ok }), "F_y");
        assert_eq!(field(Drive { x: Driven::Shift(-1e150), ..ok }), "xi");
        assert_eq!(field(Drive { twist: Driven::Load(f64::NAN), ..ok }), "M_z");
    }
}
