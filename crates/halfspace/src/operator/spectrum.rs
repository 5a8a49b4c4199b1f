//! The transform of one scalar kernel on the padded grid.

use std::f64::consts::TAU;

use carom_fourier::{Complex, Complex64};

use super::length::Sizes;
use super::plan::Plan;
use super::precision::Real;
use super::triangle::Triangle;
use super::workspace::{Lane, each};
use crate::Grid;

/// By this power of e the sum over points ahead fades along the torus.
const FADING: f64 = 4.0;

/// Symmetry of a kernel in one coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Parity {
    Even,
    Odd,
}

impl Parity {
    pub(crate) const fn odd_if(odd: bool) -> Self {
        if odd { Self::Odd } else { Self::Even }
    }

    const fn sign(self) -> f64 {
        match self {
            Self::Even => 1.0,
            Self::Odd => -1.0,
        }
    }
}

/// A transform, divided by the number of points, stored by columns.
///
/// A kernel with even or odd symmetry in both coordinates has a real or imaginary transform with
/// the same symmetry: half of the columns, with one real number per point, are stored. If it is even in both and the same
/// along both on a square grid, half of these are enough.
#[derive(Debug, Clone)]
pub(crate) enum Spectrum<T = f64> {
    Symmetric { values: Vec<T>, half: usize, imaginary: bool, row_parity: Parity },
    Square(Triangle<T>),
    General { values: Vec<Complex<T>>, length: usize },
}

impl Spectrum {
    /// From the values at offsets (source minus receiver) of `0..nx` by `0..ny`, row by row, and the parities.
    pub(crate) fn symmetric(
        plan: &Plan,
        fill: impl Fn(usize, &mut [f64]) + Sync,
        parity: [Parity; 2],
    ) -> Self {
        let [x, y] = parity;
        let mut lanes = vec![Lane::default(); plan.threads.count()];
        for lane in &mut lanes {
            lane.prepare(plan, 0);
        }
        let rows = symmetric_rows(plan, fill, x, &mut lanes);
        let imaginary = x != y;
        // As a function of receiver minus source the kernel is mirrored; the transform of an odd
        // sequence has a factor i, which gives -1 if both are odd.
        let sign = if (x, y) == (Parity::Even, Parity::Even) { 1.0 } else { -1.0 };
        let scale = sign / (plan.sizes.px as f64 * plan.sizes.py as f64);
        let half = plan.sizes.py / 2 + 1;
        let values = symmetric_columns(plan, &rows, y, scale, &mut lanes);
        Self::Symmetric { values, half, imaginary, row_parity: y }
    }

    /// The same with half of the memory, of a kernel that is the same along both axes, if it is even and the grid is square.
    pub(crate) fn folded(self, grid: Grid) -> Self {
        match self {
            Self::Symmetric { values, half, imaginary: false, row_parity: Parity::Even }
                if grid.nx() == grid.ny() && grid.dx() == grid.dy() =>
            {
                Self::Square(Triangle::of(half, &values))
            }
            other => other,
        }
    }

    /// From `kernel(columns, rows)` at any offset, source minus receiver.
    pub(crate) fn general(plan: &Plan, kernel: impl Fn(i32, i32) -> f64) -> Self {
        let (columns, py) = (plan.sizes.columns(), plan.sizes.py);
        let mut values = vec![Complex64::ZERO; columns * py];
        let mut lane = Lane::default();
        lane.prepare(plan, 0);
        let mut spectrum = vec![Complex64::ZERO; columns];
        let (nx, ny) = (plan.sizes.nx as i32, plan.sizes.ny as i32);
        for row in 1 - ny..ny {
            lane.row.fill(0.0);
            for column in 1 - nx..nx {
                let at = column.rem_euclid(plan.sizes.px as i32) as usize;
                lane.row[at] = kernel(-column, -row);
            }
            plan.row_forward(&mut lane, &mut spectrum);
            let at = row.rem_euclid(py as i32) as usize;
            for (column, value) in spectrum.iter().enumerate() {
                values[column * py + at] = *value;
            }
        }
        let scale = 1.0 / (plan.sizes.px as f64 * py as f64);
        for column in values.chunks_exact_mut(py) {
            plan.columns.forward.process_with_scratch(column, &mut lane.scratch);
            for value in column {
                *value *= scale;
            }
        }
        Self::General { values, length: py }
    }

