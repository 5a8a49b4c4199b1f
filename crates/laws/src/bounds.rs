//! Bounds on arguments within which forces and energies cannot overflow.

use carom_special::RangeError;

/// Checks an approach or shift of a memory, whose energy is of the order 5/2.
pub(crate) fn in_memory(field: &'static str, value: f64) -> Result<f64, RangeError> {
    RangeError::check(field, value, value.abs() <= LARGEST_IN_MEMORY, "at most 1e100 in magnitude")
}

/// Bodies that approach by no more than this do not touch yet: of what is smaller, squares underflow. It is far below
/// the rounding of any position, and so are the loads at it.
pub(crate) const LEAST_APPROACH: f64 = 1e-130;

/// A distance with a smaller square is below the rounding of every approach above [`LEAST_APPROACH`].
pub(crate) const LEAST_SQUARE: f64 = f64::MIN_POSITIVE / f64::EPSILON;

/// The largest magnitude in a memory.
pub(crate) const LARGEST_IN_MEMORY: f64 = 1e100;

/// Checks an anchor, stretch or depth of a stored memory: those of shifts within [`LARGEST_IN_MEMORY`] are smaller.
pub(crate) fn in_stored_memory(field: &'static str, value: f64) -> Result<f64, RangeError> {
    RangeError::check(field, value, value.abs() <= 1e101, "of a possible state")
}

/// The largest magnitude in the units of the user.
pub(crate) const LARGEST: f64 = 1e60;

/// Checks a shift, twist or contact radius in the units of the user; energies are of the order 5 in
/// the radius.
pub(crate) fn in_contact(field: &'static str, value: f64) -> Result<f64, RangeError> {
    RangeError::check(field, value, value.abs() <= LARGEST, "at most 1e60 in magnitude")
}

/// Range of the stiffnesses and lengths of a contact, for which no force and no energy leaves the range of numbers.
const CONSTANTS: std::ops::RangeInclusive<f64> = 1e-60..=1e60;

/// Checks a stiffness or a length that is a constant of a contact.
pub(crate) fn constant(field: &'static str, value: f64) -> Result<f64, RangeError> {
    RangeError::check(field, value, CONSTANTS.contains(&value), "from 1e-60 to 1e60")
}
