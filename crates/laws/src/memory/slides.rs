//! The memory of chapters 6 and 7 with static friction above kinetic friction.

use super::{Lateral, Memory, MemoryRegime, VertexStack};
use crate::profile::Hertzian;
use crate::static_slip::{Slides, slides_by_own_names};

impl<V: Lateral, S: VertexStack<V>> Slides for Memory<V, S, Hertzian> {
    type V = V;
    type Stack = S;

    slides_by_own_names!();

    fn set_stage(&mut self, stage: MemoryRegime) {
        self.regime = stage;
    }

    // No slope of the polyline exceeds that of the cone, so that the centre is the last to slip. In
    // sliding all annuli have one direction.
    fn annuli(&self) -> impl Iterator<Item = (f64, V)> + '_ {
        std::iter::once((0.0, self.shift.minus(self.slide_offset())))
    }

    fn shrink(&mut self, by: f64) {
        for i in 0..self.stack.len() {
            let vertex = self.stack.get_mut(i);
            let stretch = self.shift.minus(vertex.anchor);
            vertex.anchor = self.shift.minus(stretch.times(by));
            vertex.slope = vertex.slope.times(by);
            vertex.force_slope = vertex.force_slope.times(by);
            vertex.force = vertex.force.times(by);
            vertex.curb = (1.0 - vertex.slope.dot(vertex.slope)).max(0.0);
        }
        self.force = self.force.times(by);
    }
}
