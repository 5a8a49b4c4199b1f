//! The bodies of a case on any grid.

use super::follow::Followed;
use super::influence;
use crate::Error;
use crate::case::{Border, FrictionCase, GapCase, GridCase, InfluenceFile, PlateCase, SolveCase};
use crate::heights;
use crate::input::CaseFile;
use carom_halfspace::operator::{Blocks, KernelOperator, OperatorError, PlateOperator, Threads};
use carom_halfspace::{Field, Grid, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    CellFriction, ContactProblem, Gap, ProblemError, Shape, SurfaceFriction, Window, gap_left,
};
use carom_special::RangeError;
use std::sync::Arc;

/// Gap, materials and friction.
pub struct Bodies {
    gap: Given,
    materials: MaterialPair,
    friction: SurfaceFriction,
    border: Border,
    plate: Option<PlateCase>,
    /// Influence numbers of both bodies on the given grid.
    table: Option<KernelOperator>,
    /// The content of the files that the case names.
    read: Vec<u8>,
    /// The grid, that of the case or of a file of heights; none if an accuracy chooses it.
    grid: Option<Grid>,
    /// What is told about the heights of a file.
    warnings: Vec<String>,
}

enum Given {
    Formula(Shape),
    /// Heights on one grid; coarser grids take their means.
    Grid(Gap),
}

impl Bodies {
    /// Reads the bodies of a case of `carom solve`.
    ///
    /// # Errors
    /// [`ErrorKind::Input`](crate::ErrorKind::Input) if a file is not valid, or if an accuracy is given for heights that define their own
    /// grid.
    pub fn of(file: &CaseFile, case: &SolveCase) -> Result<Self, Error> {
        let bodies =
            Self::of_half_spaces(file, case.materials, &case.gap, case.grid, &case.friction)?;
        let bodies = Self { plate: case.plate, ..bodies };
        bodies.with_influence(file, case.influence.as_ref())
    }

    /// Takes the influence numbers of a file instead of half-spaces, if the case names one.
    ///
    /// # Errors
    /// [`ErrorKind::Input`](crate::ErrorKind::Input) if the file is not valid, or its numbers are not those of elastic bodies.
    pub(crate) fn with_influence(
        mut self,
        file: &CaseFile,
        influence: Option<&InfluenceFile>,
    ) -> Result<Self, Error> {
        let (Some(influence), Some(grid)) = (influence, self.grid) else { return Ok(self) };
        let blocks = if self.friction.is_none() { Blocks::Normal } else { Blocks::All };
        let (table, read) = influence::operator(file, influence, grid, self.materials, blocks)?;
        self.table = Some(table);
        self.read.extend(read);
        Ok(self)
    }

    /// Reads two half-spaces, their gap and friction.
    ///
    /// # Errors
    /// As [`Bodies::of`].
    pub(crate) fn of_half_spaces(
        file: &CaseFile,
        materials: MaterialPair,
        gap: &GapCase,
        grid: GridCase,
        friction: &FrictionCase,
    ) -> Result<Self, Error> {
        let mut warnings = Vec::new();
        let mut given = grid.given();
        let own = |given: Option<Grid>, what: &str| {
            given.ok_or_else(|| {
                Error::input(format!(
                    "{what} define their own grid; give `grid.cells`, not an accuracy"
                ))
            })
        };
        let (gap, mut read) = match gap {
            GapCase::Formula(shape) => (Given::Formula(shape.clone()), Vec::new()),
            GapCase::Heights(map) => {
                if let GridCase::Accuracy(_) = grid {
                    own(None, "heights from a file")?;
                }
                let heights = heights::gap(file, map, grid)?;
                given = Some(heights.gap.grid());
                warnings = heights.warnings;
                (Given::Grid(heights.gap), heights.read)
            }
            GapCase::Rough { surface, radius } => {
                let rough = surface.heights(own(given, "random heights")?)?;
                (Given::Grid(standing(&rough, *radius)?), Vec::new())
            }
        };
        let friction = match &friction.map {
            None => cell_friction(friction, 1.0)?.into(),
            Some(map) => {
                let grid = own(given, "factors of friction")?;
                let (factors, bytes) = heights::factors(file, map, grid)?;
                read.extend(bytes);
                let cells: Result<_, _> = factors
                    .values()
                    .iter()
                    .map(|factor| cell_friction(friction, *factor))
                    .collect();
                Field::new(factors.grid(), cells?)?.into()
            }
        };
        let (border, plate, table) = (grid.border(), None, None);
        Ok(Self { gap, materials, friction, border, plate, table, read, grid: given, warnings })
    }

