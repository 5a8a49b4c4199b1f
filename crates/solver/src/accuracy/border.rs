//! The error of a load by the cells at the border of the contact.
//!
//! Such a cell touches as a whole or not at all, so that a load is uncertain by a part of what these cells carry: with B
//! this part and L the whole load, by L (B/L)^(4/3), which falls as the area of a cell under a smooth indenter. The
//! differences between nested grids tell another part of the story: they may vanish by chance, or be large because hardly
//! a cell touches on the coarsest grid. The geometric mean of both follows the true error more closely than each of
//! them. The factors are those that covered 95 % of the errors of 200 drawn histories against grids four times finer,
//! with 36 to 470 cells in contact; among 45 others with six times as many cells they covered 97 %.
//!
//! Where the border runs along a row of cells, as in the contact of a cylinder, all its cells touch too early or too late
//! together, and the difference of two grids may vanish by chance. An error is then at least a part of what they carry.

use super::estimate::Estimated;
use crate::state::ContactState;
use carom_halfspace::Grid;

/// Values that differ by less than this part are given, and met by the solution to its tolerance.
pub(super) const ROUND_OFF: f64 = 1e-7;
/// The part of the difference of both components that each of them has at least.
const PART_OF_BOTH: f64 = 1.0 / 3.0;
/// The part of the difference of the forces, times the radius, that a torque has at least.
const PART_OF_FORCES: f64 = 0.15;

/// How an error follows from the differences D1 of the two finest grids and D2 of the two coarsest ones,
/// and from the uncertain load B at the border: `factor sqrt((D1 + coarse D2) B)`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Share {
    coarse: f64,
    factor: f64,
}

/// Of the normal force and the approach.
pub(super) const NORMAL: Share = Share { coarse: 0.25, factor: 0.14 };
/// Of the tangential force and the shift.
pub(super) const TANGENTIAL: Share = Share { coarse: 0.5, factor: 0.092 };
/// Of the torque and the twist.
pub(super) const TORSIONAL: Share = Share { coarse: 0.5, factor: 0.078 };

/// The part of the load of a row of cells at a straight border by which a load is uncertain.
const PART_OF_STRAIGHT: f64 = 0.12;
/// A border is straight if it keeps to one row of cells along this part of the contact; that of a round contact leaves it
/// earlier.
const STRAIGHT: f64 = 0.9;

/// A load, and by how much it is uncertain.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Uncertain {
    /// By the cells at a curved border.
    pub(super) curved: f64,
    /// At least, by those at a straight one.
    pub(super) straight: f64,
}

impl std::ops::Mul<f64> for Uncertain {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self { curved: self.curved * factor, straight: self.straight * factor }
    }
}

/// The loads that are uncertain by the cells at the border of the contact.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Border {
    /// Of the force along the normal.
    pub(super) normal: Uncertain,
    /// Of the magnitudes of the tangential forces.
    pub(super) tangential: Uncertain,
}

/// L (B/L)^(4/3), where cells at the border carry B of the load L.
fn uncertain(whole: f64, at_border: f64) -> f64 {
    if at_border > 0.0 { at_border * libm::cbrt(at_border / whole) } else { 0.0 }
}

impl Border {
    /// Of a state. A cell at the border of the grid alone is none at the border of the contact.
    pub(super) fn of(state: &ContactState) -> Self {
        let grid = state.pressure.grid();
        let [p, x, y] = [&state.pressure, &state.traction_x, &state.traction_y].map(|f| f.values());
        let (mut whole, mut at_border) = ([0.0; 2], [0.0; 2]);
        for j in 0..grid.ny() {
            for i in 0..grid.nx() {
                let own = grid.index(i, j);
                let is_free = |i: usize, j: usize| {
                    i < grid.nx() && j < grid.ny() && p[grid.index(i, j)] == 0.0
                };
                let [left, below] = [i.wrapping_sub(1), j.wrapping_sub(1)];
                let ends =
                    is_free(left, j) || is_free(i + 1, j) || is_free(i, below) || is_free(i, j + 1);
                let loads = [p[own], x[own].hypot(y[own])];
                for k in 0..2 {
                    whole[k] += loads[k];
                    at_border[k] += if ends { loads[k] } else { 0.0 };
                }
            }
        }
        let straight = straight(grid, p, |cell| [p[cell], x[cell].hypot(y[cell])]);
        let of = |k: usize| {
            let curved = uncertain(whole[k], at_border[k]);
            Uncertain { curved, straight: PART_OF_STRAIGHT * straight[k] } * grid.cell_area()
        };
        Self { normal: of(0), tangential: of(1) }
    }
}

