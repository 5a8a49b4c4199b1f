//! Whether numbers from outside can be what a twist remembers.

use carom_special::RangeError;

use super::history::{TwistHistory, sliding_limit};
use super::segment::Density;

/// By how much twists may differ where two pieces meet, over what they are summed from: 1e-11 was seen.
const OFF: f64 = 1e-6;

/// How far the torque of an inner part of the contact may be above that of sliding of the whole: pieces that were
/// joined for want of room keep their twist, not their torque. 1.17 was seen.
const INSIDE: f64 = 3.0;

impl TwistHistory {
    /// The torque is within that of sliding; each piece ends where the next one begins, with its twist, the
    /// last one with that of the contact; no slip lies outside the contact that slid.
    pub(super) fn check_meaning(&self) -> Result<(), RangeError> {
        let limit = sliding_limit(self.radius);
        RangeError::check(
            "torque",
            self.torque,
            self.torque.abs() <= limit,
            "within that of sliding",
        )?;
        for (i, segment) in self.segments.iter().enumerate() {
            let next = self.segments.get(i + 1);
            let end = next.map_or(self.radius, |next| next.from);
            if let Density::Slip { radius, .. } = segment.density {
                RangeError::check("slip radius", radius, radius >= end, "not inside its piece")?;
            }
            RangeError::non_negative("demand", segment.demand)?;
            let [twist, torque] = [segment.twist_to(end), segment.torque_to(end)];
            let [on, carried] = next.map_or([self.twist, self.torque], |next| {
                [next.twist_to(end), next.torque_to(end)]
            });
            let size = self.radius + twist.abs() + segment.twist.abs();
            RangeError::check("twist", on, (on - twist).abs() <= OFF * size, "that of the pieces")?;
            let most = torque.abs().max(carried.abs());
            RangeError::check("torque", most, most <= INSIDE * limit, "near that of sliding")?;
        }
        Ok(())
    }
}
