//! The rows and columns of a rolling contact.

use carom_laws::creep::force::CreepForce;
use carom_laws::law::ContactLoad;
use carom_rolling::{Creepage, FastsimForces};
use carom_solver::{CellState, ContactProblem, ContactState, Convergence, Estimated, Estimates};
use carom_table::{Column, Value};

/// A rolling contact under one drive, or after one distance. SI units; loads act on body 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Distance rolled from rest; `None` in the steady state.
    pub distance: Option<f64>,
    /// Rolling speed.
    pub speed: f64,
    /// The creepages, given or found.
    pub creepage: Creepage,
    /// The approach.
    pub approach: f64,
    /// Loads on body 1; torque about the origin.
    pub load: ContactLoad,
    /// Friction heat per distance rolled in the steady state.
    pub heat: Option<f64>,
    /// f F_z: the friction limits of all cells added.
    pub limit: f64,
    /// The greatest pressure.
    pub greatest_pressure: f64,
    /// Area of all cells in contact.
    pub contact_area: f64,
    /// Area of the cells that stick.
    pub stick_area: f64,
    /// Whether the whole contact slides.
    pub slides: bool,
    /// Forces by FASTSIM.
    pub springs: Option<FastsimForces>,
    /// Forces by the table of creep forces.
    pub table: Option<CreepForce>,
    /// Residuals and cost.
    pub convergence: Convergence,
    /// Discretisation errors, if they were estimated; shifts stand for creepages.
    pub estimates: Option<Estimates>,
}

impl Row {
    pub(super) fn of(
        problem: &ContactProblem,
        state: &ContactState,
        convergence: Convergence,
        speed: f64,
        creepage: Creepage,
    ) -> Self {
        let (area, load) = (state.pressure.grid().cell_area(), state.load());
        let [stick, slip] =
            [CellState::Stick, CellState::Slip].map(|cell| state.count(cell) as f64);
        let pressures = state.pressure.values();
        let limits = pressures.iter().enumerate();
        let limit: f64 =
            limits.map(|(cell, p)| problem.friction().at(cell).motion().get() * p).sum();
        Self {
            distance: None,
            speed,
            creepage,
            approach: state.shift.zeta,
            load,
            heat: None,
            limit: area * limit,
            greatest_pressure: state.peak_pressure(),
            contact_area: area * (stick + slip),
            stick_area: area * stick,
            slides: stick == 0.0 && slip > 0.0,
            springs: None,
            table: None,
            convergence,
            estimates: None,
        }
    }

    /// The same contact with its torque about the origin, from which its window lies this far.
    pub(super) fn about(mut self, middle: [f64; 2]) -> Self {
        // The torque has the sign of y t_x - x t_y.
        self.load.m_z += middle[1] * self.load.f_x - middle[0] * self.load.f_y;
        self
    }

    /// Tangential force.
    pub(super) fn pull(&self) -> f64 {
        libm::hypot(self.load.f_x, self.load.f_y)
    }

    /// Power of the loads on the creepage.
    fn power(&self) -> f64 {
        let Creepage { along, across, spin } = self.creepage;
        let ContactLoad { f_x, f_y, m_z, .. } = self.load;
        self.speed * (f_x * along + f_y * across + m_z * spin)
    }

    /// The greatest estimated error of forces and creepages.
    fn greatest_error(&self) -> Option<f64> {
        let all = self.estimates.as_ref()?;
        let force = all.f_x.error.max(all.f_y.error) / self.limit;
        let creepage = all.xi.error.max(all.eta.error);
        let size = libm::hypot(self.creepage.along, self.creepage.across);
        // Given creepages have no error.
        Some(if creepage > 0.0 && size > 0.0 { force.max(creepage / size) } else { force })
    }

    fn error(&self, of: fn(&Estimates) -> &Estimated) -> Value {
        self.estimates.as_ref().map_or(Value::Absent, |all| of(all).error.into())
    }
}

