//! The heat of a step with static friction above kinetic friction.

use super::{LONGEST_PATH, Leg, Slides, StaticMemory};
use crate::bounds::LEAST_APPROACH;
use crate::memory::Lateral;
use crate::profile::{GAUSS, Hertzian, NormalProfile as _};

impl<M: Slides> StaticMemory<M> {
    /// The heat of a straight step, in the given units of energy per direction: that of slip with
    /// f_s, what the springs lose where the force drops, and that of sliding with f_k.
    pub(crate) fn heat(&self, zeta: f64, shift: M::V, unit: M::V) -> f64 {
        self.over_legs(zeta, shift, unit, |memory, zeta, to| memory.heat_of(zeta, to, unit))
    }

    /// [`StaticMemory::heat`], and what simplifying the memory loses or gains.
    pub(crate) fn lost(&self, zeta: f64, shift: M::V, unit: M::V) -> f64 {
        self.over_legs(zeta, shift, unit, |memory, zeta, to| memory.loss_of(zeta, to, unit))
    }

    /// The sum over the legs of a straight step; `lost` is what a step with one coefficient loses.
    fn over_legs(
        &self,
        zeta: f64,
        shift: M::V,
        unit: M::V,
        lost: impl Fn(&M, f64, M::V) -> f64,
    ) -> f64 {
        let from = self.zeta();
        if !zeta.is_finite() || !shift.is_finite() || (from <= 0.0 && zeta <= 0.0) {
            return 0.0;
        }
        // Of a step that separates the bodies, the part in contact.
        let part = if zeta < 0.0 { from / (from - zeta) } else { 1.0 };
        let (zeta, shift) = match zeta < 0.0 {
            true => (0.0, self.at(part, zeta, shift).1),
            false => (zeta, shift),
        };
        let mut heat = 0.0;
        self.clone().follow(zeta, shift, |memory, leg| {
            heat += memory.heat_of_leg(leg, (zeta, shift), unit, &lost);
        });
        heat
    }

    fn heat_of_leg(
        &self,
        leg: Leg,
        (zeta, shift): (f64, M::V),
        unit: M::V,
        lost: &impl Fn(&M, f64, M::V) -> f64,
    ) -> f64 {
        match leg {
            Leg::Within => lost(&self.memory, zeta, shift),
            Leg::Slide => self.heat_of_sliding((zeta, shift), unit, lost),
            Leg::Rise { onset } => {
                let (at, place) = self.at(onset, zeta, shift);
                let mut full = self.memory.clone();
                if at > LEAST_APPROACH {
                    full.go(at, place);
                }
                let drop = (1.0 - self.ratio) * (1.0 + self.ratio) * full.elastic().dot(unit);
                lost(&self.memory, at, place) + drop
            }
        }
    }

    /// Sliding: first until all tractions are aligned with the path, then along it.
    fn heat_of_sliding(
        &self,
        (zeta, shift): (f64, M::V),
        unit: M::V,
        lost: &impl Fn(&M, f64, M::V) -> f64,
    ) -> f64 {
        let (from, dx) = (self.zeta(), shift.minus(self.shift()));
        let (length, path) = (dx.length(), self.path(zeta, shift));
        let longest = LONGEST_PATH * from.max(zeta) * self.ratio;
        let part = if length > longest { longest / length } else { 1.0 };
        let at = from + part * (zeta - from);
        let square = self.ratio * self.ratio;
        let turning = match square > 0.0 {
            true => square * lost(&self.memory, at, self.shift().plus(path)),
            false => 0.0,
        };
        if part == 1.0 {
            return turning;
        }
        let ahead = dx.times(1.0 / length);
        let slip = ((1.0 - part) * (length - self.ratio * (zeta - from))).max(0.0);
        let energy = ahead.by_component(ahead).dot(unit);
        turning + self.ratio * slip * mean_force(at, zeta) * energy
    }
}

/// The mean of Hertz's normal force over a range of approaches.
fn mean_force(from: f64, to: f64) -> f64 {
    let length = to - from;
    if length.abs() > 0.1 * from.max(to) {
        return (Hertzian.energy(to) - Hertzian.energy(from)) / length;
    }
    let at = |part: f64| Hertzian.force(from + part * length);
    GAUSS.iter().fold(0.0, |sum, &(part, weight)| sum + weight * at(part))
}
