//! Many contacts with memory.

use std::sync::atomic::{AtomicBool, Ordering};

use carom::laws::law::{ContactLaw as _, Dissipative as _, Shift};
use carom::laws::memory::Fixed;
use carom::laws::rings::RingLaw;
use carom::laws::shift_law::ShiftLaw;
use carom::laws::turning_law::TurningLaw;
use carom::special::interrupt::asked;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _, PyReadwriteArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::arrays::{Numbers, Rows, same_length};
use crate::error::Fault;
use crate::hertz::Given;
use crate::quantities::{Friction, In, StaticFriction, Tolerance};
use crate::room;
use crate::threads::{beside, without_python};
use crate::told::Watch;
use crate::walked::{Constants, Member};

/// Capacity of the history of each contact, in load reversals.
const VERTICES: usize = 16;
/// The tolerance of contacts, if none is given.
const TOLERANCE: f64 = 1e-2;
/// Steps between two questions for an interrupt.
const ASKS_EVERY: usize = 256;
/// Steps that take less than a second, and how much longer one by rings takes.
const MANY: usize = 1 << 23;
const RINGS: usize = 100;
/// Least number of contacts for a thread.
const SHARE: usize = 256;

type Law<V> = ShiftLaw<V, Fixed<V, VERTICES>>;

#[derive(Debug)]
enum Laws {
    Line(Vec<Law<f64>>),
    Plane(Vec<Law<[f64; 2]>>),
    Rings(Vec<RingLaw>),
}

/// Evaluates one expression for each kind of law.
macro_rules! of_any {
    ($laws:expr, $member:ident => $what:expr) => {
        match $laws {
            Laws::Line($member) => $what,
            Laws::Plane($member) => $what,
            Laws::Rings($member) => $what,
        }
    };
}

/// Many contacts with the same constants, advanced together.
#[pyclass(module = "carom._carom")]
#[derive(Debug)]
pub(crate) struct Contacts {
    constants: Constants,
    threads: bool,
    laws: Laws,
    watch: Watch,
}

