//! The contact laws of a twist, alone and together with a shift.

use std::f64::consts::PI;

use carom_special::RangeError;
use carom_special::quadrature::FixedRule;

use super::adhesion::{AdhesiveTorsion, sliding_torque_arm};
use super::history::{self, TwistHistory};
use crate::bounds::in_contact;
use crate::friction::Friction;
use crate::hertz::Hertz;
use crate::law::{ContactLaw, ContactLoad, Dissipative, Shift};
use crate::memory::{AdhesionMemory, Growing};
use crate::profile::PowerLaw;
use crate::shift_law::ShiftLaw;

/// Numbers before those of the memory.
const HEAD: usize = 4;

/// How many numbers the state of a [`TorsionLaw`] with so many pieces of density takes.
#[must_use]
pub const fn packed_numbers(pieces: usize) -> usize {
    HEAD + history::packed_numbers(pieces)
}

/// Gauss's nodes and weights on (0, 1).
const GAUSS: [(f64, f64); 5] = FixedRule::parts();

/// What the law of a twist takes from a contact, at unit approach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorsionConstants {
    /// `F_z = (2/3) c_z zeta^(3/2)`.
    pub c_z: f64,
    /// Torque over twist without slip, as `zeta^(3/2)`, (5.35).
    pub stiffness: f64,
    /// Torque of sliding over the friction limit, as `zeta^(1/2)`, (7.65).
    pub arm: f64,
}

impl TorsionConstants {
    /// Of a Hertzian contact.
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

/// The law of normal load and twist about the normal.
///
/// On a circular contact it is Lubkin's law with memory ([`TwistHistory`]). On an ellipse the same
/// law is scaled to the ellipse's initial stiffness (5.35) and sliding torque (7.65): both ends of
/// the torque curve are right, what lies between is approximate. Shifts xi and eta are carried along
/// without effect.
///
/// With friction a step goes straight in contact radius and twist: in the root of the approach, not the
/// approach. Where both change much at once the torque is not that of many small steps; in one step from
/// touch, before anything slips, it is 5/8 of theirs.
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
    /// bh = Omega times this, M_z = mu times that.
    per_twist: f64,
    per_torque: f64,
    state: State,
    shift: Shift,
}

#[derive(Debug, Clone, PartialEq)]
enum State {
    Free,
    Rubbing(TwistHistory),
    Stuck(Box<AdhesionMemory<f64, Growing<f64>, PowerLaw>>),
}

impl TorsionLaw {
    /// A law at rest, the bodies just touching and untwisted.
    ///
    /// # Errors
    /// [`RangeError`] if a stiffness over- or underflows.
    pub fn new(hertz: &Hertz, friction: Friction) -> Result<Self, RangeError> {
        Self::from_constants(TorsionConstants::of(hertz)?, friction)
    }

    /// The law of a contact of which only the constants are known, at rest.
    ///
    /// # Errors
    /// [`RangeError`] for a constant that is not positive and finite.
    pub fn from_constants(
        constants: TorsionConstants,
        friction: Friction,
    ) -> Result<Self, RangeError> {
        let TorsionConstants { c_z, stiffness, arm } = constants;
        RangeError::positive("c_z", c_z)?;
        RangeError::positive("torsional stiffness", stiffness)?;
        RangeError::positive("torsional arm", arm)?;
        let (state, per_twist, per_torque) = match friction.coefficient() {
            Some(0.0) => (State::Free, 0.0, 0.0),
            Some(f) => {
                let sliding = f * 2.0 / 3.0 * c_z * arm;
                let per_torque = sliding * 32.0 / (3.0 * PI);
                (State::Rubbing(TwistHistory::new()), stiffness / per_torque, per_torque)
            }
            None => {
                // Discs of depth z carry zeta^(3/2): a force zeta^(5/2), of which the derivative
                // has the factor 5/2.
                let profile = PowerLaw::of_shape(2.0 / 3.0)?;
                let memory = Box::new(AdhesionMemory::with_profile(profile));
                (State::Stuck(memory), 1.0, stiffness / 2.5)
            }
        };
        let shift = Shift::default();
        Ok(Self { c_z, per_twist, per_torque, state, shift })
    }

