//! The gap between the undeformed surfaces on a grid.

mod height_map;
mod outline;
mod rough;
mod shapes;
mod surfaces;

pub use height_map::{HeightMap, HeightMapError};
pub use outline::Outline;
pub use rough::SelfAffine;
pub use shapes::Shape;

use std::sync::Arc;

use carom_halfspace::operator::Threads;
use carom_halfspace::{Field, Grid};
use carom_laws::curvature::RelativeCurvature;
use carom_special::RangeError;

use crate::nested::coarser;

/// The distance of the undeformed surfaces at the cell centres, zero at first contact (11.1).
/// Clones are cheap: they share the heights.
///
/// ```
/// use carom_halfspace::Grid;
/// use carom_laws::curvature::RelativeCurvature;
/// use carom_solver::Gap;
/// let grid = Grid::new(3, 3, 0.1, 0.1)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(1.0, 0.5)?);
/// assert_eq!(gap.heights().get(1, 1), Some(&0.0));
/// assert!((gap.heights().get(2, 1).unwrap() - 0.01).abs() < 1e-17);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Gap {
    heights: Arc<Field>,
}

impl Gap {
    /// The paraboloid A x^2 + B y^2 (3.5), (12.1) about the centre of the grid.
    #[must_use]
    pub fn of_curvature(grid: Grid, curvature: &RelativeCurvature) -> Self {
        let heights = Field::from_function(grid, |x, y| curvature.gap(x, y));
        Self { heights: Arc::new(heights) }
    }

    /// An arbitrary shape: `height` at (x, y) from the centre of the grid, infinite where there is
    /// no body.
    ///
    /// # Errors
    /// As [`Gap::new`].
    pub fn from_function(grid: Grid, height: impl Fn(f64, f64) -> f64) -> Result<Self, RangeError> {
        Self::new(Field::from_function(grid, height))
    }

    /// Given heights, infinite where there is no body.
    ///
    /// # Errors
    /// [`RangeError`] for a height that is NaN or minus infinity, and if no height is finite.
    pub fn new(heights: Field) -> Result<Self, RangeError> {
        for &height in heights.values() {
            RangeError::check("gap", height, height > f64::NEG_INFINITY, "a number or +inf")?;
        }
        let body = heights.values().iter().any(|height| height.is_finite());
        RangeError::check("gap", f64::INFINITY, body, "finite in at least one cell")?;
        Ok(Self { heights: Arc::new(heights) })
    }

    /// The same surfaces on cells twice as wide: the mean of four points in each cell; infinite if
    /// there is no body at one of them.
    ///
    /// # Errors
    /// As [`Gap::new`]; also if a cell width overflows.
    pub fn coarser(&self) -> Result<Self, RangeError> {
        let grid = self.grid().coarser()?;
        let heights = coarser(self.grid(), self.heights.values(), grid, Threads::One);
        Self::new(Field::new(grid, heights)?)
    }

    /// The same surfaces on a grid to which doubling the width of the cells leads, once or more.
    ///
    /// # Errors
    /// [`RangeError`] if it leads to no such grid; as [`Gap::coarser`].
    pub fn coarsened_to(&self, grid: Grid) -> Result<Self, RangeError> {
        let mut own = self.clone();
        while own.grid() != grid && own.grid().cells() > grid.cells() {
            own = own.coarser()?;
        }
        let holds = own.grid() == grid;
        RangeError::check("nx", grid.nx() as f64, holds, "that of a coarser grid")?;
        Ok(own)
    }

    /// The grid.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.heights.grid()
    }

    /// The gap at the cell centres.
    #[must_use]
    pub fn heights(&self) -> &Field {
        &self.heights
    }

    /// The same, shared.
    pub(crate) const fn shared_heights(&self) -> &Arc<Field> {
        &self.heights
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flat_punch_has_no_body_outside() {
        let grid = Grid::new(5, 4, 0.5, 0.5).unwrap();
        let punch = |x: f64, y: f64| if x.hypot(y) < 0.6 { 0.0 } else { f64::INFINITY };
        let gap = Gap::from_function(grid, punch).unwrap();
        let solid = gap.heights().values().iter().filter(|height| height.is_finite());
        assert_eq!(solid.count(), 6);
        for bad in [f64::NAN, f64::NEG_INFINITY, f64::INFINITY] {
            assert_eq!(Gap::from_function(grid, |_, _| bad).unwrap_err().field, "gap");
        }
    }
}
