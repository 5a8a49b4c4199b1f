//! The constants of a contact, computed once.

use carom_halfspace::{Material, MaterialPair};
use carom_laws::coulomb::Tolerance;
use carom_laws::coupling::coupling_bound;
use carom_laws::curvature::{CurvatureError, PrincipalRadii, RelativeCurvature};
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::memory::VertexStack;
use carom_laws::rings;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::static_friction::StaticFriction;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::torsion::law::TorsionConstants;
use carom_laws::turning_law::TurningLaw;
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::law::Stack;
use crate::pointers::{read, write};

/// `coulomb`: exact return mapping at each depth of the contact, to a tolerance, for paths that turn.
pub const CAROM_LAW_COULOMB: u32 = 0;
/// `fixed-direction`: one direction of traction in a slip annulus (chapter 7 of the thesis). Exact on
/// straight paths; where the direction turns, the mean error is 5 % of the friction limit. Faster.
pub const CAROM_LAW_FIXED_DIRECTION: u32 = 1;

/// `rings`: approach, shift, twist and the coupling of dissimilar materials act together; the contact, a
/// circle, is divided into concentric rings. For grains (`carom_ring_touch_grains`) only. With 100 steps in
/// an impact the error of R_x is at most .01, unless the tangential velocity is below f/2 times the normal
/// one.
pub const CAROM_LAW_RINGS: u32 = 2;

/// An elastic material, or a rigid one.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromMaterial {
    /// Young's modulus, Pa; infinite for a rigid body.
    pub young_modulus: f64,
    /// Poisson's ratio, in (-1, 0.5]; ignored for a rigid body.
    pub poisson: f64,
    /// Yield stress in tension, Pa; 0 if it is not known. All contacts stay elastic; CAROM_WARNING_YIELDS
    /// tells where the material would yield. A hardness H is that of H/2.8.
    pub yield_stress: f64,
}

impl CaromMaterial {
    pub(crate) fn material(&self) -> Result<Material, Failure> {
        let material = match self.young_modulus == f64::INFINITY {
            true => Material::RIGID,
            false => Material::from_young(self.young_modulus, self.poisson)?,
        };
        match self.yield_stress == 0.0 {
            true => Ok(material),
            false => Ok(material.yielding_at(self.yield_stress)?),
        }
    }
}

/// The constants of a contact: plain data, made by the functions `carom_pair_of_...` and not to be changed
/// otherwise. Units are SI, or any consistent set.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromPair {
    /// Tangential stiffness along x, N/m^1.5: in full adhesion dF_x = c_x sqrt(zeta) dxi.
    pub c_x: f64,
    /// Tangential stiffness along y, N/m^1.5.
    pub c_y: f64,
    /// Normal stiffness, N/m^1.5: F_z = (2/3) c_z zeta^1.5.
    pub c_z: f64,
    /// The coefficient of friction, from 0 to infinity (no slip).
    pub friction: f64,
    /// The coefficient of static friction (`carom_pair_static_friction`); 0 if it is that of `friction`.
    pub static_friction: f64,
    /// Tolerance. CAROM_LAW_COULOMB: error of the friction force over its limit. CAROM_LAW_RINGS: relative
    /// accuracy with which tractions satisfy the friction limit.
    pub tolerance: f64,
    /// a^2/zeta of the contact ellipse, m; 0 if unknown.
    pub a_squared: f64,
    /// b^2/zeta of the contact ellipse, m; 0 if unknown.
    pub b_squared: f64,
    /// Torsional stiffness: torque over twist without slip, over zeta^1.5, N/m^0.5; 0 if unknown.
    pub torsion_stiffness: f64,
    /// Arm of the sliding torque: torque over f F_z, over zeta^0.5, m^0.5; 0 if unknown.
    pub torsion_arm: f64,
    /// Gamma, the coupling of normal and tangential displacements (15.2); 0 for like materials, or if
    /// unknown.
    pub gamma: f64,
    /// Upper bound of the change of R_x by coupling in an impact of spheres. All laws but CAROM_LAW_RINGS
    /// neglect coupling.
    pub coupling_bound: f64,
    /// The smaller yield stress of the two bodies; infinite if none is known.
    pub yield_stress: f64,
    /// CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION or CAROM_LAW_RINGS.
    pub law: u32,
    /// CAROM_ABI_VERSION of the library that made the pair.
    pub version: u32,
}

