//! A contact that recedes while it slips: when its ring keeps its sign, when two rings form.

use super::history::TwistHistory;
use super::rings::Rings;
use super::segment::{Density, Segment};
use super::sliding::{sliding_limit, sliding_twist, threshold};

/// [`threshold`] stays below this.
const GREATEST_THRESHOLD: f64 = 1.103;

/// From this rate of back-twist on the inner ring, within a quarter of the radius, changes the
/// torque by less than rings do by their width: up to 1.1e-4 of that of sliding.
const GREATEST_RATE: f64 = 4.0;

/// Parts of a step in which the radius halves.
const PARTS: f64 = 30.0;

/// Rings reach at least to this part of the radius down to which slip went before, and are not
/// asked to go below [`LOWEST`] of the contact radius.
const MARGIN: f64 = 0.8;
const LOWEST: f64 = 1e-3;

/// The inner one of two slip rings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct InnerRing {
    /// Its inner radius and the sign of its slip.
    radius: f64,
    sign: f64,
    /// The level of the rings that found it.
    level: usize,
}

impl TwistHistory {
    /// A receding step, unless it is a simple one of a new slip ring from the rim inwards.
    pub(super) fn recede(&mut self, radius: f64, twist: f64) -> bool {
        let rate = |sign: f64| -sign * (twist - self.twist) / (self.radius - radius);
        if let Some(inner) = self.inner_ring {
            return rate(inner.sign) < GREATEST_RATE && self.by_rings(radius, twist, inner.radius);
        }
        let Some(sign) = self.slip_sign() else { return false };
        let back = rate(sign);
        if back <= lowest_rate(back, self.stick / self.radius) {
            return self.recede_slipping(radius, twist, sign, back);
        }
        // Were all to stick, traction would fall as back * rho/sqrt(al^2 - rho^2) and its limit as
        // al/sqrt(al^2 - rho^2): within al/back the ring goes on slipping.
        let apart = back < GREATEST_RATE && back * self.stick < self.radius;
        apart && self.by_rings(radius, twist, self.stick)
    }

    /// A receding step at a rate of back-twist at which the slip ring keeps its sign, at least to
    /// begin with.
    fn recede_slipping(&mut self, radius: f64, twist: f64, sign: f64, back: f64) -> bool {
        let before = (back > 1.0).then(|| self.clone());
        if !self.goes_on_slipping(radius, twist, sign) {
            return false;
        }
        if let Some(mut before) = before.filter(|_| back > lowest_rate(back, self.stick / radius))
            && before.by_rings(radius, twist, before.stick)
        {
            *self = before;
        }
        true
    }

    /// Puts the sliding density of the present sign below the present stick radius. A long step
    /// may lose the slip ring itself; then nothing is done, and what lies below decides.
    fn goes_on_slipping(&mut self, radius: f64, twist: f64, sign: f64) -> bool {
        let highest = radius.min(self.stick);
        let excess = sign * (twist - self.twist_below(highest)) - sliding_twist(highest, radius);
        if excess > 0.0 {
            self.cut(radius, twist, sign, highest);
        }
        excess > 0.0
    }

    /// Whether torque and rim of a solution at the given radius stay within friction.
    pub(super) fn is_admissible(&self, radius: f64) -> bool {
        let rim = self.segments.last().map_or(0.0, |last| last.density.at(radius));
        let sticks = self.stick >= radius;
        self.torque.abs() <= sliding_limit(radius) && !(sticks && rim.abs() > 1.0)
    }

    /// The sign of the outermost slip ring, if the contact slips there.
    fn slip_sign(&self) -> Option<f64> {
        match self.segments.last()?.density {
            Density::Slip { sign, radius } if radius == self.radius => Some(sign),
            _ => None,
        }
    }

    /// Solves a receding step with rings of any pattern of slip, which reaches down to about
    /// `inner`. Whether it converged.
    pub(super) fn by_rings(&mut self, radius: f64, twist: f64, inner: f64) -> bool {
        let parts = ((self.radius - radius) / radius * PARTS).ceil().clamp(1.0, 4.0 * PARTS);
        let (from_radius, from_twist) = (self.radius, self.twist);
        let mut next = self.clone();
        let mut inner = inner;
        let mut apart = false;
        for part in 1..=parts as usize {
            let t = part as f64 / parts;
            let radius = from_radius + t * (radius - from_radius);
            let twist = from_twist + t * (twist - from_twist);
            let Some(reach) = next.part_by_rings(radius, twist, inner) else { return false };
            inner = reach;
            apart |= next.inner_ring.is_some();
        }
        next.ring_steps = next.ring_steps.saturating_add(u32::from(apart));
        *self = next;
        true
    }

