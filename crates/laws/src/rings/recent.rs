//! A cache of recent matrices: a sweep has one pair of materials, but one impact for each angle.

use std::any::{Any, TypeId};
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

/// Capacity of the cache. An impact by rings takes two to eight entries; 24 x 16 for any motion takes 0.6 MB
/// each.
const MOST: usize = 24;

type Kept = VecDeque<(TypeId, [u64; 2], Arc<dyn Any + Send + Sync>)>;

static KEPT: Mutex<Kept> = Mutex::new(VecDeque::new());

/// The entry of a key, made if it is not cached. It must depend on type and key alone.
pub(super) fn shared<T: Any + Send + Sync>(key: [u64; 2], make: impl FnOnce() -> T) -> Arc<T> {
    let of = TypeId::of::<T>();
    if let Some(found) = taken(of, key).and_then(|found| found.downcast().ok()) {
        return found;
    }
    // Two threads may make the same entry: neither waits, and both get the same bits.
    let made = Arc::new(make());
    keep(of, key, made.clone());
    made
}

/// Finds an entry and moves it to the front.
fn taken(of: TypeId, key: [u64; 2]) -> Option<Arc<dyn Any + Send + Sync>> {
    // A thread that panicked with the lock held has left complete entries only.
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    let at = kept.iter().position(|(kind, its, _)| (*kind, *its) == (of, key))?;
    let entry = kept.remove(at)?;
    let found = Arc::clone(&entry.2);
    kept.push_front(entry);
    Some(found)
}

fn keep(of: TypeId, key: [u64; 2], made: Arc<dyn Any + Send + Sync>) {
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    kept.push_front((of, key, made));
    kept.truncate(MOST);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_made_lately_is_the_same_object() {
        struct Made(u64);
        let of = |key: u64| shared([key, 7], || Made(key));
        let [one, two] = [of(1), of(1)];
        assert!(Arc::ptr_eq(&one, &two) && one.0 == 1 && of(2).0 == 2);
        for key in 10..10 + MOST as u64 {
            assert_eq!(of(key).0, key);
        }
        assert!(!Arc::ptr_eq(&one, &of(1)));
    }
}
