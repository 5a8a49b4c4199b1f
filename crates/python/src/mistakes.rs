//! Arguments that do not exist.

use carom_cases::case::likely;
use pyo3::PyTypeInfo;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The name that is probably meant, as cases tell it; empty if none is similar.
#[pyfunction]
pub(crate) fn meant(name: &str, valid: Vec<String>) -> String {
    let valid: Vec<&str> = valid.iter().map(String::as_str).collect();
    likely(name, &valid)
}

/// Refuses arguments by name that a class does not have.
pub(crate) fn refuse<T: PyTypeInfo>(
    py: Python<'_>,
    others: Option<&Bound<'_, PyDict>>,
) -> PyResult<()> {
    let Some(name) = others.and_then(|others| others.keys().iter().next()) else { return Ok(()) };
    let mistakes = py.import("carom._mistakes")?;
    Err(PyErr::from_value(mistakes.call_method1("unknown", (T::type_object(py), name))?))
}
