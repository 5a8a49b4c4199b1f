//! The contact law of a twist.

mod shift_twist;
mod stored;

pub use shift_twist::ShiftTwistLaw;
pub use stored::StoredTwist;

use std::f64::consts::PI;

use carom_special::RangeError;

use crate::bounds::{constant, in_contact};
use crate::friction::Friction;
use crate::hertz::Hertz;
use crate::law::{ContactLaw, ContactLoad, Dissipative, Shift};
use crate::memory::{AdhesionMemory, Growing};
use crate::profile::PowerLaw;
use crate::stored::{Fields as _, Reader, Writer};
use crate::torsion::adhesion::{AdhesiveTorsion, sliding_torque_arm};
use crate::torsion::history::{self, TwistHistory};

/// Number of values before those of the memory.
const HEAD: usize = 4;

/// Number of values of a stored [`TorsionLaw`] with this many pieces of density.
#[must_use]
pub const fn packed_numbers(pieces: usize) -> usize {
    HEAD + history::packed_numbers(pieces)
}

/// The constants of a torsion law, at unit approach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorsionConstants {
    /// `F_z = (2/3) c_z zeta^(3/2)`.
    pub c_z: f64,
    /// Torque divided by twist without slip, proportional to `zeta^(3/2)`, (5.35).
    pub stiffness: f64,
    /// Sliding torque divided by the friction limit, proportional to `zeta^(1/2)`, (7.65).
    pub arm: f64,
}

impl TorsionConstants {
    /// The constants of a Hertz contact.
    ///
    /// # Errors
    /// [`RangeError`] if one of them over- or underflows.
    pub fn of(hertz: &Hertz) -> Result<Self, RangeError> {
        let ellipse = hertz.ellipse(1.0)?;
        let stiffness = AdhesiveTorsion::new(ellipse, hertz.materials()).stiffness();
        RangeError::positive("torsional stiffness", stiffness)?;
        let arm = sliding_torque_arm(&ellipse);
        Ok(Self { c_z: hertz.stiffness().c_z, stiffness, arm })
    }
}

/// The contact law for normal load and twist about the normal.
///
/// For a circular contact it is Lubkin's law with memory ([`TwistHistory`]). For an ellipse the
/// same law is scaled to the initial stiffness (5.35) and the sliding torque (7.65) of the ellipse:
/// both ends of the torque curve are exact, the curve between them is approximate. Shifts xi and
/// eta are stored but have no effect.
///
/// For any friction, also infinite, a step is straight in contact radius and twist, that is, in the
/// square root of the approach. If both change much in one step, the torque differs from that of
/// many steps on a path straight in the approach: for one step from first contact without slip it
/// is (1/4) K Omega instead of (2/5) K Omega, where K is the stiffness (5.35) at the end. For
/// increasing friction, torque and energies tend to those of infinite friction. The heat is the
/// work of the torque on the path of the step minus the increase of the stored energy, with the
/// error of [`TwistHistory::dissipation`], and 0 without slip. To compute it takes about three
/// times as long as a small step, and up to sixty times for a step that slides far or twists under
/// increasing load.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_laws::curvature::RelativeCurvature;
/// use carom_laws::friction::Friction;
/// use carom_laws::hertz::Hertz;
/// use carom_laws::law::{ContactLaw, Shift};
/// use carom_laws::torsion::law::TorsionLaw;
/// let body = Material::from_shear(2.0, 0.3)?;
/// let gap = RelativeCurvature::from_coefficients(0.5, 0.5)?;
/// let hertz = Hertz::new(gap, MaterialPair::new(body, body)?)?;
/// let mut law = TorsionLaw::new(&hertz, Friction::new(0.3)?)?;
/// law.advance(Shift { zeta: 0.01, ..Shift::default() })?;
/// let load = law.advance(Shift { zeta: 0.01, omega: 9.0, ..Shift::default() })?;
/// let a = hertz.ellipse(0.01)?.semi_axis_a();
/// let sliding = 3.0 * std::f64::consts::PI / 16.0 * 0.3 * load.f_z * a;
/// assert!((load.m_z / sliding - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TorsionLaw {
    c_z: f64,
    /// bh = Omega times `per_twist`, M_z = mu times `per_torque`.
    per_twist: f64,
    per_torque: f64,
    state: State,
    shift: Shift,
}

#[derive(Debug, Clone, PartialEq)]
enum State {
    Frictionless,
    Lubkin(TwistHistory),
    Adhesion(Box<AdhesionMemory<f64, Growing<f64>, PowerLaw>>),
}

impl TorsionLaw {
    /// A law in its initial state: bodies at first contact, without twist.
    ///
    /// # Errors
    /// [`RangeError`] if a stiffness over- or underflows.
    pub fn new(hertz: &Hertz, friction: Friction) -> Result<Self, RangeError> {
        Self::from_constants(TorsionConstants::of(hertz)?, friction)
    }

