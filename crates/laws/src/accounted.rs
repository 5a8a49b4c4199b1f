//! A contact law that also sums up the friction heat.

use crate::law::{Checked, ContactLaw, ContactLoad, Dissipative, Energies, Shift};
use crate::memory::VertexStack;
use crate::shift_law::ShiftLaw;

/// A contact law with an account of its dissipated energy.
///
/// Every step computes the heat as well as the force. This takes several times as long as the law
/// alone in one direction, and much longer in two.
///
/// ```
/// use carom_laws::accounted::Accounted;
/// use carom_laws::friction::Friction;
/// use carom_laws::law::{ContactLaw, Energies, Shift};
/// use carom_laws::shift_law::ShiftLaw;
/// use carom_laws::stiffness::ContactStiffness;
/// let stiffness = ContactStiffness::new(1.0, 1.0, 1.2)?;
/// let mut law = Accounted::new(ShiftLaw::<f64>::new(stiffness, Friction::new(0.3)?));
/// law.advance(Shift { zeta: 1.0, ..Shift::default() })?;
/// let stored = law.stored_energy();
/// law.advance(Shift { zeta: 1.0, xi: 0.2, ..Shift::default() })?;
/// law.advance(Shift { zeta: 1.0, xi: 0.0, ..Shift::default() })?;
/// assert!(law.dissipated() > 0.0 && law.stored_energy() > stored);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accounted<L> {
    law: L,
    dissipated: f64,
}

impl<L: Dissipative> Accounted<L> {
    /// Starts the account at zero, from the present state of the law.
    #[must_use]
    pub const fn new(law: L) -> Self {
        Self::going_on(law, 0.0)
    }

    /// Continues an account: from the present state of the law, with this energy already
    /// dissipated.
    #[must_use]
    pub const fn going_on(law: L, dissipated: f64) -> Self {
        Self { law, dissipated }
    }

    /// The contact law.
    #[must_use]
    pub const fn law(&self) -> &L {
        &self.law
    }
}

impl<L: Dissipative> ContactLaw for Accounted<L> {
    type Error = L::Error;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, L::Error> {
        let heat = self.law.dissipation(shift);
        let load = self.law.advance(shift)?;
        self.dissipated += heat;
        Ok(load)
    }

    fn shift(&self) -> Shift {
        self.law.shift()
    }

    fn load(&self) -> ContactLoad {
        self.law.load()
    }

    fn jumps(&self, to: Shift) -> bool {
        self.law.jumps(to)
    }

    fn slides_on(&self, rates: Shift) -> Option<bool> {
        self.law.slides_on(rates)
    }
}

impl<L: Dissipative> Energies for Accounted<L> {
    fn stored_energy(&self) -> f64 {
        self.law.stored_energy()
    }

    fn dissipated(&self) -> f64 {
        self.dissipated
    }
}

impl<L: Dissipative + Checked> Checked for Accounted<L> {
    fn check(&self, to: Shift) -> Result<(), L::Error> {
        self.law.check(to)
    }
}

impl<S: VertexStack<[f64; 2]>> Accounted<ShiftLaw<[f64; 2], S>> {
    /// Rotates the frame of the law, [`ShiftLaw::turn_frame`]; this dissipates nothing.
    pub fn turn_frame(&mut self, angle: f64) {
        self.law.turn_frame(angle);
    }
}
