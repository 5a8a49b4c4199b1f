//! What a contact of grains keeps of its twist.

use std::fmt::Debug;

use carom_special::RangeError;

use super::meeting::Meeting;
use super::vector::dot;

/// The twist of a contact beside the history of its law; the law counts it clockwise.
pub trait TwistState: Copy + Default + PartialEq + Debug {
    /// Whether the law follows a twist.
    const COUNTS: bool;
    /// Number of numbers of its stored form.
    const NUMBERS: usize;

    /// The torque of the last step about the normal, on body 1, N m.
    fn torque(self) -> f64;

    /// The rate of the twist in the last step of a damped contact, rad/s.
    fn rate(self) -> f64;

    /// Difference between the twist given to the law and the true twist.
    fn lead(self) -> f64;

    /// The same with another torque.
    #[must_use]
    fn with_torque(self, torque: f64) -> Self;

    /// The same with another rate and lead.
    #[must_use]
    fn with_motion(self, rate: f64, lead: f64) -> Self;
}

/// That of a law of shifts alone: nothing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct NoTwist;

/// That of a law in which the twist counts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct Twisted {
    torque: f64,
    rate: f64,
    lead: f64,
}

impl TwistState for NoTwist {
    const COUNTS: bool = false;
    const NUMBERS: usize = 0;

    #[inline(always)]
    fn torque(self) -> f64 {
        0.0
    }

    #[inline(always)]
    fn rate(self) -> f64 {
        0.0
    }

    #[inline(always)]
    fn lead(self) -> f64 {
        0.0
    }

    #[inline(always)]
    fn with_torque(self, _torque: f64) -> Self {
        self
    }

    #[inline(always)]
    fn with_motion(self, _rate: f64, _lead: f64) -> Self {
        self
    }
}

impl TwistState for Twisted {
    const COUNTS: bool = true;
    const NUMBERS: usize = 3;

    fn torque(self) -> f64 {
        self.torque
    }

    fn rate(self) -> f64 {
        self.rate
    }

    fn lead(self) -> f64 {
        self.lead
    }

    fn with_torque(self, torque: f64) -> Self {
        Self { torque, ..self }
    }

    fn with_motion(self, rate: f64, lead: f64) -> Self {
        Self { rate, lead, ..self }
    }
}

/// Writes what is kept of a twist.
pub(super) fn write<T: TwistState>(twist: T, numbers: &mut [f64]) {
    let all = [twist.torque(), twist.rate(), twist.lead()];
    numbers.copy_from_slice(&all[..T::NUMBERS]);
}

/// Reads what was written.
pub(super) fn read<T: TwistState>(numbers: &[f64]) -> Result<T, RangeError> {
    if !T::COUNTS {
        return Ok(T::default());
    }
    let [torque, rate, lead] = [0, 1, 2].map(|i| numbers[i]);
    for (field, value) in [("torque", torque), ("twist", rate), ("twist", lead)] {
        RangeError::finite(field, value)?;
    }
    Ok(T::default().with_torque(torque).with_motion(rate, lead))
}

/// The twist during a step, clockwise as in the law.
pub(super) fn turned(meeting: &Meeting, dt: f64) -> f64 {
    -dot(meeting.twisting(), meeting.normal) * dt
}
