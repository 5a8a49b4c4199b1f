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
            Driven::Shift(approach) => RangeError::finite("zeta", approach)?,
            Driven::Load(force) => RangeError::positive("F_z", force)?,
        };
        let names = [("creepage", "F_x"), ("creepage_across", "F_y"), ("spin", "M_z")];
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

#[cfg(test)]
mod tests {
    use super::*;

    /// In any direction, with spin about any point of the way.
    #[test]
    fn the_creepages_of_a_step_are_those_given() {
        let given = Creepage { along: 0.01, across: -0.03, spin: 0.7 };
        let before = Shift { zeta: 1.0, xi: 0.2, eta: 0.5, omega: -0.1 };
        for (direction, part) in [(0.0, 0.0), (0.6, 1.0 / 6.0), (2.5, -0.5), (-1.2, 1.0)] {
            let way = Way::new(0.2).unwrap().towards(direction).unwrap();
            let way = way.with_spin_at(part).unwrap();
            let drive = RollingDrive::by_creepage(Driven::Shift(1.0), given).step(&way, before);
            let after = |driven, before: f64| match driven {
                Driven::Shift(shift) => shift - before,
                Driven::Load(_) => f64::NAN,
            };
            let step = Shift {
                zeta: 0.0,
                xi: after(drive.x, before.xi),
                eta: after(drive.y, before.eta),
                omega: after(drive.twist, before.omega),
            };
            let found = way.creepage(step);
            let off =
                [found.along - given.along, found.across - given.across, found.spin - given.spin];
            assert!(off.iter().all(|off| off.abs() < 1e-14), "{direction} {part}: {off:?}");
            // The point x + q d of a body that turns about the origin.
            let at = [direction.cos(), direction.sin()].map(|part_of| 0.2 * part * part_of);
            let lead = [step.xi - 0.2 * given.along, step.eta - 0.2 * given.across];
            assert!((lead[0] - at[1] * step.omega).abs() < 1e-15);
            assert!((lead[1] + at[0] * step.omega).abs() < 1e-15);
        }
    }
}
