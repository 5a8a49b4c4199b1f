//! Functions over arrays of numbers.

use carom::special::interrupt::{asked, is_wanted, under};
use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::ops::Range;

use crate::error::Fault;
use crate::room;
use crate::threads::{beside, without_python};

/// Least number of entries for a thread, in functions of about a microsecond an entry.
const SHARE: usize = 1024;
/// Number of shares from which on all threads are used.
const MANY: usize = 8;
/// Number of shares for which a thread is begun.
const BLOCK: usize = 128;
/// Questions for an interrupt in a share.
const ASKS: usize = 16;

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
    let mut values = room::vector("count", count)?;
    if count < MANY * share {
        let all = || {
            for i in 0..count {
                values.push(at_entry(&f, i, share, is_wanted)?);
            }
            Ok::<_, Fault>(values)
        };
        return Ok(without_python(py, all)??);
    }
    while values.len() < count {
        let block = values.len()..count.min(values.len() + BLOCK * share);
        let over = || {
            let ask = asked();
            let is_wanted = || ask.as_ref().is_some_and(|ask| ask());
            // What lasts may ask itself.
            let at = |i| match share {
                SHARE => at_entry(&f, i, share, is_wanted),
                _ => under(ask.clone(), || at_entry(&f, i, share, is_wanted)),
            };
            over(block, share, &at)
        };
        values.extend(beside(py, over)??);
    }
    Ok(values)
}

/// The value at an index. Asks for an interrupt from time to time.
fn at_entry<T>(
    f: &impl Fn(usize) -> Result<T, Fault>,
    i: usize,
    share: usize,
    is_wanted: impl Fn() -> bool,
) -> Result<T, Fault> {
    if i.is_multiple_of(share.div_ceil(ASKS)) && is_wanted() {
        return Err(Fault::interrupted());
    }
    f(i).map_err(|fault| fault.at(i))
}

fn over<T: Send>(
    block: Range<usize>,
    share: usize,
    at: &(impl Fn(usize) -> Result<T, Fault> + Sync + Send),
) -> Result<Vec<T>, Fault> {
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

/// Like `numbers`, for a function of three arrays.
pub(crate) fn of_three<'py>(
    py: Python<'py>,
    [x, y, z]: [&Numbers<'py>; 3],
    f: impl Fn(f64, f64, f64) -> Result<f64, Fault> + Sync + Send,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let (x, y, z) = (x.as_slice()?, y.as_slice()?, z.as_slice()?);
    same_length("the second argument", y.len(), x.len())?;
    same_length("the third argument", z.len(), x.len())?;
    numbers(py, x.len(), |i| f(x[i], y[i], z[i]))
}

/// Checks the length of an array.
pub(crate) fn same_length(name: &str, length: usize, expected: usize) -> PyResult<()> {
    if length == expected {
        return Ok(());
    }
    let text = format!("{name} has {length} entries: must have {expected}");
    Err(PyValueError::new_err(text))
}
