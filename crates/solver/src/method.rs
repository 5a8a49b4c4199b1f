//! The trait of a solution method.

use crate::convergence::{Convergence, Observer};
use crate::drive::Drive;
use crate::problem::ContactProblem;
use crate::state::ContactState;

/// A method that advances a numerical contact by one step of its load history.
///
/// Methods are values: all solve the same [`ContactProblem`] and write the same [`ContactState`],
/// so that one can be checked against another.
pub trait Method {
    /// Why a step failed.
    type Error: std::error::Error + Send + Sync + 'static;

    /// Working memory, kept between steps.
    type Scratch: Clone;

    /// Working memory for a problem.
    ///
    /// # Errors
    /// The method's own: a problem that it cannot solve, or too little memory.
    fn scratch(&self, problem: &ContactProblem) -> Result<Self::Scratch, Self::Error>;

    /// Goes from the state `from` to the end of a step and writes the state there to `to`.
    ///
    /// # Errors
    /// The method's own, not converging among them; `to` is then of no use, `from` as it was.
    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut Self::Scratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, Self::Error>;
}
