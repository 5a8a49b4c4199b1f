//! The scalar results of a step.

use carom_laws::law::{ContactLoad, Shift};
use carom_table::{Column, Value};

use crate::accuracy::{Estimated, Estimates};
use crate::convergence::{Convergence, Products, Residuals};
use crate::problem::ContactProblem;
use crate::result::energy::heat;
use crate::result::surfaces::{Surfaces, rms_slope};
use crate::state::{CellState, ContactState};
use carom_halfspace::operator::OperatorError;

/// The scalar results of a step, at its end. SI units; loads act on body 1. The default is the
/// state before the first step: all values are zero.
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
/// let convergence = method.step(&problem, &before, &pressed, &mut after, &mut scratch, &mut ())?;
/// let step = StepSummary::default().next(&problem, [&before, &after], &convergence)?;
/// assert!((step.load.f_z - 5.0).abs() < 1e-6 && step.dissipated == 0.0);
/// // Hertz: 2/5 of force times approach.
/// assert!((step.stored_energy / (0.4 * 5.0 * step.shift.zeta) - 1.0).abs() < 0.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StepSummary {
    /// The number of the step, from 1.
    pub step: usize,
    /// The shift of the bodies.
    pub shift: Shift,
    /// The loads on body 1.
    pub load: ContactLoad,
    /// The greatest pressure.
    pub greatest_pressure: f64,
    /// Area of all cells in contact.
    pub contact_area: f64,
    /// Area of the cells that stick.
    pub stick_area: f64,
    /// Elastic energy of both bodies.
    pub stored_energy: f64,
    /// Friction heat since the start of the history.
    pub dissipated: f64,
    /// Part of the window that is in contact.
    pub contact_share: f64,
    /// Mean distance of the deformed surfaces over the window.
    pub mean_gap: f64,
    /// Number of connected patches of contact.
    pub patches: usize,
    /// Mean pressure over the window, over E* times the root-mean-square slope of the undeformed gap; zero if the bodies
    /// are no half-spaces.
    pub pressure_over_slope: f64,
    /// How far the elastic energy of the pressure may be above its least value for this force, by a fresh product.
    pub energy_gap: f64,
    /// How far the energy less the work of the approach may be above its least value for this approach; `None` on a
    /// periodic surface, a plate, with given influence numbers, and for materials that couple.
    pub energy_gap_by_approach: Option<f64>,
    /// Violations of the contact conditions.
    pub residuals: Residuals,
    /// The cost of the step.
    pub products: Products,
    /// Discretisation errors, if they were estimated.
    pub estimates: Option<Estimates>,
}

impl StepSummary {
    /// Number of values of a stored summary.
    pub const NUMBERS: usize = OWN + ERRORS;

    /// The summary of the next step, from the states before and after it.
    ///
    /// # Errors
    /// [`OperatorError`] unless both states are on the grid of the problem.
    pub fn next(
        &self,
        problem: &ContactProblem,
        [before, after]: [&ContactState; 2],
        convergence: &Convergence,
    ) -> Result<Self, OperatorError> {
        let area = after.pressure.grid().cell_area();
        let [stick, slip] =
            [CellState::Stick, CellState::Slip].map(|cell| after.count(cell) as f64);
        let surfaces = Surfaces::of(problem, after)?;
        let window = area * after.pressure.grid().cells() as f64;
        let load = after.load();
        Ok(Self {
            step: self.step + 1,
            shift: after.shift,
            load,
            greatest_pressure: after.peak_pressure(),
            contact_area: area * (stick + slip),
            stick_area: area * stick,
            stored_energy: surfaces.stored,
            dissipated: self.dissipated + heat(before, after),
            contact_share: area * (stick + slip) / window,
            mean_gap: surfaces.mean_gap,
            patches: surfaces.patches,
            pressure_over_slope: over_slope(problem, load.f_z / window),
            energy_gap: surfaces.energy_gap,
            energy_gap_by_approach: surfaces.energy_gap_by_approach,
            residuals: convergence.residuals,
            products: convergence.products,
            estimates: None,
        })
    }

    /// Converts the torque to the origin, for a grid whose centre lies at this point.
    #[must_use]
    pub fn with_middle_at(mut self, [x, y]: [f64; 2]) -> Self {
        self.load.m_z += y * self.load.f_x - x * self.load.f_y;
        self.estimates = self.estimates.map(|all| self.estimated(errors(&all)));
        self
    }

