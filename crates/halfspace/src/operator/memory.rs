//! How much memory an operator may take.

use super::OperatorError;

/// Where the system does not tell: more than any machine this runs on has.
const UNKNOWN: u128 = 1 << 40;

/// Bytes that the system can give without swapping.
fn available() -> u128 {
    std::fs::read_to_string("/proc/meminfo")
        .ok()
        .and_then(|text| {
            let line = text.lines().find(|line| line.starts_with("MemAvailable:"))?;
            line.split_whitespace().nth(1)?.parse::<u128>().ok()
        })
        .map_or(UNKNOWN, |kilobytes| kilobytes * 1024)
}

/// Ok if `needed` bytes can be had.
pub(crate) fn check(needed: u128) -> Result<(), OperatorError> {
    let available = available();
    if needed > available {
        return Err(OperatorError::TooLarge { needed, available });
    }
    Ok(())
}
