//! Warnings about the grid: the window cuts the contact off, or the cells are too coarse.

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

/// A reason why the grid may be unsuitable for a solution.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum GridWarning {
    /// The contact reaches the border of the window and may be cut off.
    #[error("the contact reaches the {side:?} border of the window")]
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
}

impl ContactState {
    /// The first and last column and row of the cells in contact; `None` if the bodies are
    /// separated.
    #[must_use]
    pub fn extent(&self) -> Option<[[usize; 2]; 2]> {
        let grid = self.pressure.grid();
        let mut extent: Option<[[usize; 2]; 2]> = None;
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
        let sides = [
            (x[0] == 0, Side::Left),
            (x[1] + 1 == grid.nx(), Side::Right),
            (y[0] == 0, Side::Bottom),
            (y[1] + 1 == grid.ny(), Side::Top),
        ];
        let mut warnings: Vec<GridWarning> = sides
            .iter()
            .filter(|(at, _)| *at)
            .map(|(_, side)| GridWarning::Border { side: *side })
            .collect();
        let across = (x[1] - x[0] + 1).min(y[1] - y[0] + 1);
        if across < FEWEST_CELLS_ACROSS {
            warnings.push(GridWarning::FewCells { across });
        }
        warnings
    }
}
