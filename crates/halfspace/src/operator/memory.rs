//! How much memory an operator may take.

use super::OperatorError;
use crate::room;

/// Ok if `needed` bytes can be had.
pub(crate) fn check(needed: u128) -> Result<(), OperatorError> {
    let available = room::available();
    if needed > available {
        return Err(OperatorError::TooLarge { needed, available });
    }
    Ok(())
}
