//! Advances many contacts of one pair in one call.

use crate::contact::CaromContact;
use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::pair::CaromPair;
use crate::pointers::{Strided, read};
use crate::shift::{CaromLoad, CaromShift, Law};

use carom_laws::law::{Checked as _, Shift};

/// Advances many contacts of one pair, contact i by shift i. A stride is the number of bytes from one entry
/// to the next, so that the arrays may be columns of larger structures. `loads` may be null.
///
/// All shifts are checked before any contact is advanced: if one is out of range, nothing is changed and
/// `error->index` names it. An invalid contact ends the call at its index; those before it have been
/// advanced.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
/// `contacts`, `shifts` and, unless null, `loads` must have `count` entries, of which no two overlap.
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
        let law: Law = pair.law()?;
        let contacts = Strided::apart(contacts, contact_stride, count, "contacts")?;
        let arrays = Arrays::new(count, (shifts, shift_stride), (loads, load_stride))?;
        arrays.check(&law)?;
        arrays.advance(pair, contacts)
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// Input shifts and output loads of a call on many contacts.
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
    unsafe fn check(&self, law: &Law) -> Result<(), Failure> {
        for i in 0..self.count {
            // SAFETY: the caller's promise.
            let shift = Shift::from(unsafe { *self.shifts.at(i) });
            law.check(shift).map_err(|error| Failure::from(error).at(i))?;
        }
        Ok(())
    }

    /// # Safety
    /// The entries may be read and written, and none overlaps another.
    unsafe fn advance(
        &self,
        pair: &CaromPair,
        contacts: Strided<CaromContact>,
    ) -> Result<(), Failure> {
        for i in 0..self.count {
            // SAFETY: the caller's promise.
            let (contact, shift) = unsafe { (&mut *contacts.at(i), *self.shifts.at(i)) };
            let load = contact.advance(pair, shift).map_err(|failure| failure.at(i))?;
            if let Some(loads) = &self.loads {
                // SAFETY: the caller's promise.
                unsafe { *loads.at(i) = load };
            }
        }
        Ok(())
    }
}
