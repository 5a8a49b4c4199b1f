//! Contacts with a twist about the normal.

use carom::laws::accounted::Accounted;
use carom::laws::coulomb::packed_numbers;
use carom::laws::coupling::coupling_bound;
use carom::laws::law::{ContactLaw, Energies as _, Shift};
use carom::laws::shift_law::ShiftLaw;
use carom::laws::torsion::law::{self, ShiftTwistLaw, TorsionLaw};
use carom::laws::torsion::lubkin::Lubkin;
use carom::prelude::Friction;
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Numbers, of_one};
use crate::error::Fault;
use crate::hertz::{Given, Hertz};
use crate::mistakes::needed;
use crate::quantities::{self, Eta, In, Omega, Xi, Zeta};
use crate::show::repr;
use crate::told::Watch;

/// A contact that twists about its normal: Lubkin's solution with memory. An elliptical contact is
/// approximated by a circular one with the same initial stiffness and sliding torque. Can be copied and
/// pickled.
#[pyclass(module = "carom", subclass)]
#[derive(Debug, Clone)]
pub(crate) struct Twist {
    hertz: Hertz,
    friction: f64,
    law: Accounted<TorsionLaw>,
    watch: Watch,
}

#[pymethods]
impl Twist {
    #[new]
    #[pyo3(
        signature = (hertz=None, friction=None, **others),
        text_signature = "(hertz, friction)"
    )]
    fn new(
        py: Python<'_>,
        hertz: Option<Hertz>,
        friction: Option<In<quantities::Friction>>,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        needed!(py, "", others; hertz, friction);
        let friction = friction.0;
        let law = Accounted::new(torsion(&hertz, friction)?);
        let watch = Watch::new(&Given::Hertz(hertz), None);
        Ok(Self { hertz, friction, law, watch })
    }

    /// Moves the contact straight to a new approach (m) and twist (radians) and returns (M_z, F_z), N m and
    /// N.
    #[pyo3(
        signature = (zeta=None, omega=In::ZERO, **others),
        text_signature = "($self, zeta, omega=0.0)"
    )]
    fn advance(
        &mut self,
        py: Python<'_>,
        zeta: Option<In<Zeta>>,
        omega: In<Omega>,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<(f64, f64)> {
        needed!(py, "advance", others; zeta);
        let shift = Shift { zeta: zeta.0, omega: omega.0, ..Shift::default() };
        let load = self.watch.advance(py, &mut self.law, shift, |law| law.advance(shift))?;
        Ok((load.m_z, load.f_z))
    }

    /// The present load (M_z, F_z), N m and N.
    #[getter]
    fn load(&self) -> (f64, f64) {
        let load = self.law.load();
        (load.m_z, load.f_z)
    }

    /// The present approach and twist (zeta, omega), m and radians.
    #[getter]
    fn shift(&self) -> (f64, f64) {
        let Shift { zeta, omega, .. } = self.law.shift();
        (zeta, omega)
    }

    /// The radius of the stick area over that of the contact.
    #[getter]
    fn stick_radius(&self) -> f64 {
        self.law.law().stick_radius()
    }

    /// The elastic energy, compression included, J.
    #[getter]
    fn stored_energy(&self) -> f64 {
        self.law.stored_energy()
    }

    /// The energy turned into heat since the beginning, J.
    #[getter]
    fn dissipated(&self) -> f64 {
        self.law.dissipated()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let (m_z, f_z) = self.load();
        Ok(format!("Twist(M_z = {} N m, F_z = {} N)", repr(py, m_z)?, repr(py, f_z)?))
    }

    fn __copy__(&self) -> Self {
        self.clone()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.clone()
    }

    fn __getnewargs__(&self) -> (Hertz, f64) {
        (self.hertz, self.friction)
    }

    fn __getstate__(&self) -> PyResult<(Vec<f64>, f64)> {
        Ok((numbers_of(self.law.law())?, self.dissipated()))
    }

    fn __setstate__(&mut self, state: (Vec<f64>, f64)) -> PyResult<()> {
        let (numbers, dissipated) = state;
        let mut law = torsion(&self.hertz, self.friction)?;
        law.unpack(&numbers).map_err(Fault::from)?;
        self.law = Accounted::going_on(law, dissipated);
        Ok(())
    }
}

/// A contact with shift and twist, each computed as if the other were absent: accurate while one of them is
/// small. Can be copied and pickled.
#[pyclass(module = "carom", subclass)]
#[derive(Debug, Clone)]
pub(crate) struct ShiftTwist {
    hertz: Hertz,
    friction: f64,
    law: Accounted<ShiftTwistLaw>,
    watch: Watch,
}

/// Capacity of the history of the shift, more than was ever reached.
const VERTICES: usize = 99;

/// The law of twist in its initial state.
fn torsion(hertz: &Hertz, friction: f64) -> Result<TorsionLaw, Fault> {
    Ok(TorsionLaw::new(&hertz.0, Friction::new(friction)?)?)
}

