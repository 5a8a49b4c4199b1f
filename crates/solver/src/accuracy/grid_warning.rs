//! Warnings about a solution: the window cuts the contact off, the cells are too coarse, or a
//! displacement is too large for the theory of the operator.

use carom_halfspace::Grid;
use carom_halfspace::operator::{DisplacementField, OperatorError, TractionField};

use crate::problem::ContactProblem;
use crate::state::ContactState;

/// A contact narrower than this number of cells is poorly resolved.
const FEWEST_CELLS_ACROSS: usize = 10;

/// A side of the window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The side of lowest x.
    Left,
    /// The side of greatest x.
    Right,
    /// The side of lowest y.
    Bottom,
    /// The side of greatest y.
    Top,
}

impl std::fmt::Display for Side {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Left => "left",
            Self::Right => "right",
            Self::Bottom => "bottom",
            Self::Top => "top",
        })
    }
}

/// A reason to distrust a solution.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum GridWarning {
    /// The contact reaches the border of the window and may be cut off.
    #[error("the contact reaches the {side} border of the window")]
    Border {
        /// The border that it reaches.
        side: Side,
    },
    /// The contact is only a few cells wide, so that its size and pressure are inaccurate.
    #[error("the contact is {across} cells wide, fewer than {FEWEST_CELLS_ACROSS}")]
    FewCells {
        /// The number of cells across its narrower direction.
        across: usize,
    },
    /// The normal displacement is too large for the linear theory of the operator: above half the
    /// thickness, a plate stretches.
    #[error("the displacement {displacement} exceeds {allowed}, up to which the theory holds")]
    LargeDisplacement {
        /// The greatest normal displacement.
        displacement: f64,
        /// Where the theory ends.
        allowed: f64,
    },
}

/// The first and last column and row in contact.
type Extent = [[usize; 2]; 2];

impl GridWarning {
    /// The borders of the grid that a contact reaches.
    pub(crate) fn border(extent: Option<Extent>, grid: Grid) -> impl Iterator<Item = Side> {
        let sides = extent.map(|[x, y]| {
            [
                (x[0] == 0, Side::Left),
                (x[1] + 1 == grid.nx(), Side::Right),
                (y[0] == 0, Side::Bottom),
                (y[1] + 1 == grid.ny(), Side::Top),
            ]
        });
        sides.into_iter().flatten().filter(|(at, _)| *at).map(|(_, side)| side)
    }
}

impl ContactProblem {
    /// Warnings about a state of this problem: those of [`ContactState::warnings`], and a normal
    /// displacement beyond the [validity](carom_halfspace::operator::Validity) of the operator,
    /// which costs a product.
    ///
    /// # Errors
    /// [`OperatorError`] if the state is on another grid.
    pub fn warnings(&self, state: &ContactState) -> Result<Vec<GridWarning>, OperatorError> {
        let (operator, mut warnings) = (self.operator(), state.warnings());
        let allowed = operator.validity().displacement;
        if allowed.is_finite() {
            let pressure = state.pressure.values();
            let mut w = vec![0.0; pressure.len()];
            let displacement = DisplacementField::normal(&mut w);
            operator.apply(
                TractionField::normal(pressure),
                displacement,
                &mut operator.workspace(),
            )?;
            let displacement = w.into_iter().fold(0.0, f64::max);
            if displacement > allowed {
                warnings.push(GridWarning::LargeDisplacement { displacement, allowed });
            }
        }
        Ok(warnings)
    }
}

impl ContactState {
    /// The first and last column and row of the cells in contact; `None` if the bodies are
    /// separated.
    #[must_use]
    pub fn extent(&self) -> Option<Extent> {
        let grid = self.pressure.grid();
        let mut extent: Option<Extent> = None;
        for (i, pressure) in self.pressure.values().iter().enumerate() {
            if *pressure > 0.0 {
                let at = [i % grid.nx(), i / grid.nx()];
                let [x, y] = extent.unwrap_or([[at[0]; 2], [at[1]; 2]]);
                let wider = |[a, b]: [usize; 2], at: usize| [a.min(at), b.max(at)];
                extent = Some([wider(x, at[0]), wider(y, at[1])]);
            }
        }
        extent
    }

    /// Warnings about the grid of this state: a contact that reaches its border, or one that is
    /// fewer than ten cells wide.
    #[must_use]
    pub fn warnings(&self) -> Vec<GridWarning> {
        let (grid, Some([x, y])) = (self.pressure.grid(), self.extent()) else {
            return Vec::new();
        };
        let mut warnings: Vec<GridWarning> = GridWarning::border(self.extent(), grid)
            .map(|side| GridWarning::Border { side })
            .collect();
        // Nothing varies along a single row or column.
        let counted = [(grid.nx(), x), (grid.ny(), y)].into_iter().filter(|(count, _)| *count > 1);
        let across = counted.map(|(_, [first, last])| last - first + 1).min().unwrap_or(1);
        if across < FEWEST_CELLS_ACROSS {
            warnings.push(GridWarning::FewCells { across });
        }
        warnings
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A contact of these columns and rows in a window of 14 by 20 cells.
    fn told([x, y]: Extent) -> Vec<GridWarning> {
        let grid = Grid::new(14, 20, 1.0, 1.0).unwrap();
        let mut state = ContactState::apart(grid);
        for j in y[0]..=y[1] {
            for i in x[0]..=x[1] {
                state.pressure.values_mut()[grid.index(i, j)] = 1.0;
            }
        }
        state.warnings()
    }

    #[test]
    fn a_contact_may_reach_each_side_of_an_oblong_window() {
        assert_eq!(told([[2, 11], [5, 14]]), []);
        for (extent, side) in [
            ([[0, 10], [5, 15]], Side::Left),
            ([[2, 13], [5, 15]], Side::Right),
            ([[2, 11], [0, 13]], Side::Bottom),
            ([[2, 11], [5, 19]], Side::Top),
        ] {
            assert_eq!(told(extent), [GridWarning::Border { side }]);
        }
    }

    #[test]
    fn fewer_than_ten_cells_across_are_few_along_either_axis() {
        let few = [GridWarning::FewCells { across: 9 }];
        assert_eq!(told([[2, 10], [3, 16]]), few);
        assert_eq!(told([[2, 11], [3, 11]]), few);
        assert_eq!(told([[2, 11], [3, 12]]), []);
    }
}
