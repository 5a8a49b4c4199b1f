//! Work without the interpreter: it hears interrupts, and has threads in a process that may have been forked.

use carom::special::interrupt::{self, Ask};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::process::id;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread::{self, Builder, ThreadId};
use std::time::{Duration, Instant};

use crate::error::Fault;

/// Time between two questions whether there is an interrupt.
const PERIOD: Duration = Duration::from_millis(50);
/// Stack of a thread that does the work of a call.
const STACK: usize = 1 << 23;

/// The process that loaded the module: it uses the global thread pool.
static HOME: OnceLock<u32> = OnceLock::new();
/// The thread pool of a forked process, with the process it belongs to: threads do not survive a fork.
static FORKED: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Must be called when the module is loaded.
pub(crate) fn settle() {
    HOME.get_or_init(id);
}

/// Does `work` without the interpreter. A handler of signals that raises, as that of Ctrl-C does, ends it: `work` asks
/// [`interrupt::is_wanted`] from time to time, and what it returns is lost.
///
/// A forked child gets its own thread pool; on its parent's it would deadlock, since those threads do not exist in the
/// child.
pub(crate) fn without_python<T: Send>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    if of_child().is_some() {
        return beside(py, work);
    }
    let ear = Arc::new(Ear::new());
    let done = py.detach(|| interrupt::under(Some(ear.asking()), work));
    ear.unless_interrupted(py, done)
}

/// The same for work that waits for other threads, so that this one cannot ask: it is done on a thread of its own.
pub(crate) fn beside<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let (ear, is_done, own) = (Arc::new(Ear::new()), AtomicBool::new(false), thread::current());
    let pool = of_child();
    let apart = || {
        let done = match &pool {
            None => interrupt::under(Some(ear.asking()), work),
            Some(pool) => pool.install(|| interrupt::under(Some(ear.asking()), work)),
        };
        is_done.store(true, Ordering::Release);
        own.unpark();
        done
    };
    let done = py.detach(|| {
        thread::scope(|scope| {
            let worker = Builder::new().stack_size(STACK).spawn_scoped(scope, apart)?;
            while !is_done.load(Ordering::Acquire) && !worker.is_finished() {
                thread::park_timeout(PERIOD);
                ear.listen();
            }
            Ok::<_, std::io::Error>(
                worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            )
        })
    });
    ear.unless_interrupted(py, done.map_err(Fault::other)?)
}

/// Hears the interrupt of a call.
struct Ear {
    /// Python's signals are seen on the thread of the call.
    home: ThreadId,
    begin: Instant,
    /// When to ask next, in milliseconds.
    next: AtomicU64,
    is_interrupted: AtomicBool,
    raised: Mutex<Option<PyErr>>,
}

impl Ear {
    fn new() -> Self {
        Self {
            home: thread::current().id(),
            begin: Instant::now(),
            next: AtomicU64::new(PERIOD.as_millis() as u64),
            is_interrupted: AtomicBool::new(false),
            raised: Mutex::new(None),
        }
    }

    fn asking(self: &Arc<Self>) -> Ask {
        let ear = Arc::clone(self);
        Arc::new(move || ear.hears())
    }

    /// Whether there was an interrupt. On the thread of the call it asks the interpreter, if it has not for a while.
    fn hears(&self) -> bool {
        if !self.is_interrupted.load(Ordering::Relaxed) && thread::current().id() == self.home {
            let now = self.begin.elapsed();
            if now.as_millis() as u64 >= self.next.load(Ordering::Relaxed) {
                self.next.store((now + PERIOD).as_millis() as u64, Ordering::Relaxed);
                self.listen();
            }
        }
        self.is_interrupted.load(Ordering::Relaxed)
    }

    /// Lets the interpreter handle its signals.
    fn listen(&self) {
        if let Err(error) = Python::attach(|py| py.check_signals()) {
            self.is_interrupted.store(true, Ordering::Relaxed);
            let mut raised = self.raised.lock().unwrap_or_else(PoisonError::into_inner);
            raised.get_or_insert(error);
        }
    }

    /// What was done, unless it was interrupted.
    fn unless_interrupted<T>(&self, py: Python<'_>, done: T) -> PyResult<T> {
        match self.raised.lock().unwrap_or_else(PoisonError::into_inner).take() {
            Some(error) => Err(error),
            None => py.check_signals().map(|()| done),
        }
    }
}

/// The thread pool of this process, if it was forked; None if the system cannot start one.
fn of_child() -> Option<Arc<ThreadPool>> {
    if HOME.get().is_none_or(|home| *home == id()) {
        return None;
    }
    let mut kept = FORKED.lock().unwrap_or_else(PoisonError::into_inner);
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
