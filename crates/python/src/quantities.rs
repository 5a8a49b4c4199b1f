//! Numbers as arguments. What is no plain number goes by `carom._arrays`, where quantities that carry a unit are
//! converted or refused; errors name the argument.

use std::marker::PhantomData;

use numpy::PyArrayDescrMethods as _;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyInt, PyList, PyTuple, PyType};

use crate::arrays::Numbers;

/// Name and unit of an argument.
pub(crate) trait Argument {
    const NAME: &'static str;
    /// As packages of units read it; empty for a plain number.
    const UNIT: &'static str;
}

/// Arguments with their names and units. Those of one module stand in it, those of several below.
macro_rules! arguments {
    ($($argument:ident $name:literal $unit:literal,)*) => {
        $(
            #[derive(Debug, Clone, Copy)]
            pub(crate) struct $argument;
            impl $crate::quantities::Argument for $argument {
                const NAME: &'static str = $name;
                const UNIT: &'static str = $unit;
            }
        )*
    };
}

pub(crate) use arguments;

arguments! {
    Accuracy "accuracy" "",
    Angle "angle" "rad",
    Eta "eta" "m",
    Friction "friction" "",
    Normal "normal" "",
    Omega "omega" "rad",
    R "r" "",
    StaticFriction "static_friction" "",
    Tolerance "tolerance" "",
    Xi "xi" "m",
    Zeta "zeta" "m",
}

/// The number of an argument, in its unit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct In<A>(pub(crate) f64, PhantomData<A>);

impl<A> In<A> {
    pub(crate) const ZERO: Self = Self::of(0.0);

    /// A default value.
    pub(crate) const fn of(number: f64) -> Self {
        Self(number, PhantomData)
    }
}

impl<'py, A: Argument> FromPyObject<'_, 'py> for In<A> {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let number = match is_plain(&given) {
            true => given.extract(),
            false => read("number", A::NAME, &given, A::UNIT)?.extract(),
        };
        number.map(Self::of)
    }
}

/// The numbers of an argument, one or a list, in its unit.
#[derive(Debug, Clone)]
pub(crate) struct Several<A>(pub(crate) Vec<f64>, PhantomData<A>);

impl<'py, A: Argument> FromPyObject<'_, 'py> for Several<A> {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let numbers = match is_plain_row(&given) {
            true => given.extract()?,
            false => read("row", A::NAME, &given, A::UNIT)?
                .extract::<Numbers<'_>>()?
                .as_slice()?
                .to_vec(),
        };
        Ok(Self(numbers, PhantomData))
    }
}

/// So many numbers of an argument, in its unit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Row<A, const N: usize>(pub(crate) [f64; N], PhantomData<A>);

impl<A, const N: usize> Row<A, N> {
    /// A default value.
    pub(crate) const fn of(numbers: [f64; N]) -> Self {
        Self(numbers, PhantomData)
    }
}

impl<'py, A: Argument, const N: usize> FromPyObject<'_, 'py> for Row<A, N> {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let numbers = Several::<A>::extract(given)?.0;
        let wrong = |other: Vec<f64>| {
            let text = format!("{}: must be {N} numbers, not {other:?}", A::NAME);
            PyValueError::new_err(text)
        };
        numbers.try_into().map(Self::of).map_err(wrong)
    }
}

/// A one-dimensional array of real numbers in this unit, from any Python object.
pub(crate) fn line(name: &str, given: &Bound<'_, PyAny>, unit: &str) -> PyResult<Vec<f64>> {
    let numbers: Numbers<'_> = read("path", name, given, unit)?.extract()?;
    Ok(numbers.as_slice()?.to_vec())
}

/// Whether this is a number of a type without units.
fn is_plain(given: &Bound<'_, PyAny>) -> bool {
    static NUMPY: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let py = given.py();
    given.is_exact_instance_of::<PyFloat>()
        || given.is_exact_instance_of::<PyInt>()
        || given.get_type().is(NUMPY.get_or_init(py, || numpy::dtype::<f64>(py).typeobj().unbind()))
}

fn is_plain_row(given: &Bound<'_, PyAny>) -> bool {
    if let Ok(tuple) = given.cast::<PyTuple>() {
        return tuple.iter().all(|one| is_plain(&one));
    }
    given.cast::<PyList>().is_ok_and(|list| list.iter().all(|one| is_plain(&one)))
}

/// What this function of `carom._arrays` makes of an argument.
fn read<'py>(
    function: &str,
    name: &str,
    given: &Bound<'py, PyAny>,
    unit: &str,
) -> PyResult<Bound<'py, PyAny>> {
    given.py().import("carom._arrays")?.call_method1(function, (name, given, unit))
}
