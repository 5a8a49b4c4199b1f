//! The tangential problem on one grid, and its stopping criteria.

use carom_halfspace::operator::SurfaceOperator;

use super::rigid::Rigid;
use crate::state::CellState;

/// The problem and its solution. All fields are on the operator's grid or, once compressed, on the
/// cells of the contact.
pub(crate) struct TangentialTask<'a> {
    pub(crate) operator: &'a dyn SurfaceOperator,
    /// Traction bounds: zero outside the contact, infinite where the surfaces cannot slip.
    pub(crate) limits: &'a [f64],
    /// The displacement c without tangential tractions, minus the prescribed shifts.
    pub(crate) offset: [&'a [f64]; 2],
    /// Prescribed loads, and the shifts found for them.
    pub(crate) rigid: Rigid,
    /// The greatest pressure: a bound above it may never be reached.
    pub(crate) pressure: f64,
    /// Initial tractions and solution.
    pub(crate) traction: [&'a mut [f64]; 2],
    /// Initial states of the cells and those of the solution.
    pub(crate) cells: &'a mut [CellState],
}

/// Stopping criteria.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// Greatest violation of the friction law relative to the greatest friction bound.
    pub(super) tolerance: f64,
    /// The iteration also stops when correction and violation, in norm, fall below this fraction of
    /// the tractions; zero: it stops at the tolerance only.
    pub(super) change: f64,
    pub(super) iterations: usize,
}
