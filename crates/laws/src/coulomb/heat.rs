//! Heat and work of one annulus in a straight step.

use super::drag::{LimitPoint, Step, cross, log_tangent_decrease, round_off_length};
use crate::memory::Lateral;
use crate::profile::GAUSS;

/// Below this log `tan(theta/2)` slip is parallel to the step to round-off.
const ALIGNED_LOG_TANGENT: f64 = -18.0;
/// Widest panel of the quadrature over log `tan(theta/2)`: the directions have poles at the
/// distance pi/2, so that eight points have an error of 1e-14.
const MAX_PANEL_WIDTH: f64 = 0.8;

/// Number of panels over a decreasing limit, and ratio of successive limits.
const STEEP_PANELS: u32 = 20;
const LIMIT_RATIO_OF_PANELS: f64 = 0.5;

/// The energy of a unit of heat for each direction of traction.
struct Units<V> {
    unit: V,
    ahead: V,
}

impl<V: Lateral> Units<V> {
    /// The energy per normalised heat of an annulus whose traction has these direction cosines.
    fn of(&self, cos: f64, sin: f64) -> f64 {
        let ([x, y], [u, v]) = (self.ahead.components(), self.unit.components());
        let (along_x, along_y) = (cos * x - sin * y, cos * y + sin * x);
        u * along_x * along_x + v * along_y * along_y
    }
}

/// Where an annulus begins to slip, and its limit at the end.
struct Slip {
    met: LimitPoint,
    limit: f64,
    across: f64,
    /// Energy beyond the limit if W was inaccurate; it is released at once.
    beyond: f64,
}

impl<V: Lateral> Step<V> {
    /// The heat of an annulus: the integral of traction times slip, which are parallel,
    /// `int r (cos theta - dr/dl) dl`, r the limit and l the path. It counts from first contact if
    /// the annulus comes into contact in the step, and up to separation if it separates.
    pub(super) fn heat(&self, depth: f64, anchor: V, unit: V) -> f64 {
        if self.zeta < depth {
            return self.until_separation(depth).heat(depth, anchor, unit);
        }
        if self.length == 0.0 {
            let (stretch, limit) = (self.shift.minus(anchor), self.zeta - depth);
            let square = stretch.dot(stretch);
            if square <= limit * limit {
                return 0.0;
            }
            let direction = Units { unit, ahead: stretch.times(1.0 / square.sqrt()) };
            return 0.5 * (square - limit * limit) * direction.of(1.0, 0.0);
        }
        if self.grazes(depth, anchor) {
            let (settled, before) =
                (self.settled(depth, anchor), self.shift.minus(self.ahead.times(self.length)));
            let [from, to] = [anchor, settled].map(|anchor| before.minus(anchor));
            let direction = Units { unit, ahead: from.times(1.0 / from.length()) };
            let snap = 0.5 * (from.dot(from) - to.dot(to)).max(0.0);
            return snap * direction.of(1.0, 0.0) + self.slip_heat(depth, settled, unit);
        }
        self.slip_heat(depth, anchor, unit)
    }

    /// The heat of an annulus that is in contact at the end and was within its limit.
    fn slip_heat(&self, depth: f64, anchor: V, unit: V) -> f64 {
        let units = Units { unit, ahead: self.ahead };
        let rate = |cos: f64, sin: f64| (cos - self.slope).max(0.0) * units.of(cos, sin);
        self.slip(depth, anchor).map_or(0.0, |slip| {
            let Slip { met, across, beyond, .. } = &slip;
            let snap = if *beyond > 0.0 {
                beyond * units.of(met.at / met.arm, across / met.arm)
            } else {
                0.0
            };
            snap + self.over_slip(&slip, rate)
        })
    }

