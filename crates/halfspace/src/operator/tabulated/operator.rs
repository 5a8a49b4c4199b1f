//! Products with a table of coefficients.

use std::sync::Arc;

use super::TabulatedKernel;
use crate::operator::length::Sizes;
use crate::operator::plan::Plan;
use crate::operator::product::{Term, apply};
use crate::operator::spectrum::Spectrum;
use crate::operator::torus::TorusInverse;
use crate::operator::{
    Axis, DisplacementField, OperatorError, Preconditioner, SurfaceOperator, Threads,
    TractionField, Workspace, memory,
};
use crate::{Coefficients, Grid, Material, MaterialPair, Offset, RectangleInfluence};
use carom_special::RangeError;

/// The operator of a [`TabulatedKernel`].
#[derive(Clone)]
pub struct KernelOperator {
    kernel: TabulatedKernel,
    plan: Plan,
    spectra: [[Option<Spectrum>; 3]; 3],
    inverse: TorusInverse,
}

impl KernelOperator {
    /// The operator of `kernel`; its products are computed on `threads`.
    ///
    /// # Errors
    /// [`OperatorError::TooLarge`] before the transforms are allocated.
    pub fn new(kernel: TabulatedKernel, threads: Threads) -> Result<Self, OperatorError> {
        let grid = kernel.grid();
        let held = Axis::ALL.map(|of| Axis::ALL.map(|by| !kernel.is_zero(of, by)));
        let count = held.iter().flatten().filter(|held| **held).count();
        let sizes = Sizes::of(grid);
        memory::check(count as u128 * sizes.general_spectrum() + sizes.workspace(3, threads))?;
        let plan = Plan::new(grid, threads);
        let spectra = Axis::ALL.map(|of| {
            Axis::ALL.map(|by| {
                let (i, l) = (of as usize, by as usize);
                held[i][l].then(|| {
                    Spectrum::general(&plan, |columns, rows| {
                        kernel.coefficients(columns, rows).rows[i][l]
                    })
                })
            })
        });
        let inverse = TorusInverse::new(&near_field(&kernel)?, grid, threads);
        Ok(Self { kernel, plan, spectra, inverse })
    }

    /// The table.
    #[must_use]
    pub const fn kernel(&self) -> &TabulatedKernel {
        &self.kernel
    }

    /// The same body on a grid with the same sides and cells 2, 4, 8... times as wide.
    ///
    /// # Errors
    /// [`OperatorError::Range`] for another grid, [`OperatorError::TooLarge`].
    pub fn coarsened_to(&self, grid: Grid) -> Result<Self, OperatorError> {
        let mut kernel = self.kernel.clone();
        while !is_same(kernel.grid(), grid) {
            let own = kernel.grid();
            let coarser = grid.dx() > own.dx() * NEARLY || grid.dy() > own.dy() * NEARLY;
            let allowed = "2, 4, 8... times those of the table, or the same";
            RangeError::check("dx", grid.dx(), coarser, allowed)?;
            kernel = kernel.coarser_towards(grid)?;
        }
        let threads = self.plan.threads.on_smaller(kernel.grid());
        Self::new(kernel, threads)
    }

    /// The inverse of the half-space whose displacements under its own cell are those of the table.
    pub(super) fn near_field(&self) -> Arc<dyn Preconditioner> {
        Arc::new(self.inverse.clone())
    }
}

/// Widths that are larger by less than this factor are the same.
const NEARLY: f64 = 1.0 + 1e-9;

/// Whether cells and their widths are the same but for round-off.
fn is_same(one: Grid, other: Grid) -> bool {
    let near = |a: f64, b: f64| a <= b * NEARLY && b <= a * NEARLY;
    (one.nx(), one.ny()) == (other.nx(), other.ny())
        && near(one.dx(), other.dx())
        && near(one.dy(), other.dy())
}

