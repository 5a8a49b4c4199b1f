//! Options that know their size, so that later versions may add fields.

use crate::error::{CaromStatus, Failure};
use crate::pointers::read;

/// A struct of options whose first field is its size in bytes.
///
/// # Safety
/// It has the layout of C, begins with a `usize`, and any bytes are a valid value.
pub(crate) unsafe trait SizedOptions: Copy + Default {
    /// Copies as many bytes as the caller's struct has; null gives the defaults.
    ///
    /// # Safety
    /// `options` is null, or may be read for the number of bytes in its first field.
    unsafe fn of(options: *const Self) -> Result<Self, Failure> {
        let mut known = Self::default();
        if options.is_null() {
            return Ok(known);
        }
        // SAFETY: the caller's promise.
        let size = unsafe { *read(options.cast::<usize>(), "options")? };
        let (least, most) = (size_of::<usize>(), size_of::<Self>());
        if !(least..=most).contains(&size) {
            let text =
                format_args!("size = {size} is out of range: must be from {least} to {most}");
            return Err(Failure::new(CaromStatus::OutOfRange, "size", text));
        }
        let to = (&raw mut known).cast::<u8>();
        // SAFETY: `size` bytes may be read and fit; every bit pattern is a valid value.
        unsafe { options.cast::<u8>().copy_to_nonoverlapping(to, size) };
        Ok(known)
    }
}
