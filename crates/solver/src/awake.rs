//! Keeps the workers of the pool awake while a problem is solved.
//!
//! An iteration divides its work a dozen times. In between, the calling thread works alone for some microseconds, in
//! which idle workers of rayon go to sleep; to wake one takes as long as its part of the work. While a problem is
//! solved, the other workers therefore ask for work again and again. They take whatever work the pool has, give way
//! to other threads of the machine, and stop when the solution is found.

use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A worker that finds no work asks this often before it gives way to other threads of the machine.
const ASKS: u32 = 64;

thread_local! {
    /// Whether this thread solves a problem. While it does it must not ask for the work of another solution until that
    /// one is found, which may in turn wait for this thread.
    static SOLVES: Cell<bool> = const { Cell::new(false) };
}

/// Does the work on a thread of the pool, while as many others as there are `helpers`, at most, stay awake.
pub(crate) fn while_awake<R>(helpers: usize, work: impl FnOnce() -> R) -> R {
    let solution = Solution::begin();
    if !solution.within_another {
        let ended = Arc::clone(&solution.ended);
        rayon::spawn_broadcast(move |worker| {
            // One of the first may be this thread, which does not ask.
            if worker.index() <= helpers {
                ask_for_work(&ended);
            }
        });
    }
    work()
}

/// A solution on this thread, until it is dropped.
struct Solution {
    ended: Arc<AtomicBool>,
    within_another: bool,
}

impl Solution {
    fn begin() -> Self {
        Self { ended: Arc::default(), within_another: SOLVES.replace(true) }
    }
}

impl Drop for Solution {
    fn drop(&mut self) {
        self.ended.store(true, Ordering::Relaxed);
        SOLVES.set(self.within_another);
    }
}

/// Takes work of the pool until the solution has ended.
fn ask_for_work(ended: &AtomicBool) {
    let mut asked = 0;
    while !SOLVES.get() && !ended.load(Ordering::Relaxed) {
        if rayon::yield_now() == Some(rayon::Yield::Executed) {
            asked = 0;
        } else if asked < ASKS {
            asked += 1;
            std::hint::spin_loop();
        } else {
            asked = 0;
            std::thread::yield_now();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::AtomicUsize;

    fn pool(threads: usize) -> rayon::ThreadPool {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap()
    }

    /// Divides work as an iteration does; counts the parts.
    fn iterate(times: usize) -> usize {
        let parts = AtomicUsize::new(0);
        let part = || parts.fetch_add(1, Ordering::Relaxed);
        for _ in 0..times {
            rayon::join(|| rayon::join(part, part), || rayon::join(part, part));
        }
        parts.into_inner()
    }

    #[test]
    fn solutions_beside_and_within_each_other_end() {
        for threads in [1, 2, 3, 5] {
            let pool = pool(threads);
            for _ in 0..200 {
                let solve = || while_awake(threads, || iterate(20));
                let within = || while_awake(threads, || solve() + iterate(5));
                let (one, other) = pool.install(|| rayon::join(within, solve));
                assert_eq!((one, other), (100, 80));
            }
        }
    }

    /// The two parts of the work wait for each other, so that another thread has to take one.
    #[test]
    fn a_helper_takes_a_part() {
        let here = || rayon::current_thread_index().unwrap();
        let [one, two] = [(); 2].map(|()| AtomicBool::new(false));
        let meet = |own: &AtomicBool, other: &AtomicBool| {
            own.store(true, Ordering::Release);
            while !other.load(Ordering::Acquire) {
                std::hint::spin_loop();
            }
            here()
        };
        let both = || rayon::join(|| meet(&one, &two), || meet(&two, &one));
        let (first, second) = pool(2).install(|| while_awake(1, both));
        assert_ne!(first, second);
    }

    #[test]
    fn a_panic_ends_the_solution() {
        let pool = pool(2);
        let end = pool.install(|| {
            let work = || while_awake(1, || panic!("as wanted"));
            let end = std::panic::catch_unwind(work);
            (end.is_err(), SOLVES.get())
        });
        assert_eq!(end, (true, false));
        // Workers that had not stopped would leave none for this.
        assert_eq!(pool.broadcast(|_| SOLVES.get()), [false; 2]);
    }
}
