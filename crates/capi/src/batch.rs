//! Many contacts of one pair in one call.

use crate::contact::CaromContact;
use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::law::{CaromLoad, CaromShift, Kept};
use crate::pair::CaromPair;
use crate::pointers::{Strided, read};
use crate::state::{CaromState, Worker, finite};

use carom_laws::law::{Checked as _, Shift};

/// Advances many contacts of one pair, contact i by its own shift. The strides are the bytes from one
/// entry to the next, so that the arrays may be columns of larger structures; `loads` may be null.
///
/// All shifts are checked before anything moves: if one is out of range nothing is changed, and
/// `error->index` names it. A state that is none ends the call at its index: those before it have
/// been advanced.
///
/// # Safety
/// `pair` is null or may be read. `states`, `shifts` and `loads` are null, or each of their `count`
/// entries may be read and, but for the shifts, written; none overlaps another. `error` is null or
/// may be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_state_advance_many(
    pair: *const CaromPair,
    count: usize,
    states: *mut CaromState,
    state_stride: usize,
    shifts: *const CaromShift,
    shift_stride: usize,
    loads: *mut CaromLoad,
    load_stride: usize,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let pair = read(pair, "pair")?;
        finite(pair)?;
        let mut law: Worker = pair.law()?;
        let states = Strided::apart(states, state_stride, count, "states")?;
        let arrays = Arrays::new(count, (shifts, shift_stride), (loads, load_stride))?;
        arrays.check(&law)?;
        arrays.advance(states, |state, shift| state.step(&mut law, shift))
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Advances many contacts of one pair, as `carom_state_advance_many`.
///
/// # Safety
/// As `carom_state_advance_many`; each contact is as in `carom_contact_advance`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_contact_advance_many(
    pair: *const CaromPair,
    count: usize,
    contacts: *mut CaromContact,
    contact_stride: usize,
    shifts: *const CaromShift,
    shift_stride: usize,
    loads: *mut CaromLoad,
    load_stride: usize,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let pair = read(pair, "pair")?;
        let law: Worker = pair.law()?;
        let contacts = Strided::apart(contacts, contact_stride, count, "contacts")?;
        let arrays = Arrays::new(count, (shifts, shift_stride), (loads, load_stride))?;
        arrays.check(&law)?;
        arrays.advance(contacts, |contact, shift| contact.advance(pair, shift))
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// What goes into many contacts and comes out.
struct Arrays {
    count: usize,
    shifts: Strided<CaromShift>,
    loads: Option<Strided<CaromLoad>>,
}

impl Arrays {
    fn new(
        count: usize,
        (shifts, shift_stride): (*const CaromShift, usize),
        (loads, load_stride): (*mut CaromLoad, usize),
    ) -> Result<Self, Failure> {
        let shifts = Strided::new(shifts.cast_mut(), shift_stride, count, "shifts")?;
        let loads = match loads.is_null() {
            true => None,
            false => Some(Strided::apart(loads, load_stride, count, "loads")?),
        };
        Ok(Self { count, shifts, loads })
    }

    /// # Safety
    /// The entries may be read.
    unsafe fn check(&self, law: &Worker) -> Result<(), Failure> {
        for i in 0..self.count {
            // SAFETY: the caller's promise.
            let shift = Shift::from(unsafe { *self.shifts.at(i) });
            law.check(shift).map_err(|error| Failure::from(error).at(i))?;
        }
        Ok(())
    }

    /// # Safety
    /// The entries may be read and written, and none overlaps another.
    unsafe fn advance<K>(
        &self,
        kept: Strided<K>,
        mut step: impl FnMut(&mut K, CaromShift) -> Result<CaromLoad, Failure>,
    ) -> Result<(), Failure> {
        for i in 0..self.count {
            // SAFETY: the caller's promise.
            let (kept, shift) = unsafe { (&mut *kept.at(i), *self.shifts.at(i)) };
            let load = step(kept, shift).map_err(|failure| failure.at(i))?;
            if let Some(loads) = &self.loads {
                // SAFETY: the caller's promise.
                unsafe { *loads.at(i) = load };
            }
        }
        Ok(())
    }
}