    /// A law in its initial state, from the constants of a contact.
    ///
    /// # Errors
    /// [`RangeError`] for a constant that is not from 1e-60 to 1e60, or a sliding torque or the twist at which the
    /// contact slides that are far out of range.
    #[inline]
    pub fn from_constants(
        constants: TorsionConstants,
        friction: Friction,
    ) -> Result<Self, RangeError> {
        let TorsionConstants { c_z, stiffness, arm } = constants;
        constant("c_z", c_z)?;
        constant("torsional stiffness", stiffness)?;
        constant("torsional arm", arm)?;
        let (state, per_twist, per_torque) = match friction.coefficient() {
            Some(0.0) => (State::Frictionless, 0.0, 0.0),
            Some(f) => {
                let sliding = f * 2.0 / 3.0 * c_z * arm;
                let per_torque = sliding * 32.0 / (3.0 * PI);
                let holds = (1e-90..=1e90).contains(&per_torque);
                RangeError::check("sliding torque", per_torque, holds, "from 1e-90 to 1e90")?;
                let per_twist = constant("twist of sliding", stiffness / per_torque)?;
                let history = TwistHistory::new().counted_from(arm);
                (State::Lubkin(history), per_twist, per_torque)
            }
            None => {
                // Discs of radius a carry a^3: a force a^4, whose derivative has the factor 4.
                let profile = PowerLaw::of_shape(1.0 / 3.0)?;
                let memory = Box::new(AdhesionMemory::with_profile(profile));
                (State::Adhesion(memory), 1.0, stiffness / 4.0)
            }
        };
        let shift = Shift::default();
        Ok(Self { c_z, per_twist, per_torque, state, shift })
    }

    /// The history of the twist, if friction is neither zero nor infinite.
    #[must_use]
    pub fn history(&self) -> Option<&TwistHistory> {
        match &self.state {
            State::Lubkin(history) => Some(history),
            _ => None,
        }
    }

    /// Writes shift and history as numbers: [`packed_numbers`] of the number of pieces; without
    /// slip, 11 and 9 for each reversal of the twist. The constants are not stored.
    ///
    /// If there is not enough room for the whole history, the pieces that matter least are joined.
    /// The greatest later jump of the torque due to this is returned, see [`TwistHistory::pack`].
    ///
    /// # Errors
    /// [`RangeError`] for too few numbers; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<f64, RangeError> {
        let mut writer = Writer::new(numbers, HEAD, ">= 4")?;
        let (head, rest) = (writer.part(HEAD), writer.rest());
        let jump = match &self.state {
            State::Frictionless => {
                rest.fill(0.0);
                0.0
            }
            State::Lubkin(history) => history.pack(rest)? * self.per_torque,
            State::Adhesion(memory) => {
                memory.pack(rest)?;
                0.0
            }
        };
        let Shift { zeta, xi, eta, omega } = self.shift;
        head.copy_from_slice(&[zeta, xi, eta, omega]);
        Ok(jump)
    }

    /// Restores what [`TorsionLaw::pack`] of a law with the same constants wrote, bit for bit.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are not a state of this law; the law is then unchanged.
    #[inline]
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let mut reader = Reader::new(numbers, ">= 4");
        let mut shift = Shift::default();
        reader.shift(&mut shift)?;
        let rest = reader.rest();
        match &mut self.state {
            State::Frictionless => {}
            State::Lubkin(history) => {
                let read = TwistHistory::read(rest)?;
                check_approach(shift.zeta, read.radius())?;
                *history = read.counted_from(history.unit);
            }
            State::Adhesion(memory) => {
                let mut read = memory.clone();
                read.unpack(rest)?;
                check_approach(shift.zeta, read.zeta())?;
                *memory = read;
            }
        }
        self.shift = shift;
        Ok(())
    }

    /// a*/a, the relative radius of the stick area, from 0 to 1.
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        match &self.state {
            _ if self.shift.zeta <= 0.0 => 0.0,
            State::Frictionless => 0.0,
            State::Lubkin(history) => history.stick_radius() / history.radius(),
            State::Adhesion(_) => 1.0,
        }
    }

    /// The elastic energy of the twist only.
    #[must_use]
    pub fn twist_energy(&self) -> f64 {
        match &self.state {
            State::Frictionless => 0.0,
            State::Lubkin(history) => history.stored_energy() * self.per_torque / self.per_twist,
            State::Adhesion(memory) => memory.stored_energy() * self.per_torque,
        }
    }

    /// The part of the straight path to a shift on which the bodies are in contact.
    fn way(&self, to: Shift) -> SlipPath {
        let from = self.shift;
        let crossing = || {
            let part = from.zeta / (from.zeta - to.zeta);
            (from.omega + part * (to.omega - from.omega)) * self.per_twist
        };
        let parts = from.zeta > 0.0 && to.zeta < 0.0;
        SlipPath {
            touch: (from.zeta < 0.0 && to.zeta > 0.0).then(crossing),
            radius: to.zeta.max(0.0).sqrt(),
            twist: if parts { crossing() } else { to.omega * self.per_twist },
        }
    }

    /// Advances to a new shift, as [`ContactLaw::advance`], and returns the heat of the step.
    pub(crate) fn advance_with_heat(&mut self, to: Shift) -> Result<f64, RangeError> {
        self.go(to, TwistHistory::advance_with_heat)
    }

    /// Advances to a new shift, as [`ContactLaw::advance`].
    pub(crate) fn move_to(&mut self, to: Shift) -> Result<(), RangeError> {
        self.go(to, TwistHistory::advance).map(|_| ())
    }

    /// Advances to a new shift. The history is moved by `advance`, whose value is returned as its
    /// heat.
    fn go(
        &mut self,
        to: Shift,
        advance: impl Fn(&mut TwistHistory, f64, f64) -> Result<f64, RangeError>,
    ) -> Result<f64, RangeError> {
        to.check_finite()?;
        in_contact("omega", to.omega * self.per_twist)?;
        let SlipPath { touch, radius, twist } = self.way(to);
        let heat = match &mut self.state {
            State::Frictionless => 0.0,
            State::Lubkin(history) => {
                if let Some(touch) = touch {
                    history.separate(touch);
                }
                advance(history, radius, twist)? * self.per_torque / self.per_twist
            }
            State::Adhesion(memory) => {
                if let Some(touch) = touch {
                    memory.advance(0.0, touch)?;
                }
                let heat = memory.dissipation(radius, twist) * self.per_torque;
                memory.advance(radius, twist)?;
                heat
            }
        };
        if to.zeta <= 0.0 {
            self.separate(to.omega)?;
        }
        self.shift = to;
        Ok(heat)
    }

    /// The twist continues while the bodies are separated.
    fn separate(&mut self, omega: f64) -> Result<(), RangeError> {
        let twist = omega * self.per_twist;
        match &mut self.state {
            State::Frictionless => {}
            State::Lubkin(history) => history.separate(twist),
            State::Adhesion(memory) => {
                memory.advance(0.0, twist)?;
            }
        }
        Ok(())
    }

    /// The torque of the twist.
    pub(crate) fn twist_torque(&self) -> f64 {
        self.per_torque
            * match &self.state {
                State::Frictionless => 0.0,
                State::Lubkin(history) => history.torque(),
                State::Adhesion(memory) => memory.force(),
            }
    }
}

