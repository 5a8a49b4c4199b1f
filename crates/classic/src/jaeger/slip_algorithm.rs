//! `SlipAlgorithm`: the directions of slip by the linearised friction law (12.20) to (12.24).

use super::program::Program;
use crate::direct::DirectError;
use crate::direct::dense::{self, Unknown};
use carom_solver::CellState;

impl Program<'_> {
    /// Solves the linearised law block by block. A block consists of whole rows of the mesh with at
    /// most as many slipping elements as the matrix has columns. The first block has a random
    /// number of rows, so that the borders of the blocks change. Returns the largest rotation, in
    /// radians.
    pub(super) fn correct_directions(&mut self) -> Result<f64, DirectError> {
        let rows = self.slipping_rows();
        let Some(most) = rows.len().checked_sub(1) else { return Ok(0.0) };
        let mut first = self.directions.one_of(most + 1);
        let mut largest = 0.0_f64;
        let mut block: Vec<usize> = Vec::new();
        let mut taken = 0;
        for row in &rows {
            let full = block.len() + row.len() > self.method.columns() || taken == first;
            if full && !block.is_empty() {
                largest = largest.max(self.turn(&block)?);
                block.clear();
                (taken, first) = (0, usize::MAX);
            }
            block.extend(row);
            taken += 1;
        }
        Ok(largest.max(self.turn(&block)?))
    }

    /// The slipping elements with friction, row by row.
    fn slipping_rows(&self) -> Vec<Vec<usize>> {
        let columns = self.influence.grid().nx();
        let mut rows: Vec<Vec<usize>> = Vec::new();
        let mut last = usize::MAX;
        for (cell, state) in self.outcome.cells.iter().enumerate() {
            let limit = self.demand.limit(cell, self.outcome.traction[2][cell]);
            if *state == CellState::Slip && limit > 0.0 {
                if cell / columns != last {
                    rows.push(Vec::new());
                    last = cell / columns;
                }
                if let Some(row) = rows.last_mut() {
                    row.push(cell);
                }
            }
        }
        rows
    }

    /// Rotates the stresses of a block; returns the largest rotation.
    fn turn(&mut self, block: &[usize]) -> Result<f64, DirectError> {
        let unknown = |&cell: &usize| {
            let [n_x, n_y] = self.directions.of(cell);
            let limit = self.demand.limit(cell, self.outcome.traction[2][cell]);
            let slip = self.demand.slip(cell, &self.outcome.displacement);
            let across = [-n_y, n_x, 0.0];
            // -E2 E1 - E3 of (12.22), over 1 + E1^2: slip opposes the stress.
            let own = (-(slip[0] * n_x + slip[1] * n_y)).max(0.0) / limit;
            let right = slip[0] * n_y - slip[1] * n_x;
            Unknown { cell, direction: across, test: across, own, right }
        };
        let unknowns: Vec<Unknown> = block.iter().map(unknown).collect();
        let amounts = dense::solve(&unknowns, |at, from| self.influence.block(at, from))?;
        let mut largest = 0.0_f64;
        for (&cell, amount) in block.iter().zip(amounts) {
            let limit = self.demand.limit(cell, self.outcome.traction[2][cell]);
            largest = largest.max((amount / limit).abs());
            let [n_x, n_y] = self.directions.of(cell);
            let turned = [limit * n_x - amount * n_y, limit * n_y + amount * n_x];
            let size = turned[0].hypot(turned[1]);
            let unit = turned.map(|part| part / size);
            let before = self.outcome.tangent(cell);
            self.directions.set(cell, unit);
            self.outcome.pull(cell, limit, unit);
            let now = self.outcome.tangent(cell);
            let added = [now[0] - before[0], now[1] - before[1], 0.0];
            self.influence.add(cell, added, &mut self.outcome.displacement);
        }
        Ok(largest)
    }
}

#[cfg(test)]
mod tests {
    use carom_drawn::{Congruential, Draw as _};
    use nalgebra::{DMatrix, DVector};

    /// Numbers from -1 to 1.
    fn numbers(count: usize, seed: u64) -> Vec<f64> {
        let mut draw = Congruential(seed);
        std::iter::repeat_with(|| draw.signed()).take(count).collect()
    }

    #[test]
    fn the_printed_matrix_is_ours_scaled_by_rows_and_columns() {
        let n = 7;
        let square = |seed| DMatrix::from_vec(n, n, numbers(n * n, seed));
        let (a, b, c) = (square(1), square(2), square(3));
        let (a11, a22, a12) = (&a + a.transpose(), &b + b.transpose(), &c + c.transpose());
        let a21 = a12.transpose();
        let [t1, t2, s1, s2] = [5, 6, 7, 8].map(|seed| DVector::from_vec(numbers(n, seed)));
        let diagonal =
            |of: &dyn Fn(usize) -> f64| DMatrix::from_diagonal(&DVector::from_fn(n, |i, _| of(i)));
        // (12.22)
        let e1 = diagonal(&|i| t2[i] / t1[i]);
        let e2 = diagonal(&|i| s2[i] / t1[i]);
        let e3 = diagonal(&|i| s1[i] / t1[i]);
        // (12.21)
        let printed = -&a21 * &e1 + &a22 + &e1 * &a11 * &e1 - &e1 * &a12 - &e2 * &e1 - &e3;
        let right = -&s2 + &e1 * &s1;
        let amount = printed.lu().solve(&right).unwrap();
        // Ours: unit tangents across the stress.
        let size = DVector::from_fn(n, |i, _| t1[i].hypot(t2[i]));
        let (p, q) = (diagonal(&|i| -t2[i] / size[i]), diagonal(&|i| t1[i] / size[i]));
        let slip = diagonal(&|i| -(s1[i] * t1[i] + s2[i] * t2[i]) / (size[i] * size[i]));
        let own = &p * &a11 * &p + &p * &a12 * &q + &q * &a21 * &p + &q * &a22 * &q + slip;
        let across = own.lu().solve(&(-(&p * &s1) - &q * &s2)).unwrap();
        for i in 0..n {
            let along_y = across[i] * t1[i] / size[i];
            assert!((along_y - amount[i]).abs() < 1e-11 * (1.0 + amount[i].abs()), "{i}");
        }
    }
}