    /// This spectrum of a torus times that of the sum over all points `cells` apart, from the
    /// present one on ahead, divided by `part`. The sum fades along the torus, so that its end does
    /// not count at its beginning.
    pub(crate) fn summed_ahead(&self, sizes: &Sizes, cells: [f64; 2], part: f64) -> Self {
        let (px, py) = (sizes.px as f64, sizes.py as f64);
        let share = (cells[0] / px).abs().max((cells[1] / py).abs());
        let fading = libm::exp(-FADING * share);
        let mut values = Vec::with_capacity(sizes.columns() * sizes.py);
        for column in 0..sizes.columns() {
            for row in 0..sizes.py {
                let wave = if 2 * row > sizes.py { row as f64 - py } else { row as f64 };
                let turn = TAU * (column as f64 * cells[0] / px + wave * cells[1] / py);
                let ahead = Complex64::new(libm::cos(turn), libm::sin(turn)) * fading;
                values.push(self.at(column, row) / ((1.0 - ahead) * part));
            }
        }
        Self::General { values, length: sizes.py }
    }

    /// The value at one point.
    fn at(&self, column: usize, row: usize) -> Complex64 {
        match self {
            Self::Symmetric { values, half, imaginary, row_parity } => {
                let (row, sign) = if row < *half {
                    (row, 1.0)
                } else {
                    (2 * (half - 1) - row, row_parity.sign())
                };
                let value = sign * values[column * half + row];
                if *imaginary { Complex64::new(0.0, value) } else { Complex64::new(value, 0.0) }
            }
            Self::Square(values) => {
                let row = if row < values.side() { row } else { 2 * (values.side() - 1) - row };
                Complex64::new(values.at(column, row), 0.0)
            }
            Self::General { values, length } => values[column * length + row],
        }
    }

    /// The sum over all waves of a kernel that is even: its value at the origin.
    pub(crate) fn sum(&self, sizes: &Sizes) -> f64 {
        // Waves that are not stored are images of stored ones; those at the ends are their own.
        let times =
            |index: usize, count: usize| if index == 0 || 2 * index == count { 1.0 } else { 2.0 };
        let column = |column: usize| {
            let rows = (0..=sizes.py / 2).map(|row| times(row, sizes.py) * self.at(column, row).re);
            times(column, sizes.px) * rows.sum::<f64>()
        };
        (0..sizes.columns()).map(column).sum()
    }

    /// The greatest value.
    pub(crate) fn greatest(&self) -> f64 {
        match self {
            Self::Symmetric { values, .. } => greatest(values),
            Self::Square(values) => greatest(values.stored()),
            Self::General { values, .. } => values.iter().fold(0.0, |most, z| most.max(z.norm())),
        }
    }

    /// The same in another precision, over a unit.
    pub(crate) fn over<T: Real>(&self, unit: f64) -> Spectrum<T> {
        let part = |value: f64| T::of(value / unit);
        match *self {
            Self::Symmetric { ref values, half, imaginary, row_parity } => {
                let values = values.iter().copied().map(part).collect();
                Spectrum::Symmetric { values, half, imaginary, row_parity }
            }
            Self::Square(ref values) => Spectrum::Square(values.map(part)),
            Self::General { ref values, length } => {
                let values = values.iter().map(|z| Complex::new(part(z.re), part(z.im))).collect();
                Spectrum::General { values, length }
            }
        }
    }
}

impl<T: Real> Spectrum<T> {
    /// `sum = sign * spectrum * values` in one column; added to `sum` unless `fresh`. `factors` has room for half of it.
    pub(crate) fn multiply(
        &self,
        (column, sign): (usize, T),
        values: &[Complex<T>],
        (sum, fresh): (&mut [Complex<T>], bool),
        factors: &mut [T],
    ) {
        match self {
            Self::Symmetric { values: all, half, imaginary, row_parity } => {
                let own = &all[column * half..][..*half];
                let mirror = sign * T::of(row_parity.sign());
                match (imaginary, fresh) {
                    (false, true) => mirrored(own, sign, mirror, values, sum, |f, z, _| z * f),
                    (false, false) => mirrored(own, sign, mirror, values, sum, |f, z, s| s + z * f),
                    (true, true) => mirrored(own, sign, mirror, values, sum, |f, z, _| turn(z, f)),
                    (true, false) => {
                        mirrored(own, sign, mirror, values, sum, |f, z, s| s + turn(z, f));
                    }
                }
            }
            Self::Square(all) => {
                let own = &mut factors[..all.side()];
                all.column(column, own);
                match fresh {
                    true => mirrored(own, sign, sign, values, sum, |f, z, _| z * f),
                    false => mirrored(own, sign, sign, values, sum, |f, z, s| s + z * f),
                }
            }
            Self::General { values: all, length } => {
                let own = &all[column * length..][..*length];
                for ((factor, value), sum) in own.iter().zip(values).zip(sum) {
                    let product = *factor * *value * sign;
                    *sum = if fresh { product } else { *sum + product };
                }
            }
        }
    }
}

