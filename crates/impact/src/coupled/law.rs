//! What an impact asks of a contact law beside its loads.

use carom_laws::law::ContactLaw;
use carom_laws::memory::{Lateral, VertexStack};
use carom_laws::shift_law::ShiftLaw;

use super::CoulombRings;

/// A contact law that an impact can follow; one with nothing to say beside its loads is
/// `impl ImpactLaw for MyLaw {}`.
pub trait ImpactLaw: ContactLaw {
    /// The rings it is made of, if it is: the work of a step is counted by them.
    fn rings(&self) -> Option<usize> {
        None
    }
}

impl ImpactLaw for CoulombRings {
    fn rings(&self) -> Option<usize> {
        Some(self.touching())
    }
}

impl<V: Lateral, S: VertexStack<V>> ImpactLaw for ShiftLaw<V, S> {}
