//! Checks the memory that an operator needs.

use super::OperatorError;
use crate::room;

/// An error unless `needed` bytes are available.
pub(crate) fn check(needed: u128) -> Result<(), OperatorError> {
    let available = room::available();
    if needed > available {
        return Err(OperatorError::TooLarge { needed, available });
    }
    Ok(())
}
