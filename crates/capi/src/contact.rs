//! The state of a contact, kept as the law itself in the caller's memory.

use std::mem::MaybeUninit;

use carom_laws::law::{ContactLaw, Dissipative};
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pair::CaromPair;
use crate::pointers::{read, write};
use crate::shift::{CaromLoad, CaromShift, Law};
use crate::state::CaromState;
use crate::stored::{Stored, present, seen};

/// Number of 8-byte words in a `carom_contact`, without its mark.
pub const CAROM_CONTACT_WORDS: usize = 144;

/// The state of a contact in memory of the caller: 1160 bytes, aligned to 8, that may be copied as bytes.
/// Zero bytes stand for two bodies that just touch, without shift.
///
/// It stores the law with its constants, so that a step reads and writes only what it needs. Only the build
/// that wrote it can read it; `carom_contact_pack` converts it to a `carom_state`.
///
/// The constants are those of the pair of the first advance. To change them, set the contact to zero.
#[derive(Debug, Clone, Copy)]
#[repr(C)]
pub struct CaromContact {
    /// Identifies the build that wrote the contact. Written by this library only.
    pub mark: u64,
    /// The bytes of the law.
    pub words: [MaybeUninit<u64>; CAROM_CONTACT_WORDS],
}

impl CaromContact {
    #[inline(always)]
    fn present(&self) -> Result<Option<&Law>, Failure> {
        // SAFETY: the words are those that were stored with the mark.
        unsafe { seen(self.mark, 0, self.words.as_ptr().cast()) }
    }

    #[inline(always)]
    fn present_mut(&mut self) -> Result<Option<&mut Law>, Failure> {
        // SAFETY: the words are those that were stored with the mark, and borrowed exclusively.
        unsafe { present(self.mark, 0, self.words.as_mut_ptr().cast()) }
    }

    /// Makes the first step of a contact.
    #[cold]
    fn begin(&mut self, pair: &CaromPair, shift: CaromShift) -> Result<CaromLoad, Failure> {
        let mut law = pair.law()?;
        let load = law.advance(shift.into())?;
        self.keep(&law);
        Ok(load.into())
    }

    /// A copy of the law in its present state.
    fn law(&self, pair: &CaromPair) -> Result<Law, Failure> {
        match self.present()? {
            Some(law) => Ok(*law),
            None => pair.law(),
        }
    }

    fn keep(&mut self, law: &Law) {
        const { assert!(size_of::<Law>() <= 8 * CAROM_CONTACT_WORDS) };
        // SAFETY: size and alignment match; the old bytes need no drop.
        unsafe { self.words.as_mut_ptr().cast::<Law>().write(*law) };
        self.mark = Law::MARK;
    }

    #[inline]
    pub(crate) fn advance(
        &mut self,
        pair: &CaromPair,
        shift: CaromShift,
    ) -> Result<CaromLoad, Failure> {
        match self.present_mut()? {
            Some(law) => Ok(law.advance(shift.into())?.into()),
            None => self.begin(pair, shift),
        }
    }
}

/// Moves the contact straight from the present shift to a new one. `load` may be null.
///
/// A `zeta` that is not positive separates the bodies, and the history is lost.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_contact_advance(
    pair: *const CaromPair,
    contact: *mut CaromContact,
    shift: CaromShift,
    load: *mut CaromLoad,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (pair, contact) = (read(pair, "pair")?, write(contact, "contact")?);
        // Checked before the contact is advanced.
        let place = if load.is_null() { None } else { Some(write(load, "load")?) };
        let load = contact.advance(pair, shift)?;
        if let Some(place) = place {
            *place = load;
        }
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The present load.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_contact_load(
    pair: *const CaromPair,
    contact: *const CaromContact,
    load: *mut CaromLoad,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    unsafe { ask(pair, contact, load, "load", error, |law| CaromLoad::from(law.load()).checked()) }
}

/// The elastic energy of the contact, compression included, J.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_contact_energy(
    pair: *const CaromPair,
    contact: *const CaromContact,
    energy: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    let stored = |law: &Law| Ok(RangeError::finite("energy", law.stored_energy())?);
    // SAFETY: the caller's promise.
    unsafe { ask(pair, contact, energy, "energy", error, stored) }
}

/// Writes the state of a contact as plain numbers, for a file or another process.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_contact_pack(
    pair: *const CaromPair,
    contact: *const CaromContact,
    state: *mut CaromState,
    error: *mut CaromError,
) -> CaromStatus {
    let pack = |law: &Law| {
        let mut state = CaromState { numbers: [0.0; crate::CAROM_STATE_NUMBERS] };
        law.pack(&mut state.numbers)?;
        Ok(state)
    };
    // SAFETY: the caller's promise.
    unsafe { ask(pair, contact, state, "state", error, pack) }
}

/// Makes a contact from a stored state. A contact that is not zero keeps its constants, which is faster: one
/// contact may read many states of a pair in turn.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_contact_unpack(
    pair: *const CaromPair,
    state: *const CaromState,
    contact: *mut CaromContact,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (pair, state) = (read(pair, "pair")?, read(state, "state")?);
        let contact = write(contact, "contact")?;
        let unpack = |law: &mut Law| {
            law.unpack(&state.numbers).map_err(|error| Failure::from(error).in_state())
        };
        if let Some(law) = contact.present_mut()? {
            return unpack(law);
        }
        let mut law = pair.law()?;
        unpack(&mut law)?;
        contact.keep(&law);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Evaluates a function of the law of a contact.
///
/// # Safety
/// As `carom_contact_load`.
unsafe fn ask<T>(
    pair: *const CaromPair,
    contact: *const CaromContact,
    answer: *mut T,
    name: &'static str,
    error: *mut CaromError,
    question: impl FnOnce(&Law) -> Result<T, Failure>,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (pair, contact) = (read(pair, "pair")?, read(contact, "contact")?);
        *write(answer, name)? = question(&contact.law(pair)?)?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}