/// All columns.
pub const COLUMNS: &[Column<Row>] = &[
    Column::new("distance", "m", "rolled from rest, if the case gives one", |row| {
        row.distance.into()
    }),
    Column::new("time", "s", "since rest", |row| row.distance.map(|way| way / row.speed).into()),
    Column::new("creepage", "", "along x, given or found", |row| row.creepage.along.into()),
    Column::new("creepage_across", "", "along y", |row| row.creepage.across.into()),
    Column::new("spin", "rad/m", "about the normal", |row| row.creepage.spin.into()),
    Column::new("zeta", "m", "approach", |row| row.approach.into()),
    Column::new("F_x", "N", "force on body 1 along x", |row| row.load.f_x.into()),
    Column::new("F_y", "N", "force on body 1 along y", |row| row.load.f_y.into()),
    Column::new("F_z", "N", "normal force", |row| row.load.f_z.into()),
    Column::new("M_z", "N m", "torque on body 1", |row| row.load.m_z.into()),
    Column::new("used", "", "tangential force over f F_z", |row| (row.pull() / row.limit).into()),
    Column::new("adhesion", "", "tangential force over F_z", |row| {
        (row.pull() / row.load.f_z).into()
    }),
    Column::new(
        "wear_number",
        "N",
        "friction heat per distance rolled, in the steady state",
        |row| row.heat.into(),
    ),
    Column::new("heating", "W", "friction heat per time, in the steady state", |row| {
        row.heat.map(|heat| row.speed * heat).into()
    }),
    Column::new(
        "power",
        "W",
        "work rate of the loads on the creepage; bodies of one material turn it into heat",
        |row| row.power().into(),
    ),
    Column::new(
        "peak_pressure",
        "Pa",
        "greatest pressure: the vertex of parabolas through the highest cell and its neighbours",
        |row| row.greatest_pressure.into(),
    ),
    Column::new("contact_area", "m2", "of all cells in contact", |row| row.contact_area.into()),
    Column::new("stick_area", "m2", "of all cells that stick", |row| row.stick_area.into()),
    Column::flag("slides", "", "whether the whole contact slides", |row| row.slides.into()),
    Column::new("F_x_springs", "N", "F_x of FASTSIM, with --fastsim", |row| {
        row.springs.map(|springs| springs.f_x).into()
    }),
    Column::new("F_y_springs", "N", "F_y of FASTSIM, with --fastsim", |row| {
        row.springs.map(|springs| springs.f_y).into()
    }),
    Column::new(
        "springs_error",
        "",
        "FASTSIM's tangential force minus that here, over f F_z",
        |row| {
            let off = |springs: FastsimForces| {
                libm::hypot(springs.f_x - row.load.f_x, springs.f_y - row.load.f_y) / row.limit
            };
            row.springs.map(off).into()
        },
    ),
    Column::new(
        "F_x_table",
        "N",
        "F_x of the table of creep forces, of a line Carter's, with --table",
        |row| row.table.map(|table| table.f_x).into(),
    ),
    Column::new("F_y_table", "N", "F_y of the table", |row| {
        row.table.map(|table| table.f_y).into()
    }),
    Column::new("M_z_table", "N m", "M_z of the table", |row| {
        row.table.map(|table| table.m_z).into()
    }),
    Column::new("table_error", "N", "how far each force of the table may be off", |row| {
        row.table.map(|table| table.error).into()
    }),
    Column::new("residual_normal", "", "residual of the contact conditions", |row| {
        row.convergence.residuals.normal.into()
    }),
    Column::new("residual_tangential", "", "residual of the friction law", |row| {
        row.convergence.residuals.tangential.into()
    }),
    Column::count("iterations", "", "linear systems or passes", |row| {
        (row.convergence.iterations as u64).into()
    }),
    Column::new(
        "error",
        "",
        "estimated by the mesh: the greatest of those of F_x and F_y over f F_z, and of the creepages over their size",
        |row| row.greatest_error().into(),
    ),
    Column::new("zeta_error", "m", "estimated error of zeta by the mesh", |row| {
        row.error(|all| &all.zeta)
    }),
    Column::new("creepage_error", "", "the same of creepage", |row| row.error(|all| &all.xi)),
    Column::new("creepage_across_error", "", "of creepage_across", |row| row.error(|all| &all.eta)),
    Column::new("spin_error", "rad/m", "of spin", |row| row.error(|all| &all.omega)),
    Column::new("F_x_error", "N", "of F_x", |row| row.error(|all| &all.f_x)),
    Column::new("F_y_error", "N", "of F_y", |row| row.error(|all| &all.f_y)),
    Column::new("F_z_error", "N", "of F_z", |row| row.error(|all| &all.f_z)),
    Column::new("M_z_error", "N m", "of M_z", |row| row.error(|all| &all.m_z)),
    Column::new("peak_pressure_error", "Pa", "of peak_pressure", |row| row.error(|all| &all.peak)),
    Column::new("contact_area_error", "m2", "of contact_area, at most", |row| {
        row.error(|all| &all.contact_area)
    }),
    Column::new("stick_area_error", "m2", "of stick_area, at most", |row| {
        row.error(|all| &all.stick_area)
    }),
];

