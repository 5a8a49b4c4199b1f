//! Thread pools, in a process that may have been forked.

use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::process::id;
use std::sync::{Arc, Mutex, OnceLock};

/// The process that loaded the module: it uses the global thread pool.
static HOME: OnceLock<u32> = OnceLock::new();
/// The thread pool of a forked process, with the process it belongs to: threads do not survive a fork.
static FORKED: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Must be called when the module is loaded.
pub(crate) fn settle() {
    HOME.get_or_init(id);
}

/// Runs `work` without the interpreter. A forked child gets its own thread pool; on its parent's it would
/// deadlock, since those threads do not exist in the child.
pub(crate) fn without_python<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> T {
    let at_home = HOME.get().is_none_or(|home| *home == id());
    match if at_home { None } else { of_child() } {
        None => py.detach(work),
        Some(pool) => py.detach(|| pool.install(work)),
    }
}

/// The thread pool of this forked process; None if the system cannot start one.
fn of_child() -> Option<Arc<ThreadPool>> {
    let mut kept = FORKED.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    if let Some((owner, pool)) = kept.as_ref()
        && *owner == id()
    {
        return Some(Arc::clone(pool));
    }
    let pool = Arc::new(ThreadPoolBuilder::new().build().ok()?);
    // A pool inherited from a forked parent is leaked on purpose: dropping it would wait for threads that do
    // not exist.
    std::mem::forget(kept.replace((id(), Arc::clone(&pool))));
    Some(pool)
}
