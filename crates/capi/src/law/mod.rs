//! The law of the contacts of particles: all that they have in common, made once.

pub(crate) mod friction;
pub(crate) mod limits;
pub(crate) mod options;
pub(crate) mod unit;

use std::sync::Arc;

use carom_halfspace::MaterialPair;
use carom_impact::closed_form::radiation_coefficient;
use carom_laws::coulomb::Tolerance;
use carom_laws::damping::HertzDamping;
use carom_laws::grains::{GrainContact, Meeting, RollingResistance, compliance_shares};
use carom_laws::law_name::LawName;
use carom_laws::rings::{self, RingLaw, RingMatrices, RingMemory};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::static_friction::StaticFriction;
use carom_laws::torsion::law::{StoredTwist, TorsionLaw};
use carom_laws::turning_law::TurningLaw;
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::material::{CaromMaterial, law_of, materials};
use crate::pointers::{read, write};
use crate::shift::Law;
use crate::sized::SizedOptions as _;
use friction::GrainFriction;
use options::CaromLawOptions;
use unit::{Unit, gap_at_wall, gap_of_grains};

/// The law of all contacts of grains of two materials, of any radii, or of grains of material 1 and a wall of material
/// 2. It does not change, and may be used by several threads at once. It takes less than a kilobyte; with
/// CAROM_LAW_RINGS 60 more.
#[derive(Debug, Clone)]
pub struct CaromLaw {
    kind: Kind,
    materials: MaterialPair,
    unit: Unit,
    friction: GrainFriction,
    relaxation: f64,
    damping: HertzDamping,
    /// The displacement of each body at the contact over the approach.
    pub(crate) shares: [f64; 2],
    /// How strongly each material radiates elastic waves.
    radiation: [f64; 2],
    /// What coupling, if the law leaves it out, changes of R_x at most.
    coupling_bound: f64,
    has_torsion: bool,
    rolling: Option<RollingResistance>,
}

/// The contact law, with what its contacts share.
#[derive(Debug, Clone)]
enum Kind {
    Shift(TurningLaw, Tolerance),
    Rings(Arc<RingMatrices>, rings::Tolerance),
}

impl CaromLaw {
    fn new(
        materials: MaterialPair,
        friction: f64,
        options: &CaromLawOptions,
    ) -> Result<Self, Failure> {
        let name = law_of(options.law)?;
        let friction = options.friction(friction, name == LawName::Rings)?;
        let unit = Unit::new(gap_of_grains()?, materials)?;
        let radiation = [materials.body_1(), materials.body_2()].map(radiation_coefficient);
        let law = Self {
            kind: Kind::new(name, options.tolerance, (&unit, &materials), friction)?,
            materials,
            unit,
            friction,
            relaxation: options.relaxation,
            damping: options.damping()?,
            shares: compliance_shares(&materials),
            radiation: [radiation[0]?, radiation[1]?],
            coupling_bound: match name {
                LawName::Rings => 0.0,
                LawName::Shift(_) => friction.coupling_bound(materials.gamma())?,
            },
            has_torsion: options.has_torsion()? && name != LawName::Rings,
            rolling: options.rolling()?,
        };
        law.checked()
    }

    /// The law, if it can carry a contact.
    fn checked(self) -> Result<Self, Failure> {
        match self.is_by_rings() {
            true => self.damped(self.ring_law(1.0, RingMemory::default())?).map(|_| ())?,
            false => self.damped(self.shift_law(1.0, self.friction_at(0.0)?)?).map(|_| ())?,
        }
        if self.has_torsion {
            self.twist(1.0)?;
        }
        Ok(self)
    }

    /// The same at a wall of these curvatures, for grains of one radius.
    fn at_wall(&self, radius: f64, curvatures: [f64; 2]) -> Result<Self, Failure> {
        let gap = gap_at_wall(radius, curvatures, self.is_by_rings())?;
        Self { unit: Unit::new(gap, self.materials)?, ..self.clone() }.checked()
    }

    #[inline(always)]
    pub(crate) const fn is_by_rings(&self) -> bool {
        matches!(self.kind, Kind::Rings(..))
    }

    /// Whether the contact of grains is all that there is, without torsion or rolling beside it.
    #[inline(always)]
    pub(crate) const fn is_alone(&self) -> bool {
        !self.has_torsion && self.rolling.is_none()
    }

    #[inline(always)]
    pub(crate) const fn has_torsion(&self) -> bool {
        self.has_torsion
    }

    #[inline(always)]
    pub(crate) const fn rolling(&self) -> Option<&RollingResistance> {
        self.rolling.as_ref()
    }

    /// Whether a contact that touches anew has another coefficient of friction.
    #[inline(always)]
    pub(crate) fn is_by_slip(&self) -> bool {
        self.friction.is_by_slip()
    }

    /// Whether the normal motion is not damped.
    fn is_elastic(&self) -> bool {
        self.relaxation == 0.0 && self.damping.ratio() == 0.0
    }

    /// Whether the masses of the bodies count.
    #[inline(always)]
    pub(crate) fn weighs(&self) -> bool {
        self.damping.ratio() > 0.0
    }