/// The part of a step with the bodies in contact, in the units of the history.
struct SlipPath {
    /// The twist at first contact, if the bodies were separated before.
    touch: Option<f64>,
    /// Radius and twist at the end.
    radius: f64,
    twist: f64,
}

/// Checks that a memory matches an approach.
fn check_approach(zeta: f64, radius: f64) -> Result<(), RangeError> {
    let touches = (zeta > 0.0) == (radius > 0.0);
    RangeError::check("approach", zeta, touches, "> 0 in contact")?;
    let off = radius * radius - zeta.max(0.0);
    let holds = off.abs() <= 1e-9 * zeta.max(0.0);
    RangeError::check("radius", radius, holds, "the square root of the approach")?;
    Ok(())
}

impl ContactLaw for TorsionLaw {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        self.move_to(shift)?;
        Ok(self.load())
    }

    fn shift(&self) -> Shift {
        self.shift
    }

    fn load(&self) -> ContactLoad {
        let zeta = self.shift.zeta.max(0.0);
        let f_z = 2.0 / 3.0 * self.c_z * (zeta * zeta.sqrt());
        ContactLoad { f_z, m_z: self.twist_torque(), ..ContactLoad::default() }
    }
}

impl Dissipative for TorsionLaw {
    fn stored_energy(&self) -> f64 {
        let zeta = self.shift.zeta.max(0.0);
        4.0 / 15.0 * self.c_z * (zeta * zeta * zeta.sqrt()) + self.twist_energy()
    }

    fn dissipation(&self, to: Shift) -> f64 {
        self.clone().advance_with_heat(to).unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curvature::RelativeCurvature;
    use approx::assert_relative_eq;
    use carom_halfspace::{Material, MaterialPair};

    fn hertz(a: f64, b: f64) -> Hertz {
        let body = Material::from_shear(2.0, 0.3).unwrap();
        let gap = RelativeCurvature::from_coefficients(a, b).unwrap();
        Hertz::new(gap, MaterialPair::new(body, body).unwrap()).unwrap()
    }

    #[test]
    fn limits_on_an_ellipse() {
        let hertz = hertz(1.0, 0.2);
        let mut law = TorsionLaw::new(&hertz, Friction::new(0.4).unwrap()).unwrap();
        let at = |omega| Shift { zeta: 0.01, omega, ..Shift::default() };
        law.advance(at(0.0)).unwrap();
        let small = law.advance(at(1e-9)).unwrap().m_z / 1e-9;
        let ellipse = hertz.ellipse(0.01).unwrap();
        let stiffness = AdhesiveTorsion::new(ellipse, hertz.materials()).stiffness();
        assert_relative_eq!(small, stiffness, max_relative = 1e-6);
        let large = law.advance(at(10.0)).unwrap();
        let limit = 0.4 * large.f_z * sliding_torque_arm(&ellipse);
        assert_relative_eq!(large.m_z, limit, max_relative = 1e-12);
        let before = law.clone();
        assert_eq!(law.advance(at(f64::NAN)).unwrap_err().field, "omega");
        assert_eq!(law, before);
    }
}
