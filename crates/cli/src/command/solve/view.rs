//! The steps as records and columns.

use crate::columns::Record;
use carom_laws::law::{ContactLoad, Shift};
use carom_solver::{CellState, ContactState, Convergence, Estimated, Estimates, Window};
use carom_table::{Column, Value};

/// The contact at the end of a step on a grid. SI units; loads act on body 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Step {
    pub(super) step: f64,
    pub(super) shift: Shift,
    pub(super) load: ContactLoad,
    pub(super) greatest_pressure: f64,
    pub(super) contact_area: f64,
    pub(super) stick_area: f64,
    pub(super) stored_energy: f64,
    /// Since the start.
    pub(super) dissipated: f64,
    pub(super) residual_normal: f64,
    pub(super) residual_tangential: f64,
    pub(super) products_normal: f64,
    pub(super) products_tangential: f64,
    /// Estimated errors by the mesh, not numbers where there are none: shifts, loads, greatest
    /// pressure, areas.
    pub(super) errors: [f64; ERRORS],
}

/// Numbers of a step.
pub(super) const NUMBERS: usize = 18 + ERRORS;
/// Those of them that are errors.
const ERRORS: usize = 11;

impl Step {
    /// Of a state; energies are to be added. Torques count about the origin.
    pub(super) fn of(
        number: usize,
        state: &ContactState,
        window: &Window,
        estimates: Option<&Estimates>,
        went: &Convergence,
    ) -> Self {
        let area = state.pressure.grid().cell_area();
        let [stick, slip] =
            [CellState::Stick, CellState::Slip].map(|cell| state.count(cell) as f64);
        let ([x, y], load) = (window.middle(), state.load());
        let m_z = load.m_z + y * load.f_x - x * load.f_y;
        let errors = estimates.map_or([f64::NAN; ERRORS], |all| {
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
        });
        Self {
            step: number as f64,
            shift: state.shift,
            load: ContactLoad { m_z, ..load },
            greatest_pressure: state.peak_pressure(),
            contact_area: area * (stick + slip),
            stick_area: area * stick,
            residual_normal: went.residuals.normal,
            residual_tangential: went.residuals.tangential,
            products_normal: went.products.normal,
            products_tangential: went.products.tangential,
            errors,
            ..Self::default()
        }
    }

    /// Its values with their errors; none where there are none.
    pub(super) fn estimates(&self) -> Option<Estimates> {
        let Self { shift, load, errors, .. } = self;
        let with = |value, i: usize| Estimated { value, error: errors[i] };
        (!errors[0].is_nan()).then(|| Estimates {
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
        })
    }

    fn error(&self, which: usize) -> Value {
        let error = self.errors[which];
        if error.is_nan() { Value::Undefined } else { error.into() }
    }

    /// All its numbers, to be kept.
    pub(super) fn numbers(&self) -> [f64; NUMBERS] {
        let Self { shift, load, .. } = self;
        let own = [
            self.step,
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
            self.residual_normal,
            self.residual_tangential,
            self.products_normal,
            self.products_tangential,
        ];
        let mut all = own.into_iter().chain(self.errors);
        std::array::from_fn(|_| all.next().unwrap_or(f64::NAN))
    }

    /// The step of these numbers.
    pub(super) fn from_numbers(n: &[f64; NUMBERS]) -> Self {
        Self {
            step: n[0],
            shift: Shift { zeta: n[1], xi: n[2], eta: n[3], omega: n[4] },
            load: ContactLoad { f_x: n[5], f_y: n[6], f_z: n[7], m_z: n[8] },
            greatest_pressure: n[9],
            contact_area: n[10],
            stick_area: n[11],
            stored_energy: n[12],
            dissipated: n[13],
            residual_normal: n[14],
            residual_tangential: n[15],
            products_normal: n[16],
            products_tangential: n[17],
            errors: std::array::from_fn(|i| n[18 + i]),
        }
    }
}

