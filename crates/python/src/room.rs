//! Checks that there is enough memory for what an argument asks, and raises an error if not.

use carom::halfspace::room;
use carom::prelude::RangeError;
use pyo3::prelude::*;

use crate::error::Fault;

/// Allocations up to this number of bytes are not checked: a check takes some ten microseconds.
const FEW: u128 = 1 << 24;
const ALLOWED: &str = "few enough for the free memory";

/// Checks that `count` items of `each` bytes, requested by the argument `field`, fit into the free memory.
pub(crate) fn check(field: &'static str, count: usize, each: usize) -> Result<(), Fault> {
    let bytes = count as u128 * each as u128;
    RangeError::check(field, count as f64, bytes <= FEW || bytes <= room::available(), ALLOWED)?;
    Ok(())
}

/// An empty vector with room for `count` items, requested by the argument `field`.
pub(crate) fn vector<T>(field: &'static str, count: usize) -> Result<Vec<T>, Fault> {
    check(field, count, size_of::<T>())?;
    let mut values = Vec::new();
    // The memory may have been taken since the check.
    RangeError::check(field, count as f64, values.try_reserve_exact(count).is_ok(), ALLOWED)?;
    Ok(values)
}

/// Bytes that this process can allocate now.
#[pyfunction]
pub(crate) fn available_room() -> u128 {
    room::available()
}
