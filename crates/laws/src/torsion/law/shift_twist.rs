//! The contact law for shift and twist together.

use carom_special::RangeError;

use super::TorsionLaw;
use crate::friction::Friction;
use crate::hertz::Hertz;
use crate::law::{ContactLaw, ContactLoad, Dissipative, Shift};
use crate::shift_law::ShiftLaw;

/// The contact law for shift and twist, each by its own law and independent of the other.
///
/// This is an approximation, because both share the same friction. It is accurate as long as one of
/// them is small. If both approach their limits the true load is smaller, down to the limit surface
/// of a contact that slides as a rigid body (14.3).
#[derive(Debug, Clone, PartialEq)]
pub struct ShiftTwistLaw {
    tangential: ShiftLaw<[f64; 2]>,
    torsion: TorsionLaw,
}

impl ShiftTwistLaw {
    /// A law in its initial state: bodies at first contact.
    ///
    /// # Errors
    /// As [`TorsionLaw::new`].
    pub fn new(hertz: &Hertz, friction: Friction) -> Result<Self, RangeError> {
        let torsion = TorsionLaw::new(hertz, friction)?;
        let shift = ShiftLaw::new(hertz.stiffness(), friction);
        Ok(Self { tangential: shift, torsion })
    }

    /// Combines a law of the shift and a law of the twist.
    ///
    /// # Errors
    /// [`RangeError`] unless both have the same shift.
    pub fn of(tangential: ShiftLaw<[f64; 2]>, torsion: TorsionLaw) -> Result<Self, RangeError> {
        let (one, other) = (tangential.shift(), torsion.shift());
        RangeError::check(
            "approach",
            other.zeta,
            one.zeta == other.zeta,
            "equal to that of the shift law",
        )?;
        Ok(Self { tangential, torsion })
    }

    /// The law of the shift.
    #[must_use]
    pub const fn tangential(&self) -> &ShiftLaw<[f64; 2]> {
        &self.tangential
    }

    /// The law of the twist.
    #[must_use]
    pub fn torsion(&self) -> &TorsionLaw {
        &self.torsion
    }
}

impl ContactLaw for ShiftTwistLaw {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        let mut torsion = self.torsion.clone();
        torsion.advance(shift)?;
        self.tangential.advance(shift)?;
        self.torsion = torsion;
        Ok(self.load())
    }

    fn shift(&self) -> Shift {
        Shift { omega: self.torsion.shift().omega, ..self.tangential.shift() }
    }

    fn load(&self) -> ContactLoad {
        ContactLoad { m_z: self.torsion.load().m_z, ..self.tangential.load() }
    }
}

impl Dissipative for ShiftTwistLaw {
    fn stored_energy(&self) -> f64 {
        self.tangential.stored_energy() + self.torsion.twist_energy()
    }

    fn dissipation(&self, to: Shift) -> f64 {
        self.tangential.dissipation(to) + self.torsion.dissipation(to)
    }

    fn loss(&self, to: Shift) -> f64 {
        self.tangential.loss(to) + self.torsion.loss(to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accounted::Accounted;
    use crate::curvature::RelativeCurvature;
    use crate::law::Energies as _;
    use approx::assert_relative_eq;
    use carom_halfspace::{Material, MaterialPair};

    fn hertz(a: f64, b: f64) -> Hertz {
        let body = Material::from_shear(2.0, 0.3).unwrap();
        let gap = RelativeCurvature::from_coefficients(a, b).unwrap();
        Hertz::new(gap, MaterialPair::new(body, body).unwrap()).unwrap()
    }

    #[test]
    fn energy_is_balanced() {
        for friction in [0.0, 0.3, f64::INFINITY] {
            let friction_law = Friction::new(friction).unwrap();
            let mut law =
                Accounted::new(ShiftTwistLaw::new(&hertz(1.0, 0.3), friction_law).unwrap());
            let path = [
                (0.01, 0.0, 0.0),
                (0.01, 0.002, 0.03),
                (0.012, 0.0, 0.0),
                (0.008, -0.002, -0.02),
                (0.004, 0.001, -0.03),
            ];
            let mut work = 0.0;
            for (zeta, xi, omega) in path {
                let from = law.shift();
                let n = 400;
                for i in 1..=n {
                    let t = f64::from(i) / f64::from(n);
                    let mix = |a: f64, b: f64| a + t * (b - a);
                    let to = Shift {
                        zeta: mix(from.zeta, zeta),
                        xi: mix(from.xi, xi),
                        eta: 0.0,
                        omega: mix(from.omega, omega),
                    };
                    let (p, s) = (law.load(), law.shift());
                    let q = law.advance(to).unwrap();
                    work += 0.5
                        * ((p.f_x + q.f_x) * (to.xi - s.xi)
                            + (p.f_z + q.f_z) * (to.zeta - s.zeta)
                            + (p.m_z + q.m_z) * (to.omega - s.omega));
                }
            }
            let balance = law.stored_energy() + law.dissipated();
            assert_relative_eq!(work, balance, max_relative = 1e-4);
            assert_eq!(law.dissipated() > 0.0, friction > 0.0);
        }
    }
}
