//! What drives a rolling contact: creepages or forces.

use carom_laws::law::Shift;
use carom_solver::{Drive, Driven};
use carom_special::RangeError;

use crate::{Creepage, Way};

/// What drives a rolling contact: approach or normal force, and for each creepage the creepage
/// itself ([`Driven::Shift`], per distance rolled) or its force ([`Driven::Load`]).
///
/// ```
/// use carom_rolling::{Creepage, RollingDrive};
/// use carom_solver::Driven;
/// let coasting = RollingDrive::by_creepage(Driven::Load(100.0), Creepage::default());
/// let braked = RollingDrive { along: Driven::Load(-20.0), ..coasting };
/// assert!(braked.check().is_ok());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingDrive {
    /// Approach, or normal force F_z.
    pub normal: Driven,
    /// Longitudinal creepage xi, or force F_x.
    pub along: Driven,
    /// Lateral creepage eta, or force F_y.
    pub across: Driven,
    /// Spin creepage phi, or torque M_z about the middle of the grid.
    pub spin: Driven,
}

impl RollingDrive {
    /// All creepages given.
    #[must_use]
    pub const fn by_creepage(normal: Driven, creepage: Creepage) -> Self {
        let Creepage { along, across, spin } = creepage;
        Self {
            normal,
            along: Driven::Shift(along),
            across: Driven::Shift(across),
            spin: Driven::Shift(spin),
        }
    }

    /// The creepages that are given; zero where a force is.
    #[must_use]
    pub fn creepage(&self) -> Creepage {
        let given = |driven| match driven {
            Driven::Shift(creepage) => creepage,
            Driven::Load(_) => 0.0,
        };
        Creepage { along: given(self.along), across: given(self.across), spin: given(self.spin) }
    }

    /// Checks that all values are finite and a normal force is positive.
    ///
    /// # Errors
    /// [`RangeError`] that names the first value out of range.
    pub fn check(&self) -> Result<(), RangeError> {
        match self.normal {
            Driven::Shift(approach) => RangeError::finite("approach", approach)?,
            Driven::Load(force) => RangeError::positive("normal force", force)?,
        };
        let names = [("creepage along", "F_x"), ("creepage across", "F_y"), ("spin", "M_z")];
        for (driven, (creepage, load)) in
            [self.along, self.across, self.spin].into_iter().zip(names)
        {
            match driven {
                Driven::Shift(value) => RangeError::finite(creepage, value)?,
                Driven::Load(value) => RangeError::finite(load, value)?,
            };
        }
        Ok(())
    }

    /// The same; also that the creepages at the point about which spin turns the bodies are known.
    pub(crate) fn check_about(&self, way: &Way) -> Result<(), RangeError> {
        self.check()?;
        let at = way.spin_offset();
        let given = |driven, arm: f64| arm != 0.0 && matches!(driven, Driven::Shift(_));
        let unknown = matches!(self.spin, Driven::Load(_))
            && (given(self.along, at.y) || given(self.across, at.x));
        let allowed = "0 where M_z is given together with a creepage that depends on it";
        RangeError::check("spin offset", way.spin_at(), !unknown, allowed).map(drop)
    }

    /// The shifts and loads at the end of a step, after these shifts.
    pub(crate) fn step(&self, way: &Way, before: Shift) -> Drive {
        let (length, at, given) = (way.length(), way.spin_offset(), self.creepage());
        let driven = |driven, before: f64, creepage: f64| match driven {
            Driven::Shift(_) => Driven::Shift(before + length * creepage),
            load @ Driven::Load(_) => load,
        };
        Drive {
            normal: self.normal,
            x: driven(self.along, before.xi, given.along + at.y * given.spin),
            y: driven(self.across, before.eta, given.across - at.x * given.spin),
            twist: driven(self.spin, before.omega, given.spin),
        }
    }
}
