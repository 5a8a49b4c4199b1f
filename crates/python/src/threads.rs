//! The threads that compute, in a process that may have been forked.

use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::process::id;
use std::sync::{Arc, Mutex, OnceLock};

/// The process that loaded the module: the threads of all the program are its own.
static HOME: OnceLock<u32> = OnceLock::new();
/// The threads of a process forked from it, which has none of them, and whose they are.
static FORKED: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// To be called when the module is loaded.
pub(crate) fn settle() {
    HOME.get_or_init(id);
}

/// Works without the interpreter. A child of `fork` gets threads of its own: those of its parent are not
/// in it, and it would wait for them for ever.
pub(crate) fn without_python<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> T {
    let at_home = HOME.get().is_none_or(|home| *home == id());
    match if at_home { None } else { of_child() } {
        None => py.detach(work),
        Some(pool) => py.detach(|| pool.install(work)),
    }
}

/// Those of this process; none if the system gives none.
fn of_child() -> Option<Arc<ThreadPool>> {
    let mut kept = FORKED.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    if let Some((owner, pool)) = kept.as_ref()
        && *owner == id()
    {
        return Some(Arc::clone(pool));
    }
    let pool = Arc::new(ThreadPoolBuilder::new().build().ok()?);
    // One inherited from a parent that was forked itself is left alone: to drop it would wait for its threads.
    std::mem::forget(kept.replace((id(), Arc::clone(&pool))));
    Some(pool)
}
