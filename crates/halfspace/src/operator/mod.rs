//! Translation-invariant influence on a grid: every cell acts on every other by their offset.
//!
//! [`SurfaceOperator`] has two faces: `apply`, the product with all cells by zero-padded
//! Fourier transforms (exact to rounding, no period is felt), and `coefficients`, one entry for
//! dense and Gauss-Seidel solvers. [`HalfSpaceOperator`] is the elastic half-space of (4.14);
//! [`PeriodicOperator`] the same under tractions that repeat themselves;
//! [`TabulatedKernel`] a measured or computed point response of another body (section 16.2).

mod error;
mod field;
mod interior;
mod length;
mod memory;
mod periodic;
mod plan;
mod product;
mod spectrum;
mod table;
mod tabulated;
mod toeplitz;
mod torus;
mod workspace;

pub use error::OperatorError;
pub use field::{Axis, DisplacementField, TractionField};
pub use interior::{InteriorStress, StressField};
pub use length::transform_length;
pub use periodic::PeriodicOperator;
pub use plan::Threads;
pub use table::{Blocks, CoefficientTable};
pub use tabulated::{KernelOperator, TabulatedKernel};
pub use toeplitz::HalfSpaceOperator;
pub use torus::TorusInverse;
pub use workspace::Workspace;

use crate::{Coefficients, Grid};

/// A translation-invariant influence of tractions on displacements on one grid.
pub trait SurfaceOperator: Send + Sync {
    /// The grid.
    fn grid(&self) -> Grid;

    /// Whether normal tractions displace tangentially and the converse.
    fn is_coupled(&self) -> bool;

    /// Whether tangential tractions along x displace nothing along y and the converse, as without
    /// lateral contraction.
    fn is_separate(&self) -> bool {
        false
    }

    /// Whether an even traction on all cells displaces them; not on a period, where displacements are
    /// those against the mean plane.
    fn displaces_on_average(&self) -> bool {
        true
    }

    /// The nine coefficients of a source `columns` cells along x and `rows` cells along y from
    /// the receiver, n - k and m - j in (4.23); zero beyond the extent of the grid.
    fn coefficients(&self, columns: i32, rows: i32) -> Coefficients;

    /// An approximate inverse of the normal block, for methods that precondition; none unless the
    /// operator knows one.
    fn inverse(&self) -> Option<TorusInverse> {
        None
    }

    /// The same influence on cells twice as wide, with half as many (rounded up) along each axis;
    /// none unless the operator can be built on any grid.
    ///
    /// # Errors
    /// As the operator's constructor.
    fn coarser(&self) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        None
    }

    /// The same influence on fewer cells of the same widths; none unless that is one on the part of
    /// the grid alone.
    ///
    /// # Errors
    /// [`OperatorError::TooLarge`] for memory, [`OperatorError::Range`] for more cells or none.
    fn on_fewer(
        &self,
        _nx: usize,
        _ny: usize,
    ) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        None
    }

    /// The working memory of repeated products.
    fn workspace(&self) -> Workspace {
        Workspace::default()
    }

    /// The displacements of all cells by the tractions on all cells.
    ///
    /// Tractions that are `None` are zero and displacements that are `None` are not computed;
    /// neither costs time. After the first call nothing is allocated (a thread pool may, for
    /// its own queues).
    ///
    /// # Errors
    /// [`OperatorError`] for fields of another size than the grid, tractions that are not
    /// finite and blocks of the matrix that the operator does not hold. Displacements are
    /// written only on success.
    fn apply(
        &self,
        tractions: TractionField<'_>,
        displacements: DisplacementField<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError>;
}
