//! The state as plain numbers, for files and other processes.

use carom_special::RangeError;

use super::CoulombMemory;
use super::check::check_meaning;
use super::piece::{End, Node};
use crate::bounds::in_stored_memory;
use crate::memory::{Form, Head, Lateral, NodeStack};

const FORM: Form<2> = Form { version: 1.0, range: in_stored_memory, is_thin: false };

/// Number of plain numbers for a state of this many vertices: 66 for 12.
///
/// ```
/// assert_eq!(carom_laws::coulomb::packed_numbers(12), 66);
/// ```
#[must_use]
pub const fn packed_numbers(vertices: usize) -> usize {
    Form::<2>::numbers(vertices)
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
        let own = [self.front, self.extent];
        let head = Head { regime: self.regime, zeta: self.zeta, shift: self.shift, own };
        let vertices = (0..self.stack.len()).map(|i| {
            let node = self.stack.get(i);
            (node.depth, [node.anchor, node.bubble])
        });
        FORM.write(numbers, head, vertices)
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
        let (head, vertices) = FORM.read(numbers, self.stack.capacity())?;
        let nodes = Form::vertices(vertices).map(|(depth, [anchor, bubble])| {
            let (root, force) = (depth.sqrt(), V::default());
            Node { depth, root, anchor, bubble, force, error: 0.0 }
        });
        check_meaning(&head, nodes.clone())?;
        let Head { regime, zeta, shift, own } = head;
        (self.regime, self.zeta, self.shift, [self.front, self.extent]) =
            (regime, zeta, shift, own);
        (self.root, self.force) = (zeta.max(0.0).sqrt(), V::default());
        self.stack.truncate(0);
        nodes.for_each(|node| self.stack.push(node));
        if !self.stack.is_empty() {
            self.finish(End { depth: zeta, root: self.root, anchor: shift }, 0);
        }
        Ok(())
    }
}
