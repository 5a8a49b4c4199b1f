//! Versions.

use std::ffi::c_char;

/// Raised whenever a structure or a function of this header changes. Compare it with `carom_abi_version()` of
/// the loaded library.
pub const CAROM_ABI_VERSION: u32 = 13;

/// The version of the numbers of a `carom_state` and of a packed touch; files of another version cannot be read.
pub const CAROM_STATE_VERSION: u32 = 3;

/// The version of the library, as "0.1.0"; not to be freed.
#[unsafe(no_mangle)]
pub extern "C" fn carom_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}

/// The version of the structures and functions of this library.
#[unsafe(no_mangle)]
pub extern "C" fn carom_abi_version() -> u32 {
    CAROM_ABI_VERSION
}
