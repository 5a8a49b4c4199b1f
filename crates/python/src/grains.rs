//! Whole contacts of many pairs of grains: motions in, loads out.

use carom::laws::coulomb::Tolerance;
use carom::laws::damping::HertzDamping;
use carom::laws::grains::{
    Grain, GrainContact, GrainLaw, GrainLoad, GrainRoll, Heats, Meeting, Rolling,
    RollingResistance, Surface, TwistState as _, WholeContact, compliance_shares, grain_numbers,
    ring_grain_numbers,
};
use carom::laws::law_name::LawName;
use carom::laws::memory::Fixed;
use carom::laws::rings::{self, RingLaw};
use carom::laws::shift_law::ShiftLaw;
use carom::laws::torsion::law::{StoredTwist, TorsionLaw};
use carom::prelude::{Friction, RangeError};
use carom::special::WordError;
use numpy::{PyArray1, PyArray2, PyArrayMethods as _};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Rows, same_length};
use crate::error::Fault;
use crate::hertz::{Given, Hertz};
use crate::room;
use crate::threads::without_python;
use crate::told::Watch;

/// Load reversals that a contact keeps.
const VERTICES: usize = 12;
/// Numbers of a body: place, velocity and spin.
const EACH: usize = 9;

type Law = ShiftLaw<[f64; 2], Fixed<[f64; 2], VERTICES>>;

/// Law, relaxation time, restitution, torsion, and stiffness, damping and friction of rolling.
type Options = (String, f64, f64, bool, Option<[f64; 3]>);

/// The parts of a contact.
#[derive(Debug, Clone)]
struct Parts<L: GrainLaw> {
    contact: GrainContact<L>,
    twist: Option<StoredTwist>,
    roll: GrainRoll,
}

#[derive(Debug, Clone)]
enum Contacts {
    Shift(Vec<Parts<Law>>),
    Rings(Vec<Parts<RingLaw>>),
}

/// Evaluates one expression for each kind of law.
macro_rules! of_any {
    ($contacts:expr, $parts:ident => $what:expr) => {
        match $contacts {
            Contacts::Shift($parts) => $what,
            Contacts::Rings($parts) => $what,
        }
    };
}

/// What all contacts have in common.
#[derive(Debug, Clone)]
struct Shared {
    radii: [f64; 2],
    masses: [f64; 2],
    shares: [f64; 2],
    relative_radius: f64,
    rolling: Option<RollingResistance>,
    /// Whether the masses count.
    weighs: bool,
}

/// Whole contacts of many pairs of spheres, or of spheres and walls, advanced together.
#[pyclass(module = "carom._carom")]
#[derive(Debug, Clone)]
pub(crate) struct GrainContacts {
    given: (Hertz, [[f64; 2]; 2], f64, Options),
    shared: Shared,
    contacts: Contacts,
    heats: Heats,
    watch: Watch,
}

#[pymethods]
impl GrainContacts {
    /// `bodies` are both radii and both masses.
    #[new]
    fn new(
        count: usize,
        hertz: Hertz,
        bodies: [[f64; 2]; 2],
        friction: f64,
        options: Options,
    ) -> PyResult<Self> {
        let [radii, masses] = bodies;
        RangeError::positive("radius_1", radii[0]).map_err(Fault::from)?;
        RangeError::check("radius_2", radii[1], radii[1] > 0.0, "> 0").map_err(Fault::from)?;
        let rolling = resistance(options.4).map_err(Fault::from)?;
        let relative_radius = 1.0 / (1.0 / radii[0] + 1.0 / radii[1]);
        let shares = compliance_shares(&hertz.0.materials());
        let weighs = options.2 < 1.0;
        let shared = Shared { radii, masses, shares, relative_radius, rolling, weighs };
        let contacts = contacts(count, &hertz, friction, &options)?;
        let watch = Watch::new(&Given::Hertz(hertz), None);
        let given = (hertz, bodies, friction, options);
        Ok(Self { given, shared, contacts, heats: Heats::default(), watch })
    }

    fn __len__(&self) -> usize {
        of_any!(&self.contacts, parts => parts.len())
    }

