//! Bounds of what a law is told, within which forces and energies cannot overflow.

use carom_special::RangeError;

/// Approaches and shifts of a memory: energies go as their power 5/2 together.
pub(crate) fn in_memory(field: &'static str, value: f64) -> Result<f64, RangeError> {
    RangeError::check(field, value, value.abs() <= LARGEST_IN_MEMORY, "of size up to 1e100")
}

/// The largest of a memory's.
pub(crate) const LARGEST_IN_MEMORY: f64 = 1e100;

/// The largest of the user's own units.
pub(crate) const LARGEST: f64 = 1e60;

/// Shifts and twists in the user's units, and contact radii, of which energies are fifth powers.
pub(crate) fn in_contact(field: &'static str, value: f64) -> Result<f64, RangeError> {
    RangeError::check(field, value, value.abs() <= LARGEST, "of size up to 1e60")
}
