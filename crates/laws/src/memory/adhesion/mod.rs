//! The memory of a contact that never slips, the limit of infinite friction.

mod pack;

use carom_special::RangeError;

use super::energy::{flat_energy, spring_energy};
use super::merge::push;
use super::report::{Tangent, Turn};
use super::{Growing, Lateral, MemoryRegime, Vertex, VertexStack};
use crate::bounds::in_memory;
use crate::profile::{GAUSS, Hertzian, NormalProfile};

/// The load history of a contact without slip: the anchor of each annulus is the shift at which it
/// came into contact.
///
/// The anchor may be any function of the depth, also discontinuous: a shift at constant approach
/// moves all annuli. A receding edge releases its annuli, and their energy is lost. Shifts are
/// scaled so that full adhesion is `dPhi = F_z'(zeta) dX`; for Hertz `X = c_x xi`, `F = (2/3) Phi`.
///
/// ```
/// use carom_laws::memory::AdhesionMemory;
/// let mut memory = AdhesionMemory::<f64>::new();
/// memory.advance(4.0, 0.0)?;
/// assert_eq!(memory.advance(4.0, 1.0)?, 3.0); // (3/2) sqrt(4)
/// assert_eq!(memory.advance(1.0, 1.0)?, 1.5); // the outer rings let go
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AdhesionMemory<V, S = Growing<V>, P = Hertzian> {
    zeta: f64,
    shift: V,
    force: V,
    stack: S,
    profile: P,
}

impl<V: Lateral, S: VertexStack<V>> Default for AdhesionMemory<V, S> {
    fn default() -> Self {
        Self::new()
    }
}

