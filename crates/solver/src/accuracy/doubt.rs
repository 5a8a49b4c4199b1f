//! What casts doubt on a solution: a contact cut off by the window, or too few cells.

use crate::state::ContactState;

/// Fewer cells than this across a contact are too few.
const FEW: usize = 10;

/// A side of the window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// That of the lowest x.
    Left,
    /// That of the greatest x.
    Right,
    /// That of the lowest y.
    Bottom,
    /// That of the greatest y.
    Top,
}

/// What casts doubt on a solution.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Doubt {
    /// The contact is cut off by the window.
    #[error("the contact reaches the {side:?} border of the window")]
    Border {
        /// Where.
        side: Side,
    },
    /// The contact is only a few cells wide.
    #[error("the contact is {across} cells wide, fewer than {FEW}")]
    FewCells {
        /// Its width along its narrower direction.
        across: usize,
    },
}

impl ContactState {
    /// The columns and rows between which cells touch: first and last of each; none apart.
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

    /// What casts doubt on this state: a contact that reaches the border of the grid, or fewer than
    /// ten cells wide.
    #[must_use]
    pub fn doubts(&self) -> Vec<Doubt> {
        let (grid, Some([x, y])) = (self.pressure.grid(), self.extent()) else {
            return Vec::new();
        };
        let sides = [
            (x[0] == 0, Side::Left),
            (x[1] + 1 == grid.nx(), Side::Right),
            (y[0] == 0, Side::Bottom),
            (y[1] + 1 == grid.ny(), Side::Top),
        ];
        let mut doubts: Vec<Doubt> = sides
            .iter()
            .filter(|(at, _)| *at)
            .map(|(_, side)| Doubt::Border { side: *side })
            .collect();
        let across = (x[1] - x[0] + 1).min(y[1] - y[0] + 1);
        if across < FEW {
            doubts.push(Doubt::FewCells { across });
        }
        doubts
    }
}