    /// One part of a receding step. The radius down to which slip went.
    fn part_by_rings(&mut self, radius: f64, twist: f64, inner: f64) -> Option<f64> {
        let mut lowest = MARGIN * inner.min(radius);
        loop {
            let level = self.inner_ring.map_or(self.level, |ring| ring.level);
            let rings = Rings::new(radius, lowest, level);
            let before = Cells::averaged(rings.edges(), |s| self.twist_below(s));
            let solution = rings.turn(&before.densities, twist - before.below[0])?;
            let slips = &solution.slips;
            let innermost = slips.iter().rposition(|slip| *slip != 0.0);
            if innermost.is_some_and(|i| i + 3 > slips.len()) && lowest > LOWEST * radius {
                lowest *= 0.5;
                continue;
            }
            // A second ring slips somewhere inside the first stick area.
            let stick = slips.iter().position(|slip| *slip != slips[0] || *slip == 0.0);
            let ring = stick.and_then(|i| innermost.filter(|&j| j > i));
            if ring.is_none()
                && let Some(next) = self.with_one_ring(radius, twist, slips[0])
            {
                *self = next;
                return Some(self.stick);
            }
            self.lay(&before, &solution.changes, rings.edges());
            (self.radius, self.twist) = (radius, twist);
            self.stick = stick.map_or(0.0, |i| rings.edges()[i]);
            let (inner, sign) =
                innermost.map_or((self.stick, 0.0), |i| (rings.edges()[i + 1], slips[i]));
            self.inner_ring = Some(InnerRing { radius: inner, sign, level: rings.level() });
            return Some(inner);
        }
    }

    /// The stack's own solution, exact where one ring slips from the rim inwards; None where it
    /// breaks the friction law, as it may when old rings have come to the rim.
    fn with_one_ring(&self, radius: f64, twist: f64, slip: f64) -> Option<Self> {
        let mut next = self.clone();
        let same = next.slip_sign().filter(|sign| *sign == slip);
        if !same.is_some_and(|sign| next.goes_on_slipping(radius, twist, sign)) {
            let rest = twist - next.twist_below(radius);
            next.cut(radius, twist, 1.0_f64.copysign(rest), radius);
        }
        (next.radius, next.twist) = (radius, twist);
        next.is_admissible(radius).then_some(next)
    }

    /// Puts new densities on the rings.
    fn lay(&mut self, before: &Cells, changes: &[f64], edges: &[f64]) {
        let lowest = changes.len();
        let (mut twist, mut torque) = (before.below[lowest], self.torque_below(edges[lowest]));
        self.truncate(edges[lowest]);
        for i in (0..lowest).rev() {
            let density = Density::Stick(before.densities[i] + changes[i]);
            let segment = Segment { from: edges[i + 1], density, twist, torque };
            (twist, torque) = (segment.twist_to(edges[i]), segment.torque_to(edges[i]));
            self.segments.push(segment);
        }
        self.torque = torque;
    }
}

/// The rate of back-twist above which a ring may change its sign, for comparison with `back`.
fn lowest_rate(back: f64, stick: f64) -> f64 {
    if back > 1.0 && back < GREATEST_THRESHOLD { threshold(stick) } else { 1.0 }
}

/// Densities averaged over rings, and the twist of all discs below their edges.
struct Cells {
    below: Vec<f64>,
    densities: Vec<f64>,
}

impl Cells {
    fn averaged(edges: &[f64], twist_below: impl Fn(f64) -> f64) -> Self {
        let below: Vec<f64> = edges.iter().map(|&s| twist_below(s)).collect();
        let slope = |(s, t): (&[f64], &[f64])| (t[0] - t[1]) / (s[0] - s[1]);
        let densities = edges.windows(2).zip(below.windows(2)).map(slope).collect();
        Self { below, densities }
    }
}