/// Two equal bodies, half-spaces whose own displacements of a loaded cell are those of the table: close to the load
/// every elastic body is a half-space, and these displacements decide how fast iterations converge.
fn near_field(kernel: &TabulatedKernel) -> Result<MaterialPair, RangeError> {
    let own = kernel.coefficients(0, 0).rows;
    let here = |poisson: f64| -> Result<[f64; 2], RangeError> {
        let body = Material::from_shear(1.0, poisson)?;
        let cell = RectangleInfluence::new(MaterialPair::new(body, body)?, kernel.grid().cell());
        let rows = cell.coefficients(Offset::default())?.rows;
        Ok([0.5 * (rows[0][0] + rows[1][1]), rows[2][2]])
    };
    let [tangential, normal] = [0.5 * (own[0][0] + own[1][1]), own[2][2]];
    // Both displacements of the half-space are linear in nu, for G = 1.
    let ([x_0, z_0], [x_1, z_1]) = (here(0.0)?, here(0.5)?);
    let slope = |at_0: f64, at_1: f64| 2.0 * (at_1 - at_0);
    let ratio = tangential / normal;
    let poisson = (ratio * z_0 - x_0) / (slope(x_0, x_1) - ratio * slope(z_0, z_1));
    let poisson = if poisson.is_finite() { poisson.clamp(0.0, 0.49) } else { 0.0 };
    let scale = if normal > 0.0 { normal } else { tangential };
    let [at, at_z] = here(poisson)?;
    let shear = if normal > 0.0 { at_z / scale } else { at / scale };
    let shear = if shear.is_finite() && shear > 0.0 { shear } else { 1.0 };
    let body = Material::from_shear(shear, poisson)?;
    MaterialPair::new(body, body)
}

impl SurfaceOperator for KernelOperator {
    fn grid(&self) -> Grid {
        self.kernel.grid()
    }

    fn threads(&self) -> Threads {
        self.plan.threads
    }

    fn is_coupled(&self) -> bool {
        let [u, v, w] = &self.spectra;
        [&u[2], &v[2], &w[0], &w[1]].iter().any(|spectrum| spectrum.is_some())
    }

    fn is_separate(&self) -> bool {
        self.spectra[0][1].is_none() && self.spectra[1][0].is_none()
    }

    fn coefficients(&self, columns: i32, rows: i32) -> Coefficients {
        self.kernel.coefficients(columns, rows)
    }

    fn inverse(&self) -> Option<Arc<dyn Preconditioner>> {
        Some(self.near_field())
    }

    fn coarser(&self) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        let build = || {
            let kernel = self.kernel.coarser()?;
            let threads = self.plan.threads.on_smaller(kernel.grid());
            Ok(Box::new(Self::new(kernel, threads)?) as Box<dyn SurfaceOperator>)
        };
        Some(build())
    }

    fn on_fewer(
        &self,
        nx: usize,
        ny: usize,
    ) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        let build = || {
            let all = self.grid();
            for (field, cells, most) in [("nx", nx, all.nx()), ("ny", ny, all.ny())] {
                let holds = (1..=most).contains(&cells);
                let allowed = "from 1 to the number of the operator";
                RangeError::check(field, cells as f64, holds, allowed)?;
            }
            let grid = Grid::new(nx, ny, all.dx(), all.dy())?;
            let known = |columns, rows| self.kernel.coefficients(columns, rows);
            let kernel = TabulatedKernel::from_function(grid, known)?;
            let threads = self.plan.threads.on_smaller(grid);
            Ok(Box::new(Self::new(kernel, threads)?) as Box<dyn SurfaceOperator>)
        };
        Some(build())
    }

    fn apply(
        &self,
        tractions: TractionField<'_>,
        displacements: DisplacementField<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError> {
        let term = |of: Axis, by: Axis| {
            let spectrum = self.spectra[of as usize][by as usize].as_ref();
            Ok(spectrum.map(|spectrum| Term { spectrum, sign: 1.0 }))
        };
        apply(&self.plan, (term, 1.0), tractions, displacements, workspace)
    }
}

impl std::fmt::Debug for KernelOperator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("KernelOperator").field("grid", &self.kernel.grid()).finish_non_exhaustive()
    }
}
