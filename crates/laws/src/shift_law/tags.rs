//! Whether bytes that may have been changed outside are still a law.

use std::mem::offset_of;

use super::{ShiftLaw, State};
use crate::coulomb::CoulombMemory;
use crate::memory::{Fixed, Lateral, Memory, MemoryRegime, VertexStack};

/// The tags of [`State`].
pub(super) const FREE: u8 = 0;
pub(super) const RUBBING: u8 = 1;
pub(super) const TURNING: u8 = 2;
pub(super) const STUCK: u8 = 3;

impl<V: Lateral, const N: usize> ShiftLaw<V, Fixed<V, N>> {
    /// Whether bytes are a law, given the byte at each place: they are if the tags of its state and of its
    /// regime are known ones. All else in a law on a [`Fixed`] stack are numbers, and any bytes are numbers; what
    /// these mean is not looked at ([`ShiftLaw::fits`]). At most two bytes are asked for.
    #[inline(always)]
    #[must_use]
    pub fn is_in(byte: impl Fn(usize) -> u8) -> bool {
        let tag = offset_of!(Self, state);
        let memory = tag + align_of::<State<V, Fixed<V, N>>>();
        let regime = match byte(tag) {
            FREE | STUCK => return true,
            RUBBING => Memory::<V, Fixed<V, N>>::REGIME_AT,
            TURNING => CoulombMemory::<V, Fixed<V, N>>::REGIME_AT,
            _ => return false,
        };
        byte(memory + regime) < MemoryRegime::COUNT
    }

    /// Whether its vertices are not more than there is room for, and none only where the bodies are apart: so it
    /// is but in bytes that were changed outside.
    #[inline(always)]
    #[must_use]
    pub fn fits(&self) -> bool {
        let (zeta, len) = match &self.state {
            State::Free => return true,
            State::Rubbing(memory) => (memory.zeta(), memory.stack().len()),
            State::Turning(memory) => (memory.zeta(), memory.stack().len()),
            State::Stuck(memory) => (memory.zeta(), memory.stack().len()),
        };
        len <= N && (len == 0) != (zeta > 0.0)
    }
}
