//! The whole contact of two grains: its law, torsion and resistance to rolling, in one step.

use carom_special::RangeError;

use super::contact::GrainContact;
use super::heats::Heats;
use super::law::GrainLaw;
use super::load::GrainLoad;
use super::meeting::Meeting;
use super::pack::ENOUGH;
use super::rolling::{GrainRoll, Rolling};
use super::twist::GrainTwist;
use crate::law::ContactLaw as _;
use crate::stored::{Reader, Writer, any};
use crate::torsion::law::StoredTwist;

/// The whole contact of two grains. Its parts lie where a particle code keeps them.
///
/// The torque about the normal is that of a law with memory which neglects the shift ([`GrainTwist`]); the resistance to
/// rolling is limited by the normal force of the same step ([`Rolling`]).
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_laws::curvature::RelativeCurvature;
/// use carom_laws::friction::Friction;
/// use carom_laws::grains::{
///     Grain, GrainContact, GrainLoad, GrainRoll, Meeting, Rolling, RollingResistance, WholeContact,
/// };
/// use carom_laws::hertz::Hertz;
/// use carom_laws::shift_law::ShiftLaw;
/// use carom_laws::torsion::law::{StoredTwist, TorsionLaw};
/// let glass = Material::from_young(70e9, 0.22)?;
/// let pair = MaterialPair::new(glass, glass)?;
/// let hertz = Hertz::new(RelativeCurvature::from_coefficients(1.0, 1.0)?, pair)?;
/// let friction = Friction::new(0.3)?;
/// let mut contact = GrainContact::new(ShiftLaw::<[f64; 2]>::new(hertz.stiffness(), friction), 0.0)?;
/// let mut twist = StoredTwist::new(&TorsionLaw::new(&hertz, friction)?)?;
/// let (resistance, mut roll) = (RollingResistance::new(1e6, 0.1, 0.01)?, GrainRoll::default());
/// let rolling = Rolling { resistance: &resistance, relative_radius: 0.5, roll: &mut roll };
/// let mut whole = WholeContact { contact: &mut contact, twist: Some(&mut twist), rolling: Some(rolling) };
/// let below = Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
/// let above = Grain { place: [0.0, 0.0, 2.0 - 1e-6], spin: [0.0, 3.0, 1.0], ..below };
/// let mut load = GrainLoad::default();
/// whole.advance(&Meeting::of_spheres(&above, &below, [0.5; 2])?, 1e-3, &mut load, None)?;
/// // Friction turns the ball forward, the resistances act against its rolling and its spin.
/// assert!(load.torques[0][2] < 0.0 && load.torques[1][2] > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct WholeContact<'a, L: GrainLaw> {
    /// The contact of its law.
    pub contact: &'a mut GrainContact<L>,
    /// The twist about the normal, unless it is left alone or the law follows it.
    pub twist: Option<&'a mut StoredTwist>,
    /// The resistance to rolling.
    pub rolling: Option<Rolling<'a>>,
}

/// A twist at the end of a step, and its torque on body 1.
struct Turned {
    twist: GrainTwist,
    torque: [f64; 3],
    /// Whether the step took time.
    moves: bool,
}

impl Turned {
    fn of(
        twist: &StoredTwist,
        meeting: &Meeting,
        dt: f64,
        heats: Option<&mut Heats>,
    ) -> Result<Self, RangeError> {
        let mut twist = GrainTwist::new(twist.law());
        let is_new = twist.law().shift().zeta <= 0.0;
        if dt == 0.0 && !is_new && !meeting.is_apart() {
            let torque = twist.torque(meeting);
            return Ok(Self { twist, torque, moves: false });
        }
        let torque = match heats {
            None => twist.advance(meeting, dt)?,
            Some(heats) => twist.advance_accounted(meeting, dt, heats)?,
        };
        Ok(Self { twist, torque, moves: true })
    }

    fn keep(self, meeting: &Meeting, twist: &mut StoredTwist) {
        if self.moves && meeting.is_apart() {
            twist.separate();
        } else if self.moves {
            twist.keep(self.twist.into_law());
        }
    }
}