impl<V: Lateral, S: VertexStack<V>> AdhesionMemory<V, S> {
    /// Two bodies at first contact, without shift.
    #[must_use]
    pub fn new() -> Self {
        Self::with_profile(Hertzian)
    }
}

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> AdhesionMemory<V, S, P> {
    /// Two bodies with another normal law at first contact, without shift.
    #[must_use]
    pub fn with_profile(profile: P) -> Self {
        let (shift, force) = (V::default(), V::default());
        Self { zeta: 0.0, shift, force, stack: S::default(), profile }
    }

    /// The approach.
    #[must_use]
    pub fn zeta(&self) -> f64 {
        self.zeta
    }

    /// The scaled shift X.
    #[must_use]
    pub fn shift(&self) -> V {
        self.shift
    }

    /// The force Phi.
    #[must_use]
    pub fn force(&self) -> V {
        self.force
    }

    pub(crate) fn stack(&self) -> &S {
        &self.stack
    }

    /// How often two segments were merged because the storage was full.
    #[must_use]
    pub fn merges(&self) -> u32 {
        self.stack.merges()
    }

    /// Advances on a straight path to a new approach and shift and returns the force Phi.
    ///
    /// # Errors
    /// [`RangeError`] for a value that is NaN or above 1e100 in magnitude; the state is then
    /// unchanged.
    pub fn advance(&mut self, zeta: f64, shift: V) -> Result<V, RangeError> {
        in_memory("zeta", zeta)?;
        let [x, y] = shift.components();
        in_memory("shift", x)?;
        in_memory("shift", y)?;
        self.step(zeta, shift);
        Ok(self.force)
    }

    /// A step whose arguments were checked.
    pub(crate) fn step(&mut self, zeta: f64, shift: V) {
        if zeta <= 0.0 {
            self.stack.truncate(0);
            self.force = V::default();
        } else {
            if self.stack.is_empty() {
                self.touch(zeta, shift);
            }
            self.reshape(zeta, shift);
            let top = self.stack.get(self.stack.len() - 1);
            let stretch = shift.minus(top.anchor_at(zeta));
            self.force =
                top.force_at(zeta, &self.profile).plus(stretch.times(self.profile.stiffness(zeta)));
        }
        (self.zeta, self.shift) = (zeta, shift);
    }

    fn touch(&mut self, zeta: f64, shift: V) {
        let part = self.zeta / (self.zeta - zeta);
        self.shift = self.shift.plus(shift.minus(self.shift).times(part));
        (self.zeta, self.force) = (0.0, V::default());
        let vertex = Vertex { anchor: self.shift, curb: 1.0, ..Vertex::default() };
        push(&mut self.stack, vertex, &self.profile);
    }

    fn reshape(&mut self, zeta: f64, shift: V) {
        let growth = zeta - self.zeta;
        if growth > 0.0 {
            let slope = shift.minus(self.shift).times(1.0 / growth);
            // A growth below the normal numbers has no inverse, and no force of its own.
            let slope = if slope.is_finite() { slope } else { V::default() };
            let vertex = Vertex {
                depth: self.zeta,
                anchor: self.shift,
                slope,
                force_slope: slope,
                force: self.force,
                curb: 1.0,
            };
            if self.zeta == 0.0 {
                self.stack.truncate(0);
            }
            push(&mut self.stack, vertex, &self.profile);
        }
        let mut len = self.stack.len();
        while len > 1 && self.stack.get(len - 1).depth >= zeta {
            len -= 1;
        }
        self.stack.truncate(len);
    }

    /// The elastic energy of the shift, conjugate to Phi and X, per direction.
    #[must_use]
    pub fn stored_energy(&self) -> V {
        self.energy_between(0.0, |_| self.shift)
    }

    /// The energy per direction that a straight step would release at a receding edge.
    ///
    /// Zero for arguments that are not finite.
    #[must_use]
    pub fn dissipation(&self, zeta: f64, shift: V) -> V {
        if !(zeta.is_finite() && shift.is_finite() && zeta < self.zeta) {
            return V::default();
        }
        // No rate: of the thinnest contacts it is infinite.
        let (way, thinned) = (shift.minus(self.shift), self.zeta - zeta);
        let at = |s: f64| self.shift.plus(way.times((self.zeta - s) / thinned));
        self.energy_between(zeta.max(0.0), at)
    }

    /// [`AdhesionMemory::dissipation`] in units of energy per direction.
    pub(crate) fn heat(&self, zeta: f64, shift: V, unit: V) -> f64 {
        self.dissipation(zeta, shift).dot(unit)
    }

    /// The work of the force in a straight step less the increase of the stored energy, in units of energy per
    /// direction: the heat, and what merged segments lose or gain.
    pub(crate) fn lost(&self, zeta: f64, shift: V, unit: V) -> f64 {
        let stack = &self.stack;
        if stack.capacity() == usize::MAX {
            return self.heat(zeta, shift, unit); // nothing is ever merged
        }
        let mut after = self.clone();
        after.step(zeta, shift);
        let has_merged = (0..stack.len()).any(|i| stack.get(i).force_slope != stack.get(i).slope);
        if !has_merged && after.merges() == self.merges() {
            return self.heat(zeta, shift, unit);
        }
        let gain = after.stored_energy().minus(self.stored_energy());
        self.work(zeta, shift).minus(gain).dot(unit)
    }

    /// The work of the force in a straight step of bodies in contact, per direction: between two vertices the force
    /// is smooth.
    fn work(&self, zeta: f64, shift: V) -> V {
        let (end, dz) = (zeta.max(0.0), zeta - self.zeta);
        let part_at = |depth: f64| if dz < 0.0 { (depth - self.zeta) / dz } else { 1.0 };
        let (mut work, mut from, last) = (V::default(), 0.0, part_at(end).min(1.0));
        let dx = shift.minus(self.shift);
        let force = |part: f64| {
            let mut there = self.clone();
            there.step(self.zeta + part * dz, self.shift.plus(dx.times(part)));
            there.force
        };
        let depths = (0..self.stack.len()).rev().map(|i| self.stack.get(i).depth);
        for to in depths.map(part_at).filter(|part| (0.0..last).contains(part)).chain([last]) {
            for (node, weight) in GAUSS {
                let at = force(from + node * (to - from));
                work = work.plus(at.by_component(dx).times(weight * (to - from)));
            }
            from = to;
        }
        work
    }

    /// The state of bodies in contact.
    pub(crate) const fn regime(&self) -> MemoryRegime {
        MemoryRegime::Adhesion
    }

    /// The share of the contact area that sticks.
    pub(crate) const fn stick_fraction(&self) -> f64 {
        1.0
    }

    /// The derivatives of the force as the step goes on without release: annuli that come into contact are not
    /// stretched at first. The last step itself, if the contact grew in it, is softer: its annuli shared the shift.
    pub(crate) fn tangent(&self) -> Tangent {
        let k = self.profile.stiffness(self.zeta.max(0.0));
        Tangent { by_shift: [[k, 0.0], [0.0, k]], by_approach: [0.0; 2] }
    }

    /// The energy of the annuli deeper than the edge and no deeper than `from`, if the shift of
    /// annulus s is `at(s)`, linear in s.
    fn energy_between(&self, from: f64, at: impl Fn(f64) -> V) -> V {
        let mut sum = V::default();
        let mut to = self.zeta;
        for i in (0..self.stack.len()).rev() {
            let segment = self.stack.get(i);
            let low = segment.depth.max(from);
            let ends = [low, to].map(|s| at(s).minus(segment.anchor_at(s)));
            sum = sum.plus(spring_energy(&self.profile, [low, to.max(low)], ends));
            to = segment.depth;
            if i == 0 && from <= 0.0 {
                sum = sum.plus(flat_energy(&self.profile, ends[0]));
            }
            if to <= from {
                break;
            }
        }
        sum
    }

    /// Moves the origin of the shifts: X and every anchor increase by `by`. Forces do not change.
    pub fn translate(&mut self, by: V) {
        self.shift = self.shift.plus(by);
        for i in 0..self.stack.len() {
            let vertex = self.stack.get_mut(i);
            vertex.anchor = vertex.anchor.plus(by);
        }
    }
}