/// All numbers of the packed law of twist.
fn numbers_of(law: &TorsionLaw) -> Result<Vec<f64>, Fault> {
    let pieces = law.history().map_or(2 * VERTICES, |history| history.pieces().max(4));
    let mut numbers = vec![0.0; law::packed_numbers(pieces)];
    law.pack(&mut numbers)?;
    Ok(numbers)
}

#[pymethods]
impl ShiftTwist {
    #[new]
    #[pyo3(
        signature = (hertz=None, friction=None, **others),
        text_signature = "(hertz, friction)"
    )]
    fn new(
        py: Python<'_>,
        hertz: Option<Hertz>,
        friction: Option<In<quantities::Friction>>,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        needed!(py, "", others; hertz, friction);
        let friction = friction.0;
        let friction_law = Friction::new(friction).map_err(Fault::from)?;
        let law = ShiftTwistLaw::new(&hertz.0, friction_law).map_err(Fault::from)?;
        let coupling = coupling_bound(hertz.0.materials().gamma(), friction_law);
        let watch = Watch::new(&Given::Hertz(hertz), Some(coupling));
        Ok(Self { hertz, friction, law: Accounted::new(law), watch })
    }

    /// Moves the contact straight to a new shift (m) and twist (radians) and returns (F_x, F_y, F_z, M_z), N
    /// and N m.
    #[pyo3(
        signature = (zeta=None, xi=In::ZERO, eta=In::ZERO, omega=In::ZERO, **others),
        text_signature = "($self, zeta, xi=0.0, eta=0.0, omega=0.0)"
    )]
    fn advance(
        &mut self,
        py: Python<'_>,
        zeta: Option<In<Zeta>>,
        xi: In<Xi>,
        eta: In<Eta>,
        omega: In<Omega>,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<(f64, f64, f64, f64)> {
        needed!(py, "advance", others; zeta);
        let shift = Shift { zeta: zeta.0, xi: xi.0, eta: eta.0, omega: omega.0 };
        let load = self.watch.advance(py, &mut self.law, shift, |law| law.advance(shift))?;
        Ok((load.f_x, load.f_y, load.f_z, load.m_z))
    }

    /// The present load (F_x, F_y, F_z, M_z), N and N m.
    #[getter]
    fn load(&self) -> (f64, f64, f64, f64) {
        let load = self.law.load();
        (load.f_x, load.f_y, load.f_z, load.m_z)
    }

    /// The present shift (zeta, xi, eta, omega), m and radians.
    #[getter]
    fn shift(&self) -> (f64, f64, f64, f64) {
        let Shift { zeta, xi, eta, omega } = self.law.shift();
        (zeta, xi, eta, omega)
    }

    /// The elastic energy, compression included, J.
    #[getter]
    fn stored_energy(&self) -> f64 {
        self.law.stored_energy()
    }

    /// The energy turned into heat since the beginning, J.
    #[getter]
    fn dissipated(&self) -> f64 {
        self.law.dissipated()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let (f_x, f_y, f_z, m_z) = self.load();
        let force = repr(py, (f_x, f_y, f_z))?;
        Ok(format!("ShiftTwist(F = {force} N, M_z = {} N m)", repr(py, m_z)?))
    }

    fn __copy__(&self) -> Self {
        self.clone()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.clone()
    }

    fn __getnewargs__(&self) -> (Hertz, f64) {
        (self.hertz, self.friction)
    }

    fn __getstate__(&self) -> PyResult<(Vec<f64>, Vec<f64>, f64)> {
        let law = self.law.law();
        let mut of_shift = vec![0.0; 2 * packed_numbers(VERTICES)];
        law.tangential().pack(&mut of_shift).map_err(Fault::from)?;
        Ok((of_shift, numbers_of(law.torsion())?, self.dissipated()))
    }

    fn __setstate__(&mut self, state: (Vec<f64>, Vec<f64>, f64)) -> PyResult<()> {
        let (of_shift, of_twist, dissipated) = state;
        let friction = Friction::new(self.friction).map_err(Fault::from)?;
        let mut shift = ShiftLaw::new(self.hertz.0.stiffness(), friction);
        shift.unpack(&of_shift).map_err(Fault::from)?;
        let mut twist = torsion(&self.hertz, self.friction)?;
        twist.unpack(&of_twist).map_err(Fault::from)?;
        let law = ShiftTwistLaw::of(shift, twist).map_err(Fault::from)?;
        self.law = Accounted::going_on(law, dissipated);
        Ok(())
    }
}

/// Lubkin's solution for the first twist of a contact: "torque" or "stick_radius" at a dimensionless twist.
#[pyfunction]
pub(crate) fn lubkin<'py>(
    py: Python<'py>,
    what: &str,
    twist: Numbers<'py>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let of: fn(&Lubkin) -> f64 = match what {
        "torque" => Lubkin::torque,
        "stick_radius" => Lubkin::stick_radius,
        _ => return Err(PyValueError::new_err(format!("unknown quantity `{what}` of a twist"))),
    };
    of_one(py, &twist, |twist| Ok(of(&Lubkin::at_twist(twist)?)))
}
