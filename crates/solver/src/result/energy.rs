//! Elastic energy and friction heat, cell by cell.

use carom_halfspace::Field;
use carom_halfspace::operator::{
    DisplacementField, NormalRows, OperatorError, TractionField, Workspace,
};

use crate::problem::ContactProblem;
use crate::state::ContactState;

/// The elastic energy of both bodies, cell by cell.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::curvature::RelativeCurvature;
/// use carom_laws::friction::Friction;
/// use carom_solver::{
///     ContactProblem, ContactState, Drive, Driven, Frictionless, Gap, Method, StoredEnergy,
/// };
/// let grid = Grid::new(48, 48, 0.05, 0.05)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let pair = MaterialPair::new(Material::from_shear(1.0, 0.5)?, Material::RIGID)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::NONE)?;
/// let (method, apart) = (Frictionless::default(), ContactState::apart(grid));
/// let (mut scratch, mut state) = (method.scratch(&problem)?, apart.clone());
/// let drive = Drive { normal: Driven::Shift(1.0), ..Drive::default() };
/// method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
/// // Hertz: (2/5) F_z zeta.
/// let stored = StoredEnergy::of(&problem, &state)?.total();
/// assert!((stored / (0.4 * state.load().f_z) - 1.0).abs() < 2e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct StoredEnergy {
    /// Half of pressure times normal displacement, times the cell area.
    pub normal: Field,
    /// Half of tangential tractions times displacements, times the cell area.
    pub tangential: Field,
}

impl StoredEnergy {
    /// The energy of a state of a problem.
    ///
    /// # Errors
    /// [`OperatorError`] if the state is on another grid.
    pub fn of(problem: &ContactProblem, state: &ContactState) -> Result<Self, OperatorError> {
        let [mut u, v, mut w] = displaced(problem, state)?;
        let half = 0.5 * problem.grid().cell_area();
        for (own, p) in w.values_mut().iter_mut().zip(state.pressure.values()) {
            *own *= half * p;
        }
        let (x, y) = (state.traction_x.values(), state.traction_y.values());
        let both = u.values_mut().iter_mut().zip(v.values()).zip(x).zip(y);
        for (((own, v), x), y) in both {
            *own = half * (*own * x + v * y);
        }
        Ok(Self { normal: w, tangential: u })
    }

    /// The tangential part, summed over all cells, and the normal displacements w1 - w2 row by row.
    pub(super) fn tangential_and_rows<'a>(
        problem: &'a ContactProblem,
        state: &ContactState,
        workspace: &'a mut Workspace,
    ) -> Result<(f64, Box<dyn NormalRows + 'a>), OperatorError> {
        if state.has_pressure_alone() {
            return Ok((0.0, problem.operator().pressed(state.pressure.values(), workspace)?));
        }
        let ([u, v, w], half) = (displaced(problem, state)?, 0.5 * problem.grid().cell_area());
        let along = u.values().iter().zip(state.traction_x.values()).map(|(u, x)| u * x);
        let across = v.values().iter().zip(state.traction_y.values()).map(|(v, y)| v * y);
        let sum = along.zip(across).map(|(along, across)| half * (along + across)).sum();
        Ok((sum, Box::new(w)))
    }

    /// The sum over all cells.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.normal.values().iter().sum::<f64>() + self.tangential.values().iter().sum::<f64>()
    }
}

/// The displacements of each cell; tangential ones are left zero where there are no tractions: they do no work, and not
/// every operator has them.
pub(super) fn displaced(
    problem: &ContactProblem,
    state: &ContactState,
) -> Result<[Field; 3], OperatorError> {
    let (operator, grid) = (problem.operator(), problem.grid());
    // Fields of zeros take no memory until they are written; copies do.
    let [mut u, mut v, mut w] = [(); 3].map(|()| Field::uniform(grid, 0.0));
    let (x, y) = (state.traction_x.values(), state.traction_y.values());
    let pressure = state.pressure.values();
    let is_normal = state.has_pressure_alone();
    let tractions = match is_normal {
        true => TractionField::normal(pressure),
        false => TractionField::full(x, y, pressure),
    };
    let displacements = match is_normal {
        true => DisplacementField::normal(w.values_mut()),
        false => DisplacementField::full(u.values_mut(), v.values_mut(), w.values_mut()),
    };
    operator.apply(tractions, displacements, &mut operator.workspace())?;
    Ok([u, v, w])
}

/// The friction heat of a step in each cell: tangential traction at the end of the step, times
/// slip, times cell area. For long steps the relative error is about the ratio of the slip to the
/// slip at full sliding.
#[must_use]
pub fn dissipated(before: &ContactState, after: &ContactState) -> Field {
    let mut heat = Field::uniform(after.pressure.grid(), 0.0);
    for (own, of_cell) in heat.values_mut().iter_mut().zip(heats(before, after)) {
        *own = of_cell;
    }
    heat
}

/// The sum over all cells.
pub(super) fn heat(before: &ContactState, after: &ContactState) -> f64 {
    if after.has_pressure_alone() { 0.0 } else { heats(before, after).sum() }
}

/// The same, cell by cell.
fn heats<'a>(before: &'a ContactState, after: &'a ContactState) -> impl Iterator<Item = f64> + 'a {
    let area = after.pressure.grid().cell_area();
    let tractions = after.traction_x.values().iter().zip(after.traction_y.values());
    let slips = after.slips_since(before).zip(tractions);
    slips.map(move |([along, across], (x, y))| -area * (along * x + across * y))
}