impl CaromPair {
    fn new(
        stiffness: ContactStiffness,
        [a_squared, b_squared]: [f64; 2],
        friction: f64,
        law: u32,
        tolerance: f64,
    ) -> Self {
        let ContactStiffness { c_x, c_y, c_z } = stiffness;
        let usual = match law {
            CAROM_LAW_RINGS => rings::Tolerance::GRAINS.get(),
            _ => Tolerance::PARTICLES.get(),
        };
        let tolerance = if tolerance == 0.0 { usual } else { tolerance };
        let version = crate::CAROM_ABI_VERSION;
        Self {
            c_x,
            c_y,
            c_z,
            friction,
            static_friction: 0.0,
            tolerance,
            a_squared,
            b_squared,
            torsion_stiffness: 0.0,
            torsion_arm: 0.0,
            gamma: 0.0,
            coupling_bound: 0.0,
            yield_stress: f64::INFINITY,
            law,
            version,
        }
    }

    /// The pair, if its constants give a valid law.
    fn checked(self) -> Result<Self, Failure> {
        match self.law {
            CAROM_LAW_RINGS => self.check_rings()?,
            _ => self.law::<Stack>().map(|_| ())?,
        }
        Ok(self)
    }

    pub(crate) fn of_hertz(
        hertz: &Hertz,
        friction: f64,
        law: u32,
        tolerance: f64,
    ) -> Result<Self, Failure> {
        let ellipse = hertz.ellipse(1.0)?;
        let squares = [ellipse.semi_axis_a(), ellipse.semi_axis_b()].map(|a| a * a);
        let TorsionConstants { stiffness, arm, .. } = TorsionConstants::of(hertz)?;
        let gamma = hertz.materials().gamma();
        Self {
            torsion_stiffness: stiffness,
            torsion_arm: arm,
            gamma,
            coupling_bound: coupling_bound(gamma, Friction::new(friction)?),
            yield_stress: hertz.materials().yield_stress(),
            ..Self::new(hertz.stiffness(), squares, friction, law, tolerance)
        }
        .checked()
    }

    /// Rejects a pair of another version, whose fields differ.
    pub(crate) fn check_version(&self) -> Result<(), Failure> {
        if self.version != crate::CAROM_ABI_VERSION {
            let text = "the pair was not made by a function carom_pair_of_... of this version";
            return Err(Failure::new(CaromStatus::BadState, "pair", text));
        }
        Ok(())
    }

    /// The coefficients of static and kinetic friction.
    fn coefficients(&self) -> Result<StaticFriction, RangeError> {
        let kinetic = Friction::new(self.friction)?;
        if self.static_friction == 0.0 {
            return StaticFriction::new(kinetic, kinetic);
        }
        let named = |error| RangeError { field: "static_friction", ..error };
        StaticFriction::new(Friction::new(self.static_friction).map_err(named)?, kinetic)
    }

    /// Sets the coefficient of static friction, if the law has one.
    pub(crate) fn set_static_friction(&mut self, static_friction: f64) -> Result<(), Failure> {
        self.check_version()?;
        let pair = Self { static_friction, ..*self };
        let drops = pair.coefficients()?.drops();
        let holds = !drops || self.law != CAROM_LAW_RINGS;
        RangeError::check("static_friction", static_friction, holds, "`friction` for law rings")?;
        *self = if drops { pair } else { Self { static_friction: 0.0, ..pair } };
        Ok(())
    }

    /// Refuses static friction above kinetic friction, which a twist does not have.
    pub(crate) fn check_one_friction(&self) -> Result<(), RangeError> {
        let (at_rest, friction) = (self.static_friction, self.friction);
        let holds = at_rest == 0.0 || at_rest == friction;
        RangeError::check("static_friction", at_rest, holds, "`friction` for a twist").map(|_| ())
    }

