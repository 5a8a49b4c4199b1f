//! The state of a twist as 83 numbers.

use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw as _, Dissipative as _, Shift};
use carom_laws::torsion::law::{TorsionConstants, TorsionLaw, packed_numbers};
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pair::CaromPair;
use crate::pointers::{read, write};
use crate::state::finite;

/// Number of numbers in a `carom_twist`.
pub const CAROM_TWIST_NUMBERS: usize = 83;
const PIECES: usize = 12;
const _: () = assert!(CAROM_TWIST_NUMBERS == packed_numbers(PIECES));

/// The state of a contact that twists about its normal, as 83 numbers in memory of the caller; zeros stand
/// for two bodies that just touch, without twist. Twist and shift are independent: each law neglects the
/// other. As with a `carom_state`, the numbers may be stored in files and sent to other processes.
///
/// The law stores up to 12 pieces of the history exactly, one or two for each reversal of the twist. Beyond
/// that it joins the pieces that matter least. Over random histories the error of the torque was then below
/// 3e-4 of the sliding torque in the mean, and .02 at most.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromTwist {
    /// Written by this library only.
    pub numbers: [f64; CAROM_TWIST_NUMBERS],
}

impl CaromTwist {
    #[inline]
    pub(crate) fn law(&self, pair: &CaromPair) -> Result<TorsionLaw, Failure> {
        finite(pair)?;
        let mut law = pair.torsion()?;
        law.unpack(&self.numbers).map_err(|error| Failure::from(error).in_state())?;
        Ok(law)
    }

    fn advance(&mut self, pair: &CaromPair, zeta: f64, omega: f64) -> Result<f64, Failure> {
        let mut law = self.law(pair)?;
        let load = law.advance(Shift { zeta, omega, ..Shift::default() })?;
        law.pack(&mut self.numbers)?;
        Ok(load.m_z)
    }
}

impl CaromPair {
    /// The law of twist with these constants, for separated bodies.
    #[inline]
    fn torsion(&self) -> Result<TorsionLaw, Failure> {
        self.check_version()?;
        let Self { c_z, torsion_stiffness: stiffness, torsion_arm: arm, .. } = *self;
        if stiffness == 0.0 {
            let text =
                "the pair has no torsional stiffness: it was made by carom_pair_of_stiffness";
            return Err(Failure::new(CaromStatus::BadState, "pair", text));
        }
        self.check_one_friction()?;
        let friction = Friction::new(self.friction)?;
        Ok(TorsionLaw::from_constants(TorsionConstants { c_z, stiffness, arm }, friction)?)
    }
}

/// Moves the contact straight to a new approach (m) and twist of body 2 against body 1 about the normal
/// (radians). `torque`, the torque on body 1 in N m, may be null.
///
/// A `zeta` that is not positive separates the bodies, and the history is lost.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_twist_advance(
    pair: *const CaromPair,
    twist: *mut CaromTwist,
    zeta: f64,
    omega: f64,
    torque: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (pair, twist) = (read(pair, "pair")?, write(twist, "twist")?);
        let place = if torque.is_null() { None } else { Some(write(torque, "torque")?) };
        let torque = twist.advance(pair, zeta, omega)?;
        if let Some(place) = place {
            *place = torque;
        }
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The present torque on body 1, N m.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_twist_torque(
    pair: *const CaromPair,
    twist: *const CaromTwist,
    torque: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    unsafe { ask(pair, twist, torque, "torque", error, |law| Ok(law.load().m_z)) }
}

/// The elastic energy of the twist, without that of compression, J.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_twist_energy(
    pair: *const CaromPair,
    twist: *const CaromTwist,
    energy: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    unsafe { ask(pair, twist, energy, "energy", error, |law| Ok(law.twist_energy())) }
}

/// The energy that a straight step to an approach and a twist would turn into heat, J. The contact is not
/// advanced.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_twist_heat(
    pair: *const CaromPair,
    twist: *const CaromTwist,
    zeta: f64,
    omega: f64,
    heat: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    let question = |law: &TorsionLaw| {
        RangeError::finite("zeta", zeta)?;
        RangeError::finite("omega", omega)?;
        Ok(law.dissipation(Shift { zeta, omega, ..Shift::default() }))
    };
    // SAFETY: the caller's promise.
    unsafe { ask(pair, twist, heat, "heat", error, question) }
}

/// Evaluates a function of the law of twist.
///
/// # Safety
/// As `carom_twist_torque`.
unsafe fn ask(
    pair: *const CaromPair,
    twist: *const CaromTwist,
    answer: *mut f64,
    name: &'static str,
    error: *mut CaromError,
    question: impl FnOnce(&TorsionLaw) -> Result<f64, Failure>,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (pair, twist) = (read(pair, "pair")?, read(twist, "twist")?);
        let told = question(&twist.law(pair)?)?;
        *write(answer, name)? = RangeError::finite(name, told)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
