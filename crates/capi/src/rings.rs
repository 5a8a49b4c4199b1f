//! The matrices of the law of rings: the one thing of this border that the library keeps for the caller.

use carom_laws::friction::Friction;
use carom_laws::rings::{RingConstants, RingMatrices, RingMemory, Rings, Tolerance};
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pair::{CAROM_LAW_RINGS, CaromPair};
use crate::pointers::{read, write};

/// How far kappa of a pair of any radius may be from that of its matrices.
const ROUNDING: f64 = 1e-12;

/// The matrices of CAROM_LAW_RINGS for two materials with friction, some 60 kilobytes. They serve contacts of any
/// radius, never change, and may be used by several threads at once.
#[derive(Debug)]
pub struct CaromRings {
    matrices: RingMatrices,
}

impl CaromPair {
    /// What the law of rings takes from the pair.
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
            "that of a circular contact, of known materials",
        )?;
        let (kappa, radius) = (self.c_z / self.c_x, one.sqrt());
        let constants = RingConstants { c_z: self.c_z, radius, kappa, gamma: self.gamma };
        Ok((constants, Friction::new(self.friction)?, Tolerance::new(self.tolerance)?))
    }

    /// The constants with the matrices of the materials.
    pub(crate) fn rings<'a>(&self, rings: &'a CaromRings) -> Result<Rings<'a>, Failure> {
        let (RingConstants { c_z, radius, kappa, gamma }, friction, tolerance) =
            self.ring_constants()?;
        let of = &rings.matrices;
        let same = (kappa - of.kappa()).abs() <= ROUNDING * kappa
            && gamma == of.gamma()
            && friction == of.friction();
        if !same {
            let text = "the rings were made for other materials or another friction";
            return Err(Failure::new(CaromStatus::OutOfRange, "rings", text));
        }
        Ok(of.contact(c_z, radius, tolerance)?)
    }

    /// Whether the pair is one of the law of rings.
    pub(crate) fn check_rings(&self) -> Result<(), Failure> {
        self.ring_constants()?.0.checked()?;
        Ok(())
    }
}

impl CaromRings {
    /// The share of the contact area on which nothing slipped in the last step.
    pub(crate) fn sticking(&self, memory: &RingMemory) -> f64 {
        memory.sticking(&self.matrices)
    }
}

/// Makes the matrices of a pair of CAROM_LAW_RINGS, in a fraction of a millisecond (the first takes 10 ms);
/// `carom_rings_free` gives them back. Those of `grains->unit` serve all contacts of the two materials.
///
/// # Safety
/// `pair` is null or may be read; `rings` and `error` are null or may be written.
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

/// Gives back what `carom_rings_of` made; null is allowed.
///
/// # Safety
/// `rings` is null, or was made by `carom_rings_of` and is not used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_rings_free(rings: *mut CaromRings) {
    if !rings.is_null() {
        // SAFETY: the caller's promise.
        drop(unsafe { Box::from_raw(rings) });
    }
}