    /// The law with these constants, for separated bodies.
    #[inline]
    pub(crate) fn law<S: VertexStack<[f64; 2]>>(&self) -> Result<ShiftLaw<[f64; 2], S>, Failure> {
        self.check_version()?;
        let stiffness = ContactStiffness::new(self.c_x, self.c_y, self.c_z)?;
        let friction = self.coefficients()?;
        let with = |law, tolerance| {
            Ok(ShiftLaw::with_static_friction(law, stiffness, friction, tolerance))
        };
        match self.law {
            CAROM_LAW_COULOMB => with(TurningLaw::Coulomb, Tolerance::new(self.tolerance)?),
            CAROM_LAW_FIXED_DIRECTION => with(TurningLaw::FixedDirection, Tolerance::PARTICLES),
            CAROM_LAW_RINGS => {
                let text = "law = rings (2) is for grains only: use carom_ring_touch";
                let failure = Failure::new(CaromStatus::OutOfRange, "law", text);
                Err(failure.with_value(f64::from(CAROM_LAW_RINGS)))
            }
            law => {
                let text = format_args!(
                    "law = {law} is neither coulomb (0), fixed-direction (1) nor rings (2)"
                );
                let failure = Failure::new(CaromStatus::OutOfRange, "law", text);
                Err(failure.with_value(f64::from(law)))
            }
        }
    }
}

impl From<CurvatureError> for Failure {
    fn from(error: CurvatureError) -> Self {
        match error {
            CurvatureError::Range(error) => error.into(),
            error => Self::new(CaromStatus::NoContact, "", error),
        }
    }
}

/// The constants of two spheres, of a sphere on a plane (one radius infinite) or in a spherical cavity (one
/// radius negative). A `tolerance` of 0 selects the default for particles: 1e-2, for CAROM_LAW_RINGS 3e-3.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_pair_of_spheres(
    material_1: *const CaromMaterial,
    material_2: *const CaromMaterial,
    radius_1: f64,
    radius_2: f64,
    friction: f64,
    law: u32,
    tolerance: f64,
    pair: *mut CaromPair,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let materials = materials(material_1, material_2)?;
        let [one, two] = [PrincipalRadii::sphere(radius_1)?, PrincipalRadii::sphere(radius_2)?];
        let gap = RelativeCurvature::new(one, two, 0.0)?;
        let hertz = Hertz::new(gap, materials)?;
        *write(pair, "pair")? = CaromPair::of_hertz(&hertz, friction, law, tolerance)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The constants of two bodies with the gap A x^2 + B y^2; A and B in 1/m.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_pair_of_curvatures(
    material_1: *const CaromMaterial,
    material_2: *const CaromMaterial,
    curvature_a: f64,
    curvature_b: f64,
    friction: f64,
    law: u32,
    tolerance: f64,
    pair: *mut CaromPair,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let materials = materials(material_1, material_2)?;
        let gap = RelativeCurvature::from_coefficients(curvature_a, curvature_b)?;
        let hertz = Hertz::new(gap, materials)?;
        *write(pair, "pair")? = CaromPair::of_hertz(&hertz, friction, law, tolerance)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The constants of a contact of known stiffnesses: dF_x = c_x sqrt(zeta) dxi, F_z = (2/3) c_z zeta^1.5.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_pair_of_stiffness(
    c_x: f64,
    c_y: f64,
    c_z: f64,
    friction: f64,
    law: u32,
    tolerance: f64,
    pair: *mut CaromPair,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let stiffness = ContactStiffness::new(c_x, c_y, c_z)?;
        let made = CaromPair::new(stiffness, [0.0; 2], friction, law, tolerance).checked()?;
        *write(pair, "pair")? = made;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Gives a pair static friction above kinetic friction, `friction` of the pair: until all of a contact slides, it
/// sticks or slips in part with `static_friction`, finite and at least `friction`; then the force drops, and it
/// slides with `friction`. Where a part of it sticks, static friction counts again. Not for CAROM_LAW_RINGS, and a
/// twist has none. Contacts that have begun keep theirs.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_pair_static_friction(
    pair: *mut CaromPair,
    static_friction: f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe { write(pair, "pair")?.set_static_friction(static_friction) };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// # Safety
/// The pointers are null or may be read.
pub(crate) unsafe fn materials(
    one: *const CaromMaterial,
    two: *const CaromMaterial,
) -> Result<MaterialPair, Failure> {
    // SAFETY: the caller's promise.
    let (one, two) = unsafe { (read(one, "material_1")?, read(two, "material_2")?) };
    Ok(MaterialPair::new(one.material()?, two.material()?)?)
}
