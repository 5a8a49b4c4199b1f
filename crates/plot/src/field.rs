//! A quantity over a plane: values on a rectangular grid, drawn as colours with contour lines, or
//! cells of a few kinds, each kind in its colour.

use crate::error::PlotError;
use crate::panel::Limits;

/// Values at the nodes of a grid, blue below zero and orange above, or the kinds of its cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Label of the colour bar.
    pub label: String,
    x: Vec<f64>,
    y: Vec<f64>,
    /// For kinds: 0 where there is none, 1 for the first kind.
    values: Vec<f64>,
    kinds: Vec<String>,
}

/// Part of its length by which the axes of a map of kinds extend beyond its cells.
const MARGIN: f64 = 0.03;

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
        Ok(Self { label, x, y, values, kinds: Vec::new() })
    }

    /// A map of cells, each of one of the named kinds or of none, with a legend of the kinds that occur
    /// instead of a colour bar. `x` and `y` are the centres of the cells; rows as in
    /// [`Field::new`].
    ///
    /// ```
    /// use carom_plot::{Field, Panel, render};
    /// let kinds = vec![Some(0), Some(1), None, Some(1)];
    /// let map = Field::of_kinds(["stick", "slip"], vec![0.0, 1.0], vec![0.0, 1.0], kinds)?;
    /// assert!(render("", &[Panel::new("x", "y").over(map)])?.contains(">stick<"));
    /// # Ok::<(), carom_plot::PlotError>(())
    /// ```
    ///
    /// # Errors
    /// [`PlotError::Kind`] for a kind without a name, and as [`Field::new`].
    pub fn of_kinds<S: Into<String>>(
        names: impl IntoIterator<Item = S>,
        x: Vec<f64>,
        y: Vec<f64>,
        kinds: Vec<Option<usize>>,
    ) -> Result<Self, PlotError> {
        let names: Vec<String> = names.into_iter().map(Into::into).collect();
        let count = names.len();
        if let Some(kind) = kinds.iter().flatten().copied().find(|kind| *kind >= count) {
            return Err(PlotError::Kind { kind, count });
        }
        let values = kinds.into_iter().map(|kind| kind.map_or(0.0, |kind| kind as f64 + 1.0));
        let mut field = Self::new(names.join(", "), x, y, values.collect())?;
        field.kinds = names;
        field.label = field.present().map(|(_, name)| name).collect::<Vec<_>>().join(", ");
        Ok(field)
    }

    /// The names of the kinds; none for a field of values.
    pub(crate) fn kinds(&self) -> &[String] {
        &self.kinds
    }

    /// The kinds of which there are cells, with their numbers from 1.
    pub(crate) fn present(&self) -> impl Iterator<Item = (usize, &str)> {
        let is_there = |number: &usize| self.values.iter().any(|value| *value as usize == *number);
        let kinds = self.kinds.iter().enumerate().map(|(i, name)| (i + 1, name.as_str()));
        kinds.filter(move |(number, _)| is_there(number))
    }

    /// The ends of an axis over these nodes: the first and the last node, or beyond the cells of a
    /// map of kinds.
    pub(crate) fn ends(&self, nodes: &[f64]) -> Limits {
        let [low, high] = self.cell_ends(nodes);
        let margin = if self.kinds.is_empty() { 0.0 } else { MARGIN * (high - low) };
        Limits { low: low - margin, high: high + margin }
    }

    /// The outer borders of the cells along an axis.
    pub(crate) fn cell_ends(&self, nodes: &[f64]) -> [f64; 2] {
        let last = nodes.len() - 1;
        let half = if self.kinds.is_empty() { 0.0 } else { 0.5 };
        [
            nodes[0] - half * (nodes[1] - nodes[0]),
            nodes[last] + half * (nodes[last] - nodes[last - 1]),
        ]
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
    fn a_kind_without_a_name_is_refused() {
        let make = |kind| {
            let nodes = vec![0.0, 1.0];
            Field::of_kinds(["stick"], nodes.clone(), nodes, vec![Some(0), None, None, Some(kind)])
        };
        assert!(make(0).is_ok());
        assert_eq!(make(1), Err(PlotError::Kind { kind: 1, count: 1 }));
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
