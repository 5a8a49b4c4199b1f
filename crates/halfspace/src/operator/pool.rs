//! Work on the current pool of threads. Without the feature `threads` the calling thread does it all.

#[cfg(feature = "threads")]
mod several {
    use rayon::prelude::*;

    pub(crate) fn count() -> usize {
        rayon::current_num_threads()
    }

    /// Runs `work` within the pool, so that no worker needs to be woken for each of its parts.
    pub(crate) fn within<R: Send>(work: impl FnOnce() -> R + Send) -> R {
        rayon::scope(|_| work())
    }

    /// Runs `work(part, lane, share)` for the shares of `data` of length `share`, one a lane.
    pub(crate) fn each_lane<L: Send, T: Send>(
        lanes: &mut [L],
        data: &mut [T],
        share: usize,
        work: impl Fn(usize, &mut L, &mut [T]) + Sync + Send,
    ) {
        let shares = lanes.par_iter_mut().zip(data.par_chunks_mut(share)).enumerate();
        shares.for_each(|(part, (lane, share))| work(part, lane, share));
    }

    /// Runs `work(index, row)` for the rows of this length.
    pub(crate) fn each_row<T: Send>(
        values: &mut [T],
        length: usize,
        work: impl Fn((usize, &mut [T])) + Sync + Send,
    ) {
        values.par_chunks_mut(length).enumerate().for_each(work);
    }

    /// The greatest `work(share)` of the shares of this length, at least zero.
    pub(crate) fn greatest(
        values: &[f64],
        share: usize,
        work: impl Fn(&[f64]) -> f64 + Sync + Send,
    ) -> f64 {
        values.par_chunks(share).map(work).reduce(|| 0.0, f64::max)
    }

    /// Runs `work(index, item)` for all items.
    pub(crate) fn each<T: Send>(items: Vec<T>, work: impl Fn((usize, T)) + Sync + Send) {
        items.into_par_iter().enumerate().for_each(work);
    }
}

#[cfg(not(feature = "threads"))]
mod several {
    pub(crate) const fn count() -> usize {
        1
    }

    pub(crate) fn within<R>(work: impl FnOnce() -> R) -> R {
        work()
    }

    pub(crate) fn each_lane<L, T>(
        lanes: &mut [L],
        data: &mut [T],
        share: usize,
        work: impl Fn(usize, &mut L, &mut [T]),
    ) {
        for (part, (lane, share)) in lanes.iter_mut().zip(data.chunks_mut(share)).enumerate() {
            work(part, lane, share);
        }
    }

    pub(crate) fn each_row<T>(values: &mut [T], length: usize, work: impl Fn((usize, &mut [T]))) {
        values.chunks_mut(length).enumerate().for_each(work);
    }

    pub(crate) fn greatest(values: &[f64], share: usize, work: impl Fn(&[f64]) -> f64) -> f64 {
        values.chunks(share).map(work).fold(0.0, f64::max)
    }

    pub(crate) fn each<T>(items: Vec<T>, work: impl Fn((usize, T))) {
        items.into_iter().enumerate().for_each(work);
    }
}

pub(crate) use several::{count, each, each_lane, each_row, greatest, within};
