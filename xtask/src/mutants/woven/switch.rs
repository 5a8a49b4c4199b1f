//! Which mutant is on: read from the environment, once; none without it.
#![allow(missing_docs)]

use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering::Relaxed};

const COUNT: usize = 2;
const UNREAD: u32 = u32::MAX;
const REACH: u32 = u32::MAX - 1;

static ON: AtomicU32 = AtomicU32::new(UNREAD);
static REACHED: [AtomicBool; COUNT] = [const { AtomicBool::new(false) }; COUNT];

#[inline]
#[must_use]
pub fn is_on(number: u32) -> bool {
    let on = ON.load(Relaxed);
    if on < REACH { on == number } else { look(number) }
}

#[cold]
#[inline(never)]
fn look(number: u32) -> bool {
    let mut on = ON.load(Relaxed);
    if on == UNREAD {
        on = match std::env::var("CAROM_MUTANT") {
            Ok(number) => number.parse().expect("CAROM_MUTANT is a number"),
            Err(_) if std::env::var_os("CAROM_MUTANT_REACH").is_some() => REACH,
            Err(_) => 0,
        };
        ON.store(on, Relaxed);
    }
    if on == REACH && !REACHED[number as usize].swap(true, Relaxed) {
        let folder = std::env::var_os("CAROM_MUTANT_REACH").expect("the folder of the reach");
        std::fs::write(Path::new(&folder).join(number.to_string()), "").expect("a note of reach");
    }
    on == number
}
