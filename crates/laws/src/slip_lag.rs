//! How slip follows in a viscous material: the true slip lags behind that of the effective path.
//!
//! In a material of Kelvin and Voigt the elastic law bears the traction at the effective displacement `U = u + A u'`. With
//! the rigid shift ahead by the same time, `Xi = xi + theta xi'`, what it slips is `S = s + theta s'`: a place that sticks
//! keeps its true slip s, not S. A step of length dt begins with s; at its end s' is the growth of s over dt, and
//! `s = s_1 + dt/(dt + theta) (S - s_1)`.
//!
//! While the bodies approach, the effective contact is larger than the true one, by `(Z/zeta)^(1/2)`. Places between both
//! edges have not touched yet. Where they slip, they follow the field of slip inside, continued in proportion to the radius;
//! beyond places that stick it is that of the twist. Where they stick, their slip is the one at which they will touch if the
//! rates stay: it changes with `xi'/zeta'`, times `(2/pi) [(q^2/2 - b^2) acos(b/q) + (b/2) (q^2 - b^2)^(1/2)]` at the radius q
//! over that of the effective contact, b that of the true one. For like bodies that stick the force is then exact.

use carom_special::RangeError;

use crate::law::Shift;
use crate::stored::Fields;

/// How slip lags at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlipLag {
    /// theta/(dt + theta): the part of the slip of the step that is still to come.
    pub(crate) part: f64,
    /// The part of the radius of the effective contact that is beyond the true one.
    pub(crate) beyond: f64,
    /// By how much the rates over that of the approach changed in the step, times the effective approach.
    pub(crate) bent: Shift,
    /// By how much the twist leads.
    pub(crate) turned: f64,
}

impl SlipLag {
    /// That of an elastic material.
    pub const NONE: Self = Self {
        part: 0.0,
        beyond: 0.0,
        turned: 0.0,
        bent: Shift { zeta: 0.0, xi: 0.0, eta: 0.0, omega: 0.0 },
    };

    /// After a step of this length to this approach, with the effective approach and the time by which the shift leads; none
    /// where one of them is not positive.
    #[must_use]
    pub fn after(duration: f64, zeta: f64, approach: f64, lead: f64) -> Self {
        if !(duration > 0.0 && lead > 0.0 && zeta > 0.0 && approach > 0.0) {
            return Self::NONE;
        }
        Self {
            part: lead / (duration + lead),
            beyond: (1.0 - (zeta / approach).sqrt()).max(0.0),
            turned: 0.0,
            bent: Shift::default(),
        }
    }

    /// The same where the twist leads by this.
    #[must_use]
    pub fn turned_by(self, turned: f64) -> Self {
        if self.part > 0.0 { Self { turned, ..self } } else { self }
    }

    /// The same of a step in which these rates became others, at this effective approach.
    #[must_use]
    pub fn bent_by(self, before: Shift, rates: Shift, approach: f64) -> Self {
        if !(before.zeta > 0.0 && rates.zeta > 0.0) {
            return self;
        }
        let bent = |old: f64, new: f64| approach * (new / rates.zeta - old / before.zeta);
        let (xi, eta) = (bent(before.xi, rates.xi), bent(before.eta, rates.eta));
        let omega = bent(before.omega, rates.omega);
        Self { bent: Shift { zeta: 0.0, xi, eta, omega }, ..self }
    }

    /// Passes over what is stored.
    pub(crate) fn stored(&mut self, fields: &mut impl Fields) -> Result<(), RangeError> {
        let part = |field, number: f64| {
            RangeError::check(field, number, (0.0..=1.0).contains(&number), "0 to 1")
        };
        fields.number("lag of slip", &mut self.part, part)?;
        fields.number("radius beyond the contact", &mut self.beyond, part)?;
        fields.number("lead of the twist", &mut self.turned, RangeError::finite)
    }

    /// The part of the slip of the step that is still to come, from 0 to 1.
    #[must_use]
    pub const fn part(&self) -> f64 {
        self.part
    }

    /// The part of the radius of the effective contact that is beyond the true one, from 0 to 1.
    #[must_use]
    pub const fn beyond(&self) -> f64 {
        self.beyond
    }

    /// By how much the twist leads.
    #[must_use]
    pub const fn turned(&self) -> f64 {
        self.turned
    }

    /// By how much the rates over that of the approach changed in the step, times the effective approach.
    #[must_use]
    pub const fn bent(&self) -> Shift {
        self.bent
    }

    /// What is left of it after the step.
    pub(crate) fn kept(self) -> Self {
        Self { bent: Shift::default(), ..self }
    }

    /// What a place at this radius over that of the effective contact slips as the path bends by 1.
    #[must_use]
    pub fn bent_at(&self, radius: f64) -> f64 {
        let b = self.within() / radius;
        if b >= 1.0 || b.is_nan() {
            return 0.0;
        }
        let part = (0.5 - b * b) * libm::acos(b) + 0.5 * b * (1.0 - b * b).sqrt();
        std::f64::consts::FRAC_2_PI * (radius * radius * part)
    }

    /// The radius of the true contact over that of the effective one, from 0 to 1.
    #[must_use]
    pub fn within(&self) -> f64 {
        1.0 - self.beyond
    }
}

impl Default for SlipLag {
    fn default() -> Self {
        Self::NONE
    }
}
