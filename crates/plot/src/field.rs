//! A quantity over a plane: values on a rectangular grid, drawn as colours with contour lines.

use crate::error::PlotError;

/// Values at the nodes of a grid, blue below zero and orange above.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Label of the colour bar.
    pub label: String,
    x: Vec<f64>,
    y: Vec<f64>,
    values: Vec<f64>,
}

impl Field {
    /// A field of the nodes along both axes and the values, row by row: one row for each y with one
    /// value for each x.
    ///
    /// # Errors
    /// [`PlotError::Grid`] unless there are two nodes or more along each axis, finite and
    /// increasing, and a finite value for each pair.
    pub fn new(
        label: impl Into<String>,
        x: Vec<f64>,
        y: Vec<f64>,
        values: Vec<f64>,
    ) -> Result<Self, PlotError> {
        let label = label.into();
        let is_grid = |nodes: &[f64]| {
            nodes.len() > 1
                && nodes.iter().all(|node| node.is_finite())
                && nodes.windows(2).all(|pair| pair[0] < pair[1])
        };
        let fits = x.len() * y.len() == values.len() && values.iter().all(|v| v.is_finite());
        if !(is_grid(&x) && is_grid(&y) && fits) {
            return Err(PlotError::Grid { label });
        }
        Ok(Self { label, x, y, values })
    }

    /// The nodes along the horizontal axis.
    #[must_use]
    pub fn x(&self) -> &[f64] {
        &self.x
    }

    /// The nodes along the vertical axis.
    #[must_use]
    pub fn y(&self) -> &[f64] {
        &self.y
    }

    /// The value at the node of this column and row.
    pub(crate) fn at(&self, column: usize, row: usize) -> f64 {
        self.values[row * self.x.len() + column]
    }

    /// The smallest and the largest value.
    pub(crate) fn range(&self) -> [f64; 2] {
        self.values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(*value), high.max(*value)]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_grid_is_refused() {
        let make = |x: &[f64], y: &[f64], values: &[f64]| {
            Field::new("q", x.to_vec(), y.to_vec(), values.to_vec())
        };
        assert!(make(&[0.0, 1.0], &[0.0, 1.0], &[1.0; 4]).is_ok());
        for (x, y, values) in [
            (&[0.0, 1.0][..], &[0.0, 1.0][..], &[1.0; 3][..]),
            (&[0.0], &[0.0, 1.0], &[1.0; 2]),
            (&[0.0, 0.0], &[0.0, 1.0], &[1.0; 4]),
            (&[0.0, f64::INFINITY], &[0.0, 1.0], &[1.0; 4]),
            (&[0.0, 1.0], &[0.0, 1.0], &[1.0, 1.0, f64::NAN, 1.0]),
        ] {
            assert_eq!(make(x, y, values), Err(PlotError::Grid { label: "q".to_owned() }));
        }
    }
}
