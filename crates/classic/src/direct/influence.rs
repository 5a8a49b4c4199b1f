//! The coefficients of every offset, stored so that the rows of the matrix are contiguous.

use carom_halfspace::Grid;
use carom_halfspace::operator::{OperatorError, SurfaceOperator};

/// The coefficients (4.14) at all offsets of a grid. By (4.23) they depend on the offset only, so
/// that a row of the whole matrix is a window of this table.
#[derive(Debug, Clone)]
pub(crate) struct Influence {
    grid: Grid,
    /// `[i][l]`, offsets `1 - nx..nx` by `1 - ny..ny`, columns fastest; empty if zero everywhere.
    blocks: [[Vec<f64>; 3]; 3],
}

impl Influence {
    /// The displacements minus those of the same tractions `shift` columns further along x: the
    /// change of displacement of a particle that comes from there, for steady tractions. Between
    /// two columns they are interpolated.
    ///
    /// # Errors
    /// [`OperatorError::NotInvariant`].
    pub(crate) fn rolled(
        operator: &dyn SurfaceOperator,
        shift: f64,
    ) -> Result<Self, OperatorError> {
        operator.check_invariant()?;
        let whole = shift.floor();
        let (columns, part) = (whole as i32, shift - whole);
        let at = |c: i32, r: i32| operator.coefficients(c, r).rows;
        Ok(Self::tabulate(operator.grid(), |c, r| {
            let (near, far) = (at(c - columns, r), at(c - columns - 1, r));
            let mut rows = at(c, r);
            for axis in 0..2 {
                for by in 0..3 {
                    let ahead = (1.0 - part) * near[axis][by] + part * far[axis][by];
                    rows[axis][by] -= ahead;
                }
            }
            rows
        }))
    }

    /// # Errors
    /// [`OperatorError::NotInvariant`].
    pub(crate) fn new(operator: &dyn SurfaceOperator) -> Result<Self, OperatorError> {
        operator.check_invariant()?;
        let rows_at = |columns, rows| operator.coefficients(columns, rows).rows;
        Ok(Self::tabulate(operator.grid(), rows_at))
    }

    fn tabulate(grid: Grid, rows_at: impl Fn(i32, i32) -> [[f64; 3]; 3]) -> Self {
        let (nx, ny) = (grid.nx() as i32, grid.ny() as i32);
        let mut blocks: [[Vec<f64>; 3]; 3] = Default::default();
        for rows in 1 - ny..ny {
            for columns in 1 - nx..nx {
                let value = rows_at(columns, rows);
                for (blocks, values) in blocks.iter_mut().zip(value) {
                    for (block, value) in blocks.iter_mut().zip(values) {
                        block.push(value);
                    }
                }
            }
        }
        for block in blocks.iter_mut().flatten() {
            if block.iter().all(|value| *value == 0.0) {
                *block = Vec::new();
            }
        }
        Self { grid, blocks }
    }

    pub(crate) const fn grid(&self) -> Grid {
        self.grid
    }

