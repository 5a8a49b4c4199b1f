//! Steps between contact radii that differ by orders of magnitude.
//!
//! Where slip annuli may be disjoint a step is divided, in proportion to the radius: without end if one of both radii may
//! be as small as numbers are. But the sliding torque decreases with the fourth power of the radius, and the energy with
//! the fifth. What the smaller contact remembers is then below all that is known of the torque of the larger one.

use carom_special::RangeError;

use super::heat::Meter;
use super::history::TwistHistory;

/// A contact smaller than this fraction of the one at the other end of a step that must be divided has no history: its
/// sliding torque is below 1e-24 of that of the other.
const FORGOTTEN: f64 = 1e-6;

impl TwistHistory {
    /// Advances on a straight path to a new radius and twist, both radii of any size.
    ///
    /// # Errors
    /// As [`TwistHistory::travel`].
    pub(super) fn travel_far(
        &mut self,
        radius: f64,
        twist: f64,
        meter: &mut impl Meter,
    ) -> Result<(), RangeError> {
        let is_far = radius < FORGOTTEN * self.radius || self.radius < FORGOTTEN * radius;
        if !is_far || self.radius == 0.0 {
            return self.travel(radius, twist, meter);
        }
        if self.try_single_annulus(radius, twist, meter) {
            return Ok(());
        }
        let start = self.clone();
        let gone = self.travel_through_far(radius, twist, meter);
        if gone.is_err() {
            *self = start;
        }
        gone
    }

    /// A step between radii that are far apart, which must be divided.
    fn travel_through_far(
        &mut self,
        radius: f64,
        twist: f64,
        meter: &mut impl Meter,
    ) -> Result<(), RangeError> {
        let rate = (twist - self.twist) / (radius - self.radius);
        if radius > self.radius {
            meter.forgets(self);
            self.separate(self.twist - rate * self.radius);
        } else {
            let near = FORGOTTEN * self.radius;
            self.travel(near, self.twist + rate * (near - self.radius), meter)?;
            meter.forgets(self);
            self.separate(twist);
        }
        self.travel(radius, twist, meter)
    }
}
