//! Whether numbers from outside can be what a twist remembers.

use carom_special::RangeError;

use super::history::{TwistHistory, sliding_limit};
use super::segment::Density;

impl TwistHistory {
    /// The torque is within that of sliding; each piece ends where the next one begins; no slip lies outside
    /// the contact that slid.
    ///
    /// Twists and inner torques of the pieces need not meet. Once all slides, the stick radius is the least
    /// number above zero, whatever twist it left; pieces that were joined for want of room keep their twist
    /// and not their torque.
    pub(super) fn check_meaning(&self) -> Result<(), RangeError> {
        let holds = self.torque.abs() <= sliding_limit(self.radius);
        RangeError::check("torque", self.torque, holds, "within that of sliding")?;
        for (i, segment) in self.segments.iter().enumerate() {
            let end = self.segments.get(i + 1).map_or(self.radius, |next| next.from);
            if let Density::Slip { radius, .. } = segment.density {
                RangeError::check("slip radius", radius, radius >= end, "not inside its piece")?;
            }
            RangeError::non_negative("demand", segment.demand)?;
        }
        Ok(())
    }
}
