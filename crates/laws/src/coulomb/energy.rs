//! Elastic energy kept in the memory, energy dissipated by a step, and what joins change.

use carom_special::quadrature::{QuadratureError, Tolerance, adaptive};

use super::CoulombMemory;
use super::drag::Step;
use super::piece::{End, Knot, Piece};
use crate::memory::{Lateral, VertexStack};
use crate::profile::GAUSS;

/// The error allowed to an integral over the rings, relative and over the energy of the largest
/// stretch.
const RELATIVE: f64 = 1e-12;
const OF_LARGEST: f64 = 1e-15;

impl<V: Lateral> Piece<V> {
    /// The elastic energy of its rings at a shift, per direction: `(3/4) int |X - W(t^2)|^2 dt`, a
    /// polynomial of degree 8 in t.
    fn energy(&self, shift: V) -> V {
        let (low, high) = (self.low.root, self.high.root);
        let length = self.high.depth - self.low.depth;
        if length <= 0.0 {
            return V::default();
        }
        let mut sum = V::default();
        for (part, weight) in GAUSS {
            let root = low + part * (high - low);
            let stretch = shift.minus(self.at((root - low) * (root + low) / length));
            sum = sum.plus(stretch.by_component(stretch).times(weight));
        }
        sum.times(0.75 * (high - low))
    }
}

impl<V: Lateral, S: VertexStack<V>> CoulombMemory<V, S> {
    /// The pieces of the curve, from the deepest ring to the edge.
    pub(super) fn chain(&self) -> impl Iterator<Item = Piece<V>> + '_ {
        let tip = End { depth: self.zeta, root: self.root, anchor: self.shift };
        (0..self.stack.len()).map(move |i| {
            let end = match i + 1 < self.stack.len() {
                true => Knot::of(self.stack.get(i + 1)).end(),
                false => tip,
            };
            Piece::new(&Knot::of(self.stack.get(i)), end)
        })
    }

    /// The elastic energy of the tangential shift, conjugate to Phi and X, per direction:
    /// `(3/4) int |X - W(t^2)|^2 dt`.
    #[must_use]
    pub fn stored_energy(&self) -> V {
        self.chain().fold(V::default(), |sum, piece| sum.plus(piece.energy(self.shift)))
    }

    /// The energy that the straight step to a new approach and shift would turn into heat, per
    /// direction, conjugate to Phi and X: the integral of traction times slip over the rings and
    /// the way, by quadrature. Not negative; nothing moves. Not finite arguments give zero.
    #[must_use]
    pub fn dissipation(&self, zeta: f64, shift: V) -> V {
        let along = |weight| self.heat(zeta, shift, V::from_components(weight));
        V::from_components([along([1.0, 0.0]), along([0.0, 1.0])])
    }

    /// The work of the force in the straight step to a new approach and shift, of each ring exactly;
    /// conjugate to Phi and X.
    #[must_use]
    pub fn work(&self, zeta: f64, shift: V) -> f64 {
        let unit = V::from_components([1.0, 1.0]);
        let stored = self.stored_energy().dot(unit);
        self.exact_energy(zeta, shift) - stored + self.heat(zeta, shift, unit)
    }

    /// The energy that drawing parabolas through the dragged rings, and joining them, adds in a
    /// step, with its sign: work is the growth of [`CoulombMemory::stored_energy`], less this, and
    /// the heat. It vanishes with the tolerance.
    #[must_use]
    pub fn joined_energy(&self, zeta: f64, shift: V) -> f64 {
        let mut after = self.clone();
        if after.advance(zeta, shift).is_err() {
            return 0.0;
        }
        let unit = V::from_components([1.0, 1.0]);
        after.stored_energy().dot(unit) - self.exact_energy(zeta, shift)
    }

    /// The scalar product of [`CoulombMemory::dissipation`] and the energies `unit`.
    pub(crate) fn heat(&self, zeta: f64, shift: V, unit: V) -> f64 {
        self.over_rings(zeta, shift, |step, depth, anchor| step.heat(depth, anchor, unit))
    }

    /// The elastic energy after a step if every ring is dragged by itself.
    fn exact_energy(&self, zeta: f64, shift: V) -> f64 {
        self.over_rings(zeta, shift, |step, depth, anchor| {
            if depth >= step.zeta {
                return 0.0;
            }
            let stretch = step.shift.minus(step.drag(depth, anchor));
            0.5 * stretch.dot(stretch)
        })
    }

    /// An integral over the springs of all rings that touch in a step, `int F'' f ds`.
    fn over_rings(&self, zeta: f64, shift: V, f: impl Fn(&Step<V>, f64, V) -> f64) -> f64 {
        if !zeta.is_finite() || !shift.is_finite() || (self.zeta <= 0.0 && zeta <= 0.0) {
            return 0.0;
        }
        let mut before = self.clone();
        let mut end = (zeta, shift);
        if before.stack.is_empty() {
            before.touch(zeta, shift);
        } else if zeta < 0.0 {
            let part = self.zeta / (self.zeta - zeta);
            end = (0.0, self.shift.plus(shift.minus(self.shift).times(part)));
        }
        let step = Step::new((before.zeta, before.shift), end);
        let stretch = before.extent.max(end.1.minus(before.shift).length());
        let size = before.zeta.max(end.0).sqrt() * stretch * stretch;
        let mut sum = 0.0;
        for piece in before.chain() {
            sum += over_piece(&piece, &step, size, &f);
        }
        if end.0 > before.zeta {
            // Rings that touch on the way, their anchors on the path.
            let high = End { depth: end.0, root: end.0.sqrt(), anchor: end.1 };
            let low = End { depth: before.zeta, root: before.root, anchor: before.shift };
            let piece = Piece { low, high, bubble: V::default() };
            sum += over_piece(&piece, &step, size, &f);
        }
        sum
    }
}

