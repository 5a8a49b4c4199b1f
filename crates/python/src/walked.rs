//! One interface for the contact laws with memory.

use carom::laws::accounted::Accounted;
use carom::laws::coulomb::{SlipTurn, Tolerance, packed_numbers};
use carom::laws::coupling::coupling_bound;
use carom::laws::law::{Checked, ContactLaw as _, Dissipative, Energies as _, Shift};
use carom::laws::law_name::LawName;
use carom::laws::memory::{Fixed, Lateral, VertexStack};
use carom::laws::rings::{self, RingLaw};
use carom::laws::shift_law::ShiftLaw;
use carom::laws::turning_law::TurningLaw;
use carom::prelude::{ContactLoad, Friction, RangeError};
use carom::special::WordError;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::error::Fault;
use crate::friction::with_threshold;
use crate::hertz::Given;
use crate::quantities::{self, In, StaticFriction};
use crate::told::Watch;

/// Capacity of the history of one contact, in load reversals.
pub(crate) const VERTICES: usize = 64;
/// The name of the law of rings.
const RINGS: &str = LawName::Rings.name();

pub(crate) type Law = ShiftLaw<[f64; 2], Fixed<[f64; 2], VERTICES>>;

/// Parses the name of a law.
fn turning_law(word: &str) -> PyResult<TurningLaw> {
    word.parse().map_err(|error: WordError| PyValueError::new_err(format!("{error}, or 'rings'")))
}

/// The arguments from which a contact was made.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Constants {
    pub(crate) given: Given,
    pub(crate) friction: f64,
    pub(crate) law: String,
    /// None for the usual one of the class.
    pub(crate) tolerance: Option<f64>,
    /// That usual one.
    pub(crate) usual: f64,
    pub(crate) static_friction: Option<f64>,
}

/// The arguments of `__new__` that a contact is made of: stiffness, friction, law, tolerance and static friction.
pub(crate) type Arguments = (Given, f64, String, Option<f64>, Option<f64>);

impl Constants {
    pub(crate) fn new(
        given: Given,
        friction: In<quantities::Friction>,
        law: String,
        (tolerance, usual): (Option<In<quantities::Tolerance>>, f64),
        static_friction: Option<In<StaticFriction>>,
    ) -> Self {
        let static_friction = static_friction.map(|friction| friction.0);
        let tolerance = tolerance.map(|tolerance| tolerance.0);
        Self { given, friction: friction.0, law, tolerance, usual, static_friction }
    }

    /// An error if a tolerance is given, which this law does not need.
    pub(crate) fn refuse_tolerance(&self, why: &'static str) -> PyResult<()> {
        match self.tolerance {
            None => Ok(()),
            Some(tolerance) => {
                let text = format!("tolerance = {tolerance}: must not be given, since {why}");
                Err(PyValueError::new_err(text))
            }
        }
    }

    pub(crate) fn is_of_rings(&self) -> bool {
        self.law == RINGS
    }

    pub(crate) fn law<V: Lateral, S: VertexStack<V>>(&self) -> PyResult<ShiftLaw<V, S>> {
        let law = turning_law(&self.law)?;
        let tolerance = match law {
            TurningLaw::Coulomb => {
                Tolerance::new(self.tolerance.unwrap_or(self.usual)).map_err(Fault::from)?
            }
            TurningLaw::FixedDirection => {
                self.refuse_tolerance("law = 'fixed-direction' has none")?;
                Tolerance::FINE
            }
        };
        let stiffness = self.given.stiffness();
        if let Some(threshold) = self.static_friction {
            let friction = with_threshold(self.friction, threshold).map_err(Fault::from)?;
            return Ok(ShiftLaw::with_static_friction(law, stiffness, friction, tolerance));
        }
        let friction = Friction::new(self.friction).map_err(Fault::from)?;
        Ok(ShiftLaw::chosen(law, stiffness, friction, tolerance))
    }

    pub(crate) fn rings(&self) -> PyResult<RingLaw> {
        if self.static_friction.is_some() {
            let text = "static_friction: not for law = 'rings', whose rings have one coefficient";
            return Err(PyValueError::new_err(text));
        }
        let Given::Hertz(hertz) = &self.given else {
            let text = "law = 'rings': stiffness must be a Hertz contact, since the law needs the materials";
            return Err(PyValueError::new_err(text));
        };
        let friction = Friction::new(self.friction).map_err(Fault::from)?;
        let tolerance = self.tolerance.unwrap_or(self.usual);
        let tolerance = rings::Tolerance::new(tolerance).map_err(Fault::from)?;
        Ok(RingLaw::new(&hertz.0, friction, tolerance).map_err(Fault::from)?)
    }

