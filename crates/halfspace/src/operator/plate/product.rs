//! Products with a plate: rows to sines, columns to sines, eigenvalues, and back.

use super::sines::{SineBuffers, Sines};
use crate::Grid;
use crate::operator::precision::Real as _;
use crate::operator::workspace::each;
use crate::operator::{Threads, Workspace};

/// The sine transforms of a grid.
#[derive(Clone)]
pub(super) struct SinePlan {
    nx: usize,
    ny: usize,
    along_x: Sines,
    along_y: Sines,
    threads: Threads,
}

/// Buffers of a product with a plate.
#[derive(Debug, Clone, Default)]
pub(in crate::operator) struct SineSpace {
    /// Transformed rows, by row.
    rows: Vec<f64>,
    /// Transformed columns, by column.
    columns: Vec<f64>,
    lanes: Vec<SineLane>,
}

/// Working memory of one thread.
#[derive(Debug, Clone, Default)]
pub(in crate::operator) struct SineLane {
    x: SineBuffers,
    y: SineBuffers,
}

impl SinePlan {
    pub(super) fn new(grid: Grid, threads: Threads) -> Self {
        let (nx, ny) = (grid.nx(), grid.ny());
        Self { nx, ny, along_x: Sines::new(nx), along_y: Sines::new(ny), threads }
    }

    pub(super) const fn threads(&self) -> Threads {
        self.threads
    }

    /// Bytes of a workspace.
    pub(super) fn workspace(grid: Grid, threads: Threads) -> u128 {
        let lane = 8 * grid.nx().max(grid.ny()) * threads.count();
        8 * (2 * grid.cells() + lane) as u128
    }

    /// The sine transform of `input`, times the factors of the waves, transformed back. Factors are
    /// given column by column, as in `factors`, and seen through `by`.
    pub(super) fn product(
        &self,
        (factors, by): (&[f64], impl Fn(f64) -> f64 + Sync + Send),
        input: &[f64],
        output: &mut [f64],
        workspace: &mut Workspace,
    ) {
        let space = &mut workspace.sines;
        self.prepare(space);
        self.rows(input, space);
        self.columns((factors, by), space);
        self.rows_back(output, space);
    }

    fn prepare(&self, space: &mut SineSpace) {
        let cells = self.nx * self.ny;
        for buffer in [&mut space.rows, &mut space.columns] {
            if buffer.len() < cells {
                buffer.resize(cells, 0.0);
            }
        }
        let lanes = self.threads.count();
        if space.lanes.len() != lanes {
            space.lanes.resize(lanes, SineLane::default());
        }
        for lane in &mut space.lanes {
            self.along_x.prepare(&mut lane.x);
            self.along_y.prepare(&mut lane.y);
        }
    }

    fn rows(&self, input: &[f64], space: &mut SineSpace) {
        let (nx, cells) = (self.nx, self.nx * self.ny);
        let share = self.ny.div_ceil(space.lanes.len()) * nx;
        let rows = &mut space.rows[..cells];
        each(self.threads, &mut space.lanes, rows, share, |part, lane, rows| {
            let input = input[part * share..].chunks_exact(nx);
            for (row, values) in rows.chunks_exact_mut(nx).zip(input) {
                row.copy_from_slice(values);
                // NaN does not count as zero.
                if values.iter().any(|value| *value != 0.0) {
                    self.along_x.transform(row, &mut lane.x);
                }
            }
        });
    }

    fn columns(
        &self,
        (factors, by): (&[f64], impl Fn(f64) -> f64 + Sync + Send),
        space: &mut SineSpace,
    ) {
        let (nx, ny) = (self.nx, self.ny);
        let scale = 1.0 / (nx as f64 * ny as f64);
        let SineSpace { rows, columns, lanes } = space;
        let share = nx.div_ceil(lanes.len()).next_multiple_of(f64::BLOCK) * ny;
        let columns = &mut columns[..nx * ny];
        each(self.threads, lanes, columns, share, |part, lane, columns| {
            for (number, block) in columns.chunks_mut(f64::BLOCK * ny).enumerate() {
                let start = part * share + number * f64::BLOCK * ny;
                let (first, width) = (start / ny, block.len() / ny);
                for (row, values) in rows.chunks_exact(nx).take(ny).enumerate() {
                    for (column, value) in values[first..first + width].iter().enumerate() {
                        block[column * ny + row] = *value;
                    }
                }
                let factors = factors[start..].chunks_exact(ny);
                for (column, factors) in block.chunks_exact_mut(ny).zip(factors) {
                    self.along_y.transform(column, &mut lane.y);
                    for (value, factor) in column.iter_mut().zip(factors) {
                        *value *= scale * by(*factor);
                    }
                    self.along_y.undo(column, &mut lane.y);
                }
            }
        });
    }

    fn rows_back(&self, output: &mut [f64], space: &mut SineSpace) {
        let (nx, ny) = (self.nx, self.ny);
        let SineSpace { columns, lanes, .. } = space;
        let share = ny.div_ceil(lanes.len()).next_multiple_of(f64::BLOCK) * nx;
        each(self.threads, lanes, output, share, |part, lane, rows| {
            for (number, block) in rows.chunks_mut(f64::BLOCK * nx).enumerate() {
                let first = (part * share + number * f64::BLOCK * nx) / nx;
                let height = block.len() / nx;
                for (column, values) in columns.chunks_exact(ny).take(nx).enumerate() {
                    for (row, value) in values[first..first + height].iter().enumerate() {
                        block[row * nx + column] = *value;
                    }
                }
                for row in block.chunks_exact_mut(nx) {
                    self.along_x.undo(row, &mut lane.x);
                }
            }
        });
    }
}
