//! The working memory of a product, reused between products.

use carom_fourier::Complex;

use super::plan::Plan;
use super::plate::SineSpace;
use super::pool;
use super::precision::Real;
use super::sparse::SparseSpace;
use super::threads::Threads;

/// Buffers of a product; made by [`SurfaceOperator::workspace`](super::SurfaceOperator::workspace).
///
/// It may serve any operator: buffers grow as needed and are never reduced.
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    pub(super) double: Space<f64>,
    pub(super) single: Space<f32>,
    pub(super) sines: SineSpace,
    pub(super) sparse: SparseSpace,
}

/// The values of a part of the rows in a part of the columns.
pub(crate) type Tile<T> = Vec<Complex<T>>;

/// Buffers of one precision.
#[derive(Debug, Clone, Default)]
pub(crate) struct Space<T> {
    /// Spectra of the rows, results of the columns: for each part of the rows one tile of each part of the columns.
    pub(crate) tiles: Vec<Tile<T>>,
    pub(crate) lanes: Vec<Lane<T>>,
}

/// Working memory of one thread.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lane<T = f64> {
    /// One padded row.
    pub(crate) row: Vec<T>,
    /// Its spectrum.
    pub(crate) spectrum: Vec<Complex<T>>,
    /// A block of columns of each input.
    pub(crate) blocks: Vec<Complex<T>>,
    /// A block of columns of one output.
    pub(crate) sum: Vec<Complex<T>>,
    /// Half of a column of a spectrum.
    pub(crate) factors: Vec<T>,
    pub(crate) scratch: Vec<Complex<T>>,
}

impl<T: Real> Space<T> {
    /// Makes all buffers long enough for a product.
    pub(crate) fn prepare(&mut self, plan: &Plan<T>, inputs: usize, outputs: usize) {
        let lanes = plan.threads.count();
        if self.lanes.len() != lanes {
            self.lanes.resize(lanes, Lane::default());
            self.tiles = vec![Tile::default(); lanes * lanes];
        }
        let rows = inputs.max(outputs) * plan.rows_of_part(lanes) + 1;
        let tile = rows * plan.blocks_of_part(lanes) * T::BLOCK;
        for one in &mut self.tiles {
            grow(one, tile);
        }
        for lane in &mut self.lanes {
            lane.prepare(plan, inputs);
        }
    }
}

impl<T: Real> Lane<T> {
    pub(crate) fn prepare(&mut self, plan: &Plan<T>, inputs: usize) {
        // The transforms require these two at exactly their own length.
        self.row.resize(plan.sizes.px, T::zero());
        self.factors.resize(self.factors.len().max(plan.sizes.py / 2 + 1), T::zero());
        grow(&mut self.scratch, plan.scratch());
        grow(&mut self.blocks, inputs * T::BLOCK * plan.sizes.py);
        grow(&mut self.sum, T::BLOCK * plan.sizes.py);
        grow(&mut self.spectrum, plan.sizes.columns());
    }
}

/// Gives each part of the columns what the parts of the rows have of it, or back.
pub(crate) fn exchange<T>(tiles: &mut [Tile<T>], parts: usize) {
    for one in 0..parts {
        for other in 0..one {
            tiles.swap(one * parts + other, other * parts + one);
        }
    }
}

fn grow<T: Real>(buffer: &mut Vec<Complex<T>>, length: usize) {
    if buffer.len() < length {
        buffer.resize(length, Complex::default());
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
