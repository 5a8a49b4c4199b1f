//! Texts of objects, with numbers as Python prints them.

use pyo3::IntoPyObjectExt as _;
use pyo3::prelude::*;

/// Name, unit and meaning of an attribute.
pub(crate) type Quantity = (&'static str, &'static str, &'static str);

/// What Python's `repr` gives.
pub(crate) fn repr<'py>(py: Python<'py>, value: impl IntoPyObject<'py>) -> PyResult<String> {
    value.into_bound_py_any(py)?.repr()?.extract()
}

/// Attributes of an object as an HTML table, for notebooks.
pub(crate) fn html(thing: &Bound<'_, PyAny>, quantities: &[Quantity]) -> PyResult<String> {
    let show = thing.py().import("carom._show")?;
    show.call_method1("html_of", (thing, quantities.to_vec()))?.extract()
}