#[pymethods]
impl Contacts {
    #[new]
    #[pyo3(signature = (
        count, stiffness, friction, law=TurningLaw::default().name().to_owned(), tolerance=None, static_friction=None, directions=2,
        threads=false
    ))]
    #[allow(clippy::too_many_arguments)] // named ones, in Python
    fn new(
        count: usize,
        stiffness: Given,
        friction: In<Friction>,
        law: String,
        tolerance: Option<In<Tolerance>>,
        static_friction: Option<In<StaticFriction>>,
        directions: i64,
        threads: bool,
    ) -> PyResult<Self> {
        let constants =
            Constants::new(stiffness, friction, law, (tolerance, TOLERANCE), static_friction);
        let laws = match directions {
            1 => {
                constants.refuse_tolerance("in one direction the law is exact")?;
                Laws::Line(equal(&constants.law()?, count)?)
            }
            2 if constants.is_of_rings() => Laws::Rings(equal(&constants.rings()?, count)?),
            2 => Laws::Plane(equal(&constants.law()?, count)?),
            _ => {
                let text = format!("directions = {directions}: must be 1 or 2");
                return Err(PyValueError::new_err(text));
            }
        };
        let watch = constants.watch()?;
        Ok(Self { constants, threads, laws, watch })
    }

    fn __len__(&self) -> usize {
        of_any!(&self.laws, laws => laws.len())
    }

    /// Advances each contact along its path of `steps` shifts; arrays of contacts times steps, flattened.
    /// Writes the loads, (F_x, F_y, F_z) of each, with M_z where omega is given.
    #[allow(clippy::too_many_arguments)] // named ones, in Python
    fn follow<'py>(
        &mut self,
        py: Python<'py>,
        steps: usize,
        zeta: Numbers<'py>,
        xi: Numbers<'py>,
        eta: Option<Numbers<'py>>,
        omega: Option<Numbers<'py>>,
        mut loads: PyReadwriteArray1<'py, f64>,
    ) -> PyResult<()> {
        let count = self.__len__() * steps;
        let path = Path { steps, zeta: zeta.as_slice()?, xi: xi.as_slice()?, eta: &[], omega: &[] };
        let eta = eta.as_ref().map(Numbers::as_slice).transpose()?;
        same_length("zeta", path.zeta.len(), count)?;
        same_length("xi", path.xi.len(), count)?;
        same_length("eta", eta.map_or(count, <[f64]>::len), count)?;
        let omega = omega.as_ref().map(Numbers::as_slice).transpose()?;
        same_length("omega", omega.map_or(count, <[f64]>::len), count)?;
        if omega.is_some() && !matches!(self.laws, Laws::Rings(_)) {
            return Err(PyValueError::new_err("omega: for law = 'rings' only"));
        }
        let path = Path { eta: eta.unwrap_or(&[]), omega: omega.unwrap_or(&[]), ..path };
        let loads = loads.as_slice_mut()?;
        same_length("loads", loads.len(), path.width() * count)?;
        of_any!(&self.laws, laws => path.check(laws)?);
        self.watch.see(py, path.zeta, steps)?;
        let before = if self.lasts(count) { self.__copy__().ok() } else { None };
        let (threads, laws) = (self.threads, &mut self.laws);
        let ends = before.is_some();
        let walk = || of_any!(laws, laws => path.follow(laws, loads, threads, ends));
        let walked = if threads { beside(py, walk) } else { without_python(py, walk) };
        match (walked, before) {
            (Err(error), Some(before)) => {
                self.laws = before.laws;
                Err(error)
            }
            // Without a copy the way back is unknown: an interrupt then comes after the last step.
            (walked, _) => walked,
        }
    }

    /// The present loads (F_x, F_y, F_z), N, an array (n, 3).
    #[getter]
    fn loads<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let loads = of_any!(&self.laws, laws => present(laws)?);
        PyArray1::from_vec(py, loads).reshape([self.__len__(), 3])
    }

    /// The elastic energy of each contact, compression included, J.
    #[getter]
    fn stored_energy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let energies = of_any!(&self.laws, laws => told(laws, |law| [law.stored_energy()])?);
        Ok(PyArray1::from_vec(py, energies))
    }

    /// The present torques about the normal M_z, N m; nonzero for law 'rings' only.
    #[getter]
    fn torques<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let torques = of_any!(&self.laws, laws => told(laws, |law| [law.load().m_z])?);
        Ok(PyArray1::from_vec(py, torques))
    }

    /// Upper bound of the change of R_x by coupling, which the law neglects; None if unknown.
    #[getter]
    fn coupling_bound(&self) -> PyResult<Option<f64>> {
        self.constants.coupling_bound()
    }

    fn __copy__(&self) -> PyResult<Self> {
        let laws = match &self.laws {
            Laws::Line(laws) => Laws::Line(copied(laws)?),
            Laws::Plane(laws) => Laws::Plane(copied(laws)?),
            Laws::Rings(laws) => Laws::Rings(copied(laws)?),
        };
        let (constants, watch) = (self.constants.clone(), self.watch.clone());
        Ok(Self { constants, threads: self.threads, laws, watch })
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> PyResult<Self> {
        self.__copy__()
    }

    #[allow(clippy::type_complexity)] // the arguments of `__new__`
    fn __getnewargs__(&self) -> (usize, Given, f64, String, Option<f64>, Option<f64>, usize, bool) {
        let (stiffness, friction, law, tolerance, at_rest) = self.constants.arguments();
        let directions = if matches!(self.laws, Laws::Line(_)) { 1 } else { 2 };
        (self.__len__(), stiffness, friction, law, tolerance, at_rest, directions, self.threads)
    }

    fn __getstate__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let each = self.constants.numbers(VERTICES);
        let numbers = of_any!(&self.laws, laws => packed(laws, each));
        PyArray1::from_vec(py, numbers?).reshape([self.__len__(), each])
    }

    fn __setstate__(&mut self, numbers: Rows<'_>) -> PyResult<()> {
        let (numbers, each) = (numbers.as_slice()?, self.constants.numbers(VERTICES));
        same_length("state", numbers.len(), self.__len__() * each)?;
        of_any!(&mut self.laws, laws => unpack(laws, numbers, each)?);
        Ok(())
    }

    fn __repr__(&self) -> String {
        format!("Contacts({})", self.__len__())
    }
}

/// Paths of many contacts, one after the other.
#[derive(Clone, Copy)]
struct Path<'a> {
    steps: usize,
    zeta: &'a [f64],
    xi: &'a [f64],
    /// Empty if not given.
    eta: &'a [f64],
    /// Empty if not given.
    omega: &'a [f64],
}

impl Contacts {
    /// Whether so many steps may take a second, so that an interrupt is worth a copy of all contacts.
    fn lasts(&self, steps: usize) -> bool {
        let each = if matches!(self.laws, Laws::Rings(_)) { RINGS } else { 1 };
        steps.saturating_mul(each) > MANY
    }
}

