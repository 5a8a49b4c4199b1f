//! The gap between the undeformed bodies over a grid.

use carom_halfspace::Grid;
use carom_laws::curvature::RelativeCurvature;
use carom_special::RangeError;

/// Distance of the undeformed surfaces at the centres of the cells, zero at first touch (11.1).
///
/// ```
/// use carom_halfspace::Grid;
/// use carom_laws::curvature::RelativeCurvature;
/// use carom_solver::Gap;
/// let grid = Grid::new(3, 3, 0.1, 0.1)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(1.0, 0.5)?);
/// assert_eq!(gap.at(grid.index(1, 1)), 0.0);
/// assert!((gap.at(grid.index(2, 1)) - 0.01).abs() < 1e-17);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Gap {
    grid: Grid,
    heights: Vec<f64>,
}

impl Gap {
    /// The paraboloid A x^2 + B y^2 (3.5) about the middle of the grid.
    #[must_use]
    pub fn of_curvature(grid: Grid, curvature: &RelativeCurvature) -> Self {
        Self::sampled(grid, |x, y| curvature.gap(x, y))
    }

    /// Any shape: `height` at (x, y) from the middle of the grid, infinite where no body is.
    ///
    /// # Errors
    /// [`RangeError`] for a height that is not a number or minus infinity.
    pub fn from_function(grid: Grid, height: impl Fn(f64, f64) -> f64) -> Result<Self, RangeError> {
        let gap = Self::sampled(grid, height);
        for &height in &gap.heights {
            RangeError::check("gap", height, height > f64::NEG_INFINITY, "a number or +inf")?;
        }
        Ok(gap)
    }

    fn sampled(grid: Grid, height: impl Fn(f64, f64) -> f64) -> Self {
        let rows = (0..grid.ny()).flat_map(|iy| (0..grid.nx()).map(move |ix| (ix, iy)));
        let heights = rows.map(|(ix, iy)| height(grid.centred_x(ix), grid.centred_y(iy))).collect();
        Self { grid, heights }
    }

    /// The grid.
    #[must_use]
    pub const fn grid(&self) -> Grid {
        self.grid
    }

    /// The gap at a cell.
    #[must_use]
    pub fn at(&self, cell: usize) -> f64 {
        self.heights[cell]
    }

    /// The gap at all cells.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
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
        assert_eq!(gap.heights().iter().filter(|height| height.is_finite()).count(), 6);
        let bad = Gap::from_function(grid, |_, _| f64::NAN);
        assert_eq!(bad.unwrap_err().field, "gap");
    }
}
