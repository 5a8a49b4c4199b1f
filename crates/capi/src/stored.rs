//! Values of this library in bytes of the caller. A mark names the build that wrote them; tags and counts are
//! checked before the bytes are used.

use crate::error::{CaromStatus, Failure};
use crate::shift::Law;
use crate::touch::{RingTouch, ShiftTouch};

/// A type that may be stored in bytes of the caller: numbers and tags, without pointers.
///
/// # Safety
/// Any bytes for which `is_in` returns true are a valid value.
pub(crate) unsafe trait Stored: Copy + 'static {
    /// The name of the type in error messages.
    const NAME: &'static str;

    /// Whether bytes are a valid value; `byte` gives the byte at each offset.
    fn is_in(byte: impl Fn(usize) -> u8) -> bool;

    /// Whether its counts are within their bounds.
    fn fits(&self) -> bool;

    /// Identifies the build that wrote the bytes: compiler, which decides on the layout, version and size.
    const MARK: u64 = {
        const { assert!(align_of::<Self>() <= 8 && !std::mem::needs_drop::<Self>()) };
        let build = hash(BASIS, concat!(env!("CAROM_COMPILER"), " ", env!("CARGO_PKG_VERSION")));
        hash(build, Self::NAME) ^ ((size_of::<Self>() as u64) << 1) | 1
    };
}

// SAFETY: apart from the tags it consists of numbers.
unsafe impl Stored for Law {
    const NAME: &'static str = "contact";

    #[inline(always)]
    fn is_in(byte: impl Fn(usize) -> u8) -> bool {
        Self::is_in(byte)
    }

    #[inline(always)]
    fn fits(&self) -> bool {
        self.fits()
    }
}

// SAFETY: as above.
unsafe impl Stored for ShiftTouch {
    const NAME: &'static str = "touch";

    #[inline(always)]
    fn is_in(byte: impl Fn(usize) -> u8) -> bool {
        Self::is_in(byte)
    }

    #[inline(always)]
    fn fits(&self) -> bool {
        self.law().fits()
    }
}

// SAFETY: it consists of numbers.
unsafe impl Stored for RingTouch {
    const NAME: &'static str = "touch";

    #[inline(always)]
    fn is_in(_byte: impl Fn(usize) -> u8) -> bool {
        true
    }

    #[inline(always)]
    fn fits(&self) -> bool {
        self.memory.fits()
    }
}

/// The stored value, if mark, tags and counts are valid; none if the mark is zero. `tag` tells memories of one type apart.
///
/// # Safety
/// `place` is aligned, and nobody writes its bytes during `'a`; if the mark matches, they are initialised.
#[inline(always)]
pub(crate) unsafe fn seen<'a, T: Stored>(
    mark: u64,
    tag: u64,
    place: *const T,
) -> Result<Option<&'a T>, Failure> {
    if mark == 0 {
        return Ok(None);
    }
    let bytes = place.cast::<u8>();
    // SAFETY: the tags lie within the size.
    if mark ^ tag == T::MARK && T::is_in(|at| unsafe { bytes.add(at).read() }) {
        // SAFETY: the caller's promise, and the bytes are a valid value.
        let value = unsafe { &*place };
        if value.fits() {
            return Ok(Some(value));
        }
    }
    Err(strange::<T>())
}

/// The same, to be changed.
///
/// # Safety
/// As [`seen`], and nobody else uses the bytes.
#[inline(always)]
pub(crate) unsafe fn present<'a, T: Stored>(
    mark: u64,
    tag: u64,
    place: *mut T,
) -> Result<Option<&'a mut T>, Failure> {
    // SAFETY: the caller's promise.
    let holds_one = unsafe { seen(mark, tag, place)?.is_some() };
    // SAFETY: as above.
    Ok(holds_one.then(|| unsafe { &mut *place }))
}

#[cold]
fn strange<T: Stored>() -> Failure {
    let name = T::NAME;
    let text = format_args!(
        "the {name} was written by another build of carom, or its bytes are not valid"
    );
    Failure::new(CaromStatus::BadState, name, text)
}

/// The offset basis of FNV-1a in 64 bits.
const BASIS: u64 = 0xcbf2_9ce4_8422_2325;

/// FNV-1a of a text.
const fn hash(mut hash: u64, text: &str) -> u64 {
    let bytes = text.as_bytes();
    let mut i = 0;
    while i < bytes.len() {
        hash = (hash ^ bytes[i] as u64).wrapping_mul(0x0000_0100_0000_01b3);
        i += 1;
    }
    hash
}
