//! The thesis's law in one direction or two.

use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::memory::{AdhesionMemory, Lateral, Memory, MemoryRegime as Regime};
use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;

use super::{ImpactLaw, Stage, Staged};

/// Normal force and the memory of chapter 6 (V a number: along x) or 7 (a pair).
#[derive(Debug, Clone)]
pub(super) struct BareLaw<V: Lateral> {
    stiffness: ContactStiffness,
    /// X = shift times this, by component.
    scale: V,
    /// F = Phi times this.
    unit: f64,
    memory: Recall<V>,
    shift: Shift,
    load: ContactLoad,
}

#[derive(Debug, Clone)]
enum Recall<V: Lateral> {
    Free,
    Rubbing(Memory<V>),
    Stuck(AdhesionMemory<V>),
}

impl<V: Lateral> BareLaw<V> {
    /// Of any friction.
    pub(super) fn new(stiffness: ContactStiffness, friction: Friction) -> Self {
        let (memory, limit) = match friction.coefficient() {
            None => (Recall::Stuck(AdhesionMemory::new()), 1.0),
            Some(0.0) => (Recall::Free, 1.0),
            Some(f) => (Recall::Rubbing(Memory::new()), f * stiffness.c_z),
        };
        let along = V::from_components([stiffness.c_x, stiffness.c_y]);
        let unit = 2.0 / 3.0 * limit;
        Self {
            stiffness,
            scale: along.times(1.0 / limit),
            unit,
            memory,
            shift: Shift::default(),
            load: ContactLoad::default(),
        }
    }
}

impl<V: Lateral> ContactLaw for BareLaw<V> {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        let to = V::from_components([shift.xi, shift.eta]).by_component(self.scale);
        let phi = match &mut self.memory {
            Recall::Free => V::default(),
            Recall::Rubbing(memory) => memory.advance(shift.zeta, to)?,
            Recall::Stuck(memory) => memory.advance(shift.zeta, to)?,
        };
        let zeta = shift.zeta.max(0.0);
        self.shift = shift;
        [self.load.f_x, self.load.f_y] = phi.times(self.unit).components();
        self.load.f_z = 2.0 / 3.0 * self.stiffness.c_z * (zeta * zeta.sqrt());
        Ok(self.load)
    }

    fn shift(&self) -> Shift {
        self.shift
    }

    fn load(&self) -> ContactLoad {
        self.load
    }
}

impl<V: Lateral> Staged for BareLaw<V> {
    fn stage(&self) -> Stage {
        match &self.memory {
            Recall::Free => Stage::Slide,
            Recall::Stuck(_) => Stage::Adhesion,
            Recall::Rubbing(memory) => memory.regime().into(),
        }
    }
}

impl<V: Lateral> ImpactLaw for BareLaw<V> {}

impl From<Regime> for Stage {
    fn from(regime: Regime) -> Self {
        match regime {
            Regime::Separated | Regime::Adhesion | Regime::Release => Self::Adhesion,
            Regime::Slip | Regime::Reversal | Regime::Overlay => Self::Slip,
            Regime::Sliding => Self::Slide,
        }
    }
}
