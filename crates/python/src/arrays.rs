//! Functions over arrays of numbers.

use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::error::Fault;

/// Entries from which on all threads help.
const MANY: usize = 8192;
/// Entries that a thread takes at least.
const SHARE: usize = 1024;

pub(crate) type Numbers<'py> = PyReadonlyArray1<'py, f64>;
pub(crate) type Rows<'py> = PyReadonlyArray2<'py, f64>;

/// The value of `f` at each of `count` places, without the interpreter, on all threads if they are
/// many; the fault is that of the first place that has one.
pub(crate) fn map<T: Send>(
    py: Python<'_>,
    count: usize,
    f: impl Fn(usize) -> Result<T, Fault> + Sync + Send,
) -> PyResult<Vec<T>> {
    let at = |i: usize| f(i).map_err(|fault| fault.at(i));
    let result = py.detach(|| {
        if count < MANY {
            return (0..count).map(at).collect();
        }
        let places = (0..count).into_par_iter().with_min_len(SHARE);
        let all: Result<Vec<T>, Fault> = places.map(at).collect();
        all.map_err(|any| (0..count).find_map(|i| at(i).err()).unwrap_or(any))
    });
    Ok(result?)
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
