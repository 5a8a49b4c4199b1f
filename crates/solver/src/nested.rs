//! Nested grids: the solution on a coarse grid is the start on a finer one.
//!
//! The cell centres of two grids do not coincide, so that all transfers interpolate.

use std::ops::Range;
use std::sync::Arc;

use carom_halfspace::Grid;
use carom_halfspace::operator::{OperatorError, SurfaceOperator, Threads};

use crate::parts;

/// Grids with fewer cells along a side than this are not made coarser.
const COARSEST: usize = 32;

/// The operator on successively coarser grids, finest first, as far as it can be built.
pub(crate) fn coarser_operators(
    finest: &dyn SurfaceOperator,
) -> Result<Vec<Arc<dyn SurfaceOperator>>, OperatorError> {
    let mut all: Vec<Arc<dyn SurfaceOperator>> = Vec::new();
    loop {
        let last = all.last().map_or(finest, |last| &**last);
        if last.grid().nx().min(last.grid().ny()) < COARSEST {
            return Ok(all);
        }
        let Some(coarser) = last.coarser() else { return Ok(all) };
        let coarser = coarser?;
        all.push(coarser.into());
    }
}

/// Bilinear interpolation between the cell centres of a grid; beyond them the values of the border
/// are continued.
struct Bilinear<'a> {
    grid: Grid,
    values: &'a [f64],
}

impl Bilinear<'_> {
    /// The value at the given columns and rows.
    fn at(&self, (column, right): (usize, f64), (row, upper): (usize, f64)) -> f64 {
        let next = [(column + 1).min(self.grid.nx() - 1), (row + 1).min(self.grid.ny() - 1)];
        let value = |i: usize, j: usize| self.values[self.grid.index(i, j)];
        let along = |j: usize| mix(value(column, j), value(next[0], j), right);
        mix(along(row), along(next[1]), upper)
    }
}

/// Positions of coordinates along an axis, as (cell, fraction).
fn places(at: impl Iterator<Item = f64>, width: f64, count: usize) -> Vec<(usize, f64)> {
    at.map(|at| position(at / width, count)).collect()
}

/// The cell whose centre lies at or before a position, and the fraction of the distance to the next
/// one. Positions are measured in cell widths from the centre of `count` cells.
fn position(widths: f64, count: usize) -> (usize, f64) {
    let last = (count - 1) as f64;
    let place = (widths + 0.5 * last).clamp(0.0, last);
    (place as usize, place - place.trunc())
}

fn mix(low: f64, high: f64, part: f64) -> f64 {
    // If `part` is 0, `high` may be infinite and must not make 0 times infinity.
    if part == 0.0 { low } else { low + part * (high - low) }
}

/// Values on cells twice as wide: the mean of four points in each.
pub(crate) fn coarser(fine: Grid, values: &[f64], coarse: Grid, threads: Threads) -> Vec<f64> {
    let values = Bilinear { grid: fine, values };
    let (dx, dy) = (0.5 * fine.dx(), 0.5 * fine.dy());
    let columns = [-dx, dx].map(|off| {
        places((0..coarse.nx()).map(|i| coarse.centred_x(i) + off), fine.dx(), fine.nx())
    });
    let rows = [-dy, dy].map(|off| {
        places((0..coarse.ny()).map(|j| coarse.centred_y(j) + off), fine.dy(), fine.ny())
    });
    let mut means = vec![0.0; coarse.cells()];
    let all = (0..means.len(), &mut means[..]);
    parts::each(threads, all, &|(cells, means): (Range<usize>, &mut [f64])| {
        for (cell, mean) in cells.zip(means) {
            let (column, row) = (cell % coarse.nx(), cell / coarse.nx());
            let [left, right] = columns.each_ref().map(|places| places[column]);
            let [low, high] = rows.each_ref().map(|places| places[row]);
            let corners = [(left, low), (right, low), (left, high), (right, high)];
            *mean = 0.25 * corners.iter().map(|(x, y)| values.at(*x, *y)).sum::<f64>();
        }
    });
    means
}

/// Interpolation from coarse to fine cell centres.
pub(crate) struct Passage {
    coarse: Grid,
    columns: Vec<(usize, f64)>,
    rows: Vec<(usize, f64)>,
}

impl Passage {
    pub(crate) fn new(coarse: Grid, fine: Grid) -> Self {
        let columns = places((0..fine.nx()).map(|i| fine.centred_x(i)), coarse.dx(), coarse.nx());
        let rows = places((0..fine.ny()).map(|j| fine.centred_y(j)), coarse.dy(), coarse.ny());
        Self { coarse, columns, rows }
    }

    /// The coarse values interpolated at a fine cell.
    pub(crate) fn at(&self, values: &[f64], cell: usize) -> f64 {
        let (column, row) = (cell % self.columns.len(), cell / self.columns.len());
        Bilinear { grid: self.coarse, values }.at(self.columns[column], self.rows[row])
    }
}