    /// The grid of the case, or of its file of heights; none if an accuracy chooses it.
    #[must_use]
    pub const fn grid(&self) -> Option<Grid> {
        self.grid
    }

    /// What is told about the heights of a file.
    #[must_use]
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// The content of the files that the case names.
    #[must_use]
    pub fn read(&self) -> &[u8] {
        &self.read
    }

    /// The distance of the surfaces after the last step of a run; infinite where there is no body.
    ///
    /// # Errors
    /// [`ErrorKind::Problem`](crate::ErrorKind::Problem) if it is too large for the memory.
    pub fn gap_left(&self, followed: &Followed) -> Result<Field, Error> {
        let problem = self.problem(&followed.window)?;
        Ok(gap_left(&problem, &followed.state).map_err(ProblemError::from)?)
    }

    /// Side lengths of a rectangle that contains a part of the body.
    pub(crate) fn sides(&self) -> [f64; 2] {
        if let Some(PlateCase { plate, .. }) = self.plate {
            return [plate.a(), plate.b()];
        }
        match &self.gap {
            Given::Formula(shape) => shape.sides(),
            Given::Grid(gap) => {
                let grid = gap.grid();
                [grid.nx() as f64 * grid.dx(), grid.ny() as f64 * grid.dy()]
            }
        }
    }

    /// The contact problem on a window.
    ///
    /// # Errors
    /// [`ProblemError`] if no body lies under it or it is too large for the memory.
    pub(crate) fn problem(&self, window: &Window) -> Result<ContactProblem, ProblemError> {
        let gap = match &self.gap {
            Given::Formula(shape) => window.gap(|x, y| shape.height(x, y)),
            Given::Grid(gap) => gap.coarsened_to(window.grid()),
        };
        let gap = gap.map_err(OperatorError::from)?;
        if let Some(PlateCase { plate, theory }) = self.plate {
            let pair = self.materials;
            let (grid, threads) = (gap.grid(), Threads::for_grid(gap.grid()));
            let operator = PlateOperator::new(pair, plate, grid, theory, threads)?;
            return ContactProblem::new(gap, Arc::new(operator), self.friction.clone());
        }
        if let Some(table) = &self.table {
            let operator = table.coarsened_to(gap.grid())?;
            return ContactProblem::new(gap, Arc::new(operator), self.friction.clone());
        }
        if self.border == Border::Periodic {
            return ContactProblem::of_periods_by_need(gap, self.materials, self.friction.clone());
        }
        ContactProblem::of_half_spaces_by_need(gap, self.materials, self.friction.clone())
    }
}

/// The friction of a cell with a factor.
fn cell_friction(friction: &FrictionCase, factor: f64) -> Result<CellFriction, RangeError> {
    let [rest, motion] = [friction.rest, friction.motion].map(|f| Friction::new(f * factor));
    CellFriction::new(rest?, motion?)
}

/// Heights plus a paraboloid, measured from the first contact point.
fn standing(heights: &Field, radius: f64) -> Result<Gap, RangeError> {
    let places = heights.values().iter().zip(heights.grid().centres());
    let mut gaps: Vec<f64> =
        places.map(|(height, (x, y))| 0.5 * (x * x + y * y) / radius - height).collect();
    let lowest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
    gaps.iter_mut().for_each(|gap| *gap -= lowest);
    Gap::new(Field::new(heights.grid(), gaps)?)
}
