//! The heat of a substep in which one slip annulus spreads inwards.
//!
//! The inner radius c of the annulus moves inwards over the existing densities. For each c the
//! fraction t of the step follows from `sign (bh - T(c)) = B(c; al)`, where T is the twist of the
//! discs inside c. The heat is an integral over `w = +-ln al - ln c`, with the sign of the change
//! of radius: both radii change by less than w does, so that the integrand is smooth between the
//! ends of old segments for any length of the step.

use std::f64::consts::FRAC_2_PI;

use carom_special::quadrature::FixedRule;

use super::history::TwistHistory;
use super::segment::{Density, Segment};
use super::sliding::{
    DEEP, Sloped, heat_of_growth, heat_of_twist, mean_of_fourth_powers, twist_of_depth,
};

/// Number of Gauss nodes of a panel.
const NODES: usize = 8;
/// Gauss nodes and weights on (0, 1).
const GAUSS: [(f64, f64); NODES] = FixedRule::parts();
/// The greatest length of a panel in w.
const PANEL: f64 = 1.0;
/// Greatest number of panels of a step that are halved.
const HALVINGS: u32 = 60;
/// A panel is not halved if its estimated error, relative to sliding torque times step, is below
/// this.
const ACCURACY: f64 = 1e-13;
/// Relative accuracy of the contact radius at a given position of the edge.
const RADIUS_ACCURACY: f64 = 1e-11;
/// Iterations for the fraction of the step; the last of them are bisections.
const ITERATIONS: u32 = 80;
const NEWTON: u32 = 30;

/// A position of the edge of the slip annulus.
#[derive(Debug, Clone, Copy)]
struct Place {
    /// The fraction of the step.
    share: f64,
    /// `w = +-ln al - ln c`.
    at: f64,
}

/// Quantities at the moment when the edge passes a radius.
struct Passing {
    share: f64,
    radius: f64,
    depth: f64,
    /// `c (bF - sign b)`, the density that sliding adds there.
    added: f64,
    /// The derivative of `sign (bh - T) - B` with respect to the fraction of the step.
    slope: f64,
}

impl Passing {
    /// The derivative of the fraction of the step with respect to w; `None` if the edge does not
    /// move inwards.
    fn rate(&self) -> Option<f64> {
        (self.slope > 0.0).then(|| self.added.max(0.0) / self.slope)
    }
}

/// The position for which the edge is computed.
#[derive(Clone, Copy)]
enum Fixed {
    /// At a radius c.
    Edge(f64),
    /// At `exp(-w)`.
    SlipPath(f64),
}

/// A slip annulus that spreads inwards.
pub(super) struct Front<'a> {
    before: &'a TwistHistory,
    sign: f64,
    /// The radius at the end, and its change.
    end: f64,
    grown: f64,
    /// The change of twist, positive in the direction of slip.
    turned: f64,
    /// The sign of the change of radius, 1, 0 or -1.
    sense: f64,
    /// The sliding torque times the step.
    scale: f64,
    /// The number of panels that may still be halved.
    halvings: u32,
}

impl<'a> Front<'a> {
    /// The annulus of a step between two states, the second of which slips with this sign.
    pub(super) fn new(before: &'a TwistHistory, after: &TwistHistory, sign: f64) -> Self {
        let grown = after.radius - before.radius;
        let turned = sign * (after.twist - before.twist);
        let sense = if grown == 0.0 { 0.0 } else { grown.signum() };
        let scale = before.radius.max(after.radius).powi(4) * (grown.abs() + turned.abs());
        Self { before, sign, end: after.radius, grown, turned, sense, scale, halvings: HALVINGS }
    }