    /// The work of an annulus on the shift, in the given units of energy per direction: elastic until it slips, then
    /// the traction along the path, `int r cos theta dl` if all directions have the same unit.
    pub(super) fn work(&self, depth: f64, anchor: V, unit: V) -> f64 {
        if self.zeta < depth {
            return self.until_separation(depth).work(depth, anchor, unit);
        }
        let lever = self.ahead.by_component(unit);
        let [along, across] = [self.ahead.dot(lever), cross(self.ahead, lever)];
        let anchor = if self.grazes(depth, anchor) { self.settled(depth, anchor) } else { anchor };
        let stretch = self.shift.minus(anchor);
        let elastic = |path: f64, rest: f64| {
            // The work from the start up to the length `rest` before the end: length times mean
            // traction.
            path * (stretch.dot(lever) - (rest + 0.5 * path) * along)
        };
        // An annulus that comes into contact during the step has no stretch at first.
        let limit = self.zeta - depth;
        let path = if self.dz > 0.0 {
            self.length.min(self.length * (limit / self.dz))
        } else {
            self.length
        };
        match self.slip(depth, anchor) {
            None => elastic(path, 0.0),
            Some(slip) => {
                let before = elastic((path - slip.met.rest).max(0.0), slip.met.rest);
                before + self.over_slip(&slip, |cos, sin| cos * along + sin * across)
            }
        }
    }

    /// Whether an annulus, because W was inaccurate, was beyond its limit and would not come within
    /// it.
    pub(super) fn grazes(&self, depth: f64, anchor: V) -> bool {
        if self.zeta < depth {
            return self.until_separation(depth).grazes(depth, anchor);
        }
        self.slip(depth, anchor).is_some_and(|slip| slip.met.grazes)
    }

    /// The step up to the separation of the annulus of a depth. Its direction is that of the whole step: from the
    /// difference of two shifts it would have the round-off of a shift over a short way, another for each annulus.
    fn until_separation(&self, depth: f64) -> Self {
        let start = self.zeta - self.dz;
        let before = self.shift.minus(self.ahead.times(self.length));
        let length = (start - depth) / -self.dz * self.length;
        let shift = before.plus(self.ahead.times(length));
        let round_off_length = round_off_length(depth, shift);
        Self { zeta: depth, shift, dz: depth - start, length, round_off_length, ..*self }
    }

    /// The slip of an annulus that is in contact at the end of the step, if it slips.
    fn slip(&self, depth: f64, anchor: V) -> Option<Slip> {
        let limit = self.zeta - depth;
        let stretch = self.shift.minus(anchor);
        if self.length == 0.0 || stretch.dot(stretch) <= limit * limit {
            return None;
        }
        let (along, across) = (stretch.dot(self.ahead), cross(self.ahead, stretch));
        let met = self.met(along, across, limit);
        let beyond = 0.5 * (met.arm - met.limit) * (met.arm + met.limit);
        Some(Slip { met, limit, across, beyond })
    }

    /// The integral of `r rate(cos theta, sin theta) dl` over the slip of an annulus.
    fn over_slip(&self, slip: &Slip, rate: impl Fn(f64, f64) -> f64) -> f64 {
        let Slip { met, limit, .. } = slip;
        let straight = |path: f64, mean: f64, cos: f64| path * mean * rate(cos, 0.0);
        let Some([near, far]) = met.half else {
            let cos = if met.at < 0.0 { -1.0 } else { 1.0 };
            return straight(met.rest, 0.5 * (met.limit + limit), cos);
        };
        let tangent = far / near;
        if self.slope <= -1.0 {
            return self.over_steep_slip(tangent, [*limit, met.limit], rate);
        }
        // In x = log tan(theta/2): dx = -dl/r, r = r_0 exp(slope (x_0 - x)).
        let first = libm::log(tangent.abs());
        let log_tangent_decrease = log_tangent_decrease(met.rest, [met.limit, *limit], self.slope);
        let last = (first - log_tangent_decrease).max(ALIGNED_LOG_TANGENT.min(first));
        let limit_at = |x: f64| met.limit * libm::exp(self.slope * (first - x));
        let at = |x: f64| {
            let (tangent, limit) = (libm::exp(x).copysign(tangent), limit_at(x));
            let [cos, sin] = directions(tangent);
            limit * limit * rate(cos, sin)
        };
        let panels = ((first - last) / MAX_PANEL_WIDTH).ceil().max(1.0);
        let width = (first - last) / panels;
        let mut sum = 0.0;
        for panel in 0..panels as usize {
            let from = last + panel as f64 * width;
            sum += GAUSS.iter().map(|(x, w)| w * at(from + x * width)).sum::<f64>() * width;
        }
        let aligned = limit_at(last);
        let path = if self.slope == 0.0 {
            met.rest - met.limit * (first - last)
        } else {
            met.rest - (aligned - met.limit) / self.slope
        };
        sum + straight(path.max(0.0), 0.5 * (aligned + limit), 1.0)
    }

