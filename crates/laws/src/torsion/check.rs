//! Checks whether numbers from outside are a valid state of a twist.

use carom_special::RangeError;

use super::history::{TwistHistory, sliding_limit};
use super::segment::Density;

impl TwistHistory {
    /// The torque is at most that of sliding, each piece ends where the next one begins, and no
    /// slip lies outside the contact that slid.
    ///
    /// Twists and inner torques of adjacent pieces may differ: once the whole contact slides, the
    /// stick radius is the smallest positive number whatever the twist is, and pieces that were
    /// joined because the storage was full keep their twist but not their torque.
    #[inline]
    pub(super) fn check_meaning(&self) -> Result<(), RangeError> {
        let holds = self.torque.abs() <= sliding_limit(self.radius);
        RangeError::check("torque", self.torque, holds, "at most the sliding torque")?;
        let mut end = self.radius;
        for segment in self.segments.iter().rev() {
            if let Density::Slip { radius, .. } = segment.density() {
                let holds = radius >= end;
                let allowed = "at least the outer radius of its piece";
                RangeError::check("slip radius", radius, holds, allowed)?;
            }
            RangeError::non_negative("demand", segment.demand)?;
            end = segment.from;
        }
        Ok(())
    }
}
