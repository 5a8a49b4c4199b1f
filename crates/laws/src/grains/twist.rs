//! The twist of two grains about their normal, carried along.

use carom_special::RangeError;

use super::contact::Heats;
use super::meeting::Meeting;
use super::vector::{dot, times};
use crate::law::{ContactLaw, Shift};
use crate::torsion::law::TorsionLaw;

/// The memory of the twist of two grains: Lubkin's torque with memory, as if the contact were not shifted.
///
/// In each step the twist grows by the spin of body 2 against body 1 along the normal. The first step of a
/// contact begins where the two were one step before.
#[derive(Debug, Clone, PartialEq)]
pub struct GrainTwist {
    law: TorsionLaw,
}

impl GrainTwist {
    /// The twist to be of a contact, or one that is known.
    #[must_use]
    pub const fn new(law: TorsionLaw) -> Self {
        Self { law }
    }

    /// The law, about the normal.
    #[must_use]
    pub const fn law(&self) -> &TorsionLaw {
        &self.law
    }

    /// The torque on body 1 at the end of the last step, N m; that on body 2 is the opposite one.
    #[must_use]
    pub fn torque(&self, meeting: &Meeting) -> [f64; 3] {
        times(meeting.normal, self.law.load().m_z)
    }

    /// One step of the duration `dt`, at whose end the bodies are as told, and the torque.
    ///
    /// # Errors
    /// [`RangeError`] for what the law cannot take; the twist is then unchanged.
    pub fn advance(&mut self, meeting: &Meeting, dt: f64) -> Result<[f64; 3], RangeError> {
        let (mut law, to) = self.step(meeting, dt)?;
        law.advance(to)?;
        self.law = law;
        Ok(self.torque(meeting))
    }

    /// The same, and adds up the heat of friction, with what a receding edge releases: that of the law on
    /// the way of the step, [`crate::law::Dissipative::dissipation`].
    ///
    /// # Errors
    /// As [`GrainTwist::advance`].
    pub fn advance_accounted(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        heats: &mut Heats,
    ) -> Result<[f64; 3], RangeError> {
        let (mut law, to) = self.step(meeting, dt)?;
        heats.friction += law.advance_with_heat(to)?;
        self.law = law;
        Ok(self.torque(meeting))
    }

    /// The law before the step, and where that leads.
    fn step(&self, meeting: &Meeting, dt: f64) -> Result<(TorsionLaw, Shift), RangeError> {
        let mut law = self.law.clone();
        if law.shift().zeta <= 0.0 {
            let by = dot(meeting.velocity, meeting.normal) * dt;
            law.advance(Shift { zeta: meeting.zeta - by, ..Shift::default() })?;
        }
        let omega = law.shift().omega + dot(meeting.twisting, meeting.normal) * dt;
        Ok((law, Shift { zeta: meeting.zeta, omega, ..Shift::default() }))
    }
}
