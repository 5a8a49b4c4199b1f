//! Status codes, and error messages in the caller's memory.

use std::ffi::c_char;
use std::panic::{AssertUnwindSafe, catch_unwind};

use carom_special::RangeError;

/// Result of a call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(i32)]
pub enum CaromStatus {
    /// Success.
    Ok = 0,
    /// A required pointer is null.
    NullPointer = 1,
    /// A pointer or a stride is not aligned to its type.
    Misaligned = 2,
    /// A value is out of range; `carom_error` names the field.
    OutOfRange = 3,
    /// A state is not zero and was not written by this library.
    BadState = 4,
    /// The bodies have no contact that this library can compute.
    NoContact = 5,
    /// The impact could not be computed to separation.
    NotFollowed = 6,
    /// Internal error of this library; the results are not valid.
    Internal = 7,
}

/// Describes an error: `text` is the message to print, `field` and `value` say what was wrong. Filled in by a
/// call that does not return `CAROM_STATUS_OK`, otherwise not changed.
#[derive(Debug, Clone, Copy)]
#[repr(C)]
pub struct CaromError {
    /// Index of the array entry, from 0; -1 if no array is concerned.
    pub index: i64,
    /// The value of the field; 0 if it has none.
    pub value: f64,
    /// The name of the field or argument, or an empty string. Zero-terminated.
    pub field: [c_char; 40],
    /// The message, a sentence such as "friction = -1 is out of range: must be >= 0". Zero-terminated.
    pub text: [c_char; 200],
}

/// A short text for each status. Never null, and not to be freed.
#[unsafe(no_mangle)]
pub extern "C" fn carom_status_text(status: i32) -> *const c_char {
    let text = match status {
        0 => c"success",
        1 => c"a required pointer is null",
        2 => c"a pointer or a stride is not aligned",
        3 => c"a value is out of range",
        4 => c"a state is not zero and was not written by this library",
        5 => c"the bodies have no contact that can be computed",
        6 => c"the impact could not be computed to separation",
        7 => c"an internal error of the library",
        _ => c"not a status of this library",
    };
    text.as_ptr()
}

/// An error before it is written for the caller. It is one word, since each result that may hold an error is moved, also
/// if it holds none.
#[derive(Debug)]
pub(crate) struct Failure(Box<Details>);

#[derive(Debug)]
struct Details {
    status: CaromStatus,
    index: Option<usize>,
    field: &'static str,
    value: f64,
    text: String,
}

impl Failure {
    /// An error with a message.
    #[cold]
    pub(crate) fn new(
        status: CaromStatus,
        field: &'static str,
        text: impl std::fmt::Display,
    ) -> Self {
        let text = text.to_string();
        Self(Box::new(Details { status, index: None, field, value: 0.0, text }))
    }

    /// An error of the library itself.
    #[cold]
    pub(crate) fn internal() -> Self {
        Self::new(CaromStatus::Internal, "", "an internal error of the library: please report it")
    }

    /// The same error with the value of the field.
    #[cold]
    pub(crate) fn with_value(mut self, value: f64) -> Self {
        self.0.value = value;
        self
    }

    /// The same error at an entry of an array.
    #[cold]
    pub(crate) fn at(mut self, index: usize) -> Self {
        self.0.index = Some(index);
        self
    }

    /// The same error, reported as an invalid state.
    #[cold]
    pub(crate) fn in_state(mut self) -> Self {
        self.0.status = CaromStatus::BadState;
        self
    }

    fn write(&self, error: &mut CaromError) {
        let Details { index, value, field, text, .. } = &*self.0;
        error.index = index.and_then(|index| i64::try_from(index).ok()).unwrap_or(-1);
        error.value = *value;
        copy(field, &mut error.field);
        copy(text, &mut error.text);
    }
}

/// Copies as much of a text as fits, and fills up with zeros.
pub(crate) fn copy(text: &str, to: &mut [c_char]) {
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
        Self::new(CaromStatus::OutOfRange, error.field, error).with_value(error.value)
    }
}

/// Runs a call at the C border: errors and panics become a status, with a message if `error` is not null.
///
/// # Safety
/// `error` is null or points to a `CaromError` that may be written.
pub(crate) unsafe fn border(
    error: *mut CaromError,
    call: impl FnOnce() -> Result<(), Failure>,
) -> CaromStatus {
    // A call writes its results only at the end, so that a panic leaves no partial result.
    let failure = match catch_unwind(AssertUnwindSafe(call)) {
        Ok(Ok(())) => return CaromStatus::Ok,
        Ok(Err(failure)) => failure,
        Err(_) => Failure::internal(),
    };
    if !error.is_null() && error.is_aligned() {
        // SAFETY: the caller's promise.
        failure.write(unsafe { &mut *error });
    }
    failure.0.status
}
