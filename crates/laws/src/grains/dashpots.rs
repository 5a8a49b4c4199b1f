//! The damping of the normal motion: the effective approach of a contact, and by how much its shift leads.

use carom_special::RangeError;

use super::number::Number;
use crate::damping::HertzDamping;
use crate::viscous::Viscosity;

/// What resists the speed of approach; zero for none. At most one of both is above 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub(super) struct Dashpots<T = f64> {
    /// The relaxation time A of the materials.
    pub(super) relaxation: T,
    /// The ratio alpha of [`crate::damping::HertzDamping`], of a given restitution.
    pub(super) ratio: T,
}

/// The motion along the normal at the end of a step.
#[derive(Clone, Copy)]
pub(super) struct Motion<T = f64> {
    pub(super) zeta: T,
    /// The rate of the approach in the middle of the step.
    pub(super) speed: T,
    /// That of the step before.
    pub(super) before: T,
    /// For how many of the last half steps the force acts: two if the bodies touched in this step.
    pub(super) since: T,
    pub(super) dt: f64,
}

/// What a damped contact makes of its approach.
#[derive(Clone, Copy)]
pub(super) struct Effective<T = f64> {
    /// Z: the approach at which the elastic contact bears the whole normal force; 0 where it bears none.
    pub(super) approach: T,
    /// theta: the time by which shift and twist lead.
    pub(super) theta: T,
}

/// Least half width, over the approach, of the window over which the root is averaged.
const LEAST: f64 = 1e-3;

impl Dashpots {
    /// Those of materials with this relaxation time, of a contact of the stiffness `c_z`.
    pub(super) fn of_relaxation(relaxation: f64, c_z: f64) -> Result<Self, RangeError> {
        RangeError::non_negative("relaxation", relaxation)?;
        RangeError::finite("relaxation", relaxation * c_z)?;
        Ok(Self { relaxation, ratio: 0.0 })
    }

    /// Those of a given restitution, unless the materials are viscous themselves.
    pub(super) fn with_restitution(self, damping: HertzDamping) -> Result<Self, RangeError> {
        let ratio = damping.beside_relaxation(self.relaxation)?.ratio();
        Ok(Self { ratio, ..self })
    }

    /// Whether the contact is damped.
    #[inline(always)]
    pub(super) fn resist(&self) -> bool {
        self.relaxation + self.ratio > 0.0
    }
}

impl<T: Number> Dashpots<T> {
    /// Effective approach and lead of contacts that are all damped. `c_z` is the constant of Hertz's force. The mobility,
    /// the sum of one over each mass, is asked for if there is a restitution.
    #[inline(always)]
    pub(super) fn effective(
        &self,
        motion: Motion<T>,
        c_z: T,
        mobility: impl FnOnce() -> T,
    ) -> Effective<T> {
        let nothing = T::of(0.0);
        let mut all = Effective { approach: nothing, theta: nothing };
        if self.relaxation.is_any_positive() {
            let by = self.by_relaxation(motion);
            all.approach = by.approach.where_positive(self.relaxation);
            all.theta = by.theta.where_positive(self.relaxation);
        }
        if self.ratio.is_any_positive() {
            let by = self.by_restitution(motion, c_z, mobility());
            all.approach = all.approach + by.approach.where_positive(self.ratio);
            all.theta = all.theta + by.theta.where_positive(self.ratio);
        }
        // Bodies that are apart exert no force on each other, however fast they approach.
        Effective { approach: all.approach.where_positive(motion.zeta), ..all }
    }

    /// That of viscous materials, at the speed of the end of the step: hosts know that of its middle.
    #[inline(always)]
    fn by_relaxation(&self, Motion { zeta, speed, before, .. }: Motion<T>) -> Effective<T> {
        let rate = speed + T::of(0.5) * (speed - before);
        let [approach, theta] = T::each([self.relaxation, zeta, rate], |[time, zeta, rate]| {
            let by = Viscosity::of(time).effective(zeta, rate);
            [by.approach, by.lead]
        });
        Effective { approach, theta }
    }

    /// That of a given restitution: the force beside Hertz's is `D dzeta/dt`, `D = alpha sqrt(m K) zeta^(1/4)`, K = (2/3) c_z.
    ///
    /// Two corrections make the force F exact to the second order of the step, where the restitution would otherwise be
    /// off by more than the step's part of the impact. First, `zeta^(1/4)`, which begins with a vertical tangent, is
    /// averaged over the last `since` half steps and the next one. Second, the known speed is that of the middle of the
    /// step, half a step before; from there to its end the force itself slows the approach by F dt/(2 m), so that
    /// F (1 + D dt/(2 m)) = elastic + D speed.
    ///
    /// With p = (F/K)^(1/3) and s = zeta^(1/2) the lead (Z - zeta)/zeta' is (D/K) (p + s)/(p^2 + p s + s^2).
    #[inline(always)]
    fn by_restitution(&self, motion: Motion<T>, c_z: T, mobility: T) -> Effective<T> {
        let Motion { zeta, speed, since, dt, .. } = motion;
        let half = T::of(0.5 * dt);
        let root = mean_root(zeta, half * speed, since);
        let stiffness = T::of(2.0 / 3.0) * c_z;
        let damping = self.ratio * (stiffness / mobility).sqrt() * root;
        let s = zeta.larger(T::of(0.0)).sqrt();
        let slowed = T::of(1.0) + damping * mobility * half;
        let force = (stiffness * (s * s * s) + damping * speed) / slowed;
        let [p] = T::each([force.larger(T::of(0.0)) / stiffness], |[cube]| [cube_root(cube)]);
        let squares = (p * p + p * s + s * s).larger(T::of(f64::MIN_POSITIVE));
        Effective { approach: p * p, theta: damping / stiffness * ((p + s) / squares) }
    }
}

/// The cube root of a number >= 0, to the last bit or two: half of the instructions of `libm::cbrt`.
#[inline(always)]
fn cube_root(cube: f64) -> f64 {
    /// A third of the exponent of a number and its bias, less what the error of the seed is then spread by: within 1/20.
    const SEED: u64 = 0x2A9F_7893_0000_0000;
    if cube < f64::MIN_POSITIVE {
        return 0.0;
    }
    let halley = |root: f64| {
        let third = root * root * root;
        root * ((third + 2.0 * cube) / (2.0 * third + cube))
    };
    // Its error is that of the last step to the third power: 5e-5, 1e-13.
    let root = halley(halley(f64::from_bits(cube.to_bits() / 3 + SEED)));
    root - (root - cube / (root * root)) * (1.0 / 3.0)
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

#[cfg(test)]
mod tests {
    use super::cube_root;

    #[test]
    fn the_cube_root_is_that_of_a_cube() {
        for power in -90..100 {
            for part in [1.0, 1.1, 1.3, 1.7, 2.1, 2.9, 3.3, 5.0, 7.1, 9.9] {
                let root = part * 10_f64.powi(power);
                let got = cube_root(root * root * root);
                assert!((got / root - 1.0).abs() < 4e-16, "{root:e}: {got:e}");
            }
        }
        assert_eq!([0.0, 1e-310].map(cube_root), [0.0; 2]);
        assert!(cube_root(f64::NAN).is_nan());
    }
}
