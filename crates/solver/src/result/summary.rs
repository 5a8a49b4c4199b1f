//! A step in numbers.

use carom_laws::law::{ContactLoad, Shift};
use carom_table::Column;

use crate::convergence::Convergence;
use crate::problem::ContactProblem;
use crate::result::{StoredEnergy, dissipated};
use crate::state::{CellState, ContactState};
use carom_halfspace::operator::OperatorError;

/// The contact at the end of a step, in numbers. SI units; loads act on body 1.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::friction::Friction;
/// use carom_solver::{
///     ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method as _, StepSummary,
/// };
/// let grid = Grid::new(24, 24, 1e-5, 1e-5)?;
/// let steel = Material::from_young(208e9, 0.3)?;
/// let pair = MaterialPair::new(steel, steel)?;
/// let problem = ContactProblem::of_half_spaces(Gap::sphere(grid, 0.01)?, pair, Friction::new(0.3)?)?;
/// let method = Frictional::default();
/// let before = ContactState::apart(grid);
/// let (mut after, mut scratch) = (before.clone(), method.scratch(&problem)?);
/// let pressed = Drive { normal: Driven::Load(5.0), ..Drive::default() };
/// let went = method.step(&problem, &before, &pressed, &mut after, &mut scratch, &mut ())?;
/// let step = StepSummary::of(&problem, &before, &after, &went)?;
/// assert!((step.load.f_z - 5.0).abs() < 1e-6 && step.dissipated == 0.0);
/// // Hertz: 2/5 of force times approach.
/// assert!((step.stored_energy / (0.4 * 5.0 * step.shift.zeta) - 1.0).abs() < 0.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepSummary {
    /// Where the bodies are.
    pub shift: Shift,
    /// What that takes.
    pub load: ContactLoad,
    /// The greatest pressure.
    pub greatest_pressure: f64,
    /// Area of all cells in contact.
    pub contact_area: f64,
    /// Area of those that stick.
    pub stick_area: f64,
    /// Elastic energy of both bodies.
    pub stored_energy: f64,
    /// Friction heat of the step.
    pub dissipated: f64,
    /// How the step went.
    pub convergence: Convergence,
}

impl StepSummary {
    /// Of the step between two states.
    ///
    /// # Errors
    /// [`OperatorError`] unless both are on the grid of the problem.
    pub fn of(
        problem: &ContactProblem,
        before: &ContactState,
        after: &ContactState,
        convergence: &Convergence,
    ) -> Result<Self, OperatorError> {
        let area = after.pressure.grid().cell_area();
        let [stick, slip] =
            [CellState::Stick, CellState::Slip].map(|cell| after.count(cell) as f64);
        Ok(Self {
            shift: after.shift,
            load: after.load(),
            greatest_pressure: after.peak_pressure(),
            contact_area: area * (stick + slip),
            stick_area: area * stick,
            stored_energy: StoredEnergy::of(problem, after)?.total(),
            dissipated: dissipated(before, after).values().iter().sum(),
            convergence: *convergence,
        })
    }

    /// Its columns.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("zeta", "m", "approach", |step| step.shift.zeta.into()),
        Column::new("xi", "m", "shift of body 2 against body 1 along x", |s| s.shift.xi.into()),
        Column::new("eta", "m", "the same along y", |step| step.shift.eta.into()),
        Column::new("omega", "rad", "twist about the normal", |step| step.shift.omega.into()),
        Column::new("F_x", "N", "force on body 1 along x", |step| step.load.f_x.into()),
        Column::new("F_y", "N", "the same along y", |step| step.load.f_y.into()),
        Column::new("F_z", "N", "normal force", |step| step.load.f_z.into()),
        Column::new("M_z", "N m", "torque on body 1", |step| step.load.m_z.into()),
        Column::new("p_max", "Pa", "greatest pressure", |step| step.greatest_pressure.into()),
        Column::new("contact_area", "m2", "of all cells in contact", |s| s.contact_area.into()),
        Column::new("stick_area", "m2", "of those that stick", |step| step.stick_area.into()),
        Column::new("stored_energy", "J", "elastic energy of both bodies", |step| {
            step.stored_energy.into()
        }),
        Column::new("dissipated", "J", "friction heat of the step", |s| s.dissipated.into()),
        Column::new("residual_normal", "", "what is left of the normal conditions", |step| {
            step.convergence.residuals.normal.into()
        }),
        Column::new("residual_tangential", "", "what is left of the friction law", |step| {
            step.convergence.residuals.tangential.into()
        }),
        Column::new("products_normal", "", "products with the normal influence", |step| {
            step.convergence.products.normal.into()
        }),
        Column::new("products_tangential", "", "the same with the tangential one", |step| {
            step.convergence.products.tangential.into()
        }),
    ];
}
