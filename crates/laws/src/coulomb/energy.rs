//! Stored elastic energy, heat and work of a step, and the energy error of fitting and joining.

use carom_special::quadrature::{QuadratureError, Tolerance, adaptive};
use carom_special::roots::bisect;

use super::drag::Step;
use super::piece::{End, Piece};
use super::{CoulombMemory, Node, Regime};
use crate::bounds::in_memory;
use crate::memory::{Lateral, NodeStack};
use crate::profile::GAUSS;
use crate::work_by_forces::work_by_forces;

/// Largest error of an integral over the annuli: relative, and over the energy at the largest
/// stretch.
const MAX_RELATIVE_ERROR: f64 = 1e-13;
const MAX_ERROR_PER_ENERGY: f64 = 1e-16;
/// Number of parts of a piece in which the beginning of slip is sought.
const SLIP_SAMPLES: usize = 8;

impl<V: Lateral> Piece<V> {
    /// The elastic energy of its annuli at a shift, per direction: `(3/4) int |X - W(t^2)|^2 dt`, a
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

/// Is called at the stages of a step.
pub(super) trait StepObserver<V> {
    /// The return mapping is complete; nothing is joined yet.
    fn fitted(&mut self, chain: impl Iterator<Item = Piece<V>>, shift: V);
    /// One piece replaces two, at a shift.
    fn joined(&mut self, two: [&Piece<V>; 2], merged: &Piece<V>, shift: V);
}

/// Ignores all calls.
pub(super) struct NoObserver;

impl<V> StepObserver<V> for NoObserver {
    #[inline]
    fn fitted(&mut self, _: impl Iterator<Item = Piece<V>>, _: V) {}

    #[inline]
    fn joined(&mut self, _: [&Piece<V>; 2], _: &Piece<V>, _: V) {}
}

/// The elastic energy of the fitted pieces, and the energy that joins add to it.
struct EnergyChange {
    fitted: Option<f64>,
    joined: f64,
}

impl<V: Lateral> StepObserver<V> for EnergyChange {
    fn fitted(&mut self, chain: impl Iterator<Item = Piece<V>>, shift: V) {
        let unit = V::from_components([1.0, 1.0]);
        self.fitted = Some(chain.map(|piece| piece.energy(shift).dot(unit)).sum());
    }

    fn joined(&mut self, [below, above]: [&Piece<V>; 2], merged: &Piece<V>, shift: V) {
        let unit = V::from_components([1.0, 1.0]);
        let two = below.energy(shift).plus(above.energy(shift));
        self.joined += merged.energy(shift).minus(two).dot(unit);
    }
}

/// Counts joins.
struct Joins(u32);

impl<V> StepObserver<V> for Joins {
    fn fitted(&mut self, _: impl Iterator<Item = Piece<V>>, _: V) {}

    fn joined(&mut self, _: [&Piece<V>; 2], _: &Piece<V>, _: V) {
        self.0 += 1;
    }
}

impl<V: Lateral, S: NodeStack<Node<V>>> CoulombMemory<V, S> {
    /// The elastic energy of the tangential shift per direction, `(3/4) int |X - W(t^2)|^2 dt`,
    /// conjugate to Phi and X.
    #[must_use]
    pub fn stored_energy(&self) -> V {
        self.chain().fold(V::default(), |sum, piece| sum.plus(piece.energy(self.shift)))
    }

    /// The heat of friction per direction in a straight step to a new approach and shift, conjugate
    /// to Phi and X.
    ///
    /// It is the integral of traction times slip over the annuli and the path, by quadrature; it is
    /// not negative. The state does not change. Arguments that are not finite give zero.
    #[must_use]
    pub fn dissipation(&self, zeta: f64, shift: V) -> V {
        let along = |weight| self.heat(zeta, shift, V::from_components(weight));
        V::from_components([along([1.0, 0.0]), along([0.0, 1.0])])
    }

    /// The work of the force in a straight step to a new approach and shift, summed over the annuli
    /// by quadrature; conjugate to Phi and X.
    #[must_use]
    pub fn work(&self, zeta: f64, shift: V) -> f64 {
        let unit = V::from_components([1.0, 1.0]);
        self.over_annuli(zeta, shift, unit, |step, depth, anchor| step.work(depth, anchor, unit))
    }