fn greatest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// i f z.
fn turn<T: Real>(z: Complex<T>, f: T) -> Complex<T> {
    Complex::new(-f * z.im, f * z.re)
}

/// Traverses the stored half of a column and its mirror image.
#[inline(always)]
fn mirrored<T: Real>(
    own: &[T],
    sign: T,
    mirror: T,
    values: &[Complex<T>],
    sum: &mut [Complex<T>],
    combine: impl Fn(T, Complex<T>, Complex<T>) -> Complex<T>,
) {
    let (low, high) = values.split_at(own.len());
    let (low_sum, high_sum) = sum.split_at_mut(own.len());
    for ((factor, value), sum) in own.iter().zip(low).zip(low_sum) {
        *sum = combine(sign * *factor, *value, *sum);
    }
    let image = own[1..own.len() - 1].iter().rev();
    for ((factor, value), sum) in image.zip(high).zip(high_sum) {
        *sum = combine(mirror * *factor, *value, *sum);
    }
}

/// Transforms the rows and keeps their real (even) or imaginary (odd) parts.
fn symmetric_rows(
    plan: &Plan,
    fill: impl Fn(usize, &mut [f64]) + Sync,
    parity: Parity,
    lanes: &mut [Lane],
) -> Vec<f64> {
    let columns = plan.sizes.columns();
    let mut rows = vec![0.0; plan.sizes.ny * columns];
    let share = plan.sizes.ny.div_ceil(lanes.len());
    each(plan.threads, lanes, &mut rows, share * columns, |part, lane, share_rows| {
        let mut spectrum = std::mem::take(&mut lane.spectrum);
        for (row, result) in share_rows.chunks_exact_mut(columns).enumerate() {
            lane.row.fill(0.0);
            fill(part * share + row, &mut lane.row[..plan.sizes.nx]);
            if parity == Parity::Odd {
                lane.row[0] = 0.0;
            }
            for column in 1..plan.sizes.nx {
                lane.row[plan.sizes.px - column] = parity.sign() * lane.row[column];
            }
            plan.row_forward(lane, &mut spectrum[..columns]);
            for (value, transformed) in result.iter_mut().zip(&spectrum) {
                *value = match parity {
                    Parity::Even => transformed.re,
                    Parity::Odd => transformed.im,
                };
            }
        }
        lane.spectrum = spectrum;
    });
    rows
}

/// Transforms the columns, two real ones in each complex transform.
fn symmetric_columns(
    plan: &Plan,
    rows: &[f64],
    parity: Parity,
    scale: f64,
    lanes: &mut [Lane],
) -> Vec<f64> {
    let (columns, py, half) = (plan.sizes.columns(), plan.sizes.py, plan.sizes.py / 2 + 1);
    let mut values = vec![0.0; columns * half];
    let share = columns.div_ceil(lanes.len()).next_multiple_of(2 * f64::BLOCK);
    each(plan.threads, lanes, &mut values, share * half, |part, lane, results| {
        for (block, results) in results.chunks_mut(2 * f64::BLOCK * half).enumerate() {
            let first = part * share + block * 2 * f64::BLOCK;
            let width = results.len() / half;
            let pairs = width.div_ceil(2);
            let sum = &mut lane.sum[..pairs * py];
            sum.fill(Complex64::ZERO);
            for row in 0..plan.sizes.ny {
                let own = &rows[row * columns + first..][..width];
                for (pair, both) in own.chunks(2).enumerate() {
                    let z = Complex64::new(both[0], both.get(1).copied().unwrap_or(0.0));
                    if row == 0 {
                        sum[pair * py] = if parity == Parity::Odd { Complex64::ZERO } else { z };
                    } else {
                        sum[pair * py + row] = z;
                        sum[pair * py + py - row] = z * parity.sign();
                    }
                }
            }
            plan.columns.forward.process_with_scratch(sum, &mut lane.scratch);
            for (column, result) in results.chunks_exact_mut(half).enumerate() {
                let transformed = &sum[column / 2 * py..][..half];
                for (value, z) in result.iter_mut().zip(transformed) {
                    *value = scale
                        * match (parity, column % 2) {
                            (Parity::Even, 0) => z.re,
                            (Parity::Odd, 1) => -z.re,
                            _ => z.im,
                        };
                }
            }
        }
    });
    values
}
