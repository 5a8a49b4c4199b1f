//! The law of one direction, exact on straight paths, without the energy accounts that the
//! motion does not need at every step.

use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::memory::{AdhesionMemory, Memory, Regime};
use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;

use super::{Stage, Staged};

/// Normal force and the memory of chapter 6 along x.
#[derive(Debug, Clone)]
pub(super) struct Line {
    stiffness: ContactStiffness,
    /// X = shift times this.
    scale: f64,
    /// F = Phi times this.
    unit: f64,
    memory: Recall,
    shift: Shift,
    load: ContactLoad,
}

#[derive(Debug, Clone)]
enum Recall {
    Rubbing(Memory<f64>),
    Stuck(AdhesionMemory<f64>),
}

impl Line {
    /// With stiffness c_x, c_z and friction that is not zero.
    pub(super) fn new(stiffness: ContactStiffness, friction: Friction) -> Self {
        let (memory, limit) = match friction.coefficient() {
            None => (Recall::Stuck(AdhesionMemory::new()), 1.0),
            Some(f) => (Recall::Rubbing(Memory::new()), f * stiffness.c_z),
        };
        let (shift, load) = (Shift::default(), ContactLoad::default());
        let (scale, unit) = (stiffness.c_x / limit, 2.0 / 3.0 * limit);
        Self { stiffness, scale, unit, memory, shift, load }
    }
}

impl ContactLaw for Line {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        let to = shift.xi * self.scale;
        let phi = match &mut self.memory {
            Recall::Rubbing(memory) => memory.advance(shift.zeta, to)?,
            Recall::Stuck(memory) => memory.advance(shift.zeta, to)?,
        };
        let zeta = shift.zeta.max(0.0);
        self.shift = shift;
        self.load.f_x = phi * self.unit;
        self.load.f_z = 2.0 / 3.0 * self.stiffness.c_z * (zeta * zeta.sqrt());
        Ok(self.load)
    }

    fn shift(&self) -> Shift {
        self.shift
    }

    fn load(&self) -> ContactLoad {
        self.load
    }

    fn stored_energy(&self) -> f64 {
        let zeta = self.shift.zeta.max(0.0);
        let tangential = match &self.memory {
            Recall::Rubbing(memory) => memory.stored_energy(),
            Recall::Stuck(memory) => memory.stored_energy(),
        };
        let normal = 4.0 / 15.0 * self.stiffness.c_z * (zeta * zeta * zeta.sqrt());
        normal + tangential * self.unit / self.scale
    }

    /// Not kept: the energies of the motion tell it.
    fn dissipated(&self) -> f64 {
        0.0
    }
}

impl Staged for Line {
    fn stage(&self) -> Stage {
        match &self.memory {
            Recall::Stuck(_) => Stage::Adhesion,
            Recall::Rubbing(memory) => memory.regime().into(),
        }
    }
}

impl From<Regime> for Stage {
    fn from(regime: Regime) -> Self {
        match regime {
            Regime::Separated | Regime::Adhesion | Regime::Release => Self::Adhesion,
            Regime::Slip | Regime::Reversal | Regime::Overlay => Self::Slip,
            Regime::Sliding => Self::Slide,
        }
    }
}