    /// Displacements of a cell due to unit tractions on itself, by component.
    pub(crate) fn own(&self) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.coefficient(axis, axis, 0, 0))
    }

    /// Displacement `of` of the cell `at` due to the traction `by` on the cell `from`.
    pub(crate) fn coefficient(&self, of: usize, by: usize, at: usize, from: usize) -> f64 {
        let block = &self.blocks[of][by];
        if block.is_empty() { 0.0 } else { block[self.place(at, from)] }
    }

    /// All nine coefficients of two cells.
    pub(crate) fn block(&self, at: usize, from: usize) -> [[f64; 3]; 3] {
        let place = self.place(at, from);
        let value = |of: usize, by: usize| self.blocks[of][by].get(place).copied().unwrap_or(0.0);
        [0, 1, 2].map(|of| [0, 1, 2].map(|by| value(of, by)))
    }

    fn place(&self, at: usize, from: usize) -> usize {
        let (nx, ny) = (self.grid.nx(), self.grid.ny());
        let columns = from % nx + nx - 1 - at % nx;
        let rows = from / nx + ny - 1 - at / nx;
        rows * (2 * nx - 1) + columns
    }

    /// Displacement `of` of one cell due to all tractions (4.13).
    pub(crate) fn displacement(&self, of: usize, at: usize, tractions: &[Vec<f64>; 3]) -> f64 {
        let mut sum = 0.0;
        for (block, traction) in self.blocks[of].iter().zip(tractions) {
            if !block.is_empty() {
                sum += self.sum(block, at, traction);
            }
        }
        sum
    }

    fn sum(&self, block: &[f64], at: usize, traction: &[f64]) -> f64 {
        let nx = self.grid.nx();
        let rows = traction.chunks_exact(nx);
        rows.enumerate()
            .map(|(row, traction)| {
                let start = self.place(at, row * nx);
                product(&block[start..start + nx], traction)
            })
            .sum()
    }

    /// All displacements due to all tractions.
    pub(crate) fn displacements(&self, tractions: &[Vec<f64>; 3], out: &mut [Vec<f64>; 3]) {
        for (of, out) in out.iter_mut().enumerate() {
            for (at, out) in out.iter_mut().enumerate() {
                *out = self.displacement(of, at, tractions);
            }
        }
    }

    /// Adds the displacements due to a traction on one cell.
    pub(crate) fn add(&self, from: usize, traction: [f64; 3], out: &mut [Vec<f64>; 3]) {
        for (of, out) in out.iter_mut().enumerate() {
            for (by, traction) in traction.iter().enumerate() {
                if *traction == 0.0 || self.blocks[of][by].is_empty() {
                    continue;
                }
                for (at, out) in out.iter_mut().enumerate() {
                    *out += self.coefficient(of, by, at, from) * traction;
                }
            }
        }
    }
}

/// The dot product with four independent sums, for instruction-level parallelism.
fn product(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (mut left, mut right) = (a.chunks_exact(4), b.chunks_exact(4));
    for (a, b) in (&mut left).zip(&mut right) {
        for ((sum, a), b) in sums.iter_mut().zip(a).zip(b) {
            *sum += a * b;
        }
    }
    let rest: f64 = left.remainder().iter().zip(right.remainder()).map(|(a, b)| a * b).sum();
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_halfspace::operator::{DisplacementField, HalfSpaceOperator, TractionField};
    use carom_halfspace::{Material, MaterialPair};

    #[test]
    fn sums_over_the_table_are_the_products_of_the_operator() {
        let grid = Grid::new(7, 5, 0.3, 0.2).unwrap();
        let [one, two] = [0.1, 0.45].map(|nu| Material::from_shear(1.0, nu).unwrap());
        let pair = MaterialPair::new(one, two).unwrap();
        let operator = HalfSpaceOperator::new(pair, grid).unwrap();
        let influence = Influence::new(&operator).unwrap();
        let wave = |phase: f64| (0..35).map(|i| (phase + 1.7 * f64::from(i)).sin()).collect();
        let tractions: [Vec<f64>; 3] = [0.0, 1.0, 2.0].map(wave);
        let mut found = [(); 3].map(|()| vec![0.0; 35]);
        influence.displacements(&tractions, &mut found);
        let mut want = [(); 3].map(|()| vec![0.0; 35]);
        let [u, v, w] = &mut want;
        let load = TractionField::full(&tractions[0], &tractions[1], &tractions[2]);
        let out = DisplacementField::full(u, v, w);
        operator.apply(load, out, &mut operator.workspace()).unwrap();
        let mut added = [(); 3].map(|()| vec![0.0; 35]);
        for from in 0..35 {
            let traction = tractions.each_ref().map(|values| values[from]);
            influence.add(from, traction, &mut added);
        }
        for axis in 0..3 {
            for i in 0..35 {
                assert!((found[axis][i] - want[axis][i]).abs() < 1e-14);
                assert!((added[axis][i] - want[axis][i]).abs() < 1e-14);
            }
        }
        assert_eq!(influence.block(3, 20)[2][0], influence.coefficient(2, 0, 3, 20));
    }
}