    /// Advances all contacts; `bodies` has a row for each body, body 1 and 2 of the first contact first: place, velocity,
    /// spin. Returns force and torques of each.
    fn step<'py>(
        &mut self,
        py: Python<'py>,
        dt: f64,
        bodies: Rows<'py>,
        heat: bool,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let bodies = bodies.as_slice()?;
        same_length("bodies", bodies.len(), 2 * EACH * self.__len__())?;
        RangeError::non_negative("dt", dt).map_err(Fault::from)?;
        let (shared, mut heats, mut contacts) = (&self.shared, self.heats, self.contacts.clone());
        let asked = heat.then_some(&mut heats);
        let walk = || of_any!(&mut contacts, parts => shared.advance(parts, bodies, dt, asked));
        let (loads, approaches) = without_python(py, walk)??;
        self.watch.see(py, &approaches, 1)?;
        (self.contacts, self.heats) = (contacts, heats);
        PyArray1::from_vec(py, loads).reshape([self.__len__(), EACH])
    }

    /// The heat so far of friction, damping and rolling, J.
    #[getter]
    fn heats(&self) -> [f64; 3] {
        [self.heats.friction, self.heats.damping, self.heats.rolling]
    }

    /// The elastic energy of each contact, J.
    #[getter]
    fn stored_energy<'py>(&mut self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let shared = &self.shared;
        let energies: Vec<f64> = of_any!(&mut self.contacts, parts => {
            parts.iter_mut().map(|parts| shared.whole(parts).stored_energy()).collect()
        });
        PyArray1::from_vec(py, energies)
    }

    fn __copy__(&self) -> Self {
        self.clone()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.clone()
    }

    #[allow(clippy::type_complexity)] // the arguments of `__new__`
    fn __getnewargs__(&self) -> (usize, Hertz, [[f64; 2]; 2], f64, Options) {
        let (hertz, bodies, friction, options) = self.given.clone();
        (self.__len__(), hertz, bodies, friction, options)
    }

    fn __getstate__(&mut self) -> PyResult<([f64; 3], Vec<Vec<f64>>)> {
        let (shared, heats) = (&self.shared, self.heats());
        let states: Result<Vec<Vec<f64>>, RangeError> = of_any!(&mut self.contacts, parts => {
            parts.iter_mut().map(|parts| {
                let roll = shared.rolling.map_or(0, |_| GrainRoll::NUMBERS);
                let mut numbers = vec![0.0; parts.numbers() + roll];
                if !parts.contact.is_new() {
                    shared.whole(parts).pack(&mut numbers)?;
                }
                Ok(numbers)
            }).collect()
        });
        Ok((heats, states.map_err(Fault::from)?))
    }

    fn __setstate__(&mut self, state: ([f64; 3], Vec<Vec<f64>>)) -> PyResult<()> {
        let ([friction, damping, rolling], states) = state;
        same_length("state", states.len(), self.__len__())?;
        let shared = &self.shared;
        of_any!(&mut self.contacts, parts => {
            for (parts, numbers) in parts.iter_mut().zip(&states) {
                if numbers.first().is_some_and(|first| *first != 0.0) {
                    shared.whole(parts).unpack(numbers).map_err(Fault::from)?;
                }
            }
        });
        self.heats = Heats { friction, damping, rolling };
        Ok(())
    }
}

/// The resistance to rolling of these constants.
fn resistance(rolling: Option<[f64; 3]>) -> Result<Option<RollingResistance>, RangeError> {
    let made = rolling
        .map(|[stiffness, damping, friction]| RollingResistance::new(stiffness, damping, friction));
    made.transpose()
}

/// So many contacts of bodies that are apart.
fn contacts(count: usize, hertz: &Hertz, friction: f64, options: &Options) -> PyResult<Contacts> {
    let (law, _, _, torsion, _) = options;
    let name: LawName = law.parse().map_err(|e: WordError| PyValueError::new_err(e.to_string()))?;
    let limit = Friction::new(friction).map_err(Fault::from)?;
    Ok(match name {
        LawName::Shift(law) => {
            let fresh = Law::chosen(law, hertz.0.stiffness(), limit, Tolerance::PARTICLES);
            let twist = torsion.then(|| StoredTwist::new(&TorsionLaw::new(&hertz.0, limit)?));
            Contacts::Shift(equal(count, fresh, twist.transpose().map_err(Fault::from)?, options)?)
        }
        LawName::Rings => {
            let fresh = RingLaw::new(&hertz.0, limit, rings::Tolerance::GRAINS);
            Contacts::Rings(equal(count, fresh.map_err(Fault::from)?, None, options)?)
        }
    })
}

