//! Stores the state of a contact without slip as plain numbers.

use carom_special::RangeError;

use super::super::pack::{HEAD, MOST, check};
use super::super::{Lateral, Vertex, VertexStack};
use super::AdhesionMemory;
use crate::profile::NormalProfile;

/// The version of the format; the first number is `1e4 version + vertices`.
const VERSION: f64 = 4.0;
/// Without slip a slope may be as large as it is finite.
const LARGEST_SLOPE: f64 = f64::MAX;
/// Numbers per vertex.
const EACH: usize = 9;

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> AdhesionMemory<V, S, P> {
    /// Writes the state as numbers: a mark, the approach, the shift, the force, and nine numbers
    /// per vertex. The rest of the slice is set to zero. All zeros represent two separated bodies.
    ///
    /// # Errors
    /// [`RangeError`] if the slice is too short for the vertices; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let len = self.stack.len();
        let room = numbers.len() as f64;
        let holds = numbers.len() >= HEAD + EACH * len && len <= MOST;
        RangeError::check("numbers", room, holds, ">= 6 + 9 per vertex, of which at most 99")?;
        numbers.fill(0.0);
        let ([x, y], [f_x, f_y]) = (self.shift.components(), self.force.components());
        let mark = 1e4 * VERSION + len as f64;
        numbers[..HEAD].copy_from_slice(&[mark, self.zeta, x, y, f_x, f_y]);
        let places = numbers[HEAD..].chunks_exact_mut(EACH).take(len);
        for (i, place) in places.enumerate() {
            let vertex = self.stack.get(i);
            place[0] = vertex.depth;
            let vectors = [vertex.anchor, vertex.slope, vertex.force_slope, vertex.force];
            for (pair, vector) in place[1..].chunks_exact_mut(2).zip(vectors) {
                pair.copy_from_slice(&vector.components());
            }
        }
        Ok(())
    }

    /// Restores a state from the numbers of [`AdhesionMemory::pack`], bit for bit.
    ///
    /// # Errors
    /// [`RangeError`] as [`crate::memory::Memory::unpack`], and for forces that do not follow from
    /// the anchors; the state is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let format = (VERSION, EACH, "of version 4");
        let (_, len) = check(numbers, format, self.stack.capacity(), LARGEST_SLOPE)?;
        let vector = |at: usize| V::from_components([numbers[at], numbers[at + 1]]);
        let (zeta, shift, force) = (numbers[1], vector(2), vector(4));
        let vertex = |i: usize| vertex(&numbers[HEAD + EACH * i..]);
        let tip = Vertex { depth: zeta, anchor: shift, force, ..Vertex::default() };
        let mut below = Vertex::default();
        for i in (0..=len).filter(|_| len > 0) {
            let above = if i < len { vertex(i) } else { tip };
            let begins = i == 0 && above.force == V::default();
            let holds = begins || i > 0 && self.carries(&below, &above);
            RangeError::check(
                "force",
                above.force.length(),
                holds,
                "the force of the anchors below",
            )?;
            below = above;
        }
        (self.zeta, self.shift, self.force) = (zeta, shift, force);
        self.stack.truncate(0);
        (0..len).for_each(|i| self.stack.push(vertex(i)));
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

/// The vertex that nine numbers represent.
fn vertex<V: Lateral>(numbers: &[f64]) -> Vertex<V> {
    let vector = |at: usize| V::from_components([numbers[at], numbers[at + 1]]);
    Vertex {
        depth: numbers[0].abs(),
        anchor: vector(1),
        slope: vector(3),
        force_slope: vector(5),
        force: vector(7),
        curb: 1.0,
    }
}
