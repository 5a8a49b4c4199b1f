//! The laws of a history: shift and, if there is one, twist.

use crate::case::HistoryCase;
use carom_laws::accounted::Accounted;
use carom_laws::coulomb::SlipTurn;
use carom_laws::hertz::{Hertz, HertzState};
use carom_laws::law::{ContactLaw as _, ContactLoad, Energies as _, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::torsion::law::{ShiftTwistLaw, TorsionLaw};
use carom_special::RangeError;

/// The laws of a contact under a history, with its Hertz constants.
#[derive(Debug, Clone)]
pub struct Laws {
    hertz: Hertz,
    law: Accounted<ShiftTwistLaw>,
    /// Whether any step has a twist.
    twists: bool,
    contact: Option<HertzState>,
    /// The turn of slip; none if no step has contact.
    turn: Option<SlipTurn>,
}

impl Laws {
    /// The laws before the first of these steps.
    ///
    /// # Errors
    /// [`RangeError`] if a law refuses a value, or a step has a twist under static friction.
    pub fn new(case: &HistoryCase, steps: &[Shift]) -> Result<Self, RangeError> {
        case.check_twist(steps)?;
        let (stiffness, friction) = (case.hertz.stiffness(), case.friction);
        let shift = ShiftLaw::with_static_friction(case.law, stiffness, friction, case.tolerance);
        let torsion = TorsionLaw::new(&case.hertz, friction.threshold())?;
        let law = Accounted::new(ShiftTwistLaw::of(shift, torsion)?);
        let deepest = steps.iter().fold(0.0, |most: f64, step| most.max(step.zeta));
        let turn = (deepest > 0.0)
            .then(|| SlipTurn::new(stiffness, friction.threshold(), deepest))
            .transpose()?;
        Ok(Self { hertz: case.hertz, law, twists: is_twisted(steps), contact: None, turn })
    }

    /// Advances to a shift.
    ///
    /// # Errors
    /// [`RangeError`] if a law rejects it.
    pub fn advance(&mut self, step: Shift) -> Result<(), RangeError> {
        self.law.advance(step)?;
        self.turn.as_mut().map_or(Ok(()), |turn| turn.advance(step))?;
        let zeta = step.zeta;
        self.contact = if zeta > 0.0 { Some(self.hertz.at_approach(zeta)?) } else { None };
        Ok(())
    }

    /// The law of the shift.
    #[must_use]
    pub fn shift(&self) -> &ShiftLaw<[f64; 2]> {
        self.law.law().tangential()
    }

    /// The law of the twist, if there is one.
    #[must_use]
    pub fn torsion(&self) -> Option<&TorsionLaw> {
        self.twists.then(|| self.law.law().torsion())
    }

    /// The contact ellipse and pressure; none while the bodies are separated.
    #[must_use]
    pub fn contact(&self) -> Option<HertzState> {
        self.contact
    }

    /// The present shift.
    #[must_use]
    pub fn present(&self) -> Shift {
        self.law.shift()
    }

    /// The load on body 1.
    #[must_use]
    pub fn load(&self) -> ContactLoad {
        self.law.load()
    }

    /// The largest angle by which slip has turned within an annulus since that last stuck, radians.
    #[must_use]
    pub fn slip_turn(&self) -> f64 {
        self.turn.as_ref().map_or(0.0, SlipTurn::angle)
    }

    /// Elastic energy of the contact.
    #[must_use]
    pub fn stored_energy(&self) -> f64 {
        self.law.stored_energy()
    }

    /// Friction heat since the start.
    #[must_use]
    pub fn dissipated(&self) -> f64 {
        self.law.dissipated()
    }
}

/// Whether any step has a twist.
#[must_use]
pub fn is_twisted(shifts: &[Shift]) -> bool {
    shifts.iter().any(|shift| shift.omega != 0.0)
}
