//! Functions over arrays of numbers.

use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::ops::Range;

use crate::error::Fault;
use crate::room;
use crate::threads::without_python;

/// Entries that a thread takes at least, of functions that take a microsecond.
const SHARE: usize = 1024;
/// Shares from which on all threads help.
const MANY: usize = 8;
/// Shares between two looks whether the program is interrupted.
const BLOCK: usize = 128;

pub(crate) type Numbers<'py> = PyReadonlyArray1<'py, f64>;
pub(crate) type Rows<'py> = PyReadonlyArray2<'py, f64>;

/// The value of `f` at each of `count` places, without the interpreter, on all threads if they are
/// many; the fault is that of the first place that has one. Whoever interrupts the program need not wait for
/// the end.
pub(crate) fn map<T: Send>(
    py: Python<'_>,
    count: usize,
    f: impl Fn(usize) -> Result<T, Fault> + Sync + Send,
) -> PyResult<Vec<T>> {
    map_by(SHARE, py, count, f)
}

/// The same where a thread takes at least so many.
pub(crate) fn map_by<T: Send>(
    share: usize,
    py: Python<'_>,
    count: usize,
    f: impl Fn(usize) -> Result<T, Fault> + Sync + Send,
) -> PyResult<Vec<T>> {
    let at = |i: usize| f(i).map_err(|fault| fault.at(i));
    let mut values = room::vector("count", count)?;
    while values.len() < count {
        let block = values.len()..count.min(values.len() + BLOCK * share);
        values.extend(without_python(py, || over(block, share, &at))?);
        py.check_signals()?;
    }
    Ok(values)
}

fn over<T: Send>(
    block: Range<usize>,
    share: usize,
    at: &(impl Fn(usize) -> Result<T, Fault> + Sync + Send),
) -> Result<Vec<T>, Fault> {
    if block.len() < MANY * share {
        return block.map(at).collect();
    }
    let places = block.clone().into_par_iter().with_min_len(share);
    let all: Result<Vec<T>, Fault> = places.map(at).collect();
    let first = || block.into_par_iter().find_map_first(|i| at(i).err());
    all.map_err(|any| first().unwrap_or(any))
}

/// The same for numbers, as an array.
pub(crate) fn numbers<'py>(
    py: Python<'py>,
    count: usize,
    f: impl Fn(usize) -> Result<f64, Fault> + Sync + Send,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    Ok(PyArray1::from_vec(py, map(py, count, f)?))
}

/// The same for a function of one argument.
pub(crate) fn of_one<'py>(
    py: Python<'py>,
    x: &Numbers<'py>,
    f: impl Fn(f64) -> Result<f64, Fault> + Sync + Send,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let x = x.as_slice()?;
    numbers(py, x.len(), |i| f(x[i]))
}

/// The same for a function of two.
pub(crate) fn of_two<'py>(
    py: Python<'py>,
    x: &Numbers<'py>,
    y: &Numbers<'py>,
    f: impl Fn(f64, f64) -> Result<f64, Fault> + Sync + Send,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let (x, y) = (x.as_slice()?, y.as_slice()?);
    same_length("the second argument", y.len(), x.len())?;
    numbers(py, x.len(), |i| f(x[i], y[i]))
}

/// An array must have so many entries.
pub(crate) fn same_length(name: &str, length: usize, expected: usize) -> PyResult<()> {
    if length == expected {
        return Ok(());
    }
    let text = format!("{name} has {length} entries: must have {expected}");
    Err(PyValueError::new_err(text))
}
