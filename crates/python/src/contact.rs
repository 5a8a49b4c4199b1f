//! One contact with memory.

use carom::laws::law::Shift;
use carom::laws::turning_law::TurningLaw;
use carom::prelude::{ContactLoad, RangeError};
use carom::special::interrupt::is_wanted;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::same_length;
use crate::error::Fault;
use crate::hertz::Given;
use crate::mistakes::needed;
use crate::quantities::{
    Angle, Argument, Eta, Friction, In, Omega, R, StaticFriction, Tolerance, Xi, Zeta, line,
};
use crate::show::{self, Quantity, repr};
use crate::threads::without_python;
use crate::told::Watch;
use crate::walked::{Accounts, Arguments, Constants, VERTICES, Walked};

const QUANTITIES: &[Quantity] = &[
    ("regime", "", "regime of the last step"),
    ("shift", "m", "zeta, xi, eta"),
    ("load", "N", "F_x, F_y, F_z"),
    ("torque", "N m", "about the normal"),
    ("sticking", "", "share of the contact area that sticks"),
    ("stored_energy", "J", "elastic energy"),
    ("dissipated", "J", "heat since the beginning"),
];

/// The tolerance of a contact, if none is given.
const TOLERANCE: f64 = 1e-3;

/// A contact with memory: rigid shifts in, loads out.
///
/// Contact(stiffness, friction, law='coulomb', tolerance=None, static_friction=None, heat=True): `stiffness` is a
/// Hertz contact or (c_x, c_y, c_z), N/m^1.5; `friction` is from 0 to infinity (no slip). With a `static_friction`
/// above it the contact sticks or slips in part up to f_s F_z, and slides as a whole with f_k = `friction`; not
/// for law 'rings'.
///
/// `law='coulomb'` applies the exact return mapping at each depth of the contact, to a `tolerance` of the
/// friction limit, by default 1e-3; the 64 pieces of its memory hold about 1e-5. `law='fixed-direction'` has no tolerance and gives a slip annulus one direction of traction. On straight paths
/// both are exact. They remember at most 64 load reversals, neglect the coupling of normal and tangential
/// displacements of dissimilar materials, which may change R_x of an impact by `coupling_bound`, and do not
/// take a twist.
///
/// `law='rings'` includes coupling and twist for circular contacts: approach, shift and twist act together on
/// concentric rings, with a mean error of .01 of the friction limit. It needs a Hertz contact.
///
/// Where the path turns, computing the heat of a step costs up to a thousand times as much as the step
/// itself; `heat=False` skips it, and `dissipated` and `slip_turn` are None. Contacts can be copied and pickled; a contact
/// from a pickle agrees to round-off.
#[pyclass(module = "carom", subclass)]
#[derive(Debug, Clone)]
pub(crate) struct Contact {
    constants: Constants,
    law: Walked,
    watch: Watch,
}