#[cfg(test)]
mod tests {
    use super::*;
    use carom_solver::{Products, Residuals, Stop};

    fn row(f_x: f64, f_y: f64) -> Row {
        let (products, residuals) = (Products::default(), Residuals::default());
        Row {
            distance: None,
            speed: 1.0,
            creepage: Creepage { along: 1.6, across: -1.2, spin: 0.0 },
            approach: 0.0,
            load: ContactLoad { f_x, f_y, f_z: 9.0, m_z: 0.5 },
            heat: None,
            limit: 4.0,
            greatest_pressure: 0.0,
            contact_area: 0.0,
            stick_area: 0.0,
            slides: false,
            springs: None,
            table: None,
            convergence: Convergence { iterations: 0, products, residuals, stop: Stop::Converged },
            estimates: None,
        }
    }

    /// A force through the origin has no torque about it; a quarter turn of everything changes none.
    #[test]
    fn the_torque_about_the_origin_is_that_of_a_force_beside_it() {
        let torque = |[f_x, f_y]: [f64; 2], middle| row(f_x, f_y).about(middle).load.m_z;
        assert_eq!(torque([2.0, 4.0], [0.25, 0.5]), 0.5);
        assert_eq!(torque([2.0, 3.0], [0.25, 0.5]), 0.5 + 0.5 * 2.0 - 0.25 * 3.0);
        assert_eq!(torque([-3.0, 2.0], [-0.5, 0.25]), torque([2.0, 3.0], [0.25, 0.5]));
    }

    /// Forces over f F_z, creepages over their size of 2, whichever is greatest.
    #[test]
    fn the_error_of_a_row_is_the_greatest_of_forces_and_creepages() {
        let error = |[f_x, f_y, xi, eta]: [f64; 4]| {
            let of = |error| Estimated { value: 1.0, error };
            let [f_x, f_y, xi, eta] = [of(f_x), of(f_y), of(xi), of(eta)];
            let estimates = Some(Estimates { f_x, f_y, xi, eta, ..Estimates::default() });
            Row { estimates, ..row(1.0, 1.0) }.greatest_error().unwrap()
        };
        for (errors, greatest) in [
            ([0.5, 0.25, 0.125, 0.0], 0.125),
            ([0.25, 0.5, 0.125, 0.0], 0.125),
            ([0.25, 0.25, 0.5, 0.25], 0.25),
            ([0.25, 0.25, 0.25, 0.5], 0.25),
        ] {
            assert_eq!(error(errors), greatest, "{errors:?}");
        }
    }
}
