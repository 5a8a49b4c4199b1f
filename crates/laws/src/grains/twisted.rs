//! What a contact of grains keeps of its twist.

use std::fmt::Debug;

use carom_special::RangeError;

use super::meeting::Meeting;
use super::vector::dot;

/// The twist in the last step of a contact, beside the history of its law.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct Twisted {
    /// The torque about the normal, on body 1, N m.
    pub(super) torque: f64,
    /// Of a damped contact, the rate of the twist, rad/s; clockwise, as in the law.
    pub(super) rate: f64,
    /// Difference between the twist given to the law and the true twist.
    pub(super) lead: f64,
}

/// What is kept of a twist: [`Twisted`], or nothing where the law does not follow it.
pub trait TwistState: Copy + Default + PartialEq + Debug {
    /// Whether the law follows a twist.
    const COUNTS: bool;
    /// Number of numbers of its stored form.
    const NUMBERS: usize;

    /// The twist; zeros where it is not followed.
    fn get(self) -> Twisted;

    /// What is kept of a twist.
    fn of(twisted: Twisted) -> Self;
}

impl TwistState for () {
    const COUNTS: bool = false;
    const NUMBERS: usize = 0;

    #[inline(always)]
    fn get(self) -> Twisted {
        Twisted::default()
    }

    #[inline(always)]
    fn of(_twisted: Twisted) {}
}

impl TwistState for Twisted {
    const COUNTS: bool = true;
    const NUMBERS: usize = 3;

    #[inline(always)]
    fn get(self) -> Twisted {
        self
    }

    #[inline(always)]
    fn of(twisted: Twisted) -> Self {
        twisted
    }
}

/// Writes what is kept of a twist.
pub(super) fn write<T: TwistState>(twist: T, numbers: &mut [f64]) {
    let Twisted { torque, rate, lead } = twist.get();
    numbers.copy_from_slice(&[torque, rate, lead][..T::NUMBERS]);
}

/// Reads what was written.
pub(super) fn read<T: TwistState>(numbers: &[f64]) -> Result<T, RangeError> {
    let mut all = [0.0; 3];
    all[..T::NUMBERS].copy_from_slice(&numbers[..T::NUMBERS]);
    let [torque, rate, lead] = all;
    for (field, value) in [("torque", torque), ("twist", rate), ("twist", lead)] {
        RangeError::finite(field, value)?;
    }
    Ok(T::of(Twisted { torque, rate, lead }))
}

/// The twist during a step, clockwise as in the law.
pub(super) fn turned(meeting: &Meeting, dt: f64) -> f64 {
    -dot(meeting.twisting(), meeting.normal) * dt
}
