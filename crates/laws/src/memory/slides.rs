//! The memory of chapters 6 and 7 with static friction above kinetic friction.

use carom_special::RangeError;

use super::{Lateral, Memory, MemoryRegime, Tangent, VertexStack};
use crate::profile::Hertzian;
use crate::static_slip::Slides;

impl<V: Lateral, S: VertexStack<V>> Slides for Memory<V, S, Hertzian> {
    type V = V;
    type Stack = S;

    fn approach(&self) -> f64 {
        self.zeta
    }

    fn place(&self) -> V {
        self.shift
    }

    fn phi(&self) -> V {
        self.force
    }

    fn rates(&self) -> Tangent {
        self.tangent()
    }

    fn stage(&self) -> MemoryRegime {
        self.regime
    }

    fn set_stage(&mut self, stage: MemoryRegime) {
        self.regime = stage;
    }

    fn is_in_contact(&self) -> bool {
        self.is_touching()
    }

    fn vertices(&self) -> &S {
        &self.stack
    }

    fn stick_share(&self) -> f64 {
        self.stick_fraction()
    }

    fn begin(&mut self, zeta: f64, shift: V) {
        self.touch(zeta, shift);
    }

    fn go(&mut self, zeta: f64, shift: V) {
        self.step(zeta, shift);
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

    fn move_by(&mut self, by: V) {
        self.translate(by);
    }

    fn elastic(&self) -> V {
        self.stored_energy()
    }

    fn heat_of(&self, zeta: f64, shift: V, unit: V) -> f64 {
        self.heat(zeta, shift, unit)
    }

    fn loss_of(&self, zeta: f64, shift: V, unit: V) -> f64 {
        self.lost(zeta, shift, unit)
    }

    fn traction_at(&self, q: f64) -> V {
        self.traction(q)
    }

    fn write(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        self.pack(numbers)
    }

    fn read(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        self.unpack(numbers)
    }
}
