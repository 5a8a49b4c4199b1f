//! Checks whether bytes that may have been changed elsewhere are a valid law.

use std::mem::offset_of;

use super::{ShiftLaw, State, with_memory};
use crate::coulomb::{CoulombMemory, FixedCurve};
use crate::memory::{Fixed, Lateral, Memory, MemoryRegime, Nodes};
use crate::static_slip::StaticMemory;

/// The tags of [`State`].
pub(super) const FRICTIONLESS: u8 = 0;
pub(super) const FIXED_DIRECTION: u8 = 1;
pub(super) const COULOMB: u8 = 2;
pub(super) const ADHESION: u8 = 3;
pub(super) const STATIC_FIXED_DIRECTION: u8 = 4;
pub(super) const STATIC_COULOMB: u8 = 5;

impl<V: Lateral, const N: usize> ShiftLaw<V, Fixed<V, N>> {
    /// Whether bytes form a law, given the byte at each offset: they do if the tags of its state
    /// and of its regime are valid. All other parts of a law on a [`Fixed`] stack are numbers, for
    /// which any bytes are valid; [`ShiftLaw::fits`] checks their number. At most two bytes are
    /// read.
    #[inline(always)]
    #[must_use]
    pub fn is_in(byte: impl Fn(usize) -> u8) -> bool {
        let tag = offset_of!(Self, state);
        let memory = tag + align_of::<State<V, Fixed<V, N>>>();
        let regime = match byte(tag) {
            FRICTIONLESS | ADHESION => return true,
            FIXED_DIRECTION => Memory::<V, Fixed<V, N>>::REGIME_AT,
            COULOMB => CoulombMemory::<V, FixedCurve<V, N>>::REGIME_AT,
            STATIC_FIXED_DIRECTION => {
                StaticMemory::<Memory<V, Fixed<V, N>>>::MEMORY_AT
                    + Memory::<V, Fixed<V, N>>::REGIME_AT
            }
            STATIC_COULOMB => {
                StaticMemory::<CoulombMemory<V, FixedCurve<V, N>>>::MEMORY_AT
                    + CoulombMemory::<V, FixedCurve<V, N>>::REGIME_AT
            }
            _ => return false,
        };
        byte(memory + regime) < MemoryRegime::COUNT
    }

    /// Whether the number of vertices is at most the capacity, and zero for separated bodies only, by their approach and
    /// by their regime, and the lowest vertex is the deepest part of the contact, below every approach. It can be false
    /// only if the bytes were changed elsewhere.
    #[inline(always)]
    #[must_use]
    pub fn fits(&self) -> bool {
        with_memory!(&self.state, memory => {
            let stack = memory.stack();
            let (len, is_apart) = (stack.len(), memory.regime() == MemoryRegime::Separated);
            let is_empty = len == 0;
            len <= N
                && is_empty == is_apart
                && is_empty != (memory.zeta() > 0.0)
                && stack.get(0).depth == 0.0
        }, else true)
    }
}
