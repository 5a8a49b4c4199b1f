//! The state of a contact without slip as plain numbers, to be kept elsewhere.

use carom_special::RangeError;

use super::super::pack::{HEAD, MOST, check};
use super::super::{Lateral, Vertex, VertexStack};
use super::AdhesionMemory;
use crate::profile::NormalProfile;

/// The version of the format; the first number is `1e4 version + vertices`.
const VERSION: f64 = 4.0;
/// Numbers of a vertex.
const EACH: usize = 9;

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> AdhesionMemory<V, S, P> {
    /// Writes the state into numbers: a mark, the approach, the shift, the force, and nine numbers of each
    /// vertex. What is left over becomes zero. All zeros are two bodies apart.
    ///
    /// # Errors
    /// [`RangeError`] if there is no room for the vertices; nothing is then written.
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

    /// Takes the state from numbers that [`AdhesionMemory::pack`] wrote, to the same bits.
    ///
    /// # Errors
    /// [`RangeError`] as [`crate::memory::Memory::unpack`]; the state is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let format = (VERSION, EACH, "of version 4");
        let (_, len) = check(numbers, format, self.stack.capacity())?;
        let vector = |at: usize| V::from_components([numbers[at], numbers[at + 1]]);
        self.zeta = numbers[1];
        (self.shift, self.force) = (vector(2), vector(4));
        self.stack.truncate(0);
        for at in (0..len).map(|i| HEAD + EACH * i) {
            self.stack.push(Vertex {
                depth: numbers[at].abs(),
                anchor: vector(at + 1),
                slope: vector(at + 3),
                force_slope: vector(at + 5),
                force: vector(at + 7),
                curb: 1.0,
            });
        }
        Ok(())
    }
}