/// The integral over the springs of a piece, parted at its middle and where slip begins.
fn over_piece<V: Lateral>(
    piece: &Piece<V>,
    step: &Step<V>,
    size: f64,
    f: &impl Fn(&Step<V>, f64, V) -> f64,
) -> f64 {
    let length = piece.high.depth - piece.low.depth;
    let Ok(tolerance) = Tolerance::new((OF_LARGEST * size).max(1e-300), RELATIVE) else {
        return 0.0; // not finite: refused before
    };
    if length <= 0.0 {
        return 0.0;
    }
    let low = piece.low.root;
    let at = |root: f64| {
        let part = ((root - low) * (root + low) / length).clamp(0.0, 1.0);
        1.5 * f(step, piece.depth_at(part), piece.at(part))
    };
    let excess = |part: f64| step.excess(piece.depth_at(part), piece.at(part));
    let mut marks = [0.0, 0.5, 1.0, 1.0, 1.0];
    let mut count = 3;
    for (from, to) in [(0.0, 0.5), (0.5, 1.0)] {
        if (excess(from) > 0.0) != (excess(to) > 0.0) {
            marks[count] = sign_change(&excess, from, to);
            count += 1;
        }
    }
    let marks = &mut marks[..count];
    marks.sort_by(f64::total_cmp);
    let root_at = |part: f64| piece.depth_at(part).sqrt();
    let integral = |ends: &[f64]| match adaptive(root_at(ends[0]), root_at(ends[1]), tolerance, at)
    {
        Ok(integral) | Err(QuadratureError::NotConverged { integral }) => integral.value,
        Err(_) => 0.0,
    };
    marks.windows(2).map(integral).sum()
}

fn sign_change(f: &impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> f64 {
    let beyond = f(to) > 0.0;
    for _ in 0..50 {
        let middle = 0.5 * (from + to);
        if (f(middle) > 0.0) == beyond { to = middle } else { from = middle }
    }
    0.5 * (from + to)
}
