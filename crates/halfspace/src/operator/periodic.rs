//! The half-space under tractions that are periodic with the sides of the grid.

use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

use super::length::Sizes;
use super::memory;
use super::plan::Plan;
use super::product::{Term, Terms, apply, reduced};
use super::sparse::Hierarchy;
use super::spectrum::Spectrum;
use super::table::Entry;
use super::torus::TorusInverse;
use super::{
    Axis, Blocks, DisplacementField, NormalRows, OperatorError, Preconditioner, SurfaceOperator,
    Threads, TractionField, Workspace,
};
use crate::{Coefficients, Grid, MaterialPair};
use carom_special::RangeError;

/// Two elastic half-spaces under tractions that are periodic with the sides of the grid.
///
/// A wave `exp(i k x)` of the pressure causes the normal displacement `(1 - nu)/G/|k|`, one of the
/// tangential tractions the tangential displacement `[1 - nu k k^T/k^2]/G/|k|`, and each causes the
/// other displacement with the factor `-+ i epsilon k/k^2` (the transforms of (4.8), (4.9)).
/// Tractions are the waves through the values at the cell centres. The mean traction causes no
/// displacement: all displacements are relative to the mean plane. The approach is that of the mean
/// planes, and is at most the mean of the gap, where the whole surface is in contact; tangential
/// shifts are also those of the mean planes.
///
/// ```
/// use carom_halfspace::operator::{
///     DisplacementField, PeriodicOperator, SurfaceOperator, Threads, TractionField,
/// };
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// let body = Material::from_shear(2.0, 0.3)?;
/// let pair = MaterialPair::new(body, body)?;
/// let grid = Grid::new(32, 8, 0.25, 0.25)?;
/// let operator = PeriodicOperator::new(pair, grid, Threads::One)?;
/// let k = std::f64::consts::TAU / 8.0;
/// let pressure: Vec<f64> = grid.centres().map(|(x, _)| 3.0 + (k * x).cos()).collect();
/// let mut w = vec![0.0; grid.cells()];
/// let displacement = DisplacementField::normal(&mut w);
/// operator.apply(TractionField::normal(&pressure), displacement, &mut operator.workspace())?;
/// for ((x, _), w) in grid.centres().zip(w) {
///     assert!((w - 0.7 / k * (k * x).cos()).abs() < 1e-14);
/// }
/// # Ok::<(), carom_halfspace::operator::OperatorError>(())
/// ```
#[derive(Clone)]
pub struct PeriodicOperator {
    pair: MaterialPair,
    grid: Grid,
    plan: Plan,
    blocks: Blocks,
    /// Each is computed when first needed.
    spectra: Arc<[OnceLock<Spectrum>; 6]>,
    /// Displacements due to unit tractions x, y, normal on the first cell, likewise.
    responses: Arc<[OnceLock<Vec<f64>>; 9]>,
    inverse: TorusInverse,
    hierarchy: Arc<OnceLock<Option<Arc<Hierarchy>>>>,
}

impl PeriodicOperator {
    /// The operator of a pair of bodies on one period, with all blocks.
    ///
    /// # Errors
    /// [`OperatorError::Range`] unless both numbers of cells are even,
    /// [`OperatorError::TooLarge`] before anything is allocated.
    pub fn new(pair: MaterialPair, grid: Grid, threads: Threads) -> Result<Self, OperatorError> {
        Self::with_blocks(pair, grid, Blocks::All, threads)
    }

