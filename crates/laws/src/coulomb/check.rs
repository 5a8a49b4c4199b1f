//! Checks whether numbers from outside are a possible state of the memory.

use carom_special::RangeError;

use super::piece::{End, Node, Piece};
use crate::memory::{Head, Lateral};

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
pub(super) fn check_meaning<V: Lateral>(
    head: &Head<V>,
    nodes: impl DoubleEndedIterator<Item = Node<V>>,
) -> Result<(), RangeError> {
    let &Head { zeta, shift, own: [front, extent], .. } = head;
    let zeta = zeta.max(0.0);
    let holds = (0.0..=zeta).contains(&front);
    RangeError::check("front", front, holds, "from 0 to the approach")?;
    RangeError::non_negative("extent", extent)?;
    let size = SHIFT_ROUND_OFF * shift.length();
    let mut high = End { depth: zeta, root: zeta.sqrt(), anchor: shift };
    let mut force = V::default();
    for node in nodes.rev() {
        let piece = Piece::new(&node, high);
        let [x, y] = node.anchor.components();
        let beyond = CONE_EXCESS * zeta + size + SHIFT_ROUND_OFF * (x.abs() + y.abs());
        check_distance(node.anchor, shift, zeta - node.depth + beyond, "anchor")?;
        check_distance(piece.middle(), shift, zeta - piece.middle_depth() + beyond, "bubble")?;
        force = force.plus(piece.force());
        high = node.end();
    }
    check_distance(high.anchor, shift, extent * (1.0 + 1e-6) + size, "extent")?;
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