/// The columns of a solution.
pub const COLUMNS: &[Column<Step>] = &[
    Column::new("step", "", "number of the step, from 1", |step| (step.step as u64).into()),
    Column::new("zeta", "m", "approach", |step| step.shift.zeta.into()),
    Column::new("xi", "m", "shift of body 2 against body 1 along x", |step| step.shift.xi.into()),
    Column::new("eta", "m", "the same along y", |step| step.shift.eta.into()),
    Column::new("omega", "rad", "twist about the normal", |step| step.shift.omega.into()),
    Column::new("F_x", "N", "force on body 1 along x", |step| step.load.f_x.into()),
    Column::new("F_y", "N", "the same along y", |step| step.load.f_y.into()),
    Column::new("F_z", "N", "normal force", |step| step.load.f_z.into()),
    Column::new("M_z", "N m", "torque on body 1", |step| step.load.m_z.into()),
    Column::new("p_max", "Pa", "greatest pressure", |step| step.greatest_pressure.into()),
    Column::new("contact_area", "m2", "of all cells in contact", |step| step.contact_area.into()),
    Column::new("stick_area", "m2", "of those that stick", |step| step.stick_area.into()),
    Column::new("stored_energy", "J", "elastic energy of both bodies", |step| {
        step.stored_energy.into()
    }),
    Column::new("dissipated", "J", "friction heat since the start", |step| step.dissipated.into()),
    Column::new("residual_normal", "", "what is left of the normal conditions", |step| {
        step.residual_normal.into()
    }),
    Column::new("residual_tangential", "", "what is left of the friction law", |step| {
        step.residual_tangential.into()
    }),
    Column::new("products_normal", "", "products with the normal influence", |step| {
        step.products_normal.into()
    }),
    Column::new("products_tangential", "", "the same with the tangential one", |step| {
        step.products_tangential.into()
    }),
    Column::new("zeta_error", "m", "estimated error of zeta by the mesh", |step| step.error(0)),
    Column::new("xi_error", "m", "the same of xi", |step| step.error(1)),
    Column::new("eta_error", "m", "of eta", |step| step.error(2)),
    Column::new("omega_error", "rad", "of omega", |step| step.error(3)),
    Column::new("F_x_error", "N", "of F_x", |step| step.error(4)),
    Column::new("F_y_error", "N", "of F_y", |step| step.error(5)),
    Column::new("F_z_error", "N", "of F_z", |step| step.error(6)),
    Column::new("M_z_error", "N m", "of M_z", |step| step.error(7)),
    Column::new("p_max_error", "Pa", "of p_max", |step| step.error(8)),
    Column::new("contact_area_error", "m2", "of contact_area, at most", |step| step.error(9)),
    Column::new("stick_area_error", "m2", "of stick_area, at most", |step| step.error(10)),
];

/// Those of a table to read.
pub(super) fn readable() -> Vec<Column<Step>> {
    COLUMNS[..14].to_vec()
}

/// The estimated errors of the last step, in a line to read.
pub(super) fn errors(steps: &[Step]) -> String {
    let Some(all) = steps.last().and_then(Step::estimates) else { return String::new() };
    let told = [
        ("zeta", all.zeta, "m"),
        ("xi", all.xi, "m"),
        ("eta", all.eta, "m"),
        ("omega", all.omega, "rad"),
        ("F_x", all.f_x, "N"),
        ("F_y", all.f_y, "N"),
        ("F_z", all.f_z, "N"),
        ("M_z", all.m_z, "N m"),
        ("p_max", all.peak, "Pa"),
        ("stick_area", all.stick_area, "m2"),
    ];
    let told = told.iter().filter(|(_, one, _)| one.error > 1e-12 * one.value.abs());
    let told: Vec<_> =
        told.map(|(name, one, unit)| format!("{name} {:.1e} {unit}", one.error)).collect();
    if told.is_empty() {
        return String::new();
    }
    format!("errors of the last step by the mesh, estimated: {}\n", told.join(", "))
}

/// The steps as they stand in JSON.
pub(super) fn records(steps: &[Step]) -> Vec<Record<'_, Step>> {
    steps.iter().map(|step| Record::new(COLUMNS, step)).collect()
}