    /// Adds discretisation errors; the values beside them are those of the summary.
    #[must_use]
    pub fn with_estimates(mut self, estimates: Option<&Estimates>) -> Self {
        self.estimates = estimates.map(|all| self.estimated(errors(all)));
        self
    }

    fn estimated(&self, errors: [f64; ERRORS]) -> Estimates {
        let Self { shift, load, .. } = self;
        let with = |value, i: usize| Estimated { value, error: errors[i] };
        Estimates {
            zeta: with(shift.zeta, 0),
            xi: with(shift.xi, 1),
            eta: with(shift.eta, 2),
            omega: with(shift.omega, 3),
            f_x: with(load.f_x, 4),
            f_y: with(load.f_y, 5),
            f_z: with(load.f_z, 6),
            m_z: with(load.m_z, 7),
            peak: with(self.greatest_pressure, 8),
            contact_area: with(self.contact_area, 9),
            stick_area: with(self.stick_area, 10),
        }
    }

    fn error(&self, of: fn(&Estimates) -> &Estimated) -> Value {
        self.estimates.as_ref().map_or(Value::Undefined, |all| of(all).error.into())
    }

    /// All values for storage: those of [`StepSummary::COLUMNS`], then those of
    /// [`StepSummary::ERROR_COLUMNS`], which are NaN without estimates.
    #[must_use]
    pub fn numbers(&self) -> [f64; Self::NUMBERS] {
        let Self { shift, load, residuals, products, .. } = self;
        let own: [f64; OWN] = [
            self.step as f64,
            shift.zeta,
            shift.xi,
            shift.eta,
            shift.omega,
            load.f_x,
            load.f_y,
            load.f_z,
            load.m_z,
            self.greatest_pressure,
            self.contact_area,
            self.stick_area,
            self.stored_energy,
            self.dissipated,
            self.contact_share,
            self.mean_gap,
            self.patches as f64,
            self.pressure_over_slope,
            self.energy_gap,
            self.energy_gap_by_approach.unwrap_or(f64::NAN),
            residuals.normal,
            residuals.tangential,
            products.normal,
            products.tangential,
        ];
        let errors = self.estimates.as_ref().map_or([f64::NAN; ERRORS], errors);
        std::array::from_fn(|i| if i < OWN { own[i] } else { errors[i - OWN] })
    }

    /// Restores a summary from the values of [`StepSummary::numbers`].
    #[must_use]
    pub fn from_numbers(n: &[f64; Self::NUMBERS]) -> Self {
        let own = Self {
            step: n[0] as usize,
            shift: Shift { zeta: n[1], xi: n[2], eta: n[3], omega: n[4] },
            load: ContactLoad { f_x: n[5], f_y: n[6], f_z: n[7], m_z: n[8] },
            greatest_pressure: n[9],
            contact_area: n[10],
            stick_area: n[11],
            stored_energy: n[12],
            dissipated: n[13],
            contact_share: n[14],
            mean_gap: n[15],
            patches: n[16] as usize,
            pressure_over_slope: n[17],
            energy_gap: n[18],
            energy_gap_by_approach: Some(n[19]).filter(|gap| !gap.is_nan()),
            residuals: Residuals { normal: n[20], tangential: n[21] },
            products: Products { normal: n[22], tangential: n[23], ..Products::default() },
            estimates: None,
        };
        let errors: [f64; ERRORS] = std::array::from_fn(|i| n[OWN + i]);
        let estimates = (!errors[0].is_nan()).then(|| own.estimated(errors));
        Self { estimates, ..own }
    }

