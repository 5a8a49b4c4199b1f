//! Ends a long computation from outside.
//!
//! Who starts a computation says how to ask whether it should end; its loops ask from time to time, on whatever thread they
//! run, and give up with the error of a computation that did not converge.

use std::cell::RefCell;
use std::sync::Arc;

/// Says whether the computation should end.
pub type Ask = Arc<dyn Fn() -> bool + Send + Sync>;

thread_local! {
    static ASK: RefCell<Option<Ask>> = const { RefCell::new(None) };
}

/// Does work on this thread that may be ended; without an `ask` it may not.
///
/// ```
/// use carom_special::interrupt::{is_wanted, under};
/// use std::sync::Arc;
/// let mut rounds = 0;
/// under(Some(Arc::new(|| true)), || {
///     while !is_wanted() {
///         rounds += 1;
///     }
/// });
/// assert!(rounds == 0 && !is_wanted());
/// ```
pub fn under<T>(ask: Option<Ask>, work: impl FnOnce() -> T) -> T {
    struct Before(Option<Ask>);
    impl Drop for Before {
        fn drop(&mut self) {
            ASK.set(self.0.take());
        }
    }
    let _before = Before(ASK.replace(ask));
    work()
}

/// What this thread asks, for work that it gives to other threads.
#[must_use]
pub fn asked() -> Option<Ask> {
    ASK.with_borrow(Clone::clone)
}

/// Whether the computation should end.
#[must_use]
pub fn is_wanted() -> bool {
    asked().is_some_and(|ask| ask())
}
