//! The laws of a history: shift and, if there is one, twist.

use crate::case::{HistoryCase, TurningLaw};
use carom_laws::accounted::Accounted;
use carom_laws::friction::Friction;
use carom_laws::hertz::{Hertz, HertzState};
use carom_laws::law::{ContactLaw as _, ContactLoad, Energies as _, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::torsion::law::TorsionLaw;
use carom_special::RangeError;

/// Shift and twist of one contact, each as if the other were absent.
#[derive(Debug, Clone)]
pub(super) struct Laws {
    hertz: Hertz,
    shift: Accounted<ShiftLaw<[f64; 2]>>,
    torsion: Option<TorsionLaw>,
    contact: Option<HertzState>,
}

impl Laws {
    /// The laws that these steps need: without twist there is no torsion.
    pub(super) fn new(
        case: &HistoryCase,
        friction: Friction,
        steps: &[Shift],
    ) -> Result<Self, RangeError> {
        let torsion = match steps.iter().any(|step| step.omega != 0.0) {
            true => Some(TorsionLaw::new(&case.hertz, friction)?),
            false => None,
        };
        let stiffness = case.hertz.stiffness();
        let shift = match case.law {
            TurningLaw::Coulomb(allowed) => ShiftLaw::with_tolerance(stiffness, friction, allowed),
            TurningLaw::FixedDirection => ShiftLaw::of_chapter_7(stiffness, friction),
        };
        let shift = Accounted::new(shift);
        Ok(Self { hertz: case.hertz, shift, torsion, contact: None })
    }

    pub(super) fn advance(&mut self, step: Shift) -> Result<(), RangeError> {
        self.shift.advance(step)?;
        if let Some(torsion) = &mut self.torsion {
            torsion.advance(step)?;
        }
        let zeta = step.zeta;
        self.contact = if zeta > 0.0 { Some(self.hertz.at_approach(zeta)?) } else { None };
        Ok(())
    }

    pub(super) fn shift(&self) -> &ShiftLaw<[f64; 2]> {
        self.shift.law()
    }

    pub(super) fn torsion(&self) -> Option<&TorsionLaw> {
        self.torsion.as_ref()
    }

    /// The contact area and pressure; none while the bodies are apart.
    pub(super) fn contact(&self) -> Option<HertzState> {
        self.contact
    }

    pub(super) fn present(&self) -> Shift {
        self.shift.shift()
    }

    pub(super) fn load(&self) -> ContactLoad {
        let m_z = self.torsion.as_ref().map_or(0.0, |law| law.load().m_z);
        ContactLoad { m_z, ..self.shift.load() }
    }

    pub(super) fn stored_energy(&self) -> f64 {
        let twist = self.torsion.as_ref().map_or(0.0, TorsionLaw::twist_energy);
        self.shift.stored_energy() + twist
    }

    pub(super) fn dissipated(&self) -> f64 {
        self.shift.dissipated() + self.torsion.as_ref().map_or(0.0, |law| law.dissipated())
    }
}
