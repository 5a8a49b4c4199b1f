//! A built-in contact law, chosen at run time.

use carom_laws::coulomb::Tolerance;
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::sliders::SlipLines;
use carom_laws::static_friction::StaticFriction;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::turning_law::TurningLaw;
use carom_special::RangeError;

use super::refine::Level;
use super::{ImpactLaw, Stage, Staged};

/// A law for one direction, for two, or Coulomb's law on line segments.
#[derive(Debug, Clone)]
pub(super) enum AnyLaw {
    Line(Box<ShiftLaw<f64>>),
    Plane(Box<ShiftLaw<[f64; 2]>>),
    Lines(Box<SlipLines>),
}

/// Largest share of the limit that the line segments may lose with an annulus, times the square of
/// the steps of a free impact, times the steps taken: each step may lose one annulus.
const LINE_LOSS_TIMES_STEPS: f64 = 6.0;
/// Tolerance of the curve of zero-traction shifts, times the steps of a free impact, times the
/// steps taken.
const CURVE_TOLERANCE_TIMES_STEPS: f64 = 20.0;
/// Largest relative difference of c_x and c_y for which they count as equal.
const MAX_ISOTROPIC_DIFFERENCE: f64 = 1e-13;

impl AnyLaw {
    /// The law for one direction.
    pub(super) fn in_line(stiffness: ContactStiffness, friction: Friction) -> Self {
        Self::Line(Box::new(ShiftLaw::with_fixed_direction(stiffness, friction)))
    }

    /// The law for one direction with static friction above kinetic friction.
    pub(super) fn with_static(stiffness: ContactStiffness, friction: StaticFriction) -> Self {
        let (law, tolerance) = (TurningLaw::FixedDirection, Tolerance::default());
        Self::Line(Box::new(ShiftLaw::with_static_friction(law, stiffness, friction, tolerance)))
    }

    /// The law for two directions with static friction above kinetic friction, with the accuracy of a
    /// run.
    pub(super) fn in_space_with_static(
        law: TurningLaw,
        stiffness: ContactStiffness,
        friction: StaticFriction,
        level: Level,
    ) -> Self {
        let tolerance = curve_tolerance(level);
        let law = ShiftLaw::with_static_friction(law, stiffness, friction, tolerance);
        Self::Plane(Box::new(law))
    }

    /// A law for two directions, with the accuracy of a run. The curve has fewer vertices. The line
    /// segments find faster which annuli do not slip, which matters in impacts with many steps.
    pub(super) fn in_space(
        law: TurningLaw,
        stiffness: ContactStiffness,
        friction: Friction,
        (level, is_mild): (Level, bool),
    ) -> Self {
        // Without a friction limit the directions are independent.
        if law == TurningLaw::FixedDirection || friction.coefficient().is_none() {
            return Self::Plane(Box::new(ShiftLaw::with_fixed_direction(stiffness, friction)));
        }
        let (steps, taken) = (level.steps as f64, level.taken as f64);
        let ContactStiffness { c_x, c_y, .. } = stiffness;
        if is_mild && (c_x - c_y).abs() <= MAX_ISOTROPIC_DIFFERENCE * c_x {
            let tolerance = curve_tolerance(level);
            return Self::Plane(Box::new(ShiftLaw::with_tolerance(stiffness, friction, tolerance)));
        }
        let lines = SlipLines::new(
            stiffness,
            friction.get(),
            LINE_LOSS_TIMES_STEPS / (steps * steps * taken),
        );
        lines.map_or_else(
            // Without friction there is no direction of traction.
            |_| Self::Plane(Box::new(ShiftLaw::with_fixed_direction(stiffness, friction))),
            |lines| Self::Lines(Box::new(lines)),
        )
    }
}

/// The tolerance of the curve of zero-traction shifts in a run.
fn curve_tolerance(level: Level) -> Tolerance {
    let (steps, taken) = (level.steps as f64, level.taken as f64);
    let tolerance = (CURVE_TOLERANCE_TIMES_STEPS / (steps * taken)).min(0.1);
    Tolerance::new(tolerance).unwrap_or_default()
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

    fn jumps(&self, to: Shift) -> bool {
        each!(self, law => law.jumps(to))
    }

    fn used_friction(&self) -> Option<f64> {
        each!(self, law => law.used_friction())
    }

    fn slides_on(&self, rates: Shift) -> Option<bool> {
        each!(self, law => law.slides_on(rates))
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
