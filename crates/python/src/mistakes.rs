//! Arguments that do not exist, or are missing.

use carom_cases::case::likely;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyType};

/// The name that is probably meant, as cases tell it; empty if none is similar.
#[pyfunction]
pub(crate) fn meant(name: &str, valid: Vec<String>) -> String {
    let valid: Vec<&str> = valid.iter().map(String::as_str).collect();
    likely(name, &valid)
}

/// What a quantity of this name is called now; None if it was not renamed.
#[pyfunction]
pub(crate) fn renamed(name: &str) -> Option<&'static str> {
    carom::table::renamed(name)
}

/// Refuses arguments by name that the method of a class does not have; without a method, the class itself.
pub(crate) fn refuse(
    class: &Bound<'_, PyType>,
    method: &str,
    others: Option<&Bound<'_, PyDict>>,
) -> PyResult<()> {
    match others.and_then(|others| others.keys().iter().next()) {
        Some(name) => Err(error("unknown", class, method, name)),
        None => Ok(()),
    }
}

/// The error of a call without arguments that it needs: of these names, those that are not there.
pub(crate) fn lacking(class: &Bound<'_, PyType>, method: &str, needed: &[(&str, bool)]) -> PyErr {
    let absent = needed.iter().filter(|(_, is_there)| !is_there).map(|(name, _)| *name);
    error("lacking", class, method, absent.collect::<Vec<_>>())
}

/// An error of the Python side, which knows what the method takes.
fn error<'py>(
    kind: &str,
    class: &Bound<'py, PyType>,
    method: &str,
    told: impl IntoPyObject<'py>,
) -> PyErr {
    let make = || {
        let made = if method.is_empty() { class.as_any() } else { &class.getattr(method)? };
        let mistakes = class.py().import("carom._mistakes")?;
        mistakes.call_method1(kind, (made, told))
    };
    make().map_or_else(|error| error, PyErr::from_value)
}

/// Takes the arguments that a call needs out of their options, or returns an error that names what does not fit:
/// `needed!(py, "advance", others; zeta)` in a method, with an empty name where the class is made.
macro_rules! needed {
    ($py:expr, $method:literal, $others:expr; $($name:ident),+) => {
        if $others.is_some() {
            let class = <Self as pyo3::PyTypeInfo>::type_object($py);
            $crate::mistakes::refuse(&class, $method, $others)?;
        }
        let needed = [$((stringify!($name), $name.is_some())),+];
        let ($(Some($name),)+) = ($($name,)+) else {
            let class = <Self as pyo3::PyTypeInfo>::type_object($py);
            return Err($crate::mistakes::lacking(&class, $method, &needed));
        };
    };
}
pub(crate) use needed;
