//! The friction heat of a step in two directions, by quadrature over the step.
//!
//! A slip annulus of stick depth s* and direction m slides at `W' = X' - m zeta' - m' (zeta - s)`.
//! Its geometry is smooth while the cone cuts one segment, except at the moment when the edge meets
//! the segment's own line and the traction reverses. The step is divided there, and wherever the
//! cone passes a vertex.

use carom_special::quadrature::{QuadratureError, Tolerance, adaptive};

use super::energy::Path;
use super::lateral::outgrown;
use super::{Lateral, Memory, Vertex, VertexStack};
use crate::profile::NormalProfile;

/// Allowed error of the heat of a part of the step, relative to it.
const ERROR_OF_PART: f64 = 1e-13;
/// The same, relative to the heat if the whole motion were slip of the widest annulus.
const ERROR_OF_ANNULUS: f64 = 1e-15;
/// The same, relative to friction limit times motion: below it the heat is rounding error.
const ERROR_OF_LIMIT: f64 = 1e-20;

/// Fraction at which an integral is divided to confirm it, and greatest number of divisions.
const UNEVEN: f64 = 0.382;
const CONFIRMATIONS: u32 = 4;

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Memory<V, S, P> {
    /// The friction heat of a straight step, in the given units of energy per direction.
    pub(super) fn heat_in_plane(&self, path: &Path<V>, unit: V) -> f64 {
        let mut heat = 0.0;
        self.parts_of(path, |part, edge| heat += path.heat(&self.profile, unit, part, edge));
        heat
    }

    /// The parts of a straight step with slip in which the slip annulus changes smoothly, with its inner edge.
    pub(super) fn parts_of(&self, path: &Path<V>, mut part: impl FnMut([f64; 2], &Edge<V>)) {
        let (mut start, mut end, mut anchor) = (0.0, path.zeta, path.shift);
        for i in (0..self.stack.len()).rev() {
            let base = self.stack.get(i);
            let line = Line {
                base: *base,
                distance: path.shift.minus(anchor).minus(base.slope.times(path.zeta - end)),
                drift: path.dx.minus(base.slope.times(path.dz)),
                beyond: path.zeta - end,
            };
            let exit = line.exit(path).max(start);
            let turn = line.nearest().clamp(start, exit);
            let edge = Edge::On(line);
            part([start, turn], &edge);
            part([turn, exit], &edge);
            if exit >= 1.0 {
                return;
            }
            (start, end, anchor) = (exit, base.depth, base.anchor);
        }
        let arm = path.at(start).minus(anchor);
        let foot = if self.stack.is_empty() { V::default() } else { self.stack.get(0).slope };
        let before = V::slip_slope(arm, foot, 0.0);
        part([start, 1.0], &Edge::Sliding { onset: start, before });
    }
}

/// Where the slip annulus ends inwards.
pub(super) enum Edge<V> {
    /// On a segment of the polyline.
    On(Line<V>),
    /// Nowhere: the whole contact slides since a time, and had a traction of this direction then.
    Sliding { onset: f64, before: V },
}

impl<V: Lateral> Edge<V> {
    /// The slip annulus at a time.
    #[inline]
    pub(super) fn ring(&self, path: &Path<V>, t: f64) -> Ring<V> {
        match self {
            Self::On(line) => line.ring(path, t),
            Self::Sliding { onset, before } => path.sliding(*onset, t, *before),
        }
    }
}

/// A segment relative to the moving edge.
pub(super) struct Line<V> {
    pub(super) base: Vertex<V>,
    /// The distance of the shift from the segment's line at the start, and its rate of change.
    distance: V,
    drift: V,
    /// The distance of the edge beyond the segment's upper end at the start.
    beyond: f64,
}

/// A slip annulus at one instant.
pub(super) struct Ring<V> {
    /// Its width zeta - s*; `None` in gross sliding, where the flat end slips too.
    pub(super) width: Option<f64>,
    pub(super) slope: V,
    /// `m.X' - zeta'`, the rate of the slip along the traction.
    rate: f64,
    /// The width times m'.
    turn: V,
}

impl<V: Lateral> Line<V> {
    /// The time at which the edge is closest to the line.
    fn nearest(&self) -> f64 {
        let square = self.drift.dot(self.drift);
        if square > 0.0 { -self.distance.dot(self.drift) / square } else { 0.0 }
    }

    /// The time at which the cone passes the segment's lower end.
    fn exit(&self, path: &Path<V>) -> f64 {
        // |d + m0 L|^2 = L^2 with L from the base to the edge, in units in which no fourth power
        // underflows.
        let unit = 1.0 / (path.zeta.max(path.end).max(path.dx.length())).max(f64::MIN_POSITIVE);
        let (from, drift) = (self.distance.times(unit), self.drift.times(unit));
        let (length, dz) = ((path.zeta - self.base.depth) * unit, path.dz * unit);
        let (m, q) = (self.base.slope, self.base.curb);
        let curve = drift.dot(drift) + dz * (2.0 * m.dot(drift) - q * dz);
        let slope = from.dot(drift) + length * m.dot(drift) + dz * m.dot(from) - q * length * dz;
        let inside = from.dot(from) + length * (2.0 * m.dot(from) - q * length);
        let tip = if dz < 0.0 { (length / -dz).max(0.0) } else { 1.0 };
        outgrown(curve, slope, inside.min(0.0)).min(tip)
    }

