//! One of the laws at hand, chosen while the program runs.

use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_special::RangeError;

use super::bare_law::BareLaw;
use super::slip_lines::SlipLines;
use super::{ImpactLaw, Stage, Staged};

/// A law of one direction, of two, or Coulomb's.
#[derive(Debug, Clone)]
pub(super) enum AnyLaw {
    Line(Box<BareLaw<f64>>),
    Plane(Box<BareLaw<[f64; 2]>>),
    Lines(Box<SlipLines>),
}

macro_rules! each {
    ($any:expr, $law:ident => $call:expr) => {
        match $any {
            AnyLaw::Line($law) => $call,
            AnyLaw::Plane($law) => $call,
            AnyLaw::Lines($law) => $call,
        }
    };
}

impl ContactLaw for AnyLaw {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        each!(self, law => law.advance(shift))
    }

    fn shift(&self) -> Shift {
        each!(self, law => law.shift())
    }

    fn load(&self) -> ContactLoad {
        each!(self, law => law.load())
    }
}

impl Staged for AnyLaw {
    fn stage(&self) -> Stage {
        each!(self, law => law.stage())
    }
}

impl ImpactLaw for AnyLaw {
    fn rings(&self) -> Option<usize> {
        each!(self, law => law.rings())
    }
}
