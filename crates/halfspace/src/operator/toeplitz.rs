//! The operator of two elastic half-spaces (4.13), (4.14).

use std::sync::{Arc, OnceLock};

use super::length::Sizes;
use super::memory;
use super::plan::Plan;
use super::product::{Term, apply};
use super::sparse::Hierarchy;
use super::spectrum::Spectrum;
use super::table::Entry;
use super::torus::TorusInverse;
use super::{
    Axis, Blocks, CoefficientTable, DisplacementField, NormalRows, OperatorError, Preconditioner,
    SurfaceOperator, Threads, TractionField, Workspace,
};
use crate::{Coefficients, Grid, MaterialPair, Offset};
use carom_special::RangeError;

/// The operator (4.13) of two elastic half-spaces on a grid.
///
/// ```
/// use carom_halfspace::operator::{
///     DisplacementField, HalfSpaceOperator, SurfaceOperator, TractionField,
/// };
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// let steel = Material::from_young(208e3, 0.3)?;
/// let pair = MaterialPair::new(steel, steel)?;
/// let operator = HalfSpaceOperator::new(pair, Grid::new(32, 32, 0.1, 0.1)?)?;
/// let mut workspace = operator.workspace();
/// let pressure = vec![100.0; 32 * 32];
/// let mut w = vec![0.0; 32 * 32];
/// let fields = (TractionField::normal(&pressure), DisplacementField::normal(&mut w));
/// operator.apply(fields.0, fields.1, &mut workspace)?;
/// assert!(w[16 * 33] > w[0]);
/// # Ok::<(), carom_halfspace::operator::OperatorError>(())
/// ```
///
/// Clones are cheap: they share the table. Each transform of the influence is computed when first
/// needed.
#[derive(Clone)]
pub struct HalfSpaceOperator {
    blocks: Blocks,
    /// The table of this grid or of a larger one.
    table: Arc<CoefficientTable>,
    grid: Grid,
    plan: Plan,
    spectra: Arc<[OnceLock<Spectrum>; 6]>,
    single: Arc<OnceLock<Single>>,
    inverse: TorusInverse,
    rough_inverse: TorusInverse<f32>,
    hierarchy: Arc<OnceLock<Option<Arc<Hierarchy>>>>,
}

/// The transforms in single precision.
struct Single {
    plan: Plan<f32>,
    /// Over the unit.
    spectra: [OnceLock<Spectrum<f32>>; 6],
    unit: f64,
}

impl HalfSpaceOperator {
    /// The operator with all blocks, on one thread.
    ///
    /// # Errors
    /// [`OperatorError::TooLarge`] before anything is allocated.
    pub fn new(pair: MaterialPair, grid: Grid) -> Result<Self, OperatorError> {
        Self::with_blocks(pair, grid, Blocks::All, Threads::One)
    }

    /// The operator with the given blocks; tables and products are computed on `threads`.
    ///
    /// # Errors
    /// [`OperatorError::TooLarge`] before anything is allocated.
    pub fn with_blocks(
        pair: MaterialPair,
        grid: Grid,
        blocks: Blocks,
        threads: Threads,
    ) -> Result<Self, OperatorError> {
        let table = CoefficientTable::bytes(&pair, grid, blocks);
        memory::check(table + Self::bytes(&pair, grid, blocks, threads))?;
        let table = Arc::new(CoefficientTable::build(pair, grid, blocks, threads));
        Ok(Self::of_table(table, grid, blocks, threads))
    }

    fn of_table(
        table: Arc<CoefficientTable>,
        grid: Grid,
        blocks: Blocks,
        threads: Threads,
    ) -> Self {
        let (plan, spectra, single) = (Plan::new(grid, threads), Arc::default(), Arc::default());
        let inverse = TorusInverse::new(&table.pair(), grid, threads);
        let rough_inverse = TorusInverse::new(&table.pair(), grid, threads);
        let hierarchy = Arc::default();
        Self { blocks, table, grid, plan, spectra, single, inverse, rough_inverse, hierarchy }
    }

