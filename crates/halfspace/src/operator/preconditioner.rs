//! What a solver uses instead of the exact inverse.

use std::sync::Arc;

use super::Workspace;
use crate::Offset;

/// An approximate inverse of an operator: tractions from displacements, in the order of the grid.
///
/// As a preconditioner of conjugate gradients it must be linear, symmetric and positive definite.
/// After the first call with a workspace nothing is allocated.
pub trait Preconditioner: Send + Sync {
    /// The pressure that causes this normal displacement, approximately.
    ///
    /// # Panics
    /// If the length of a field differs from the number of cells.
    fn pressure(&self, displacement: &[f64], pressure: &mut [f64], workspace: &mut Workspace);

    /// The tangential tractions that cause these displacements, approximately. Displacements that
    /// are `None` are zero; tractions that are `None` are not computed. Unless overridden, each
    /// traction is the displacement itself: no preconditioning.
    ///
    /// # Panics
    /// As [`Preconditioner::pressure`].
    fn traction(
        &self,
        displacement: [Option<&[f64]>; 2],
        traction: [Option<&mut [f64]>; 2],
        _workspace: &mut Workspace,
    ) {
        for (given, field) in displacement.into_iter().zip(traction) {
            match (given, field) {
                (Some(given), Some(field)) => field.copy_from_slice(given),
                (None, Some(field)) => field.fill(0.0),
                (_, None) => {}
            }
        }
    }

    /// The inverse for `part` times the change of displacement of particles that come from `ahead`
    /// in a step of rolling, which is not symmetric; `None` if there is none.
    fn rolled(&self, _ahead: Offset, _part: f64) -> Option<Arc<dyn Preconditioner>> {
        None
    }
}
