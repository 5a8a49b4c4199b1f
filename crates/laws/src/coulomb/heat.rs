//! The heat of one ring on a straight step.

use super::drag::{Step, cross};
use crate::memory::Lateral;
use crate::profile::GAUSS;

/// Below this logarithm of `tan(theta/2)` the slip is along the step to round-off.
const ALIGNED: f64 = -18.0;
/// The widest panel of a quadrature over that logarithm.
const PANEL: f64 = 1.5;

/// Panels over a limit that shrinks, and how much each shrinks.
const STEEP_PANELS: u32 = 8;
const SHRINK: f64 = 0.2;

/// The energies that a unit of heat is, along the step and across it.
struct Units<V> {
    unit: V,
    ahead: V,
}

impl<V: Lateral> Units<V> {
    /// The energy per normalised heat of a ring whose traction has these direction cosines.
    fn of(&self, cos: f64, sin: f64) -> f64 {
        let ([x, y], [u, v]) = (self.ahead.components(), self.unit.components());
        let (along_x, along_y) = (cos * x - sin * y, cos * y + sin * x);
        u * along_x * along_x + v * along_y * along_y
    }
}

impl<V: Lateral> Step<V> {
    /// What a ring turns into heat: the integral of traction times slip, which is parallel to it,
    /// `int r (cos theta - dr/dl) dl`, r the limit and l the way. A ring that touches on the way
    /// begins there; one that parts ends there.
    pub(super) fn heat(&self, depth: f64, anchor: V, unit: V) -> f64 {
        let limit = self.zeta - depth;
        let start = limit - self.dz;
        if limit < 0.0 {
            let part = start / -self.dz;
            let before = self.shift.minus(self.ahead.times(self.length));
            let until = before.plus(self.ahead.times(part * self.length));
            return Self::new((self.zeta - self.dz, before), (depth, until))
                .heat(depth, anchor, unit);
        }
        let stretch = self.shift.minus(anchor);
        let square = stretch.dot(stretch);
        if square <= limit * limit {
            return 0.0;
        }
        let units = Units { unit, ahead: self.ahead };
        if self.length == 0.0 {
            let direction = Units { unit, ahead: stretch.times(1.0 / square.sqrt()) };
            return 0.5 * (square - limit * limit) * direction.of(1.0, 0.0);
        }
        let (along, across) = (stretch.dot(self.ahead), cross(self.ahead, stretch));
        let met = self.met(along, across, limit);
        let rest = met.rest;
        if rest <= 0.0 {
            return 0.0;
        }
        let straight = |way: f64, mean: f64, cos: f64| {
            (way * mean * (cos - self.slope) * units.of(cos, 0.0)).max(0.0)
        };
        let Some(tangent) = met.tangent else {
            let cos = if met.at < 0.0 { -1.0 } else { 1.0 };
            return straight(rest, 0.5 * (met.limit + limit), cos);
        };
        if self.slope <= -1.0 {
            return self.steep_heat(tangent, [limit, met.limit], &units);
        }
        // In x = log tan(theta/2): dx = -dl/r, r = r_0 exp(slope (x_0 - x)).
        let first = libm::log(tangent.abs());
        let fall = rest * super::drag::pull(met.limit, limit);
        let last = (first - fall).max(ALIGNED.min(first));
        let limit_at = |x: f64| met.limit * libm::exp(self.slope * (first - x));
        let rate = |x: f64| {
            let (tangent, limit) = (libm::exp(x).copysign(tangent), limit_at(x));
            let scale = 1.0 / (1.0 + tangent * tangent);
            let cos = (1.0 - tangent) * (1.0 + tangent) * scale;
            limit * limit * (cos - self.slope).max(0.0) * units.of(cos, 2.0 * tangent * scale)
        };
        let panels = ((first - last) / PANEL).ceil().max(1.0);
        let width = (first - last) / panels;
        let mut sum = 0.0;
        for panel in 0..panels as usize {
            let from = last + panel as f64 * width;
            sum += GAUSS.iter().map(|(x, w)| w * rate(from + x * width)).sum::<f64>() * width;
        }
        let aligned = limit_at(last);
        let way = if self.slope == 0.0 {
            rest - met.limit * (first - last)
        } else {
            rest - (aligned - met.limit) / self.slope
        };
        sum + straight(way.max(0.0), 0.5 * (aligned + limit), 1.0)
    }

    /// The same where the limit shrinks faster than the shift moves: over the limit r, in panels
    /// that shrink with it, `tan(theta/2) ~ r^(-1/slope)`.
    fn steep_heat(&self, tangent: f64, [last, first]: [f64; 2], units: &Units<V>) -> f64 {
        let rate = |limit: f64| {
            let tangent = tangent * libm::pow(limit / first, -1.0 / self.slope);
            let scale = 1.0 / (1.0 + tangent * tangent);
            let cos = (1.0 - tangent) * (1.0 + tangent) * scale;
            limit * (1.0 - cos / self.slope) * units.of(cos, 2.0 * tangent * scale)
        };
        let (mut high, mut sum) = (first, 0.0);
        for panel in 1..=STEEP_PANELS {
            let low = if panel == STEEP_PANELS { last } else { (SHRINK * high).max(last) };
            let width = high - low;
            sum += GAUSS.iter().map(|(x, w)| w * rate(low + x * width)).sum::<f64>() * width;
            high = low;
        }
        sum
    }
}
