//! The problem of pressures and tractions together.

use carom_halfspace::operator::SurfaceOperator;

use crate::drive::Driven;
use crate::state::CellState;
use crate::tangential::Rigid;

/// The problem and its solution.
pub(crate) struct CoupledTask<'a> {
    pub(crate) operator: &'a dyn SurfaceOperator,
    /// Distances of the surfaces at zero approach, without tractions.
    pub(crate) heights: &'a [f64],
    /// Friction coefficient of each cell.
    pub(crate) friction: &'a [f64],
    /// The slip of the cells without tractions and without the motions whose loads are prescribed.
    pub(crate) offset: [&'a [f64]; 2],
    pub(crate) normal: Driven,
    pub(crate) approach: f64,
    pub(crate) rigid: Rigid,
    pub(crate) pressure: &'a mut [f64],
    pub(crate) traction: [&'a mut [f64]; 2],
    pub(crate) cells: &'a mut [CellState],
}
