//! The energy that slip turns into heat: traction times slip.
//!
//! A disc of radius s that is given the density db turns rings outside it against the surface by
//! `W(s/rho) db`. Where all slides outside s, the friction does the work
//! `P(s; al) db`, `P = (3/2) int_s^al rho^2 sqrt(al^2 - rho^2) W(s/rho) drho`, in the units of
//! [`super::history`]. With a slip ring of depth v = ln(al/c) a step therefore costs
//! `al^4 [p(v) sign dbh - g(v) dal]`, where p = P/al^4 and
//! `g = p(c) + int_c^al (dbF/dal) (p(c) - p(s)) ds`.

use carom_special::quadrature::FixedRule;
use carom_special::roots::bisect;

use super::grow::steady_rate;
use super::history::{TwistHistory, Way};
use super::rings::Rings;
use super::sliding::{heat_of_growth, heat_of_twist, sliding_twist};

/// Gauss's nodes and weights on (0, 1).
const GAUSS: [(f64, f64); 6] = FixedRule::parts();

/// Parts that a way is halved into at most, and the accuracy over the torque of sliding times the
/// step at which a part is left whole.
const PARTS: u32 = 150;
const ACCURACY: f64 = 3e-14;
/// Ends of parts that are halved each by itself: thin rings of steps before lie at the rim.
const START: [f64; 6] = [0.0, 1e-6, 1e-4, 3e-3, 0.06, 1.0];

/// Sees what a step does.
pub(super) trait Meter {
    /// A way from the state `before`.
    fn follows(&mut self, before: &TwistHistory, way: Way, radius: f64, twist: f64);
    /// A part solved by rings.
    fn slides(&mut self, heat: RingHeat<'_>);
}

/// Looks away.
pub(super) struct Unmetered;

impl Meter for Unmetered {
    fn follows(&mut self, _: &TwistHistory, _: Way, _: f64, _: f64) {}
    fn slides(&mut self, _: RingHeat<'_>) {}
}

/// Adds up the heat.
#[derive(Debug, Default)]
pub(super) struct Heat(pub(super) f64);

impl Meter for Heat {
    fn follows(&mut self, before: &TwistHistory, way: Way, radius: f64, twist: f64) {
        self.0 += match way {
            Way::Adhere => 0.0,
            Way::Outward { depth, .. } => {
                let fifth = |a: f64| a.powi(5) / 5.0;
                let rate = steady_rate(depth);
                (fifth(radius) - fifth(before.radius))
                    * (rate * heat_of_twist(depth) - heat_of_growth(depth))
            }
            Way::FromRim | Way::Inward(_) => Path { before, way, radius, twist }.heat(),
        };
    }

    fn slides(&mut self, heat: RingHeat<'_>) {
        self.0 += heat.sum();
    }
}

/// Rings that slip, and the contact radius from which they came.
pub(super) struct RingHeat<'a> {
    pub(super) rings: &'a Rings,
    pub(super) from: f64,
    pub(super) signs: &'a [f64],
    pub(super) slips: &'a [f64],
}

impl RingHeat<'_> {
    fn sum(&self) -> f64 {
        let (edges, middles) = (self.rings.edges(), self.rings.middles());
        let limit = |al: f64, rho: f64| ((al - rho) * (al + rho)).max(0.0).sqrt();
        (0..middles.len())
            .map(|i| {
                let rho = middles[i];
                let inner = if i + 1 == middles.len() { 0.0 } else { edges[i + 1] };
                // sqrt(al^2 - rho^2) falls to the rim within its ring.
                let area = |al: f64| {
                    let outer = edges[i].min(al);
                    if i == 0 {
                        let rest = (al - inner) * (al + inner);
                        return rho * rest * rest.max(0.0).sqrt() / 3.0;
                    }
                    limit(al, rho) * (outer.powi(3) - inner.powi(3)) / 3.0
                };
                let mean = 0.5 * (area(self.rings.radius()) + area(self.from));
                1.5 * mean * (self.signs[i] * self.slips[i]).max(0.0)
            })
            .sum()
    }
}

/// A way with one slip ring.
struct Path<'a> {
    before: &'a TwistHistory,
    way: Way,
    radius: f64,
    twist: f64,
}

impl Path<'_> {
    fn heat(&self) -> f64 {
        let (from, to) = (self.before, self.radius);
        let way = (self.twist - from.twist).abs() + (to - from.radius).abs();
        // A twist that is large beside the step is known to its rounding.
        let rounding = f64::EPSILON * self.twist.abs().max(from.twist.abs());
        let accuracy = from.radius.max(to).powi(4) * (ACCURACY * way + rounding);
        let mut left = PARTS;
        let part = |ends: &[f64]| {
            let whole = self.sum(ends[0], ends[1]);
            self.halve(ends[0], ends[1], whole, accuracy, &mut left)
        };
        self.ends().windows(2).map(part).sum()
    }

    /// Where the stick area passes an old one, from 0 to 1, and [`START`].
    fn ends(&self) -> Vec<f64> {
        let before = self.before;
        let (grown, turned) = (self.radius - before.radius, self.twist - before.twist);
        let mut ends = START.to_vec();
        for segment in &before.segments {
            let below = before.twist_below(segment.from);
            // What the twist of the discs up to there lacks when all slides outside.
            let excess = |sign: f64, t: f64| {
                let twist = before.twist + t * turned - below;
                sign * twist - sliding_twist(segment.from, before.radius + t * grown)
            };
            for sign in [1.0, -1.0] {
                let rises = excess(sign, 0.0) < 0.0;
                if segment.from == 0.0 || rises == (excess(sign, 1.0) < 0.0) {
                    continue;
                }
                let [_, passed] = bisect([0.0, 1.0], 50, |t| (excess(sign, t) < 0.0) == rises);
                ends.push(passed);
            }
        }
        ends.sort_by(f64::total_cmp);
        ends
    }

    /// By halves as long as that changes the sum: a stick area that passes an old one has a kink.
    fn halve(&self, low: f64, high: f64, whole: f64, accuracy: f64, left: &mut u32) -> f64 {
        let middle = 0.5 * (low + high);
        let halves = [self.sum(low, middle), self.sum(middle, high)];
        let sum = halves[0] + halves[1];
        if (sum - whole).abs() <= accuracy || *left == 0 {
            return sum;
        }
        *left -= 1;
        self.halve(low, middle, halves[0], accuracy, left)
            + self.halve(middle, high, halves[1], accuracy, left)
    }

    fn sum(&self, low: f64, high: f64) -> f64 {
        let part = high - low;
        GAUSS.iter().map(|(node, weight)| weight * part * self.rate(low + node * part)).sum()
    }

    /// Heat by the step's parameter from 0 to 1.
    fn rate(&self, t: f64) -> f64 {
        let (grown, turned) = (self.radius - self.before.radius, self.twist - self.before.twist);
        let mut at = self.before.clone();
        at.follow(self.way, at.radius + t * grown, at.twist + t * turned);
        let Some(sign) = at.slip_sign() else { return 0.0 };
        let depth = if at.stick > 0.0 { libm::log(at.radius / at.stick) } else { f64::INFINITY };
        let square = at.radius * at.radius;
        let rate = heat_of_twist(depth) * sign * turned - heat_of_growth(depth) * grown;
        square * square * rate.max(0.0) // below zero by rounding of the twist
    }
}