impl<S: VertexStack<[f64; 2]>, P: NormalProfile> AdhesionMemory<[f64; 2], S, P> {
    /// Rotates the frame in the contact plane: all components are then given in axes rotated by
    /// `angle` (radians, counterclockwise).
    pub fn turn_frame(&mut self, angle: f64) {
        let turn = Turn::by(angle);
        self.shift = turn.of(self.shift);
        self.force = turn.of(self.force);
        for i in 0..self.stack.len() {
            turn.vertex(self.stack.get_mut(i));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_growth_gives_no_nan() {
        let mut memory = AdhesionMemory::<f64>::new();
        for zeta in [2.6e-309, 5e-309, 1.0] {
            assert!(memory.advance(zeta, 0.0).unwrap() == 0.0, "{zeta}");
        }
        assert!(memory.advance(1.0, 0.1).unwrap() > 0.0);
    }

    /// The rate of the shift was infinite, and times no way not a number.
    #[test]
    fn the_thinnest_contact_releases_a_number() {
        for (zeta, shift) in [(6e-312, 0.01), (1e-320, 1.0), (1e-250, 1e60)] {
            let mut memory = AdhesionMemory::<f64>::new();
            memory.advance(zeta, shift).unwrap();
            memory.advance(zeta, 0.0).unwrap();
            let released = memory.dissipation(0.0, 0.0);
            let stored = memory.stored_energy();
            assert!(released >= 0.0 && (released - stored).abs() <= 1e-9 * stored, "{released:e}");
            assert!(memory.dissipation(0.0, shift).is_finite());
        }
    }

    #[test]
    fn the_tangent_is_that_of_a_step_that_goes_on() {
        let mut memory = AdhesionMemory::<[f64; 2]>::new();
        for (zeta, x) in [(1.0, [0.1, 0.0]), (1.3, [0.4, 0.2]), (1.3, [0.1, 0.9])] {
            memory.advance(zeta, x).unwrap();
            let (tangent, force, h) = (memory.tangent(), memory.force(), 1e-6);
            let rate = |growth: f64, dx: [f64; 2]| {
                let mut on = memory.clone();
                let on = on.advance(zeta + growth, [x[0] + dx[0], x[1] + dx[1]]).unwrap();
                [0, 1].map(|i| (on[i] - force[i]) / h)
            };
            for i in [0, 1] {
                assert!((rate(h, [0.0; 2])[i] - tangent.by_approach[i]).abs() < 1e-5);
                assert!((rate(h, [h, 0.0])[i] - tangent.by_shift[i][0]).abs() < 1e-5);
                assert!((rate(0.0, [0.0, h])[i] - tangent.by_shift[i][1]).abs() < 1e-5);
            }
        }
    }
}
