//! The friction heat of a step in one direction, in closed form.
//!
//! The anchor W of the spring at depth s lies between the fronts `X - (zeta - s)` and `X + (zeta -
//! s)`. On a straight step a front moves at a constant rate. If it moves inwards, it reaches the
//! anchor once it has closed the gap, and drags it along until the step ends or the edge passes the
//! spring. No spring is reached by both fronts: if both move inwards they meet at the edge. Slip
//! and mean traction of a spring are therefore linear in s on every segment, and the heat, the
//! integral of their product over the springs, is exact.

use super::energy::Path;
use super::{Lateral, Memory, VertexStack};
use crate::profile::NormalProfile;

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Memory<V, S, P> {
    /// The friction heat of a straight step in one direction.
    pub(super) fn heat_in_line(&self, path: &Path<V>) -> f64 {
        let dx = path.dx.components()[0];
        [1.0, -1.0]
            .map(|sign| Front {
                sign,
                advance: sign * dx - path.dz,
                from: path.zeta,
                to: path.end,
                growth: path.dz,
            })
            .iter()
            .filter(|front| front.advance > 0.0)
            .map(|front| self.heat_of_front(front))
            .sum()
    }

    fn heat_of_front(&self, front: &Front) -> f64 {
        let mut heat = front.on_new_springs(&self.profile);
        let (mut end, mut gap) = (front.from, 0.0);
        for i in (0..self.stack.len()).rev() {
            let base = self.stack.get(i);
            let opening = (1.0 - front.sign * base.slope.components()[0]).max(0.0);
            heat += front.on_segment(&self.profile, [base.depth, end], gap, opening);
            gap += (end - base.depth) * opening;
            end = base.depth;
            if end < front.to && gap >= front.advance {
                return heat; // what lies deeper is inside the cone to the end
            }
        }
        heat + self.profile.stiffness(0.0) * front.on_flat_end(gap)
    }
}

/// A face of the friction cone that moves inwards; the tractions there have its sign.
struct Front {
    sign: f64,
    /// The distance that it moves, sign dX - dzeta.
    advance: f64,
    from: f64,
    to: f64,
    growth: f64,
}

/// The slip of a spring and its mean traction.
#[derive(Clone, Copy)]
struct Slip {
    depth: f64,
    slip: f64,
    traction: f64,
}

impl Front {
    /// Springs that come into contact during the step slip from the start.
    fn on_new_springs<P: NormalProfile>(&self, profile: &P) -> f64 {
        if self.growth <= 0.0 {
            return 0.0;
        }
        let ends = ([0.5 * self.growth, 0.0], [self.advance, 0.0]);
        profile.spring_product(self.from, self.to, ends.0, ends.1).max(0.0)
    }

    /// The springs of a segment, on which the gap increases downwards from its upper end.
    fn on_segment<P: NormalProfile>(
        &self,
        profile: &P,
        [base, end]: [f64; 2],
        gap: f64,
        opening: f64,
    ) -> f64 {
        let gap_at = |depth: f64| gap + (end - depth) * opening;
        let mut heat = 0.0;
        if end > self.to {
            let low = base.max(self.to);
            heat += Slip::heat(profile, self.passed(low, gap_at(low)), self.passed(end, gap));
        }
        if base < self.to {
            let high = end.min(self.to);
            let ends = (self.kept(base, gap_at(base)), self.kept(high, gap_at(high)));
            heat += Slip::heat(profile, ends.0, ends.1);
        }
        heat
    }

    /// A spring that is in contact until the end of the step.
    fn kept(&self, depth: f64, gap: f64) -> Slip {
        let slip = self.advance - gap;
        let traction = (self.to - depth) - 0.5 * self.growth * (slip / self.advance);
        Slip { depth, slip, traction }
    }

    /// A spring that leaves the contact during the step.
    fn passed(&self, depth: f64, gap: f64) -> Slip {
        let slip = self.advance * ((self.from - depth) / -self.growth) - gap;
        Slip { depth, slip, traction: 0.5 * -self.growth * (slip / self.advance) }
    }

    /// The springs at depth zero, with unit total stiffness.
    fn on_flat_end(&self, gap: f64) -> f64 {
        let end = if self.to > 0.0 { self.kept(0.0, gap) } else { self.passed(0.0, gap) };
        if end.slip > 0.0 { end.slip * end.traction } else { 0.0 }
    }
}

impl Slip {
    /// The heat of the slipping springs between two depths.
    fn heat<P: NormalProfile>(profile: &P, low: Self, high: Self) -> f64 {
        if low.slip.max(high.slip) <= 0.0 {
            return 0.0;
        }
        let low = if low.slip < 0.0 { high.first_towards(low) } else { low };
        let high = if high.slip < 0.0 { low.first_towards(high) } else { high };
        let (traction, slip) = ([low.traction, high.traction], [low.slip, high.slip]);
        profile.spring_product(low.depth, high.depth, traction, slip).max(0.0)
    }

    /// The last spring that slips, between one that slips and one that does not.
    fn first_towards(self, other: Self) -> Self {
        let part = self.slip / (self.slip - other.slip);
        let mix = |a: f64, b: f64| a + part * (b - a);
        Self {
            depth: mix(self.depth, other.depth),
            slip: 0.0,
            traction: mix(self.traction, other.traction).max(0.0),
        }
    }
}