    /// Checks the masses of two bodies if a restitution needs them.
    #[inline(always)]
    pub(crate) fn check_masses(&self, meeting: &Meeting) -> Result<(), RangeError> {
        if self.weighs() { meeting.check_masses() } else { Ok(()) }
    }

    /// The friction of a contact that first touches at a slip speed.
    pub(crate) fn friction_at(&self, slip_speed: f64) -> Result<StaticFriction, Failure> {
        Ok(self.friction.at(slip_speed)?)
    }

    /// The law of shifts of a contact of this relative radius.
    pub(crate) fn shift_law(
        &self,
        relative_radius: f64,
        friction: StaticFriction,
    ) -> Result<Law, Failure> {
        let stiffness = self.unit.stiffness(relative_radius)?;
        match self.kind {
            Kind::Shift(law, tolerance) => {
                Ok(ShiftLaw::with_static_friction(law, stiffness, friction, tolerance))
            }
            Kind::Rings(..) => Err(Failure::internal()),
        }
    }

    /// The law of rings of a contact of this relative radius.
    pub(crate) fn ring_law(
        &self,
        relative_radius: f64,
        memory: RingMemory,
    ) -> Result<RingLaw, Failure> {
        match &self.kind {
            Kind::Rings(matrices, tolerance) => {
                let circle = self.unit.circle(relative_radius);
                Ok(RingLaw::of(Arc::clone(matrices), circle, *tolerance, memory)?)
            }
            Kind::Shift(..) => Err(Failure::internal()),
        }
    }

    /// The twist of a contact of this relative radius, for separated bodies.
    pub(crate) fn twist(&self, relative_radius: f64) -> Result<StoredTwist, Failure> {
        let constants = self.unit.torsion(relative_radius);
        let law = TorsionLaw::from_constants(constants, self.friction.kinetic()?)?;
        Ok(StoredTwist::new(&law)?)
    }

    /// A new contact with the damping of the law.
    pub(crate) fn damped<L: carom_laws::grains::GrainLaw>(
        &self,
        law: L,
    ) -> Result<GrainContact<L>, Failure> {
        Ok(GrainContact::new(law, self.relaxation)?.with_restitution(self.damping)?)
    }
}

impl Kind {
    fn new(
        name: LawName,
        tolerance: f64,
        (unit, materials): (&Unit, &MaterialPair),
        friction: GrainFriction,
    ) -> Result<Self, Failure> {
        let is_usual = tolerance == 0.0;
        Ok(match name {
            LawName::Rings => {
                let usual = rings::Tolerance::GRAINS;
                let tolerance = if is_usual { usual } else { rings::Tolerance::new(tolerance)? };
                let (kappa, gamma) = (unit.kappa(), materials.gamma());
                let matrices = RingMatrices::new(kappa, gamma, friction.kinetic()?)?;
                Self::Rings(Arc::new(matrices), tolerance)
            }
            LawName::Shift(TurningLaw::Coulomb) if !is_usual => {
                Self::Shift(TurningLaw::Coulomb, Tolerance::new(tolerance)?)
            }
            LawName::Shift(law) => Self::Shift(law, Tolerance::PARTICLES),
        })
    }
}

/// Makes the law of the contacts of grains of two materials, or of grains of material 1 and a wall of material 2.
/// `friction` is the coefficient of friction, finite; null `options` select the defaults: CAROM_LAW_COULOMB, without
/// damping, torsion or resistance to rolling. `carom_law_free` releases it.
///
/// With CAROM_LAW_RINGS it takes a fraction of a millisecond, the first one 10 ms.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_law_make(
    material_1: *const CaromMaterial,
    material_2: *const CaromMaterial,
    friction: f64,
    options: *const CaromLawOptions,
    law: *mut *mut CaromLaw,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let materials = materials(material_1, material_2)?;
        let options = CaromLawOptions::of(options)?;
        let place = write(law, "law")?;
        *place = Box::into_raw(Box::new(CaromLaw::new(materials, friction, &options)?));
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Makes the law of the contacts of grains of one radius R with a curved wall, from that with a flat one. The wall,
/// where it is nearest, has the curvature `curvature_x` along the axis x of the contact, `curvature_y` across it, 1/m;
/// above 0 where it is convex, as a shaft, below 0 where it is hollow, as a drum: then above -1/R. In calls that ask
/// for the radius of the wall it is infinite, as that of a flat one. CAROM_LAW_RINGS needs two equal curvatures; its
/// matrices are shared. `carom_law_free` releases the law; the flat one may be released before.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_law_on_curved_wall(
    flat: *const CaromLaw,
    radius: f64,
    curvature_x: f64,
    curvature_y: f64,
    law: *mut *mut CaromLaw,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (flat, place) = (read(flat, "flat")?, write(law, "law")?);
        *place = Box::into_raw(Box::new(flat.at_wall(radius, [curvature_x, curvature_y])?));
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Releases a law; null is allowed.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `law` must be null or made by this library, and is not to be used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_law_free(law: *mut CaromLaw) {
    if !law.is_null() {
        // SAFETY: the caller's promise.
        drop(unsafe { Box::from_raw(law) });
    }
}