    /// Its columns.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::count("step", "", "number of the step, from 1", |s| (s.step as u64).into()),
        Column::new("zeta", "m", "approach", |step| step.shift.zeta.into()),
        Column::new("xi", "m", "shift of body 2 against body 1 along x", |s| s.shift.xi.into()),
        Column::new("eta", "m", "the same along y", |step| step.shift.eta.into()),
        Column::new("omega", "rad", "twist about the normal", |step| step.shift.omega.into()),
        Column::new("F_x", "N", "force on body 1 along x", |step| step.load.f_x.into()),
        Column::new("F_y", "N", "the same along y", |step| step.load.f_y.into()),
        Column::new("F_z", "N", "normal force", |step| step.load.f_z.into()),
        Column::new("M_z", "N m", "torque on body 1", |step| step.load.m_z.into()),
        Column::new(
            "peak_pressure",
            "Pa",
            "greatest pressure: the vertex of parabolas through the highest cell and its neighbours",
            |step| step.greatest_pressure.into(),
        ),
        Column::new("contact_area", "m2", "of all cells in contact", |s| s.contact_area.into()),
        Column::new("stick_area", "m2", "of those that stick", |step| step.stick_area.into()),
        Column::new("stored_energy", "J", "elastic energy of both bodies", |step| {
            step.stored_energy.into()
        }),
        Column::new("dissipated", "J", "friction heat since the start", |s| s.dissipated.into()),
        Column::new("contact_share", "", "part of the window in contact", |s| {
            s.contact_share.into()
        }),
        Column::new("mean_gap", "m", "mean distance of the surfaces over the window", |step| {
            step.mean_gap.into()
        }),
        Column::count("patches", "", "connected parts of the contact", |s| {
            Value::Count(s.patches as u64)
        }),
        Column::new(
            "pressure_over_slope",
            "",
            "mean pressure over the window, over E* times the rms slope of the gap; 0 if no half-spaces",
            |step| step.pressure_over_slope.into(),
        ),
        Column::new(
            "energy_gap",
            "J",
            "the pressure is proven to be this near to the least energy for its force",
            |step| step.energy_gap.into(),
        ),
        Column::new(
            "energy_gap_by_approach",
            "J",
            "the same for the energy less the work of the approach, for its approach; undefined if none is known",
            |step| step.energy_gap_by_approach.map_or(Value::Undefined, Into::into),
        ),
        Column::new("residual_normal", "", "what is left of the normal conditions", |step| {
            step.residuals.normal.into()
        }),
        Column::new("residual_tangential", "", "what is left of the friction law", |step| {
            step.residuals.tangential.into()
        }),
        Column::new("products_normal", "", "products with the normal influence", |step| {
            step.products.normal.into()
        }),
        Column::new("products_tangential", "", "the same with the tangential one", |step| {
            step.products.tangential.into()
        }),
    ];

    /// The columns of values and of errors.
    #[must_use]
    pub fn columns() -> Vec<Column<Self>> {
        [Self::COLUMNS, Self::ERROR_COLUMNS].concat()
    }

    /// The columns of the discretisation errors; undefined without estimates.
    pub const ERROR_COLUMNS: &'static [Column<Self>] = &[
        Column::new("zeta_error", "m", "estimated error of zeta by the mesh", |step| {
            step.error(|all| &all.zeta)
        }),
        Column::new("xi_error", "m", "the same of xi", |step| step.error(|all| &all.xi)),
        Column::new("eta_error", "m", "of eta", |step| step.error(|all| &all.eta)),
        Column::new("omega_error", "rad", "of omega", |step| step.error(|all| &all.omega)),
        Column::new("F_x_error", "N", "of F_x", |step| step.error(|all| &all.f_x)),
        Column::new("F_y_error", "N", "of F_y", |step| step.error(|all| &all.f_y)),
        Column::new("F_z_error", "N", "of F_z", |step| step.error(|all| &all.f_z)),
        Column::new("M_z_error", "N m", "of M_z", |step| step.error(|all| &all.m_z)),
        Column::new("peak_pressure_error", "Pa", "of peak_pressure", |step| {
            step.error(|all| &all.peak)
        }),
        Column::new("contact_area_error", "m2", "of contact_area, at most", |step| {
            step.error(|all| &all.contact_area)
        }),
        Column::new("stick_area_error", "m2", "of stick_area, at most", |step| {
            step.error(|all| &all.stick_area)
        }),
    ];
}

/// A mean pressure over E* times the slope of the gap.
fn over_slope(problem: &ContactProblem, pressure: f64) -> f64 {
    let slope = rms_slope(problem);
    match problem.operator().contact_modulus() {
        Some(modulus) if slope > 0.0 => pressure / (modulus * slope),
        _ => 0.0,
    }
}

/// Number of values without errors, and number of errors.
const OWN: usize = 24;
const ERRORS: usize = 11;

/// The errors in the order of the columns.
fn errors(all: &Estimates) -> [f64; ERRORS] {
    [
        all.zeta,
        all.xi,
        all.eta,
        all.omega,
        all.f_x,
        all.f_y,
        all.f_z,
        all.m_z,
        all.peak,
        all.contact_area,
        all.stick_area,
    ]
    .map(|one| one.error)
}
