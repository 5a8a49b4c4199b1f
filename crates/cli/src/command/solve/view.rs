//! The steps as records and columns.

use crate::columns::Record;
use carom_laws::law::{ContactLoad, Shift};
use carom_solver::{CellState, ContactState, Convergence};
use carom_table::Column;

/// The contact at the end of a step. SI units; loads act on body 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Step {
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
}

/// Numbers of a step.
pub(super) const NUMBERS: usize = 18;

impl Step {
    /// Of a state; energies are to be added.
    pub(super) fn of(number: usize, state: &ContactState, went: &Convergence) -> Self {
        let area = state.pressure.grid().cell_area();
        let [stick, slip] =
            [CellState::Stick, CellState::Slip].map(|cell| state.count(cell) as f64);
        Self {
            step: number as f64,
            shift: state.shift,
            load: state.load(),
            greatest_pressure: state.pressure.values().iter().copied().fold(0.0, f64::max),
            contact_area: area * (stick + slip),
            stick_area: area * stick,
            residual_normal: went.residuals.normal,
            residual_tangential: went.residuals.tangential,
            products_normal: went.products.normal,
            products_tangential: went.products.tangential,
            ..Self::default()
        }
    }

    /// All its numbers, to be kept.
    pub(super) fn numbers(&self) -> [f64; NUMBERS] {
        let Self { shift, load, .. } = self;
        [
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
        ]
    }

    /// The step of these numbers.
    pub(super) const fn from_numbers(n: &[f64; NUMBERS]) -> Self {
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
        }
    }
}

/// The columns of a solution.
pub(super) const COLUMNS: &[Column<Step>] = &[
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
];

/// Those of a table to read.
pub(super) fn readable() -> Vec<Column<Step>> {
    COLUMNS[..14].to_vec()
}

/// The steps as they stand in JSON.
pub(super) fn records(steps: &[Step]) -> Vec<Record<'_, Step>> {
    steps.iter().map(|step| Record::new(COLUMNS, step)).collect()
}