    /// The twist's history, if the friction is neither zero nor infinite.
    #[must_use]
    pub fn history(&self) -> Option<&TwistHistory> {
        match &self.state {
            State::Rubbing(history) => Some(history),
            _ => None,
        }
    }

    /// Writes shift and memory into numbers, [`packed_numbers`] of so many pieces; without slip, 11 and 9
    /// for each turn of the twist. The constants are not among them.
    ///
    /// If there is no room for the whole history the pieces that matter least are joined: the greatest
    /// jump of the torque that this may bring about is returned, [`TwistHistory::pack`].
    ///
    /// # Errors
    /// [`RangeError`] for too few numbers; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<f64, RangeError> {
        let room = numbers.len() as f64;
        RangeError::check("numbers", room, numbers.len() >= HEAD, ">= 4")?;
        let (head, rest) = numbers.split_at_mut(HEAD);
        let jump = match &self.state {
            State::Free => {
                rest.fill(0.0);
                0.0
            }
            State::Rubbing(history) => history.pack(rest)? * self.per_torque,
            State::Stuck(memory) => {
                memory.pack(rest)?;
                0.0
            }
        };
        let Shift { zeta, xi, eta, omega } = self.shift;
        head.copy_from_slice(&[zeta, xi, eta, omega]);
        Ok(jump)
    }

    /// Takes up what [`TorsionLaw::pack`] of a law of the same constants wrote, to the same bits.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are no state of this law; the law is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let room = numbers.len() as f64;
        RangeError::check("numbers", room, numbers.len() >= HEAD, ">= 4")?;
        let (head, rest) = numbers.split_at(HEAD);
        let shift = Shift { zeta: head[0], xi: head[1], eta: head[2], omega: head[3] };
        shift.check_finite()?;
        match &mut self.state {
            State::Free => {}
            State::Rubbing(history) => {
                let mut read = history.clone();
                read.unpack(rest)?;
                let touches = (shift.zeta > 0.0) == (read.radius() > 0.0);
                RangeError::check("approach", shift.zeta, touches, "> 0 in contact")?;
                let off = read.radius() * read.radius() - shift.zeta.max(0.0);
                let holds = off.abs() <= 1e-9 * shift.zeta.max(0.0);
                RangeError::check("radius", read.radius(), holds, "the root of the approach")?;
                *history = read;
            }
            State::Stuck(memory) => memory.unpack(rest)?,
        }
        self.shift = shift;
        Ok(())
    }

    /// a*/a, the size of the stick area, from 0 to 1.
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        match &self.state {
            _ if self.shift.zeta <= 0.0 => 0.0,
            State::Free => 0.0,
            State::Rubbing(history) => history.stick_radius() / history.radius(),
            State::Stuck(_) => 1.0,
        }
    }

    /// The elastic energy of the twist alone.
    #[must_use]
    pub fn twist_energy(&self) -> f64 {
        match &self.state {
            State::Free => 0.0,
            State::Rubbing(history) => history.stored_energy() * self.per_torque / self.per_twist,
            State::Stuck(memory) => memory.stored_energy() * self.per_torque,
        }
    }

    /// The twist, in the law's units, at which bodies that are apart touch on the straight way to a shift.
    fn touch(&self, to: Shift) -> Option<f64> {
        let from = self.shift;
        (from.zeta < 0.0 && to.zeta > 0.0).then(|| {
            let part = from.zeta / (from.zeta - to.zeta);
            (from.omega + part * (to.omega - from.omega)) * self.per_twist
        })
    }

    /// The torque in the law's units.
    fn torque(&self) -> f64 {
        match &self.state {
            State::Free => 0.0,
            State::Rubbing(history) => history.torque(),
            State::Stuck(memory) => memory.force(),
        }
    }
}

