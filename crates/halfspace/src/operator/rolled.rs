//! The change of displacement of particles between two steps of rolling.

use std::sync::Arc;

use super::{
    DisplacementField, KernelOperator, OperatorError, Preconditioner, SurfaceOperator,
    TabulatedKernel, Threads, TractionField, Validity, Workspace,
};
use crate::{Coefficients, Grid, Offset};
use carom_special::RangeError;

/// The change of displacement of particles in a step of steady rolling, `u(x) - u(x + d)` and
/// `v(x) - v(x + d)`: in the step the particle at x comes from x + d, where the same tractions
/// displaced it before. The normal displacement is that of the body itself.
///
/// For an operator that knows its [coefficients at any
/// offset](SurfaceOperator::coefficients_at) the displacements at x + d are exact, also beyond the
/// grid. For any other operator they are interpolated between the cells of the grid, and those
/// beyond it are zero.
///
/// ```
/// use std::sync::Arc;
/// use carom_halfspace::operator::{HalfSpaceOperator, RolledOperator, SurfaceOperator, Threads};
/// use carom_halfspace::{Grid, Material, MaterialPair, Offset};
/// let steel = Material::from_young(208e3, 0.3)?;
/// let pair = MaterialPair::new(steel, steel)?;
/// let body = Arc::new(HalfSpaceOperator::new(pair, Grid::new(16, 16, 0.1, 0.1)?)?);
/// let ahead = Offset { x: 0.1, y: 0.0 };
/// let rolled = RolledOperator::new(body.clone(), ahead, Threads::One)?;
/// let [own, before] = [0, -1].map(|columns| body.coefficients(columns, 0).rows[0][0]);
/// assert_eq!(rolled.coefficients(0, 0).rows[0][0], own - before);
/// # Ok::<(), carom_halfspace::operator::OperatorError>(())
/// ```
#[derive(Clone)]
pub struct RolledOperator {
    body: Arc<dyn SurfaceOperator>,
    ahead: Offset,
    /// Factor of the change: on coarser cells the step is longer, the change that of one step of
    /// the finest.
    part: f64,
    product: KernelOperator,
    inverse: Option<Arc<dyn Preconditioner>>,
}

/// Relative deviation from a whole number of cells that counts as rounding.
const ROUNDING: f64 = 1e-9;

impl RolledOperator {
    /// For particles that come from `ahead` in a step; products are computed on `threads`.
    ///
    /// # Errors
    /// [`OperatorError::NotInvariant`] for an operator that is not translation-invariant,
    /// [`OperatorError::Range`] for an offset that is zero or not finite,
    /// [`OperatorError::TooLarge`] for memory.
    pub fn new(
        body: Arc<dyn SurfaceOperator>,
        ahead: Offset,
        threads: Threads,
    ) -> Result<Self, OperatorError> {
        RangeError::finite("rolling distance along x", ahead.x)?;
        RangeError::finite("rolling distance along y", ahead.y)?;
        RangeError::positive("rolling distance", libm::hypot(ahead.x, ahead.y))?;
        Self::with_part(body, ahead, 1.0, threads)
    }

    fn with_part(
        body: Arc<dyn SurfaceOperator>,
        ahead: Offset,
        part: f64,
        threads: Threads,
    ) -> Result<Self, OperatorError> {
        body.check_invariant()?;
        let kernel = TabulatedKernel::from_function(body.grid(), |columns, rows| {
            let before = coefficients_ahead(&*body, ahead, [columns, rows]);
            let mut own = body.coefficients(columns, rows);
            for (own, before) in own.rows.iter_mut().zip(before.rows).take(2) {
                own.iter_mut().zip(before).for_each(|(own, before)| *own = part * (*own - before));
            }
            own
        })?;
        Self::of_kernel(body, ahead, part, KernelOperator::new(kernel, threads)?)
    }

    fn of_kernel(
        body: Arc<dyn SurfaceOperator>,
        ahead: Offset,
        part: f64,
        product: KernelOperator,
    ) -> Result<Self, OperatorError> {
        let inverse = body.inverse().and_then(|inverse| inverse.rolled(ahead, part));
        Ok(Self { body, ahead, part, product, inverse })
    }

    /// Where the particles come from in a step.
    #[must_use]
    pub const fn ahead(&self) -> Offset {
        self.ahead
    }
}