    /// The heat of the step while the edge moves from `start` to `end`; `None` if it does not move
    /// inwards.
    pub(super) fn heat(mut self, start: f64, end: f64) -> Option<f64> {
        if end > start {
            return None;
        }
        let mut from = Place { share: 0.0, at: self.way(0.0, start) };
        if self.depth(from) >= DEEP {
            return Some(self.slid(0.0));
        }
        let (mut sum, before) = (0.0, self.before);
        for segment in before.segments.iter().rev().filter(|segment| segment.from < start) {
            let last = segment.from <= end;
            let edge = if last { end } else { segment.from };
            let share = match last {
                true => 1.0,
                false => self.passing(segment, Fixed::Edge(edge), from.share, from.share)?.share,
            };
            let to = Place { share, at: self.way(share, edge) };
            if let Some(share) = self.over(segment, from, to, &mut sum)? {
                return Some(sum + self.slid(share));
            }
            if last {
                break;
            }
            from = to;
        }
        Some(sum)
    }

    fn radius(&self, share: f64) -> f64 {
        (1.0 - share) * self.before.radius + share * self.end
    }

    fn way(&self, share: f64, edge: f64) -> f64 {
        self.sense * libm::log(self.radius(share)) - libm::log(edge)
    }

    fn depth(&self, place: Place) -> f64 {
        place.at + (1.0 - self.sense) * libm::log(self.radius(place.share))
    }

    /// The heat of the rest of the step once the stick area is negligible.
    fn slid(&self, share: f64) -> f64 {
        let (a, b) = (self.radius(share), self.radius(1.0));
        let rate = heat_of_twist(DEEP) * self.turned - heat_of_growth(DEEP) * self.grown;
        (1.0 - share) * mean_of_fourth_powers(a, b) * rate.max(0.0)
    }

    /// Adds the heat over a segment. Returns the fraction of the step from which the stick area is
    /// negligible.
    fn over(
        &mut self,
        segment: &Segment,
        from: Place,
        to: Place,
        sum: &mut f64,
    ) -> Option<Option<f64>> {
        let panels = ((to.at - from.at) / PANEL).ceil().max(1.0);
        let mut low = from;
        for i in 1..=panels as u32 {
            let high = if f64::from(i) == panels {
                to
            } else {
                let at = from.at + f64::from(i) / panels * (to.at - from.at);
                let range = [low.share, to.share];
                let share = self.passing(segment, Fixed::SlipPath(at), range[0], range[0])?.share;
                Place { share: share.min(range[1]), at }
            };
            *sum += self.panel(segment, low, high)?;
            if self.depth(high) >= DEEP {
                return Some(Some(high.share));
            }
            low = high;
        }
        Some(None)
    }

    /// A panel by Gauss quadrature: the mean power of friction times the fraction of the step. It
    /// is halved if the last Legendre coefficients of the integrand are too large.
    fn panel(&mut self, segment: &Segment, low: Place, high: Place) -> Option<f64> {
        let length = high.at - low.at;
        let mut heats = [0.0; NODES];
        let (mut heat, mut passed) = (0.0, 0.0);
        let (mut guess, mut at) = (low.share, low.at);
        for (place, (node, weight)) in heats.iter_mut().zip(GAUSS) {
            let next = low.at + node * length;
            let passing = self.passing(segment, Fixed::SlipPath(next), low.share, guess)?;
            let rate = passing.rate()?;
            *place = self.power(&passing) * rate;
            heat += weight * *place;
            passed += weight * rate;
            guess = (passing.share + rate * (next - at)).min(1.0);
            at = next;
        }
        if heat == 0.0 || !heat.is_finite() {
            return heat.is_finite().then_some(0.0);
        }
        let sum = heat / passed * (high.share - low.share);
        // The error of the Gauss rule is smaller than these terms by the same factor as they are
        // smaller than the first.
        let terms = LAST_TERMS.map(|term| {
            heats.iter().zip(term).map(|(heat, weight)| weight * heat).sum::<f64>().abs()
        });
        let rest = ((terms[0] + terms[1]) / heat).min(1.0);
        if sum * rest * rest <= ACCURACY * self.scale || self.halvings == 0 {
            return Some(sum);
        }
        self.halvings -= 1;
        let at = 0.5 * (low.at + high.at);
        let middle = self.passing(segment, Fixed::SlipPath(at), low.share, low.share)?.share;
        let middle = Place { share: middle.min(high.share), at };
        let one = self.panel(segment, low, middle)?;
        Some(one + self.panel(segment, middle, high)?)
    }

