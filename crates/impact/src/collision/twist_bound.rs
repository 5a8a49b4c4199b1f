//! Whether friction acts on the spin about the normal, and how much that can change of an impact.

use super::Collision;
use crate::normal::NormalImpact;
use crate::outcome::TorsionMode;

/// Change of R_x over a Omega/(f v_z) where that is small: 1.5 times the largest that was measured.
const SLOPE: f64 = 2.0;

/// a Omega/(f v_z) up to which a spin is left alone: as small ones come about by rounding.
const NO_SPIN: f64 = 1e-6;

/// Tangential velocities below this part of those that they are the difference of are round-off.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Bounds of what the relative spin about the normal and friction change of each other; both 0 without that spin, and
/// where it moves the edge of the greatest contact slower than 1e-6 f v_z.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TwistBound {
    /// Of the change of R_x by the spin: 2 t/(1 + t), where t = a Omega/(f v_z) compares the velocity of spin at the
    /// edge of the greatest contact (radius a) with the normal velocity of approach.
    ///
    /// The spin uses up friction at the edge, and where the contact slips it turns friction out of the direction of
    /// the shift: the change is linear in a small t. The bound was measured, not derived: in 207 impacts of like
    /// spheres (nu from 0 to 0.5, tangential velocities from 0.1 to 6 f v_z, t from 0.1 to 6) by rings the change was
    /// at most 0.74 of it.
    pub restitution: f64,
    /// Of the part of the relative spin that friction takes: what it takes without tangential motion, by the lesser of
    /// the closed forms of no slip and of sliding. In the same impacts friction took at most 0.97 of it.
    pub spin: f64,
}

impl Collision {
    /// The same collision, where friction acts on the spin about the normal always, never, or where it matters.
    #[must_use]
    pub fn with_torsion_mode(self, torsion: TorsionMode) -> Self {
        Self { torsion, ..self }
    }

    /// Whether friction acts on the spin about the normal.
    #[must_use]
    pub const fn torsion_mode(&self) -> TorsionMode {
        self.torsion
    }

    /// Bounds of what the relative spin about the normal changes of R_x, and of what friction takes of that spin. Both
    /// are 0 where the spin is left alone by [`Collision::with_torsion_mode`], and for other bodies than spheres and
    /// planes that turn as easily about all tangents: only rings know a spin together with a shift.
    #[must_use]
    pub fn twist_bound(&self) -> TwistBound {
        let speed = self.velocity().z;
        let omega = self.relative_spin().abs();
        let friction = self.friction.get();
        let is_counted = self.torsion != TorsionMode::LeftOut && self.is_symmetric();
        if !is_counted || speed <= 0.0 || omega == 0.0 || friction == 0.0 {
            return TwistBound::default();
        }
        let (d_zz, c_z) = (self.mobility.matrix().m33, self.hertz.stiffness().c_z);
        let contact = NormalImpact::new(d_zz, c_z, speed)
            .and_then(|normal| self.hertz.ellipse(normal.maximal_approach()));
        let radius = contact.map_or(f64::INFINITY, |contact| contact.semi_axis_b());
        let inverse = friction * speed / (radius * omega);
        // Infinite friction: shift and twist are linear, each by itself.
        if inverse * NO_SPIN >= 1.0 && friction.is_finite() {
            return TwistBound::default();
        }
        let restitution = SLOPE / (1.0 + inverse);
        TwistBound { restitution, spin: self.normal_spin(speed).greatest_loss().unwrap_or(0.0) }
    }

    /// Whether the contact points have a tangential velocity, beyond the rounding of the velocities that it is the
    /// difference of.
    pub(super) fn is_tangential(&self) -> bool {
        let speed = |i: usize| {
            let motion = self.bodies[i].motion();
            motion.velocity.norm() + motion.spin.norm() * self.levers[i].arm().norm()
        };
        self.velocity().xy().norm() > ROUNDING * (speed(0) + speed(1))
    }

    fn relative_spin(&self) -> f64 {
        let spin = |i: usize| self.bodies[i].motion().spin.dot(&self.frame().z());
        spin(0) - spin(1)
    }
}
