//! The product of fields with spectra, in passes over rows and columns.
//!
//! Rows are transformed as real data, and only those with tractions; the padding is zero. Columns
//! are processed in blocks that stay in the cache: gathered, transformed, multiplied with the
//! spectra, transformed back and stored transposed, where the second pass over the rows reads them.
//! The full spectrum is never stored, and no array is transposed in memory.

use std::ops::Range;

use rustfft::num_complex::Complex64;

use super::length::BLOCK;
use super::plan::Plan;
use super::pool;
use super::product::{Term, Terms};
use super::threads::Threads;
use super::workspace::{Lane, Workspace, each};

impl Plan {
    /// `outputs = terms * inputs`. Inputs and outputs hold `nx * ny` values; there is at least one
    /// of each.
    pub(crate) fn product(
        &self,
        inputs: &[&[f64]],
        terms: &Terms<'_>,
        outputs: &mut [&mut [f64]],
        workspace: &mut Workspace,
    ) {
        workspace.prepare(self, inputs.len(), outputs.len());
        match self.threads {
            Threads::One => self.passes(inputs, terms, outputs, workspace),
            Threads::Pool => pool::within(|| self.passes(inputs, terms, outputs, workspace)),
        }
    }

    fn passes(
        &self,
        inputs: &[&[f64]],
        terms: &Terms<'_>,
        outputs: &mut [&mut [f64]],
        workspace: &mut Workspace,
    ) {
        let used = self.used_rows(inputs);
        self.rows_forward(inputs, &used, workspace);
        self.columns_pass((inputs.len(), &used), terms, outputs.len(), workspace);
        self.rows_inverse(outputs, workspace);
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
    fn rows_forward(&self, inputs: &[&[f64]], used: &Range<usize>, workspace: &mut Workspace) {
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
                    values.copy_from_slice(&input[start..start + self.sizes.nx]);
                    padding.fill(0.0);
                    self.row_forward(lane, spectrum);
                }
            }
        });
    }

    /// Real transform of `lane.row`, which is overwritten.
    pub(crate) fn row_forward(&self, lane: &mut Lane, spectrum: &mut [Complex64]) {
        let done =
            self.row_forward.process_with_scratch(&mut lane.row, spectrum, &mut lane.scratch);
        debug_assert!(done.is_ok(), "buffers are made for this plan");
    }

    /// Multiplies with the terms; writes `workspace.columns[column][output][row]`.
    fn columns_pass(
        &self,
        (inputs, rows_used): (usize, &Range<usize>),
        terms: &Terms<'_>,
        outputs: usize,
        work: &mut Workspace,
    ) {
        let column_length = outputs * self.sizes.ny;
        let columns = self.sizes.columns().div_ceil(work.lanes.len()).next_multiple_of(BLOCK);
        let used = &mut work.columns[..self.sizes.columns() * column_length];
        let rows = &work.rows;
        each(self.threads, &mut work.lanes, used, columns * column_length, |part, lane, share| {
            for (block, results) in share.chunks_mut(BLOCK * column_length).enumerate() {
                let first = part * columns + block * BLOCK;
                let width = results.len() / column_length;
                for input in 0..inputs {
                    self.gather((rows, rows_used), (inputs, input), (first, width), lane);
                }
                for (output, row) in terms.iter().enumerate().take(outputs) {
                    self.multiply(row, inputs, (first, width), lane);
                    self.column_inverse.process_with_scratch(
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
        (rows, used): (&[Complex64], &Range<usize>),
        (inputs, input): (usize, usize),
        (first, width): (usize, usize),
        lane: &mut Lane,
    ) {
        let py = self.sizes.py;
        let block = &mut lane.blocks[input * BLOCK * py..][..width * py];
        for row in used.clone() {
            let at = (row * inputs + input) * self.sizes.columns() + first;
            for (column, value) in rows[at..at + width].iter().enumerate() {
                block[column * py + row] = *value;
            }
        }
        for column in block.chunks_exact_mut(py) {
            column[..used.start].fill(Complex64::ZERO);
            column[used.end..].fill(Complex64::ZERO);
        }
        self.column_forward.process_with_scratch(block, &mut lane.scratch);
    }

    /// Sums the terms of one output over the inputs into `lane.sum`.
    fn multiply(
        &self,
        terms: &[Option<Term<'_>>; 3],
        inputs: usize,
        (first, width): (usize, usize),
        lane: &mut Lane,
    ) {
        let py = self.sizes.py;
        for column in 0..width {
            let sum = &mut lane.sum[column * py..][..py];
            let mut fresh = true;
            for (input, term) in terms.iter().enumerate().take(inputs) {
                let Some(term) = term else { continue };
                let values = &lane.blocks[(input * BLOCK + column) * py..][..py];
                term.spectrum.multiply(first + column, term.sign, values, sum, fresh);
                fresh = false;
            }
            if fresh {
                sum.fill(Complex64::ZERO);
            }
        }
    }

    /// Reads the transposed columns and transforms the rows of the outputs back.
    fn rows_inverse(&self, outputs: &mut [&mut [f64]], workspace: &mut Workspace) {
        let count = outputs.len();
        let rows = self.sizes.ny.div_ceil(workspace.lanes.len()).next_multiple_of(BLOCK);
        let columns = &workspace.columns;
        for (output, field) in outputs.iter_mut().enumerate() {
            each(
                self.threads,
                &mut workspace.lanes,
                field,
                rows * self.sizes.nx,
                |part, lane, share| {
                    for (block, results) in share.chunks_mut(BLOCK * self.sizes.nx).enumerate() {
                        let first = part * rows + block * BLOCK;
                        let height = results.len() / self.sizes.nx;
                        let length = self.sizes.columns();
                        for column in 0..length {
                            let at = (column * count + output) * self.sizes.ny + first;
                            for (row, value) in columns[at..at + height].iter().enumerate() {
                                lane.spectra[row * length + column] = *value;
                            }
                        }
                        for (row, result) in results.chunks_exact_mut(self.sizes.nx).enumerate() {
                            self.row_inverse(row, result, lane);
                        }
                    }
                },
            );
        }
    }

    fn row_inverse(&self, row: usize, result: &mut [f64], lane: &mut Lane) {
        let length = self.sizes.columns();
        let spectrum = &mut lane.spectra[row * length..][..length];
        // Real by symmetry; the transform requires an exact zero.
        spectrum[0].im = 0.0;
        spectrum[length - 1].im = 0.0;
        let done =
            self.row_inverse.process_with_scratch(spectrum, &mut lane.row, &mut lane.scratch);
        debug_assert!(done.is_ok(), "buffers are made for this plan");
        result.copy_from_slice(&lane.row[..self.sizes.nx]);
    }
}