    /// The heat per fraction of the step.
    fn power(&self, &Passing { radius, depth, .. }: &Passing) -> f64 {
        let power = heat_of_twist(depth) * self.turned - heat_of_growth(depth) * self.grown;
        let square = radius * radius;
        // Negative by rounding only.
        square * square * power.max(0.0)
    }

    /// The fraction of the step, at least `lowest`, at which the edge passes a position in a
    /// segment.
    fn passing(&self, segment: &Segment, place: Fixed, lowest: f64, guess: f64) -> Option<Passing> {
        // `exp(-w)` or the radius itself.
        let held = match place {
            Fixed::Edge(edge) => edge,
            Fixed::SlipPath(at) => libm::exp(-at),
        };
        let (mut low, mut high, mut share) = (lowest, 1.0 + f64::EPSILON, guess);
        for iteration in 0..ITERATIONS {
            let (passing, lacks) = self.deficit_at(segment, place, held, share);
            let step = -lacks / passing.slope;
            if (step * self.grown).abs() <= RADIUS_ACCURACY * passing.radius {
                return Some(Passing { share: (share + step).clamp(lowest, 1.0), ..passing });
            }
            if lacks < 0.0 {
                low = share
            } else {
                high = share
            }
            let next = share + step;
            let newton = next > low && (next < high || high > 1.0) && iteration < NEWTON;
            let next = if newton { next.min(1.0) } else { 0.5 * (low + high) };
            if next == share || high - low <= f64::EPSILON {
                return Some(passing);
            }
            share = next;
        }
        None
    }

    /// The deficit of the twist of the discs inside a position, `sign (bh - T) - B`, at a fraction
    /// of the step.
    fn deficit_at(&self, segment: &Segment, place: Fixed, held: f64, share: f64) -> (Passing, f64) {
        let radius = self.radius(share);
        let (edge, depth, drawn) = match place {
            Fixed::Edge(edge) => (edge, libm::log(radius / edge), 0.0),
            Fixed::SlipPath(at) => {
                let edge = match self.sense {
                    1.0 => held * radius,
                    -1.0 => held / radius,
                    _ => held,
                };
                (edge, self.depth(Place { share, at }), self.grown.abs() / radius)
            }
        };
        let depth = depth.max(0.0);
        let Sloped { value, slope } = twist_of_depth(depth);
        let below = match segment.density() {
            Density::Stick(density) => Sloped {
                value: segment.twist + density * (edge - segment.from),
                slope: density * edge,
            },
            Density::Slip { sign, radius: before } => {
                let laid = twist_of_depth((depth + libm::log(before / radius)).max(0.0));
                let scale = sign * FRAC_2_PI * before;
                Sloped { value: segment.twist - scale * laid.value, slope: scale * laid.slope }
            }
        };
        let twist = self.sign * (self.before.twist - below.value) + self.turned * share;
        let added = FRAC_2_PI * radius * slope - self.sign * below.slope;
        let slope = self.turned - self.grown * FRAC_2_PI * (value + slope) + drawn * added;
        (Passing { share, radius, depth, added, slope }, twist - FRAC_2_PI * radius * value)
    }
}

/// Gauss weights times `(2 k + 1) P_k`, k = 6 and 7: the sum with a function gives its coefficient
/// of that Legendre polynomial.
const LAST_TERMS: [[f64; NODES]; 2] = last_terms();

const fn last_terms() -> [[f64; NODES]; 2] {
    let mut terms = [[0.0; NODES]; 2];
    let mut i = 0;
    while i < NODES {
        let (node, weight) = GAUSS[i];
        let x = 2.0 * node - 1.0;
        let (mut before, mut this) = (1.0, x);
        let mut k = 1;
        while k + 1 < NODES {
            let n = k as f64;
            (before, this) = (this, ((2.0 * n + 1.0) * x * this - n * before) / (n + 1.0));
            k += 1;
        }
        let n = k as f64;
        terms[0][i] = weight * (2.0 * n - 1.0) * before;
        terms[1][i] = weight * (2.0 * n + 1.0) * this;
        i += 1;
    }
    terms
}
