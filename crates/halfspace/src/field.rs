//! A value for every cell of a grid.

use carom_special::RangeError;

use crate::Grid;

/// One value for each cell of a grid. The field carries its grid, so that it cannot be indexed with
/// another one, and functions of two fields can check that they match.
///
/// ```
/// use carom_halfspace::{Field, Grid};
/// let grid = Grid::new(3, 2, 0.5, 1.0)?;
/// let field = Field::from_function(grid, |x, y| x + 10.0 * y);
/// assert_eq!(field.get(2, 1), Some(&5.5));
/// assert_eq!(field.get(3, 0), None);
/// assert_eq!(field.integral(), 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, PartialEq)]
pub struct Field<T = f64> {
    grid: Grid,
    values: Vec<T>,
}

impl<T: Clone> Clone for Field<T> {
    fn clone(&self) -> Self {
        Self { grid: self.grid, values: self.values.clone() }
    }

    // Reuses the memory that is already allocated.
    fn clone_from(&mut self, source: &Self) {
        self.grid = source.grid;
        self.values.clone_from(&source.values);
    }
}

impl<T> Field<T> {
    /// From values in the order of the cells, x running fastest.
    ///
    /// # Errors
    /// [`RangeError`] unless there is one value for each cell.
    pub fn new(grid: Grid, values: Vec<T>) -> Result<Self, RangeError> {
        let (count, holds) = (values.len() as f64, values.len() == grid.cells());
        RangeError::check("number of values", count, holds, "one for each cell of the grid")?;
        Ok(Self { grid, values })
    }

    /// The values of a function at the cell centres, (x, y) from the centre of the grid.
    #[must_use]
    pub fn from_function(grid: Grid, value: impl Fn(f64, f64) -> T) -> Self {
        let values = grid.centres().map(|(x, y)| value(x, y)).collect();
        Self { grid, values }
    }

    /// The grid.
    #[must_use]
    pub const fn grid(&self) -> Grid {
        self.grid
    }

    /// The value in a column and a row; `None` beyond the grid.
    #[must_use]
    pub fn get(&self, column: usize, row: usize) -> Option<&T> {
        let inside = column < self.grid.nx() && row < self.grid.ny();
        inside.then(|| &self.values[self.grid.index(column, row)])
    }

    /// All values, x running fastest.
    #[must_use]
    pub fn values(&self) -> &[T] {
        &self.values
    }

    /// All values, mutable.
    #[must_use]
    pub fn values_mut(&mut self) -> &mut [T] {
        &mut self.values
    }

    /// A field on the same grid with a function applied to each value.
    #[must_use]
    pub fn map<U>(&self, change: impl Fn(&T) -> U) -> Field<U> {
        Field { grid: self.grid, values: self.values.iter().map(change).collect() }
    }
}

impl<T: Clone> Field<T> {
    /// The same value in every cell.
    #[must_use]
    pub fn uniform(grid: Grid, value: T) -> Self {
        Self { grid, values: vec![value; grid.cells()] }
    }
}

impl Field {
    /// The sum over the cells times their area.
    #[must_use]
    pub fn integral(&self) -> f64 {
        self.grid.cell_area() * self.values.iter().sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_belong_to_cells() {
        let grid = Grid::new(4, 3, 0.5, 0.25).unwrap();
        assert_eq!(Field::new(grid, vec![0.0; 11]).unwrap_err().field, "number of values");
        let mut field = Field::uniform(grid, 2.0);
        assert_eq!(field.integral(), 2.0 * 12.0 * 0.125);
        field.values_mut()[grid.index(3, 2)] = 5.0;
        assert_eq!(field.get(3, 2), Some(&5.0));
        assert_eq!((field.get(4, 0), field.get(0, 3)), (None, None));
        assert_eq!(field.map(|value| *value > 3.0).values().iter().filter(|big| **big).count(), 1);
    }
}
