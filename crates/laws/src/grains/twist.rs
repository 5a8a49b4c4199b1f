//! The twist of two grains about their normal.

use carom_special::RangeError;

use super::heats::Heats;
use super::meeting::Meeting;
use super::vector::{dot, times};
use crate::law::{ContactLaw, Shift};
use crate::torsion::law::TorsionLaw;

/// The torque of two grains about their normal: Lubkin's law with memory, independent of the
/// tangential shift.
///
/// In each step the twist grows by the relative angular velocity along the normal. The first step
/// of a contact starts from the positions one step before.
#[derive(Debug, Clone, PartialEq)]
pub struct GrainTwist {
    law: TorsionLaw,
}

impl GrainTwist {
    /// Makes a contact from a law, in its initial state or with a history.
    #[must_use]
    pub const fn new(law: TorsionLaw) -> Self {
        Self { law }
    }

    /// The torsion law about the normal.
    #[must_use]
    pub const fn law(&self) -> &TorsionLaw {
        &self.law
    }

    /// The law alone.
    pub(super) fn into_law(self) -> TorsionLaw {
        self.law
    }

    /// The torque on body 1 at the end of the last step, N m; the torque on body 2 is the opposite.
    #[must_use]
    pub fn torque(&self, meeting: &Meeting) -> [f64; 3] {
        if meeting.is_apart() {
            return [0.0; 3];
        }
        times(meeting.normal, self.law.twist_torque())
    }

    /// Advances by a step of duration `dt`, at the end of which the bodies are as given, and
    /// returns the torque.
    ///
    /// # Errors
    /// [`RangeError`] for a twist that the law does not allow; the state is then unchanged.
    pub fn advance(&mut self, meeting: &Meeting, dt: f64) -> Result<[f64; 3], RangeError> {
        self.step(meeting, dt, TorsionLaw::move_to)?;
        Ok(self.torque(meeting))
    }

    /// As [`GrainTwist::advance`], and adds the friction heat, including the energy released at a
    /// receding edge, on the path of the step ([`crate::law::Dissipative::dissipation`]).
    ///
    /// # Errors
    /// As [`GrainTwist::advance`].
    pub fn advance_accounted(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        heats: &mut Heats,
    ) -> Result<[f64; 3], RangeError> {
        heats.friction += self.step(meeting, dt, TorsionLaw::advance_with_heat)?;
        Ok(self.torque(meeting))
    }

    /// Moves the law to the end of a step by `advance`; bodies that were apart and are so still do not count.
    fn step<T: Default>(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        advance: impl Fn(&mut TorsionLaw, Shift) -> Result<T, RangeError>,
    ) -> Result<T, RangeError> {
        let turned = dot(meeting.twisting(), meeting.normal) * dt;
        let shift = self.law.shift();
        if shift.zeta > 0.0 {
            // A law that refuses a step is unchanged.
            let omega = shift.omega + turned;
            return advance(&mut self.law, Shift { zeta: meeting.zeta, omega, ..Shift::default() });
        }
        let mut law = self.law.clone();
        let by = dot(meeting.velocity, meeting.normal) * dt;
        law.advance(Shift { zeta: meeting.zeta - by, ..Shift::default() })?;
        let omega = law.shift().omega + turned;
        let told = advance(&mut law, Shift { zeta: meeting.zeta, omega, ..Shift::default() })?;
        if meeting.is_apart() {
            return Ok(T::default());
        }
        self.law = law;
        Ok(told)
    }
}