/// The loads of the rows of cells at straight borders, which are uncertain independently of each other: the root of the sum of
/// their squares.
fn straight(grid: Grid, p: &[f64], loads: impl Fn(usize) -> [f64; 2]) -> [f64; 2] {
    let mut squares = [0.0; 2];
    for axis in 0..2 {
        let (along, across) =
            if axis == 0 { (grid.nx(), grid.ny()) } else { (grid.ny(), grid.nx()) };
        let cell = |i: usize, j: usize| if axis == 0 { grid.index(i, j) } else { grid.index(j, i) };
        let touches = |i: usize, j: usize| p[cell(i, j)] > 0.0;
        let extent = (0..along).filter(|i| (0..across).any(|j| touches(*i, j))).count();
        for j in 0..across {
            for (beyond, inner) in [(j.wrapping_sub(1), j + 1), (j + 1, j.wrapping_sub(1))] {
                if beyond >= across {
                    continue;
                }
                // A row that touches by chance carries next to nothing, the one behind it does not.
                let behind = if inner < across { inner } else { j };
                let (mut sum, mut length) = ([0.0; 2], 0);
                for i in 0..=along {
                    if i < along && touches(i, j) && !touches(i, beyond) {
                        let [own, behind] = [loads(cell(i, j)), loads(cell(i, behind))];
                        let mean = |k: usize| sum[k] + 0.5 * (own[k] + behind[k]);
                        (sum, length) = ([mean(0), mean(1)], length + 1);
                        continue;
                    }
                    if length as f64 > STRAIGHT * extent as f64 {
                        squares = [squares[0] + sum[0] * sum[0], squares[1] + sum[1] * sum[1]];
                    }
                    (sum, length) = ([0.0; 2], 0);
                }
            }
        }
    }
    squares.map(f64::sqrt)
}

/// Whether three values are those of a prescribed load or shift.
pub(super) fn is_given(values: [f64; 3]) -> bool {
    let spread = (values[0] - values[1]).abs().max((values[1] - values[2]).abs());
    spread <= ROUND_OFF * values[0].abs()
}

impl Share {
    fn difference(self, values: [f64; 3]) -> f64 {
        (values[0] - values[1]).abs() + self.coarse * (values[1] - values[2]).abs()
    }

    /// A value on the finest of three grids, where the load `at_border` is uncertain.
    pub(super) fn estimated(self, values: [f64; 3], at_border: Uncertain) -> Estimated {
        self.with_least(values, at_border, 0.0)
    }

    /// A torque or a twist about the normal. One whose values agree by chance still has a part of the difference
    /// of the forces or shifts beside it, at this radius.
    pub(super) fn of_turned(
        self,
        values: [f64; 3],
        beside: [[f64; 3]; 2],
        radius: f64,
        at_border: f64,
    ) -> Estimated {
        let [x, y] = beside.map(|values| self.driven(values));
        let size = beside[0][0].hypot(beside[1][0]);
        let vanishes = values[0].abs() <= ROUND_OFF * size * radius;
        let least = if vanishes { 0.0 } else { PART_OF_FORCES * radius * x.hypot(y) };
        self.with_least(values, Uncertain { curved: at_border, straight: 0.0 }, least)
    }

    /// The difference of values that are not prescribed.
    fn driven(self, values: [f64; 3]) -> f64 {
        if is_given(values) { 0.0 } else { self.difference(values) }
    }

    fn with_least(self, values: [f64; 3], at_border: Uncertain, least: f64) -> Estimated {
        let smooth = Estimated::of(values);
        if is_given(values) || at_border.curved == 0.0 {
            return smooth;
        }
        let difference = self.difference(values).max(least);
        let of_second_order = (values[0] - values[1]).abs() / 3.0;
        let curved = self.factor * (difference * at_border.curved).sqrt();
        let error = of_second_order.max(curved).max(at_border.straight);
        Estimated { error, ..smooth }
    }

