//! Kalker's simplified theory on the cells of a grid, under any pressures.

use carom_halfspace::Grid;
use carom_solver::{CellState, ContactState};
use carom_special::RangeError;
use std::f64::consts::PI;

use super::{CreepCoefficients, Creepage, Way};

/// Springs of the particles of a contact that rolls along x: how far one moves per traction, for motions along, across and
/// by spin. [`crate::Fastsim`] has the same springs, and cells that fit the ellipse.
///
/// ```
/// use carom_halfspace::{Field, Grid};
/// use carom_rolling::{Creepage, Springs, Way};
/// use carom_solver::ContactState;
/// let grid = Grid::new(20, 1, 0.1, 1.0)?;
/// let way = Way::new(grid.dx())?;
/// let creepage = Creepage { along: 0.001, ..Creepage::default() };
/// let mut state = ContactState::apart(grid);
/// state.pressure = Field::uniform(grid, 1.0);
/// let heat = Springs::alike(0.01)?.roll(&way, creepage, |_| 0.3, &mut state)?;
/// // The traction grows by xi/L per length, from the leading edge on, and nothing slips.
/// assert!((state.traction_x.values()[0] - 0.2).abs() < 1e-12 && heat == 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Springs {
    flexibilities: [f64; 3],
}

impl Springs {
    /// With these three flexibilities, lengths per traction.
    ///
    /// # Errors
    /// [`RangeError`] unless they are positive and finite.
    pub fn new(flexibilities: [f64; 3]) -> Result<Self, RangeError> {
        flexibilities
            .iter()
            .try_for_each(|own| RangeError::positive("flexibility", *own).map(drop))?;
        Ok(Self { flexibilities })
    }

    /// With the same flexibility for all motions.
    ///
    /// # Errors
    /// As [`Springs::new`].
    pub fn alike(flexibility: f64) -> Result<Self, RangeError> {
        Self::new([flexibility; 3])
    }

    /// Those with which the forces of small creepages in an ellipse are Kalker's.
    ///
    /// # Errors
    /// [`RangeError`] unless semi-axes, modulus and coefficients are positive and finite.
    pub fn of_ellipse(
        [a, b]: [f64; 2],
        shear_modulus: f64,
        coefficients: &CreepCoefficients,
    ) -> Result<Self, RangeError> {
        for (field, value) in [("a", a), ("b", b), ("shear_modulus", shear_modulus)] {
            RangeError::positive(field, value)?;
        }
        let CreepCoefficients { c11, c22, c23, .. } = *coefficients;
        let [along, across] = [c11, c22].map(|c| 8.0 * a / (3.0 * shear_modulus * c));
        Self::new([along, across, PI * a * a / (4.0 * shear_modulus * libm::sqrt(a * b) * c23)])
    }

    /// The flexibilities for motions along, across and by spin.
    #[must_use]
    pub const fn flexibilities(&self) -> [f64; 3] {
        self.flexibilities
    }

    /// Steady rolling in steps of a cell along x, forwards or backwards, under the pressures of `state` and the friction of each row
    /// of cells: sets tractions and areas, and returns the friction heat per distance rolled.
    ///
    /// Each row begins at its leading edge without tractions. A step adds the creepage over the flexibility; what
    /// exceeds the friction limit slips.
    ///
    /// # Errors
    /// [`RangeError`] for a way that is not a cell along x, friction that is negative, and creepages that are not finite.
    pub fn roll(
        &self,
        way: &Way,
        creepage: Creepage,
        friction: impl Fn(usize) -> f64,
        state: &mut ContactState,
    ) -> Result<f64, RangeError> {
        creepage.check()?;
        let grid = state.pressure.grid();
        let ahead = way.ahead();
        let is_cell = (ahead.x.abs() - grid.dx()).abs() <= 1e-6 * grid.dx();
        let holds = is_cell && ahead.y.abs() <= 1e-6 * grid.dy();
        RangeError::check("rolling distance", way.length(), holds, "a cell along x")?;
        let mut slipped = 0.0;
        for row in 0..grid.ny() {
            let friction = RangeError::non_negative("friction", friction(row))?;
            let mut last = [0.0; 2];
            for place in 0..grid.nx() {
                let column = if ahead.x > 0.0 { grid.nx() - 1 - place } else { place };
                let step = self.step(way, creepage, grid, [column, row]);
                let limit = friction * state.pressure.values()[row * grid.nx() + column];
                let (cell, next) = grip(last, step, limit);
                let own = [0, 1].map(|i| self.flexibilities[i] * (last[i] + step[i] - next[i]));
                if cell == CellState::Slip {
                    slipped += own[0] * next[0] + own[1] * next[1];
                }
                set(state, row * grid.nx() + column, cell, next);
                last = next;
            }
        }
        Ok(grid.cell_area() * slipped / way.length())
    }

    /// The tractions that the rigid motion of a step adds to a particle that sticks.
    fn step(
        &self,
        way: &Way,
        creepage: Creepage,
        grid: Grid,
        [column, row]: [usize; 2],
    ) -> [f64; 2] {
        let ([along, across, spin], at) = (self.flexibilities, way.spin_offset());
        let (x, y) = (grid.centred_x(column) + at.x, grid.centred_y(row) + at.y);
        let Creepage { along: xi, across: eta, spin: phi } = creepage;
        let length = way.length();
        [length * (xi / along + y * phi / spin), length * (eta / across - x * phi / spin)]
    }
}

/// The traction of a particle after a step within its friction limit.
fn grip(last: [f64; 2], step: [f64; 2], limit: f64) -> (CellState, [f64; 2]) {
    let next = [last[0] + step[0], last[1] + step[1]];
    let size = libm::hypot(next[0], next[1]);
    match () {
        () if limit <= 0.0 => (CellState::Exterior, [0.0; 2]),
        () if size > limit => (CellState::Slip, next.map(|part| part * (limit / size))),
        () => (CellState::Stick, next),
    }
}

fn set(state: &mut ContactState, at: usize, cell: CellState, [x, y]: [f64; 2]) {
    state.traction_x.values_mut()[at] = x;
    state.traction_y.values_mut()[at] = y;
    state.cells.values_mut()[at] = cell;
}
