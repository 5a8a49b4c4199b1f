//! The contact law of a viscoelastic material, from any elastic law: the elastic law is driven by an effective path.
//!
//! In a material of Kelvin and Voigt each stress has a viscous companion, A times the rate of the elastic one; A is its
//! relaxation time. Hertz's contact, F = K zeta^(3/2), then carries
//!
//! - while the approach grows: `F = K [zeta^(3/2) + (3/2) A sqrt(zeta) zeta']`,
//! - while it falls: `F = K [zeta + A zeta']^(3/2)`, until that vanishes; the bodies then part, though zeta > 0.
//!
//! Both are exact, the second by Ting's theory of receding contacts. With the effective approach `Z = (F/K)^(2/3)` and the
//! lead `theta = (Z - zeta)/zeta'` the elastic law at approach Z, shift `xi + theta xi'` and twist `omega + theta omega'`
//! is exact in rebound where nothing slips, and has the contact radius of Z instead of zeta in compression. Its limit is f
//! times the whole force.
//!
//! A law that keeps the slip of each place (rings, grids) goes on from the true slip in each step ([`crate::slip_lag`]). A
//! twist counts there in proportion to the mean distance of the pressure from the centre. Against full simulations of 48
//! drawn impacts, unlike bodies and spins among them, the velocity is off by .006 f v_z in the mean and .025 at most.
//!
//! Another law slides as a whole: while all of it slides, the effective shift is kept ahead of the effective approach, so that
//! friction does not stick. Against the exact impact (`carom_impact::viscoelastic`) R_x is off by at most .03; where the slip
//! turns the velocity is off by up to .23 f v_z, and impacts take springs instead (`carom_impact::coupled`).

use carom_special::RangeError;

use crate::law::{ContactLaw, ContactLoad, ImpactLaw, Shift};
use crate::slip_lag::SlipLag;
use crate::stiffness::ContactStiffness;

/// The viscosity of the materials of a contact: their relaxation time A, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viscosity {
    relaxation: f64,
}

/// What a viscous contact makes of its approach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effective {
    /// Z: the approach at which the elastic contact bears the force; 0 where the bodies part.
    pub approach: f64,
    /// theta: the time by which shift and twist lead, s.
    pub lead: f64,
}

/// Ratios of viscous and elastic force below which the lead is computed by its series.
const SLOW: f64 = 1e-4;

impl Viscosity {
    /// Materials with this relaxation time, s.
    ///
    /// # Errors
    /// [`RangeError`] of `relaxation` unless it is finite and >= 0.
    pub fn new(relaxation: f64) -> Result<Self, RangeError> {
        RangeError::non_negative("relaxation", relaxation)?;
        Ok(Self { relaxation })
    }

    /// Materials with a relaxation time that was checked.
    #[inline(always)]
    pub(crate) const fn of(relaxation: f64) -> Self {
        Self { relaxation }
    }

    /// The relaxation time A, s.
    #[must_use]
    pub const fn relaxation(&self) -> f64 {
        self.relaxation
    }

    /// Effective approach and lead of Hertz's contact with this approach and its rate.
    ///
    /// ```
    /// use carom_laws::viscous::Viscosity;
    /// let viscosity = Viscosity::new(0.5)?;
    /// // At rest the contact is elastic.
    /// assert_eq!(viscosity.effective(2.0, 0.0).approach, 2.0);
    /// // It parts where zeta + A zeta' vanishes.
    /// assert_eq!(viscosity.effective(2.0, -4.0).approach, 0.0);
    /// let growing = viscosity.effective(1.0, 1.0).approach;
    /// assert!((growing.powf(1.5) - 1.75).abs() < 1e-14);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    #[must_use]
    pub fn effective(&self, zeta: f64, rate: f64) -> Effective {
        let a = self.relaxation;
        if zeta <= 0.0 {
            return Effective { approach: 0.0, lead: a };
        }
        if rate <= 0.0 {
            return Effective { approach: (zeta + a * rate).max(0.0), lead: a };
        }
        let ratio = 1.5 * a * rate / zeta;
        if ratio < SLOW {
            // (1 + r)^(2/3) = 1 + (2/3) r - r^2/9.
            let lead = a * (1.0 - ratio / 6.0);
            return Effective { approach: zeta + lead * rate, lead };
        }
        let root = libm::cbrt(1.0 + ratio);
        let approach = zeta * (root * root);
        Effective { approach, lead: (approach - zeta) / rate }
    }
}

