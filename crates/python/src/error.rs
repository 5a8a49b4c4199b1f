//! Errors as Python raises them.

use pyo3::exceptions::{PyException, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyString;

mod classes {
    use super::{PyException, PyValueError};

    pyo3::create_exception!(
        carom,
        RangeError,
        PyValueError,
        "A value is out of range: `field` names it, `value` is it, `index` is its place in an array \
         (or None)."
    );
    pyo3::create_exception!(
        carom,
        CaromError,
        PyException,
        "Something that cannot be computed: bodies that do not touch, an impact that does not settle."
    );
}

pub(crate) use classes::{CaromError, RangeError};

/// What went wrong, and at which entry of an array.
#[derive(Debug)]
pub(crate) struct Fault {
    index: Option<usize>,
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    Range(carom::prelude::RangeError),
    Other(String),
}

impl Fault {
    /// Something that cannot be computed.
    pub(crate) fn other(error: impl std::fmt::Display) -> Self {
        Self { index: None, kind: Kind::Other(error.to_string()) }
    }

    /// The same at an entry of an array.
    pub(crate) fn at(self, index: usize) -> Self {
        Self { index: Some(index), ..self }
    }
}

impl From<carom::prelude::RangeError> for Fault {
    fn from(error: carom::prelude::RangeError) -> Self {
        Self { index: None, kind: Kind::Range(error) }
    }
}

impl From<Fault> for PyErr {
    fn from(Fault { index, kind }: Fault) -> Self {
        let at = index.map(|index| format!(" (entry {index})")).unwrap_or_default();
        let range = match kind {
            Kind::Other(text) => return CaromError::new_err(format!("{text}{at}")),
            Kind::Range(range) => range,
        };
        Python::attach(|py| {
            let error = RangeError::new_err(format!("{range}{at}"));
            let value = error.value(py);
            // An exception has room for attributes; if not, its text says all.
            let _ = value.setattr("field", PyString::new(py, range.field));
            let _ = value.setattr("value", range.value);
            let _ = value.setattr("index", index);
            error
        })
    }
}

impl From<carom::impact::oblique::ObliqueError> for Fault {
    fn from(error: carom::impact::oblique::ObliqueError) -> Self {
        Self::other(error)
    }
}

/// Errors of carom that hold a range error or another.
macro_rules! fault_of {
    ($($error:ty: $range:pat => $inner:expr;)*) => {
        $(impl From<$error> for Fault {
            fn from(error: $error) -> Self {
                match error {
                    $range => $inner.into(),
                    error => Self::other(error),
                }
            }
        })*
    };
}

fault_of! {
    carom::impact::CollisionError: carom::impact::CollisionError::Range(error) => error;
    carom::numerical::CollisionLawError:
        carom::numerical::CollisionLawError::Collision(carom::impact::CollisionError::Range(error)) => error;
    carom::impact::RingImpactError: carom::impact::RingImpactError::Range(error) => error;
    carom::impact::restitution::RestitutionError:
        carom::impact::restitution::RestitutionError::Range(error) => error;
    carom::laws::curvature::CurvatureError: carom::laws::curvature::CurvatureError::Range(error) => error;
    carom::geometry::SurfaceError: carom::geometry::SurfaceError::Range(error) => error;
    carom::solver::FrictionalError: carom::solver::FrictionalError::Range(error) => error;
    carom::special::hypergeometric::HypergeometricError:
        carom::special::hypergeometric::HypergeometricError::Range(error) => error;
}