#[pymethods]
impl Contact {
    #[new]
    #[pyo3(
        signature = (
            stiffness=None, friction=None, law=TurningLaw::default().name().to_owned(), tolerance=None,
            static_friction=None, *, heat=true, **others
        ),
        text_signature =
            "(stiffness, friction, law='coulomb', tolerance=None, static_friction=None, *, heat=True)"
    )]
    #[allow(clippy::too_many_arguments)] // named ones, in Python
    fn new(
        py: Python<'_>,
        stiffness: Option<Given>,
        friction: Option<In<Friction>>,
        law: String,
        tolerance: Option<In<Tolerance>>,
        static_friction: Option<In<StaticFriction>>,
        heat: bool,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        needed!(py, "", others; stiffness, friction);
        let constants =
            Constants::new(stiffness, friction, law, (tolerance, TOLERANCE), static_friction);
        let law = Walked::new(&constants, None, heat.then_some((0.0, None)))?;
        let watch = constants.watch()?;
        Ok(Self { constants, law, watch })
    }

    /// Moves the contact straight to a new shift (m) and returns the load (F_x, F_y, F_z), N.
    ///
    /// zeta is the approach, xi and eta are the shifts of body 2 against body 1 along x and y, omega is the
    /// twist about the normal in radians, for law 'rings' only: u = xi + y omega. A zeta that is not positive
    /// separates the bodies, and the history is lost. A failed step leaves the contact as it was.
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
    ) -> PyResult<(f64, f64, f64)> {
        needed!(py, "advance", others; zeta);
        let shift = Shift { zeta: zeta.0, xi: xi.0, eta: eta.0, omega: omega.0 };
        let load = self.watch.advance(py, &mut self.law, shift, |law| law.advance(shift))?;
        Ok(triple(load))
    }

    /// Moves the contact along a path and returns the loads (F_x, F_y, F_z) at each of its points, an array
    /// (n, 3).
    ///
    /// xi and eta are arrays as long as zeta, or None for zeros. If a step of the path fails, the contact
    /// stays as it was before the path. With omega, for law 'rings' only, the loads are (F_x, F_y, F_z, M_z),
    /// an array (n, 4).
    #[pyo3(
        signature = (zeta=None, xi=None, eta=None, omega=None, **others),
        text_signature = "($self, zeta, xi=None, eta=None, omega=None)"
    )]
    fn follow<'py>(
        &mut self,
        py: Python<'py>,
        zeta: Option<&Bound<'py, PyAny>>,
        xi: Option<&Bound<'py, PyAny>>,
        eta: Option<&Bound<'py, PyAny>>,
        omega: Option<&Bound<'py, PyAny>>,
        others: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        needed!(py, "follow", others; zeta);
        let zeta = path::<Zeta>(zeta)?;
        let width = if omega.is_some() { 4 } else { 3 };
        let (xi, eta) = (across::<Xi>(xi, zeta.len())?, across::<Eta>(eta, zeta.len())?);
        let omega = across::<Omega>(omega, zeta.len())?;
        let mut law = self.law.clone();
        let walk = || -> Result<(Walked, Vec<f64>), Fault> {
            let mut loads = Vec::with_capacity(width * zeta.len());
            for (i, zeta) in zeta.iter().enumerate() {
                if i % 64 == 0 && is_wanted() {
                    return Err(Fault::interrupted());
                }
                let shift = Shift { zeta: *zeta, xi: xi[i], eta: eta[i], omega: omega[i] };
                let load = law.advance(shift).map_err(|error| Fault::from(error).at(i))?;
                loads.extend(&[load.f_x, load.f_y, load.f_z, load.m_z][..width]);
            }
            Ok((law, loads))
        };
        let (law, loads) = without_python(py, walk)??;
        let greatest = zeta.iter().copied().fold(0.0, f64::max);
        self.watch.see(py, &[greatest], 1)?;
        self.law = law;
        PyArray1::from_vec(py, loads).reshape([zeta.len(), width])
    }

    /// The present load (F_x, F_y, F_z), N.
    #[getter]
    fn load(&self) -> (f64, f64, f64) {
        triple(self.law.load())
    }

    /// The present torque about the normal M_z, the integral of y t_x - x t_y, N m; nonzero for law 'rings'
    /// only.
    #[getter]
    fn torque(&self) -> f64 {
        self.law.load().m_z
    }

    /// Upper bound of the change of R_x by the coupling of dissimilar materials, which the law neglects. 0
    /// for like materials and for law 'rings', None for unknown materials.
    #[getter]
    fn coupling_bound(&self) -> PyResult<Option<f64>> {
        self.constants.coupling_bound()
    }

    /// The present shift (zeta, xi, eta), m.
    #[getter]
    fn shift(&self) -> (f64, f64, f64) {
        let Shift { zeta, xi, eta, .. } = self.law.shift();
        (zeta, xi, eta)
    }

    /// The elastic energy of the contact, compression included, J.
    #[getter]
    fn stored_energy(&self) -> f64 {
        self.law.stored_energy()
    }

    /// The energy turned into heat, or released by a receding edge, since the beginning, J; None with
    /// `heat=False`.
    #[getter]
    fn dissipated(&self) -> Option<f64> {
        self.law.dissipated()
    }

    /// The regime of the last step: 'separated', 'adhesion', 'release', 'slip', 'reversal', 'overlay' or
    /// 'sliding'.
    #[getter]
    fn regime(&self) -> PyResult<String> {
        self.law.regime()
    }

    /// The share of the contact area that sticks.
    #[getter]
    fn sticking(&self) -> PyResult<f64> {
        self.law.sticking()
    }

    /// The largest angle (radians) by which the direction of slip has turned within an annulus since that last
    /// stuck: 0 while nothing slips. On paths that turn, the distance of the law from elastic half-spaces grows
    /// with it, but is not bounded by it. None with `heat=False`; not for law 'rings'.
    #[getter]
    fn slip_turn(&self) -> PyResult<Option<f64>> {
        self.law.slip_turn()
    }

    /// The tangent stiffness: derivatives of (F_x, F_y, F_z), rows, by (xi, eta, zeta), columns, N/m. Not for
    /// law 'rings'.
    #[getter]
    fn tangent(&self) -> PyResult<[[f64; 3]; 3]> {
        Ok(self.law.shift_law()?.tangent())
    }

    /// The traction over the friction limit at the centre of the contact, as a function of the elliptical
    /// radius r = sqrt(x^2/a^2 + y^2/b^2); None without friction or with infinite friction. Not for law
    /// 'rings'.
    #[pyo3(signature = (r=None, **others), text_signature = "($self, r)")]
    fn traction(
        &self,
        py: Python<'_>,
        r: Option<In<R>>,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Option<(f64, f64)>> {
        needed!(py, "traction", others; r);
        Ok(self.law.shift_law()?.traction(r.0 * r.0).map(|[x, y]| (x, y)))
    }

    /// Rotates the contact axes by an angle (radians, from x to y); the state is transformed to the new axes.
    /// Not for law 'rings'.
    #[pyo3(signature = (angle=None, **others), text_signature = "($self, angle)")]
    fn turn_frame(
        &mut self,
        py: Python<'_>,
        angle: Option<In<Angle>>,
        others: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<()> {
        needed!(py, "turn_frame", others; angle);
        RangeError::finite("angle", angle.0).map_err(Fault::from)?;
        self.law.turn_frame(angle.0)
    }

    fn __copy__(&self) -> Self {
        self.clone()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.clone()
    }

    fn __getnewargs__(&self) -> Arguments {
        self.constants.arguments()
    }

    fn __getstate__(&self) -> PyResult<(Vec<f64>, Option<Accounts>)> {
        let mut numbers = vec![0.0; self.constants.numbers(VERTICES)];
        self.law.pack(&mut numbers)?;
        Ok((numbers, self.law.accounts()))
    }

    fn __setstate__(&mut self, state: (Vec<f64>, Option<Accounts>)) -> PyResult<()> {
        let (numbers, accounts) = state;
        self.law = Walked::new(&self.constants, Some(&numbers), accounts)?;
        Ok(())
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!("Contact({}, F = {} N)", self.regime()?, repr(py, self.load())?))
    }

    fn _repr_html_(slf: &Bound<'_, Self>) -> PyResult<String> {
        show::html(slf, QUANTITIES)
    }
}

/// The numbers of a path.
fn path<A: Argument>(given: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    line(A::NAME, given, A::UNIT)
}

/// As many numbers, or zeros.
fn across<A: Argument>(given: Option<&Bound<'_, PyAny>>, count: usize) -> PyResult<Vec<f64>> {
    let Some(given) = given else { return Ok(vec![0.0; count]) };
    let line = path::<A>(given)?;
    same_length(A::NAME, line.len(), count)?;
    Ok(line)
}

fn triple(ContactLoad { f_x, f_y, f_z, .. }: ContactLoad) -> (f64, f64, f64) {
    (f_x, f_y, f_z)
}
