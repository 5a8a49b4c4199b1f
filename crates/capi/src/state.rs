//! The memory of a contact as 66 numbers.

use carom_laws::coulomb::packed_numbers;
use carom_laws::law::ContactLaw;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::law::{CaromLoad, CaromReport, CaromShift, Kept, Law};
use crate::pair::CaromPair;
use crate::pointers::{read, write};
use crate::stored::{Stack, VERTICES};

/// The numbers in a `carom_state`.
pub const CAROM_STATE_NUMBERS: usize = 66;
const _: () = assert!(CAROM_STATE_NUMBERS == packed_numbers(VERTICES));

/// The memory of a contact in 66 numbers, the caller's: zeros are two bodies that just touch, unshifted.
/// The numbers mean the same on any machine and in any build of this `carom_state_version()`, so
/// that they can be kept in files and sent to other processes; a run that goes on from them goes on to
/// the same bits. The friction of the pair must be finite.
///
/// Where two bodies come near, advance first to a negative zeta: the step that closes the gap finds the
/// place where they touch.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromState {
    /// Not to be changed but by the functions of this library.
    pub numbers: [f64; CAROM_STATE_NUMBERS],
}

/// A law that takes up one state after the other.
pub(crate) type Worker = Law<Stack>;

impl CaromState {
    /// One step, by a law of the pair's constants, whatever it remembers.
    #[inline]
    pub(crate) fn step(
        &mut self,
        law: &mut Worker,
        shift: CaromShift,
    ) -> Result<CaromLoad, Failure> {
        law.unpack(&self.numbers).map_err(|error| Failure::from(error).in_state())?;
        let load = law.advance(shift.into())?;
        law.pack(&mut self.numbers)?;
        Ok(load.into())
    }
}

impl Kept for CaromState {
    type Stack = Stack;

    fn law(&self, pair: &CaromPair) -> Result<Worker, Failure> {
        finite(pair)?;
        let mut law: Worker = pair.law()?;
        law.unpack(&self.numbers).map_err(|error| Failure::from(error).in_state())?;
        Ok(law)
    }

    fn keep(&mut self, law: &Worker) -> Result<(), Failure> {
        Ok(law.pack(&mut self.numbers)?)
    }

    fn advance(&mut self, pair: &CaromPair, shift: CaromShift) -> Result<CaromLoad, Failure> {
        finite(pair)?;
        self.step(&mut pair.law()?, shift)
    }
}

/// Infinite friction does not fit into a state.
pub(crate) fn finite(pair: &CaromPair) -> Result<(), Failure> {
    let friction = pair.friction;
    let holds = friction != f64::INFINITY;
    carom_special::RangeError::check("friction", friction, holds, "finite for a carom_state")?;
    Ok(())
}

/// Goes straight from the present shift to a new one; `load` may be null.
///
/// A `zeta` that is not positive separates the bodies: the memory is lost.
///
/// # Safety
/// `pair` is null or may be read; `state`, `load` and `error` are null or may be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_state_advance(
    pair: *const CaromPair,
    state: *mut CaromState,
    shift: CaromShift,
    load: *mut CaromLoad,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    unsafe { border(error, || advance(pair, state, shift, load)) }
}

/// The present load.
///
/// # Safety
/// `pair` and `state` are null or may be read; `load` and `error` are null or may be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_state_load(
    pair: *const CaromPair,
    state: *const CaromState,
    load: *mut CaromLoad,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    unsafe { ask(pair, state, load, "load", error, |state, pair| state.load(pair)) }
}

/// The elastic energy of the contact, compression included, J.
///
/// # Safety
/// As `carom_state_load`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_state_energy(
    pair: *const CaromPair,
    state: *const CaromState,
    energy: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    unsafe { ask(pair, state, energy, "energy", error, |state, pair| state.energy(pair)) }
}

/// The energy that the straight step to `shift` would turn into heat, or release at a receding edge,
/// J. Nothing moves.
///
/// # Safety
/// As `carom_state_load`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_state_heat(
    pair: *const CaromPair,
    state: *const CaromState,
    shift: CaromShift,
    heat: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    unsafe { ask(pair, state, heat, "heat", error, |state, pair| state.heat(pair, shift)) }
}

/// What the last step did, and how much of the contact sticks.
///
/// # Safety
/// As `carom_state_load`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_state_report(
    pair: *const CaromPair,
    state: *const CaromState,
    report: *mut CaromReport,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    unsafe { ask(pair, state, report, "report", error, |state, pair| state.report(pair)) }
}

/// Turns the contact axes by an angle (radians, from x to y): what is remembered is expressed in the
/// new ones, and stays the same in space.
///
/// # Safety
/// `pair` is null or may be read; `state` and `error` are null or may be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_state_turn_frame(
    pair: *const CaromPair,
    state: *mut CaromState,
    angle: f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    unsafe { border(error, || write(state, "state")?.turn_frame(read(pair, "pair")?, angle)) }
}

/// One step of one memory.
///
/// # Safety
/// As `carom_state_advance`.
pub(crate) unsafe fn advance<K: Kept>(
    pair: *const CaromPair,
    kept: *mut K,
    shift: CaromShift,
    load: *mut CaromLoad,
) -> Result<(), Failure> {
    // SAFETY: the caller's promise.
    let (pair, kept) = unsafe { (read(pair, "pair")?, write(kept, "state")?) };
    // SAFETY: the caller's promise. Checked before anything moves.
    let place = if load.is_null() { None } else { Some(unsafe { write(load, "load")? }) };
    let load = kept.advance(pair, shift)?;
    if let Some(place) = place {
        *place = load;
    }
    Ok(())
}

/// A question to one memory.
///
/// # Safety
/// As `carom_state_load`.
pub(crate) unsafe fn ask<K: Kept, T>(
    pair: *const CaromPair,
    kept: *const K,
    answer: *mut T,
    name: &'static str,
    error: *mut CaromError,
    question: impl FnOnce(&K, &CaromPair) -> Result<T, Failure>,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (pair, kept) = (read(pair, "pair")?, read(kept, "state")?);
        *write(answer, name)? = question(kept, pair)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
