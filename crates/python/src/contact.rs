//! One contact with memory.

use carom::laws::accounted::Accounted;
use carom::laws::coulomb::{Tolerance, packed_numbers};
use carom::laws::law::{Checked as _, ContactLaw as _, Dissipative as _, Energies as _, Shift};
use carom::laws::memory::{Fixed, Lateral, VertexStack};
use carom::laws::shift_law::ShiftLaw;
use carom::laws::turning_law::TurningLaw;
use carom::prelude::{ContactLoad, ContactStiffness, Friction, RangeError};
use carom::special::WordError;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Numbers, same_length};
use crate::error::Fault;

/// Vertices of the memory.
const VERTICES: usize = 64;

type Law = ShiftLaw<[f64; 2], Fixed<[f64; 2], VERTICES>>;

/// The law of a word.
pub(crate) fn turning_law(word: &str) -> PyResult<TurningLaw> {
    word.parse().map_err(|error: WordError| PyValueError::new_err(error.to_string()))
}

/// What a contact was made of.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Constants {
    pub(crate) stiffness: ContactStiffness,
    pub(crate) friction: f64,
    pub(crate) law: String,
    pub(crate) tolerance: f64,
}

impl Constants {
    pub(crate) fn law<V: Lateral, S: VertexStack<V>>(&self) -> PyResult<ShiftLaw<V, S>> {
        let friction = Friction::new(self.friction).map_err(Fault::from)?;
        let law = turning_law(&self.law)?;
        let tolerance = match law {
            TurningLaw::Coulomb => Tolerance::new(self.tolerance).map_err(Fault::from)?,
            TurningLaw::FixedDirection => Tolerance::FINE,
        };
        Ok(ShiftLaw::chosen(law, self.stiffness, friction, tolerance))
    }

    /// Numbers that a state of so many vertices takes; without slip a vertex takes more.
    pub(crate) fn numbers(&self, vertices: usize) -> usize {
        match self.friction == f64::INFINITY {
            true => 6 + 9 * vertices,
            false => packed_numbers(vertices),
        }
    }

    /// As they are given to `__new__`.
    pub(crate) fn arguments(&self) -> ((f64, f64, f64), f64, String, f64) {
        let ContactStiffness { c_x, c_y, c_z } = self.stiffness;
        ((c_x, c_y, c_z), self.friction, self.law.clone(), self.tolerance)
    }
}

/// The law, with an account of the heat where it is asked for.
#[derive(Debug, Clone, Copy)]
enum Walked {
    Bare(Law),
    Accounted(Accounted<Law>),
}

impl Walked {
    fn new(law: Law, dissipated: Option<f64>) -> Self {
        match dissipated {
            Some(dissipated) => Self::Accounted(Accounted::going_on(law, dissipated)),
            None => Self::Bare(law),
        }
    }

    fn law(&self) -> &Law {
        match self {
            Self::Bare(law) => law,
            Self::Accounted(accounted) => accounted.law(),
        }
    }

    fn dissipated(&self) -> Option<f64> {
        match self {
            Self::Bare(_) => None,
            Self::Accounted(accounted) => Some(accounted.dissipated()),
        }
    }

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        match self {
            Self::Bare(law) => law.advance(shift),
            Self::Accounted(accounted) => accounted.advance(shift),
        }
    }

    fn turn_frame(&mut self, angle: f64) {
        match self {
            Self::Bare(law) => law.turn_frame(angle),
            Self::Accounted(accounted) => accounted.turn_frame(angle),
        }
    }
}

/// A contact with memory: rigid shifts in, loads out.
///
/// Contact(stiffness, friction, law='coulomb', tolerance=1e-3, heat=True): `stiffness` is a Hertz contact or
/// (c_x, c_y, c_z), N/m^1.5; `friction` is from 0 to infinity (no slip). `law` is 'coulomb', where each ring of
/// the contact slips by itself, to a `tolerance` of the friction limit, or 'fixed-direction', one direction
/// of traction in a slip ring. On straight paths both are exact. At most 64 vertices are remembered.
/// The heat of a step costs up to a thousand times the step itself where the path turns: without `heat` there
/// is no `dissipated`. Contacts copy, and pickle: one from a pickle sums its forces anew, which is round-off.
#[pyclass(module = "carom", subclass)]
#[derive(Debug, Clone)]
pub(crate) struct Contact {
    constants: Constants,
    law: Walked,
}

#[pymethods]
impl Contact {
    #[new]
    #[pyo3(signature = (stiffness, friction, law="coulomb".to_owned(), tolerance=1e-3, *, heat=true))]
    fn new(
        #[pyo3(from_py_with = crate::hertz::stiffness)] stiffness: ContactStiffness,
        friction: f64,
        law: String,
        tolerance: f64,
        heat: bool,
    ) -> PyResult<Self> {
        let constants = Constants { stiffness, friction, law, tolerance };
        let law = Walked::new(constants.law()?, heat.then_some(0.0));
        Ok(Self { constants, law })
    }

    /// Goes straight to a new shift (m) and returns the load (F_x, F_y, F_z), N.
    ///
    /// zeta is the approach, xi and eta are the shifts of body 2 against body 1 along x and y. A zeta
    /// that is not positive separates the bodies: the memory is lost. A failed step leaves the
    /// contact as it was.
    #[pyo3(signature = (zeta, xi=0.0, eta=0.0))]
    fn advance(&mut self, zeta: f64, xi: f64, eta: f64) -> PyResult<(f64, f64, f64)> {
        let shift = Shift { zeta, xi, eta, omega: 0.0 };
        Ok(triple(self.law.advance(shift).map_err(Fault::from)?))
    }