    /// Both components of a force or a shift. One whose values agree by chance still has a part of the
    /// difference of the other; one that symmetry makes zero has none.
    pub(super) fn of_both(self, components: [[f64; 3]; 2], at_border: Uncertain) -> [Estimated; 2] {
        let [x, y] =
            components.map(|values| if is_given(values) { 0.0 } else { self.difference(values) });
        let size = components[0][0].hypot(components[1][0]);
        components.map(|values| {
            let vanishes = values[0].abs() <= ROUND_OFF * size;
            let least = if vanishes { 0.0 } else { PART_OF_BOTH * x.hypot(y) };
            let part = if size > 0.0 { values[0].abs() / size } else { 0.0 };
            let straight = part * at_border.straight;
            self.with_least(values, Uncertain { straight, ..at_border }, least)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_halfspace::{Field, Grid};

    fn state(pressure: impl Fn(f64, f64) -> f64) -> ContactState {
        let mut state = ContactState::apart(Grid::new(6, 5, 2.0, 0.5).unwrap());
        state.pressure = Field::from_function(state.pressure.grid(), pressure);
        state.traction_x = state.pressure.map(|p| -0.3 * p);
        state.traction_y = state.pressure.map(|p| 0.4 * p);
        state
    }

    #[test]
    fn the_border_is_where_a_neighbour_is_free() {
        let block = |x: f64, y: f64| if x.abs() < 3.5 && y.abs() < 0.6 { 1.0 } else { 0.0 };
        let mut own = state(block);
        let count = own.pressure.values().iter().filter(|p| **p > 0.0).count();
        assert_eq!(count, 12);
        let border = Border::of(&own);
        // Two cells of twelve lie inside.
        let uncertain = 10.0 * (10.0 / 12.0_f64).cbrt();
        assert!((border.normal.curved - uncertain).abs() < 1e-12, "{border:?}");
        assert!((border.tangential.curved - 0.5 * uncertain).abs() < 1e-12, "{border:?}");
        own = state(|_, _| 1.0);
        assert_eq!(Border::of(&own), Border::default());
    }

    #[test]
    fn a_border_that_keeps_to_a_row_of_cells_is_straight() {
        // Columns of 5 cells of unit pressure: 3 of them, and 1.
        let ridge = state(|x, _| if x.abs() < 2.5 || x > 4.5 { 1.0 } else { 0.0 });
        let [of_ridge, of_friction] = [Border::of(&ridge).normal, Border::of(&ridge).tangential];
        // Both sides of a ridge, and one of a ridge at the border of the grid.
        let loads = 5.0 * 3.0_f64.sqrt() * PART_OF_STRAIGHT;
        assert!((of_ridge.straight - loads).abs() < 1e-12, "{of_ridge:?}");
        assert!((of_friction.straight - 0.5 * loads).abs() < 1e-12, "{of_friction:?}");
        let step = state(|x, y| if x < if y > 0.1 { 0.5 } else { 2.5 } { 1.0 } else { 0.0 });
        assert_eq!(Border::of(&step).normal.straight, 0.0);
    }

    #[test]
    fn prescribed_and_vanishing_values_have_no_error() {
        let at = |curved: f64| Uncertain { curved, straight: 0.0 };
        let given = TANGENTIAL.of_both([[1.0, 1.0 + 1e-9, 1.0], [0.1, 0.12, 0.2]], at(0.01));
        assert!(given[0].error < 1e-8 && given[1].error > 1e-3, "{given:?}");
        let zero = TANGENTIAL.of_both([[1.0, 1.1, 1.2], [1e-17, -1e-17, 0.0]], at(0.01));
        assert!(zero[1].error < 1e-8, "{zero:?}");
        let by_chance = TANGENTIAL.of_both([[1.0, 1.001, 1.004], [0.5, 0.500_001, 0.5]], at(0.1));
        assert!(by_chance[1].error > 0.4 * by_chance[0].error, "{by_chance:?}");
        // What is uncertain at a straight border counts by the direction of the force; a given one keeps none.
        let straight = Uncertain { curved: 1e-9, straight: 0.1 };
        let both = TANGENTIAL.of_both([[3.0, 3.1, 3.0], [4.0, 4.1, 4.0]], straight);
        assert!((both[0].error - 0.06).abs() < 1e-12 && (both[1].error - 0.08).abs() < 1e-12);
        assert_eq!(TANGENTIAL.of_both([[3.0; 3], [0.0; 3]], straight)[0].error, 0.0);
        let forces = [[1.0, 1.1, 1.3], [0.5, 0.5, 0.5]];
        let turned = |values| TORSIONAL.of_turned(values, forces, 2.0, 0.01).error;
        let by_chance = turned([0.3, 0.300_001, 0.3]);
        // As if it differed by .15 R times what the forces do.
        let of_forces = TORSIONAL.factor * (0.15 * 2.0 * (0.1 + 0.5 * 0.2) * 0.01_f64).sqrt();
        assert!((by_chance / of_forces - 1.0).abs() < 1e-12, "{by_chance} {of_forces}");
        assert!(turned([1e-17, -1e-17, 0.0]) < 1e-8 && turned([0.3; 3]) == 0.0);
    }
}
