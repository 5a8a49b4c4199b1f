//! The product of fields with spectra, in passes over rows and columns.
//!
//! Rows are transformed as real data, and only those with tractions; the padding is zero. Columns
//! are processed in blocks that stay in the cache: gathered, transformed, multiplied with the
//! spectra, transformed back and stored transposed, where the second pass over the rows reads them.
//! The full spectrum is never stored, and no array is transposed in memory.

use std::ops::Range;

use carom_fourier::Complex;

use super::plan::Plan;
use super::pool;
use super::precision::Real;
use super::product::{Matrix, Term, Terms};
use super::threads::Threads;
use super::workspace::{Lane, Space, Workspace, each};

impl<T: Real> Plan<T> {
    /// `outputs = terms * inputs`. Inputs and outputs hold `nx * ny` values; there is at least one
    /// of each.
    pub(crate) fn product(
        &self,
        inputs: &[&[f64]],
        terms: &Terms<'_, T>,
        outputs: &mut [&mut [f64]],
        workspace: &mut Workspace,
    ) {
        let space = T::space(workspace);
        space.prepare(self, inputs.len(), outputs.len());
        match self.threads {
            Threads::One => self.passes(inputs, terms, outputs, space),
            Threads::Pool => pool::within(|| self.passes(inputs, terms, outputs, space)),
        }
    }

    fn passes(
        &self,
        inputs: &[&[f64]],
        terms: &Terms<'_, T>,
        outputs: &mut [&mut [f64]],
        space: &mut Space<T>,
    ) {
        let (used, unit) = (self.used_rows(inputs), T::unit(inputs, self.threads));
        self.rows_forward((inputs, unit), &used, space);
        self.columns_pass((inputs.len(), &used), terms.blocks, outputs.len(), space);
        self.rows_inverse((outputs, unit * terms.unit), space);
    }

    /// The range of rows in which some input is not zero.
    fn used_rows(&self, inputs: &[&[f64]]) -> Range<usize> {
        // NaN does not count as zero.
        let ends = inputs.iter().filter_map(|input| {
            let first = input.iter().position(|value| *value != 0.0)?;
            Some((first, input.iter().rposition(|value| *value != 0.0)?))
        });
        let row = |at: usize| at / self.sizes.nx;
        ends.map(|(first, last)| row(first)..row(last) + 1)
            .reduce(|one, other| one.start.min(other.start)..one.end.max(other.end))
            .unwrap_or_default()
    }

    /// Transforms the used rows of the inputs into `workspace.rows[row][input][column]`.
    fn rows_forward(
        &self,
        (inputs, unit): (&[&[f64]], f64),
        used: &Range<usize>,
        workspace: &mut Space<T>,
    ) {
        let per_unit = 1.0 / unit;
        let row_length = inputs.len() * self.sizes.columns();
        let rows = self.sizes.ny.div_ceil(workspace.lanes.len());
        let all = &mut workspace.rows[..self.sizes.ny * row_length];
        each(self.threads, &mut workspace.lanes, all, rows * row_length, |part, lane, spectra| {
            for (row, spectra) in spectra.chunks_exact_mut(row_length).enumerate() {
                if !used.contains(&(part * rows + row)) {
                    continue;
                }
                let start = (part * rows + row) * self.sizes.nx;
                for (input, spectrum) in
                    inputs.iter().zip(spectra.chunks_exact_mut(self.sizes.columns()))
                {
                    let (values, padding) = lane.row.split_at_mut(self.sizes.nx);
                    let given = &input[start..start + self.sizes.nx];
                    for (value, given) in values.iter_mut().zip(given) {
                        *value = T::of(given * per_unit);
                    }
                    padding.fill(T::zero());
                    self.row_forward(lane, spectrum);
                }
            }
        });
    }

    /// Real transform of `lane.row`, which is overwritten.
    pub(crate) fn row_forward(&self, lane: &mut Lane<T>, spectrum: &mut [Complex<T>]) {
        let done =
            self.rows.forward.process_with_scratch(&mut lane.row, spectrum, &mut lane.scratch);
        debug_assert!(done.is_ok(), "buffers are made for this plan");
    }

