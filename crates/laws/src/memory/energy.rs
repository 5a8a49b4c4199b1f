//! Elastic energy stored in the memory, and energy dissipated by a step.

use super::{Lateral, Memory, VertexStack};
use crate::profile::NormalProfile;

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Memory<V, S, P> {
    /// The elastic energy of the tangential shift per direction, conjugate to Phi and X: `(1/2) int
    /// F'' |X - W(s)|^2 ds`, for Hertz `(3/4) int |X - W(t^2)|^2 dt`. The springs of a flat end,
    /// all in contact from depth zero, add `(1/2) F'(0) |X - W(0)|^2`.
    ///
    /// The sum of the components is the energy if all directions have the same stiffness.
    #[must_use]
    pub fn stored_energy(&self) -> V {
        let mut sum = V::default();
        for segment in self.segments() {
            let low = self.shift.minus(segment.anchor);
            let high = low.minus(segment.slope.times(segment.to - segment.from));
            sum = sum.plus(spring_energy(&self.profile, [segment.from, segment.to], [low, high]));
        }
        if self.is_touching() {
            sum = sum.plus(flat_energy(&self.profile, self.shift.minus(self.stack.get(0).anchor)));
        }
        sum
    }

    /// The energy per direction, conjugate to Phi and X, that a straight step to a new approach and
    /// shift would dissipate. The state does not change.
    ///
    /// It is computed from the traction and the slip of every spring, so that small losses are
    /// accurate, and equals the work of the force minus the increase of [`Memory::stored_energy`].
    /// In one direction it is in closed form, a sum of terms that are not negative. In two it is an
    /// adaptive quadrature over the step: the balance holds to 1e-11 of its largest term, in most
    /// cases to 1e-12; for one direction alone mostly to 1e-10, with one step in 150 000 at 4e-8. A
    /// merge of a [`super::Fixed`] stack changes the state outside a step and is in no balance; [`Memory::loss`]
    /// contains it.
    ///
    /// Zero for arguments that are not finite.
    #[must_use]
    pub fn dissipation(&self, zeta: f64, shift: V) -> V {
        let along = |weight| self.heat(zeta, shift, V::from_components(weight));
        match V::DIMENSION {
            1 => V::from_components([along([1.0, 0.0]), 0.0]),
            _ => V::from_components([along([1.0, 0.0]), along([0.0, 1.0])]),
        }
    }

    /// The scalar product of [`Memory::dissipation`] and the energies `unit`; not negative if both
    /// directions have the same unit.
    pub(crate) fn heat(&self, zeta: f64, shift: V, unit: V) -> f64 {
        if !zeta.is_finite() || !shift.is_finite() || (self.zeta <= 0.0 && zeta <= 0.0) {
            return 0.0;
        }
        let path = self.path_in_contact(zeta, shift);
        if path.dz > 0.0 && path.dx.dot(path.dx) <= path.dz * path.dz {
            return 0.0;
        }
        match V::DIMENSION {
            1 => self.heat_in_line(&path) * unit.components()[0],
            _ => self.heat_in_plane(&path, unit),
        }
    }

    /// The part of the step during which the bodies are in contact.
    pub(super) fn path_in_contact(&self, zeta: f64, shift: V) -> Path<V> {
        let (mut from, mut to) = ((self.zeta, self.shift), (zeta, shift));
        let touch = |from: (f64, V), to: (f64, V)| {
            let part = from.0 / (from.0 - to.0);
            (0.0, from.1.plus(to.1.minus(from.1).times(part)))
        };
        if self.zeta < 0.0 {
            from = touch(from, to);
        }
        if zeta < 0.0 {
            to = touch(from, to);
        }
        Path { zeta: from.0, shift: from.1, end: to.0, dz: to.0 - from.0, dx: to.1.minus(from.1) }
    }
}

/// A straight step of bodies in contact.
pub(super) struct Path<V> {
    pub(super) zeta: f64,
    pub(super) shift: V,
    /// The approach at the end.
    pub(super) end: f64,
    pub(super) dz: f64,
    pub(super) dx: V,
}

/// The energy of the springs between two depths, for a stretch that is linear in the depth.
pub(super) fn spring_energy<V: Lateral, P: NormalProfile>(
    profile: &P,
    [lower, upper]: [f64; 2],
    stretch: [V; 2],
) -> V {
    let [low, high] = stretch.map(V::components);
    let mut sum = [0.0; 2];
    for (i, sum) in sum.iter_mut().enumerate().take(V::DIMENSION) {
        let ends = [low[i], high[i]];
        *sum = 0.5 * profile.spring_product(lower, upper, ends, ends);
    }
    V::from_components(sum)
}

/// The energy of the springs that are all in contact from depth zero.
pub(super) fn flat_energy<V: Lateral, P: NormalProfile>(profile: &P, stretch: V) -> V {
    stretch.by_component(stretch).times(0.5 * profile.stiffness(0.0))
}
