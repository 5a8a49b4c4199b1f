//! The contact of two grains, or of a grain and a wall, in memory of the caller.

pub(crate) mod bodies;
mod kind;
pub(crate) mod many;
pub(crate) mod packed;
mod parts;
pub(crate) mod report;
pub(crate) mod step;
pub(crate) mod told;

use carom_laws::grains::GrainRoll;
use carom_laws::torsion::law::StoredTwist;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::law::CaromLaw;
use crate::pointers::read;
use crate::stored::{present, seen};
use kind::Kind;

pub(crate) use kind::{RingTouch, ShiftTouch};

/// The state of the contact of two grains, or of a grain and a wall, in memory of the caller: `carom_touch_size(law)`
/// bytes, aligned to 8, that may be copied as bytes. Zero bytes stand for two separated bodies. Only the build that
/// wrote it can read it, and only with a law of the same kind; `carom_touch_pack` converts it to numbers that any build
/// of this `CAROM_STATE_VERSION` can read.
///
/// The constants are those of the step in which contact began. To change them, set the touch to zero.
#[derive(Debug)]
pub struct CaromTouch {
    _mark: u64,
}

impl CaromLaw {
    /// What tells the memories of this law from others with the same contact: which parts they have.
    #[inline(always)]
    fn tag(&self) -> u64 {
        (u64::from(self.has_torsion()) | u64::from(self.rolling().is_some()) << 1) << 33
    }

    /// The size of a touch whose contact is of this kind.
    fn size_of_touch<K: Kind>(&self) -> usize {
        let twist = if self.has_torsion() { size_of::<StoredTwist>() } else { 0 };
        let roll = if self.rolling().is_some() { size_of::<GrainRoll>() } else { 0 };
        size_of::<u64>() + size_of::<K>() + twist + roll
    }
}

/// A touch of a law whose contact is of this kind, in the caller's memory.
pub(crate) struct Place<K> {
    mark: *mut u64,
    contact: *mut K,
    tag: u64,
    /// Null if the law has none.
    twist: *mut StoredTwist,
    /// Likewise.
    roll: *mut GrainRoll,
}

impl<K: Kind> Place<K> {
    #[inline(always)]
    pub(crate) fn of(touch: *const CaromTouch, law: &CaromLaw) -> Self {
        let mark = touch.cast::<u64>().cast_mut();
        let contact = mark.wrapping_add(1).cast::<K>();
        let none = std::ptr::null_mut();
        let behind = contact.wrapping_add(1).cast::<StoredTwist>();
        let (twist, behind) = match law.has_torsion() {
            true => (behind, behind.wrapping_add(1).cast()),
            false => (none, behind.cast()),
        };
        let roll = if law.rolling().is_some() { behind } else { none.cast() };
        Self { mark, contact, tag: law.tag(), twist, roll }
    }

    /// The contact; none if the bodies are separated.
    ///
    /// # Safety
    /// The touch has the size that the law tells, and nobody else uses it during `'a`.
    #[inline(always)]
    pub(crate) unsafe fn present<'a>(&self) -> Result<Option<&'a mut K>, Failure> {
        // SAFETY: the caller's promise.
        unsafe { present(*self.mark, self.tag, self.contact) }
    }

    /// The contact, which is not changed.
    ///
    /// # Safety
    /// The touch has the size that the law tells, and nobody writes it during `'a`.
    pub(crate) unsafe fn seen<'a>(&self) -> Result<Option<&'a K>, Failure> {
        // SAFETY: the caller's promise.
        unsafe { seen(*self.mark, self.tag, self.contact) }
    }

    /// The bodies are separated.
    ///
    /// # Safety
    /// As [`Place::present`].
    unsafe fn clear(&self) {
        // SAFETY: the caller's promise.
        unsafe { *self.mark = 0 };
    }
}

/// The number of bytes of a touch of this law: 1272 of a law of shifts, 3296 of CAROM_LAW_RINGS; 752 more with torsion,
/// 72 more with a resistance to rolling. 0 for null.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_size(law: *const CaromLaw) -> usize {
    let mut size = 0;
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let law = read(law, "law")?;
        size = match law.is_by_rings() {
            true => law.size_of_touch::<RingTouch>(),
            false => law.size_of_touch::<ShiftTouch>(),
        };
        Ok(())
    };
    let unasked: *mut CaromError = std::ptr::null_mut();
    // SAFETY: there is no place for an error.
    let status = unsafe { border(unasked, call) };
    if status == CaromStatus::Ok { size } else { 0 }
}
