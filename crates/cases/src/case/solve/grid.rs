//! The grid: `[grid]`.

use crate::case::error::CaseError;
use crate::case::field::{Default, Field, Form};
use crate::case::range::Range;
use crate::case::section::Section;
use crate::case::unit::Dimension;
use carom_halfspace::Grid;

/// The field `cells` of a grid.
pub(in crate::case) const CELLS: Field = Field::new(
    "cells",
    Form::Vector(&["x", "y"], Range::Cells.pure(), "two whole numbers [along x, along y]"),
    "cells of the grid",
)
.or("`accuracy`, or `gap.file`, whose points are then the cells")
.such_as("[40, 40]");
/// The field `size` of a grid.
pub(in crate::case) const SIZE: Field = Field::new(
    "size",
    Form::Vector(
        &["x", "y"],
        Range::Positive.of(Dimension::Length),
        "two lengths [along x, along y]",
    ),
    "sides of the whole grid, on a plate those of the plate; the contact must not reach its border",
)
.or("`accuracy`, or `gap.file`, if that states it")
.such_as("[2.6e-4, 2.6e-4]");
/// The field `cut` of a grid.
pub(in crate::case) const CUT: Field = Field::new(
    "cut",
    Form::Switch,
    "whether the bodies end at the border, so that the contact may reach it",
)
.default(Default::False);
/// The field `periodic` of a grid.
pub(in crate::case) const PERIODIC: Field = Field::new(
    "periodic",
    Form::Switch,
    "whether the surfaces are periodic; the approach is then measured from the mean plane",
)
.default(Default::False);
/// The field `accuracy` of a grid.
pub(in crate::case) const ACCURACY: Field = Field::number(
    "accuracy",
    Range::Accuracy.pure(),
    "window and cells are chosen so that estimated errors of loads and shifts are at most this part \
     of the greatest ones, instead of `cells` and `size`",
)
.may("a grid is given")
.such_as("1e-3");

/// A grid, or the accuracy for which one is chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GridCase {
    /// Cells about the origin.
    Cells {
        /// The grid.
        grid: Grid,
        /// What lies beyond its border.
        border: Border,
    },
    /// A grid chosen for this accuracy.
    Accuracy(f64),
    /// The points of a file of heights.
    OfFile {
        /// Numbers of cells that the file must have, if they are given.
        cells: Option<[f64; 2]>,
        /// Sides of the grid, instead of what the file says.
        size: Option<[f64; 2]>,
        /// What lies beyond its border.
        border: Border,
    },
}

/// What lies beyond the border of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Border {
    /// The bodies continue, and the contact must not reach the border.
    Free,
    /// The bodies end there.
    Cut,
    /// The surfaces are periodic.
    Periodic,
}

impl Border {
    fn read(grid: &Section<'_>) -> Result<Self, CaseError> {
        match (grid.switch(&CUT)?, grid.switch(&PERIODIC)?) {
            (true, true) => {
                let reason = "bodies that end at the border are not periodic";
                Err(grid.conflict(&PERIODIC, &CUT, reason))
            }
            (true, false) => Ok(Self::Cut),
            (false, true) => Ok(Self::Periodic),
            (false, false) => Ok(Self::Free),
        }
    }
}

impl GridCase {
    /// Reads the table `grid`.
    pub(in crate::case) fn read(grid: &Section<'_>) -> Result<Self, CaseError> {
        if let Some(accuracy) = grid.maybe(&ACCURACY)? {
            let others: [&Field; 4] = [&CELLS, &SIZE, &CUT, &PERIODIC];
            return match others.into_iter().find(|field| grid.has(*field)) {
                Some(other) => Err(grid.conflict(&ACCURACY, other, "an accuracy chooses the grid")),
                None => Ok(Self::Accuracy(accuracy)),
            };
        }
        let counts: [f64; 2] = grid.vector(&CELLS)?;
        let sizes: [f64; 2] = grid.vector(&SIZE)?;
        let [nx, ny] = counts.map(|count| count as usize);
        let made = Grid::new(nx, ny, sizes[0] / counts[0], sizes[1] / counts[1])
            .map_err(|error| grid.out_of_range(&SIZE, error.value, error.allowed))?;
        Ok(Self::Cells { grid: made, border: Border::read(grid)? })
    }

    /// Reads the table `grid` of a case whose file of heights gives what is not there.
    pub(in crate::case) fn read_beside_file(
        case: &Section<'_>,
        field: &Field,
    ) -> Result<Self, CaseError> {
        if !case.has(field) {
            return Ok(Self::OfFile { cells: None, size: None, border: Border::Free });
        }
        let grid = case.section(field)?;
        if grid.has(&ACCURACY) || grid.has(&CELLS) && grid.has(&SIZE) {
            return Self::read(&grid);
        }
        let pair = |field: &Field| grid.has(field).then(|| grid.vector(field)).transpose();
        Ok(Self::OfFile { cells: pair(&CELLS)?, size: pair(&SIZE)?, border: Border::read(&grid)? })
    }

    /// The grid of a file of heights of `points` (columns, rows).
    ///
    /// # Errors
    /// The reason why there is none, in words: other numbers of cells, or a size that neither says.
    pub fn of_points(&self, points: [usize; 2], spacing: Option<[f64; 2]>) -> Result<Grid, String> {
        let wanted = self.cells();
        let [columns, rows] = points;
        if let Some([nx, ny]) = wanted.filter(|wanted| *wanted != points) {
            return Err(format!(
                "the height map has {columns} x {rows} values, the grid {nx} x {ny} cells; leave `grid.cells` away \
                 to take those of the map, or cut a part out by `crop`"
            ));
        }
        let counts = points.map(|count| count as f64);
        let steps = match *self {
            Self::Cells { grid, .. } => Some([grid.dx(), grid.dy()]),
            Self::OfFile { size: Some([x, y]), .. } => Some([x / counts[0], y / counts[1]]),
            _ => spacing,
        };
        let [dx, dy] =
            steps.ok_or("this file does not state the size of its map: give `grid.size`")?;
        Grid::new(columns, rows, dx, dy).map_err(|error| error.to_string())
    }

    /// The grid that is given; none if one is chosen.
    #[must_use]
    pub const fn given(&self) -> Option<Grid> {
        match *self {
            Self::Cells { grid, .. } => Some(grid),
            Self::Accuracy(_) | Self::OfFile { .. } => None,
        }
    }

    /// Numbers of cells along x and y; none if they are chosen or those of a file.
    #[must_use]
    pub fn cells(&self) -> Option<[usize; 2]> {
        match *self {
            Self::Cells { grid, .. } => Some([grid.nx(), grid.ny()]),
            Self::OfFile { cells, .. } => cells.map(|cells| cells.map(|count| count as usize)),
            Self::Accuracy(_) => None,
        }
    }

    /// What lies beyond its border; a chosen grid contains the contact.
    #[must_use]
    pub const fn border(&self) -> Border {
        match *self {
            Self::Cells { border, .. } | Self::OfFile { border, .. } => border,
            Self::Accuracy(_) => Border::Free,
        }
    }
}
