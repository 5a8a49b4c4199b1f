//! A history of a twist in fixed room.

use carom_special::RangeError;

use super::TwistHistory;
use super::pack::{check, packed_numbers};

/// Pieces of a history that are kept exactly, one or two for each reversal; beyond that those that matter least are
/// joined. Over random histories the error of the torque was then below 3e-4 of the sliding torque in the mean, and .02
/// at most.
const PIECES: usize = 12;

/// A history as the numbers of [`TwistHistory::pack`], which may be kept as bytes; zeros stand for first contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub(in crate::torsion) struct StoredHistory {
    numbers: [f64; Self::NUMBERS],
}

impl StoredHistory {
    /// Number of its numbers.
    pub(in crate::torsion) const NUMBERS: usize = packed_numbers(PIECES);
    /// Bodies at first contact.
    pub(in crate::torsion) const NEW: Self = Self { numbers: [0.0; Self::NUMBERS] };

    /// Checks numbers whose bytes may have been changed elsewhere, as far as a step needs it.
    pub(in crate::torsion) fn check(&self) -> Result<(), RangeError> {
        check(&self.numbers)
    }

    pub(in crate::torsion) fn history(&self) -> TwistHistory {
        TwistHistory::of(&self.numbers)
    }

    pub(in crate::torsion) fn keep(&mut self, history: &TwistHistory) {
        // There is room for more than the four pieces that it asks for.
        if history.pack(&mut self.numbers).is_err() {
            *self = Self::NEW;
        }
    }

    /// The history of the last numbers.
    pub(in crate::torsion) fn of(numbers: &[f64]) -> Self {
        numbers.last_chunk().map_or(Self::NEW, |numbers| Self { numbers: *numbers })
    }

    pub(in crate::torsion) const fn numbers(&self) -> &[f64; Self::NUMBERS] {
        &self.numbers
    }
}
