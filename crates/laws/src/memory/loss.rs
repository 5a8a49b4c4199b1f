//! The energy that a step loses, also where the storage is full.
//!
//! One segment that replaces two carries the same force, but stores another elastic energy, and later
//! forces are not the derivative of this energy. The heat of slip then misses a part of the balance.
//! The loss does not: it is the work of the force less the increase of the stored energy.

use carom_special::quadrature::{QuadratureError, Tolerance, adaptive};

use super::energy::Path;
use super::slip_in_plane::Edge;
use super::{Lateral, Memory, VertexStack};
use crate::profile::{GAUSS, NormalProfile};
use crate::work_by_forces::work_by_forces;

/// Allowed error of the work of a part of the step, relative to it, and over friction limit times motion.
const ERROR_OF_PART: f64 = 1e-12;
const ERROR_OF_LIMIT: f64 = 1e-14;

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Memory<V, S, P> {
    /// The work of the force in a straight step less the increase of the stored energy, in the given units of energy
    /// per direction. It is the scalar product of [`Memory::dissipation`] and the units unless segments of a
    /// [`super::Fixed`] stack were merged, in the step or before; then it may be negative. The state does not change.
    ///
    /// Zero for arguments that are not finite.
    #[must_use]
    pub fn loss(&self, zeta: f64, shift: V, unit: V) -> f64 {
        if !(zeta.is_finite() && shift.is_finite()) {
            return 0.0;
        }
        if self.stack.capacity() == usize::MAX {
            return self.heat(zeta, shift, unit); // nothing is ever merged
        }
        let mut after = self.clone();
        after.step(zeta, shift);
        if !self.has_merged() && after.stack.merges() == self.stack.merges() {
            return self.heat(zeta, shift, unit);
        }
        let gain = after.stored_energy().minus(self.stored_energy());
        self.work(zeta, shift, unit) - gain.dot(unit)
    }

    /// [`Memory::loss`]; in small steps, whose forces have no kink, with the work of the forces within the step.
    pub(crate) fn lost(&self, zeta: f64, shift: V, unit: V) -> f64 {
        if !(zeta.is_finite() && shift.is_finite()) {
            return 0.0;
        }
        let (dz, dx) = (zeta - self.zeta, shift.minus(self.shift));
        let adheres = dz > 0.0 && dx.dot(dx) <= dz * dz;
        let begins_or_ends = self.stack.is_empty() || zeta <= 0.0;
        let merges = self.stack.capacity() < usize::MAX;
        if V::DIMENSION == 1 || !merges || adheres || begins_or_ends {
            return self.loss(zeta, shift, unit);
        }
        let after = |time: f64| {
            let mut after = self.clone();
            after.step(self.zeta + time * dz, self.shift.plus(dx.times(time)));
            after
        };
        let end = after(1.0);
        let way = dx.by_component(unit);
        let work = work_by_forces([self.force, end.force], way, |time| after(time).force);
        let gain = || end.stored_energy().minus(self.stored_energy()).dot(unit);
        work.map_or_else(|| self.loss(zeta, shift, unit), |work| work - gain())
    }

    /// Whether a segment stands for several.
    fn has_merged(&self) -> bool {
        (0..self.stack.len()).any(|i| {
            let vertex = self.stack.get(i);
            vertex.force_slope != vertex.slope
        })
    }

    /// The work of the force in a straight step.
    fn work(&self, zeta: f64, shift: V, unit: V) -> f64 {
        let path = self.path_in_contact(zeta, shift);
        let lever = path.dx.by_component(unit);
        if path.dz > 0.0 && path.dx.dot(path.dx) <= path.dz * path.dz {
            let slope = path.dx.times(1.0 / path.dz);
            let force = |part: f64| {
                self.force.plus(slope.times(self.profile.growth(path.zeta, part * path.dz)))
            };
            return GAUSS.iter().map(|&(part, weight)| weight * force(part).dot(lever)).sum();
        }
        let mut work = 0.0;
        self.parts_of(&path, |part, edge| work += self.work_of_part(&path, lever, part, edge));
        work
    }

    /// The work of a part of the step, with a substitution that removes square roots at both ends.
    fn work_of_part(&self, path: &Path<V>, lever: V, [from, to]: [f64; 2], edge: &Edge<V>) -> f64 {
        let span = to - from;
        let largest = self.profile.force(path.zeta.max(path.end)) * lever.length();
        let Ok(tolerance) = Tolerance::new(ERROR_OF_LIMIT * largest, ERROR_OF_PART) else {
            return 0.0; // no motion
        };
        if span <= 0.0 {
            return 0.0;
        }
        let rate = |v: f64| {
            let t = from + span * v * v * (3.0 - 2.0 * v);
            self.force_at_edge(path, edge, t).dot(lever) * (6.0 * v * (1.0 - v))
        };
        match adaptive(0.0, 1.0, tolerance, rate) {
            // The remaining error is rounding.
            Ok(integral) | Err(QuadratureError::NotConverged { integral }) => span * integral.value,
            Err(_) => 0.0, // not finite: refused before
        }
    }

    /// The force at a time of the step.
    fn force_at_edge(&self, path: &Path<V>, edge: &Edge<V>, t: f64) -> V {
        let (ring, zeta) = (edge.ring(path, t), path.depth(t).max(0.0));
        match (edge, ring.width) {
            (Edge::On(line), Some(width)) => {
                let depth = (zeta - width).max(0.0);
                let inner = line.base.force_at(depth, &self.profile);
                match zeta - depth > 0.0 {
                    true => inner.plus(ring.slope.times(self.profile.growth(depth, zeta - depth))),
                    false => inner,
                }
            }
            _ => ring.slope.times(self.profile.force(zeta)),
        }
    }
}
