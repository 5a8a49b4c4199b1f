//! The product of fields with spectra, in passes over rows and columns.
//!
//! Rows are transformed as real data, and only those with tractions; the padding is zero. Their spectra are stored in
//! blocks of a few columns, which stay in the cache while they are transformed along the columns, multiplied with the
//! spectra, transformed back and written in place, where the second pass over the rows reads them. The full spectrum is
//! never stored, and no array is transposed in memory.
//!
//! Each thread has a part of the rows and a part of the columns. A tile is what a part of the rows has of a part of the
//! columns: the threads exchange whole tiles between the passes.

use std::ops::Range;

use carom_fourier::Complex;

use super::plan::Plan;
use super::pool;
use super::precision::Real;
use super::product::{Matrix, Term, Terms};
use super::rows::NormalRows;
use super::threads::Threads;
use super::workspace::{Lane, Space, Tile, Workspace, each, exchange};

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
        let (parts, unit) = self.transformed(inputs, (terms, outputs.len()), space);
        self.rows_inverse((outputs, unit), &parts, space);
    }

    /// The passes but for the last: the results are the spectra of the rows of all outputs, in the unit that is returned.
    fn transformed(
        &self,
        inputs: &[&[f64]],
        (terms, outputs): (&Terms<'_, T>, usize),
        space: &mut Space<T>,
    ) -> (Parts, f64) {
        // On a thread of the pool, which has given back the memory of the last product.
        space.prepare(self, inputs.len(), outputs);
        let (used, unit) = (self.used_rows(inputs), T::unit(inputs, self.threads));
        let parts = self.parts(inputs.len().max(outputs), space);
        self.rows_forward((inputs, unit), &used, &parts, space);
        exchange(&mut space.tiles, space.lanes.len());
        self.columns_pass((inputs.len(), &used), (terms.blocks, outputs), &parts, space);
        exchange(&mut space.tiles, space.lanes.len());
        (parts, unit * terms.unit)
    }

    fn parts(&self, fields: usize, space: &Space<T>) -> Parts {
        Parts {
            fields,
            rows: self.sizes.ny,
            each: self.rows_of_part(space.lanes.len()),
            blocks: self.blocks_of_part(space.lanes.len()),
        }
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

    /// Number of rows of a part, but for the last.
    pub(super) const fn rows_of_part(&self, parts: usize) -> usize {
        self.sizes.ny.div_ceil(parts)
    }

    /// Number of blocks of columns of a part.
    pub(super) const fn blocks_of_part(&self, parts: usize) -> usize {
        self.sizes.columns().div_ceil(T::BLOCK).div_ceil(parts)
    }

    /// Transforms the used rows of the inputs.
    fn rows_forward(
        &self,
        (inputs, unit): (&[&[f64]], f64),
        used: &Range<usize>,
        parts: &Parts,
        space: &mut Space<T>,
    ) {
        let (per_unit, count) = (1.0 / unit, space.lanes.len());
        each(self.threads, &mut space.lanes, &mut space.tiles, count, |part, lane, tiles| {
            let own = parts.rows(part);
            for row in used.start.max(own.start)..used.end.min(own.end) {
                for (field, input) in inputs.iter().enumerate() {
                    let (values, padding) = lane.row.split_at_mut(self.sizes.nx);
                    let given = &input[row * self.sizes.nx..][..self.sizes.nx];
                    for (value, given) in values.iter_mut().zip(given) {
                        *value = T::of(given * per_unit);
                    }
                    padding.fill(T::zero());
                    let mut spectrum = std::mem::take(&mut lane.spectrum);
                    self.row_forward(lane, &mut spectrum[..self.sizes.columns()]);
                    let some = spectrum[..self.sizes.columns()].chunks(T::BLOCK);
                    for (slot, values) in parts.slots_mut((part, field, row), tiles).zip(some) {
                        slot[..values.len()].copy_from_slice(values);
                    }
                    lane.spectrum = spectrum;
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

    /// Transforms the columns, multiplies with the terms, and transforms back, in place.
    fn columns_pass(
        &self,
        (inputs, used): (usize, &Range<usize>),
        (terms, outputs): (&Matrix<'_, T>, usize),
        parts: &Parts,
        space: &mut Space<T>,
    ) {
        let count = space.lanes.len();
        each(self.threads, &mut space.lanes, &mut space.tiles, count, |part, lane, tiles| {
            for block in 0..parts.blocks {
                let first = (part * parts.blocks + block) * T::BLOCK;
                let width = self.sizes.columns().saturating_sub(first).min(T::BLOCK);
                for input in 0..inputs {
                    self.gather((tiles, used), parts, (input, block, width), lane);
                }
                for (output, row) in terms.iter().enumerate().take(outputs) {
                    self.multiply(row, inputs, (first, width), lane);
                    self.columns.inverse.process_with_scratch(
                        &mut lane.sum[..width * self.sizes.py],
                        &mut lane.scratch,
                    );
                    self.scatter(&lane.sum, parts, (output, block, width), tiles);
                }
            }
        });
    }

    /// Gathers `width` columns of one input and transforms them.
    fn gather(
        &self,
        (tiles, used): (&[Tile<T>], &Range<usize>),
        parts: &Parts,
        (input, block, width): (usize, usize, usize),
        lane: &mut Lane<T>,
    ) {
        let py = self.sizes.py;
        let columns = &mut lane.blocks[input * T::BLOCK * py..][..width * py];
        for (part, tile) in tiles.iter().enumerate() {
            let (own, start) = (parts.rows(part), block * parts.block::<T>(part));
            for row in used.start.max(own.start)..used.end.min(own.end) {
                let at = start + parts.place::<T>(part, input, row);
                for (column, value) in tile[at..at + width].iter().enumerate() {
                    columns[column * py + row] = *value;
                }
            }
        }
        for column in columns.chunks_exact_mut(py) {
            column[..used.start].fill(Complex::default());
            column[used.end..].fill(Complex::default());
        }
        self.columns.forward.process_with_scratch(columns, &mut lane.scratch);
    }

    /// Stores `width` columns of one output.
    fn scatter(
        &self,
        columns: &[Complex<T>],
        parts: &Parts,
        (output, block, width): (usize, usize, usize),
        tiles: &mut [Tile<T>],
    ) {
        for (part, tile) in tiles.iter_mut().enumerate() {
            let start = block * parts.block::<T>(part);
            for row in parts.rows(part) {
                let at = start + parts.place::<T>(part, output, row);
                for (column, value) in tile[at..at + width].iter_mut().enumerate() {
                    *value = columns[column * self.sizes.py + row];
                }
            }
        }
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
            let Lane { sum, blocks, factors, .. } = lane;
            let sum = &mut sum[column * py..][..py];
            let mut fresh = true;
            for (input, term) in terms.iter().enumerate().take(inputs) {
                let Some(term) = term else { continue };
                let values = &blocks[(input * T::BLOCK + column) * py..][..py];
                let at = (first + column, term.sign);
                term.spectrum.multiply(at, values, (sum, fresh), factors);
                fresh = false;
            }
            if fresh {
                sum.fill(Complex::default());
            }
        }
    }

    /// Transforms the rows of the outputs back.
    fn rows_inverse(
        &self,
        (outputs, unit): (&mut [&mut [f64]], f64),
        parts: &Parts,
        space: &mut Space<T>,
    ) {
        let (tiles, count, nx) = (&space.tiles, space.lanes.len(), self.sizes.nx);
        for (output, field) in outputs.iter_mut().enumerate() {
            each(self.threads, &mut space.lanes, field, parts.each * nx, |part, lane, results| {
                let own = &tiles[part * count..][..count];
                for (row, result) in results.chunks_exact_mut(nx).enumerate() {
                    self.row_inverse((output, part, part * parts.each + row), parts, own, lane);
                    for (result, value) in result.iter_mut().zip(&lane.row) {
                        *result = value.to() * unit;
                    }
                }
            });
        }
    }

    /// One row of an output, from the tiles of its part to the row of the lane.
    fn row_inverse(
        &self,
        (output, part, row): (usize, usize, usize),
        parts: &Parts,
        tiles: &[Tile<T>],
        lane: &mut Lane<T>,
    ) {
        let length = self.sizes.columns();
        let spectrum = &mut lane.spectrum[..length];
        let slots = parts.slots((part, output, row), tiles);
        for (values, slot) in spectrum.chunks_mut(T::BLOCK).zip(slots) {
            values.copy_from_slice(&slot[..values.len()]);
        }
        // Real by symmetry; the transform requires an exact zero.
        spectrum[0].im = T::zero();
        spectrum[length - 1].im = T::zero();
        let done =
            self.rows.inverse.process_with_scratch(spectrum, &mut lane.row, &mut lane.scratch);
        debug_assert!(done.is_ok(), "buffers are made for this plan");
    }
}

/// The product of one field with a term, whose rows are stored where their spectra were.
pub(crate) struct Transformed<'a> {
    plan: &'a Plan,
    space: &'a mut Space<f64>,
    parts: Parts,
}

impl Plan {
    /// The product of one field with a term, row by row.
    pub(crate) fn by_rows<'a>(
        &'a self,
        input: &[f64],
        term: Option<Term<'_>>,
        workspace: &'a mut Workspace,
    ) -> Transformed<'a> {
        let space = f64::space(workspace);
        let mut blocks: Matrix<'_, f64> = [[None; 3]; 3];
        blocks[0][0] = term;
        let terms = Terms { blocks: &blocks, unit: 1.0 };
        let mut passes = || {
            let (parts, unit) = self.transformed(&[input], (&terms, 1), space);
            self.rows_inverse_in_place(unit, &parts, space);
            parts
        };
        let parts = match self.threads {
            Threads::One => passes(),
            Threads::Pool => pool::within(passes),
        };
        Transformed { plan: self, space, parts }
    }

    /// Transforms the rows of one output back, and stores them instead of their spectra, which are longer.
    fn rows_inverse_in_place(&self, unit: f64, parts: &Parts, space: &mut Space<f64>) {
        let count = space.lanes.len();
        each(self.threads, &mut space.lanes, &mut space.tiles, count, |part, lane, tiles| {
            for row in parts.rows(part) {
                self.row_inverse((0, part, row), parts, tiles, lane);
                let some = lane.row[..self.sizes.nx].chunks(2 * f64::BLOCK);
                for (slot, values) in parts.slots_mut((part, 0, row), tiles).zip(some) {
                    let (pairs, last) = values.as_chunks();
                    for (place, [one, other]) in slot.iter_mut().zip(pairs) {
                        *place = Complex::new(one * unit, other * unit);
                    }
                    if let [last] = last {
                        slot[pairs.len()].re = last * unit;
                    }
                }
            }
        });
    }
}
impl NormalRows for Transformed<'_> {
    fn each(
        &mut self,
        wanted: &(dyn Fn(usize) -> bool + Sync),
        take: &(dyn Fn(usize, &[f64]) + Sync),
    ) {
        let Self { plan, space, parts } = self;
        let Space { tiles, lanes } = &mut **space;
        let (nx, count) = (plan.sizes.nx, lanes.len());
        each(plan.threads, lanes, tiles, count, |part, lane, tiles| {
            for row in parts.rows(part).filter(|row| wanted(*row)) {
                let some = lane.row[..nx].chunks_mut(2 * f64::BLOCK);
                for (values, slot) in some.zip(parts.slots((part, 0, row), tiles)) {
                    let (pairs, last) = values.as_chunks_mut();
                    for (pair, stored) in pairs.iter_mut().zip(slot) {
                        *pair = [stored.re, stored.im];
                    }
                    if let [last] = last {
                        *last = slot[pairs.len()].re;
                    }
                }
                take(row, &lane.row[..nx]);
            }
        });
    }
}

/// How rows and columns are distributed: a tile holds blocks of columns, each of them its fields, each of them its rows.
struct Parts {
    fields: usize,
    /// All rows, and those of a part but for the last.
    rows: usize,
    each: usize,
    /// Blocks of columns of a part.
    blocks: usize,
}

impl Parts {
    /// The rows of a part.
    fn rows(&self, part: usize) -> Range<usize> {
        (part * self.each).min(self.rows)..((part + 1) * self.each).min(self.rows)
    }

    /// The length of a block in tiles of a part: one row more than it holds, as blocks at a distance of a power of two
    /// would share few lines of the cache.
    fn block<T: Real>(&self, part: usize) -> usize {
        (self.fields * self.rows(part).len() + 1) * T::BLOCK
    }

    /// The place of a row in a block.
    fn place<T: Real>(&self, part: usize, field: usize, row: usize) -> usize {
        let own = self.rows(part);
        (field * own.len() + row - own.start) * T::BLOCK
    }

    /// What the tiles of a part have of a row, block by block.
    fn slots<'t, T: Real>(
        &self,
        (part, field, row): (usize, usize, usize),
        tiles: &'t [Tile<T>],
    ) -> impl Iterator<Item = &'t [Complex<T>]> {
        let (block, blocks) = (self.block::<T>(part), self.blocks);
        let at = self.place::<T>(part, field, row);
        let of_tile = move |tile: &'t Tile<T>| tile.chunks_exact(block).take(blocks);
        tiles.iter().flat_map(of_tile).map(move |block| &block[at..at + T::BLOCK])
    }

    /// The same, to be written.
    fn slots_mut<'t, T: Real>(
        &self,
        (part, field, row): (usize, usize, usize),
        tiles: &'t mut [Tile<T>],
    ) -> impl Iterator<Item = &'t mut [Complex<T>]> {
        let (block, blocks) = (self.block::<T>(part), self.blocks);
        let at = self.place::<T>(part, field, row);
        let of_tile = move |tile: &'t mut Tile<T>| tile.chunks_exact_mut(block).take(blocks);
        tiles.iter_mut().flat_map(of_tile).map(move |block| &mut block[at..at + T::BLOCK])
    }
}
