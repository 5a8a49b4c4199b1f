//! Checks whether numbers from outside are a possible state of the memory.

use carom_special::RangeError;

use super::format::{HEAD_NUMBERS, NUMBERS_PER_VERTEX, node_of};
use super::piece::{End, Piece};
use crate::memory::Lateral;

/// How far W may lie beyond the friction cone, at ends and middles of pieces, over the approach:
/// the error of the law. At most 0.07 was seen, where pieces were merged because storage was full,
/// in four million states of four or more vertices.
const CONE_EXCESS: f64 = 0.25;
/// The same over the shift and W: round-off of their difference.
const SHIFT_ROUND_OFF: f64 = 1e-12;
/// How far the force may exceed its limit, relative; at most 2e-11 was seen.
const FORCE_EXCESS: f64 = 1e-6;

/// Checks that the curve lies within the friction cone, `|X - W(s)| <= zeta - s`, the force within
/// its limit `zeta^(3/2)`, and the slip front within the contact.
pub(super) fn check_meaning<V: Lateral>(numbers: &[f64], len: usize) -> Result<(), RangeError> {
    let [zeta, front, extent] = [numbers[1].max(0.0), numbers[4], numbers[5]];
    let holds = (0.0..=zeta).contains(&front);
    RangeError::check("front", front, holds, "from 0 to the approach")?;
    RangeError::non_negative("extent", extent)?;
    let shift = V::from_components([numbers[2], numbers[3]]);
    let size = SHIFT_ROUND_OFF * shift.length();
    let mut high = End { depth: zeta, root: zeta.sqrt(), anchor: shift };
    let mut force = V::default();
    for vertex in numbers[HEAD_NUMBERS..HEAD_NUMBERS + NUMBERS_PER_VERTEX * len]
        .chunks_exact(NUMBERS_PER_VERTEX)
        .rev()
    {
        let node = node_of::<V>(vertex);
        let piece = Piece::new(&node, high);
        let [x, y] = node.anchor.components();
        let round_off = size + SHIFT_ROUND_OFF * (x.abs() + y.abs());
        check_distance(
            node.anchor,
            shift,
            zeta - node.depth + CONE_EXCESS * zeta + round_off,
            "anchor",
        )?;
        let limit = zeta - piece.middle_depth();
        check_distance(piece.middle(), shift, limit + CONE_EXCESS * zeta + round_off, "bubble")?;
        force = force.plus(piece.force());
        high = node.end();
    }
    if len > 0 {
        check_distance(high.anchor, shift, extent * (1.0 + 1e-6) + size, "extent")?;
    }
    let force = force.length();
    let holds = force <= ((1.0 + FORCE_EXCESS) * zeta + size) * zeta.sqrt();
    RangeError::check("force", force, holds, "within its limit")?;
    Ok(())
}

/// Checks that an anchor is at most `limit` from the shift.
#[inline]
fn check_distance<V: Lateral>(
    anchor: V,
    shift: V,
    limit: f64,
    field: &'static str,
) -> Result<(), RangeError> {
    let stretch = shift.minus(anchor);
    let square = stretch.dot(stretch);
    let holds = square <= limit * limit;
    RangeError::check(field, square, holds, "within the friction cone").map(|_| ())
}
