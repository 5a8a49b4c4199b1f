//! The turn of slip as numbers, for storage.

use super::{ANNULI, Annulus, SlipTurn};
use carom_special::RangeError;

/// Approach up to which annuli are spread, approach, shift.
const OWN: usize = 4;
/// Of an annulus: anchor, turn, whether it slips.
const EACH: usize = 4;

impl SlipTurn {
    /// Number of numbers of a stored state.
    pub const NUMBERS: usize = OWN + EACH * ANNULI;

    /// The state as numbers, without stiffness and friction.
    #[must_use]
    pub fn numbers(&self) -> Vec<f64> {
        let mut numbers = vec![self.deepest, self.zeta, self.shift[0], self.shift[1]];
        for Annulus { anchor: [x, y], turn, slips, .. } in &self.annuli {
            numbers.extend([*x, *y, *turn, f64::from(u8::from(*slips))]);
        }
        numbers
    }

    /// The same contact in a state written by [`SlipTurn::numbers`].
    ///
    /// # Errors
    /// [`RangeError`] unless these are [`SlipTurn::NUMBERS`] finite numbers, with approaches from 0.
    pub fn in_state(self, numbers: &[f64]) -> Result<Self, RangeError> {
        let count = numbers.len();
        RangeError::check("numbers", count as f64, count == Self::NUMBERS, "one turn of slip")?;
        numbers.iter().try_for_each(|number| RangeError::finite("number", *number).map(|_| ()))?;
        let (own, annuli) = numbers.split_at(OWN);
        let [deepest, zeta] = [own[0], own[1]];
        RangeError::check("deepest", deepest, deepest >= zeta, "at least the approach")?;
        RangeError::check("zeta", zeta, zeta >= 0.0, ">= 0")?;
        let annulus = |(i, stored): (usize, &[f64])| Annulus {
            turn: stored[2],
            slips: stored[3] == 1.0,
            ..Annulus::apart(deepest, i, [stored[0], stored[1]])
        };
        let annuli = annuli.chunks(EACH).enumerate().map(annulus).collect();
        Ok(Self { deepest, zeta, shift: [own[2], own[3]], annuli, ..self })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::Friction;
    use crate::law::Shift;
    use crate::stiffness::ContactStiffness;

    #[test]
    fn a_stored_turn_goes_on_with_the_same_bits() -> Result<(), RangeError> {
        let (stiffness, friction) = (ContactStiffness::new(1.0, 0.7, 1.0)?, Friction::new(0.4)?);
        let fresh = || SlipTurn::of_any_depth(stiffness, friction);
        let (mut own, mut stored) = (fresh(), fresh());
        for step in 0..90 {
            let t = 0.1 * f64::from(step);
            let (eta, xi) = libm::sincos(t);
            let shift = Shift { zeta: 0.3 + 0.2 * t, xi, eta: 0.5 * eta, omega: 0.0 };
            own.advance(shift)?;
            stored.advance(shift)?;
            stored = fresh().in_state(&stored.numbers())?;
            assert_eq!(stored, own, "{step}");
        }
        assert!(own.angle() > 0.1);
        let mut wrong = own.numbers();
        for count in [SlipTurn::NUMBERS - EACH, SlipTurn::NUMBERS + EACH] {
            let numbers = [&wrong[..], &[0.0; EACH]].concat();
            assert_eq!(fresh().in_state(&numbers[..count]).unwrap_err().field, "numbers");
        }
        wrong[7] = f64::NAN;
        assert!(fresh().in_state(&wrong).is_err());
        Ok(())
    }
}
