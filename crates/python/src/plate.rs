//! Plates.

use carom::halfspace::operator::PlateSymbol;
use carom::special::WordError;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::Fault;
use crate::mistakes::needed;
use crate::quantities::{In, arguments};
use crate::show::{self, Quantity, repr};

arguments! {
    SideA "a" "m",
    SideB "b" "m",
    Thickness "thickness" "m",
}

const QUANTITIES: &[Quantity] = &[
    ("a", "m", "side along x"),
    ("b", "m", "side along y"),
    ("thickness", "m", "thickness"),
    ("theory", "", "theory of the displacement"),
];

/// A rectangular plate of constant thickness, simply supported at its edges.
///
/// Plate(a, b, thickness, theory="layer"): sides along x and y and thickness in m. The theory is "layer" (the
/// elastic body itself, from bending to the half-space), "sum" (bending and a half-space added), "kirchhoff"
/// (bending alone) or "mindlin" (bending and shear).
#[pyclass(frozen, eq, from_py_object, module = "carom")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Plate {
    pub(crate) plate: carom::halfspace::operator::Plate,
    pub(crate) theory: PlateSymbol,
}

#[pymethods]
impl Plate {
    #[new]
    #[pyo3(
        signature = (a=None, b=None, thickness=None, theory="layer", **others),
        text_signature = "(a, b, thickness, theory='layer')"
    )]
    fn new(
        py: Python<'_>,
        a: Option<In<SideA>>,
        b: Option<In<SideB>>,
        thickness: Option<In<Thickness>>,
        theory: &str,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        needed!(py, "", others; a, b, thickness);
        let plate = carom::halfspace::operator::Plate::new(a.0, b.0, thickness.0);
        let plate = plate.map_err(Fault::from)?;
        let theory =
            theory.parse().map_err(|error: WordError| PyValueError::new_err(error.to_string()))?;
        Ok(Self { plate, theory })
    }

    /// The side along x, m.
    #[getter]
    fn a(&self) -> f64 {
        self.plate.a()
    }

    /// The side along y, m.
    #[getter]
    fn b(&self) -> f64 {
        self.plate.b()
    }

    /// The thickness, m.
    #[getter]
    fn thickness(&self) -> f64 {
        self.plate.thickness()
    }

    /// The theory of the displacement.
    #[getter]
    fn theory(&self) -> &'static str {
        self.theory.name()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let [a, b, h] = [self.a(), self.b(), self.thickness()].map(|side| repr(py, side));
        Ok(format!("Plate({}, {}, {}, '{}')", a?, b?, h?, self.theory.name()))
    }

    fn _repr_html_(slf: &Bound<'_, Self>) -> PyResult<String> {
        show::html(slf, QUANTITIES)
    }

    fn __getnewargs__(&self) -> (f64, f64, f64, &'static str) {
        (self.a(), self.b(), self.thickness(), self.theory.name())
    }
}
