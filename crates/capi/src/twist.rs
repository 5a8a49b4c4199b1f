//! The memory of a twist as 83 numbers.

use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw as _, Dissipative as _, Shift};
use carom_laws::torsion::law::{TorsionConstants, TorsionLaw, packed_numbers};
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pair::CaromPair;
use crate::pointers::{read, write};
use crate::state::finite;

/// The numbers in a `carom_twist`.
pub const CAROM_TWIST_NUMBERS: usize = 83;
const PIECES: usize = 12;
const _: () = assert!(CAROM_TWIST_NUMBERS == packed_numbers(PIECES));

/// The memory of a contact that twists about its normal, in 83 numbers, the caller's: zeros are two bodies
/// that just touch, untwisted. It stands beside the memory of the shift, each as if the other were absent.
/// As a `carom_state` the numbers may be kept in files and sent to other processes.
///
/// 12 pieces of the history, one or two for a turn of the twist, are remembered to the bit; beyond, those
/// that matter least are joined: over random histories the torque was then off by less than 3e-4 of that
/// of sliding in the mean, .02 at worst.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromTwist {
    /// Not to be changed but by the functions of this library.
    pub numbers: [f64; CAROM_TWIST_NUMBERS],
}

impl CaromTwist {
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
    /// The law of a twist of these constants, the bodies apart.
    fn torsion(&self) -> Result<TorsionLaw, Failure> {
        self.check_version()?;
        let Self { c_z, torsion_stiffness: stiffness, torsion_arm: arm, .. } = *self;
        if stiffness == 0.0 {
            let text = "the pair knows no torsion: it was made by carom_pair_of_stiffness";
            return Err(Failure::new(CaromStatus::BadState, "pair", text));
        }
        let friction = Friction::new(self.friction)?;
        Ok(TorsionLaw::from_constants(TorsionConstants { c_z, stiffness, arm }, friction)?)
    }
}

/// Goes straight to a new approach (m) and twist of body 2 against body 1 about the normal (radians);
/// `torque`, that on body 1 in N m, may be null.
///
/// A `zeta` that is not positive separates the bodies: the memory is lost.
///
/// # Safety
/// `pair` is null or may be read; `twist`, `torque` and `error` are null or may be written.
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
/// `pair` and `twist` are null or may be read; `torque` and `error` are null or may be written.
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

/// The elastic energy of the twist alone, J.
///
/// # Safety
/// As `carom_twist_torque`.
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

/// The energy that the straight step to an approach and a twist would turn into heat, J. Nothing moves.
///
/// # Safety
/// As `carom_twist_torque`.
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

/// A question to one memory.
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
        *write(answer, name)? = question(&twist.law(pair)?)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
