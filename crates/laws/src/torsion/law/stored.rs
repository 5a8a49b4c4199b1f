//! A torsion law in fixed room.

use carom_special::RangeError;

use super::{HEAD, State, TorsionLaw};
use crate::bounds::constant;
use crate::law::{ContactLaw as _, Shift};
use crate::stored::Writer;
use crate::torsion::history::StoredHistory;

/// A torsion law of finite friction in fixed room: numbers without pointers, which may be kept as bytes. Of the
/// history of a twist the pieces that matter least are joined where there are more than twelve.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct StoredTwist {
    c_z: f64,
    per_twist: f64,
    per_torque: f64,
    /// The radius from which the edges of rings are counted.
    unit: f64,
    zeta: f64,
    omega: f64,
    history: StoredHistory,
}

impl StoredTwist {
    /// Number of numbers of [`StoredTwist::pack`].
    pub const NUMBERS: usize = HEAD + StoredHistory::NUMBERS;

    /// Two separated bodies with the constants of a law.
    ///
    /// # Errors
    /// [`RangeError`] for infinite friction, whose history has no fixed size.
    pub fn new(law: &TorsionLaw) -> Result<Self, RangeError> {
        let &TorsionLaw { c_z, per_twist, per_torque, .. } = law;
        let is_finite = !matches!(law.state, State::Adhesion(_));
        RangeError::check("friction", f64::INFINITY, is_finite, "finite")?;
        let history = StoredHistory::NEW;
        let unit = law.history().map_or(1.0, |history| history.unit);
        Ok(Self { c_z, per_twist, per_torque, unit, zeta: 0.0, omega: 0.0, history })
    }

    /// The law in this state.
    #[must_use]
    pub fn law(&self) -> TorsionLaw {
        let &Self { c_z, per_twist, per_torque, unit, zeta, omega, .. } = self;
        let state = match per_torque {
            0.0 => State::Frictionless,
            _ => State::Lubkin(self.history.history().counted_from(unit)),
        };
        let shift = Shift { zeta, omega, ..Shift::default() };
        TorsionLaw { c_z, per_twist, per_torque, state, shift }
    }

    /// Checks a state whose bytes may have been changed elsewhere.
    ///
    /// # Errors
    /// [`RangeError`] for bytes with which a step might not end.
    pub fn check(&self) -> Result<(), RangeError> {
        for number in [self.zeta, self.omega] {
            RangeError::finite("twist", number)?;
        }
        constant("unit of the rings", self.unit)?;
        self.history.check()
    }

    /// Keeps the state of the law, which was that of [`StoredTwist::law`], after a step.
    pub fn keep(&mut self, mut law: TorsionLaw) {
        let Shift { zeta, omega, .. } = law.shift();
        (self.zeta, self.omega) = (zeta, omega);
        if let State::Lubkin(history) = &mut law.state {
            self.history.keep(history);
        }
    }

    /// The bodies part.
    pub fn separate(&mut self) {
        (self.zeta, self.omega, self.history) = (0.0, 0.0, StoredHistory::NEW);
    }

    /// Writes the state as the numbers of [`TorsionLaw::pack`]; all are zero for separated bodies.
    ///
    /// # Errors
    /// As [`TorsionLaw::pack`].
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let mut writer = Writer::new(numbers, Self::NUMBERS, "enough for the twist")?;
        writer.write(&[self.zeta, 0.0, 0.0, self.omega]);
        self.history.pack(writer.rest())
    }

    /// Restores what [`StoredTwist::pack`] of a law with the same constants wrote.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are no state; the state is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let mut law = self.law();
        law.unpack(numbers)?;
        self.keep(law);
        Ok(())
    }
}
