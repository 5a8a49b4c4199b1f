//! Quantities derived from a memory: those of the thesis, tractions, tangents.

use super::{Lateral, Memory, MemoryRegime, Vertex, VertexStack};
use crate::profile::NormalProfile;

/// A straight segment of the memory polyline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment<V> {
    /// Depth of the lower end.
    pub from: f64,
    /// Depth of the upper end.
    pub to: f64,
    /// Anchor at the lower end.
    pub anchor: V,
    /// Slope of the anchor; its length is 1 in a slip annulus.
    pub slope: V,
    /// Slope of the force with respect to the normal force; differs from `slope` after a merge
    /// only.
    pub force_slope: V,
    /// Whether it was formed in slip (otherwise in complete adhesion).
    pub is_slip: bool,
}

/// The consistent tangent of a step: the derivatives of the force at its end with respect to
/// approach and shift at its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tangent {
    /// dPhi_i/dX_j, rows i; in one direction only the first entry is used.
    pub by_shift: [[f64; 2]; 2],
    /// dPhi_i/dzeta.
    pub by_approach: [f64; 2],
}

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Memory<V, S, P> {
    /// The approach zeta; negative while the bodies are separated.
    #[must_use]
    pub fn zeta(&self) -> f64 {
        self.zeta
    }

    /// The normalised shift X.
    #[must_use]
    pub fn shift(&self) -> V {
        self.shift
    }

    /// The normalised force Phi; F = (2/3) f c_z Phi.
    #[inline]
    #[must_use]
    pub fn force(&self) -> V {
        self.force
    }

    /// The normalised normal force, zeta^(3/2) for Hertz.
    #[must_use]
    pub fn normal_force(&self) -> f64 {
        self.profile.force(self.zeta.max(0.0))
    }

    /// The contact state after the last step.
    #[must_use]
    pub fn regime(&self) -> MemoryRegime {
        self.regime
    }

    /// Whether the bodies are in contact.
    #[must_use]
    pub fn is_touching(&self) -> bool {
        !self.stack.is_empty()
    }

    /// The normal law.
    #[must_use]
    pub fn profile(&self) -> &P {
        &self.profile
    }

    /// How often two segments were merged because the storage was full; zero for storage that
    /// grows.
    #[must_use]
    pub fn merges(&self) -> u32 {
        self.stack.merges()
    }

    /// The stack of vertices, for example to store it elsewhere.
    #[must_use]
    pub fn stack(&self) -> &S {
        &self.stack
    }

    /// zeta*/zeta, the share of the contact area that sticks, for bodies in contact.
    pub(crate) fn stick_fraction(&self) -> f64 {
        self.stick_depth() / self.zeta
    }

    /// zeta*, the approach at which the contact would have the size of the stick area: `(a*/a)^2 =
    /// zeta*/zeta`. Equal to zeta after adhesion and release, zero in gross sliding.
    #[must_use]
    pub fn stick_depth(&self) -> f64 {
        match self.regime {
            MemoryRegime::Separated | MemoryRegime::Sliding => 0.0,
            MemoryRegime::Adhesion | MemoryRegime::Release => self.zeta,
            _ => self.stack.get(self.stack.len() - 1).depth,
        }
    }

    /// a*/a, the relative radius of the stick area of a Hertz contact, from 0 to 1.
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        if self.zeta > 0.0 { (self.stick_depth() / self.zeta).sqrt() } else { 0.0 }
    }

    /// The slide offset W_0: the shift at which the deepest annulus would carry no load. It is zero
    /// until gross sliding or a new first contact changes it; the elastic shift is `X - W_0`.
    #[must_use]
    pub fn slide_offset(&self) -> V {
        if self.is_touching() { self.stack.get(0).anchor } else { self.shift }
    }

    /// The segments of the polyline, from the deepest annulus to the edge.
    pub fn segments(&self) -> impl ExactSizeIterator<Item = Segment<V>> + '_ {
        let len = self.stack.len();
        (0..len).map(move |i| {
            let here = self.stack.get(i);
            let to = if i + 1 < len { self.stack.get(i + 1).depth } else { self.zeta };
            Segment {
                from: here.depth,
                to,
                anchor: here.anchor,
                slope: here.slope,
                force_slope: here.force_slope,
                is_slip: here.is_slip(),
            }
        })
    }

    /// The direction of the traction in the present slip annulus: p_N summed, or `-s_N` of the
    /// thesis, where slip is that of body 1. `None` without slip.
    #[must_use]
    pub fn slip_direction(&self) -> Option<V> {
        match self.regime {
            MemoryRegime::Separated | MemoryRegime::Adhesion | MemoryRegime::Release => None,
            _ => Some(self.stack.get(self.stack.len() - 1).slope),
        }
    }

    /// The depths `zeta_i*` of the stored points of instantaneous adhesion, where one slip annulus
    /// ends and the next, with another direction, begins.
    pub fn instantaneous_adhesions(&self) -> impl Iterator<Item = f64> + '_ {
        let slips = |i: usize| self.stack.get(i).is_slip();
        (1..self.stack.len())
            .filter(move |&i| slips(i - 1) && slips(i))
            .map(|i| self.stack.get(i).depth)
    }

    /// The number N of slip annuli (the "N-th decrease" of the thesis).
    #[must_use]
    pub fn decrease(&self) -> usize {
        self.segments().filter(|segment| segment.is_slip).count()
    }

    /// The anchor W(s): the shift at which the annulus at depth s would carry no load. Beyond the
    /// edge it is the present shift.
    #[must_use]
    pub fn anchor(&self, depth: f64) -> V {
        match self.index_of(depth) {
            Some(i) if depth < self.zeta => self.stack.get(i).anchor_at(depth),
            _ => self.shift,
        }
    }

    /// The force of the part of the contact deeper than `depth`: Phi of the sub-contact, whose
    /// shift is the anchor there.
    #[must_use]
    pub fn force_below(&self, depth: f64) -> V {
        match self.index_of(depth) {
            Some(i) if depth < self.zeta => self.stack.get(i).force_at(depth, &self.profile),
            _ => self.force,
        }
    }

    fn index_of(&self, depth: f64) -> Option<usize> {
        (0..self.stack.len()).rev().find(|&i| i == 0 || self.stack.get(i).depth <= depth)
    }

    /// The sum over all segments of their slope times the increase of `g` over them.
    ///
    /// Any field of the tangential problem (force, traction, displacement) follows in this way from
    /// the same field `g(z)` of the normal problem at the approach z.
    pub fn superpose(&self, mut g: impl FnMut(f64) -> f64) -> V {
        let mut low = g(0.0);
        let mut sum = V::default();
        for segment in self.segments() {
            let high = g(segment.to);
            sum = sum.plus(segment.force_slope.times(high - low));
            low = high;
        }
        sum
    }

    /// The consistent tangent of the last step, for implicit integration and force control.
    ///
    /// It is the derivative at the end of the step, so that Newton's method converges
    /// quadratically; in gross sliding the rotation of the traction is that of the last instant.
    #[must_use]
    pub fn tangent(&self) -> Tangent {
        let isotropic = |k: f64| [[k, 0.0], [0.0, k]];
        let rest = |by_shift| Tangent { by_shift, by_approach: [0.0; 2] };
        if !self.is_touching() {
            return rest(isotropic(0.0));
        }
        let stiffness = self.profile.stiffness(self.zeta);
        let top = self.stack.get(self.stack.len() - 1);
        let length = self.zeta - top.depth;
        if self.regime == MemoryRegime::Release || length <= 0.0 {
            return rest(isotropic(stiffness));
        }
        let m = top.slope.components();
        let chord = self.profile.growth(top.depth, length) / length;
        let normal_turn = m.map(|m| m * (stiffness - chord));
        match self.regime {
            MemoryRegime::Adhesion => {
                Tangent { by_shift: isotropic(chord), by_approach: normal_turn }
            }
            MemoryRegime::Sliding => {
                Tangent { by_shift: turning(m, chord), by_approach: m.map(|m| m * stiffness) }
            }
            _ => self.slip_tangent(m, stiffness, chord),
        }
    }

    /// The tangent while an annulus of slope m extends into the segment below.
    fn slip_tangent(&self, m: [f64; 2], stiffness: f64, chord: f64) -> Tangent {
        let last = self.stack.len() - 1;
        let depth = self.stack.get(last).depth;
        let (slope, force_slope) = match last {
            0 => ([0.0; 2], [0.0; 2]),
            _ => {
                let below = self.stack.get(last - 1);
                (below.slope.components(), below.force_slope.components())
            }
        };
        let stick = self.profile.stiffness(depth);
        let approach_to_line = 1.0 - (m[0] * slope[0] + m[1] * slope[1]);
        // ds* = (dzeta - m.dX)/(1 - m.m0); dm = (I - m m^T)(dX - m0 ds*)/(zeta - s*).
        // The force at the cut follows the force slope below, which normally equals m0.
        let mut tangent = Tangent { by_shift: turning(m, chord), by_approach: [0.0; 2] };
        let across = turning(m, chord);
        for i in 0..2 {
            let turned = across[i][0] * slope[0] + across[i][1] * slope[1];
            let by_depth = stick * (force_slope[i] - m[i]) - turned;
            let by_depth = if approach_to_line > 0.0 { by_depth / approach_to_line } else { 0.0 };
            for (entry, direction) in tangent.by_shift[i].iter_mut().zip(m) {
                *entry -= by_depth * direction;
            }
            tangent.by_approach[i] = m[i] * stiffness + by_depth;
        }
        if V::DIMENSION == 1 {
            tangent.by_shift[1] = [0.0; 2];
        }
        tangent
    }
}

