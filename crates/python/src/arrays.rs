//! Functions over arrays of numbers.

use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::ops::Range;

use crate::error::Fault;
use crate::room;
use crate::threads::without_python;

/// Least number of entries for a thread, in functions of about a microsecond an entry.
const SHARE: usize = 1024;
/// Number of shares from which on all threads are used.
const MANY: usize = 8;
/// Number of shares between two checks for an interrupt.
const BLOCK: usize = 128;

pub(crate) type Numbers<'py> = PyReadonlyArray1<'py, f64>;
pub(crate) type Rows<'py> = PyReadonlyArray2<'py, f64>;

/// Evaluates `f` at each of `count` indices, without the interpreter and, if there are many, on all threads.
/// An error is that of the first index that has one. An interrupt ends the call early.
pub(crate) fn map<T: Send>(
    py: Python<'_>,
    count: usize,
    f: impl Fn(usize) -> Result<T, Fault> + Sync + Send,
) -> PyResult<Vec<T>> {
    map_by(SHARE, py, count, f)
}

/// Like `map`, with a given least number of entries for a thread.
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

/// Like `map`, for a function whose values are numbers, as an array.
pub(crate) fn numbers<'py>(
    py: Python<'py>,
    count: usize,
    f: impl Fn(usize) -> Result<f64, Fault> + Sync + Send,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    Ok(PyArray1::from_vec(py, map(py, count, f)?))
}

/// Like `numbers`, for a function of one array.
pub(crate) fn of_one<'py>(
    py: Python<'py>,
    x: &Numbers<'py>,
    f: impl Fn(f64) -> Result<f64, Fault> + Sync + Send,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let x = x.as_slice()?;
    numbers(py, x.len(), |i| f(x[i]))
}

/// Like `numbers`, for a function of two arrays.
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

/// Checks the length of an array.
pub(crate) fn same_length(name: &str, length: usize, expected: usize) -> PyResult<()> {
    if length == expected {
        return Ok(());
    }
    let text = format!("{name} has {length} entries: must have {expected}");
    Err(PyValueError::new_err(text))
}