/// Extends values to unknown cells as the mean of their known neighbours, one ring of cells after
/// another.
pub(crate) fn extended(grid: Grid, values: &mut [f64], known: &[bool], rings: usize) {
    let mut known = known.to_vec();
    for _ in 0..rings {
        let before = known.clone();
        for row in 0..grid.ny() {
            for column in 0..grid.nx() {
                let cell = grid.index(column, row);
                if before[cell] {
                    continue;
                }
                let (mut sum, mut count) = (0.0, 0.0);
                for j in row.saturating_sub(1)..(row + 2).min(grid.ny()) {
                    for i in column.saturating_sub(1)..(column + 2).min(grid.nx()) {
                        let near = grid.index(i, j);
                        if before[near] {
                            sum += values[near];
                            count += 1.0;
                        }
                    }
                }
                if count > 0.0 {
                    (values[cell], known[cell]) = (sum / count, true);
                }
            }
        }
    }
}

/// Interpolates a pressure on finer cells without pressure. The square of the pressure falls linearly
/// towards the edge of a smooth contact; it is extrapolated beyond the edge and interpolated, so that
/// the edge keeps its position.
pub(crate) fn refine_pressure(coarse: Grid, pressure: &[f64], fine: Grid, finer: &mut [f64]) {
    let squares = continued(coarse, pressure);
    let (squares, passage) =
        (Bilinear { grid: coarse, values: &squares }, Passage::new(coarse, fine));
    for (row, cells) in passage.rows.iter().zip(finer.chunks_exact_mut(fine.nx())) {
        for (column, pressure) in passage.columns.iter().zip(cells) {
            let square = squares.at(*column, *row);
            if square > 0.0 {
                *pressure = square.sqrt();
            }
        }
    }
}

/// The squares of a pressure; outside the contact the mean of their linear extrapolations.
fn continued(grid: Grid, pressure: &[f64]) -> Vec<f64> {
    let square = |i: usize, j: usize| {
        let p = pressure[grid.index(i, j)];
        p * p
    };
    let mut squares: Vec<f64> = pressure.iter().map(|p| p * p).collect();
    for row in 0..grid.ny() {
        for column in 0..grid.nx() {
            if pressure[grid.index(column, row)] > 0.0 {
                continue;
            }
            let (mut sum, mut count) = (0.0, 0.0);
            for (i, j) in [(1, 0), (-1, 0), (0, 1), (0, -1)] {
                let at = |steps: isize| {
                    let x = column.checked_add_signed(steps * i).filter(|x| *x < grid.nx())?;
                    let y = row.checked_add_signed(steps * j).filter(|y| *y < grid.ny())?;
                    Some(square(x, y))
                };
                if let (Some(near), Some(far)) = (at(1), at(2))
                    && near > 0.0
                {
                    sum += (2.0 * near - far).min(0.0);
                    count += 1.0;
                }
            }
            if count > 0.0 {
                squares[grid.index(column, row)] = sum / count;
            }
        }
    }
    squares
}

#[cfg(test)]
mod tests {
    use super::*;

    fn coarse_of(fine: Grid) -> Grid {
        fine.coarser().unwrap()
    }

    #[test]
    fn planes_and_saddles_pass_to_coarse_cells_of_even_and_odd_grids() {
        // The last has more coarse cells than one part.
        for (nx, ny) in [(8, 6), (9, 7), (8, 7), (260, 180)] {
            let fine = Grid::new(nx, ny, 0.5, 0.25).unwrap();
            let saddle = |(x, y): (f64, f64)| 1.0 + 2.0 * x - 3.0 * y + 0.5 * x * y;
            let heights: Vec<f64> = fine.centres().map(saddle).collect();
            let coarse = coarse_of(fine);
            let got = coarser(fine, &heights, coarse, Threads::One);
            assert_eq!(coarser(fine, &heights, coarse, Threads::Pool), got);
            // Inside; at the border of odd grids the last cells reach beyond.
            let [inside_x, inside_y] = [0.25 * nx as f64 - 0.8, 0.125 * ny as f64 - 0.15];
            for ((x, y), got) in coarse.centres().zip(got) {
                if x.abs() < inside_x && y.abs() < inside_y {
                    let off = (got - saddle((x, y))).abs();
                    assert!(off < 1e-14 * nx as f64, "{nx} {ny}: {x} {y}");
                }
            }
        }
    }

    #[test]
    fn the_edge_of_a_round_pressure_keeps_its_place() {
        let fine = Grid::new(64, 64, 1.0 / 28.0, 1.0 / 28.0).unwrap();
        let coarse = coarse_of(fine);
        let round = |(x, y): (f64, f64)| (1.0 - x * x - y * y).max(0.0).sqrt();
        let pressure: Vec<f64> = coarse.centres().map(round).collect();
        let wrong = |pressure: &[f64]| {
            let both = fine.centres().zip(pressure);
            both.filter(|(at, p)| (**p > 0.0) != (round(*at) > 0.0)).count()
        };
        let mut got = vec![0.0; fine.cells()];
        refine_pressure(coarse, &pressure, fine, &mut got);
        let passage = Passage::new(coarse, fine);
        let plain: Vec<f64> = (0..fine.cells()).map(|cell| passage.at(&pressure, cell)).collect();
        assert!(5 * wrong(&got) < wrong(&plain), "{} {}", wrong(&got), wrong(&plain));
        let total: f64 = got.iter().sum::<f64>() * fine.cell_area();
        assert!((total / (2.0 / 3.0 * std::f64::consts::PI) - 1.0).abs() < 3e-3, "{total}");
    }
}
