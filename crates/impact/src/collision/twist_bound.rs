//! The effect of friction on the spin about the normal, and bounds of it.

use super::Collision;
use crate::coupled::ImpactMethod;
use crate::normal::NormalImpact;
use crate::outcome::TorsionMode;

/// Change of R_x over a Omega/(f v_z) for small values: 1.5 times the largest measured one.
const SLOPE: f64 = 2.0;

/// a Omega/(f v_z) below which a spin does not change R_x.
const NO_SPIN: f64 = 1e-6;

/// Tangential velocities, and spins about the normal, below this fraction of what they are the difference or a component
/// of are round-off.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Bounds of the effects of the relative spin about the normal and friction on each other. Both are 0 without
/// that spin; that of R_x also if it moves the edge of the largest contact slower than 1e-6 f v_z.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TwistBound {
    /// Bound of the change of R_x by the spin: 2 t/(1 + t), where t = a Omega/(f v_z) compares the velocity
    /// of spin at the edge of the largest contact (radius a) with the normal velocity before the impact.
    ///
    /// The spin uses up friction at the edge, and where the contact slips it turns the friction away from the
    /// direction of the shift: for small t the change is linear in t. The bound was measured, not derived. In
    /// 207 impacts of similar spheres by rings (nu from 0 to 0.5, tangential velocities from 0.1 to 6 f v_z,
    /// t from 0.1 to 6) the change was at most 0.74 of it.
    pub restitution: f64,
    /// Bound of the fraction of the relative spin that friction removes: the fraction that it removes without
    /// tangential motion, by the smaller of the closed forms for no slip and for sliding. In the same impacts
    /// friction removed at most 0.97 of it.
    pub spin: f64,
}

impl Collision {
    /// The same collision with friction acting on the spin about the normal always, never, or where it
    /// matters.
    #[must_use]
    pub fn with_torsion_mode(self, torsion: TorsionMode) -> Self {
        Self { torsion, ..self }
    }

    /// Whether friction acts on the spin about the normal.
    #[must_use]
    pub const fn torsion_mode(&self) -> TorsionMode {
        self.torsion
    }

    /// Bounds of the change of R_x by the relative spin about the normal, and of the fraction of that spin
    /// that friction removes. Both are 0 if [`Collision::with_torsion_mode`] leaves the spin unchanged, and
    /// for bodies other than spheres and planes with the same mobility along all tangents: only the law of
    /// rings combines spin and shift.
    #[must_use]
    pub fn twist_bound(&self) -> TwistBound {
        let is_counted = self.torsion != TorsionMode::LeftOut && self.is_symmetric();
        if !is_counted || !self.twists() {
            return TwistBound::default();
        }
        // However slow a spin is, a contact that sticks removes the same part of it.
        let spin = self.normal_spin(self.velocity().z).greatest_loss().unwrap_or(0.0);
        TwistBound { restitution: self.restitution_by_spin().unwrap_or(0.0), spin }
    }

    /// How much the relative spin about the normal may change R_x where a method leaves it out: all but that of
    /// rings do, and it does with [`TorsionMode::LeftOut`]. For bodies other than spheres and planes the bound is
    /// that of a sphere whose contact has their larger semi-axis.
    fn spin_on_shift(&self, method: ImpactMethod) -> f64 {
        let is_counted = method == ImpactMethod::Rings && self.torsion != TorsionMode::LeftOut;
        if is_counted || !self.is_tangential() {
            return 0.0;
        }
        self.restitution_by_spin().unwrap_or(0.0)
    }

    /// Bounds of the change of R_x by what this method leaves out: the coupling of dissimilar materials and the
    /// spin about the normal.
    pub(super) fn left_out(&self, method: ImpactMethod) -> [f64; 2] {
        let coupling = if method.counts_coupling() { 0.0 } else { self.coupling_bound() };
        [coupling, self.spin_on_shift(method)]
    }

    /// Whether friction acts on a relative spin about the normal.
    fn twists(&self) -> bool {
        let spins: f64 = self.bodies.iter().map(|body| body.motion().spin.norm()).sum();
        let is_spinning = self.relative_spin().abs() > ROUNDING * spins;
        self.velocity().z > 0.0 && is_spinning && self.friction.get() > 0.0
    }

    /// [`TwistBound::restitution`] for any bodies; `None` if the spin counts for nothing.
    fn restitution_by_spin(&self) -> Option<f64> {
        if !self.twists() {
            return None;
        }
        let speed = self.velocity().z;
        let omega = self.relative_spin().abs();
        let friction = self.friction.get();
        let (d_zz, c_z) = (self.mobility.matrix().m33, self.hertz.stiffness().c_z);
        let contact = NormalImpact::new(d_zz, c_z, speed)
            .and_then(|normal| self.hertz.ellipse(normal.maximal_approach()));
        let radius = contact
            .map_or(f64::INFINITY, |contact| contact.semi_axis_a().max(contact.semi_axis_b()));
        let inverse = friction * speed / (radius * omega);
        // Infinite friction: shift and twist are linear and independent.
        let is_negligible = inverse * NO_SPIN >= 1.0 && friction.is_finite();
        (!is_negligible).then(|| SLOPE / (1.0 + inverse))
    }

    /// Whether the contact points have a tangential velocity beyond the round-off of the velocities that it
    /// is the difference of.
    pub(super) fn is_tangential(&self) -> bool {
        let speed = |i: usize| {
            let motion = self.bodies[i].motion();
            motion.velocity.norm() + motion.spin.norm() * self.levers[i].arm().norm()
        };
        self.velocity().xy().norm() > ROUNDING * (speed(0) + speed(1))
    }

    pub(super) fn relative_spin(&self) -> f64 {
        let spin = |i: usize| self.bodies[i].motion().spin.dot(&self.frame().z());
        spin(0) - spin(1)
    }
}
