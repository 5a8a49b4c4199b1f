//! The state as plain numbers, for files and other processes.

use carom_special::RangeError;

use super::CoulombMemory;
use super::check::check_meaning;
use super::format::{
    HEAD_NUMBERS, MAX_VERTICES, NUMBERS_PER_VERTEX, VERSION, check_format, node_of, packed_numbers,
};
use super::piece::{End, Node};
use crate::memory::{Lateral, NodeStack};

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
        let (regime, len) = check_format(numbers, self.stack.capacity())?;
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
