//! Heat and work of one annulus in a straight step.

use super::drag::{
    LimitPoint, Step, cross, exp_of_negative, log_tangent_decrease, round_off_length,
};
use crate::memory::Lateral;
use crate::profile::GAUSS;
use carom_special::quadrature::FixedRule;

/// Below this log `tan(theta/2)` slip is parallel to the step to round-off.
const ALIGNED_LOG_TANGENT: f64 = -18.0;
/// Widest panel of the quadrature over log `tan(theta/2)`: the directions have poles at the
/// distance pi/2, so that eight points have an error of 1e-14.
const MAX_PANEL_WIDTH: f64 = 0.8;
/// The width up to which four points have that error.
const MAX_WIDTH_OF_FOUR_POINTS: f64 = 0.1;
const FOUR_POINTS: [(f64, f64); 4] = FixedRule::parts();
/// Decrease of log r from which on an annulus has no traction: what is left of its heat is below 1e-17 of it.
const MAX_LOG_DECREASE: f64 = 20.0;

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
        let Some(slip) = self.slip(depth, anchor) else { return 0.0 };
        if !slip.met.grazes {
            return self.slip_heat(&slip, unit);
        }
        let (settled, before) =
            (self.settled(depth, anchor), self.shift.minus(self.ahead.times(self.length)));
        let [from, to] = [anchor, settled].map(|anchor| before.minus(anchor));
        let beyond = 0.5 * (from.dot(from) - to.dot(to));
        let snap = if beyond > 0.0 {
            beyond * Units { unit, ahead: from.times(1.0 / from.length()) }.of(1.0, 0.0)
        } else {
            0.0
        };
        let slip = self.slip(depth, settled);
        snap + slip.map_or(0.0, |slip| self.slip_heat(&slip, unit))
    }

    /// The heat of an annulus that is in contact at the end and was within its limit.
    fn slip_heat(&self, slip: &Slip, unit: V) -> f64 {
        let units = Units { unit, ahead: self.ahead };
        let rate = |cos: f64, sin: f64| (cos - self.slope).max(0.0) * units.of(cos, sin);
        let Slip { met, across, beyond, .. } = slip;
        let snap =
            if *beyond > 0.0 { beyond * units.of(met.at / met.arm, across / met.arm) } else { 0.0 };
        snap + self.over_slip(slip, rate)
    }

    /// The work of an annulus on the shift, in the given units of energy per direction: elastic until it slips, then
    /// the traction along the path, `int r cos theta dl` if all directions have the same unit.
    pub(super) fn work(&self, depth: f64, anchor: V, unit: V) -> f64 {
        if self.zeta < depth {
            return self.until_separation(depth).work(depth, anchor, unit);
        }
        let lever = self.ahead.by_component(unit);
        let [along, across] = [self.ahead.dot(lever), cross(self.ahead, lever)];
        let mut slip = self.slip(depth, anchor);
        let mut anchor = anchor;
        if slip.as_ref().is_some_and(|slip| slip.met.grazes) {
            anchor = self.settled(depth, anchor);
            slip = self.slip(depth, anchor);
        }
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
        match slip {
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
        let turn = Turn { limit: met.limit, tangent: far / near };
        if self.slope <= -1.0 {
            let length = libm::log(met.limit / limit).min(MAX_LOG_DECREASE);
            let of_limit = -1.0 / self.slope;
            return of_limit * turn.over(length, [of_limit, -1.0], rate);
        }
        let decrease = log_tangent_decrease(met.rest, [met.limit, *limit], self.slope);
        let until_aligned = (libm::log(turn.tangent.abs()) - ALIGNED_LOG_TANGENT).max(0.0);
        if decrease <= until_aligned {
            return turn.over(decrease, [1.0, self.slope], rate);
        }
        let aligned = met.limit * exp(self.slope * until_aligned);
        let path = if self.slope == 0.0 {
            met.rest - met.limit * until_aligned
        } else {
            met.rest - (aligned - met.limit) / self.slope
        };
        turn.over(until_aligned, [1.0, self.slope], &rate)
            + straight(path.max(0.0), 0.5 * (aligned + limit), 1.0)
    }
}

/// The traction of an annulus at the point at which it begins to slip.
struct Turn {
    limit: f64,
    /// `tan(theta/2)`, theta the angle from the step to the traction.
    tangent: f64,
}

