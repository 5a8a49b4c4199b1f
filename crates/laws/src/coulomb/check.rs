//! Whether numbers from outside can be what a contact remembers.

use carom_special::RangeError;

use super::pack::{EACH, HEAD, knot_of};
use super::piece::{End, Piece};
use crate::memory::Lateral;

/// By how much anchors and middles of pieces may lie beyond the friction cone, over the approach: the law's own
/// error. Where pieces were joined for want of room .07 was seen, in four million states of four vertices and
/// more.
const BEYOND: f64 = 0.25;
/// The same, over the shift and the anchor, whose difference counts: round-off.
const OF_SHIFT: f64 = 1e-12;
/// By how much the force may be above its limit: 2e-11 was seen.
const FORCE: f64 = 1e-6;

/// The anchors lie within the friction cone below the shift, `|X - W(s)| <= zeta - s`, and the force of all rings
/// within its limit `zeta^(3/2)`; the front lies in the contact.
pub(super) fn check_meaning<V: Lateral>(numbers: &[f64], len: usize) -> Result<(), RangeError> {
    let [zeta, front, extent] = [numbers[1].max(0.0), numbers[4], numbers[5]];
    let holds = (0.0..=zeta).contains(&front);
    RangeError::check("front", front, holds, "from 0 to the approach")?;
    RangeError::non_negative("extent", extent)?;
    let shift = V::from_components([numbers[2], numbers[3]]);
    let size = OF_SHIFT * shift.length();
    let mut high = End { depth: zeta, root: zeta.sqrt(), anchor: shift };
    let mut force = V::default();
    for vertex in numbers[HEAD..HEAD + EACH * len].chunks_exact(EACH).rev() {
        let knot = knot_of::<V>(vertex);
        let piece = Piece::new(&knot, high);
        let [x, y] = knot.anchor.components();
        let off = size + OF_SHIFT * (x.abs() + y.abs());
        within(knot.anchor, shift, zeta - knot.depth + BEYOND * zeta + off, "anchor")?;
        let limit = zeta - piece.middle_depth();
        within(piece.middle(), shift, limit + BEYOND * zeta + off, "bubble")?;
        force = force.plus(piece.force());
        high = knot.end();
    }
    if len > 0 {
        within(high.anchor, shift, extent * (1.0 + 1e-6) + size, "extent")?;
    }
    let force = force.length();
    let holds = force <= ((1.0 + FORCE) * zeta + size) * zeta.sqrt();
    RangeError::check("force", force, holds, "within its limit")?;
    Ok(())
}

/// Whether an anchor lies within a way of the shift.
#[inline]
fn within<V: Lateral>(
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