    /// Memory of all transforms and one workspace, in bytes.
    fn bytes(pair: &MaterialPair, grid: Grid, blocks: Blocks, threads: Threads) -> u128 {
        let held = blocks.count(pair) as u128;
        let fields = match blocks {
            Blocks::All => 3,
            Blocks::Normal => 1,
            Blocks::Tangential => 2,
        };
        let sizes = Sizes::of(grid);
        let double = held * sizes.symmetric_spectrum() + sizes.workspace(fields, threads);
        // Single precision takes half as much beside it.
        double + double / 2
    }

    /// The materials.
    #[must_use]
    pub fn pair(&self) -> MaterialPair {
        self.table.pair()
    }

    /// The table of coefficients, of this grid or of a larger one.
    #[must_use]
    pub fn table(&self) -> &CoefficientTable {
        &self.table
    }

    /// The term for one pair of components, (4.23); `None` if it is zero.
    fn term(&self, of: Axis, by: Axis) -> Result<Option<Term<'_>>, OperatorError> {
        let (entry, sign) = self.blocks.entry(&self.pair(), of, by)?;
        Ok(entry.map(|entry| Term { spectrum: self.spectrum(entry), sign }))
    }

    /// The same in single precision.
    fn single_term<'a>(
        &'a self,
        single: &'a Single,
        of: Axis,
        by: Axis,
    ) -> Result<Option<Term<'a, f32>>, OperatorError> {
        let term = self.term(of, by)?;
        let place = &single.spectra[Entry::of(of, by).0 as usize];
        Ok(term.map(|Term { spectrum, sign }| {
            let spectrum = place.get_or_init(|| spectrum.over(single.unit));
            Term { spectrum, sign: sign as f32 }
        }))
    }

    /// The normal displacement due to a pressure, also beyond the table.
    fn normal(&self, columns: i32, rows: i32) -> f64 {
        let grid = self.table.grid();
        let [n, m] = [columns, rows].map(|count| count.unsigned_abs() as usize);
        let stored = (n < grid.nx() && m < grid.ny()).then(|| grid.index(n, m));
        let stored = stored.and_then(|at| self.table.block(Entry::Zz).get(at));
        let fresh = || self.table.normal(self.grid.offset(columns, rows));
        stored.copied().unwrap_or_else(fresh)
    }

    fn single(&self) -> &Single {
        self.single.get_or_init(|| {
            let Sizes { px, py, .. } = self.plan.sizes;
            // The influence of a cell on itself is the mean of the spectrum.
            let [x, _, z] = self.coefficients(0, 0).rows;
            let unit = x[0].max(z[2]) / (px as f64 * py as f64);
            let plan = Plan::on(self.plan.sizes, self.plan.threads);
            Single { plan, spectra: Default::default(), unit }
        })
    }

    fn spectrum(&self, entry: Entry) -> &Spectrum {
        let place = &self.spectra[entry as usize];
        if let Some(known) = place.get() {
            return known;
        }
        // Not under the lock: pool threads that wait may start other products.
        let rows = |row: usize, values: &mut [f64]| self.table.fill_row(entry, row, values);
        let new = Spectrum::symmetric(&self.plan, rows, entry.parity());
        let new = if self.blocks == Blocks::Normal { new.folded(self.grid) } else { new };
        place.get_or_init(|| new)
    }
}

impl SurfaceOperator for HalfSpaceOperator {
    fn grid(&self) -> Grid {
        self.grid
    }

    fn threads(&self) -> Threads {
        self.plan.threads
    }

    fn is_coupled(&self) -> bool {
        !self.pair().is_uncoupled()
    }

    fn is_separate(&self) -> bool {
        self.pair().poisson() == 0.0
    }

    /// From the displacement w of a cell of sides a, b by its own pressure p,
    /// w = 2 p (a asinh(b/a) + b asinh(a/b))/(pi E*).
    fn contact_modulus(&self) -> Option<f64> {
        let (a, b) = (self.grid.dx(), self.grid.dy());
        let sides = a * libm::asinh(b / a) + b * libm::asinh(a / b);
        let [.., [.., own]] = self.coefficients(0, 0).rows;
        Some(2.0 * sides / (std::f64::consts::PI * own))
    }

