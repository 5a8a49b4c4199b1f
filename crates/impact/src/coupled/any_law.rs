//! One of the laws at hand, chosen while the program runs.

use carom_laws::coulomb::Tolerance;
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::sliders::SlipLines;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::turning_law::TurningLaw;
use carom_special::RangeError;

use super::refine::Level;
use super::{ImpactLaw, Stage, Staged};

/// A law of one direction, of two, or Coulomb's on a curve or a line of anchors.
#[derive(Debug, Clone)]
pub(super) enum AnyLaw {
    Line(Box<ShiftLaw<f64>>),
    Plane(Box<ShiftLaw<[f64; 2]>>),
    Lines(Box<SlipLines>),
}

/// Force that the line of anchors may lose with a ring, over the greatest one: this over the square
/// of the steps of a free impact, and over the steps taken, each of which may lose one.
const OFF_LINE: f64 = 6.0;
/// How far the curve of anchors may be off: this over the steps of a free impact and over the steps
/// taken.
const OFF_CURVE: f64 = 20.0;
/// The greatest part of c_x by which c_y may differ where slip passes for that of equal ones.
const ROUND: f64 = 1e-13;

impl AnyLaw {
    /// The law of one direction.
    pub(super) fn in_line(stiffness: ContactStiffness, friction: Friction) -> Self {
        Self::Line(Box::new(ShiftLaw::with_fixed_direction(stiffness, friction)))
    }

    /// A law of two directions, as fine as a run. The curve has fewer anchors; the line of them sees
    /// faster which ones do not slip, which counts where an impact takes many steps.
    pub(super) fn in_space(
        law: TurningLaw,
        stiffness: ContactStiffness,
        friction: Friction,
        (level, is_mild): (Level, bool),
    ) -> Self {
        // Without a limit every direction is on its own.
        if law == TurningLaw::FixedDirection || friction.coefficient().is_none() {
            return Self::Plane(Box::new(ShiftLaw::with_fixed_direction(stiffness, friction)));
        }
        let (steps, taken) = (level.steps as f64, level.taken as f64);
        let ContactStiffness { c_x, c_y, .. } = stiffness;
        if is_mild && (c_x - c_y).abs() <= ROUND * c_x {
            let off = Tolerance::new((OFF_CURVE / (steps * taken)).min(0.1));
            let off = off.unwrap_or_default();
            return Self::Plane(Box::new(ShiftLaw::with_tolerance(stiffness, friction, off)));
        }
        let lines = SlipLines::new(stiffness, friction.get(), OFF_LINE / (steps * steps * taken));
        lines.map_or_else(
            // Without friction no direction acts.
            |_| Self::Plane(Box::new(ShiftLaw::with_fixed_direction(stiffness, friction))),
            |lines| Self::Lines(Box::new(lines)),
        )
    }
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
