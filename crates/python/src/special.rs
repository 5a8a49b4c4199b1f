//! Special functions.

use carom::special::elliptic::{Amplitude, complete as of_ellipse, incomplete as up_to};
use carom::special::hypergeometric::{Gauss, ThreeFTwo, UnitArgument};
use carom::special::{AxisRatio, gamma as gammas};
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Numbers, of_one, of_two};
use crate::error::Fault;

type Array<'py> = PyResult<Bound<'py, PyArray1<f64>>>;

/// The complete elliptic integral K, E, B, C or D, chosen by its letter.
#[pyfunction]
pub(crate) fn complete<'py>(py: Python<'py>, letter: &str, ratio: Numbers<'py>) -> Array<'py> {
    let function: fn(AxisRatio) -> f64 = match letter {
        "k" => of_ellipse::k,
        "e" => of_ellipse::e,
        "d" => of_ellipse::d,
        "b" => of_ellipse::b,
        "c" => of_ellipse::c,
        _ => return Err(unknown(letter)),
    };
    of_one(py, &ratio, |ratio| Ok(function(AxisRatio::new(ratio)?)))
}

/// The incomplete elliptic integral F, E or D, chosen by its letter.
#[pyfunction]
pub(crate) fn incomplete<'py>(
    py: Python<'py>,
    letter: &str,
    ratio: Numbers<'py>,
    phi: Numbers<'py>,
) -> Array<'py> {
    let function: fn(AxisRatio, Amplitude) -> f64 = match letter {
        "f" => up_to::f,
        "e" => up_to::e,
        "d" => up_to::d,
        _ => return Err(unknown(letter)),
    };
    of_two(py, &ratio, &phi, |ratio, phi| {
        Ok(function(AxisRatio::new(ratio)?, Amplitude::from_angle(phi)?))
    })
}

fn unknown(letter: &str) -> PyErr {
    PyValueError::new_err(format!("unknown elliptic integral `{letter}`"))
}

/// The gamma function.
#[pyfunction]
pub(crate) fn gamma<'py>(py: Python<'py>, x: Numbers<'py>) -> Array<'py> {
    of_one(py, &x, |x| Ok(gammas::gamma(x)))
}

/// The logarithm of the gamma function.
#[pyfunction]
pub(crate) fn ln_gamma<'py>(py: Python<'py>, x: Numbers<'py>) -> Array<'py> {
    of_one(py, &x, |x| Ok(gammas::ln_gamma(x)))
}

/// Gauss's hypergeometric function.
#[pyfunction]
pub(crate) fn hyp2f1<'py>(py: Python<'py>, a: f64, b: f64, c: f64, x: Numbers<'py>) -> Array<'py> {
    let function = Gauss::new(a, b, c).map_err(Fault::from)?;
    of_one(py, &x, |x| Ok(function.at(UnitArgument::new(x)?)?))
}

/// The function 3F2(s, a, b; s + 1, c; x).
#[pyfunction]
pub(crate) fn hyp3f2<'py>(
    py: Python<'py>,
    s: f64,
    a: f64,
    b: f64,
    c: f64,
    x: Numbers<'py>,
) -> Array<'py> {
    let function = ThreeFTwo::new(s, a, b, c).map_err(Fault::from)?;
    of_one(py, &x, |x| Ok(function.at(UnitArgument::new(x)?)?))
}
