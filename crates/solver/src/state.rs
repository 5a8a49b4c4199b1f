//! The state of a numerical contact between two steps of a load history.

use carom_laws::law::{ContactLoad, Shift};

use crate::problem::Problem;

/// Tractions that body 2 exerts on body 1, and what the next step must remember.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactState {
    /// The rigid shift reached.
    pub shift: Shift,
    /// Pressure of each cell.
    pub pressure: Vec<f64>,
    /// Tangential traction along x of each cell.
    pub traction_x: Vec<f64>,
    /// Tangential traction along y of each cell.
    pub traction_y: Vec<f64>,
    /// Elastic displacement u = u1 - u2 of every cell, outside the contact too: a cell that
    /// enters the contact needs its last one.
    pub displacement_x: Vec<f64>,
    /// Elastic displacement v = v1 - v2 of every cell.
    pub displacement_y: Vec<f64>,
}

impl ContactState {
    /// Bodies apart: no tractions.
    #[must_use]
    pub fn apart(problem: &Problem) -> Self {
        let zeros = vec![0.0; problem.gap.grid().cells()];
        Self {
            shift: Shift::default(),
            pressure: zeros.clone(),
            traction_x: zeros.clone(),
            traction_y: zeros.clone(),
            displacement_x: zeros.clone(),
            displacement_y: zeros,
        }
    }

    /// The load: sums over the cells; `M_z` is the sum of y t_x - x t_y.
    #[must_use]
    pub fn load(&self, problem: &Problem) -> ContactLoad {
        let grid = problem.gap.grid();
        let mut load = ContactLoad::default();
        for iy in 0..grid.ny() {
            for ix in 0..grid.nx() {
                let cell = grid.index(ix, iy);
                let (t_x, t_y) = (self.traction_x[cell], self.traction_y[cell]);
                load.f_x += t_x;
                load.f_y += t_y;
                load.f_z += self.pressure[cell];
                load.m_z += grid.centred_y(iy) * t_x - grid.centred_x(ix) * t_y;
            }
        }
        let area = grid.cell_area();
        ContactLoad {
            f_x: area * load.f_x,
            f_y: area * load.f_y,
            f_z: area * load.f_z,
            m_z: area * load.m_z,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::Gap;
    use carom_halfspace::{Grid, Material, MaterialPair};
    use carom_laws::curvature::RelativeCurvature;
    use carom_laws::friction::Friction;

    #[test]
    fn loads_are_sums_and_a_positive_twist_has_a_positive_torque() {
        let grid = Grid::new(4, 3, 0.5, 0.25).unwrap();
        let body = Material::from_shear(1.0, 0.3).unwrap();
        let curvature = RelativeCurvature::from_coefficients(1.0, 1.0).unwrap();
        let problem = Problem {
            gap: Gap::of_curvature(grid, &curvature),
            materials: MaterialPair::new(body, body).unwrap(),
            friction: Friction::NONE,
        };
        let mut state = ContactState::apart(&problem);
        assert_eq!(state.load(&problem), ContactLoad::default());
        state.pressure.fill(2.0);
        // u = y Omega, v = -x Omega: tractions of the same directions.
        for iy in 0..3 {
            for ix in 0..4 {
                let cell = grid.index(ix, iy);
                state.traction_x[cell] = grid.centred_y(iy);
                state.traction_y[cell] = -grid.centred_x(ix);
            }
        }
        let load = state.load(&problem);
        assert_eq!(load.f_z, 2.0 * 12.0 * 0.125);
        assert!(load.m_z > 0.0 && load.f_x.abs() < 1e-15 && load.f_y.abs() < 1e-15);
    }
}
