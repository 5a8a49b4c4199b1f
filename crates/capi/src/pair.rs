//! The constants of a contact with given shifts, computed once.

use carom_halfspace::MaterialPair;
use carom_laws::coulomb::Tolerance;
use carom_laws::coupling::coupling_bound;
use carom_laws::curvature::{CurvatureError, PrincipalRadii, RelativeCurvature};
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law_name::LawName;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::turning_law::TurningLaw;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::material::{CaromMaterial, law_of, materials};
use crate::pointers::write;
use crate::shift::Law;

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
    /// CAROM_LAW_COULOMB: error of the friction force over its limit.
    pub tolerance: f64,
    /// a^2/zeta of the contact ellipse, m.
    pub a_squared: f64,
    /// b^2/zeta of the contact ellipse, m.
    pub b_squared: f64,
    /// Gamma, the coupling of normal and tangential displacements (15.2); 0 for like materials.
    pub gamma: f64,
    /// Upper bound of the change of R_x by coupling in an impact of spheres, which the law neglects.
    pub coupling_bound: f64,
    /// CAROM_LAW_COULOMB or CAROM_LAW_FIXED_DIRECTION.
    pub law: u32,
    /// CAROM_ABI_VERSION of the library that made the pair.
    pub version: u32,
}

impl CaromPair {
    fn new(
        gap: RelativeCurvature,
        materials: MaterialPair,
        (friction, law, tolerance): (f64, u32, f64),
    ) -> Result<Self, Failure> {
        let hertz = Hertz::new(gap, materials)?;
        let ContactStiffness { c_x, c_y, c_z } = hertz.stiffness();
        let ellipse = hertz.ellipse(1.0)?;
        let gamma = materials.gamma();
        let pair = Self {
            c_x,
            c_y,
            c_z,
            friction,
            tolerance: if tolerance == 0.0 { Tolerance::PARTICLES.get() } else { tolerance },
            a_squared: ellipse.semi_axis_a() * ellipse.semi_axis_a(),
            b_squared: ellipse.semi_axis_b() * ellipse.semi_axis_b(),
            gamma,
            coupling_bound: coupling_bound(gamma, Friction::new(friction)?),
            law,
            version: crate::CAROM_ABI_VERSION,
        };
        pair.law()?;
        Ok(pair)
    }

    /// The law with these constants, for separated bodies.
    #[inline]
    pub(crate) fn law(&self) -> Result<Law, Failure> {
        if self.version != crate::CAROM_ABI_VERSION {
            let text = "the pair was not made by a function carom_pair_of_... of this version";
            return Err(Failure::new(CaromStatus::BadState, "pair", text));
        }
        let stiffness = ContactStiffness::new(self.c_x, self.c_y, self.c_z)?;
        let friction = Friction::new(self.friction)?;
        let with = |law, tolerance| Ok(ShiftLaw::chosen(law, stiffness, friction, tolerance));
        match law_of(self.law)? {
            LawName::Shift(TurningLaw::Coulomb) => {
                with(TurningLaw::Coulomb, Tolerance::new(self.tolerance)?)
            }
            LawName::Shift(law) => with(law, Tolerance::PARTICLES),
            LawName::Rings => {
                let text = "law = rings (2) is for particles only: use carom_law_make";
                let failure = Failure::new(CaromStatus::OutOfRange, "law", text);
                Err(failure.with_value(f64::from(self.law)))
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
/// radius negative). A `tolerance` of 0 selects the default for particles: 1e-2.
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
        *write(pair, "pair")? = CaromPair::new(gap, materials, (friction, law, tolerance))?;
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
        *write(pair, "pair")? = CaromPair::new(gap, materials, (friction, law, tolerance))?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
