//! The damping of the normal motion.

use super::meeting::Meeting;
use super::number::Number;
use super::vector::dot;

/// What resists the speed of approach beside Hertz's force; zero for none.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub(super) struct Dashpots<T = f64> {
    /// The damping force of a viscoelastic material divided by `sqrt(zeta) dzeta/dt`.
    pub(super) viscosity: T,
    /// The ratio alpha of [`crate::damping::HertzDamping`], of a given restitution.
    pub(super) ratio: T,
}

/// Least half width, over the approach, of the window over which the root is averaged.
const LEAST: f64 = 1e-3;

impl<T: Number> Dashpots<T> {
    /// The damping force at the end of a step of duration `dt`; its sum with Hertz's force `elastic`, of the constant
    /// `c_z`, is never tensile. It is 0 where the bodies are apart. The masses are asked for if there is a restitution.
    #[inline(always)]
    pub(super) fn force<M>(
        &self,
        meeting: &Meeting<T, M>,
        masses: impl FnOnce() -> [T; 2],
        [c_z, elastic]: [T; 2],
        dt: f64,
    ) -> T {
        self.force_since(meeting, masses, [c_z, elastic], [T::of(1.0), T::of(dt)])
    }

    /// The force of a viscoelastic material, and that of a given restitution over the last `since` half steps and the
    /// next one.
    ///
    /// The latter is `alpha sqrt(m K) zeta^(1/4) dzeta/dt`, K = (2/3) c_z. Two corrections make it exact to the second
    /// order of the step, where the restitution would otherwise be off by more than the step's part of the impact.
    /// First, `zeta^(1/4)`, which begins with a vertical tangent, is averaged over the time for which the force acts.
    /// Second, the known speed is that of the middle of the step, half a step before; from there to its end the force
    /// itself slows the approach by F dt/(2 m), so that F (1 + c dt/(2 m)) = elastic + c speed.
    #[inline(always)]
    fn force_since<M>(
        &self,
        meeting: &Meeting<T, M>,
        masses: impl FnOnce() -> [T; 2],
        [c_z, elastic]: [T; 2],
        [since, dt]: [T; 2],
    ) -> T {
        let speed = dot(meeting.velocity, meeting.normal);
        // Without damping 0 and never -0, whichever damping the contacts beside have.
        let mut force =
            T::of(0.0) + self.viscosity * meeting.zeta.larger(T::of(0.0)).sqrt() * speed;
        if self.ratio.is_any_positive() {
            let [one, two] = masses().map(|mass| T::of(1.0) / mass);
            let mobility = one + two;
            let root = mean_root(meeting.zeta, T::of(0.5) * dt * speed, since);
            let c = self.ratio * (T::of(2.0 / 3.0) * c_z / mobility).sqrt() * root;
            let slowed = T::of(1.0) + c * mobility * (T::of(0.5) * dt);
            // Masses of contacts without a restitution beside this one may be anything.
            let by_restitution = (elastic + c * speed) / slowed - elastic;
            force = force + by_restitution.where_positive(self.ratio);
        }
        // Bodies that are apart exert no force on each other, however fast they approach.
        force.larger(T::of(0.0) - elastic).where_positive(meeting.zeta)
    }
}

impl Dashpots {
    /// The force of one contact at the end of a step, as [`Dashpots::force`].
    #[inline(always)]
    pub(super) fn force_of_one(&self, meeting: &Meeting, forces: [f64; 2], dt: f64) -> f64 {
        self.force(meeting, || meeting.masses, forces, dt)
    }

    /// The force at the end of the step in which the bodies touched: it makes up for the time before the last half
    /// of the step.
    #[inline]
    pub(super) fn first_force(&self, meeting: &Meeting, forces: [f64; 2], dt: f64) -> f64 {
        self.force_since(meeting, || meeting.masses, forces, [2.0, dt])
    }
}

/// The mean of `zeta^(1/4)`, 0 for a gap, along a straight path from `since` times `way` before the end of the step
/// to `way` after it; per one `2 way`.
#[inline(always)]
fn mean_root<T: Number>(zeta: T, way: T, since: T) -> T {
    let way = way.larger(T::of(0.0) - way).larger(T::of(LEAST) * zeta);
    let way = way.larger(T::of(f64::MIN_POSITIVE));
    // The integral of zeta^(1/4) is (4/5) zeta^(5/4).
    let to = |zeta: T| {
        let zeta = zeta.larger(T::of(0.0));
        zeta * zeta.sqrt().sqrt()
    };
    T::of(0.4) * (to(zeta + way) - to(zeta - since * way)) / way
}
