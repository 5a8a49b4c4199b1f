//! What a contact of grains keeps of its twist.

use std::fmt::Debug;

use carom_special::RangeError;

use super::meeting::Meeting;
use super::vector::dot;
use crate::stored::Fields;

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

    /// The twist; zeros where it is not followed.
    fn get(self) -> Twisted;

    /// What is kept of a twist.
    fn of(twisted: Twisted) -> Self;
}

impl TwistState for () {
    const COUNTS: bool = false;

    #[inline(always)]
    fn get(self) -> Twisted {
        Twisted::default()
    }

    #[inline(always)]
    fn of(_twisted: Twisted) {}
}

impl TwistState for Twisted {
    const COUNTS: bool = true;

    #[inline(always)]
    fn get(self) -> Twisted {
        self
    }

    #[inline(always)]
    fn of(twisted: Twisted) -> Self {
        twisted
    }
}

/// Passes over what is kept of a twist.
pub(super) fn stored<T: TwistState>(
    twist: &mut T,
    fields: &mut impl Fields,
) -> Result<(), RangeError> {
    if T::COUNTS {
        let mut twisted = twist.get();
        fields.number("torque", &mut twisted.torque, RangeError::finite)?;
        fields.number("twist", &mut twisted.rate, RangeError::finite)?;
        fields.number("twist", &mut twisted.lead, RangeError::finite)?;
        *twist = T::of(twisted);
    }
    Ok(())
}

/// The twist during a step, clockwise as in the law.
pub(super) fn turned(meeting: &Meeting, dt: f64) -> f64 {
    -dot(meeting.twisting(), meeting.normal) * dt
}
