//! Materials, and the laws that a contact may follow.

use std::ffi::{CStr, c_char};

use carom_halfspace::{Material, MaterialPair};
use carom_laws::law_name::LawName;
use carom_laws::turning_law::TurningLaw;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pointers::{read, write};

/// `coulomb`: exact return mapping at each depth of the contact, to a tolerance, for paths that turn.
pub const CAROM_LAW_COULOMB: u32 = 0;
/// `fixed-direction`: one direction of traction in a slip annulus (chapter 7 of the thesis). Exact on
/// straight paths; where the direction turns, the mean error is 5 % of the friction limit. Faster.
pub const CAROM_LAW_FIXED_DIRECTION: u32 = 1;
/// `rings`: approach, shift, twist and the coupling of dissimilar materials act together; the contact, a
/// circle, is divided into concentric rings. For particles (`carom_law_make`) only. A step takes 2 to 5
/// microseconds. With 100 steps in an impact the error of R_x is at most .01, unless the tangential velocity is
/// below f/2 times the normal one.
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

/// The law of a CAROM_LAW constant.
pub(crate) fn law_of(law: u32) -> Result<LawName, Failure> {
    match law {
        CAROM_LAW_COULOMB => Ok(LawName::Shift(TurningLaw::Coulomb)),
        CAROM_LAW_FIXED_DIRECTION => Ok(LawName::Shift(TurningLaw::FixedDirection)),
        CAROM_LAW_RINGS => Ok(LawName::Rings),
        law => {
            let text = format_args!(
                "law = {law} is neither coulomb (0), fixed-direction (1) nor rings (2)"
            );
            let failure = Failure::new(CaromStatus::OutOfRange, "law", text);
            Err(failure.with_value(f64::from(law)))
        }
    }
}

const fn number_of(law: LawName) -> u32 {
    match law {
        LawName::Shift(TurningLaw::Coulomb) => CAROM_LAW_COULOMB,
        LawName::Shift(TurningLaw::FixedDirection) => CAROM_LAW_FIXED_DIRECTION,
        LawName::Rings => CAROM_LAW_RINGS,
    }
}

/// The CAROM_LAW constant of a name: "coulomb", "fixed-direction" or "rings".
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `name` must end with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_law_of_name(
    name: *const c_char,
    law: *mut u32,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        read(name, "name")?;
        let place = write(law, "law")?;
        let name = CStr::from_ptr(name).to_string_lossy();
        let known = name.parse::<LawName>();
        *place =
            number_of(known.map_err(|wrong| Failure::new(CaromStatus::OutOfRange, "law", wrong))?);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The name of a CAROM_LAW constant; empty for another number. Never null, and not to be freed.
#[unsafe(no_mangle)]
pub extern "C" fn carom_law_name(law: u32) -> *const c_char {
    let text = match law_of(law) {
        Ok(LawName::Shift(TurningLaw::Coulomb)) => c"coulomb",
        Ok(LawName::Shift(TurningLaw::FixedDirection)) => c"fixed-direction",
        Ok(LawName::Rings) => c"rings",
        Err(_) => c"",
    };
    text.as_ptr()
}