/// The influence of a source on the point ahead of a receiver, `[columns, rows]` from the receiver
/// to the source.
pub(super) fn coefficients_ahead(
    body: &dyn SurfaceOperator,
    ahead: Offset,
    [columns, rows]: [i32; 2],
) -> Coefficients {
    let grid = body.grid();
    let [along, across] = [ahead.x / grid.dx(), ahead.y / grid.dy()].map(cells);
    let (from_x, from_y) = (f64::from(columns) - along, f64::from(rows) - across);
    let inside = from_x.abs() < grid.nx() as f64 && from_y.abs() < grid.ny() as f64;
    let whole = along.fract() == 0.0 && across.fract() == 0.0;
    if whole && inside {
        return body.coefficients(from_x as i32, from_y as i32);
    }
    let offset = Offset { x: from_x * grid.dx(), y: from_y * grid.dy() };
    body.coefficients_at(offset).unwrap_or_else(|| between(body, [from_x, from_y]))
}

/// A length in cells; whole but for rounding counts as whole.
fn cells(length: f64) -> f64 {
    let whole = length.round();
    if (length - whole).abs() < ROUNDING * whole.abs().max(1.0) { whole } else { length }
}

/// The coefficients interpolated between whole offsets, of which those beyond a period are repeated.
fn between(body: &dyn SurfaceOperator, [from_x, from_y]: [f64; 2]) -> Coefficients {
    let grid = body.grid();
    let period = |cells: f64, count: usize| {
        if body.displaces_on_average() { cells } else { cells.rem_euclid(count as f64) }
    };
    let mut sum = Coefficients::default();
    for (column, along) in ends(from_x) {
        for (row, across) in ends(from_y) {
            let (column, row) = (period(column, grid.nx()), period(row, grid.ny()));
            let known = body.coefficients(column as i32, row as i32);
            for (sum, known) in sum.rows.iter_mut().flatten().zip(known.rows.iter().flatten()) {
                *sum += along * across * known;
            }
        }
    }
    sum
}

/// The whole numbers on both sides, with their weights.
fn ends(place: f64) -> [(f64, f64); 2] {
    let low = place.floor();
    let part = place - low;
    [(low, 1.0 - part), (low + 1.0, part)]
}

impl SurfaceOperator for RolledOperator {
    fn grid(&self) -> Grid {
        self.body.grid()
    }

    fn threads(&self) -> Threads {
        self.product.threads()
    }

    fn is_coupled(&self) -> bool {
        self.body.is_coupled()
    }

    fn is_separate(&self) -> bool {
        self.body.is_separate()
    }

    fn displaces_on_average(&self) -> bool {
        self.body.displaces_on_average()
    }

    fn is_reciprocal(&self) -> bool {
        false
    }

    fn contact_modulus(&self) -> Option<f64> {
        self.body.contact_modulus()
    }

    fn validity(&self) -> Validity {
        self.body.validity()
    }

    fn coefficients(&self, columns: i32, rows: i32) -> Coefficients {
        self.product.coefficients(columns, rows)
    }

    fn inverse(&self) -> Option<Arc<dyn Preconditioner>> {
        self.inverse.clone()
    }

    fn coarser(&self) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        let coarse = self.body.coarser()?;
        // On coarse cells the same step would be too short for their centres.
        let ahead = Offset { x: 2.0 * self.ahead.x, y: 2.0 * self.ahead.y };
        let build = || {
            let coarse: Arc<dyn SurfaceOperator> = Arc::from(coarse?);
            let threads = self.threads().on_smaller(coarse.grid());
            let rolled = Self::with_part(coarse, ahead, 0.5 * self.part, threads)?;
            Ok(Box::new(rolled) as Box<dyn SurfaceOperator>)
        };
        Some(build())
    }

    fn on_fewer(
        &self,
        nx: usize,
        ny: usize,
    ) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        let fewer = self.body.on_fewer(nx, ny)?;
        let build = || {
            let body: Arc<dyn SurfaceOperator> = Arc::from(fewer?);
            let known = |columns, rows| self.product.coefficients(columns, rows);
            let kernel = TabulatedKernel::from_function(body.grid(), known)?;
            let threads = self.threads().on_smaller(body.grid());
            let product = KernelOperator::new(kernel, threads)?;
            let rolled = Self::of_kernel(body, self.ahead, self.part, product)?;
            Ok(Box::new(rolled) as Box<dyn SurfaceOperator>)
        };
        Some(build())
    }

    fn workspace(&self) -> Workspace {
        self.product.workspace()
    }

    fn apply(
        &self,
        tractions: TractionField<'_>,
        displacements: DisplacementField<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError> {
        self.product.apply(tractions, displacements, workspace)
    }
}

