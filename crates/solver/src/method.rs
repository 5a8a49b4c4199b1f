//! The trait of a solution method.

use carom_laws::law::Shift;

use crate::problem::Problem;
use crate::state::ContactState;

/// A method that advances a numerical contact by one step of its load history.
///
/// Methods are values: all solve the same [`Problem`] and return the same [`ContactState`], so
/// that one can be checked against another. None is part of this version.
pub trait Method {
    /// Why a step failed.
    type Error: std::error::Error + Send + Sync + 'static;

    /// The state after going from `state` to the rigid shift `shift`; `state` itself is kept.
    ///
    /// # Errors
    /// The method's own, not converging among them.
    fn step(
        &self,
        problem: &Problem,
        state: &ContactState,
        shift: Shift,
    ) -> Result<ContactState, Self::Error>;
}
