//! The load history of a contact, without its constants.

use carom_special::RangeError;

use super::contact::{Contact, Done, Step, Sums};
use super::matrices::{RingMatrices, Rings};
use super::symmetry::Symmetry;
use super::units::Units;
use crate::bounds::{LEAST_APPROACH, in_contact};
use crate::law::{ContactLoad, Shift};
use crate::slip_lag::SlipLag;

/// The load history of a contact on rings: numbers without pointers, which can be stored as bytes.
///
/// The constants ([`Rings`]) are passed to each call and must be those with which the history began.
/// [`super::RingLaw`] holds both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingMemory<const N: usize = 6, const M: usize = 8> {
    pub(super) contact: Contact<N, M>,
    pub(super) sums: Sums,
    pub(super) shift: Shift,
}

impl<const N: usize, const M: usize> Default for RingMemory<N, M> {
    /// The history of two bodies that just touch.
    fn default() -> Self {
        let (contact, sums, shift) = (Contact::default(), Sums::default(), Shift::default());
        Self { contact, sums, shift }
    }
}

impl<const N: usize, const M: usize> RingMemory<N, M> {
    /// Advances on a straight path to a new shift; returns the heat of the step, J
    /// ([`crate::law::Dissipative::dissipation`]).
    ///
    /// # Errors
    /// [`RangeError`] as [`RingMemory::check`]; nothing is then changed.
    pub fn advance<S: Symmetry<M>>(
        &mut self,
        rings: &Rings<'_, N, M, S>,
        to: Shift,
    ) -> Result<f64, RangeError> {
        self.check(rings, to)?;
        Ok(rings.units.energy * self.go(rings, to, SlipLag::NONE).heat)
    }

    /// Checks whether [`RingMemory::advance`] would accept this shift.
    ///
    /// # Errors
    /// [`RangeError`] for a shift, or a change of it over the friction, beyond 1e60.
    pub fn check<S: Symmetry<M>>(
        &self,
        rings: &Rings<'_, N, M, S>,
        to: Shift,
    ) -> Result<(), RangeError> {
        to.check_finite()?;
        if S::MIRRORED {
            RangeError::check(
                "eta",
                to.eta,
                to.eta == 0.0,
                "0: this law is for shifts along x only",
            )?;
            RangeError::check(
                "omega",
                to.omega,
                to.omega == 0.0,
                "0: this law is for shifts along x only",
            )?;
        }
        let Units { shift, twist, .. } = rings.units;
        in_contact("shift over friction", (to.xi - self.shift.xi) * shift)?;
        in_contact("shift over friction", (to.eta - self.shift.eta) * shift)?;
        in_contact("twist over friction", (to.omega - self.shift.omega) * twist)?;
        Ok(())
    }

    /// Whether radius and shift are finite, for a history read from bytes that may have been changed.
    #[must_use]
    pub fn fits(&self) -> bool {
        self.contact.radius >= 0.0
            && self.contact.radius < f64::INFINITY
            && self.shift.check_finite().is_ok()
    }

    /// The present shift.
    #[must_use]
    pub const fn shift(&self) -> Shift {
        self.shift
    }

    /// The present load.
    #[must_use]
    pub fn load<S: Symmetry<M>>(&self, rings: &Rings<'_, N, M, S>) -> ContactLoad {
        let Units { c_z, force, torque, .. } = rings.units;
        let [x, y] = self.sums.force;
        let f_z = match rings.pair {
            Some(pair) if pair.lift != 0.0 => 0.25 * c_z * self.sums.normal,
            _ => {
                let zeta = self.shift.zeta.max(0.0);
                2.0 / 3.0 * c_z * (zeta * zeta.sqrt())
            }
        };
        ContactLoad {
            f_x: rings.side * (force * x),
            f_y: force * y,
            f_z,
            m_z: torque * self.sums.torque,
        }
    }

    /// The elastic energy: compression by Hertz's law, plus the energy stored by the tangential tractions and
    /// the pressures that they add.
    #[must_use]
    pub fn stored_energy<S: Symmetry<M>>(&self, rings: &Rings<'_, N, M, S>) -> f64 {
        let zeta = self.shift.zeta.max(0.0);
        let normal = 4.0 / 15.0 * rings.units.c_z * (zeta * zeta * zeta.sqrt());
        normal + rings.units.energy * self.sums.stored
    }

    /// The share of the contact area that did not slip in the last step.
    #[must_use]
    pub fn sticking<S: Symmetry<M>>(&self, matrices: &RingMatrices<N, M, S>) -> f64 {
        let Some(pair) = matrices.pair() else { return 0.0 };
        if self.contact.radius == 0.0 {
            return 0.0;
        }
        let area = &pair.layout.area;
        let sticks =
            |j: usize, i: usize| self.contact.tractions.y[j].iter().all(|part| part[i] == 0.0);
        let stuck: f64 = (0..N)
            .map(|i| area[i] * (0..M).filter(|&j| sticks(j, i)).count() as f64 / M as f64)
            .sum();
        (stuck / area.iter().sum::<f64>()).min(1.0)
    }

    /// Advances to a checked shift; returns the heat in the unit of energy.
    pub(super) fn go<S: Symmetry<M>>(
        &mut self,
        rings: &Rings<'_, N, M, S>,
        to: Shift,
        lag: SlipLag,
    ) -> Done {
        let from = std::mem::replace(&mut self.shift, to);
        let Some(pair) = rings.pair else { return Done::default() };
        if to.zeta <= LEAST_APPROACH {
            self.contact = Contact::default();
            let heat = std::mem::replace(&mut self.sums, Sums::just_touching(to.zeta)).stored;
            return Done { heat, ..Done::default() };
        }
        if to == from {
            return Done::default();
        }
        // The part of the step in contact.
        let part = if from.zeta < 0.0 { to.zeta / (to.zeta - from.zeta) } else { 1.0 };
        let Units { shift, twist, .. } = rings.units;
        let step = Step {
            approach: to.zeta,
            approached: part * (to.zeta - from.zeta),
            shifted: [
                rings.side * ((to.xi - from.xi) * part * shift),
                (to.eta - from.eta) * part * shift,
            ],
            twisted: (to.omega - from.omega) * part * twist,
            bent: [rings.side * lag.bent.xi * shift, lag.bent.eta * shift, lag.bent.omega * twist],
            lag: lag.turned_by(lag.turned * twist),
        };
        let done = self.contact.advance(pair, rings.tolerance, &step);
        self.sums = self.contact.sums(pair);
        done
    }
}