/// The heat of the straight way to a new radius and twist: the work of the torque, by Gauss, without what
/// is stored.
fn heat_to(history: &TwistHistory, radius: f64, twist: f64) -> Result<f64, RangeError> {
    let (radius_0, twist_0) = (history.radius(), history.twist());
    let mut probe = history.clone();
    let mut mean = 0.0;
    for (node, weight) in GAUSS {
        // Radii are roots of the approach, which is what goes straight.
        let square = radius_0 * radius_0 + node * (radius * radius - radius_0 * radius_0);
        let at = square.max(0.0).sqrt();
        mean += weight * probe.advance(at, twist_0 + node * (twist - twist_0))?;
    }
    let mut end = history.clone();
    end.advance(radius, twist)?;
    let gained = end.stored_energy() - history.stored_energy();
    Ok((mean * (twist - twist_0) - gained).max(0.0))
}

impl ContactLaw for TorsionLaw {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        shift.check_finite()?;
        let twist = in_contact("omega", shift.omega * self.per_twist)?;
        let touch = self.touch(shift);
        match &mut self.state {
            State::Free => {}
            State::Rubbing(history) => {
                if let Some(touch) = touch {
                    history.separate(touch);
                }
                history.advance(shift.zeta.max(0.0).sqrt(), twist)?;
            }
            State::Stuck(memory) => {
                memory.advance(shift.zeta, twist)?;
            }
        }
        self.shift = shift;
        Ok(self.load())
    }

    fn shift(&self) -> Shift {
        self.shift
    }

    fn load(&self) -> ContactLoad {
        let zeta = self.shift.zeta.max(0.0);
        let f_z = 2.0 / 3.0 * self.c_z * (zeta * zeta.sqrt());
        ContactLoad { f_z, m_z: self.torque() * self.per_torque, ..ContactLoad::default() }
    }
}

impl Dissipative for TorsionLaw {
    fn stored_energy(&self) -> f64 {
        let zeta = self.shift.zeta.max(0.0);
        4.0 / 15.0 * self.c_z * (zeta * zeta * zeta.sqrt()) + self.twist_energy()
    }

    fn dissipation(&self, to: Shift) -> f64 {
        let twist = to.omega * self.per_twist;
        if to.check_finite().and(in_contact("omega", twist)).is_err() {
            return 0.0;
        }
        match &self.state {
            State::Free => 0.0,
            State::Rubbing(history) => {
                let radius = to.zeta.max(0.0).sqrt();
                let heat = match self.touch(to) {
                    Some(touch) => {
                        let mut touching = history.clone();
                        touching.separate(touch);
                        heat_to(&touching, radius, twist)
                    }
                    None => heat_to(history, radius, twist),
                };
                heat.unwrap_or(0.0) * self.per_torque / self.per_twist
            }
            State::Stuck(memory) => memory.dissipation(to.zeta, twist) * self.per_torque,
        }
    }
}

/// Shift and twist together, each by its own law as if the other were absent.
///
/// An approximation: both draw on the same friction. It is right as long as at least one of them is
/// small; where both approach their limits the true load is smaller, up to the limit surface of
/// [`crate::rigid_slip`].
#[derive(Debug, Clone, PartialEq)]
pub struct ShiftTwistLaw {
    tangential: ShiftLaw<[f64; 2]>,
    torsion: TorsionLaw,
}

impl ShiftTwistLaw {
    /// A law at rest, the bodies just touching.
    ///
    /// # Errors
    /// As [`TorsionLaw::new`].
    pub fn new(hertz: &Hertz, friction: Friction) -> Result<Self, RangeError> {
        let torsion = TorsionLaw::new(hertz, friction)?;
        let shift = ShiftLaw::new(hertz.stiffness(), friction);
        Ok(Self { tangential: shift, torsion })
    }

    /// The law of two that were kept apart.
    ///
    /// # Errors
    /// [`RangeError`] if they are not at the same place.
    pub fn of(tangential: ShiftLaw<[f64; 2]>, torsion: TorsionLaw) -> Result<Self, RangeError> {
        let (one, other) = (tangential.shift(), torsion.shift());
        RangeError::check("approach", other.zeta, one.zeta == other.zeta, "that of the shift")?;
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
