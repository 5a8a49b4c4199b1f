//! A quantity over a plane: values on a rectangular grid, drawn as colours with contour lines.

use crate::error::PlotError;

/// Values at the nodes of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Label of the colour bar.
    pub label: String,
    /// The value with the neutral colour; below it is blue, above it orange.
    pub centre: f64,
    x: Vec<f64>,
    y: Vec<f64>,
    values: Vec<f64>,
}

impl Field {
    /// From the nodes along both axes and the values, row by row: one row for each y, in it one
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
        Ok(Self { label, centre: 0.0, x, y, values })
    }

    /// With another neutral value than zero.
    #[must_use]
    pub const fn centred(mut self, centre: f64) -> Self {
        self.centre = centre;
        self
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

    /// The least and the greatest value.
    pub(crate) fn range(&self) -> [f64; 2] {
        self.values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(*value), high.max(*value)]
        })
    }
}

/// A piece of a contour line, in the coordinates of the field.
pub(crate) type Piece = [(f64, f64); 2];

/// The contour line of `level`: straight pieces across the triangles of each cell, whose middle
/// has the mean of its corners.
pub(crate) fn contour(field: &Field, level: f64) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for row in 0..field.y.len() - 1 {
        for column in 0..field.x.len() - 1 {
            let node = |i: usize, j: usize| {
                (field.x[column + i], field.y[row + j], field.at(column + i, row + j))
            };
            let corners = [node(0, 0), node(1, 0), node(1, 1), node(0, 1)];
            let above = corners.iter().filter(|corner| corner.2 >= level).count();
            if above == 0 || above == 4 {
                continue;
            }
            let mean = |of: fn(&(f64, f64, f64)) -> f64| corners.iter().map(of).sum::<f64>() / 4.0;
            let middle = (mean(|c| c.0), mean(|c| c.1), mean(|c| c.2));
            for i in 0..4 {
                pieces.extend(across([corners[i], corners[(i + 1) % 4], middle], level));
            }
        }
    }
    pieces
}

/// Where the level crosses a triangle.
fn across(corners: [(f64, f64, f64); 3], level: f64) -> Option<Piece> {
    let mut ends = [0, 1, 2].into_iter().filter_map(|i| {
        let ((x_1, y_1, v_1), (x_2, y_2, v_2)) = (corners[i], corners[(i + 1) % 3]);
        if (v_1 >= level) == (v_2 >= level) {
            return None;
        }
        let part = (level - v_1) / (v_2 - v_1);
        Some((x_1 + part * (x_2 - x_1), y_1 + part * (y_2 - y_1)))
    });
    Some([ends.next()?, ends.next()?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::series::linspace;

    fn cone(n: usize) -> Field {
        let nodes = linspace(-1.0, 1.0, n);
        let values =
            nodes.iter().flat_map(|y| nodes.iter().map(move |x| libm::hypot(*x, *y))).collect();
        Field::new("r", nodes.clone(), nodes, values).unwrap()
    }

    #[test]
    fn contours_of_a_cone_are_circles() {
        let pieces = contour(&cone(81), 0.6);
        let mut length = 0.0;
        for [(x_1, y_1), (x_2, y_2)] in pieces {
            assert!((libm::hypot(x_1, y_1) - 0.6).abs() < 2e-4);
            length += libm::hypot(x_2 - x_1, y_2 - y_1);
        }
        assert!((length / (1.2 * std::f64::consts::PI) - 1.0).abs() < 2e-3, "{length}");
        assert!(contour(&cone(9), 2.0).is_empty() && contour(&cone(9), -1.0).is_empty());
    }

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
