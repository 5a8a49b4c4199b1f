//! The law of shifts along a line with static friction above kinetic friction.

use carom_special::RangeError;

use super::{ShiftLaw, State};
use crate::law::{Checked, ContactLaw, ContactLoad, Dissipative, ImpactLaw, Shift};
use crate::memory::{Growing, MemoryRegime, Threshold, VertexStack};
use crate::static_friction::StaticFriction;
use crate::stiffness::ContactStiffness;

/// The contact law for shifts along x with static friction f_s as a threshold of full sliding.
///
/// Until all of the contact slides, every annulus sticks or slips with f_s, as in [`ShiftLaw`] with
/// f_s. Where the force reaches f_s F_z, it drops to f_k F_z, and the contact slides with f_k. When
/// the slip stops, the contact sticks, and must reach f_s F_z again before it slides. A step of any
/// length is exact. If f_s = f_k the law is [`ShiftLaw`], to the bit.
///
/// Where the shift turns, [`ShiftLaw::with_static_friction`] is the law.
///
/// The heat includes that of the drop, `(2/5) (f_s^2 - f_k^2) (c_z/c_x) F_z zeta`.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::law::{ContactLaw, Shift};
/// use carom_laws::shift_law::StaticFrictionLaw;
/// use carom_laws::static_friction::StaticFriction;
/// use carom_laws::stiffness::ContactStiffness;
/// let stiffness = ContactStiffness::new(1.0, 1.0, 1.0)?;
/// let friction = StaticFriction::new(Friction::new(0.3)?, Friction::new(0.2)?)?;
/// let mut law: StaticFrictionLaw = StaticFrictionLaw::new(stiffness, friction);
/// let f_z = law.advance(Shift { zeta: 1.0, ..Shift::default() })?.f_z;
/// let held = law.advance(Shift { zeta: 1.0, xi: 0.29, ..Shift::default() })?;
/// assert!(held.f_x > 0.29 * f_z);
/// let sliding = law.advance(Shift { zeta: 1.0, xi: 0.31, ..Shift::default() })?;
/// assert!((sliding.f_x - 0.2 * f_z).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct StaticFrictionLaw<S: VertexStack<f64> = Growing<f64>> {
    /// The law with f_s.
    law: ShiftLaw<f64, S>,
    friction: StaticFriction,
    threshold: Threshold,
}

impl<S: VertexStack<f64>> StaticFrictionLaw<S> {
    /// A law in its initial state: bodies at first contact, without shift.
    #[must_use]
    pub fn new(stiffness: ContactStiffness, friction: StaticFriction) -> Self {
        Self {
            law: ShiftLaw::new(stiffness, friction.threshold()),
            friction,
            threshold: Threshold::new(friction.ratio()),
        }
    }

    /// The stiffness coefficients.
    #[must_use]
    pub fn stiffness(&self) -> ContactStiffness {
        self.law.stiffness()
    }

    /// The coefficients of friction.
    #[must_use]
    pub fn friction(&self) -> StaticFriction {
        self.friction
    }

    /// The contact state after the last step.
    #[must_use]
    pub fn regime(&self) -> MemoryRegime {
        self.law.regime()
    }

    /// `zeta*/zeta = (a*/a)^2`: the relative area of the stick zone.
    #[must_use]
    pub fn stick_depth(&self) -> f64 {
        self.law.stick_depth()
    }
}

impl<S: VertexStack<f64>> ContactLaw for StaticFrictionLaw<S> {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        let to = self.law.reachable(shift)?;
        match &mut self.law.state {
            State::FixedDirection(memory) if self.friction.drops() => {
                self.threshold.step(memory, shift.zeta, to);
                self.law.shift = shift;
                Ok(self.law.load())
            }
            _ => self.law.advance(shift),
        }
    }

    fn shift(&self) -> Shift {
        self.law.shift()
    }

    fn load(&self) -> ContactLoad {
        self.law.load()
    }

    fn jumps(&self, to: Shift) -> bool {
        match (&self.law.state, self.law.reachable(to)) {
            (State::FixedDirection(memory), Ok(x)) if self.friction.drops() => {
                self.threshold.beyond(memory, to.zeta, x) > 0.0
            }
            _ => false,
        }
    }
}

impl<S: VertexStack<f64>> Checked for StaticFrictionLaw<S> {
    fn check(&self, to: Shift) -> Result<(), RangeError> {
        self.law.check(to)
    }
}

impl<S: VertexStack<f64>> Dissipative for StaticFrictionLaw<S> {
    fn stored_energy(&self) -> f64 {
        self.law.stored_energy()
    }

    fn dissipation(&self, to: Shift) -> f64 {
        match (&self.law.state, self.law.reachable(to)) {
            (State::FixedDirection(memory), Ok(x)) if self.friction.drops() => {
                self.threshold.heat(memory, to.zeta, x) * self.law.scale_of_energies()
            }
            _ => self.law.dissipation(to),
        }
    }
}

impl<S: VertexStack<f64>> ImpactLaw for StaticFrictionLaw<S> {}