    fn coefficients(&self, columns: i32, rows: i32) -> Coefficients {
        let beyond = |offset: i32, count: usize| offset.unsigned_abs() as usize >= count;
        if beyond(columns, self.grid.nx()) || beyond(rows, self.grid.ny()) {
            return Coefficients::default();
        }
        self.table.coefficients(columns, rows)
    }

    fn coefficients_at(&self, offset: Offset) -> Option<Coefficients> {
        self.table.influence().coefficients(offset).ok()
    }

    /// That of the farthest cell.
    fn least_normal_influence(&self) -> Option<f64> {
        let [columns, rows] = [self.grid.nx(), self.grid.ny()].map(|count| count as i32 - 1);
        Some(self.normal(columns, rows))
    }

    fn inverse(&self) -> Option<Arc<dyn Preconditioner>> {
        Some(Arc::new(self.inverse.clone()))
    }

    fn rough_inverse(&self) -> Option<Arc<dyn Preconditioner>> {
        Some(Arc::new(self.rough_inverse.clone()))
    }

    fn coarser(&self) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        let build = || {
            let grid = self.grid().coarser()?;
            let threads = self.plan.threads.on_smaller(grid);
            let coarse = Self::with_blocks(self.pair(), grid, self.blocks, threads)?;
            Ok(Box::new(coarse) as Box<dyn SurfaceOperator>)
        };
        Some(build())
    }

    fn on_fewer(
        &self,
        nx: usize,
        ny: usize,
    ) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        let build = || {
            let (pair, all) = (self.pair(), self.grid);
            for (field, cells, most) in [("nx", nx, all.nx()), ("ny", ny, all.ny())] {
                let holds = (1..=most).contains(&cells);
                RangeError::check(
                    field,
                    cells as f64,
                    holds,
                    "from 1 to the number of the operator",
                )?;
            }
            let grid = Grid::new(nx, ny, all.dx(), all.dy())?;
            let threads = self.plan.threads.on_smaller(grid);
            memory::check(Self::bytes(&pair, grid, self.blocks, threads))?;
            let fewer = Self::of_table(Arc::clone(&self.table), grid, self.blocks, threads);
            Ok(Box::new(fewer) as Box<dyn SurfaceOperator>)
        };
        Some(build())
    }

    fn among(&self, cells: &[usize]) -> Option<Box<dyn SurfaceOperator>> {
        let hierarchy = self.hierarchy.get_or_init(|| {
            let kernel = |columns: i32, rows: i32| self.normal(columns, rows);
            let place = (self.grid, self.plan.threads);
            Hierarchy::new(place, kernel, &self.pair(), false).map(Arc::new)
        });
        let operator = hierarchy.as_ref()?.among(cells)?;
        Some(Box::new(operator))
    }

    fn apply(
        &self,
        tractions: TractionField<'_>,
        displacements: DisplacementField<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError> {
        let terms = (|of, by| self.term(of, by), 1.0);
        apply(&self.plan, terms, tractions, displacements, workspace)
    }

    fn pressed<'a>(
        &'a self,
        pressure: &[f64],
        workspace: &'a mut Workspace,
    ) -> Result<Box<dyn NormalRows + 'a>, OperatorError> {
        TractionField::normal(pressure).check(self.grid.cells())?;
        let term = self.term(Axis::Normal, Axis::Normal)?;
        Ok(Box::new(self.plan.by_rows(pressure, term, workspace)))
    }

    fn has_rough_products(&self) -> bool {
        true
    }

    fn apply_roughly(
        &self,
        tractions: TractionField<'_>,
        displacements: DisplacementField<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError> {
        let single = self.single();
        let terms = (|of, by| self.single_term(single, of, by), single.unit);
        apply(&single.plan, terms, tractions, displacements, workspace)
    }
}

impl std::fmt::Debug for HalfSpaceOperator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("HalfSpaceOperator")
            .field("pair", &self.pair())
            .field("grid", &self.grid)
            .field("padded", &(self.plan.sizes.px, self.plan.sizes.py))
            .finish_non_exhaustive()
    }
}
