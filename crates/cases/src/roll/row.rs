//! The rows and columns of a rolling contact.

use carom_laws::law::ContactLoad;
use carom_rolling::{CreepCoefficients, Creepage};
use carom_solver::{CellState, ContactState, Convergence};
use carom_table::Column;

/// A rolling contact under one creepage, or after one distance. SI units; loads act on body 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Distance rolled from rest; `None` in the steady state.
    pub distance: Option<f64>,
    /// Rolling speed.
    pub speed: f64,
    /// The creepages.
    pub creepage: Creepage,
    /// Loads on body 1.
    pub load: ContactLoad,
    /// f F_z.
    pub limit: f64,
    /// The greatest pressure.
    pub greatest_pressure: f64,
    /// Area of all cells in contact.
    pub contact_area: f64,
    /// Area of the cells that stick.
    pub stick_area: f64,
    /// Whether the whole contact slides.
    pub slides: bool,
    /// Forces along and across by FASTSIM.
    pub springs: Option<[f64; 2]>,
    /// Residuals and cost.
    pub convergence: Convergence,
}

impl Row {
    pub(super) fn of(
        state: &ContactState,
        convergence: Convergence,
        [speed, friction]: [f64; 2],
        creepage: Creepage,
    ) -> Self {
        let (area, load) = (state.pressure.grid().cell_area(), state.load());
        let [stick, slip] =
            [CellState::Stick, CellState::Slip].map(|cell| state.count(cell) as f64);
        Self {
            distance: None,
            speed,
            creepage,
            load,
            limit: friction * load.f_z,
            greatest_pressure: state.pressure.values().iter().copied().fold(0.0, f64::max),
            contact_area: area * (stick + slip),
            stick_area: area * stick,
            slides: stick == 0.0 && slip > 0.0,
            springs: None,
            convergence,
        }
    }

    /// Power of the loads on the creepage; in the steady state all of it is heat.
    fn power(&self) -> f64 {
        let Creepage { along, across, spin } = self.creepage;
        let ContactLoad { f_x, f_y, m_z, .. } = self.load;
        self.speed * (f_x * along + f_y * across + m_z * spin)
    }

    fn spring(&self, axis: usize) -> Option<f64> {
        self.springs.map(|forces| forces[axis])
    }
}

/// All columns.
pub const COLUMNS: &[Column<Row>] = &[
    Column::new("distance", "m", "rolled from rest, if the case gives one", |row| {
        row.distance.into()
    }),
    Column::new("time", "s", "since rest", |row| row.distance.map(|way| way / row.speed).into()),
    Column::new("creepage", "", "along x", |row| row.creepage.along.into()),
    Column::new("creepage_across", "", "along y", |row| row.creepage.across.into()),
    Column::new("spin", "rad/m", "about the normal", |row| row.creepage.spin.into()),
    Column::new("F_x", "N", "force on body 1 along x", |row| row.load.f_x.into()),
    Column::new("F_y", "N", "force on body 1 along y", |row| row.load.f_y.into()),
    Column::new("F_z", "N", "normal force", |row| row.load.f_z.into()),
    Column::new("M_z", "N m", "torque on body 1", |row| row.load.m_z.into()),
    Column::new("used", "", "tangential force over f F_z", |row| {
        (libm::hypot(row.load.f_x, row.load.f_y) / row.limit).into()
    }),
    Column::new(
        "power",
        "W",
        "work rate of the loads on the creepage; heat in the steady state",
        |row| row.power().into(),
    ),
    Column::new("p_max", "Pa", "maximum pressure", |row| row.greatest_pressure.into()),
    Column::new("contact_area", "m2", "of all cells in contact", |row| row.contact_area.into()),
    Column::new("stick_area", "m2", "of all cells that stick", |row| row.stick_area.into()),
    Column::new(
        "slides",
        "",
        "whether the whole contact slides: the creep force is saturated",
        |row| {
            if row.slides { "yes".into() } else { "no".into() }
        },
    ),
    Column::new("F_x_springs", "N", "F_x of FASTSIM, with --fastsim", |row| row.spring(0).into()),
    Column::new("F_y_springs", "N", "F_y of FASTSIM, with --fastsim", |row| row.spring(1).into()),
    Column::new("residual_normal", "", "residual of the contact conditions", |row| {
        row.convergence.residuals.normal.into()
    }),
    Column::new("residual_tangential", "", "residual of the friction law", |row| {
        row.convergence.residuals.tangential.into()
    }),
    Column::new("iterations", "", "linear systems or passes", |row| {
        (row.convergence.iterations as u64).into()
    }),
];

/// Creep coefficients of the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Creep {
    /// Kalker's coefficients.
    pub coefficients: CreepCoefficients,
    /// Axis ratio a/b, a along the direction of rolling.
    pub ratio: f64,
    /// Combined modulus, as that of each of two equal bodies.
    pub shear_modulus: f64,
    /// Poisson's ratio of each of them.
    pub poisson: f64,
}

/// The columns of `--coefficients`.
pub const CREEP: &[Column<Creep>] = &[
    Column::new("axis_ratio", "", "a/b, a along the direction of rolling", |c| c.ratio.into()),
    Column::new("G", "Pa", "shear modulus of each of two equal bodies", |c| c.shear_modulus.into()),
    Column::new("nu", "", "Poisson's ratio of each of them", |c| c.poisson.into()),
    Column::new("C11", "", "F_x = G a b C11 creepage", |c| c.coefficients.c11.into()),
    Column::new("C22", "", "F_y = G a b C22 creepage_across", |c| c.coefficients.c22.into()),
    Column::new("C23", "", "F_y = -G (ab)^1.5 C23 spin", |c| c.coefficients.c23.into()),
    Column::new("C32", "", "M_z = G (ab)^1.5 C32 creepage_across", |c| c.coefficients.c32.into()),
    Column::new("C33", "", "M_z = G (ab)^2 C33 spin", |c| c.coefficients.c33.into()),
];
