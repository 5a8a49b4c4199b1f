//! The influence of tractions on displacements on a grid.
//!
//! [`SurfaceOperator`] offers two views: `apply`, the product with all cells by Fourier transforms
//! (exact to rounding), and, where the effect of one cell on another depends on their offset alone,
//! `coefficients`, single entries for dense and Gauss-Seidel solvers. [`HalfSpaceOperator`] is the
//! elastic half-space of (4.14), [`PeriodicOperator`] the half-space under periodic tractions,
//! [`TabulatedKernel`] a measured or computed point response of another body (section 16.2),
//! [`PlateOperator`] a rectangular plate (proposition 3), which is not translation-invariant,
//! [`RolledOperator`] the change of displacement of particles between two steps of rolling.
//!
//! A solver needs three things beside the product. [`SurfaceOperator::inverse`] is an approximate inverse
//! ([`Preconditioner`]): for half-spaces that of a periodic surface with the sides of the grid, for a plate the
//! exact one. [`SurfaceOperator::on_fewer`] is the same influence on a part of the grid, for a step that is solved
//! about the contact only. [`SurfaceOperator::apply_roughly`] is a product in single precision, in half of the time
//! on large grids: the tangential solve of uncoupled problems takes it for its corrections and computes the slip
//! again in double precision where the error may count. [`SurfaceOperator::among`] is the normal influence among some
//! cells alone: where few cells of a large grid touch, the solver corrects their pressures with it, and checks the gap
//! of all cells with the exact product.

mod error;
mod field;
mod interior;
mod length;
mod memory;
mod passes;
mod periodic;
mod plan;
mod plate;
mod pool;
mod precision;
mod preconditioner;
mod product;
mod rolled;
mod rows;
mod sparse;
mod spectrum;
mod table;
mod tabulated;
mod threads;
mod toeplitz;
mod torus;
mod triangle;
mod validity;
mod workspace;

pub use error::OperatorError;
pub use field::{Axis, DisplacementField, TractionField};
pub use interior::{InteriorStress, StressField};
pub use length::transform_length;
pub use periodic::PeriodicOperator;
pub use plate::{Plate, PlateOperator, PlateSymbol};
pub use preconditioner::Preconditioner;
pub use rolled::RolledOperator;
pub use rows::NormalRows;
pub use sparse::SPARSENESS;
pub use table::{Blocks, CoefficientTable};
pub use tabulated::{InflcfUnits, KernelBlock, KernelOperator, TabulatedKernel};
pub use threads::Threads;
pub use toeplitz::HalfSpaceOperator;
pub use validity::Validity;
pub use workspace::Workspace;

use std::sync::Arc;

use crate::{Coefficients, Field, Grid, Offset};

/// Error of a rough product, over the greatest displacement plus what the influence of a cell on itself makes of the root of
/// the sum of all squared tractions.
///
/// The second part counts where tractions change sign from cell to cell, so that displacements are small: the forward
/// transform loses a part of the tractions, whose displacements are bounded by the product of both roots of squares, and
/// that of the influence is a few times the influence of a cell on itself. The factor is measured: it is 1.6e-7 at most for fields
/// of 4 x 4 to 1024 x 1024 cells that a search has made worse.
pub const ROUGHNESS: f64 = 1e-6;

/// An influence of tractions on displacements on one grid.
pub trait SurfaceOperator: Send + Sync {
    /// The grid.
    fn grid(&self) -> Grid;

    /// The threads on which products are computed; methods use them for their own work on the cells.
    fn threads(&self) -> Threads {
        Threads::One
    }

    /// Whether normal tractions cause tangential displacements and tangential tractions normal
    /// ones.
    fn is_coupled(&self) -> bool;

    /// Whether tangential tractions along x cause no displacement along y, and vice versa, as for a
    /// Poisson's ratio of zero.
    fn is_separate(&self) -> bool {
        false
    }

    /// Whether a uniform traction on all cells displaces them. It does not on a periodic surface,
    /// where displacements are relative to the mean plane.
    fn displaces_on_average(&self) -> bool {
        true
    }

    /// Whether the influence of one cell on another depends on their offset alone (4.23). If not,
    /// methods that need [`SurfaceOperator::coefficients`] of all offsets refuse the operator.
    fn is_invariant(&self) -> bool {
        true
    }

    /// Whether the displacement of one cell due to a traction on another equals the converse, as
    /// Betti's theorem says for displacements in one state of elastic bodies.
    fn is_reciprocal(&self) -> bool {
        true
    }

    /// Checks that the operator is translation-invariant, for methods that need it.
    ///
    /// # Errors
    /// [`OperatorError::NotInvariant`].
    fn check_invariant(&self) -> Result<(), OperatorError> {
        self.is_invariant().then_some(()).ok_or(OperatorError::NotInvariant)
    }

    /// E* of Hertz, in Pa; none if the bodies are no half-spaces.
    fn contact_modulus(&self) -> Option<f64> {
        None
    }

    /// Where the theory behind the operator ends; without bounds unless overridden.
    fn validity(&self) -> Validity {
        Validity::default()
    }

    /// The nine coefficients for a source `columns` cells along x and `rows` cells along y from the
    /// receiver, n - k and m - j in (4.23); zero beyond the extent of the grid. If the operator is
    /// not [invariant](SurfaceOperator::is_invariant), those of the middle cell, as a scale.
    fn coefficients(&self, columns: i32, rows: i32) -> Coefficients;

