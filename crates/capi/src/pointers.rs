//! Checks the caller's pointers and turns them into references.

use crate::error::{CaromStatus, Failure};

/// A reference to a value that is read.
///
/// # Safety
/// A pointer that is neither null nor misaligned points to a `T` that nobody writes during `'a`.
#[inline]
pub(crate) unsafe fn read<'a, T>(pointer: *const T, name: &'static str) -> Result<&'a T, Failure> {
    check(pointer, name)?;
    // SAFETY: neither null nor misaligned; the rest is the caller's promise.
    Ok(unsafe { &*pointer })
}

/// A reference to a value that is written.
///
/// # Safety
/// A pointer that is neither null nor misaligned points to a `T` that nobody else reads or writes during
/// `'a`.
#[inline]
pub(crate) unsafe fn write<'a, T>(
    pointer: *mut T,
    name: &'static str,
) -> Result<&'a mut T, Failure> {
    check(pointer, name)?;
    // SAFETY: neither null nor misaligned; the rest is the caller's promise.
    Ok(unsafe { &mut *pointer })
}

/// A thing to be written; none where the pointer is null.
///
/// # Safety
/// As [`write()`].
#[inline]
pub(crate) unsafe fn write_or_null<'a, T>(
    pointer: *mut T,
    name: &'static str,
) -> Result<Option<&'a mut T>, Failure> {
    if pointer.is_null() {
        return Ok(None);
    }
    // SAFETY: the caller's promise.
    unsafe { write(pointer, name) }.map(Some)
}

/// Whether a pointer is neither null nor misaligned.
#[inline]
pub(crate) fn is_place<T>(pointer: *const T) -> bool {
    !pointer.is_null() && pointer.is_aligned()
}

#[inline]
fn check<T>(pointer: *const T, name: &'static str) -> Result<(), Failure> {
    if is_place(pointer) { Ok(()) } else { Err(no_place(pointer.is_null(), name, align_of::<T>())) }
}

/// The error of a pointer that is null or, if not, misaligned.
#[cold]
#[inline(never)]
fn no_place(is_null: bool, name: &'static str, align: usize) -> Failure {
    if is_null {
        let text = format_args!("{name} is a null pointer");
        return Failure::new(CaromStatus::NullPointer, name, text);
    }
    let text = format_args!("{name} is not aligned to {align} bytes");
    Failure::new(CaromStatus::Misaligned, name, text)
}

/// Entries of a caller's array, a given number of bytes from one to the next.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Strided<T> {
    first: *mut T,
    stride: usize,
}

impl<T> Strided<T> {
    /// An array of `count` entries; a stride of 0 repeats the first entry.
    pub(crate) fn new(
        first: *mut T,
        stride: usize,
        count: usize,
        name: &'static str,
    ) -> Result<Self, Failure> {
        if count > 0 {
            check(first, name)?;
        }
        if !stride.is_multiple_of(align_of::<T>()) {
            let text = format_args!("the stride of {name}, {stride}, does not keep its alignment");
            return Err(Failure::new(CaromStatus::Misaligned, name, text));
        }
        Ok(Self { first, stride })
    }

    /// An array of entries that are written: none may overlap another.
    pub(crate) fn apart(
        first: *mut T,
        stride: usize,
        count: usize,
        name: &'static str,
    ) -> Result<Self, Failure> {
        if count > 1 && stride < size_of::<T>() {
            let text = format_args!("the stride of {name}, {stride}, lets its entries overlap");
            return Err(Failure::new(CaromStatus::Misaligned, name, text));
        }
        Self::new(first, stride, count, name)
    }

    /// The address of an entry.
    #[inline]
    pub(crate) fn at(&self, index: usize) -> *mut T {
        self.first.wrapping_byte_add(index * self.stride)
    }
}
