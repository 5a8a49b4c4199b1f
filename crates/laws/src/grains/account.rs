//! Whether a step of a law books its loss.

use carom_special::RangeError;

use super::law::GrainLaw;
use crate::law::{ContactLoad, Shift};

/// How a step moves the law.
pub(super) trait Account {
    fn advance<L: GrainLaw>(&mut self, law: &mut L, to: Shift) -> Result<ContactLoad, RangeError>;
}

/// Nothing is booked.
pub(super) struct Unaccounted;

/// The loss of the step.
#[derive(Default)]
pub(super) struct Accounted {
    pub(super) loss: f64,
}

impl Account for Unaccounted {
    #[inline(always)]
    fn advance<L: GrainLaw>(&mut self, law: &mut L, to: Shift) -> Result<ContactLoad, RangeError> {
        law.advance(to)
    }
}

impl Account for Accounted {
    #[inline]
    fn advance<L: GrainLaw>(&mut self, law: &mut L, to: Shift) -> Result<ContactLoad, RangeError> {
        let (load, loss) = law.advance_with_loss(to)?;
        self.loss = loss;
        Ok(load)
    }
}
