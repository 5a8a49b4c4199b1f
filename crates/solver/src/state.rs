//! The state of a numerical contact between two steps of a load history.

use carom_halfspace::{Field, Grid};
use carom_laws::law::{ContactLoad, Shift};
use carom_special::RangeError;

/// The state of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum CellState {
    /// The surfaces are separated.
    #[default]
    Exterior,
    /// The surfaces are in contact and stick.
    Stick,
    /// The surfaces are in contact and slip.
    Slip,
}

/// Tractions that body 2 exerts on body 1, with the data that the next step needs.
#[derive(Debug, PartialEq)]
pub struct ContactState {
    /// The rigid shift at the end of the last step.
    pub shift: Shift,
    /// Pressure.
    pub pressure: Field,
    /// Tangential traction along x.
    pub traction_x: Field,
    /// Tangential traction along y.
    pub traction_y: Field,
    /// Elastic displacement u = u1 - u2, also outside the contact: a cell that comes into contact
    /// needs its previous displacement.
    pub displacement_x: Field,
    /// Elastic displacement v = v1 - v2.
    pub displacement_y: Field,
    /// State of each cell in the last step.
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

    // Reuses the memory that is already allocated.
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
    /// Separated bodies, without tractions.
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

    /// Checks that all fields are on this grid.
    ///
    /// # Errors
    /// [`RangeError`] that names the first field on another grid and gives its number of cells.
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

    /// The loads: sums over the cells. `M_z` is the sum of y t_x - x t_y about the centre of the
    /// grid, times the cell area.
    #[must_use]
    pub fn load(&self) -> ContactLoad {
        let (grid, f_z) = (self.pressure.grid(), self.pressure.integral());
        if self.has_pressure_alone() {
            return ContactLoad { f_z, ..ContactLoad::default() };
        }
        let tractions = self.traction_x.values().iter().zip(self.traction_y.values());
        let torque: f64 =
            grid.centres().zip(tractions).map(|((x, y), (t_x, t_y))| y * t_x - x * t_y).sum();
        ContactLoad {
            f_x: self.traction_x.integral(),
            f_y: self.traction_y.integral(),
            f_z,
            m_z: grid.cell_area() * torque,
        }
    }

    /// Whether there are no tangential tractions.
    pub(crate) fn has_pressure_alone(&self) -> bool {
        self.traction_x.is_zero() && self.traction_y.is_zero()
    }

    /// The number of cells in this state.
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
        assert!(state.check_grid(grid).is_ok());
        type Place = fn(&mut ContactState) -> &mut Field;
        let fields: [(&str, Place); 5] = [
            ("pressure", |state| &mut state.pressure),
            ("traction x", |state| &mut state.traction_x),
            ("traction y", |state| &mut state.traction_y),
            ("displacement u", |state| &mut state.displacement_x),
            ("displacement v", |state| &mut state.displacement_y),
        ];
        for (name, field) in fields {
            let mut state = state.clone();
            *field(&mut state) = Field::uniform(other, 0.0);
            assert_eq!(state.check_grid(grid).unwrap_err().field, name);
        }
        state.cells = Field::uniform(other, CellState::Exterior);
        assert_eq!(state.check_grid(grid).unwrap_err().field, "cells");
    }
}
