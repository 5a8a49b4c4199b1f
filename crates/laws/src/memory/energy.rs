//! Elastic energy kept in the memory and energy dissipated by a step.

use super::lateral::cone_exit;
use super::{Lateral, Memory, VertexStack};
use crate::profile::NormalProfile;

/// Gauss's nodes and weights on (0, 1), twelve points.
const GAUSS: [(f64, f64); 6] = [
    (0.125_233_408_511_468_92, 0.249_147_045_813_402_77),
    (0.367_831_498_998_180_2, 0.233_492_536_538_354_8),
    (0.587_317_954_286_617_4, 0.203_167_426_723_065_9),
    (0.769_902_674_194_304_7, 0.160_078_328_543_346_23),
    (0.904_117_256_370_474_9, 0.106_939_325_995_318_43),
    (0.981_560_634_246_719_3, 0.047_175_336_386_511_83),
];

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Memory<V, S, P> {
    /// The elastic energy of the tangential shift, conjugate to Phi and X, per direction:
    /// `(1/2) int F'' |X - W(s)|^2 ds`, for Hertz `(3/4) int |X - W(t^2)|^2 dt`.
    ///
    /// The sum of the components is the energy where all directions are equally stiff.
    #[must_use]
    pub fn stored_energy(&self) -> V {
        let mut sum = [0.0; 2];
        for segment in self.segments() {
            let low = self.shift.minus(segment.anchor);
            let high = low.minus(segment.slope.times(segment.to - segment.from));
            let (low, high) = (low.components(), high.components());
            for (i, sum) in sum.iter_mut().enumerate().take(V::DIMENSION) {
                let ends = [low[i], high[i]];
                *sum += 0.5 * self.profile.spring_product(segment.from, segment.to, ends, ends);
            }
        }
        V::from_components(sum)
    }

    /// The energy that the straight step to a new approach and shift would turn into heat, per
    /// direction of the shift, conjugate to Phi and X. Nothing moves.
    ///
    /// It is the work of the force less the growth of [`Memory::stored_energy`], found from the
    /// slip itself, so that small losses keep their digits: the rings of the slip area slide at
    /// the friction limit.
    ///
    /// Not finite arguments give zero.
    #[must_use]
    pub fn dissipation(&self, zeta: f64, shift: V) -> V {
        if !zeta.is_finite() || !shift.is_finite() || (self.zeta <= 0.0 && zeta <= 0.0) {
            return V::default();
        }
        let mut path = self.path_in_contact(zeta, shift);
        if path.dz > 0.0 && path.dx.dot(path.dx) <= path.dz * path.dz {
            return V::default();
        }
        let mut sum = V::default();
        let (mut end, mut anchor) = (path.zeta, path.shift);
        for i in (0..self.stack.len()).rev() {
            let base = self.stack.get(i);
            if path.start < 1.0 {
                let line =
                    Line { base: base.depth, end, anchor, slope: base.slope, curb: base.curb };
                let exit = path.exit(base.depth, base.anchor);
                sum = sum.plus(path.integrate(exit, &self.profile, |path, t| path.ring(t, &line)));
                path.start = exit;
            }
            (end, anchor) = (base.depth, base.anchor);
        }
        if path.start < 1.0 {
            let arm = path.at(path.start).minus(anchor);
            let slope = self.stack.is_empty().then(V::default);
            let before = V::slip_slope(arm, slope.unwrap_or_else(|| self.stack.get(0).slope), 0.0);
            let onset = path.start;
            sum = sum
                .plus(path.integrate(1.0, &self.profile, |path, t| path.sliding(onset, t, before)));
        }
        sum
    }

    /// The part of the step during which the bodies touch.
    fn path_in_contact(&self, zeta: f64, shift: V) -> Path<V> {
        let (mut from, mut to) = ((self.zeta, self.shift), (zeta, shift));
        let touch = |from: (f64, V), to: (f64, V)| {
            let part = from.0 / (from.0 - to.0);
            (0.0, from.1.plus(to.1.minus(from.1).times(part)))
        };
        if self.zeta < 0.0 {
            from = touch(from, to);
        }
        if zeta < 0.0 {
            to = touch(from, to);
        }
        Path { zeta: from.0, shift: from.1, dz: to.0 - from.0, dx: to.1.minus(from.1), start: 0.0 }
    }
}

