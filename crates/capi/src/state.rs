//! The state of a contact as 66 numbers, for storage.

use carom_laws::coulomb::packed_numbers;

use crate::shift::VERTICES;

/// Number of numbers in a `carom_state`.
pub const CAROM_STATE_NUMBERS: usize = 66;
const _: () = assert!(CAROM_STATE_NUMBERS == packed_numbers(VERTICES));

/// The state of a contact as 66 numbers, in memory of the caller; zeros stand for two bodies that just touch,
/// without shift. The numbers mean the same on any machine and in any build of this `CAROM_STATE_VERSION`,
/// so that they can be stored in files and sent to other processes. `carom_contact_pack` writes them;
/// `carom_contact_unpack` makes a contact from them, which continues with the same bits. The friction of the
/// pair must be finite.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromState {
    /// Written by this library only.
    pub numbers: [f64; CAROM_STATE_NUMBERS],
}