    /// The operator with the given blocks.
    ///
    /// # Errors
    /// As [`PeriodicOperator::new`].
    pub fn with_blocks(
        pair: MaterialPair,
        grid: Grid,
        blocks: Blocks,
        threads: Threads,
    ) -> Result<Self, OperatorError> {
        for (field, count) in [("nx", grid.nx()), ("ny", grid.ny())] {
            let allowed = "even on a period";
            RangeError::check(field, count as f64, count.is_multiple_of(2), allowed)?;
        }
        let sizes = Sizes::of_period(grid);
        // Responses of nine pairs of components; without friction none is kept.
        let (fields, kept) = match blocks {
            Blocks::All => (3, 9),
            Blocks::Normal => (1, 1),
            Blocks::Tangential => (2, 4),
        };
        let responses = 8 * kept * grid.cells() as u128;
        let spectra = blocks.count(&pair) as u128 * sizes.symmetric_spectrum();
        memory::check(spectra + sizes.workspace(fields, threads) + responses)?;
        let plan = Plan::on(sizes, threads);
        let inverse = TorusInverse::new(&pair, grid, threads);
        let (spectra, responses, hierarchy) = Default::default();
        Ok(Self { pair, grid, plan, blocks, spectra, responses, inverse, hierarchy })
    }

    /// The displacements of all cells along an axis, due to a unit traction on the first cell.
    fn response(&self, of: Axis, by: Axis) -> Vec<f64> {
        let (mut unit, mut response) = (vec![0.0; self.grid.cells()], vec![0.0; self.grid.cells()]);
        unit[0] = 1.0;
        let mut blocks = [[None; 3]; 3];
        blocks[0][0] = self.term(Blocks::All, of, by).unwrap_or_default();
        let terms = Terms { blocks: &blocks, unit: 1.0 };
        reduced(&self.plan, &[&unit], &terms, &mut [&mut response], &mut Workspace::default());
        response
    }

    /// The same, kept.
    fn kept_response(&self, of: Axis, by: Axis) -> &[f64] {
        let place = &self.responses[3 * of as usize + by as usize];
        if let Some(known) = place.get() {
            return known;
        }
        // Not under the lock: pool threads that wait may start other products.
        let new = self.response(of, by);
        place.get_or_init(|| new)
    }

    fn term(&self, blocks: Blocks, of: Axis, by: Axis) -> Result<Option<Term<'_>>, OperatorError> {
        let (entry, sign) = blocks.entry(&self.pair, of, by)?;
        let place = |entry: Entry| &self.spectra[entry as usize];
        let all = |entry| spectrum(&self.pair, self.grid, &self.plan.sizes, entry);
        let is_alone = self.blocks == Blocks::Normal;
        let new = |entry| if is_alone { all(entry).folded(self.grid) } else { all(entry) };
        let spectrum = |entry| place(entry).get_or_init(|| new(entry));
        Ok(entry.map(|entry| Term { spectrum: spectrum(entry), sign }))
    }
}

/// The symbol of a block, column by column, divided by the number of cells.
fn spectrum(pair: &MaterialPair, grid: Grid, sizes: &Sizes, entry: Entry) -> Spectrum {
    let (nx, ny) = (sizes.px, sizes.py);
    let (side_x, side_y) = (nx as f64 * grid.dx(), ny as f64 * grid.dy());
    let (nu, compliance) = (pair.poisson(), 1.0 / pair.shear_modulus());
    let mut values = Vec::with_capacity(sizes.columns() * (ny / 2 + 1));
    for column in 0..sizes.columns() {
        for row in 0..=ny / 2 {
            let (x, y) = (TAU * column as f64 / side_x, TAU * row as f64 / side_y);
            let square = x * x + y * y;
            // The shortest wave along an axis has no sign.
            let odd_x = if 2 * column == nx { 0.0 } else { x / square };
            let odd_y = if 2 * row == ny { 0.0 } else { y / square };
            let whole = compliance / square.sqrt();
            let value = match entry {
                _ if square == 0.0 => 0.0,
                Entry::Xx => whole * (1.0 - nu * x * x / square),
                Entry::Xy => -whole * nu * odd_x * odd_y * square,
                Entry::Yy => whole * (1.0 - nu * y * y / square),
                Entry::Zz => whole * (1.0 - nu),
                Entry::Xz => pair.epsilon() * odd_x,
                Entry::Yz => pair.epsilon() * odd_y,
            };
            values.push(value / (nx as f64 * ny as f64));
        }
    }
    let [along, across] = entry.parity();
    let (half, imaginary) = (ny / 2 + 1, along != across);
    Spectrum::Symmetric { values, half, imaginary, row_parity: across }
}

