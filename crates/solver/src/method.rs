//! The trait of the solution methods.

use crate::accuracy::MeshOrder;
use crate::convergence::{Convergence, Observer};
use crate::drive::Drive;
use crate::problem::ContactProblem;
use crate::state::ContactState;

/// A method that advances a numerical contact by one step of its load history.
///
/// All methods solve the same [`ContactProblem`] and write the same [`ContactState`], so that one
/// can be checked against another.
pub trait Method {
    /// Why a step failed.
    type Error: std::error::Error + Send + Sync + 'static;

    /// Working memory, reused between steps.
    type Scratch: Clone;

    /// The order in which its tangential loads and shifts converge with the width of a cell.
    fn mesh_order(&self) -> MeshOrder {
        MeshOrder::Second
    }

    /// Allocates the working memory for a problem.
    ///
    /// # Errors
    /// The method's error: a problem that it cannot solve, or too little memory.
    fn scratch(&self, problem: &ContactProblem) -> Result<Self::Scratch, Self::Error>;

    /// Computes the state at the end of a step from the state `from` before it, and writes it to
    /// `to`.
    ///
    /// # Errors
    /// The method's error, for example if it does not converge. The content of `to` is then
    /// meaningless; `from` is unchanged.
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