impl Path<'_> {
    #[inline]
    fn at(&self, i: usize) -> Shift {
        let or_zero = |of: &[f64]| of.get(i).copied().unwrap_or(0.0);
        let (eta, omega) = (or_zero(self.eta), or_zero(self.omega));
        Shift { zeta: self.zeta[i], xi: self.xi[i], eta, omega }
    }

    /// Number of components of a load.
    const fn width(&self) -> usize {
        if self.omega.is_empty() { 3 } else { 4 }
    }

    /// Checks that no shift is out of range.
    fn check<L: Member>(&self, laws: &[L]) -> Result<(), Fault> {
        let Some(law) = laws.first() else { return Ok(()) };
        (0..self.zeta.len()).try_for_each(|i| {
            law.check(self.at(i)).map_err(|error| match self.steps {
                1 => Fault::from(error).at(i),
                steps => Fault::from(error).at_step(i / steps, i % steps),
            })
        })
    }

    /// Advances all contacts along their paths, which are checked; an interrupt ends that where it may.
    fn follow<L: Member>(&self, laws: &mut [L], loads: &mut [f64], threads: bool, ends: bool) {
        if self.steps == 0 {
            return;
        }
        let (steps, width) = (self.steps, self.width());
        let ask = if ends { asked() } else { None };
        let is_wanted = || ask.as_ref().is_some_and(|ask| ask());
        let is_ended = AtomicBool::new(false);
        let walk = |(contact, (law, loads)): (usize, (&mut L, &mut [f64]))| {
            if is_ended.load(Ordering::Relaxed) {
                return;
            }
            for (step, load) in loads.chunks_exact_mut(width).enumerate() {
                if (contact * steps + step).is_multiple_of(ASKS_EVERY) && is_wanted() {
                    // Contacts that begin at no question end, too.
                    is_ended.store(true, Ordering::Relaxed);
                    return;
                }
                if let Ok(got) = law.advance(self.at(contact * steps + step)) {
                    load.copy_from_slice(&[got.f_x, got.f_y, got.f_z, got.m_z][..width]); // cannot fail: checked above
                }
            }
        };
        match threads {
            false => laws
                .iter_mut()
                .zip(loads.chunks_exact_mut(width * steps))
                .enumerate()
                .for_each(walk),
            true => {
                let share = (SHARE / steps).max(1);
                let laws = laws.par_iter_mut().with_min_len(share);
                laws.zip(loads.par_chunks_exact_mut(width * steps)).enumerate().for_each(walk);
            }
        }
    }
}

/// `count` contacts in the same state.
fn equal<L: Member>(law: &L, count: usize) -> Result<Vec<L>, Fault> {
    let mut laws = room::vector("count", count)?;
    laws.resize(count, law.clone());
    Ok(laws)
}

fn copied<L: Member>(laws: &[L]) -> Result<Vec<L>, Fault> {
    let mut others = room::vector("count", laws.len())?;
    others.extend_from_slice(laws);
    Ok(others)
}

/// `N` numbers of each contact, one contact after the other.
fn told<L: Member, const N: usize>(
    laws: &[L],
    tell: impl Fn(&L) -> [f64; N],
) -> Result<Vec<f64>, Fault> {
    let mut numbers = room::vector("count", N * laws.len())?;
    numbers.extend(laws.iter().flat_map(tell));
    Ok(numbers)
}

fn present<L: Member>(laws: &[L]) -> Result<Vec<f64>, Fault> {
    told(laws, |law| {
        let load = law.load();
        [load.f_x, load.f_y, load.f_z]
    })
}

fn packed<L: Member>(laws: &[L], each: usize) -> Result<Vec<f64>, Fault> {
    let mut numbers = room::vector("count", laws.len() * each)?;
    numbers.resize(laws.len() * each, 0.0);
    for (law, numbers) in laws.iter().zip(numbers.chunks_exact_mut(each)) {
        law.write(numbers)?;
    }
    Ok(numbers)
}

/// Reads the states of all contacts; if one is not valid, none is changed.
fn unpack<L: Member>(laws: &mut [L], numbers: &[f64], each: usize) -> Result<(), Fault> {
    if let Some(mut probe) = laws.first().cloned() {
        for (i, numbers) in numbers.chunks_exact(each).enumerate() {
            probe.read(numbers).map_err(|error| Fault::from(error).at(i))?;
        }
    }
    for (law, numbers) in laws.iter_mut().zip(numbers.chunks_exact(each)) {
        law.read(numbers)?; // cannot fail: tried above
    }
    Ok(())
}
