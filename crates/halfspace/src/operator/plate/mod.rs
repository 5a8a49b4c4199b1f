//! The simply supported rectangular plate (proposition 3).

mod eigenvalues;
mod product;
mod shape;
mod sines;
mod symbol;

use std::sync::Arc;

use super::{
    Axis, DisplacementField, OperatorError, Preconditioner, SurfaceOperator, Threads,
    TractionField, Validity, Workspace, memory,
};
use crate::{Coefficients, Grid, MaterialPair};
use carom_special::RangeError;
use product::SinePlan;
use shape::Constants;
use symbol::Symbol;

pub(super) use product::SineSpace;
pub use shape::Plate;
pub use symbol::PlateSymbol;

/// The normal displacement of a simply supported rectangular plate due to pressures on the cells
/// that cover it (proposition 3).
///
/// On the edges the displacement is zero, and corners are held down. The pressure is constant in
/// each cell, the displacement is that of the centre. On such a grid the operator is diagonal in
/// sines: `A = S^T Lambda S`, with the orthonormal sine transforms of both axes in S and the
/// eigenvalues [`PlateOperator::eigenvalue`]. Each eigenvalue sums [`PlateSymbol`] over the waves
/// that look alike at the cell centres (Navier's series; Timoshenko and Woinowsky-Krieger), to
/// 1e-12. A product is four sine transforms of each row or column; the inverse is exact on the whole
/// plate.
///
/// The plate is body 2 and its material that of body 2 of the pair. Body 1, the punch, is rigid, or
/// an elastic half-space whose displacement is added wave by wave. The influence of a cell depends
/// on its place, so that methods for [translation-invariant](SurfaceOperator::is_invariant)
/// operators refuse a plate. There are no tangential displacements, hence no friction.
///
/// ```
/// use carom_halfspace::operator::{
///     DisplacementField, Plate, PlateOperator, PlateSymbol, SurfaceOperator, Threads,
///     TractionField,
/// };
/// use carom_halfspace::{Material, MaterialPair};
/// // E* = 1 and h = 0.01, hence D = h^3/12.
/// let glass = Material::from_young(0.91, 0.3)?;
/// let pair = MaterialPair::new(Material::RIGID, glass)?;
/// let plate = Plate::new(1.0, 1.0, 0.01)?;
/// let grid = plate.grid(25, 25)?;
/// let operator = PlateOperator::new(pair, plate, grid, PlateSymbol::Kirchhoff, Threads::One)?;
/// let mut w = vec![0.0; grid.cells()];
/// let load = vec![1.0; grid.cells()];
/// let displacement = DisplacementField::normal(&mut w);
/// operator.apply(TractionField::normal(&load), displacement, &mut operator.workspace())?;
/// // Timoshenko: w = 0.00406 q a^4/D in the middle.
/// assert!((w[grid.index(12, 12)] * 1e-6 / 12.0 - 0.00406).abs() < 1e-5);
/// # Ok::<(), carom_halfspace::operator::OperatorError>(())
/// ```
///
/// Clones are cheap: they share the eigenvalues.
#[derive(Clone)]
pub struct PlateOperator {
    pair: MaterialPair,
    plate: Plate,
    grid: Grid,
    kind: PlateSymbol,
    plan: SinePlan,
    /// Column by column: for each m = 1..=nx those of n = 1..=ny.
    eigenvalues: Arc<Vec<f64>>,
    /// Displacements due to a unit pressure on the middle cell.
    middle: Arc<Vec<f64>>,
}

impl PlateOperator {
    /// The operator of a plate, body 2 of `pair`, under body 1.
    ///
    /// # Errors
    /// [`OperatorError::Range`] unless the cells cover the plate exactly and its material is elastic,
    /// [`OperatorError::TooLarge`] before anything is allocated.
    pub fn new(
        pair: MaterialPair,
        plate: Plate,
        grid: Grid,
        kind: PlateSymbol,
        threads: Threads,
    ) -> Result<Self, OperatorError> {
        plate.check_cover(grid)?;
        let symbol = Symbol::new(kind, Constants::new(&pair, plate)?);
        let fields = 16 * grid.cells() as u128;
        memory::check(fields + SinePlan::workspace(grid, threads))?;
        let eigenvalues = eigenvalues::eigenvalues(plate, grid, &symbol, threads);
        let usable = |value: &f64| *value > 0.0 && value.is_finite() && (1.0 / value).is_finite();
        if let Some(value) = eigenvalues.iter().copied().find(|value| !usable(value)) {
            let allowed = "within the numbers of the machine; choose other units";
            return Err(RangeError::new("compliance of the plate", value, allowed).into());
        }
        let (plan, middle) = (SinePlan::new(grid, threads), Arc::default());
        let eigenvalues = Arc::new(eigenvalues);
        let own = Self { pair, plate, grid, kind, plan, eigenvalues, middle };
        Ok(own.with_middle())
    }

    fn with_middle(self) -> Self {
        let [mut unit, mut middle] = [(); 2].map(|()| vec![0.0; self.grid.cells()]);
        unit[self.grid.index(self.grid.nx() / 2, self.grid.ny() / 2)] = 1.0;
        let by = (&self.eigenvalues[..], |value| value);
        self.plan.product(by, &unit, &mut middle, &mut Workspace::default());
        Self { middle: Arc::new(middle), ..self }
    }