    /// The work of the force less the increase of [`CoulombMemory::stored_energy`], in the given units of energy per
    /// direction: the heat, and what fitting and joining parabolas loses or gains. Zero in adhesion in which nothing is
    /// joined. In small steps the work is that of the forces within the step, in others [`CoulombMemory::work`].
    pub(crate) fn lost(&self, zeta: f64, shift: V, unit: V) -> f64 {
        if !zeta.is_finite() || !shift.is_finite() {
            return 0.0;
        }
        let (mut after, mut joins) = (self.clone(), Joins(0));
        after.step_observed(zeta, shift, &mut joins);
        let joins = joins.0 > 0 || after.stack.merges() != self.stack.merges();
        if after.regime == Regime::Adhesion && !joins {
            return 0.0;
        }
        let by_forces = match self.stack.is_empty() || zeta <= 0.0 {
            true => None, // contact begins or ends
            false => work_by_forces(
                [self.force, after.force],
                shift.minus(self.shift).by_component(unit),
                |time| {
                    let mut part = self.clone();
                    let way = shift.minus(self.shift).times(time);
                    part.step(self.zeta + time * (zeta - self.zeta), self.shift.plus(way));
                    part.force
                },
            ),
        };
        let work = by_forces.unwrap_or_else(|| {
            self.over_annuli(zeta, shift, unit, |step, depth, anchor| {
                step.work(depth, anchor, unit)
            })
        });
        work - after.stored_energy().minus(self.stored_energy()).dot(unit)
    }

    /// The energy that fitting parabolas and joining them adds in a step, with its sign.
    ///
    /// Work is the increase of [`CoulombMemory::stored_energy`], less this, plus the heat. It
    /// vanishes with the tolerance. In full storage it includes the merges for lack of room.
    #[must_use]
    pub fn joined_energy(&self, zeta: f64, shift: V) -> f64 {
        if in_memory("zeta", zeta).is_err() || !shift.is_finite() {
            return 0.0;
        }
        let unit = V::from_components([1.0, 1.0]);
        let (mut after, mut change) = (self.clone(), EnergyChange { fitted: None, joined: 0.0 });
        after.step_observed(zeta, shift, &mut change);
        let fitted =
            change.fitted.unwrap_or_else(|| after.stored_energy().dot(unit) - change.joined);
        fitted - self.exact_energy(zeta, shift) + change.joined
    }

    /// The scalar product of [`CoulombMemory::dissipation`] and the energies `unit`.
    pub(crate) fn heat(&self, zeta: f64, shift: V, unit: V) -> f64 {
        self.over_annuli(zeta, shift, unit, |step, depth, anchor| step.heat(depth, anchor, unit))
    }

    /// The elastic energy after a step if the return mapping is exact for every annulus.
    fn exact_energy(&self, zeta: f64, shift: V) -> f64 {
        let unit = V::from_components([1.0, 1.0]);
        self.over_annuli(zeta, shift, unit, |step, depth, anchor| {
            if depth >= step.zeta {
                return 0.0;
            }
            let stretch = step.shift.minus(step.drag(depth, anchor));
            0.5 * stretch.dot(stretch)
        })
    }

