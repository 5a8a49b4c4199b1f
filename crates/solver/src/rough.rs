//! Where products and inverses of an operator may be rough: in single precision.

use std::sync::Arc;

use carom_halfspace::operator::{Preconditioner, SurfaceOperator};

/// Whether corrections may take rough products. In coupled problems they may not: at great friction, normal and
/// tangential solves in turn magnify the smallest difference.
pub(crate) fn takes_rough(operator: &dyn SurfaceOperator) -> bool {
    operator.has_rough_products() && !operator.is_coupled()
}

/// The inverse of an operator, rough if it may be.
pub(crate) fn inverse_of(operator: &dyn SurfaceOperator) -> Option<Arc<dyn Preconditioner>> {
    if takes_rough(operator) { operator.rough_inverse() } else { operator.inverse() }
}