    /// Multiplies with the terms; writes `workspace.columns[column][output][row]`.
    fn columns_pass(
        &self,
        (inputs, rows_used): (usize, &Range<usize>),
        terms: &Matrix<'_, T>,
        outputs: usize,
        work: &mut Space<T>,
    ) {
        let column_length = outputs * self.sizes.ny;
        let columns = self.sizes.columns().div_ceil(work.lanes.len()).next_multiple_of(T::BLOCK);
        let used = &mut work.columns[..self.sizes.columns() * column_length];
        let rows = &work.rows;
        each(self.threads, &mut work.lanes, used, columns * column_length, |part, lane, share| {
            for (block, results) in share.chunks_mut(T::BLOCK * column_length).enumerate() {
                let first = part * columns + block * T::BLOCK;
                let width = results.len() / column_length;
                for input in 0..inputs {
                    self.gather((rows, rows_used), (inputs, input), (first, width), lane);
                }
                for (output, row) in terms.iter().enumerate().take(outputs) {
                    self.multiply(row, inputs, (first, width), lane);
                    self.columns.inverse.process_with_scratch(
                        &mut lane.sum[..width * self.sizes.py],
                        &mut lane.scratch,
                    );
                    for (column, sums) in
                        lane.sum.chunks_exact(self.sizes.py).take(width).enumerate()
                    {
                        let at = (column * outputs + output) * self.sizes.ny;
                        results[at..at + self.sizes.ny].copy_from_slice(&sums[..self.sizes.ny]);
                    }
                }
            }
        });
    }

    /// Gathers `width` columns of one input from the row spectra and transforms them.
    fn gather(
        &self,
        (rows, used): (&[Complex<T>], &Range<usize>),
        (inputs, input): (usize, usize),
        (first, width): (usize, usize),
        lane: &mut Lane<T>,
    ) {
        let py = self.sizes.py;
        let block = &mut lane.blocks[input * T::BLOCK * py..][..width * py];
        for row in used.clone() {
            let at = (row * inputs + input) * self.sizes.columns() + first;
            for (column, value) in rows[at..at + width].iter().enumerate() {
                block[column * py + row] = *value;
            }
        }
        for column in block.chunks_exact_mut(py) {
            column[..used.start].fill(Complex::default());
            column[used.end..].fill(Complex::default());
        }
        self.columns.forward.process_with_scratch(block, &mut lane.scratch);
    }

    /// Sums the terms of one output over the inputs into `lane.sum`.
    fn multiply(
        &self,
        terms: &[Option<Term<'_, T>>; 3],
        inputs: usize,
        (first, width): (usize, usize),
        lane: &mut Lane<T>,
    ) {
        let py = self.sizes.py;
        for column in 0..width {
            let sum = &mut lane.sum[column * py..][..py];
            let mut fresh = true;
            for (input, term) in terms.iter().enumerate().take(inputs) {
                let Some(term) = term else { continue };
                let values = &lane.blocks[(input * T::BLOCK + column) * py..][..py];
                term.spectrum.multiply(first + column, term.sign, values, sum, fresh);
                fresh = false;
            }
            if fresh {
                sum.fill(Complex::default());
            }
        }
    }

    /// Reads the transposed columns and transforms the rows of the outputs back.
    fn rows_inverse(&self, (outputs, unit): (&mut [&mut [f64]], f64), workspace: &mut Space<T>) {
        let count = outputs.len();
        let rows = self.sizes.ny.div_ceil(workspace.lanes.len()).next_multiple_of(T::BLOCK);
        let columns = &workspace.columns;
        for (output, field) in outputs.iter_mut().enumerate() {
            each(
                self.threads,
                &mut workspace.lanes,
                field,
                rows * self.sizes.nx,
                |part, lane, share| {
                    for (block, results) in share.chunks_mut(T::BLOCK * self.sizes.nx).enumerate() {
                        let first = part * rows + block * T::BLOCK;
                        let height = results.len() / self.sizes.nx;
                        let length = self.sizes.columns();
                        for column in 0..length {
                            let at = (column * count + output) * self.sizes.ny + first;
                            for (row, value) in columns[at..at + height].iter().enumerate() {
                                lane.spectra[row * length + column] = *value;
                            }
                        }
                        for (row, result) in results.chunks_exact_mut(self.sizes.nx).enumerate() {
                            self.row_inverse(row, (result, unit), lane);
                        }
                    }
                },
            );
        }
    }

    fn row_inverse(&self, row: usize, (result, unit): (&mut [f64], f64), lane: &mut Lane<T>) {
        let length = self.sizes.columns();
        let spectrum = &mut lane.spectra[row * length..][..length];
        // Real by symmetry; the transform requires an exact zero.
        spectrum[0].im = T::zero();
        spectrum[length - 1].im = T::zero();
        let done =
            self.rows.inverse.process_with_scratch(spectrum, &mut lane.row, &mut lane.scratch);
        debug_assert!(done.is_ok(), "buffers are made for this plan");
        for (result, value) in result.iter_mut().zip(&lane.row) {
            *result = value.to() * unit;
        }
    }
}