impl<L: GrainLaw> WholeContact<'_, L> {
    /// Advances as [`GrainContact::advance`], and writes the load of all parts. The heat of the step is added to `heats`
    /// if they are given; it costs as much as [`GrainContact::advance_accounted`] says.
    ///
    /// # Errors
    /// [`RangeError`] if one of the parts cannot make the step; all are then unchanged.
    pub fn advance(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
        mut heats: Option<&mut Heats>,
    ) -> Result<(), RangeError> {
        // What may fail of the others comes first, on copies; the contact itself stays as it was if its step fails.
        let rolls = self.rolling.as_ref().map(|rolling| rolling.trial(meeting, dt)).transpose()?;
        let mut made = heats.is_some().then(Heats::default);
        let turn = |twist: &&mut StoredTwist| Turned::of(twist, meeting, dt, made.as_mut());
        let turned = self.twist.as_ref().map(turn).transpose()?;
        self.contact.advance_with(meeting, dt, load, heats.as_deref_mut())?;
        if let (Some(twist), Some(turned)) = (&mut self.twist, turned) {
            load.couple(meeting, turned.torque);
            turned.keep(meeting, twist);
        }
        if let (Some(rolling), Some(trial)) = (&mut self.rolling, &rolls) {
            rolling.press(meeting, trial, load, heats.as_deref_mut());
        }
        if let (Some(heats), Some(made)) = (heats, made) {
            heats.friction += made.friction;
        }
        Ok(())
    }

    /// The load at the end of the last step, for the bodies as given, as [`GrainContact::load`].
    #[must_use]
    pub fn load(&self, meeting: &Meeting) -> GrainLoad {
        let mut load = self.contact.load(meeting);
        if meeting.is_apart() {
            return load;
        }
        if let Some(twist) = &self.twist {
            load.couple(meeting, GrainTwist::new(twist.law()).torque(meeting));
        }
        if let Some(Rolling { relative_radius, roll, .. }) = &self.rolling {
            load.couple(meeting, roll.torque(*relative_radius, meeting));
        }
        load
    }

    /// The elastic energy, J: of compression, of the tangential load, of twist and of rolling.
    #[must_use]
    pub fn stored_energy(&self) -> f64 {
        let mut energy = self.contact.stored_energy();
        if let Some(twist) = &self.twist {
            energy += twist.law().twist_energy();
        }
        if let Some(Rolling { resistance, roll, .. }) = &self.rolling {
            energy += roll.stored_energy(resistance);
        }
        energy
    }

    /// Number of numbers beside those of the contact.
    fn beside(&self) -> usize {
        let twist = self.twist.as_ref().map_or(0, |_| StoredTwist::NUMBERS);
        twist + self.rolling.as_ref().map_or(0, |_| GrainRoll::NUMBERS)
    }

    /// Writes the state as numbers: those of [`GrainContact::pack`], of [`StoredTwist::pack`] and of the rolling.
    ///
    /// # Errors
    /// [`RangeError`] if `numbers` is too short.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        let its = numbers.len().saturating_sub(self.beside());
        let mut writer = Writer::new(numbers, self.beside(), ENOUGH)?;
        self.contact.pack(writer.part(its))?;
        if let Some(twist) = &self.twist {
            twist.pack(writer.part(StoredTwist::NUMBERS))?;
        }
        if let Some(rolling) = &self.rolling {
            writer.write(&rolling.roll.packed());
        }
        Ok(())
    }

    /// Restores what [`WholeContact::pack`] of a contact with the same constants and parts wrote.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are not a stored contact; all parts are then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        let mut reader = Reader::new(numbers, ENOUGH);
        let its = reader.part(numbers.len().saturating_sub(self.beside()))?;
        let mut twist = self.twist.as_deref().copied();
        if let Some(twist) = &mut twist {
            twist.unpack(reader.part(StoredTwist::NUMBERS)?)?;
        }
        let roll = self.rolling.as_ref().map(|_| GrainRoll::unpacked(&reader.read("roll", any)?));
        let roll = roll.transpose()?;
        self.contact.unpack(its)?;
        if let (Some(place), Some(twist)) = (&mut self.twist, twist) {
            **place = twist;
        }
        if let (Some(rolling), Some(roll)) = (&mut self.rolling, roll) {
            *rolling.roll = roll;
        }
        Ok(())
    }
}
