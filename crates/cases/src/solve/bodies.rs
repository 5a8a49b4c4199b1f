//! The bodies of a case on any grid.

use super::heights;
use crate::Error;
use crate::case::{Border, GapCase, GridCase, PlateCase, SolveCase};
use crate::input::CaseFile;
use carom_halfspace::operator::{OperatorError, PeriodicOperator, PlateOperator, Threads};
use carom_halfspace::{Field, Grid, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    CellFriction, ContactProblem, Gap, ProblemError, Shape, SurfaceFriction, Window,
};
use std::sync::Arc;

/// Gap, materials and friction.
pub struct Bodies {
    gap: Given,
    materials: MaterialPair,
    friction: SurfaceFriction,
    border: Border,
    plate: Option<PlateCase>,
    /// The content of the files that the case names.
    read: Vec<u8>,
}

enum Given {
    Formula(Shape),
    /// Heights on one grid; coarser grids take their means.
    Grid(Gap),
}

impl Bodies {
    /// Reads the bodies of a case.
    ///
    /// # Errors
    /// [`Error::Input`] if a file of heights is not valid, or if an accuracy is given for heights that define
    /// their own grid.
    pub fn of(file: &CaseFile, case: &SolveCase) -> Result<Self, Error> {
        let path = &file.path;
        let law = |source| Error::Law { path: path.clone(), source };
        let border = match case.grid {
            GridCase::Cells { border, .. } => border,
            GridCase::Accuracy(_) => Border::Free,
        };
        let own = |what: &str| match case.grid {
            GridCase::Cells { grid, .. } => Ok(grid),
            GridCase::Accuracy(_) => {
                let reason =
                    format!("{what} define their own grid; give `grid.cells`, not an accuracy");
                Err(Error::Input { path: path.clone(), reason })
            }
        };
        let (gap, read) = match &case.gap {
            GapCase::Formula(shape) => (Given::Formula(shape.clone()), Vec::new()),
            GapCase::Heights(map) => {
                let (gap, read) = heights::gap(file, map, own("heights from a file")?)?;
                (Given::Grid(gap), read)
            }
            GapCase::Rough { surface, radius } => {
                let grid = own("random heights")?;
                let rough = surface.heights(grid).map_err(law)?;
                (Given::Grid(standing(&rough, *radius).map_err(law)?), Vec::new())
            }
        };
        let friction = |f: f64| Friction::new(f).map_err(law);
        let friction = CellFriction::new(friction(case.static_friction)?, friction(case.friction)?);
        let friction = friction.map_err(law)?.into();
        let (materials, plate) = (case.materials, case.plate);
        Ok(Self { gap, materials, friction, border, plate, read })
    }

    /// The content of the files that the case names.
    #[must_use]
    pub fn read(&self) -> &[u8] {
        &self.read
    }

    /// Side lengths of a rectangle that contains a part of the body.
    pub(super) fn sides(&self) -> [f64; 2] {
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
    pub(super) fn problem(&self, window: &Window) -> Result<ContactProblem, ProblemError> {
        let gap = match &self.gap {
            Given::Formula(shape) => window.gap(|x, y| shape.height(x, y)),
            Given::Grid(gap) => on(gap, window.grid()),
        };
        let gap = gap.map_err(OperatorError::from)?;
        if let Some(PlateCase { plate, theory }) = self.plate {
            let pair = self.materials;
            let operator = PlateOperator::new(pair, plate, gap.grid(), theory, Threads::One)?;
            return ContactProblem::new(gap, Arc::new(operator), self.friction.clone());
        }
        if self.border == Border::Periodic {
            let operator = PeriodicOperator::new(self.materials, gap.grid(), Threads::One)?;
            return ContactProblem::new(gap, Arc::new(operator), self.friction.clone());
        }
        ContactProblem::of_half_spaces(gap, self.materials, self.friction.clone())
    }
}

/// Heights plus a paraboloid, measured from the first contact point.
fn standing(heights: &Field, radius: f64) -> Result<Gap, carom_special::RangeError> {
    let places = heights.values().iter().zip(heights.grid().centres());
    let mut gaps: Vec<f64> =
        places.map(|(height, (x, y))| 0.5 * (x * x + y * y) / radius - height).collect();
    let lowest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
    gaps.iter_mut().for_each(|gap| *gap -= lowest);
    Gap::new(Field::new(heights.grid(), gaps)?)
}

/// The gap on its own grid or a coarser one.
fn on(gap: &Gap, grid: Grid) -> Result<Gap, carom_special::RangeError> {
    let mut own = gap.clone();
    while own.grid() != grid && own.grid().cells() > grid.cells() {
        own = own.coarser()?;
    }
    Ok(own)
}
