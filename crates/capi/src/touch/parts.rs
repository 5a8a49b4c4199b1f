//! What a contact may have beside its law: torsion and a resistance to rolling, by the same meeting.

use carom_laws::grains::{GrainLoad, GrainRoll, GrainTwist, Heats, Meeting, RollTrial};
use carom_laws::law::ContactLaw as _;
use carom_laws::torsion::law::{TorsionLaw, packed_numbers};
use carom_special::RangeError;

use crate::error::Failure;
use crate::law::CaromLaw;

/// Pieces of the history of a twist that are kept exactly, one or two for each reversal; beyond that those that matter
/// least are joined. Over random histories the error of the torque was then below 3e-4 of the sliding torque in the
/// mean, and .02 at most.
const PIECES: usize = 12;
pub(super) const TWIST_NUMBERS: usize = packed_numbers(PIECES);

/// The state of a twist; zeros stand for two separated bodies.
pub(super) type Twist = [f64; TWIST_NUMBERS];
/// The state of a rolling resistance.
pub(super) type Roll = GrainRoll;

/// A twist at the end of a step, and its torque on body 1.
pub(super) struct Turned {
    twist: GrainTwist,
    pub(super) torque: [f64; 3],
    /// Whether the step took time.
    moves: bool,
}

/// Two bodies, and what they have in common.
#[derive(Clone, Copy)]
pub(super) struct Pressed<'a> {
    pub(super) law: &'a CaromLaw,
    pub(super) relative_radius: f64,
    pub(super) meeting: &'a Meeting,
}

impl Pressed<'_> {
    /// A step of the twist, which is still to be kept.
    pub(super) fn turned(
        &self,
        twist: &Twist,
        dt: f64,
        heats: Option<&mut Heats>,
    ) -> Result<Turned, Failure> {
        let mut twist = GrainTwist::new(torsion(self.law, self.relative_radius, twist)?);
        let is_new = twist.law().shift().zeta <= 0.0;
        if dt == 0.0 && !is_new && !self.meeting.is_apart() {
            let torque = twist.torque(self.meeting);
            return Ok(Turned { twist, torque, moves: false });
        }
        let torque = match heats {
            None => twist.advance(self.meeting, dt)?,
            Some(heats) => twist.advance_accounted(self.meeting, dt, heats)?,
        };
        Ok(Turned { twist, torque, moves: true })
    }

    /// Keeps a twist.
    pub(super) fn keep(&self, turned: &Turned, twist: &mut Twist) {
        if !turned.moves {
            return;
        }
        if self.meeting.is_apart() || turned.twist.law().pack(twist).is_err() {
            twist.fill(0.0);
        }
    }

    /// The step of a resistance to rolling before its load is known; none if there is no resistance.
    #[inline]
    pub(super) fn trial(&self, roll: &Roll, dt: f64) -> Result<RollTrial, Failure> {
        match self.law.rolling() {
            Some(its) => Ok(roll.trial((its, self.relative_radius), self.meeting, dt)?),
            None => Ok(RollTrial::default()),
        }
    }

    /// Adds the torque of the resistance to rolling, whose trial has not failed, to the load that presses the bodies.
    #[inline]
    pub(super) fn roll(
        &self,
        (roll, trial): (&mut Roll, &RollTrial),
        load: &mut GrainLoad,
        heats: Option<&mut Heats>,
    ) {
        let Some(its) = self.law.rolling() else { return };
        let ([a, b, c], [x, y, z]) = (load.force, self.meeting.normal);
        let (normal_force, mut unasked) = (a * x + b * y + c * z, Heats::default());
        let heats = heats.unwrap_or(&mut unasked);
        let torque = roll.end((its, self.relative_radius), trial, normal_force, heats);
        self.add(load, torque);
    }

    /// Adds a torque on body 1 to a load; body 2 gets the opposite, unless it is a wall.
    pub(super) fn add(&self, load: &mut GrainLoad, torque: [f64; 3]) {
        let [one, two] = &mut load.torques;
        let has_torque = self.meeting.arms[1] != 0.0;
        for k in 0..3 {
            one[k] += torque[k];
            if has_torque {
                two[k] -= torque[k];
            }
        }
    }
}

/// The law of a twist with this history.
pub(super) fn torsion(
    law: &CaromLaw,
    relative_radius: f64,
    twist: &Twist,
) -> Result<TorsionLaw, Failure> {
    let mut its = law.torsion_law(relative_radius)?;
    its.unpack(twist).map_err(|error| Failure::from(error).in_state())?;
    Ok(its)
}

/// The state of a rolling resistance that these numbers are.
pub(super) fn roll_of(numbers: &[f64; GrainRoll::NUMBERS]) -> Result<Roll, Failure> {
    GrainRoll::unpacked(numbers).map_err(|error: RangeError| Failure::from(error).in_state())
}
