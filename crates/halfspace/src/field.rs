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
#[derive(Debug)]
pub struct Field<T = f64> {
    grid: Grid,
    values: Vec<T>,
    /// Whether no value was written since all were made equal: zeros take no memory until then, and reading them would.
    untouched: bool,
}

impl<T: PartialEq> PartialEq for Field<T> {
    fn eq(&self, other: &Self) -> bool {
        (self.grid, &self.values) == (other.grid, &other.values)
    }
}

impl<T: Clone> Clone for Field<T> {
    fn clone(&self) -> Self {
        let Self { grid, values, untouched } = self;
        match values.first().filter(|_| *untouched) {
            Some(value) => Self::uniform(*grid, value.clone()),
            None => Self { grid: *grid, values: values.clone(), untouched: false },
        }
    }

    // Reuses the memory that is already allocated.
    fn clone_from(&mut self, source: &Self) {
        if self.untouched {
            *self = source.clone();
            return;
        }
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
        Ok(Self { grid, values, untouched: false })
    }

    /// The values of a function at the cell centres, (x, y) from the centre of the grid.
    #[must_use]
    pub fn from_function(grid: Grid, value: impl Fn(f64, f64) -> T) -> Self {
        let values = grid.centres().map(|(x, y)| value(x, y)).collect();
        Self { grid, values, untouched: false }
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
        self.untouched = false;
        &mut self.values
    }

    /// A field on the same grid with a function applied to each value.
    #[must_use]
    pub fn map<U>(&self, change: impl Fn(&T) -> U) -> Field<U> {
        let values = self.values.iter().map(change).collect();
        Field { grid: self.grid, values, untouched: false }
    }
}

impl<T: Clone> Field<T> {
    /// The same value in every cell.
    #[must_use]
    pub fn uniform(grid: Grid, value: T) -> Self {
        Self { grid, values: vec![value; grid.cells()], untouched: true }
    }
}

impl Field {
    /// The sum over the cells times their area.
    #[must_use]
    pub fn integral(&self) -> f64 {
        if self.is_known_to_be_zero() {
            return 0.0;
        }
        self.grid.cell_area() * self.values.iter().sum::<f64>()
    }

    /// Whether all values are zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        // Without an exit within a part it is compiled to vectors.
        let all_zero = |part: &[f64]| part.iter().fold(true, |all, value| all & (*value == 0.0));
        self.is_known_to_be_zero() || self.values.chunks(4096).all(all_zero)
    }

    fn is_known_to_be_zero(&self) -> bool {
        self.untouched && self.values.first() == Some(&0.0)
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

    #[test]
    fn zeros_are_known_until_they_are_written() {
        let grid = Grid::new(70, 65, 0.5, 1.0).unwrap();
        for value in [0.0, -0.0] {
            let mut field = Field::uniform(grid, value);
            assert!(field.is_zero() && field.clone().is_zero() && field.integral() == 0.0);
            // Written with zeros, and with another value in the last cell.
            field.values_mut().fill(0.0);
            assert!(field.is_zero());
            field.values_mut()[grid.cells() - 1] = 1.0;
            assert!(!field.is_zero() && !field.clone().is_zero());
            assert_eq!(field.integral(), 0.5);
            // Into memory that holds values, and into zeros.
            let (mut held, mut zero) = (field.clone(), Field::uniform(grid, 0.0));
            held.clone_from(&zero);
            assert!(held.is_zero() && held == zero);
            zero.clone_from(&field);
            assert!(!zero.is_zero() && zero == field);
        }
        let ones = Field::uniform(grid, 1.0);
        assert!(!ones.is_zero() && ones.clone() == ones && ones.integral() == 2275.0);
    }
}
