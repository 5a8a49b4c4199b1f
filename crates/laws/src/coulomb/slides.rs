//! Coulomb's law with static friction above kinetic friction.

use super::{CoulombMemory, Node};
use crate::memory::{Lateral, MemoryRegime, NodeStack};
use crate::static_slip::{Slides, slides_by_own_names};

/// The annuli of a piece that are asked whether they slip.
const PARTS: [f64; 4] = [0.0, 0.25, 0.5, 0.75];

impl<V: Lateral, S: NodeStack<Node<V>>> Slides for CoulombMemory<V, S> {
    type V = V;
    type Stack = S;

    slides_by_own_names!();

    fn set_stage(&mut self, stage: MemoryRegime) {
        self.regime = stage;
        self.front = if stage == MemoryRegime::Sliding { 0.0 } else { self.front };
    }

    fn annuli(&self) -> impl Iterator<Item = (f64, V)> + '_ {
        self.chain().flat_map(|piece| {
            PARTS.map(|part| (piece.depth_at(part), self.shift.minus(piece.at(part))))
        })
    }

    fn shrink(&mut self, by: f64) {
        for i in 0..self.stack.len() {
            let node = self.stack.get_mut(i);
            let stretch = self.shift.minus(node.anchor);
            node.anchor = self.shift.minus(stretch.times(by));
            node.bubble = node.bubble.times(by);
            node.force = node.force.times(by);
            node.error *= by;
        }
        self.force = self.force.times(by);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coulomb::Tolerance;

    /// A contact whose shift turns by steps.
    fn turned() -> CoulombMemory<[f64; 2]> {
        let mut memory = CoulombMemory::new(Tolerance::PARTICLES);
        for step in 0..40 {
            let angle = 0.3 * f64::from(step);
            let zeta = 1.0 + 0.2 * (1.3 * angle).sin();
            memory.step(zeta, [0.6 * angle.cos(), 0.5 * angle.sin()]);
        }
        memory
    }

    #[test]
    fn a_shrunk_memory_has_its_share_of_force_error_and_energy() {
        let before = turned();
        let mut after = before.clone();
        after.shrink(0.5);
        let error = |memory: &CoulombMemory<[f64; 2]>| -> f64 {
            memory.chain().map(|piece| piece.force_error(memory.zeta)).sum()
        };
        assert!(error(&before) > 0.0);
        approx::assert_relative_eq!(error(&after), 0.5 * error(&before), max_relative = 1e-12);
        for axis in 0..2 {
            let [whole, half] = [&before, &after].map(|memory| memory.phi()[axis]);
            approx::assert_relative_eq!(half, 0.5 * whole, max_relative = 1e-12);
            let [whole, quarter] = [&before, &after].map(|memory| memory.elastic()[axis]);
            approx::assert_relative_eq!(quarter, 0.25 * whole, max_relative = 1e-12);
        }
    }

    #[test]
    fn all_annuli_of_a_sliding_contact_are_above_its_slip_front() {
        let mut memory = turned();
        assert!(memory.front > 0.0);
        memory.set_stage(MemoryRegime::Slip);
        assert!(memory.front > 0.0);
        memory.set_stage(MemoryRegime::Sliding);
        assert_eq!(memory.front, 0.0);
    }
}
