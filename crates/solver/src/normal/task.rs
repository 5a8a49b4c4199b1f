//! The normal problem on one grid, and its stopping criteria.

use carom_halfspace::operator::SurfaceOperator;

use crate::drive::Driven;

/// Grids with fewer cells are solved on all cells, by exact products, and keep their memory.
pub(super) const LARGE: usize = 1 << 16;

/// Stopping criteria.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// Greatest violation relative to the greatest displacement.
    pub(super) tolerance: f64,
    /// The iteration also stops when correction and violation, in norm, fall below this fraction of
    /// the pressure; zero: it stops at the tolerance only.
    pub(super) change: f64,
    pub(super) iterations: usize,
}

/// The problem and its solution: pressure and approach.
pub(super) struct NormalTask<'a> {
    pub(super) operator: &'a dyn SurfaceOperator,
    /// Distances of the surfaces at zero approach.
    pub(super) heights: &'a [f64],
    pub(super) driven: Driven,
    /// The initial pressure, positive somewhere, and the solution.
    pub(super) pressure: &'a mut [f64],
    pub(super) approach: f64,
}

/// Removes tension within the tolerance, and scales the pressures to a prescribed force. Zeros are not written: pages of
/// them take no memory.
pub(super) fn finish(task: &mut NormalTask<'_>) {
    for pressure in task.pressure.iter_mut().filter(|pressure| **pressure != 0.0) {
        *pressure = pressure.max(0.0);
    }
    if let Driven::Load(force) = task.driven {
        // In the order in which the integral of a field is taken: the force is that which was prescribed, to the last bit.
        let sum = task.operator.grid().cell_area() * task.pressure.iter().sum::<f64>();
        if sum > 0.0 {
            for pressure in task.pressure.iter_mut().filter(|pressure| **pressure != 0.0) {
                *pressure *= force / sum;
            }
        }
    }
}
