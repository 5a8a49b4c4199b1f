//! The law in the user's units.

use std::sync::Arc;

use carom_special::RangeError;

use super::contact::{Contact, Step, Sums};
use super::pair::Pair;
use crate::bounds::in_contact;
use crate::friction::Friction;
use crate::hertz::Hertz;
use crate::law::{Checked, ContactLaw, ContactLoad, Dissipative, ImpactLaw, Shift};

/// How closely tractions keep Coulomb's law, over the peak of the pressure.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Tolerance(f64);

impl Tolerance {
    /// That of many particles: 1e-2.
    pub const PARTICLES: Self = Self(1e-2);
    /// That of single contacts: 1e-3.
    pub const FINE: Self = Self(1e-3);

    /// A tolerance.
    ///
    /// # Errors
    /// [`RangeError`] unless it is from 1e-10 to 0.1.
    pub fn new(tolerance: f64) -> Result<Self, RangeError> {
        let holds = (1e-10..=0.1).contains(&tolerance);
        RangeError::check("tolerance", tolerance, holds, "from 1e-10 to 0.1").map(Self)
    }
}

/// Units of the normalised contact.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Units {
    c_z: f64,
    /// Normalised shift over shift: 1/f.
    shift: f64,
    /// Normalised twist over twist.
    twist: f64,
    /// Tangential force over normalised force.
    force: f64,
    torque: f64,
    energy: f64,
}

/// The law of a circular contact of rings.
#[derive(Debug, Clone)]
pub struct RingLaw<const N: usize = 6, const M: usize = 8> {
    /// None without friction.
    pair: Option<Arc<Pair<N, M>>>,
    units: Units,
    tolerance: f64,
    contact: Contact<N, M>,
    sums: Sums,
    shift: Shift,
    iterations: usize,
}

/// How far the axes of a circle may differ.
const ROUND: f64 = 1e-9;

impl<const N: usize, const M: usize> RingLaw<N, M> {
    /// A law at rest, the bodies just touching.
    ///
    /// # Errors
    /// [`RangeError`] unless the contact is a circle.
    pub fn new(hertz: &Hertz, friction: Friction, tolerance: Tolerance) -> Result<Self, RangeError> {
        let materials = hertz.materials();
        Self::with_coupling(hertz, friction, tolerance, materials.gamma())
    }

    /// The same with another gamma.
    ///
    /// # Errors
    /// As [`RingLaw::new`].
    pub fn with_coupling(
        hertz: &Hertz,
        friction: Friction,
        tolerance: Tolerance,
        gamma: f64,
    ) -> Result<Self, RangeError> {
        let ratio = hertz.axis_ratio();
        let off = (ratio.parameter()).abs();
        RangeError::check("axis ratio", off, off <= ROUND, "1: a circular contact")?;
        let kappa = hertz.materials().kappa();
        let c_z = hertz.stiffness().c_z;
        let root = hertz.ellipse(1.0)?.semi_axis_a();
        let f = friction.coefficient().unwrap_or(1.0);
        let force = 0.25 * c_z * f;
        let units = Units {
            c_z,
            shift: if f > 0.0 { 1.0 / f } else { 0.0 },
            twist: if f > 0.0 { root / f } else { 0.0 },
            force,
            torque: force * root,
            energy: force * f,
        };
        let pair = (f > 0.0).then(|| Arc::new(Pair::new(kappa, gamma, friction.get())));
        Ok(Self {
            pair,
            units,
            tolerance: tolerance.0,
            contact: Contact::default(),
            sums: Sums::default(),
            shift: Shift::default(),
            iterations: 0,
        })
    }

    /// Iterations of the last step.
    #[must_use]
    pub fn iterations(&self) -> usize {
        self.iterations
    }

    /// For each ring its edges and the share of angles that slip.
    pub fn slipping(&self) -> Vec<f64> {
        let Some(pair) = &self.pair else { return vec![] };
        (0..N).filter(|&i| self.contact.tractions.y[0][0][i] != 0.0 || self.contact.tractions.y[0][1][i] != 0.0).map(|i| pair.layout.edges[i]).take(1).collect()
    }

    fn go(&mut self, to: Shift) -> f64 {
        let from = std::mem::replace(&mut self.shift, to);
        self.iterations = 0;
        let Some(pair) = &self.pair else { return 0.0 };
        if to.zeta <= 0.0 {
            self.contact = Contact::default();
            self.sums = Sums::default();
            return 0.0;
        }
        // The part of the way on which they touch.
        let part = if from.zeta < 0.0 { to.zeta / (to.zeta - from.zeta) } else { 1.0 };
        let Units { shift, twist, .. } = self.units;
        let step = Step {
            approach: to.zeta,
            approached: part * (to.zeta - from.zeta),
            shifted: [(to.xi - from.xi) * part * shift, (to.eta - from.eta) * part * shift],
            twisted: -(to.omega - from.omega) * part * twist,
        };
        let (count, heat) = self.contact.advance(pair, self.tolerance, &step);
        self.iterations = count;
        self.sums = self.contact.sums(pair);
        self.sums.heat = heat;
        heat
    }
}

impl<const N: usize, const M: usize> ContactLaw for RingLaw<N, M> {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        self.check(shift)?;
        self.go(shift);
        Ok(self.load())
    }

    fn shift(&self) -> Shift {
        self.shift
    }

    fn load(&self) -> ContactLoad {
        let zeta = self.shift.zeta.max(0.0);
        let hertz = 2.0 / 3.0 * self.units.c_z * (zeta * zeta.sqrt());
        let [x, y] = self.sums.force;
        let f_z = match &self.pair {
            Some(pair) if pair.lift != 0.0 => 0.25 * self.units.c_z * self.sums.normal,
            _ => hertz,
        };
        let force = self.units.force;
        ContactLoad { f_x: force * x, f_y: force * y, f_z, m_z: -self.units.torque * self.sums.torque }
    }
}

impl<const N: usize, const M: usize> Checked for RingLaw<N, M> {
    fn check(&self, to: Shift) -> Result<(), RangeError> {
        to.check_finite()?;
        in_contact("shift", (to.xi - self.shift.xi) * self.units.shift)?;
        in_contact("shift", (to.eta - self.shift.eta) * self.units.shift)?;
        in_contact("omega", (to.omega - self.shift.omega) * self.units.twist)?;
        Ok(())
    }
}

impl<const N: usize, const M: usize> Dissipative for RingLaw<N, M> {
    fn stored_energy(&self) -> f64 {
        let zeta = self.shift.zeta.max(0.0);
        4.0 / 15.0 * self.units.c_z * (zeta * zeta * zeta.sqrt())
            + self.units.energy * self.sums.stored
    }

    fn dissipation(&self, to: Shift) -> f64 {
        if self.check(to).is_err() {
            return 0.0;
        }
        let mut trial = self.clone();
        trial.go(to) * self.units.energy
    }
}

impl<const N: usize, const M: usize> ImpactLaw for RingLaw<N, M> {}
