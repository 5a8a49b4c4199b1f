//! The inverse influence on a torus of the grid's size, with the coupling of normal and tangential
//! displacements.
//!
//! The influence of the torus is the mean of the influences at the offsets that are one on it,
//! weighted by how many pairs of cells have them (Chan's circulant). It is positive definite where
//! the operator is, and needs coefficients only.

use carom_fourier::{Complex64, ComplexPlan, Transformed as _};
use carom_halfspace::Grid;
use carom_halfspace::operator::SurfaceOperator;
use nalgebra::Matrix3;

/// Three values for each cell: along x, along y, normal.
pub(super) type Space = [Vec<f64>; 3];

/// A wave whose response is below this fraction of the greatest one has no inverse, such as the
/// mean on a periodic surface.
const NO_RESPONSE: f64 = 1e-12;

/// The working memory of a transform: a field, and what the transforms of its rows and columns need.
#[derive(Clone)]
struct TransformSpace {
    field: Vec<Complex64>,
    lines: Vec<Complex64>,
}

/// Tractions from displacements on a torus.
#[derive(Clone)]
pub(super) struct Torus {
    grid: Grid,
    /// Transforms along x and y.
    plans: [ComplexPlan<f64>; 2],
    /// The inverse of each wave, by columns of the grid, divided by the number of cells.
    waves: Vec<Matrix3<Complex64>>,
    /// The tractions on cells at each offset due to a unit displacement of one cell.
    answers: Vec<Matrix3<f64>>,
    /// Normal as real part and along x as imaginary part; along y.
    lanes: [Vec<Complex64>; 2],
    space: TransformSpace,
}

impl Torus {
    pub(super) fn new(operator: &dyn SurfaceOperator) -> Self {
        let grid = operator.grid();
        let plans = [grid.nx(), grid.ny()].map(f64::complex_plan);
        let zero = vec![Complex64::ZERO; grid.cells()];
        let both = plans.iter().flat_map(|plan| [&plan.forward, &plan.inverse]);
        let needs = both.map(|transform| transform.get_inplace_scratch_len());
        let lines = vec![Complex64::ZERO; needs.max().unwrap_or(0)];
        let mut own = Self {
            grid,
            plans,
            waves: vec![Matrix3::zeros(); grid.cells()],
            answers: vec![Matrix3::zeros(); grid.cells()],
            lanes: [zero.clone(), zero.clone()],
            space: TransformSpace { field: zero, lines },
        };
        own.transform_influence(operator);
        own.invert_waves();
        own.transform_answers();
        own
    }

    /// The influence of each wave.
    fn transform_influence(&mut self, operator: &dyn SurfaceOperator) {
        let (nx, ny) = (self.grid.nx() as i32, self.grid.ny() as i32);
        let mut influence = Vec::with_capacity(self.grid.cells());
        for row in 0..ny {
            for column in 0..nx {
                influence.push(mean_influence(operator, [column, row], [nx, ny]));
            }
        }
        for entry in 0..9 {
            for (value, matrix) in self.lanes[0].iter_mut().zip(&influence) {
                *value = matrix[entry].into();
            }
            transform(&self.plans, self.grid, &mut self.lanes[0], &mut self.space);
            for (wave, value) in self.waves.iter_mut().zip(&self.lanes[0]) {
                wave[entry] = *value;
            }
        }
    }

    /// Inverts the influence of each wave. A wave without response gets that of the nearest ones.
    fn invert_waves(&mut self) {
        let cells = self.waves.len() as f64;
        let greatest = self.waves.iter().map(size).fold(0.0, f64::max);
        let near = [1 % self.waves.len(), self.grid.ny() % self.waves.len()];
        let long = near.map(|at| size(&self.waves[at])).into_iter().fold(0.0, f64::max);
        let instead = if long > NO_RESPONSE * greatest { long } else { greatest };
        for wave in &mut self.waves {
            let inverse = (size(wave) > NO_RESPONSE * greatest).then(|| wave.try_inverse());
            let other = || Matrix3::from_diagonal_element(Complex64::from(1.0 / instead));
            *wave = inverse.flatten().unwrap_or_else(other).unscale(cells);
        }
    }

    fn transform_answers(&mut self) {
        for entry in 0..9 {
            for (value, wave) in self.lanes[0].iter_mut().zip(&self.waves) {
                *value = wave[entry];
            }
            transform_back(&self.plans, self.grid, &mut self.lanes[0], &mut self.space);
            for (answer, value) in self.answers.iter_mut().zip(&self.lanes[0]) {
                answer[entry] = value.re;
            }
        }
    }

    /// Column and row of a cell.
    pub(super) const fn place(&self, cell: usize) -> [usize; 2] {
        [cell % self.grid.nx(), cell / self.grid.nx()]
    }