/// An elastic contact law in a viscous material.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::law::{ContactLaw, Shift};
/// use carom_laws::shift_law::ShiftLaw;
/// use carom_laws::stiffness::ContactStiffness;
/// use carom_laws::viscous::{ViscousLaw, Viscosity};
/// let (stiffness, friction) = (ContactStiffness::new(1.0, 1.0, 1.2)?, Friction::new(0.3)?);
/// let elastic = ShiftLaw::<[f64; 2]>::new(stiffness, friction);
/// let mut law = ViscousLaw::new(elastic, Viscosity::new(0.1)?, friction.get(), stiffness);
/// let to = Shift { zeta: 1.0, xi: 0.1, ..Shift::default() };
/// let rates = Shift { zeta: 1.0, xi: 0.1, ..Shift::default() };
/// let load = law.advance_at(to, rates, 1.0)?;
/// assert!((load.f_z - 0.8 * 1.15).abs() < 1e-14);
/// assert!(load.f_x.hypot(load.f_y) <= 0.3 * load.f_z);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ViscousLaw<L> {
    law: L,
    viscosity: Viscosity,
    /// The true shift of the last step.
    shift: Shift,
    /// Its rates.
    rates: Shift,
    /// By how much the effective shift leads.
    lead: Shift,
    /// Friction, and kappa f along both axes.
    friction: f64,
    slides_by: [f64; 2],
}

/// A contact slides as a whole if its friction is within this share of the limit.
const WHOLE: f64 = 1e-3;

impl<L: ContactLaw> ViscousLaw<L> {
    /// An elastic law in its initial state in a material with this viscosity. The coefficient of friction and the stiffness
    /// are those of the law.
    #[must_use]
    pub fn new(law: L, viscosity: Viscosity, friction: f64, stiffness: ContactStiffness) -> Self {
        let ContactStiffness { c_x, c_y, c_z } = stiffness;
        let [shift, rates, lead] = [Shift::default(); 3];
        let slides_by = [c_x, c_y].map(|c| friction * c_z / c);
        Self { law, viscosity, shift, rates, lead, friction, slides_by }
    }

    /// The elastic law.
    #[must_use]
    pub const fn elastic(&self) -> &L {
        &self.law
    }

    /// The effective path of a step: where it ends, and the lead there.
    fn driven(&self, to: Shift, rates: Shift) -> (Shift, Shift) {
        let Effective { approach, lead: theta } = self.viscosity.effective(to.zeta, rates.zeta);
        let (ahead, arm) = (|rate: f64| theta * rate, arm(to.zeta, approach));
        let lead = Shift {
            zeta: approach - to.zeta,
            xi: ahead(rates.xi),
            eta: ahead(rates.eta),
            omega: arm * ahead(rates.omega),
        };
        let from = self.law.shift();
        let gained = |to: f64, from: f64, lead: f64, before: f64| (to - from) + (lead - before);
        let mut by = [
            gained(to.xi, self.shift.xi, lead.xi, self.lead.xi),
            gained(to.eta, self.shift.eta, lead.eta, self.lead.eta),
        ];
        if !self.law.keeps_slip() {
            self.keep_sliding(to, approach - from.zeta, &mut by);
        }
        let turned = arm * (to.omega - self.shift.omega) + (lead.omega - self.lead.omega);
        let omega = from.omega + turned;
        (Shift { zeta: approach, xi: from.xi + by[0], eta: from.eta + by[1], omega }, lead)
    }

    /// Where all slides, the effective shift stays ahead of the effective approach.
    fn keep_sliding(&self, to: Shift, deeper: f64, by: &mut [f64; 2]) {
        let ContactLoad { f_x, f_y, f_z, .. } = self.law.load();
        let used = self.law.used_friction();
        let limit = used.map_or(self.friction * f_z, |used| libm::hypot(f_x, f_y) / used);
        if let Some(slides) = Slides::of([f_x, f_y], limit, || self.slides_by) {
            let truly = [to.xi - self.shift.xi, to.eta - self.shift.eta];
            *by = slides.on(truly, [to.zeta - self.shift.zeta, deeper], *by);
        }
    }
}

