//! Errors as Python exceptions.

use pyo3::exceptions::{PyException, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyString;

mod classes {
    use super::{PyException, PyValueError};

    pyo3::create_exception!(
        carom,
        RangeError,
        PyValueError,
        "A value is out of range: `field` names it, `value` is it, `index` is its place in an array: an entry, or \
         (contact, step) on paths, or None."
    );
    pyo3::create_exception!(
        carom,
        CaromError,
        PyException,
        "Raised if something cannot be computed: bodies that do not touch, an impact that does not converge."
    );
}

pub(crate) use classes::{CaromError, RangeError};

/// An error, with its place in an array if there is one.
#[derive(Debug)]
pub(crate) struct Fault {
    place: Option<Place>,
    kind: Kind,
}

#[derive(Debug, Clone, Copy)]
enum Place {
    Entry(usize),
    /// A contact, and a step of its path.
    Step(usize, usize),
}

#[derive(Debug)]
enum Kind {
    Range(carom::prelude::RangeError),
    Other(String),
}

impl Fault {
    /// A computation that failed for another reason than a value out of range.
    pub(crate) fn other(error: impl std::fmt::Display) -> Self {
        Self { place: None, kind: Kind::Other(error.to_string()) }
    }

    /// A computation that was ended, which is told by the exception of the signal.
    pub(crate) fn interrupted() -> Self {
        Self::other("interrupted")
    }

    /// The same error at an entry of an array.
    pub(crate) fn at(self, index: usize) -> Self {
        Self { place: Some(Place::Entry(index)), ..self }
    }

    /// The same error at a step of the path of a contact.
    pub(crate) fn at_step(self, contact: usize, step: usize) -> Self {
        Self { place: Some(Place::Step(contact, step)), ..self }
    }
}

impl From<carom::prelude::RangeError> for Fault {
    fn from(error: carom::prelude::RangeError) -> Self {
        Self { place: None, kind: Kind::Range(error) }
    }
}

impl From<Fault> for PyErr {
    fn from(Fault { place, kind }: Fault) -> Self {
        let at = match place {
            None => String::new(),
            Some(Place::Entry(index)) => format!(" (entry {index})"),
            Some(Place::Step(contact, step)) => format!(" (contact {contact}, step {step})"),
        };
        let range = match kind {
            Kind::Other(text) => return CaromError::new_err(format!("{text}{at}")),
            Kind::Range(range) => range,
        };
        Python::attach(|py| {
            let error = RangeError::new_err(format!("{range}{at}"));
            let value = error.value(py);
            // If the attributes cannot be set, the text of the exception still says everything.
            let _ = value.setattr("field", PyString::new(py, range.field));
            let _ = value.setattr("value", range.value);
            let _ = match place {
                None => value.setattr("index", py.None()),
                Some(Place::Entry(index)) => value.setattr("index", index),
                Some(Place::Step(contact, step)) => value.setattr("index", (contact, step)),
            };
            error
        })
    }
}

impl From<carom::impact::oblique::ObliqueError> for Fault {
    fn from(error: carom::impact::oblique::ObliqueError) -> Self {
        Self::other(error)
    }
}

/// Conversions of error types that may hold a range error.
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
    carom_cases::solve::ChosenError:
        carom_cases::solve::ChosenError::Main(carom::solver::FrictionalError::Range(error))
        | carom_cases::solve::ChosenError::Normal(carom::solver::NormalError::Range(error)) => error;
    carom::laws::curvature::CurvatureError: carom::laws::curvature::CurvatureError::Range(error) => error;
    carom::geometry::SurfaceError: carom::geometry::SurfaceError::Range(error) => error;
    carom::solver::NormalError: carom::solver::NormalError::Range(error) => error;
    carom::halfspace::operator::OperatorError:
        carom::halfspace::operator::OperatorError::Range(error) => error;
    carom::solver::FrictionalError: carom::solver::FrictionalError::Range(error) => error;
    carom::special::hypergeometric::HypergeometricError:
        carom::special::hypergeometric::HypergeometricError::Range(error) => error;
}