    /// The tractions on the cell at one place due to a unit displacement of the cell at another alone.
    pub(super) fn answer(&self, at: [usize; 2], of: [usize; 2]) -> &Matrix3<f64> {
        let counts = [self.grid.nx(), self.grid.ny()];
        let [column, row] = [0, 1].map(|axis| {
            let ahead = if at[axis] < of[axis] { counts[axis] } else { 0 };
            at[axis] + ahead - of[axis]
        });
        &self.answers[self.grid.index(column, row)]
    }

    /// The tractions that cause these displacements on the torus.
    pub(super) fn invert(&mut self, displacement: &Space, traction: &mut Space) {
        let [x, y, z] = displacement;
        let [first, second] = &mut self.lanes;
        for (i, value) in first.iter_mut().enumerate() {
            *value = Complex64::new(z[i], x[i]);
            second[i] = y[i].into();
        }
        transform(&self.plans, self.grid, first, &mut self.space);
        transform(&self.plans, self.grid, second, &mut self.space);
        self.multiply();
        let [first, second] = &mut self.lanes;
        transform_back(&self.plans, self.grid, first, &mut self.space);
        transform_back(&self.plans, self.grid, second, &mut self.space);
        let [x, y, z] = traction;
        for (i, value) in first.iter().enumerate() {
            (x[i], y[i], z[i]) = (value.im, second[i].re, value.re);
        }
    }

    /// Multiplies each wave and its opposite, which hold two real fields in one lane.
    fn multiply(&mut self) {
        let [nx, ny] = [self.grid.nx(), self.grid.ny()];
        let [first, second] = &mut self.lanes;
        for column in 0..nx {
            for row in 0..ny {
                let at = column * ny + row;
                let opposite = (nx - column) % nx * ny + (ny - row) % ny;
                if opposite < at {
                    continue;
                }
                let (one, other) = (first[at], first[opposite].conj());
                let z = 0.5 * (one + other);
                let x = Complex64::new(0.0, -0.5) * (one - other);
                let [x, y, z] = product(&self.waves[at], [x, second[at], z]);
                let turned = Complex64::new(-x.im, x.re);
                (first[at], second[at]) = (z + turned, y);
                (first[opposite], second[opposite]) = ((z - turned).conj(), y.conj());
            }
        }
    }
}

fn product(wave: &Matrix3<Complex64>, [x, y, z]: [Complex64; 3]) -> [Complex64; 3] {
    [0, 1, 2].map(|row| wave[(row, 0)] * x + wave[(row, 1)] * y + wave[(row, 2)] * z)
}

/// The greatest entry.
fn size(wave: &Matrix3<Complex64>) -> f64 {
    wave.iter().map(|entry| entry.norm()).fold(0.0, f64::max)
}

/// The influence at an offset on the torus, receiver minus source.
fn mean_influence(
    operator: &dyn SurfaceOperator,
    offset: [i32; 2],
    counts: [i32; 2],
) -> Matrix3<f64> {
    let ends = |axis: usize| {
        let part = f64::from(offset[axis]) / f64::from(counts[axis]);
        [(offset[axis], 1.0 - part), (offset[axis] - counts[axis], part)]
    };
    let mut mean = Matrix3::zeros();
    for (columns, along) in ends(0) {
        for (rows, across) in ends(1) {
            if along * across > 0.0 {
                let own = operator.coefficients(-columns, -rows).rows;
                mean += Matrix3::from_fn(|i, l| own[i][l]) * (along * across);
            }
        }
    }
    mean
}

/// Transforms rows, then columns; the result is stored by columns.
fn transform(
    [along, across]: &[ComplexPlan<f64>; 2],
    grid: Grid,
    values: &mut Vec<Complex64>,
    TransformSpace { field, lines }: &mut TransformSpace,
) {
    along.forward.process_with_scratch(values, lines);
    transpose(values, field, grid.nx());
    across.forward.process_with_scratch(field, lines);
    std::mem::swap(values, field);
}

/// The converse of [`transform`].
fn transform_back(
    [along, across]: &[ComplexPlan<f64>; 2],
    grid: Grid,
    values: &mut Vec<Complex64>,
    TransformSpace { field, lines }: &mut TransformSpace,
) {
    across.inverse.process_with_scratch(values, lines);
    transpose(values, field, grid.ny());
    along.inverse.process_with_scratch(field, lines);
    std::mem::swap(values, field);
}

