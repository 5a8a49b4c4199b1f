//! Elastic energy kept in the memory, energy dissipated by a step, and what joins change.

use carom_special::quadrature::{QuadratureError, Tolerance, adaptive};
use carom_special::roots::bisect;

use super::CoulombMemory;
use super::drag::Step;
use super::piece::{End, Piece};
use crate::bounds::in_memory;
use crate::memory::{Lateral, VertexStack};
use crate::profile::GAUSS;

/// The error allowed to an integral over the rings, relative and over the energy of the largest
/// stretch.
const RELATIVE: f64 = 1e-13;
const OF_LARGEST: f64 = 1e-16;
/// In how many parts of a piece it is looked for where slip begins.
const LOOKS: usize = 8;

impl<V: Lateral> Piece<V> {
    /// The elastic energy of its rings at a shift, per direction: `(3/4) int |X - W(t^2)|^2 dt`, a
    /// polynomial of degree 8 in t.
    pub(super) fn energy(&self, shift: V) -> V {
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

/// What is told about a step by the way.
pub(super) trait Notes<V> {
    /// The rings were dragged and drawn; nothing is joined yet.
    fn drawn(&mut self, chain: impl Iterator<Item = Piece<V>>, shift: V);
    /// A piece takes the place of two, at a shift.
    fn joined(&mut self, two: [&Piece<V>; 2], one: &Piece<V>, shift: V);
}

/// Nothing is noted.
pub(super) struct Unnoted;

impl<V> Notes<V> for Unnoted {
    #[inline]
    fn drawn(&mut self, _: impl Iterator<Item = Piece<V>>, _: V) {}

    #[inline]
    fn joined(&mut self, _: [&Piece<V>; 2], _: &Piece<V>, _: V) {}
}

/// The elastic energy of the rings as drawn, and what joins add to it.
struct Book {
    drawn: Option<f64>,
    joined: f64,
}

impl<V: Lateral> Notes<V> for Book {
    fn drawn(&mut self, chain: impl Iterator<Item = Piece<V>>, shift: V) {
        let unit = V::from_components([1.0, 1.0]);
        self.drawn = Some(chain.map(|piece| piece.energy(shift).dot(unit)).sum());
    }

    fn joined(&mut self, [below, above]: [&Piece<V>; 2], one: &Piece<V>, shift: V) {
        let unit = V::from_components([1.0, 1.0]);
        let two = below.energy(shift).plus(above.energy(shift));
        self.joined += one.energy(shift).minus(two).dot(unit);
    }
}

impl<V: Lateral, S: VertexStack<V>> CoulombMemory<V, S> {
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

    /// The work of the force in the straight step to a new approach and shift, of each ring by
    /// itself, by quadrature; conjugate to Phi and X.
    #[must_use]
    pub fn work(&self, zeta: f64, shift: V) -> f64 {
        self.over_rings(zeta, shift, Step::work)
    }

    /// The energy that drawing parabolas through the dragged rings, and joining them, adds in a
    /// step, with its sign: work is the growth of [`CoulombMemory::stored_energy`], less this, and
    /// the heat. It vanishes with the tolerance. In storage that is full it has that of the joins
    /// for want of room.
    #[must_use]
    pub fn joined_energy(&self, zeta: f64, shift: V) -> f64 {
        if in_memory("zeta", zeta).is_err() || !shift.is_finite() {
            return 0.0;
        }
        let unit = V::from_components([1.0, 1.0]);
        let (mut after, mut book) = (self.clone(), Book { drawn: None, joined: 0.0 });
        after.step_noted(zeta, shift, &mut book);
        let drawn = book.drawn.unwrap_or_else(|| after.stored_energy().dot(unit) - book.joined);
        drawn - self.exact_energy(zeta, shift) + book.joined
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
            let piece = Piece { low, high, bubble: V::default(), error: 0.0 };
            sum += over_piece(&piece, &step, size, &f);
        }
        sum
    }
}

/// The integral over the springs of a piece, parted at its middle, at the ring that parts at the end,
/// and where rings come beyond their limit in the step or, as they were drawn, are so before it, or
/// graze it.
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
    let before = |part: f64| step.excess_before(piece.depth_at(part), piece.at(part));
    let grazes = |part: f64| f64::from(step.grazes(piece.depth_at(part), piece.at(part)));
    // The derivatives of both by the part, halved.
    let rate = |zeta: f64, shift: V| {
        move |part: f64| {
            let limit = (zeta - piece.depth_at(part)).abs();
            limit * length - shift.minus(piece.at(part)).dot(piece.rate(part))
        }
    };
    let start = step.shift.minus(step.ahead.times(step.length));
    let [rate, rate_before] = [rate(step.zeta, step.shift), rate(step.zeta - step.dz, start)];
    // The ring that parts at the end is between those that do before and those that stay.
    let parts = ((step.zeta - piece.low.depth) / length).clamp(0.0, 1.0);
    let mut marks = Marks::new(parts);
    for [from, to] in looks(0.0, 1.0) {
        // A zone that slips or sticks may be narrower than a look: it has an extreme.
        let top = kink(&rate, from, to).unwrap_or(to);
        let top_before = kink(&rate_before, from, to).unwrap_or(to);
        marks.add(kink(&excess, from, top));
        marks.add(kink(&excess, top, to));
        marks.add(kink(&before, from, top_before));
        marks.add(kink(&before, top_before, to));
    }
    for [low, high] in marks.clone().intervals() {
        let middle = 0.5 * (low + high);
        if excess(middle) > 0.0 && before(middle) > 0.0 {
            for [from, to] in looks(low, high) {
                marks.add(kink(&grazes, from, to));
            }
        }
    }
    let root_at = |part: f64| piece.depth_at(part).sqrt();
    let integral =
        |ends: [f64; 2]| match adaptive(root_at(ends[0]), root_at(ends[1]), tolerance, at) {
            Ok(integral) | Err(QuadratureError::NotConverged { integral }) => integral.value,
            Err(_) => 0.0,
        };
    marks.intervals().map(integral).sum()
}

/// The parts of a piece at which an integrand has kinks, in order from 0 to 1.
#[derive(Clone)]
struct Marks {
    at: [f64; 8 * LOOKS],
    count: usize,
}

impl Marks {
    /// Both ends, the middle, and one more.
    fn new(part: f64) -> Self {
        let mut marks = Self { at: [1.0; 8 * LOOKS], count: 2 };
        marks.at[0] = 0.0;
        marks.add(Some(0.5));
        marks.add(Some(part));
        marks
    }

    /// Adds one, while there is room.
    fn add(&mut self, mark: Option<f64>) {
        if let Some(mark) = mark
            && self.count < self.at.len()
        {
            let place = self.at[..self.count].partition_point(|at| *at < mark);
            self.at[place..=self.count].rotate_right(1);
            self.at[place] = mark;
            self.count += 1;
        }
    }

    fn intervals(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.at[..self.count].windows(2).map(|ends| [ends[0], ends[1]])
    }
}

/// Equal parts of an interval.
fn looks(from: f64, to: f64) -> impl Iterator<Item = [f64; 2]> {
    let at = move |look: usize| from + (to - from) * (look as f64 / LOOKS as f64);
    (0..LOOKS).map(move |look| [at(look), at(look + 1)])
}

/// Where a function changes its sign between two places, if it has two signs there.
fn kink(f: &impl Fn(f64) -> f64, from: f64, to: f64) -> Option<f64> {
    let beyond = f(to) > 0.0;
    if (f(from) > 0.0) == beyond {
        return None;
    }
    Some(bisect([from, to], 50, |part| (f(part) > 0.0) != beyond)[1])
}
