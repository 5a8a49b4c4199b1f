//! The matrices of the law of rings, the only memory that the library allocates for a caller.

use carom_laws::friction::Friction;
use carom_laws::rings::{RingConstants, RingMatrices, RingMemory, Rings, Tolerance};
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pair::{CAROM_LAW_RINGS, CaromPair};
use crate::pointers::{read, write};

/// Allowed relative difference between kappa of a pair and that of its matrices: rounding at other radii.
const ROUNDING: f64 = 1e-12;

/// The matrices of CAROM_LAW_RINGS for two materials and a coefficient of friction, some 60 kilobytes. They
/// serve contacts of any radius, do not change, and may be used by several threads at once.
#[derive(Debug)]
pub struct CaromRings {
    matrices: RingMatrices,
}

impl CaromPair {
    /// The constants of the pair that the law of rings needs.
    fn ring_constants(&self) -> Result<(RingConstants, Friction, Tolerance), Failure> {
        self.check_version()?;
        if self.law != CAROM_LAW_RINGS {
            let text = format_args!("law = {} is not rings (2)", self.law);
            return Err(Failure::new(CaromStatus::OutOfRange, "law", text));
        }
        let (one, two) = (self.a_squared, self.b_squared);
        let holds = one > 0.0 && (one - two).abs() <= 1e-9 * one;
        RangeError::check(
            "b_squared",
            two,
            holds,
            "a_squared > 0: the contact must be a circle of known materials",
        )?;
        let (kappa, radius) = (self.c_z / self.c_x, one.sqrt());
        let constants = RingConstants { c_z: self.c_z, radius, kappa, gamma: self.gamma };
        Ok((constants, Friction::new(self.friction)?, Tolerance::new(self.tolerance)?))
    }

    /// The constants of the pair, joined to the matrices of its materials.
    pub(crate) fn rings<'a>(&self, rings: &'a CaromRings) -> Result<Rings<'a>, Failure> {
        let (RingConstants { c_z, radius, kappa, gamma }, friction, tolerance) =
            self.ring_constants()?;
        let of = &rings.matrices;
        let same = (kappa - of.kappa()).abs() <= ROUNDING * kappa
            && gamma == of.gamma()
            && friction == of.friction();
        if !same {
            let text = "the rings were made for other materials or another coefficient of friction";
            return Err(Failure::new(CaromStatus::OutOfRange, "rings", text));
        }
        Ok(of.contact(c_z, radius, tolerance)?)
    }

    /// Checks that the law of the pair is the law of rings.
    pub(crate) fn check_rings(&self) -> Result<(), Failure> {
        self.ring_constants()?.0.checked()?;
        Ok(())
    }
}

impl CaromRings {
    /// The share of the contact area that did not slip in the last step.
    pub(crate) fn sticking(&self, memory: &RingMemory) -> f64 {
        memory.sticking(&self.matrices)
    }
}

/// Computes the matrices of a pair of CAROM_LAW_RINGS, in a fraction of a millisecond (10 ms for the first).
/// `carom_rings_free` releases them. The matrices of `grains->unit` serve all contacts of the two materials.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_rings_of(
    pair: *const CaromPair,
    rings: *mut *mut CaromRings,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let pair = read(pair, "pair")?;
        let place = write(rings, "rings")?;
        let (RingConstants { kappa, gamma, .. }, friction, _) = pair.ring_constants()?;
        let matrices = RingMatrices::new(kappa, gamma, friction)?;
        *place = Box::into_raw(Box::new(CaromRings { matrices }));
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Releases the matrices that `carom_rings_of` made; null is allowed.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `rings` must be null or made by `carom_rings_of`, and is not to be used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_rings_free(rings: *mut CaromRings) {
    if !rings.is_null() {
        // SAFETY: the caller's promise.
        drop(unsafe { Box::from_raw(rings) });
    }
}