/// Writes the rows of a given length as columns.
fn transpose(values: &[Complex64], to: &mut [Complex64], length: usize) {
    let count = values.len() / length;
    for (row, values) in values.chunks_exact(length).enumerate() {
        for (column, value) in values.iter().enumerate() {
            to[column * count + row] = *value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_halfspace::operator::{
        DisplacementField, HalfSpaceOperator, PeriodicOperator, Threads, TractionField,
    };
    use carom_halfspace::{Material, MaterialPair};

    fn pair() -> MaterialPair {
        MaterialPair::new(Material::from_shear(2.0, 0.1).unwrap(), Material::RIGID).unwrap()
    }

    fn operator() -> PeriodicOperator {
        PeriodicOperator::new(pair(), Grid::new(10, 8, 0.3, 0.2).unwrap(), Threads::One).unwrap()
    }

    /// The displacements of all cells of a half-space due to a unit traction on one cell.
    fn displaced(operator: &HalfSpaceOperator, axis: usize, cell: usize) -> Space {
        let zero = || vec![0.0; operator.grid().cells()];
        let [mut load, mut moved]: [Space; 2] =
            [[zero(), zero(), zero()], [zero(), zero(), zero()]];
        load[axis][cell] = 1.0;
        let [u, v, w] = &mut moved;
        let tractions = TractionField::full(&load[0], &load[1], &load[2]);
        let displacements = DisplacementField::full(u, v, w);
        operator.apply(tractions, displacements, &mut operator.workspace()).unwrap();
        moved
    }

    /// The mean over all pairs of cells of a half-space whose offset is one on the torus, pair by pair.
    #[test]
    fn the_influence_of_the_torus_is_the_mean_over_pairs_of_cells() {
        let (nx, ny) = (5, 4);
        let operator =
            HalfSpaceOperator::new(pair(), Grid::new(nx, ny, 0.3, 0.2).unwrap()).unwrap();
        let mut mean = vec![Matrix3::zeros(); nx * ny];
        for (of, axis) in (0..nx * ny).flat_map(|of| [(of, 0), (of, 1), (of, 2)]) {
            let moved = displaced(&operator, axis, of);
            for at in 0..nx * ny {
                let column = (at % nx + nx - of % nx) % nx;
                let row = (at / nx + ny - of / nx) % ny;
                for (k, values) in moved.iter().enumerate() {
                    mean[row * nx + column][(k, axis)] += values[at] / (nx * ny) as f64;
                }
            }
        }
        let counts = [nx as i32, ny as i32];
        for (at, mean) in mean.iter().enumerate() {
            let offset = [at % nx, at / nx].map(|count| count as i32);
            let off = (mean_influence(&operator, offset, counts) - mean).norm();
            assert!(off < 1e-12 * mean.norm(), "{offset:?}: {off:e} of {mean}");
        }
    }

    /// On a periodic surface the inverse is exact, but for the mean.
    #[test]
    fn tractions_on_a_period_come_back_from_their_displacements() {
        let operator = operator();
        let cells = operator.grid().cells();
        let wave = |k: f64| (0..cells).map(move |i| (k * (i * i) as f64).sin());
        let load: Space = [0.3, 0.7, 1.1].map(|k| {
            let mean = wave(k).sum::<f64>() / cells as f64;
            wave(k).map(|value| value - mean).collect()
        });
        let zero = || vec![0.0; cells];
        let (mut moved, mut back): (Space, Space) =
            ([zero(), zero(), zero()], [zero(), zero(), zero()]);
        let [u, v, w] = &mut moved;
        let displacements = DisplacementField::full(u, v, w);
        let tractions = TractionField::full(&load[0], &load[1], &load[2]);
        operator.apply(tractions, displacements, &mut operator.workspace()).unwrap();
        Torus::new(&operator).invert(&moved, &mut back);
        for (back, load) in back.iter().flatten().zip(load.iter().flatten()) {
            assert!((back - load).abs() < 1e-10, "{back} {load}");
        }
    }

    #[test]
    fn answers_are_the_inverse_of_a_unit_displacement() {
        let mut torus = Torus::new(&operator());
        let zero = vec![0.0; torus.grid.cells()];
        let mut traction: Space = [zero.clone(), zero.clone(), zero.clone()];
        for (axis, of) in [(0, 13), (1, 0), (2, 69)] {
            let mut displacement: Space = [zero.clone(), zero.clone(), zero.clone()];
            displacement[axis][of] = 1.0;
            torus.invert(&displacement, &mut traction);
            for at in 0..zero.len() {
                let [own, place] = [of, at].map(|cell| torus.place(cell));
                for (k, values) in traction.iter().enumerate() {
                    let expected = torus.answer(place, own)[(k, axis)];
                    let scale = torus.answer(own, own)[(k, k)];
                    assert!((values[at] - expected).abs() < 1e-12 * scale);
                }
            }
        }
    }
}
