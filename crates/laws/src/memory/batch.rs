//! Many contacts at once: a structure of arrays.

use carom_special::RangeError;

use super::{Growing, Lateral, Memory, VertexStack};
use crate::bounds::in_memory;

/// The memories of many contacts, advanced together.
///
/// ```
/// use carom_laws::memory::Batch;
/// let mut batch = Batch::<f64>::new(3);
/// let mut forces = [0.0; 3];
/// batch.advance(&[1.0, 1.0, -1.0], &[0.0, 0.5, 0.0], &mut forces)?;
/// assert_eq!(forces[2], 0.0);
/// # Ok::<(), carom_laws::memory::BatchError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Batch<V, S = Growing<V>> {
    memories: Vec<Memory<V, S>>,
}

/// Why a batch step failed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum BatchError {
    /// An array has not one entry for each contact.
    #[error("the array {array} has {length} entries for {contacts} contacts")]
    Length {
        /// The name of the array.
        array: &'static str,
        /// Its length.
        length: usize,
        /// The number of contacts.
        contacts: usize,
    },
    /// An entry is out of range.
    #[error("contact {contact}: {error}")]
    Range {
        /// The number of the contact, from 0.
        contact: usize,
        /// What is wrong.
        error: RangeError,
    },
}

impl<V: Lateral, S: VertexStack<V>> Batch<V, S> {
    /// Contacts that just touch, unshifted.
    #[must_use]
    pub fn new(contacts: usize) -> Self {
        Self { memories: vec![Memory::new(); contacts] }
    }

    /// The single memories.
    #[must_use]
    pub fn memories(&self) -> &[Memory<V, S>] {
        &self.memories
    }

    /// The single memories, to be advanced one by one.
    #[must_use]
    pub fn memories_mut(&mut self) -> &mut [Memory<V, S>] {
        &mut self.memories
    }

    /// Advances every contact to its approach and shift, and writes its force.
    ///
    /// # Errors
    /// [`BatchError`] for arrays of the wrong length or an entry above 1e100 in size or not a
    /// number; nothing is then changed or written.
    pub fn advance(
        &mut self,
        zeta: &[f64],
        shift: &[V],
        force: &mut [V],
    ) -> Result<(), BatchError> {
        let contacts = self.memories.len();
        for (array, length) in
            [("zeta", zeta.len()), ("shift", shift.len()), ("force", force.len())]
        {
            if length != contacts {
                return Err(BatchError::Length { array, length, contacts });
            }
        }
        for (contact, (&zeta, shift)) in zeta.iter().zip(shift).enumerate() {
            let wrap = |error| BatchError::Range { contact, error };
            in_memory("zeta", zeta).map_err(wrap)?;
            let [x, y] = shift.components();
            in_memory("shift", x).map_err(wrap)?;
            in_memory("shift", y).map_err(wrap)?;
        }
        for (((memory, &zeta), &shift), force) in
            self.memories.iter_mut().zip(zeta).zip(shift).zip(force)
        {
            memory.step(zeta, shift);
            *force = memory.force();
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_every_contact_by_itself() {
        let mut batch = Batch::<[f64; 2]>::new(5);
        let mut single = vec![Memory::<[f64; 2]>::new(); 5];
        let mut forces = [[0.0; 2]; 5];
        for step in 0..50 {
            let t = f64::from(step);
            let zeta = [0, 1, 2, 3, 4].map(|i| 1.0 + 0.5 * (t + f64::from(i)).sin());
            let shift = [0, 1, 2, 3, 4].map(|i| [(t * 0.3 + f64::from(i)).sin(), (t * 0.2).cos()]);
            batch.advance(&zeta, &shift, &mut forces).unwrap();
            for i in 0..5 {
                assert_eq!(single[i].advance(zeta[i], shift[i]).unwrap(), forces[i]);
            }
        }
        let before = batch.clone();
        let bad = [1.0, 1.0, f64::NAN, 1.0, 1.0];
        let error = batch.advance(&bad, &[[0.0; 2]; 5], &mut forces).unwrap_err();
        assert!(matches!(error, BatchError::Range { contact: 2, .. }));
        let error = batch.advance(&[1.0], &[[0.0; 2]; 5], &mut forces).unwrap_err();
        assert!(matches!(error, BatchError::Length { array: "zeta", length: 1, contacts: 5 }));
        assert_eq!(batch, before);
    }
}