impl std::fmt::Debug for RolledOperator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("RolledOperator")
            .field("grid", &self.grid())
            .field("ahead", &self.ahead)
            .finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::operator::{HalfSpaceOperator, PeriodicOperator};
    use crate::{Material, MaterialPair, RectangleInfluence};

    fn pair() -> MaterialPair {
        let [one, two] = [0.1, 0.45].map(|nu| Material::from_shear(1.0, nu).unwrap());
        MaterialPair::new(one, two).unwrap()
    }

    fn half_space(grid: Grid) -> Arc<dyn SurfaceOperator> {
        Arc::new(HalfSpaceOperator::new(pair(), grid).unwrap())
    }

    /// Displacements u, v, w due to tractions that vary from cell to cell.
    fn displaced(operator: &dyn SurfaceOperator) -> [Vec<f64>; 3] {
        let cells = operator.grid().cells();
        let [x, y, p] = [0.3, 1.1, 2.0]
            .map(|phase| (0..cells).map(|i| (phase + 1.7 * i as f64).sin()).collect::<Vec<_>>());
        let [mut u, mut v, mut w] = [(); 3].map(|()| vec![0.0; cells]);
        let out = DisplacementField::full(&mut u, &mut v, &mut w);
        operator.apply(TractionField::full(&x, &y, &p), out, &mut operator.workspace()).unwrap();
        [u, v, w]
    }

    #[test]
    fn whole_steps_move_the_displacements_by_columns_and_rows() {
        let grid = Grid::new(9, 7, 0.3, 0.2).unwrap();
        let body = half_space(grid);
        let ahead = Offset { x: 2.0 * 0.3, y: -0.2 };
        let rolled = RolledOperator::new(body.clone(), ahead, Threads::One).unwrap();
        let (still, moved) = (displaced(&*body), displaced(&rolled));
        for row in 1..7 {
            for column in 0..7 {
                let (at, from) = (grid.index(column, row), grid.index(column + 2, row - 1));
                for axis in 0..2 {
                    let want = still[axis][at] - still[axis][from];
                    assert!((moved[axis][at] - want).abs() < 1e-14);
                }
                assert!((moved[2][at] - still[2][at]).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn steps_between_cells_and_beyond_the_grid_are_exact() {
        let grid = Grid::new(5, 4, 0.3, 0.2).unwrap();
        let cell = RectangleInfluence::new(pair(), grid.cell());
        for ahead in [Offset { x: 0.13, y: 0.05 }, Offset { x: 1.2, y: 0.0 }] {
            let rolled = RolledOperator::new(half_space(grid), ahead, Threads::One).unwrap();
            let own = rolled.coefficients(-3, 2);
            let at = |x: f64, y: f64| cell.coefficients(Offset { x, y }).unwrap().rows;
            let (now, before) = (at(-0.9, 0.4), at(-0.9 - ahead.x, 0.4 - ahead.y));
            for axis in 0..2 {
                for by in 0..3 {
                    let want = now[axis][by] - before[axis][by];
                    assert!((own.rows[axis][by] - want).abs() < 1e-15);
                }
            }
            assert!(own.rows[2].iter().zip(now[2]).all(|(own, now)| (own - now).abs() < 1e-15));
        }
        let still = RolledOperator::new(half_space(grid), Offset::default(), Threads::One);
        assert!(matches!(still, Err(OperatorError::Range(e)) if e.field == "rolling distance"));
    }

    #[test]
    fn a_period_repeats_ahead_and_fewer_cells_have_the_same_influence() {
        let grid = Grid::new(8, 6, 0.3, 0.2).unwrap();
        let period: Arc<dyn SurfaceOperator> =
            Arc::new(PeriodicOperator::new(pair(), grid, Threads::One).unwrap());
        let ahead = Offset { x: 0.6, y: 0.0 };
        let rolled = RolledOperator::new(period.clone(), ahead, Threads::One).unwrap();
        let (still, moved) = (displaced(&*period), displaced(&rolled));
        for at in 0..grid.cells() {
            let from = at - at % 8 + (at % 8 + 2) % 8;
            let want = still[0][at] - still[0][from];
            assert!((moved[0][at] - want).abs() < 1e-13, "{at}: {} {want}", moved[0][at]);
        }
        let rolled = RolledOperator::new(half_space(grid), ahead, Threads::One).unwrap();
        let fewer = rolled.on_fewer(4, 3).unwrap().unwrap();
        assert_eq!(fewer.coefficients(-2, 1), rolled.coefficients(-2, 1));
        let coarse = rolled.coarser().unwrap().unwrap();
        assert_eq!((coarse.grid().nx(), coarse.is_reciprocal()), (4, false));
    }
}
