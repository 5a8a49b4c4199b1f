//! Status codes, and what is wrong in words, in the caller's own memory.

use std::ffi::c_char;
use std::panic::{AssertUnwindSafe, catch_unwind};

use carom_special::RangeError;

/// How a call ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(i32)]
pub enum CaromStatus {
    /// All is done.
    Ok = 0,
    /// A pointer that must not be null is.
    NullPointer = 1,
    /// A pointer or a stride is not aligned to what it points to.
    Misaligned = 2,
    /// A value is out of range: `carom_error` names its field.
    OutOfRange = 3,
    /// A state is neither zero nor one that this library wrote.
    BadState = 4,
    /// The bodies make no contact that can be computed.
    NoContact = 5,
    /// The impact could not be followed to its end.
    NotFollowed = 6,
    /// A fault in this library; nothing can be said about the results.
    Internal = 7,
}

/// What was wrong: filled in by a call that does not return `CAROM_STATUS_OK`, else left alone.
#[derive(Debug, Clone, Copy)]
#[repr(C)]
pub struct CaromError {
    /// The entry of an array, counted from 0; -1 where there is no array.
    pub index: i64,
    /// The value of the field; 0 where there is none.
    pub value: f64,
    /// The name of the field or argument; empty where there is none. Ends with a zero.
    pub field: [c_char; 40],
    /// A sentence for a person. Ends with a zero.
    pub text: [c_char; 200],
}

/// A few words for each status; never null, and not to be freed.
#[unsafe(no_mangle)]
pub extern "C" fn carom_status_text(status: i32) -> *const c_char {
    let text = match status {
        0 => c"all is done",
        1 => c"a pointer that must not be null is",
        2 => c"a pointer or a stride is not aligned",
        3 => c"a value is out of range",
        4 => c"a state is neither zero nor one that this library wrote",
        5 => c"the bodies make no contact that can be computed",
        6 => c"the impact could not be followed to its end",
        7 => c"a fault in the library",
        _ => c"no status of this library",
    };
    text.as_ptr()
}

/// What went wrong inside.
#[derive(Debug)]
pub(crate) struct Failure {
    pub(crate) status: CaromStatus,
    pub(crate) index: Option<usize>,
    pub(crate) field: &'static str,
    pub(crate) value: f64,
    pub(crate) text: String,
}

impl Failure {
    /// A failure in words.
    #[cold]
    pub(crate) fn new(
        status: CaromStatus,
        field: &'static str,
        text: impl std::fmt::Display,
    ) -> Self {
        Self { status, index: None, field, value: 0.0, text: text.to_string() }
    }

    /// The same in an entry of an array.
    pub(crate) fn at(self, index: usize) -> Self {
        Self { index: Some(index), ..self }
    }

    /// The same as what is wrong with a state.
    pub(crate) fn in_state(self) -> Self {
        Self { status: CaromStatus::BadState, ..self }
    }

    fn write(&self, error: &mut CaromError) {
        error.index = self.index.and_then(|index| i64::try_from(index).ok()).unwrap_or(-1);
        error.value = self.value;
        copy(self.field, &mut error.field);
        copy(&self.text, &mut error.text);
    }
}

/// As much of a text as there is room for, and zeros.
fn copy(text: &str, to: &mut [c_char]) {
    let fits = |len: &usize| text.is_char_boundary(*len);
    let len = (0..to.len()).rev().find(fits).unwrap_or(0);
    to.fill(0);
    for (to, byte) in to.iter_mut().zip(&text.as_bytes()[..len]) {
        *to = *byte as c_char;
    }
}

impl From<RangeError> for Failure {
    #[cold]
    fn from(error: RangeError) -> Self {
        let value = error.value;
        Self { value, ..Self::new(CaromStatus::OutOfRange, error.field, error) }
    }
}

/// Runs a call behind the border: failures and panics become a status, and words if these are wanted.
///
/// # Safety
/// `error` is null or points to a `CaromError` that may be written.
pub(crate) unsafe fn border(
    error: *mut CaromError,
    call: impl FnOnce() -> Result<(), Failure>,
) -> CaromStatus {
    // What a call has not finished it has not written, so that nothing broken is seen afterwards.
    let failure = match catch_unwind(AssertUnwindSafe(call)) {
        Ok(Ok(())) => return CaromStatus::Ok,
        Ok(Err(failure)) => failure,
        Err(_) => Failure::new(CaromStatus::Internal, "", "a fault in the library: please report"),
    };
    if !error.is_null() && error.is_aligned() {
        // SAFETY: the caller's promise.
        failure.write(unsafe { &mut *error });
    }
    failure.status
}