impl SurfaceOperator for PeriodicOperator {
    fn grid(&self) -> Grid {
        self.grid
    }

    fn threads(&self) -> Threads {
        self.plan.threads
    }

    fn is_coupled(&self) -> bool {
        !self.pair.is_uncoupled()
    }

    fn is_separate(&self) -> bool {
        self.pair.poisson() == 0.0
    }

    fn contact_modulus(&self) -> Option<f64> {
        Some(self.pair.contact_modulus())
    }

    fn displaces_on_average(&self) -> bool {
        false
    }

    /// The coefficients of a source together with all its periodic images.
    fn coefficients(&self, columns: i32, rows: i32) -> Coefficients {
        let (nx, ny) = (self.grid.nx(), self.grid.ny());
        if columns.unsigned_abs() as usize >= nx || rows.unsigned_abs() as usize >= ny {
            return Coefficients::default();
        }
        let column = (-columns).rem_euclid(nx as i32) as usize;
        let row = (-rows).rem_euclid(ny as i32) as usize;
        let at = self.grid.index(column, row);
        let rows = Axis::ALL.map(|of| Axis::ALL.map(|by| self.kept_response(of, by)[at]));
        Coefficients { rows }
    }

    /// The sum of all waves; a response has the memory of a field.
    fn normal_influence_of_a_cell(&self) -> f64 {
        let term = self.term(Blocks::All, Axis::Normal, Axis::Normal).unwrap_or_default();
        term.map_or(0.0, |term| term.spectrum.sum(&self.plan.sizes))
    }

    fn inverse(&self) -> Option<Arc<dyn Preconditioner>> {
        Some(Arc::new(self.inverse.clone()))
    }

    fn coarser(&self) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        let divisible = |count: usize| count.is_multiple_of(4);
        (divisible(self.grid.nx()) && divisible(self.grid.ny())).then(|| {
            let grid = self.grid.coarser()?;
            let threads = self.plan.threads.on_smaller(grid);
            let coarse = Self::with_blocks(self.pair, grid, self.blocks, threads)?;
            Ok(Box::new(coarse) as Box<dyn SurfaceOperator>)
        })
    }

    fn among(&self, cells: &[usize]) -> Option<Box<dyn SurfaceOperator>> {
        let hierarchy = self.hierarchy.get_or_init(|| {
            let [nx, ny] = [self.grid.nx(), self.grid.ny()];
            let response = self.response(Axis::Normal, Axis::Normal);
            let kernel = |columns: i32, rows: i32| {
                let place = |offset: i32, count: usize| offset.rem_euclid(count as i32) as usize;
                response[self.grid.index(place(columns, nx), place(rows, ny))]
            };
            Hierarchy::new((self.grid, self.plan.threads), kernel, &self.pair, true).map(Arc::new)
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
        apply(
            &self.plan,
            (|of, by| self.term(self.blocks, of, by), 1.0),
            tractions,
            displacements,
            workspace,
        )
    }

    fn pressed<'a>(
        &'a self,
        pressure: &[f64],
        workspace: &'a mut Workspace,
    ) -> Result<Box<dyn NormalRows + 'a>, OperatorError> {
        TractionField::normal(pressure).check(self.grid.cells())?;
        let term = self.term(self.blocks, Axis::Normal, Axis::Normal)?;
        Ok(Box::new(self.plan.by_rows(pressure, term, workspace)))
    }
}

impl std::fmt::Debug for PeriodicOperator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PeriodicOperator")
            .field("pair", &self.pair)
            .field("grid", &self.grid)
            .finish_non_exhaustive()
    }
}