/// A contact that slides as a whole.
pub(crate) struct Slides {
    /// The direction of friction.
    along: [f64; 2],
    /// kappa f along it: the shift over the approach by which all goes on to slide.
    least: f64,
}

impl Slides {
    /// Unless friction is below its limit. `by` is kappa f along both axes, c_z/c_x and c_z/c_y times f.
    #[inline(always)]
    pub(crate) fn of([x, y]: [f64; 2], limit: f64, by: impl FnOnce() -> [f64; 2]) -> Option<Self> {
        let (square, whole) = (x * x + y * y, (1.0 - WHOLE) * limit);
        if !(square > 0.0 && square >= whole * whole) {
            return None;
        }
        let size = square.sqrt();
        let (along, [by_x, by_y]) = ([x / size, y / size], by());
        // The compliances c_z/c_x, c_z/c_y weigh with the direction of friction.
        let least = along[0] * along[0] * by_x + along[1] * along[1] * by_y;
        Some(Self { along, least })
    }

    /// The growth of the effective shift: where the true shift goes on to slide, the effective one slides as far, so that
    /// friction heats as much. `deeper` are the growths of the true approach and of the effective one.
    pub(crate) fn on(&self, truly: [f64; 2], deeper: [f64; 2], mut by: [f64; 2]) -> [f64; 2] {
        let part = |by: [f64; 2]| self.along[0] * by[0] + self.along[1] * by[1];
        let slip = part(truly) - self.least * deeper[0];
        if slip > 0.0 {
            let missing = self.least * deeper[1] + slip - part(by);
            by[0] += missing * self.along[0];
            by[1] += missing * self.along[1];
        }
        by
    }
}

/// The mean distance of the pressure from the centre over that of Hertz's pressure in the effective contact, `b (4 - b^3)/3`
/// with b the ratio of the radii. The pressure while the approach grows is that of Hertz at zeta with a part `1 - b^3` of a flat
/// punch's; where the bodies twist, places slip in proportion to their distance.
pub(crate) fn arm(zeta: f64, approach: f64) -> f64 {
    if !(zeta > 0.0 && approach > zeta) {
        return 1.0;
    }
    let square = zeta / approach;
    let b = square.sqrt();
    b * (4.0 - square * b) / 3.0
}

impl<L: ContactLaw> ContactLaw for ViscousLaw<L> {
    type Error = L::Error;

    /// A step so slow that the material does not resist.
    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, L::Error> {
        self.advance_at(shift, Shift::default(), 0.0)
    }

    fn advance_at(
        &mut self,
        shift: Shift,
        rates: Shift,
        duration: f64,
    ) -> Result<ContactLoad, L::Error> {
        let (to, lead) = self.driven(shift, rates);
        let theta = self.viscosity.effective(shift.zeta, rates.zeta).lead;
        let lag = SlipLag::after(duration, shift.zeta, to.zeta, theta)
            .turned_by(lead.omega)
            .bent_by(self.rates, rates, to.zeta);
        self.law.advance_lagging(to, lag)?;
        (self.shift, self.rates, self.lead) = (shift, rates, lead);
        if to.zeta <= 0.0 {
            (self.rates, self.lead) = Default::default();
        }
        Ok(self.load())
    }

    fn depth(&self, shift: Shift, rates: Shift) -> f64 {
        if shift.zeta <= 0.0 {
            return shift.zeta;
        }
        let lead = self.viscosity.relaxation * rates.zeta;
        if lead < 0.0 { shift.zeta + lead } else { shift.zeta }
    }

    fn shift(&self) -> Shift {
        self.shift
    }

    fn load(&self) -> ContactLoad {
        let load = self.law.load();
        let arm = arm(self.shift.zeta, self.law.shift().zeta);
        ContactLoad { m_z: arm * load.m_z, ..load }
    }

    fn jumps(&self, to: Shift) -> bool {
        self.law.jumps(self.driven(to, self.rates).0)
    }

    fn slides_on(&self, rates: Shift) -> Option<bool> {
        self.law.slides_on(rates)
    }
}

impl<L: ImpactLaw> ImpactLaw for ViscousLaw<L> {
    fn rings(&self) -> Option<usize> {
        self.law.rings()
    }
}
