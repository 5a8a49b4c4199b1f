//! The state as plain numbers, for files and other processes.

use carom_special::RangeError;

use super::CoulombMemory;
use super::check::check_meaning;
use super::piece::{End, Node};
use crate::bounds::in_memory;
use crate::memory::{Lateral, MemoryRegime as Regime, NodeStack};

/// Version of the format. The first number is `1e4 version + 100 regime + vertices`.
const VERSION: f64 = 1.0;
pub(super) const HEAD_NUMBERS: usize = 6;
pub(super) const NUMBERS_PER_VERTEX: usize = 5;
/// The largest number of vertices that the first number can hold.
const MAX_VERTICES: usize = 99;

/// Number of plain numbers for a state of this many vertices: 66 for 12.
///
/// ```
/// assert_eq!(carom_laws::coulomb::packed_numbers(12), 66);
/// ```
#[must_use]
pub const fn packed_numbers(vertices: usize) -> usize {
    HEAD_NUMBERS + NUMBERS_PER_VERTEX * vertices
}

impl<V: Lateral, S: NodeStack<Node<V>>> CoulombMemory<V, S> {
    /// Writes the state as plain numbers.
    ///
    /// They are: a mark of version, regime and number of vertices; the approach; the shift; the
    /// depth of the slip front; the largest stretch; and for each vertex depth, anchor and bubble.
    /// The remaining numbers are set to zero. All zeros are two separated bodies.
    ///
    /// # Errors
    /// [`RangeError`] if there is no room for the vertices; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let len = self.stack.len();
        let count = numbers.len() as f64;
        let holds = numbers.len() >= packed_numbers(len) && len <= MAX_VERTICES;
        RangeError::check("numbers", count, holds, ">= 6 + 5 per vertex, of which at most 99")?;
        numbers.fill(0.0);
        let [x, y] = self.shift.components();
        let mark = 1e4 * VERSION + 100.0 * f64::from(self.regime.number()) + len as f64;
        numbers[..HEAD_NUMBERS].copy_from_slice(&[mark, self.zeta, x, y, self.front, self.extent]);
        for (i, numbers) in
            numbers[HEAD_NUMBERS..].chunks_exact_mut(NUMBERS_PER_VERTEX).take(len).enumerate()
        {
            let node = *self.stack.get(i);
            let ([w_x, w_y], [b_x, b_y]) = (node.anchor.components(), node.bubble.components());
            numbers.copy_from_slice(&[node.depth, w_x, w_y, b_x, b_y]);
        }
        Ok(())
    }

    /// Restores the state from the numbers of [`CoulombMemory::pack`].
    ///
    /// Forces are summed anew and may differ by round-off. [`CoulombMemory::error_estimate`] counts
    /// from here on.
    ///
    /// # Errors
    /// [`RangeError`] for another version, too few numbers, more vertices than the capacity, depths
    /// that do not increase to the approach, anchors far beyond the friction cone, a force beyond
    /// its limit, or values out of range; the state is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let (regime, len) = check(numbers, self.stack.capacity())?;
        check_meaning::<V>(numbers, len)?;
        self.zeta = numbers[1];
        self.root = self.zeta.max(0.0).sqrt();
        self.shift = V::from_components([numbers[2], numbers[3]]);
        (self.front, self.extent) = (numbers[4], numbers[5]);
        (self.regime, self.force) = (regime, V::default());
        self.stack.truncate(0);
        for vertex in numbers[HEAD_NUMBERS..].chunks_exact(NUMBERS_PER_VERTEX).take(len) {
            self.stack.push(node_of::<V>(vertex));
        }
        if len > 0 {
            self.finish(End { depth: self.zeta, root: self.root, anchor: self.shift }, 0);
        }
        Ok(())
    }
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
fn check(numbers: &[f64], capacity: usize) -> Result<(Regime, usize), RangeError> {
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
    for value in &numbers[1..packed_numbers(len)] {
        in_memory("numbers", *value)?;
    }
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
