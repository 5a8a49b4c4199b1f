//! A touch with all its parts: its contact, and where the law has them, torsion and resistance to rolling.

use carom_laws::grains::{GrainRoll, Meeting, Rolling, WholeContact};
use carom_laws::static_friction::StaticFriction;
use carom_laws::torsion::law::StoredTwist;

use super::Place;
use super::kind::Kind;
use crate::error::Failure;
use crate::law::CaromLaw;
use crate::law::unit::relative_radius;

/// The parts of a touch in the caller's memory.
pub(super) struct Held<'a, K> {
    pub(super) contact: &'a mut K,
    pub(super) twist: Option<&'a mut StoredTwist>,
    pub(super) roll: Option<&'a mut GrainRoll>,
}

/// The parts of a touch.
pub(super) struct Parts<K> {
    pub(super) contact: K,
    twist: Option<StoredTwist>,
    roll: Option<GrainRoll>,
}

impl<K: Kind> Held<'_, K> {
    /// Checks parts whose bytes may have been changed elsewhere.
    pub(super) fn checked(self) -> Result<Self, Failure> {
        let twist = self.twist.as_ref().map_or(Ok(()), |twist| twist.check());
        let roll = self.roll.as_ref().map_or(Ok(()), |roll| roll.check());
        twist.and(roll).map_err(|error| Failure::from(error).in_state())?;
        Ok(self)
    }

    /// Changes the whole contact, unless that fails.
    #[inline(always)]
    pub(super) fn change<T>(
        &mut self,
        (law, radii): (&CaromLaw, [f64; 2]),
        change: impl FnOnce(&mut WholeContact<'_, K::Law>) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let relative_radius = relative_radius(radii)?;
        let (twist, roll) = (self.twist.as_deref_mut(), self.roll.as_deref_mut());
        let rolling = law.rolling().zip(roll);
        let rolling =
            rolling.map(|(resistance, roll)| Rolling { resistance, relative_radius, roll });
        self.contact
            .change((law, radii), |contact| change(&mut WholeContact { contact, twist, rolling }))
    }
}

impl<K: Kind> Parts<K> {
    /// Those of bodies that are apart.
    pub(super) fn fresh(
        (law, radii): (&CaromLaw, [f64; 2]),
        friction: StaticFriction,
    ) -> Result<Self, Failure> {
        let relative_radius = relative_radius(radii)?;
        let twist = law.has_torsion().then(|| law.twist(relative_radius)).transpose()?;
        let roll = law.rolling().map(|_| GrainRoll::default());
        Ok(Self { contact: K::fresh(law, relative_radius, friction)?, twist, roll })
    }

    /// Those of bodies that are met for the first time.
    pub(super) fn met(of: (&CaromLaw, [f64; 2]), meeting: &Meeting) -> Result<Self, Failure> {
        Self::fresh(of, of.0.friction_at(meeting.slip_speed())?)
    }

    pub(super) const fn held(&mut self) -> Held<'_, K> {
        Held { contact: &mut self.contact, twist: self.twist.as_mut(), roll: self.roll.as_mut() }
    }
}

impl<K: Kind> Place<K> {
    /// The parts; none if the bodies are separated.
    ///
    /// # Safety
    /// As [`Place::present`].
    #[inline(always)]
    pub(super) unsafe fn held<'a>(&self) -> Result<Option<Held<'a, K>>, Failure> {
        // SAFETY: the caller's promise; any bytes are numbers.
        unsafe {
            let Some(contact) = self.present()? else { return Ok(None) };
            let (twist, roll) = (self.twist.as_mut(), self.roll.as_mut());
            Ok(Some(Held { contact, twist, roll }))
        }
    }

    /// A copy of the parts; none if the bodies are separated.
    ///
    /// # Safety
    /// As [`Place::seen`].
    pub(super) unsafe fn copied(&self) -> Result<Option<Parts<K>>, Failure> {
        // SAFETY: the caller's promise; any bytes are numbers.
        unsafe {
            let Some(contact) = self.seen()? else { return Ok(None) };
            let (twist, roll) = (self.twist.as_ref().copied(), self.roll.as_ref().copied());
            let mut parts = Parts { contact: *contact, twist, roll };
            parts.held().checked()?;
            Ok(Some(parts))
        }
    }

    /// Writes the parts.
    ///
    /// # Safety
    /// As [`Place::present`].
    pub(super) unsafe fn keep(&self, Parts { contact, twist, roll }: Parts<K>) {
        // SAFETY: the caller's promise; the old bytes need no drop.
        unsafe {
            self.contact.write(contact);
            *self.mark = K::MARK ^ self.tag;
            if let Some(twist) = twist {
                self.twist.write(twist);
            }
            if let Some(roll) = roll {
                self.roll.write(roll);
            }
        }
    }
}