    /// The same if the limit decreases faster than the shift moves: over the limit r, in panels
    /// that shrink in proportion, `tan(theta/2) ~ r^(-1/slope)`.
    fn over_steep_slip(
        &self,
        tangent: f64,
        [last, first]: [f64; 2],
        rate: impl Fn(f64, f64) -> f64,
    ) -> f64 {
        let at = |limit: f64| {
            let [cos, sin] = directions(tangent * libm::pow(limit / first, -1.0 / self.slope));
            limit * rate(cos, sin) / -self.slope
        };
        let (mut high, mut sum) = (first, 0.0);
        for panel in 1..=STEEP_PANELS {
            let low =
                if panel == STEEP_PANELS { last } else { (LIMIT_RATIO_OF_PANELS * high).max(last) };
            let width = high - low;
            sum += GAUSS.iter().map(|(x, w)| w * at(low + x * width)).sum::<f64>() * width;
            high = low;
        }
        sum
    }
}

/// Cosine and sine of an angle from the tangent of its half.
fn directions(tangent: f64) -> [f64; 2] {
    let scale = 1.0 / (1.0 + tangent * tangent);
    [(1.0 - tangent) * (1.0 + tangent) * scale, 2.0 * tangent * scale]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Energies of both directions of an ellipse.
    const UNIT: [f64; 2] = [1.3, 0.7];

    fn energy([x, y]: [f64; 2]) -> f64 {
        0.5 * (UNIT[0] * x * x + UNIT[1] * y * y)
    }

    #[test]
    fn work_of_a_ring_is_stored_or_heat() {
        let mut state = 1_u64;
        let mut unit = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut worst = 0.0_f64;
        for case in 0..200_000 {
            let (zeta, depth) = (0.2 + unit(), 0.15 * unit());
            let limit = zeta - depth;
            // At the limit, within it, or beyond it because of the error of W.
            let reach = [1.0, unit(), 1.0 + 0.01 * unit()][case % 3] * limit;
            let angle = std::f64::consts::TAU * unit();
            let anchor = [reach * angle.cos(), reach * angle.sin()];
            let length = 10_f64.powf(2.0 * unit() - 2.0);
            let growth = [0.0, 2.0 * unit() - 1.0, 30.0 * (unit() - 0.5)][case / 3 % 3];
            let to = (zeta + (length * growth).max(-0.15), [length, 0.0]);
            let step = Step::new((zeta, [0.0; 2]), to);
            if to.0 < depth {
                continue;
            }
            let stored = energy(step.shift.minus(step.drag(depth, anchor))) - energy(anchor);
            let work = step.work(depth, anchor, UNIT);
            let balance = work - stored - step.heat(depth, anchor, UNIT);
            let error = balance.abs() / (reach * (reach + length));
            assert!(error < 1e-11, "{case}: {balance:e}, {zeta} {depth} {anchor:?} {to:?}");
            worst = worst.max(error);
        }
        println!("{worst:e}");
    }
}
