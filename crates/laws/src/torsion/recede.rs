//! Which steps are known to slip in one ring, and how a step is divided until its parts are.

use carom_special::RangeError;

use super::heat::Meter;
use super::history::{TwistHistory, Way};
use super::sliding::{sliding_limit, sliding_twist, threshold};

/// [`threshold`] stays below this.
const GREATEST_THRESHOLD: f64 = 1.103;

/// The rate of twist by growth up to which new area adheres: 1, and rounding.
const ADHESION: f64 = 1.0 + 1e-12;

/// The greatest part of the radius that a part of a step gains or loses where one slip ring is not
/// known to be all.
const PART: f64 = 1.0 / 40.0;

/// How often such a part is halved where rings do not settle; none did in 6000 random paths.
const HALVINGS: u32 = 10;

impl TwistHistory {
    /// Goes straight to a new radius and twist.
    ///
    /// # Errors
    /// [`RangeError`] if rings do not settle however small the part; nothing has moved then.
    pub(super) fn travel(
        &mut self,
        radius: f64,
        twist: f64,
        meter: &mut impl Meter,
    ) -> Result<(), RangeError> {
        let mut start = None;
        let mut apart = false;
        while radius != self.radius || twist != self.twist {
            if self.is_sure(radius, twist, meter) {
                break;
            }
            start.get_or_insert_with(|| self.clone());
            let Some(rings) = self.go_a_part(radius, twist, meter) else {
                *self = start.unwrap_or_default();
                return RangeError::check("twist", twist, false, "where rings settle").map(|_| ());
            };
            apart |= rings;
        }
        self.ring_steps = self.ring_steps.saturating_add(u32::from(apart));
        Ok(())
    }

    /// Goes the next part of a step, the smaller the harder it is; whether rings lay apart.
    fn go_a_part(&mut self, radius: f64, twist: f64, meter: &mut impl Meter) -> Option<bool> {
        let [mut radius, mut twist] = self.part_of(radius, twist);
        for _ in 0..HALVINGS {
            if self.is_sure(radius, twist, meter) {
                return Some(false);
            }
            if let Some(rings) = self.tried(radius, twist, meter) {
                return Some(rings);
            }
            radius = 0.5 * (self.radius + radius);
            twist = 0.5 * (self.twist + twist);
        }
        None
    }

    /// Takes a step that is known to slip in one ring; whether it is.
    fn is_sure(&mut self, radius: f64, twist: f64, meter: &mut impl Meter) -> bool {
        let (grown, turned) = (radius - self.radius, twist - self.twist);
        if grown > 0.0 && turned.abs() <= ADHESION * grown {
            self.metered(Way::Adhere, radius, twist, meter);
            return true;
        }
        if grown > 0.0 {
            let sure = self.demand() <= self.radius;
            if sure {
                self.grow(radius, twist, meter);
            }
            return sure;
        }
        let way = if grown < 0.0 {
            self.sure_way_back(radius, twist)
        } else {
            (self.demand() <= radius).then_some(Way::FromRim)
        };
        if let Some(way) = way {
            self.metered(way, radius, twist, meter);
        }
        way.is_some()
    }

    /// The way of a receding step with one slip ring.
    fn sure_way_back(&self, radius: f64, twist: f64) -> Option<Way> {
        let Some(sign) = self.slip_sign() else {
            let short = radius >= self.next_rim();
            return (short && self.demand() <= radius).then_some(Way::FromRim);
        };
        // What lies below the slip ring stays within friction.
        let below = self.segments.len().checked_sub(2).map_or(0.0, |i| self.segments[i].demand);
        if below > radius {
            return None;
        }
        let back = -sign * (twist - self.twist) / (self.radius - radius);
        if back < GREATEST_THRESHOLD {
            let sure = back <= lowest_rate(back, self.stick / self.radius)
                && self.goes_on_slipping(radius, twist, sign)
                && (back <= 1.0 || {
                    let mut after = self.clone();
                    after.follow(Way::Inward(sign), radius, twist);
                    back <= lowest_rate(back, after.stick / radius)
                });
            return sure.then_some(Way::Inward(sign));
        }
        // Were all to stick, traction would fall as back * rho/sqrt(al^2 - rho^2) and its limit as
        // al/sqrt(al^2 - rho^2): only within al/back the ring would go on slipping.
        let sticks = back * self.stick >= self.radius && radius >= self.stick;
        sticks.then_some(Way::FromRim)
    }

    /// Whether the ring of the present sign has twist left to slip inwards.
    pub(super) fn goes_on_slipping(&self, radius: f64, twist: f64, sign: f64) -> bool {
        let highest = radius.min(self.stick);
        sign * (twist - self.twist_below(highest)) > sliding_twist(highest, radius)
    }

    /// The end of the part of a step in which the radius changes little.
    fn part_of(&self, radius: f64, twist: f64) -> [f64; 2] {
        let next = if radius > self.radius { self.radius * (1.0 + PART) } else { self.next_rim() };
        let whole = if radius > self.radius { radius <= next } else { radius >= next };
        if whole || self.radius == 0.0 {
            return [radius, twist];
        }
        let part = (next - self.radius) / (radius - self.radius);
        [next, self.twist + part * (twist - self.twist)]
    }

    /// How far a step may recede at once: not past the segment at the rim.
    fn next_rim(&self) -> f64 {
        let least = (1.0 - PART) * self.radius;
        match self.segments.last() {
            Some(last) if self.slip_sign().is_none() && last.from < self.radius => {
                least.max(last.from)
            }
            _ => least,
        }
    }

    /// Follows a way and has it metered.
    pub(super) fn metered<M: Meter>(&mut self, way: Way, radius: f64, twist: f64, meter: &mut M) {
        let before = M::LOOKS.then(|| self.clone());
        self.follow(way, radius, twist);
        if let Some(before) = before {
            meter.follows(&before, self, way);
        }
    }

    /// Whether torque and rim of a solution stay within friction.
    pub(super) fn is_admissible(&self) -> bool {
        let rim = self.segments.last().map_or(0.0, |last| last.density.at(self.radius));
        let sticks = self.stick >= self.radius;
        self.torque.abs() <= sliding_limit(self.radius) && !(sticks && rim.abs() > 1.0)
    }
}

/// The rate of back-twist above which a ring may change its sign, for comparison with `back`.
pub(super) fn lowest_rate(back: f64, stick: f64) -> f64 {
    if back > 1.0 && back < GREATEST_THRESHOLD { threshold(stick) } else { 1.0 }
}