fn equal<L: GrainLaw>(
    count: usize,
    law: L,
    twist: Option<StoredTwist>,
    &(_, relaxation, restitution, _, _): &Options,
) -> Result<Vec<Parts<L>>, Fault> {
    let damping = HertzDamping::of_restitution(restitution)?.beside_relaxation(relaxation)?;
    let contact = GrainContact::new(law, relaxation)?.with_restitution(damping)?;
    let mut all = room::vector("count", count)?;
    all.resize(count, Parts { contact, twist, roll: GrainRoll::default() });
    Ok(all)
}

impl<L: GrainLaw> Parts<L> {
    /// Number of numbers of its state without that of its rolling.
    fn numbers(&self) -> usize {
        let law = if L::Twist::COUNTS { ring_grain_numbers(6, 8) } else { grain_numbers(VERTICES) };
        let twist = self.twist.map_or(0, |_| StoredTwist::NUMBERS);
        law + twist
    }
}

impl Shared {
    fn whole<'a, L: GrainLaw>(&'a self, parts: &'a mut Parts<L>) -> WholeContact<'a, L> {
        let (relative_radius, roll) = (self.relative_radius, &mut parts.roll);
        let rolling = self.rolling.as_ref();
        let rolling = rolling.map(|resistance| Rolling { resistance, relative_radius, roll });
        WholeContact { contact: &mut parts.contact, twist: parts.twist.as_mut(), rolling }
    }

    /// Advances contacts and gives their loads and approaches.
    fn advance<L: GrainLaw>(
        &self,
        all: &mut [Parts<L>],
        bodies: &[f64],
        dt: f64,
        mut heats: Option<&mut Heats>,
    ) -> Result<(Vec<f64>, Vec<f64>), Fault> {
        let (mut loads, mut approaches) = (Vec::new(), Vec::new());
        for (i, (parts, bodies)) in all.iter_mut().zip(bodies.chunks_exact(2 * EACH)).enumerate() {
            let mut load = GrainLoad::default();
            let meeting = self.meeting(bodies).and_then(|meeting| {
                self.whole(parts).advance(&meeting, dt, &mut load, heats.as_deref_mut())?;
                Ok(meeting)
            });
            let meeting = meeting.map_err(|error| Fault::from(error).at(i))?;
            loads.extend(load.force.iter().chain(load.torques.as_flattened()));
            approaches.push(meeting.zeta);
        }
        Ok((loads, approaches))
    }

    /// Two spheres, or a sphere and the nearest point of a wall, which is a body of infinite radius.
    fn meeting(&self, bodies: &[f64]) -> Result<Meeting, RangeError> {
        let body = |k: usize| {
            let vector = |i: usize| std::array::from_fn(|j| bodies[EACH * k + 3 * i + j]);
            let (radius, mass) = (self.radii[k], self.masses[k]);
            Grain { place: vector(0), velocity: vector(1), spin: vector(2), radius, mass }
        };
        let (one, two) = (body(0), body(1));
        let met = if two.radius.is_finite() {
            Meeting::of_spheres(&one, &two, self.shares)?
        } else {
            let Grain { place, velocity, spin, .. } = two;
            let way: [f64; 3] = std::array::from_fn(|k| one.place[k] - place[k]);
            let distance = way.iter().map(|x| x * x).sum::<f64>().sqrt();
            RangeError::positive("distance", distance)?;
            let normal = way.map(|x| x / distance);
            let wall = Surface { place, normal, velocity, spin, axis: [0.0; 3] };
            Meeting::on_surface(&one, &wall, self.shares[0])
        };
        if self.weighs {
            met.check_masses()?;
        }
        Ok(met)
    }
}
