//! One of the laws at hand, chosen while the program runs.

use carom_laws::coulomb::Tolerance;
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::sliders::SlipLines;
use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;

use super::refine::Level;
use super::{ImpactLaw, Stage, Staged};

/// The friction law where the direction of the tangential motion turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum VectorLaw {
    /// Coulomb: every ring slips along its traction in the physical plane. Their anchors lie on a
    /// curve ([`carom_laws::coulomb`]) where c_x = c_y and the impact passes much like a free one,
    /// else on a line ([`SlipLines`]); in 60 random impacts of the former kind the curve took 0.7 of
    /// the time at 1e-3, 0.4 from 1e-4 to 1e-6 and 0.25 at 1e-7.
    #[default]
    Coulomb,
    /// The thesis (8.51): every slip ring keeps the direction in which it formed, measured with
    /// c_x xi and c_y eta. Ten times cheaper. How far it leaves the former, as a part of |v_A|, in
    /// 1000 random impacts or more each (f from 0.05 to 1, slip up to 6 f times the speed of
    /// approach): half of them below, one in ten above, the most seen. Steel ellipsoids upright on a
    /// plane 0.2 %, 1.4 %, 6 %; tilted and spinning ones and crossed cylinders 0.8 %, 4 %, 13 %;
    /// random mobilities with couplings up to 0.6 sqrt(D_ii D_jj), c_x/c_y from 2/3 to 3/2 and f up
    /// to 1.5: 1.7 %, 6 %, 37 %.
    /// Where sliding drives the normal motion and c_x and c_y differ much it may create energy (1.7 % in
    /// one of 60 000 extreme impacts): such an impact has no outcome and is refused as not settled.
    FixedDirection,
}

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
        Self::Line(Box::new(ShiftLaw::of_chapter_7(stiffness, friction)))
    }

    /// A law of two directions, as fine as a run. The curve has fewer anchors; the line of them sees
    /// faster which ones do not slip, which counts where an impact takes many steps.
    pub(super) fn in_space(
        law: VectorLaw,
        stiffness: ContactStiffness,
        friction: Friction,
        (level, is_mild): (Level, bool),
    ) -> Self {
        // Without a limit every direction is on its own.
        if law == VectorLaw::FixedDirection || friction.coefficient().is_none() {
            return Self::Plane(Box::new(ShiftLaw::of_chapter_7(stiffness, friction)));
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
            |_| Self::Plane(Box::new(ShiftLaw::of_chapter_7(stiffness, friction))),
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
