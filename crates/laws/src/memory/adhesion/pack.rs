//! Stores the state of a contact without slip as plain numbers.

use carom_special::RangeError;

use super::super::stored::{Form, Head};
use super::super::{Lateral, MemoryRegime, Vertex, VertexStack};
use super::AdhesionMemory;
use crate::profile::NormalProfile;

/// Beside the head the force. Without slip a slope may be as large as it is finite.
const FORM: Form<4> = Form { version: 4.0, range: RangeError::finite, is_thin: true };

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> AdhesionMemory<V, S, P> {
    /// Writes the state as numbers: a mark, the approach, the shift, the force, and nine numbers
    /// per vertex. The rest of the slice is set to zero. All zeros represent two separated bodies.
    ///
    /// # Errors
    /// [`RangeError`] if the slice is too short for the vertices; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let (regime, own) = (MemoryRegime::Separated, self.force.components());
        let head = Head { regime, zeta: self.zeta, shift: self.shift, own };
        let vertices = (0..self.stack.len()).map(|i| {
            let &Vertex { depth, anchor, slope, force_slope, force, .. } = self.stack.get(i);
            (depth, [anchor, slope, force_slope, force])
        });
        FORM.write(numbers, head, vertices)
    }

    /// Restores a state from the numbers of [`AdhesionMemory::pack`], bit for bit.
    ///
    /// # Errors
    /// [`RangeError`] as [`crate::memory::Memory::unpack`], and for forces that do not follow from
    /// the anchors; the state is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let (head, vertices) = FORM.read(numbers, self.stack.capacity())?;
        let Head { zeta, shift, own, .. } = head;
        let force = V::from_components(own);
        let mut read = Self { zeta, shift, force, ..self.clone() };
        read.stack.truncate(0);
        for (depth, [anchor, slope, force_slope, force]) in Form::vertices(vertices) {
            let depth = depth.abs();
            read.stack.push(Vertex { depth, anchor, slope, force_slope, force, curb: 1.0 });
        }
        let tip = Vertex { depth: zeta, anchor: shift, force, ..Vertex::default() };
        for i in (0..=read.stack.len()).filter(|_| !read.stack.is_empty()) {
            let above = if i < read.stack.len() { read.stack.get(i) } else { &tip };
            let holds = match i {
                0 => above.force == V::default(),
                _ => self.carries(read.stack.get(i - 1), above),
            };
            let size = above.force.length();
            RangeError::check("force", size, holds, "the force of the anchors below")?;
        }
        *self = read;
        Ok(())
    }

    /// Whether the force up to a vertex follows from that up to the one below, with the annuli in
    /// between and the jump of the anchor, to rounding.
    fn carries(&self, below: &Vertex<V>, above: &Vertex<V>) -> bool {
        let jump = above.anchor.minus(below.anchor_at(above.depth));
        let stiffness = self.profile.stiffness(above.depth);
        let grown = below.force_at(above.depth, &self.profile);
        let off = grown.plus(jump.times(stiffness)).minus(above.force).length();
        let size = below.force.length() + grown.length() + above.force.length();
        let ways =
            below.anchor.length() + below.anchor_at(above.depth).length() + above.anchor.length();
        off.is_finite() && off <= FORCE_TOLERANCE * (size + stiffness * ways)
    }
}

/// Relative tolerance of a force, compared with the terms of its sum.
const FORCE_TOLERANCE: f64 = 1e-9;
