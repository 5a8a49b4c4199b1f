//! Room in memory for what an argument asks for, and an error where there is none.

use carom::halfspace::room;
use carom::prelude::RangeError;
use pyo3::prelude::*;

use crate::error::Fault;

/// Bytes that are taken without asking the system, which takes some ten microseconds.
const FEW: u128 = 1 << 24;
const ALLOWED: &str = "so many as the memory holds";

/// Ok if `count` things of `each` bytes, of the argument `field`, fit into the memory that is free.
pub(crate) fn check(field: &'static str, count: usize, each: usize) -> Result<(), Fault> {
    let bytes = count as u128 * each as u128;
    RangeError::check(field, count as f64, bytes <= FEW || bytes <= room::available(), ALLOWED)?;
    Ok(())
}

/// An empty vector with room for `count` things of the argument `field`.
pub(crate) fn vector<T>(field: &'static str, count: usize) -> Result<Vec<T>, Fault> {
    check(field, count, size_of::<T>())?;
    let mut values = Vec::new();
    // The room may have gone since it was asked for.
    RangeError::check(field, count as f64, values.try_reserve_exact(count).is_ok(), ALLOWED)?;
    Ok(values)
}

/// Bytes that this process can allocate now.
#[pyfunction]
pub(crate) fn available_room() -> u128 {
    room::available()
}