    /// The slip annulus that ends on the segment.
    fn ring(&self, path: &Path<V>, t: f64) -> Ring<V> {
        let (m, q) = (self.base.slope, self.base.curb);
        let length = path.depth(t) - self.base.depth;
        let beyond = (self.beyond + path.dz * t).max(0.0);
        let d = self.distance.plus(self.drift.times(t));
        let cut = V::reach(d, m, q, length).filter(|_| d != V::default());
        let width = cut.unwrap_or(if d == V::default() { beyond } else { length });
        if width <= 0.0 {
            return Ring { width: Some(0.0), slope: m, rate: 0.0, turn: V::default() };
        }
        let slope = V::slip_slope(d, m, width);
        // With e = d/r = m - m0: 1 - m.m0 = (e.e + 1 - m0.m0)/2 and r m' = d' - e r' are accurate
        // also if the annulus nearly continues the segment.
        let e = d.times(1.0 / width);
        let bend = e.dot(e) + q;
        let along = slope.dot(self.drift);
        let turn = match cut {
            Some(_) if bend > 0.0 => self.drift.minus(e.times(2.0 * along / bend)),
            _ => across(path.dx, slope),
        };
        Ring { width: Some(width), slope, rate: along - 0.5 * path.dz * bend, turn }
    }
}

impl<V: Lateral> Path<V> {
    fn at(&self, t: f64) -> V {
        self.shift.plus(self.dx.times(t))
    }

    pub(super) fn depth(&self, t: f64) -> f64 {
        self.zeta + self.dz * t
    }

    /// The whole contact, sliding since the time `onset`.
    fn sliding(&self, onset: f64, t: f64, before: V) -> Ring<V> {
        let slope = V::dragged(before, self.dx.times(t - onset), self.depth(onset), self.depth(t));
        let rate = slope.dot(self.dx) - self.dz;
        Ring { width: None, slope, rate, turn: across(self.dx, slope) }
    }

    /// The heat of a part of the step, with a substitution that removes square roots at both ends.
    fn heat<P: NormalProfile>(
        &self,
        profile: &P,
        unit: V,
        [from, to]: [f64; 2],
        edge: &Edge<V>,
    ) -> f64 {
        let span = to - from;
        if span <= 0.0 {
            return 0.0;
        }
        let widest = [from, from + 0.5 * span, to]
            .map(|t| self.moments(profile, &edge.ring(self, t), t)[0])
            .into_iter()
            .fold(0.0, f64::max);
        let [x, y] = unit.components().map(f64::abs);
        let limit = profile.force(self.zeta.max(self.end));
        let motion = (self.dx.length() + self.dz.abs()) * x.max(y);
        let largest = (ERROR_OF_ANNULUS * widest).max(ERROR_OF_LIMIT * limit) * motion;
        let Ok(tolerance) = Tolerance::new(largest, ERROR_OF_PART) else {
            return 0.0; // not finite: refused before
        };
        let rate = |v: f64| {
            let t = from + span * v * v * (3.0 - 2.0 * v);
            self.heat_rate(profile, &edge.ring(self, t), t, unit) * (6.0 * v * (1.0 - v))
        };
        span * settled(&rate, [0.0, 1.0], tolerance, largest, CONFIRMATIONS)
    }

    /// The integrals of (zeta - s) and of (zeta - s)^2 over the annulus.
    fn moments<P: NormalProfile>(&self, profile: &P, ring: &Ring<V>, t: f64) -> [f64; 2] {
        let zeta = self.depth(t).max(0.0);
        match ring.width {
            Some(width) => profile.slip_moments(zeta, (zeta - width).max(0.0)),
            None => [profile.force(zeta), 2.0 * profile.energy(zeta)],
        }
    }

    /// `int F'' (zeta - s) m_i W_i' ds` over the annulus, in the given units per direction.
    fn heat_rate<P: NormalProfile>(&self, profile: &P, ring: &Ring<V>, t: f64, unit: V) -> f64 {
        let width = ring.width.unwrap_or(self.depth(t));
        if width <= 0.0 {
            return 0.0;
        }
        let [first, second] = self.moments(profile, ring, t);
        let [x, y] = unit.components();
        let rate = ring.rate.max(0.0); // negative by round-off
        let heat = 0.5 * (x + y) * rate * first;
        if x == y {
            return heat; // m.m' = 0
        }
        // Slip is parallel to the traction only on average over the annulus.
        let slip = across(self.dx, ring.slope).plus(ring.slope.times(rate)).times(first);
        let slip = slip.minus(ring.turn.times(second / width));
        let [along, aside] = ring.slope.by_component(slip).components();
        heat + 0.5 * (x - y) * (along - aside)
    }
}

/// An integral that is confirmed by its two parts. If the traction rotates within a small part of
/// the step, the error estimate of one quadrature in ten thousand is too small by coincidence.
fn settled(
    rate: &impl Fn(f64) -> f64,
    [low, high]: [f64; 2],
    tolerance: Tolerance,
    least: f64,
    left: u32,
) -> f64 {
    let middle = low + UNEVEN * (high - low);
    let parts = [[low, middle], [middle, high]];
    let over = |[low, high]: [f64; 2]| adaptive(low, high, tolerance, rate);
    let whole = match over([low, high]) {
        Ok(integral) => integral.value,
        // The remaining error is rounding.
        Err(QuadratureError::NotConverged { integral }) => return integral.value,
        Err(_) => return 0.0,
    };
    let [Ok(one), Ok(two)] = parts.map(over) else { return whole };
    let sum = one.value + two.value;
    if left == 0 || (sum - whole).abs() <= 2.0 * (ERROR_OF_PART * sum.abs()).max(least) {
        return sum;
    }
    parts.map(|part| settled(rate, part, tolerance, least, left - 1)).iter().sum()
}

/// The component of v perpendicular to the unit vector m.
fn across<V: Lateral>(v: V, m: V) -> V {
    v.minus(m.times(m.dot(v)))
}