    /// Goes along a path and returns the loads (F_x, F_y, F_z) at each of its points, an array (n, 3).
    ///
    /// xi and eta are arrays as long as zeta, or None for zeros. A path that cannot be gone to its end is
    /// not gone at all.
    #[pyo3(signature = (zeta, xi=None, eta=None))]
    fn follow<'py>(
        &mut self,
        py: Python<'py>,
        zeta: &Bound<'py, PyAny>,
        xi: Option<&Bound<'py, PyAny>>,
        eta: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let zeta = line("zeta", zeta)?;
        let across = |name, given: Option<&Bound<'py, PyAny>>| {
            let Some(given) = given else { return Ok(vec![0.0; zeta.len()]) };
            let line = line(name, given)?;
            same_length(name, line.len(), zeta.len())?;
            PyResult::Ok(line)
        };
        let (xi, eta) = (across("xi", xi)?, across("eta", eta)?);
        let mut law = self.law;
        let walk = || -> Result<(Walked, Vec<f64>), Fault> {
            let mut loads = Vec::with_capacity(3 * zeta.len());
            for (i, ((zeta, xi), eta)) in zeta.iter().zip(&xi).zip(&eta).enumerate() {
                let shift = Shift { zeta: *zeta, xi: *xi, eta: *eta, omega: 0.0 };
                let load = law.advance(shift).map_err(|error| Fault::from(error).at(i))?;
                loads.extend([load.f_x, load.f_y, load.f_z]);
            }
            Ok((law, loads))
        };
        let (law, loads) = py.detach(walk)?;
        self.law = law;
        PyArray1::from_vec(py, loads).reshape([zeta.len(), 3])
    }

    /// The present load (F_x, F_y, F_z), N.
    #[getter]
    fn load(&self) -> (f64, f64, f64) {
        triple(self.law.law().load())
    }

    /// The present shift (zeta, xi, eta), m.
    #[getter]
    fn shift(&self) -> (f64, f64, f64) {
        let Shift { zeta, xi, eta, .. } = self.law.law().shift();
        (zeta, xi, eta)
    }

    /// The elastic energy of the contact, compression included, J.
    #[getter]
    fn stored_energy(&self) -> f64 {
        self.law.law().stored_energy()
    }

    /// The energy turned into heat, or released by a receding edge, since the beginning, J; None without
    /// `heat`.
    #[getter]
    fn dissipated(&self) -> Option<f64> {
        self.law.dissipated()
    }

    /// What the last step did: 'separated', 'adhesion', 'release', 'slip', 'reversal', 'overlay' or
    /// 'sliding'.
    #[getter]
    fn regime(&self) -> String {
        format!("{:?}", self.law.law().regime()).to_lowercase()
    }

    /// The share of the contact area that sticks.
    #[getter]
    fn sticking(&self) -> f64 {
        self.law.law().stick_depth()
    }

    /// The derivatives of (F_x, F_y, F_z), rows, by (xi, eta, zeta), columns, N/m.
    #[getter]
    fn tangent(&self) -> [[f64; 3]; 3] {
        self.law.law().tangent()
    }

    /// The traction over the greatest friction, at the elliptical radius r = sqrt(x^2/a^2 + y^2/b^2);
    /// None without friction or without slip.
    fn traction(&self, r: f64) -> Option<(f64, f64)> {
        self.law.law().traction(r * r).map(|[x, y]| (x, y))
    }

    /// Turns the contact axes by an angle (radians, from x to y): what is remembered is expressed in the
    /// new ones.
    fn turn_frame(&mut self, angle: f64) -> PyResult<()> {
        RangeError::finite("angle", angle).map_err(Fault::from)?;
        self.law.turn_frame(angle);
        Ok(())
    }

    fn __copy__(&self) -> Self {
        self.clone()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.clone()
    }

    fn __getnewargs__(&self) -> ((f64, f64, f64), f64, String, f64) {
        self.constants.arguments()
    }

    fn __getstate__(&self) -> PyResult<(Vec<f64>, Option<f64>)> {
        let mut numbers = vec![0.0; self.constants.numbers(VERTICES)];
        self.law.law().pack(&mut numbers).map_err(Fault::from)?;
        Ok((numbers, self.dissipated()))
    }

    fn __setstate__(&mut self, state: (Vec<f64>, Option<f64>)) -> PyResult<()> {
        let (numbers, dissipated) = state;
        let mut law: Law = self.constants.law()?;
        law.unpack(&numbers).map_err(Fault::from)?;
        self.law = Walked::new(law, dissipated);
        Ok(())
    }

    fn __repr__(&self) -> String {
        let (f_x, f_y, f_z) = self.load();
        format!("Contact({}, F = ({f_x:e}, {f_y:e}, {f_z:e}) N)", self.regime())
    }
}

/// Real numbers in a line, of any kind.
fn line(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    let read = given.py().import("carom._arrays")?.call_method1("path", (name, given))?;
    let numbers: Numbers<'_> = read.extract()?;
    Ok(numbers.as_slice()?.to_vec())
}

fn triple(ContactLoad { f_x, f_y, f_z, .. }: ContactLoad) -> (f64, f64, f64) {
    (f_x, f_y, f_z)
}

/// The first shift where a law cannot go.
pub(crate) fn check<V: Lateral, S: VertexStack<V>>(
    law: &ShiftLaw<V, S>,
    shift: Shift,
    index: usize,
) -> Result<(), Fault> {
    law.check(shift).map_err(|error| Fault::from(error).at(index))
}