/// `k (I - m m^T)`.
fn turning(m: [f64; 2], k: f64) -> [[f64; 2]; 2] {
    let off = -k * m[0] * m[1];
    [[k * (1.0 - m[0] * m[0]), off], [off, k * (1.0 - m[1] * m[1])]]
}

impl<V: Lateral, S: VertexStack<V>> Memory<V, S> {
    /// The traction in units of `f sigma_z0`, the greatest traction limit, at the squared
    /// elliptical radius `q = (x/a)^2 + (y/b)^2` of the present contact.
    #[must_use]
    pub fn traction(&self, q: f64) -> V {
        if !(self.zeta > 0.0 && q < 1.0) {
            return V::default();
        }
        let depth = q * self.zeta;
        self.superpose(|z| (z - depth).max(0.0).sqrt()).times(1.0 / self.zeta.sqrt())
    }
}

impl<S: VertexStack<[f64; 2]>, P: NormalProfile> Memory<[f64; 2], S, P> {
    /// Rotates the frame in the contact plane: all components are then given in axes rotated by
    /// `angle` (radians, counterclockwise).
    ///
    /// Keeps the memory valid when the contact frame of two rolling bodies rotates.
    pub fn turn_frame(&mut self, angle: f64) {
        let turn = Turn::by(angle);
        self.shift = turn.of(self.shift);
        self.force = turn.of(self.force);
        for i in 0..self.stack.len() {
            turn.vertex(self.stack.get_mut(i));
        }
    }
}

/// A rotation of the axes in the contact plane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Turn {
    sin: f64,
    cos: f64,
}

impl Turn {
    /// Axes rotated by `angle`, counterclockwise.
    pub(crate) fn by(angle: f64) -> Self {
        let (sin, cos) = libm::sincos(angle);
        Self { sin, cos }
    }

    /// The components of a vector in the new axes.
    pub(crate) fn of(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.cos * x + self.sin * y, self.cos * y - self.sin * x]
    }

    /// A vertex in the new axes.
    pub(crate) fn vertex(self, vertex: &mut Vertex<[f64; 2]>) {
        vertex.anchor = self.of(vertex.anchor);
        vertex.slope = self.of(vertex.slope);
        vertex.force_slope = self.of(vertex.force_slope);
        vertex.force = self.of(vertex.force);
    }
}

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Memory<V, S, P> {
    /// Moves the origin of the shifts: X and every anchor increase by `by`. Forces do not change.
    pub fn translate(&mut self, by: V) {
        self.shift = self.shift.plus(by);
        for i in 0..self.stack.len() {
            let vertex = self.stack.get_mut(i);
            vertex.anchor = vertex.anchor.plus(by);
        }
    }
}
