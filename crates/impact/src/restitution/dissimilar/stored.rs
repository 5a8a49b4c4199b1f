//! The table as bytes: a name of eight letters, the count of entries and a checksum of them, then the entries,
//! all little-endian.

use super::nodes::ENTRIES;

const NAME: &[u8; 8] = b"caromRx1";

/// R_x by rings may exceed 1 by their error.
const MOST: f32 = 1.01;

/// Made by `cargo xtask generate --tables`.
pub(super) static STORED: &[u8] = include_bytes!("stored.bin");

pub(super) fn to_bytes(entries: &[f32]) -> Vec<u8> {
    let mut bytes = NAME.to_vec();
    bytes.extend((entries.len() as u64).to_le_bytes());
    bytes.extend(checksum(entries).to_le_bytes());
    bytes.extend(entries.iter().flat_map(|entry| entry.to_le_bytes()));
    bytes
}

/// None for bytes that are no such table.
pub(super) fn from_bytes(bytes: &[u8]) -> Option<Vec<f32>> {
    let (name, rest) = bytes.split_first_chunk::<8>()?;
    let (count, rest) = rest.split_first_chunk::<8>()?;
    let (sum, rest) = rest.split_first_chunk::<8>()?;
    let (numbers, left) = rest.as_chunks::<4>();
    let entries: Vec<f32> = numbers.iter().map(|&number| f32::from_le_bytes(number)).collect();
    let holds = name == NAME
        && left.is_empty()
        && u64::from_le_bytes(*count) == ENTRIES as u64
        && entries.len() == ENTRIES
        && u64::from_le_bytes(*sum) == checksum(&entries)
        && entries.iter().all(|entry| entry.abs() <= MOST);
    holds.then_some(entries)
}

/// Fowler, Noll and Vo's, of the bits.
fn checksum(entries: &[f32]) -> u64 {
    entries.iter().fold(0xcbf2_9ce4_8422_2325, |sum, entry| {
        (sum ^ u64::from(entry.to_bits())).wrapping_mul(0x0000_0100_0000_01b3)
    })
}