    /// The integral of the energy `f`, in the given units per direction, over all annuli that are in contact at some
    /// time of the step, `int F'' f ds`.
    fn over_annuli(
        &self,
        zeta: f64,
        shift: V,
        unit: V,
        f: impl Fn(&Step<V>, f64, V) -> f64,
    ) -> f64 {
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
        let [unit_x, unit_y] = unit.components().map(f64::abs);
        let size = before.zeta.max(end.0).sqrt() * stretch * stretch * unit_x.max(unit_y);
        let mut sum = 0.0;
        for piece in before.chain() {
            sum += over_piece(&piece, &step, size, &f);
        }
        if end.0 > before.zeta {
            // Annuli that come into contact during the step: W lies on the path.
            let high = End { depth: end.0, root: end.0.sqrt(), anchor: end.1 };
            let low = End { depth: before.zeta, root: before.root, anchor: before.shift };
            let piece = Piece { low, high, bubble: V::default(), error: 0.0 };
            sum += over_piece(&piece, &step, size, &f);
        }
        sum
    }
}

/// The integral over the annuli of a piece, divided at its middle, at the annulus that separates at
/// the end of the step, and at kinks: where annuli reach their limit in the step, are beyond it
/// before, because W is inaccurate, or graze it.
fn over_piece<V: Lateral>(
    piece: &Piece<V>,
    step: &Step<V>,
    size: f64,
    f: &impl Fn(&Step<V>, f64, V) -> f64,
) -> f64 {
    let length = piece.high.depth - piece.low.depth;
    let Ok(tolerance) =
        Tolerance::new((MAX_ERROR_PER_ENERGY * size).max(1e-300), MAX_RELATIVE_ERROR)
    else {
        return 0.0; // not finite: already rejected
    };
    if length <= 0.0 {
        return 0.0;
    }
    let low = piece.low.root;
    let at = |root: f64| {
        let part = ((root - low) * (root + low) / length).clamp(0.0, 1.0);
        1.5 * f(step, piece.depth_at(part), piece.at(part))
    };
    if piece.sticks(step) {
        // A polynomial of degree 8 at most.
        let [from, width] = [low, piece.high.root - low];
        return GAUSS.iter().map(|(part, weight)| weight * at(from + part * width)).sum::<f64>()
            * width;
    }
    let excess = |part: f64| step.excess(piece.depth_at(part), piece.at(part));
    let before = |part: f64| step.excess_before(piece.depth_at(part), piece.at(part));
    let grazes = |part: f64| f64::from(step.grazes(piece.depth_at(part), piece.at(part)));
    // Half the derivatives of both by the fraction.
    let rate = |zeta: f64, shift: V| {
        move |part: f64| {
            let limit = (zeta - piece.depth_at(part)).abs();
            limit * length - shift.minus(piece.at(part)).dot(piece.rate(part))
        }
    };
    let start = step.shift.minus(step.ahead.times(step.length));
    let [rate, rate_before] = [rate(step.zeta, step.shift), rate(step.zeta - step.dz, start)];
    // The annulus that separates at the end of the step lies between separated ones and those in
    // contact.
    let parts = ((step.zeta - piece.low.depth) / length).clamp(0.0, 1.0);
    let mut marks = Marks::new(parts);
    for [from, to] in sample_intervals(0.0, 1.0) {
        // A zone of slip or stick may be narrower than a part; the excess then has an extremum
        // there.
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
            for [from, to] in sample_intervals(low, high) {
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

/// The fractions of a piece at which the integrand has kinks, in ascending order from 0 to 1.
#[derive(Clone)]
struct Marks {
    at: [f64; 8 * SLIP_SAMPLES],
    count: usize,
}

impl Marks {
    /// Both ends, the middle, and one more fraction.
    fn new(part: f64) -> Self {
        let mut marks = Self { at: [1.0; 8 * SLIP_SAMPLES], count: 2 };
        marks.at[0] = 0.0;
        marks.add(Some(0.5));
        marks.add(Some(part));
        marks
    }

    /// Adds a fraction if there is room.
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
fn sample_intervals(from: f64, to: f64) -> impl Iterator<Item = [f64; 2]> {
    let at = move |sample: usize| from + (to - from) * (sample as f64 / SLIP_SAMPLES as f64);
    (0..SLIP_SAMPLES).map(move |sample| [at(sample), at(sample + 1)])
}

/// Where a function changes its sign between two points, if its signs there differ.
fn kink(f: &impl Fn(f64) -> f64, from: f64, to: f64) -> Option<f64> {
    let beyond = f(to) > 0.0;
    if (f(from) > 0.0) == beyond {
        return None;
    }
    Some(bisect([from, to], 50, |part| (f(part) > 0.0) != beyond)[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coulomb::{FixedCurve, Tolerance};

    /// Steps in adhesion that find no room for their piece merge two others: their work is not all stored.
    #[test]
    fn merges_for_lack_of_room_count_as_loss() {
        let mut memory = CoulombMemory::<[f64; 2], FixedCurve<[f64; 2], 4>>::new(Tolerance::FINE);
        let (mut shift, mut merged) = ([0.0; 2], 0);
        for step in 1..60 {
            let angle = 2.3 * f64::from(step);
            let zeta = 0.1 * f64::from(step);
            shift = shift.plus([angle.cos(), angle.sin()].times(0.08));
            let (lost, work) = (memory.lost(zeta, shift, [1.0; 2]), memory.work(zeta, shift));
            let (stored, merges) = (memory.stored_energy(), memory.stack.merges());
            memory.step(zeta, shift);
            assert_eq!(memory.regime, Regime::Adhesion);
            let expected = work - memory.stored_energy().minus(stored).dot([1.0; 2]);
            let off = (lost - expected).abs();
            assert!(off <= 1e-3 * expected.abs() + 1e-12 * work.abs(), "{step}: {lost} {expected}");
            merged += usize::from(memory.stack.merges() > merges && expected.abs() > 1e-9 * work);
        }
        assert!(merged > 10, "{merged}");
    }
}