    /// Upper bound of the change of R_x by the coupling of dissimilar materials where the law neglects it;
    /// None for unknown materials.
    pub(crate) fn coupling_bound(&self) -> PyResult<Option<f64>> {
        let Given::Hertz(hertz) = &self.given else { return Ok(None) };
        if self.is_of_rings() {
            return Ok(Some(0.0));
        }
        // It grows as friction falls.
        let friction = Friction::new(self.friction).map_err(Fault::from)?;
        Ok(Some(coupling_bound(hertz.0.materials().gamma(), friction)))
    }

    /// What follows the turn of slip, of a law whose annuli slip independently.
    fn slip_turn(&self) -> PyResult<SlipTurn> {
        let friction = self.static_friction.unwrap_or(self.friction);
        let friction = Friction::new(friction).map_err(Fault::from)?;
        Ok(SlipTurn::of_any_depth(self.given.stiffness(), friction))
    }

    /// What tells where the contact leaves the theory.
    pub(crate) fn watch(&self) -> PyResult<Watch> {
        Ok(Watch::new(&self.given, self.coupling_bound()?))
    }

    /// Number of numbers of a packed state; without slip a stored load reversal takes more of them.
    pub(crate) fn numbers(&self, vertices: usize) -> usize {
        if self.is_of_rings() {
            return rings::packed_numbers(6, 8);
        }
        match self.friction == f64::INFINITY {
            true => 6 + 9 * vertices,
            false => packed_numbers(vertices),
        }
    }

    /// The arguments of `__new__` that make the same contact, for pickling.
    pub(crate) fn arguments(&self) -> Arguments {
        (self.given, self.friction, self.law.clone(), self.tolerance, self.static_friction)
    }
}

/// A law with memory that one or many contacts follow.
pub(crate) trait Member: Checked<Error = RangeError> + Dissipative + Send + Sync {
    /// Writes the state as numbers.
    fn write(&self, numbers: &mut [f64]) -> Result<(), RangeError>;
    /// Reads a state written by `write`.
    fn read(&mut self, numbers: &[f64]) -> Result<(), RangeError>;
}

impl<V: Lateral + Send + Sync, const N: usize> Member for ShiftLaw<V, Fixed<V, N>> {
    fn write(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        self.pack(numbers)
    }

    fn read(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        self.unpack(numbers)
    }
}

impl Member for RingLaw {
    fn write(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        self.pack(numbers)
    }

    fn read(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        self.unpack(numbers)
    }
}

/// A law with an account of its heat and of the turn of its slip.
#[derive(Debug, Clone)]
pub(crate) struct Followed {
    accounted: Accounted<Law>,
    turn: SlipTurn,
}

impl Followed {
    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        let load = self.accounted.advance(shift)?;
        self.turn.advance(shift)?;
        Ok(load)
    }
}

/// The accounts of a contact: heat so far, and the numbers of the turn of slip, if it slips by annuli.
pub(crate) type Accounts = (f64, Option<Vec<f64>>);

/// The law of one contact, with its accounts if requested.
#[derive(Debug, Clone)]
pub(crate) enum Walked {
    Bare(Law),
    Accounted(Followed),
    Rings(Box<RingLaw>),
    AccountedRings(Box<Accounted<RingLaw>>),
}

impl Walked {
    /// A new law with these accounts so far.
    pub(crate) fn new(
        constants: &Constants,
        state: Option<&[f64]>,
        accounts: Option<Accounts>,
    ) -> PyResult<Self> {
        if constants.is_of_rings() {
            let law = restored(constants.rings()?, state)?;
            return Ok(match accounts {
                Some((heat, _)) => Self::AccountedRings(Box::new(Accounted::going_on(law, heat))),
                None => Self::Rings(Box::new(law)),
            });
        }
        let law: Law = restored(constants.law()?, state)?;
        let Some((heat, turned)) = accounts else { return Ok(Self::Bare(law)) };
        let turn = constants.slip_turn()?;
        let turn = match turned {
            Some(numbers) => turn.in_state(&numbers).map_err(Fault::from)?,
            None => turn,
        };
        Ok(Self::Accounted(Followed { accounted: Accounted::going_on(law, heat), turn }))
    }

