//! The state of a numerical contact between two steps of a load history.

use carom_halfspace::{Field, Grid};
use carom_laws::law::{ContactLoad, Shift};
use carom_special::RangeError;

/// What a cell does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum CellState {
    /// The surfaces are apart.
    #[default]
    Exterior,
    /// They touch and stick.
    Stick,
    /// They touch and slip.
    Slip,
}

/// Tractions that body 2 exerts on body 1, and what the next step must remember.
#[derive(Debug, PartialEq)]
pub struct ContactState {
    /// The rigid shift reached.
    pub shift: Shift,
    /// Pressure.
    pub pressure: Field,
    /// Tangential traction along x.
    pub traction_x: Field,
    /// Tangential traction along y.
    pub traction_y: Field,
    /// Elastic displacement u = u1 - u2, outside the contact too: a cell that enters the contact
    /// needs its last one.
    pub displacement_x: Field,
    /// Elastic displacement v = v1 - v2.
    pub displacement_y: Field,
    /// What each cell did in the last step.
    pub cells: Field<CellState>,
}

impl Clone for ContactState {
    fn clone(&self) -> Self {
        Self {
            shift: self.shift,
            pressure: self.pressure.clone(),
            traction_x: self.traction_x.clone(),
            traction_y: self.traction_y.clone(),
            displacement_x: self.displacement_x.clone(),
            displacement_y: self.displacement_y.clone(),
            cells: self.cells.clone(),
        }
    }

    // What is there already is used again.
    fn clone_from(&mut self, source: &Self) {
        self.shift = source.shift;
        self.pressure.clone_from(&source.pressure);
        self.traction_x.clone_from(&source.traction_x);
        self.traction_y.clone_from(&source.traction_y);
        self.displacement_x.clone_from(&source.displacement_x);
        self.displacement_y.clone_from(&source.displacement_y);
        self.cells.clone_from(&source.cells);
    }
}

impl ContactState {
    /// Bodies apart: no tractions.
    #[must_use]
    pub fn apart(grid: Grid) -> Self {
        let zero = || Field::uniform(grid, 0.0);
        Self {
            shift: Shift::default(),
            pressure: zero(),
            traction_x: zero(),
            traction_y: zero(),
            displacement_x: zero(),
            displacement_y: zero(),
            cells: Field::uniform(grid, CellState::Exterior),
        }
    }

    /// Ok if all fields are on this grid.
    ///
    /// # Errors
    /// [`RangeError`] that names the first one of another grid, with its number of cells.
    pub fn check_grid(&self, grid: Grid) -> Result<(), RangeError> {
        let fields = [
            ("pressure", self.pressure.grid()),
            ("traction x", self.traction_x.grid()),
            ("traction y", self.traction_y.grid()),
            ("displacement u", self.displacement_x.grid()),
            ("displacement v", self.displacement_y.grid()),
            ("cells", self.cells.grid()),
        ];
        for (name, own) in fields {
            RangeError::check(name, own.cells() as f64, own == grid, "on the grid of the problem")?;
        }
        Ok(())
    }

    /// The load: sums over the cells; `M_z` is the sum of y t_x - x t_y about the middle of the
    /// grid.
    #[must_use]
    pub fn load(&self) -> ContactLoad {
        let grid = self.pressure.grid();
        let tractions = self.traction_x.values().iter().zip(self.traction_y.values());
        let torque: f64 =
            grid.centres().zip(tractions).map(|((x, y), (t_x, t_y))| y * t_x - x * t_y).sum();
        ContactLoad {
            f_x: self.traction_x.integral(),
            f_y: self.traction_y.integral(),
            f_z: self.pressure.integral(),
            m_z: grid.cell_area() * torque,
        }
    }

    /// How many cells are in this state.
    #[must_use]
    pub fn count(&self, state: CellState) -> usize {
        self.cells.values().iter().filter(|cell| **cell == state).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_are_sums_and_a_positive_twist_has_a_positive_torque() {
        let grid = Grid::new(4, 3, 0.5, 0.25).unwrap();
        let mut state = ContactState::apart(grid);
        assert_eq!(state.load(), ContactLoad::default());
        assert_eq!(state.count(CellState::Exterior), 12);
        state.pressure.values_mut().fill(2.0);
        // u = y Omega, v = -x Omega: tractions of the same directions.
        state.traction_x = Field::from_function(grid, |_, y| y);
        state.traction_y = Field::from_function(grid, |x, _| -x);
        let load = state.load();
        assert_eq!(load.f_z, 2.0 * 12.0 * 0.125);
        assert!(load.m_z > 0.0 && load.f_x.abs() < 1e-15 && load.f_y.abs() < 1e-15);
        let other = Grid::new(3, 4, 0.5, 0.25).unwrap();
        assert_eq!(state.check_grid(other).unwrap_err().field, "pressure");
        assert!(state.check_grid(grid).is_ok());
    }
}
