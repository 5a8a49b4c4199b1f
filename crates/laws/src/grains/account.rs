//! Whether a step of a law books its loss.

use carom_special::RangeError;

use super::law::GrainLaw;
use crate::law::{ContactLoad, Shift};
use crate::slip_lag::SlipLag;

/// How a step moves the law.
pub(super) trait Account {
    fn advance<L: GrainLaw>(
        &mut self,
        law: &mut L,
        to: Shift,
        lag: SlipLag,
    ) -> Result<ContactLoad, RangeError>;
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
    fn advance<L: GrainLaw>(
        &mut self,
        law: &mut L,
        to: Shift,
        lag: SlipLag,
    ) -> Result<ContactLoad, RangeError> {
        law.advance_lagging(to, lag)
    }
}

impl Account for Accounted {
    #[inline]
    fn advance<L: GrainLaw>(
        &mut self,
        law: &mut L,
        to: Shift,
        lag: SlipLag,
    ) -> Result<ContactLoad, RangeError> {
        let (load, loss) = law.advance_with_loss(to, lag)?;
        self.loss = loss;
        Ok(load)
    }
}
