//! Contacts that twist.

use carom::laws::law::{ContactLaw, Energies as _, Shift};
use carom::laws::torsion::law::{ShiftTwistLaw, TorsionLaw};
use carom::laws::torsion::lubkin::Lubkin;
use carom::prelude::Friction;
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Numbers, of_one};
use crate::error::Fault;
use crate::hertz::Hertz;

/// A contact that twists about its normal: Lubkin's law with memory, on an ellipse scaled to its initial
/// stiffness and sliding torque. Copies, but does not pickle.
#[pyclass(module = "carom", subclass)]
#[derive(Debug, Clone)]
pub(crate) struct Twist(TorsionLaw);

#[pymethods]
impl Twist {
    #[new]
    fn new(hertz: Hertz, friction: f64) -> PyResult<Self> {
        let friction = Friction::new(friction).map_err(Fault::from)?;
        Ok(Self(TorsionLaw::new(&hertz.0, friction).map_err(Fault::from)?))
    }

    /// Goes straight to a new approach (m) and twist (radians) and returns (M_z, F_z), N m and N.
    #[pyo3(signature = (zeta, omega=0.0))]
    fn advance(&mut self, zeta: f64, omega: f64) -> PyResult<(f64, f64)> {
        let shift = Shift { zeta, omega, ..Shift::default() };
        let load = self.0.advance(shift).map_err(Fault::from)?;
        Ok((load.m_z, load.f_z))
    }

    /// The radius of the stick area over that of the contact.
    #[getter]
    fn stick_radius(&self) -> f64 {
        self.0.stick_radius()
    }

    /// The elastic energy, compression included, J.
    #[getter]
    fn stored_energy(&self) -> f64 {
        self.0.stored_energy()
    }

    /// The energy turned into heat since the beginning, J.
    #[getter]
    fn dissipated(&self) -> f64 {
        self.0.dissipated()
    }

    fn __copy__(&self) -> Self {
        self.clone()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.clone()
    }
}

/// A contact that shifts and twists, each as if the other were absent: right as long as one is small.
/// Copies, but does not pickle.
#[pyclass(module = "carom", subclass)]
#[derive(Debug, Clone)]
pub(crate) struct ShiftTwist(ShiftTwistLaw);

#[pymethods]
impl ShiftTwist {
    #[new]
    fn new(hertz: Hertz, friction: f64) -> PyResult<Self> {
        let friction = Friction::new(friction).map_err(Fault::from)?;
        Ok(Self(ShiftTwistLaw::new(&hertz.0, friction).map_err(Fault::from)?))
    }

    /// Goes straight to a new shift (m) and twist (radians) and returns (F_x, F_y, F_z, M_z), N and N m.
    #[pyo3(signature = (zeta, xi=0.0, eta=0.0, omega=0.0))]
    fn advance(
        &mut self,
        zeta: f64,
        xi: f64,
        eta: f64,
        omega: f64,
    ) -> PyResult<(f64, f64, f64, f64)> {
        let load = self.0.advance(Shift { zeta, xi, eta, omega }).map_err(Fault::from)?;
        Ok((load.f_x, load.f_y, load.f_z, load.m_z))
    }

    /// The elastic energy, compression included, J.
    #[getter]
    fn stored_energy(&self) -> f64 {
        self.0.stored_energy()
    }

    /// The energy turned into heat since the beginning, J.
    #[getter]
    fn dissipated(&self) -> f64 {
        self.0.dissipated()
    }

    fn __copy__(&self) -> Self {
        self.clone()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.clone()
    }
}

/// Lubkin's twist of a virgin contact: "torque" or "stick_radius" at a dimensionless twist.
#[pyfunction]
pub(crate) fn lubkin<'py>(
    py: Python<'py>,
    what: &str,
    twist: Numbers<'py>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let of: fn(&Lubkin) -> f64 = match what {
        "torque" => Lubkin::torque,
        "stick_radius" => Lubkin::stick_radius,
        _ => return Err(PyValueError::new_err(format!("no `{what}` of a twist"))),
    };
    of_one(py, &twist, |twist| Ok(of(&Lubkin::at_twist(twist)?)))
}