    /// The plate.
    #[must_use]
    pub const fn plate(&self) -> Plate {
        self.plate
    }

    /// The theory of the plate.
    #[must_use]
    pub const fn symbol(&self) -> PlateSymbol {
        self.kind
    }

    /// The materials: body 1 is the punch, body 2 the plate.
    #[must_use]
    pub const fn pair(&self) -> MaterialPair {
        self.pair
    }

    /// The eigenvalue of the wave `sin(m pi x/a) sin(n pi y/b)`, displacement over pressure; `None`
    /// unless 1 <= m <= nx and 1 <= n <= ny.
    #[must_use]
    pub fn eigenvalue(&self, m: usize, n: usize) -> Option<f64> {
        let (nx, ny) = (self.grid.nx(), self.grid.ny());
        let held = (1..=nx).contains(&m) && (1..=ny).contains(&n);
        held.then(|| self.eigenvalues[(m - 1) * ny + n - 1])
    }
}

impl SurfaceOperator for PlateOperator {
    fn grid(&self) -> Grid {
        self.grid
    }

    fn threads(&self) -> Threads {
        self.plan.threads()
    }

    fn is_coupled(&self) -> bool {
        false
    }

    fn is_separate(&self) -> bool {
        true
    }

    fn is_invariant(&self) -> bool {
        false
    }

    /// The plate is held at its border, and deflections above half the thickness stretch its middle
    /// plane.
    fn validity(&self) -> Validity {
        Validity { contact_at_border: false, displacement: 0.5 * self.plate.thickness() }
    }

    /// The influence of the middle cell on the cell at this offset from it; zero beyond the plate.
    fn coefficients(&self, columns: i32, rows: i32) -> Coefficients {
        let place = |offset: i32, count: usize| {
            (count / 2).checked_add_signed(-(offset as isize)).filter(|at| *at < count)
        };
        let mut coefficients = Coefficients::default();
        let at = (place(columns, self.grid.nx()), place(rows, self.grid.ny()));
        if let (Some(column), Some(row)) = at {
            coefficients.rows[2][2] = self.middle[self.grid.index(column, row)];
        }
        coefficients
    }

    fn inverse(&self) -> Option<Arc<dyn Preconditioner>> {
        let (plan, eigenvalues) = (self.plan.clone(), Arc::clone(&self.eigenvalues));
        Some(Arc::new(PlateInverse { plan, eigenvalues }))
    }

    /// The plate keeps its size; `None` unless both numbers of cells are even.
    fn coarser(&self) -> Option<Result<Box<dyn SurfaceOperator>, OperatorError>> {
        let even = |count: usize| count.is_multiple_of(2);
        (even(self.grid.nx()) && even(self.grid.ny())).then(|| {
            let (pair, grid) = (self.pair, self.grid.coarser()?);
            let threads = self.threads().on_smaller(grid);
            let coarse = Self::new(pair, self.plate, grid, self.kind, threads)?;
            Ok(Box::new(coarse) as Box<dyn SurfaceOperator>)
        })
    }

    fn apply(
        &self,
        tractions: TractionField<'_>,
        displacements: DisplacementField<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError> {
        tractions.check(self.grid.cells())?;
        displacements.check(self.grid.cells())?;
        let [x, y, pressure] = tractions.by_axis();
        let [u, v, w] = displacements.by_axis();
        for (axis, given) in [(Axis::X, x), (Axis::Y, y)] {
            if given.is_some_and(|values| values.iter().any(|value| *value != 0.0)) {
                let (of, by) = (Axis::Normal.displacement_name(), axis.traction_name());
                return Err(OperatorError::Missing { of, by });
            }
        }
        for (axis, wanted) in [(Axis::X, u), (Axis::Y, v)] {
            if wanted.is_some() {
                let (of, by) = (axis.displacement_name(), Axis::Normal.traction_name());
                return Err(OperatorError::Missing { of, by });
            }
        }
        match (pressure, w) {
            (Some(pressure), Some(w)) => {
                let by = (&self.eigenvalues[..], |value| value);
                self.plan.product(by, pressure, w, workspace);
            }
            (None, Some(w)) => w.fill(0.0),
            (_, None) => {}
        }
        Ok(())
    }
}

/// The inverse of a plate: exact on the whole plate, a preconditioner on the cells in contact.
struct PlateInverse {
    plan: SinePlan,
    eigenvalues: Arc<Vec<f64>>,
}

impl Preconditioner for PlateInverse {
    fn pressure(&self, displacement: &[f64], pressure: &mut [f64], workspace: &mut Workspace) {
        let by = (&self.eigenvalues[..], |value: f64| 1.0 / value);
        self.plan.product(by, displacement, pressure, workspace);
    }
}

impl std::fmt::Debug for PlateOperator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PlateOperator")
            .field("plate", &self.plate)
            .field("grid", &self.grid)
            .field("symbol", &self.kind)
            .finish_non_exhaustive()
    }
}
