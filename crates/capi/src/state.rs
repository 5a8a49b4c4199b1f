//! What a contact remembers, as 66 numbers.

use carom_laws::coulomb::packed_numbers;

use crate::error::Failure;
use crate::pair::CaromPair;
use crate::stored::VERTICES;

/// The numbers in a `carom_state`.
pub const CAROM_STATE_NUMBERS: usize = 66;
const _: () = assert!(CAROM_STATE_NUMBERS == packed_numbers(VERTICES));

/// What a contact remembers, in 66 numbers, the caller's: zeros are two bodies that just touch, unshifted.
/// The numbers mean the same on any machine and in any build of this `carom_state_version()`, so
/// that they can be kept in files and sent to other processes. `carom_contact_pack` writes them,
/// `carom_contact_unpack` makes a contact of them, whose further way is the same to the bit. The friction of the
/// pair must be finite.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromState {
    /// Not to be changed but by the functions of this library.
    pub numbers: [f64; CAROM_STATE_NUMBERS],
}

/// Infinite friction does not fit into a state.
pub(crate) fn finite(pair: &CaromPair) -> Result<(), Failure> {
    let friction = pair.friction;
    let holds = friction != f64::INFINITY;
    carom_special::RangeError::check("friction", friction, holds, "finite for what is stored")?;
    Ok(())
}
