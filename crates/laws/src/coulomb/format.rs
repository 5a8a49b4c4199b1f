//! The format of a stored state: its numbers, their order and their ranges.

use carom_special::RangeError;

use super::piece::Node;
use crate::bounds::{LARGEST_ANCHOR, in_memory, stored_number};
use crate::memory::{Lateral, MemoryRegime as Regime};

/// Version of the format. The first number is `1e4 version + 100 regime + vertices`.
pub(super) const VERSION: f64 = 1.0;
pub(super) const HEAD_NUMBERS: usize = 6;
pub(super) const NUMBERS_PER_VERTEX: usize = 5;
/// The largest number of vertices that the first number can hold.
pub(super) const MAX_VERTICES: usize = 99;

/// Number of plain numbers for a state of this many vertices: 66 for 12.
///
/// ```
/// assert_eq!(carom_laws::coulomb::packed_numbers(12), 66);
/// ```
#[must_use]
pub const fn packed_numbers(vertices: usize) -> usize {
    HEAD_NUMBERS + NUMBERS_PER_VERTEX * vertices
}

/// The node of five numbers, without its force.
pub(super) fn node_of<V: Lateral>(numbers: &[f64]) -> Node<V> {
    Node {
        depth: numbers[0],
        root: numbers[0].sqrt(),
        anchor: V::from_components([numbers[1], numbers[2]]),
        bubble: V::from_components([numbers[3], numbers[4]]),
        force: V::default(),
        error: 0.0,
    }
}

/// The regime and the number of vertices, if the numbers have the format of a state.
pub(super) fn check_format(
    numbers: &[f64],
    capacity: usize,
) -> Result<(Regime, usize), RangeError> {
    let count = numbers.len() as f64;
    RangeError::check("numbers", count, numbers.len() >= HEAD_NUMBERS, ">= 6")?;
    let mark = if numbers[0] == 0.0 { 1e4 * VERSION } else { numbers[0] };
    let rest = mark - 1e4 * VERSION;
    let (regime, len) = ((rest / 100.0).floor(), rest.rem_euclid(100.0));
    let known = Regime::of_number(regime).filter(|_| len == len.floor());
    let regime = known.ok_or(RangeError::new("mark", mark, "of version 1"))?;
    let len = len as usize;
    let holds = len <= capacity && numbers.len() >= packed_numbers(len);
    RangeError::check("vertices", len as f64, holds, "not above the room for them")?;
    let (place, rest) = numbers[1..packed_numbers(len)].split_at(3);
    place.iter().try_for_each(|value| in_memory("numbers", *value).map(|_| ()))?;
    rest.iter().try_for_each(|value| stored_number(*value, LARGEST_ANCHOR).map(|_| ()))?;
    let mut below = -1.0;
    for vertex in numbers[HEAD_NUMBERS..].chunks_exact(NUMBERS_PER_VERTEX).take(len) {
        let depth = vertex[0];
        let rises = if below < 0.0 { depth == 0.0 } else { depth > below && depth < numbers[1] };
        RangeError::check("depth", depth, rises, "rising from 0 to below the approach")?;
        below = depth;
    }
    RangeError::check("approach", numbers[1], (numbers[1] > 0.0) == (len > 0), "> 0 in contact")?;
    Ok((regime, len))
}
