//! A growing contact in closed form: in adhesion, or with a slip annulus.
//!
//! Twisted at the rate r > 1 relative to its edge, a growing contact slips in an annulus at its
//! edge. The inner radius c of the annulus first moves inwards over the existing densities, until
//! its depth satisfies `(2/pi) K(k) = r`, `k' = c/al`. Then it moves outwards with the contact at
//! this ratio and leaves the constant density `(2/pi) E(k)/k'` behind.

use super::heat::Meter;
use super::history::{SlipPath, TwistHistory};
use super::segment::{Density, Segment};
use super::sliding::sliding_torque;
use super::steady::SteadyAnnulus;

/// An annulus whose inner radius is this close to that of the steady annulus is replaced by it. The
/// error of twist and torque is the square of this, and rounding of the rate moves the radius by
/// less.
const STEADY_TOLERANCE: f64 = 1e-7;

impl TwistHistory {
    /// New area formed in complete adhesion.
    pub(super) fn adhere(&mut self, radius: f64, twist: f64) {
        let density = Density::Stick((twist - self.twist) / (radius - self.radius));
        let segment = Segment::new(self.radius, density, [self.twist, self.torque], 0.0);
        let same = self.segments.last().is_some_and(|last| last.density() == density);
        if !same {
            self.push(segment);
        }
        self.set_torque(segment.torque_to(radius), radius);
        self.stick = radius;
    }

    /// Growth with a slip annulus.
    pub(super) fn grow(&mut self, radius: f64, twist: f64, meter: &mut impl Meter) {
        let grown = radius - self.radius;
        let rate = (twist - self.twist) / grown;
        let sign = 1.0_f64.copysign(rate);
        let annulus = SteadyAnnulus::new(rate.abs());
        let ratio = annulus.ratio;
        let slips = self.radius == 0.0 || self.slip_sign() == Some(sign);
        let deeper = ratio == 0.0 || self.stick > (1.0 + STEADY_TOLERANCE) * ratio * self.radius;
        if !slips || deeper {
            let turn = self.turns_outward(radius, rate, annulus);
            let between = self.twist + rate * (turn - self.radius);
            if turn >= radius {
                return self.metered(SlipPath::FromRim, radius, twist, meter);
            }
            if turn > self.radius {
                self.metered(SlipPath::FromRim, turn, between, meter);
            }
        }
        self.metered(SlipPath::Outward { sign, annulus }, radius, twist, meter);
    }

    /// The inner radius of the slip annulus moves outwards with the contact.
    pub(super) fn move_outwards(
        &mut self,
        radius: f64,
        twist: f64,
        sign: f64,
        annulus: SteadyAnnulus,
    ) {
        let ratio = annulus.ratio;
        // No contact sticks at the centre alone, however deep it slips.
        let [start, end] = [self.radius, radius].map(|al| match al > 0.0 {
            true => (ratio * al).max(f64::MIN_POSITIVE),
            false => 0.0,
        });
        let density = Density::Stick(sign * annulus.density());
        let below = if self.radius == 0.0 { self.twist } else { self.twist_below(start) };
        let (twist_to, torque_to) = (below, self.torque_below(start));
        if self.radius == 0.0 {
            self.segments.truncate(0);
        }
        self.truncate(start);
        let laid = Segment::new(start, density, [twist_to, torque_to], radius);
        match self.segments.last().copied() {
            Some(last) if last.density() == density => {
                let demand = last.demand.max(radius);
                self.segments.replace(self.segments.len() - 1, Segment { demand, ..last });
            }
            _ => self.push(laid),
        }
        let torque = laid.torque_to(end) + sign * sliding_torque(end, radius);
        let density = Density::Slip { sign, radius };
        self.set_torque(torque, radius);
        self.stick = end;
        self.push(Segment::new(end, density, [twist, torque], radius));
    }
}
