//! Interpolation between the entries of the table, in the logarithms of the coefficients: these are
//! smooth in the logarithm of the axis ratio, and their errors are relative errors of coefficients.

use super::nodes::{COLUMNS, ROWS, of_axis_ratio, of_poisson, points};

/// C11, C22, C23 and C33 at each Poisson's ratio of an axis ratio.
pub(super) type Row = [[f64; 4]; COLUMNS];

/// The polynomial through the logarithms of all entries.
pub(super) struct Interpolation {
    logs: [Row; ROWS],
    /// Places of the rows, and in a row those of its entries.
    places: ([f64; ROWS], [f64; COLUMNS]),
}

impl Interpolation {
    pub(super) fn new(values: &[Row; ROWS]) -> Self {
        let logs = values.map(|row| row.map(|entry| entry.map(libm::log)));
        Self { logs, places: (points(), points()) }
    }

    /// C11, C22, C23 and C33.
    pub(super) fn at(&self, axis_ratio: f64, poisson: f64) -> [f64; 4] {
        let by_row = shares(&self.places.0, of_axis_ratio(axis_ratio));
        let by_column = shares(&self.places.1, of_poisson(poisson));
        let mut sums = [0.0; 4];
        for (row, of_row) in self.logs.iter().zip(by_row) {
            for (entry, of_column) in row.iter().zip(by_column) {
                for (sum, log) in sums.iter_mut().zip(entry) {
                    *sum += of_row * of_column * log;
                }
            }
        }
        sums.map(libm::exp)
    }
}

/// The share of each point in the value at a place: Lagrange's polynomials in the barycentric form,
/// whose weights at Chebyshev's points alternate, half as large at the ends.
fn shares<const N: usize>(points: &[f64; N], place: f64) -> [f64; N] {
    if let Some(hit) = points.iter().position(|point| *point == place) {
        return std::array::from_fn(|i| if i == hit { 1.0 } else { 0.0 });
    }
    let parts: [f64; N] = std::array::from_fn(|i| {
        let size = if i == 0 || i == N - 1 { 0.5 } else { 1.0 };
        let weight = if i % 2 == 0 { size } else { -size };
        weight / (place - points[i])
    });
    let sum: f64 = parts.iter().sum();
    parts.map(|part| part / sum)
}