    /// The least normal displacement of any cell due to a unit pressure on another, if it is known to be positive.
    fn least_normal_influence(&self) -> Option<f64> {
        None
    }

    /// The normal displacement of a cell due to the pressure on it.
    fn normal_influence_of_a_cell(&self) -> f64 {
        self.coefficients(0, 0).rows[2][2]
    }

    /// The nine coefficients for a source at any offset from the receiver, source minus receiver;
    /// `None` if they are known for whole cells only.
    fn coefficients_at(&self, _offset: Offset) -> Option<Coefficients> {
        None
    }

    /// An approximate inverse, used as preconditioner; `None` if the operator has none.
    fn inverse(&self) -> Option<Arc<dyn Preconditioner>> {
        None
    }

    /// The same in half of the time on large grids, linear and symmetric to single precision only, as conjugate gradients
    /// allow that keep prescribed loads by themselves. Unless overridden, the same as [`SurfaceOperator::inverse`].
    fn rough_inverse(&self) -> Option<Arc<dyn Preconditioner>> {
        self.inverse()
    }

    /// The same influence on cells twice as wide, half as many (rounded up) along each axis; `None`
    /// if the operator cannot be built on other grids.
    ///
    /// # Errors
    /// Those of the operator's constructor.
    fn coarser(&self) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        None
    }

    /// The same influence on a smaller grid with the same cell widths; `None` if the operator
    /// cannot be restricted to a part of its grid.
    ///
    /// # Errors
    /// [`OperatorError::TooLarge`] for memory, [`OperatorError::Range`] for more cells than the
    /// grid has, or none.
    fn on_fewer(
        &self,
        _nx: usize,
        _ny: usize,
    ) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        None
    }

    /// The normal influence among some cells, in ascending order, with the errors of [`SPARSENESS`], in a time that grows
    /// with their number: for contacts that cover a small part of a large grid. Its fields hold the values of these cells.
    /// `None` unless overridden, and where the grid is too small or its cells too slender.
    fn among(&self, _cells: &[usize]) -> Option<Box<dyn SurfaceOperator>> {
        None
    }

    /// Allocates the working memory for repeated products.
    fn workspace(&self) -> Workspace {
        Workspace::default()
    }

    /// Whether [`SurfaceOperator::apply_roughly`] takes less time than [`SurfaceOperator::apply`].
    fn has_rough_products(&self) -> bool {
        false
    }

    /// As [`SurfaceOperator::apply`], with the errors of [`ROUGHNESS`], in half of the time on large grids: for iterations
    /// that check what they reach by a product without these errors. Unless overridden, the same as
    /// [`SurfaceOperator::apply`].
    ///
    /// # Errors
    /// As [`SurfaceOperator::apply`].
    fn apply_roughly(
        &self,
        tractions: TractionField<'_>,
        displacements: DisplacementField<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError> {
        self.apply(tractions, displacements, workspace)
    }

    /// The displacements of all cells due to the tractions on all cells.
    ///
    /// Tractions that are `None` are zero, displacements that are `None` are not computed; neither
    /// costs time. After the first call nothing is allocated (a thread pool may allocate for its
    /// own queues).
    ///
    /// # Errors
    /// [`OperatorError`] for fields of another size than the grid, tractions that are not finite,
    /// and blocks that the operator was built without. Displacements are written only on success.
    fn apply(
        &self,
        tractions: TractionField<'_>,
        displacements: DisplacementField<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError>;

    /// The normal displacements of all cells due to pressures alone, to be read row by row: operators that compute them by
    /// Fourier transforms keep no field of them.
    ///
    /// ```
    /// use std::sync::Mutex;
    /// use carom_halfspace::operator::{HalfSpaceOperator, SurfaceOperator as _};
    /// use carom_halfspace::{Grid, Material, MaterialPair};
    /// let body = Material::from_shear(1.0, 0.3)?;
    /// let grid = Grid::new(16, 16, 1.0, 1.0)?;
    /// let operator = HalfSpaceOperator::new(MaterialPair::new(body, body)?, grid)?;
    /// let mut workspace = operator.workspace();
    /// let deepest = Mutex::new(0.0_f64);
    /// operator.pressed(&vec![1.0; grid.cells()], &mut workspace)?.each(&|row| row == 8, &|_, displacements| {
    ///     let most = displacements.iter().copied().fold(0.0, f64::max);
    ///     *deepest.lock().unwrap() = most;
    /// });
    /// // The middle of a square of side l under p = 1 sinks by 4 l ln(1 + sqrt 2)/(pi E*); the nearest centre a little less.
    /// let exact = 4.0 * 16.0 * (1.0 + 2.0_f64.sqrt()).ln() / std::f64::consts::PI * 0.7;
    /// let most = *deepest.lock().unwrap();
    /// assert!(most < exact && most > 0.998 * exact, "{most} {exact}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`SurfaceOperator::apply`].
    fn pressed<'a>(
        &'a self,
        pressure: &[f64],
        workspace: &'a mut Workspace,
    ) -> Result<Box<dyn NormalRows + 'a>, OperatorError> {
        let mut displacement = Field::uniform(self.grid(), 0.0);
        let displacements = DisplacementField::normal(displacement.values_mut());
        self.apply(TractionField::normal(pressure), displacements, workspace)?;
        Ok(Box::new(displacement))
    }
}