impl Turn {
    /// The integral of `r^2 rate(cos theta, sin theta)` over a variable y, from zero to a length, with which
    /// `log tan(theta/2)` decreases and log r increases by these rates.
    ///
    /// In slip `dl = -r dx`, `x = log tan(theta/2)`: y is the decrease of x or, if the limit decreases faster than the
    /// shift moves, that of log r. The directions have poles at the distance pi/2 or more.
    fn over(
        &self,
        length: f64,
        [turning, growth]: [f64; 2],
        rate: impl Fn(f64, f64) -> f64,
    ) -> f64 {
        if length <= MAX_WIDTH_OF_FOUR_POINTS {
            return self.over_panels(&FOUR_POINTS, (1, length), [turning, growth], rate);
        }
        let panels = (length / MAX_PANEL_WIDTH).ceil();
        let width = length / panels;
        self.over_panels(&GAUSS, (panels as usize, width), [turning, growth], rate)
    }

    /// The same by panels of one width and a rule of nodes and weights on (0, 1).
    #[inline]
    fn over_panels<const N: usize>(
        &self,
        rule: &[(f64, f64); N],
        (panels, width): (usize, f64),
        [turning, growth]: [f64; 2],
        rate: impl Fn(f64, f64) -> f64,
    ) -> f64 {
        // Tangent and squared limit at the nodes of a panel, over those where it begins.
        let tangents = rule.map(|(part, _)| exp(-turning * width * part));
        let squares = rule.map(|(part, weight)| weight * exp(2.0 * growth * width * part));
        let [turned, grown] = [exp(-turning * width), exp(2.0 * growth * width)];
        let (mut tangent, mut square, mut sum) = (self.tangent, self.limit * self.limit, 0.0);
        for _ in 0..panels {
            let mut of_panel = 0.0;
            for (tangent_at, square_at) in tangents.iter().zip(&squares) {
                let [cos, sin] = directions(tangent * tangent_at);
                of_panel += square_at * rate(cos, sin);
            }
            sum += square * of_panel;
            tangent *= turned;
            square *= grown;
        }
        sum * width
    }
}

/// `exp(x)`, to some units in the last place, for magnitudes up to 60.
#[inline(always)]
fn exp(x: f64) -> f64 {
    let [small, large] = exp_of_negative(x.abs());
    let (over, under) = if x > 0.0 { (large, small) } else { (small, large) };
    over / under
}

/// Cosine and sine of an angle from the tangent of its half.
fn directions(tangent: f64) -> [f64; 2] {
    let scale = 1.0 / (1.0 + tangent * tangent);
    [(1.0 - tangent) * (1.0 + tangent) * scale, 2.0 * tangent * scale]
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_drawn::{Congruential, Draw as _};

    /// Energies of both directions of an ellipse.
    const UNIT: [f64; 2] = [1.3, 0.7];

    fn energy([x, y]: [f64; 2]) -> f64 {
        0.5 * (UNIT[0] * x * x + UNIT[1] * y * y)
    }

    /// The limit may decrease faster than the shift moves, also to zero.
    #[test]
    fn heat_is_traction_times_slip_of_many_small_steps() {
        const PARTS: usize = 2000;
        let mut draw = Congruential(1);
        let mut unit = || draw.part();
        let mut slipped = 0;
        for case in 0..300 {
            let (zeta, length) = (0.2 + unit(), 10_f64.powf(1.5 * unit() - 1.0));
            let angle = std::f64::consts::TAU * unit();
            let start = [zeta * angle.cos(), zeta * angle.sin()].times(unit());
            let slope = [0.0, 0.9, -0.9, -1.0, -4.0, -30.0][case % 6] * unit();
            let to = ((zeta + slope * length).max(0.0), [length, 0.0]);
            let heat = Step::new((zeta, [0.0; 2]), to).heat(0.0, start, [1.0, 1.0]);
            let at = |part: usize| {
                let share = part as f64 / PARTS as f64;
                (zeta + (to.0 - zeta) * share, to.1.times(share))
            };
            let (mut anchor, mut sum) = (start, 0.0);
            for part in 0..PARTS {
                let (from, to) = (at(part), at(part + 1));
                let end = Step::new(from, to).drag(0.0, anchor);
                let stretches = from.1.minus(anchor).plus(to.1.minus(end));
                sum += 0.5 * stretches.dot(end.minus(anchor));
                anchor = end;
            }
            let error = (heat - sum).abs() / (zeta * (zeta + length));
            assert!(error < 3e-6, "{case}: {heat} {sum}, {zeta} {start:?} {to:?}");
            slipped += usize::from(heat > 0.0);
        }
        assert!(slipped > 200, "{slipped} slip");
    }

    #[test]
    fn work_of_a_ring_is_stored_or_heat() {
        let mut draw = Congruential(1);
        let mut unit = || draw.part();
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
