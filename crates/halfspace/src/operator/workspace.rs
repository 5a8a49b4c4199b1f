//! The working memory of a product, reused between products.

use rustfft::num_complex::Complex64;

use super::length::BLOCK;
use super::plan::Plan;
use super::plate::SineSpace;
use super::pool;
use super::threads::Threads;

/// Buffers of a product; made by [`SurfaceOperator::workspace`](super::SurfaceOperator::workspace).
///
/// It may serve any operator: buffers grow as needed and are never reduced.
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    /// Row spectra of the tractions, by row, traction, column.
    pub(crate) rows: Vec<Complex64>,
    /// Column results of the displacements, by column, displacement, row.
    pub(crate) columns: Vec<Complex64>,
    pub(crate) lanes: Vec<Lane>,
    pub(super) sines: SineSpace,
}

/// Working memory of one thread.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lane {
    /// One padded row.
    pub(crate) row: Vec<f64>,
    /// A block of columns of each input.
    pub(crate) blocks: Vec<Complex64>,
    /// A block of columns of one output.
    pub(crate) sum: Vec<Complex64>,
    /// A block of rows of one output.
    pub(crate) spectra: Vec<Complex64>,
    pub(crate) scratch: Vec<Complex64>,
}

impl Workspace {
    /// Makes all buffers long enough for a product.
    pub(crate) fn prepare(&mut self, plan: &Plan, inputs: usize, outputs: usize) {
        let field = plan.sizes.columns() * plan.sizes.ny;
        grow(&mut self.rows, inputs * field);
        grow(&mut self.columns, outputs * field);
        let lanes = plan.threads.count();
        if self.lanes.len() != lanes {
            self.lanes.resize(lanes, Lane::default());
        }
        for lane in &mut self.lanes {
            lane.prepare(plan, inputs);
        }
    }
}

impl Lane {
    pub(crate) fn prepare(&mut self, plan: &Plan, inputs: usize) {
        // The transforms require these two at exactly their own length.
        self.row.resize(plan.sizes.px, 0.0);
        grow(&mut self.scratch, plan.scratch());
        grow(&mut self.blocks, inputs * BLOCK * plan.sizes.py);
        grow(&mut self.sum, BLOCK * plan.sizes.py);
        grow(&mut self.spectra, BLOCK * plan.sizes.columns());
    }
}

fn grow(buffer: &mut Vec<Complex64>, length: usize) {
    if buffer.len() < length {
        buffer.resize(length, Complex64::ZERO);
    }
}

/// Runs `work(part, lane, share)` for the shares of `data` of length `share`, one a lane.
pub(crate) fn each<L: Send, T: Send>(
    threads: Threads,
    lanes: &mut [L],
    data: &mut [T],
    share: usize,
    work: impl Fn(usize, &mut L, &mut [T]) + Sync + Send,
) {
    match threads {
        Threads::One => {
            for (part, (lane, share)) in lanes.iter_mut().zip(data.chunks_mut(share)).enumerate() {
                work(part, lane, share);
            }
        }
        Threads::Pool => pool::each_lane(lanes, data, share, work),
    }
}