    /// The law of shifts; an error if the contact follows another law.
    pub(crate) fn shift_law(&self) -> PyResult<&Law> {
        match self {
            Self::Bare(law) => Ok(law),
            Self::Accounted(followed) => Ok(followed.accounted.law()),
            _ => Err(PyValueError::new_err("this quantity is not available for law = 'rings'")),
        }
    }

    /// The law of rings, if the contact follows it.
    pub(crate) fn rings(&self) -> Option<&RingLaw> {
        match self {
            Self::Rings(law) => Some(law),
            Self::AccountedRings(accounted) => Some(accounted.law()),
            _ => None,
        }
    }

    pub(crate) fn dissipated(&self) -> Option<f64> {
        match self {
            Self::Bare(_) | Self::Rings(_) => None,
            Self::Accounted(followed) => Some(followed.accounted.dissipated()),
            Self::AccountedRings(accounted) => Some(accounted.dissipated()),
        }
    }

    /// The accounts, if there are any.
    pub(crate) fn accounts(&self) -> Option<Accounts> {
        let turned = match self {
            Self::Accounted(followed) => Some(followed.turn.numbers()),
            _ => None,
        };
        self.dissipated().map(|heat| (heat, turned))
    }

    /// The turn of slip; None without accounts. An error if the contact follows another law.
    pub(crate) fn slip_turn(&self) -> PyResult<Option<f64>> {
        self.shift_law()?;
        Ok(match self {
            Self::Accounted(followed) => Some(followed.turn.angle()),
            _ => None,
        })
    }

    pub(crate) fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        if self.rings().is_none() {
            let holds = shift.omega == 0.0;
            RangeError::check("omega", shift.omega, holds, "0 but for law = 'rings'")?;
        }
        match self {
            Self::Bare(law) => law.advance(shift),
            Self::Accounted(followed) => followed.advance(shift),
            Self::Rings(law) => law.advance(shift),
            Self::AccountedRings(accounted) => accounted.advance(shift),
        }
    }

    pub(crate) fn load(&self) -> ContactLoad {
        match self {
            Self::Bare(law) => law.load(),
            Self::Accounted(followed) => followed.accounted.load(),
            Self::Rings(law) => law.load(),
            Self::AccountedRings(accounted) => accounted.load(),
        }
    }

    pub(crate) fn shift(&self) -> Shift {
        match self {
            Self::Bare(law) => law.shift(),
            Self::Accounted(followed) => followed.accounted.shift(),
            Self::Rings(law) => law.shift(),
            Self::AccountedRings(accounted) => accounted.shift(),
        }
    }

    pub(crate) fn stored_energy(&self) -> f64 {
        match self {
            Self::Bare(law) => law.stored_energy(),
            Self::Accounted(followed) => followed.accounted.law().stored_energy(),
            Self::Rings(law) => law.stored_energy(),
            Self::AccountedRings(accounted) => accounted.law().stored_energy(),
        }
    }

    /// The regime of the last step; for the law of rings adhesion, slip or sliding by the share that stuck.
    pub(crate) fn regime(&self) -> PyResult<String> {
        let Some(law) = self.rings() else {
            return Ok(format!("{:?}", self.shift_law()?.regime()).to_lowercase());
        };
        let word = match law.sticking() {
            _ if law.shift().zeta <= 0.0 => "separated",
            1.0.. => "adhesion",
            0.0 => "sliding",
            _ => "slip",
        };
        Ok(word.to_owned())
    }

    pub(crate) fn sticking(&self) -> PyResult<f64> {
        match self.rings() {
            Some(law) => Ok(law.sticking()),
            None => Ok(self.shift_law()?.stick_depth()),
        }
    }

    pub(crate) fn turn_frame(&mut self, angle: f64) -> PyResult<()> {
        match self {
            Self::Bare(law) => law.turn_frame(angle),
            Self::Accounted(Followed { accounted, turn }) => {
                accounted.turn_frame(angle);
                turn.turn_frame(angle);
            }
            _ => return self.shift_law().map(|_| ()),
        }
        Ok(())
    }

    pub(crate) fn pack(&self, numbers: &mut [f64]) -> PyResult<()> {
        let packed = match self.rings() {
            Some(law) => law.pack(numbers),
            None => self.shift_law()?.pack(numbers),
        };
        Ok(packed.map_err(Fault::from)?)
    }
}

fn restored<L: Member>(mut law: L, state: Option<&[f64]>) -> PyResult<L> {
    if let Some(numbers) = state {
        law.read(numbers).map_err(Fault::from)?;
    }
    Ok(law)
}