/// A straight step, travelled up to the parameter `start`.
struct Path<V> {
    zeta: f64,
    shift: V,
    dz: f64,
    dx: V,
    start: f64,
}

/// A segment seen from its upper end.
struct Line<V> {
    base: f64,
    end: f64,
    anchor: V,
    slope: V,
    curb: f64,
}

/// A slip ring at one instant: depth of the stick area, direction, and their rates.
struct Ring<V> {
    stick: f64,
    slope: V,
    slope_rate: V,
}

impl<V: Lateral> Path<V> {
    fn at(&self, t: f64) -> V {
        self.shift.plus(self.dx.times(t))
    }

    fn depth(&self, t: f64) -> f64 {
        self.zeta + self.dz * t
    }

    /// The parameter at which the cone leaves a vertex behind.
    fn exit(&self, depth: f64, anchor: V) -> f64 {
        let offset = self.shift.minus(anchor);
        cone_exit(offset, self.dx, self.zeta - depth, self.dz).max(self.start)
    }

    /// The ring that cuts a segment.
    fn ring(&self, t: f64, line: &Line<V>) -> Ring<V> {
        let zeta = self.depth(t);
        let (length, beyond) = (zeta - line.base, zeta - line.end);
        let d = self.at(t).minus(line.anchor).minus(line.slope.times(beyond));
        let reach = if d == V::default() {
            beyond.max(0.0)
        } else {
            V::reach(d, line.slope, line.curb, length).unwrap_or(length).max(beyond)
        };
        let slope = V::slip_slope(d, line.slope, reach);
        let closing = 1.0 - slope.dot(line.slope);
        let stick_rate = if closing > 0.0 { (self.dz - slope.dot(self.dx)) / closing } else { 0.0 };
        let drift = self.dx.minus(line.slope.times(stick_rate));
        let across = drift.minus(slope.times(slope.dot(drift)));
        let slope_rate = if reach > 0.0 { across.times(1.0 / reach) } else { V::default() };
        Ring { stick: zeta - reach, slope, slope_rate }
    }

    /// The whole contact, sliding since the parameter `onset`.
    fn sliding(&self, onset: f64, t: f64, before: V) -> Ring<V> {
        let (from, zeta) = (self.depth(onset), self.depth(t));
        let slope = V::dragged(before, self.dx.times(t - onset), from, zeta);
        let across = self.dx.minus(slope.times(slope.dot(self.dx)));
        let slope_rate = if zeta > 0.0 { across.times(1.0 / zeta) } else { V::default() };
        Ring { stick: 0.0, slope, slope_rate }
    }

    /// The heat of the slip ring from `start` to `end`, by Gauss after a substitution that
    /// smooths the square root of a vanishing stick area.
    fn integrate<P: NormalProfile>(
        &self,
        end: f64,
        profile: &P,
        ring: impl Fn(&Self, f64) -> Ring<V>,
    ) -> V {
        let span = end - self.start;
        let mut sum = V::default();
        if span <= 0.0 {
            return sum;
        }
        for (node, weight) in GAUSS {
            for node in [-node, node] {
                let v = 0.5 * (1.0 + node);
                let t = end - span * v * v;
                let rate = self.heat_rate(t, profile, &ring(self, t));
                sum = sum.plus(rate.times(weight * v * span));
            }
        }
        sum
    }

    /// `int F'' (zeta - s) m_i dW_i`, with `W = X - m (zeta - s)`.
    fn heat_rate<P: NormalProfile>(&self, t: f64, profile: &P, ring: &Ring<V>) -> V {
        let [first, second] = profile.slip_moments(self.depth(t), ring.stick);
        let advance = self.dx.minus(ring.slope.times(self.dz)).times(first);
        let turn = ring.slope_rate.times(second);
        ring.slope.by_component(advance.minus(turn))
    }
}
