//! Damping of the normal motion of a Hertz contact: which damping gives which restitution.
//!
//! Two bodies of the reduced mass m approach with the speed v and are pressed by Hertz's force K zeta^(3/2), K =
//! (2/3) c_z, and a damping force, whose sum never pulls. Without friction they part with the speed e v.
//!
//! - [`HertzDamping`]: the force `alpha sqrt(m K) zeta^(1/4) dzeta/dt` of Tsuji, Tanaka and Ishida (Powder Technology
//!   71, 1992). It has no scale of its own, so that e is the same at any speed.
//! - A viscous material has another one, with which e falls as the speed grows: [`crate::viscous`].

use carom_special::RangeError;
use carom_special::roots::{ALL_DIGITS, bisect};

/// The damping with which two bodies in Hertz contact rebound with a given restitution at any speed.
///
/// With `s = (2/sqrt 5) x^(5/4)`, x the approach in units in which m = K = 1, the motion is that of a linear spring with
/// the damping ratio beta = alpha/sqrt 5: `s'' + 2 beta s' + s = 0`, where s' is the speed of approach. The force
/// vanishes where s'' does. With beta = cos psi this is after a phase of 2 psi, and
///
/// `e = exp(-2 psi cot psi)`; with beta = cosh chi > 1, `e = exp(-2 chi coth chi)`.
///
/// ```
/// use carom_laws::damping::HertzDamping;
/// let damping = HertzDamping::of_restitution(0.5)?;
/// assert!((damping.ratio() - 0.5708).abs() < 1e-4);
/// assert_eq!(HertzDamping::of_restitution(1.0)?.ratio(), 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzDamping {
    restitution: f64,
    ratio: f64,
}

impl HertzDamping {
    /// The damping of a restitution e.
    ///
    /// # Errors
    /// [`RangeError`] unless it is in \[0.01, 1\].
    pub fn of_restitution(restitution: f64) -> Result<Self, RangeError> {
        let holds = (LEAST..=1.0).contains(&restitution);
        RangeError::check("restitution", restitution, holds, "from 0.01 to 1")?;
        Ok(Self { restitution, ratio: 5.0_f64.sqrt() * damping_ratio(restitution) })
    }

    /// The damping of a ratio alpha, whose restitution follows.
    ///
    /// # Errors
    /// [`RangeError`] unless it is that of a restitution in \[0.01, 1\], from 0 to 11.2.
    pub fn of_ratio(ratio: f64) -> Result<Self, RangeError> {
        let greatest = 5.0_f64.sqrt() * damping_ratio(LEAST) * (1.0 + 1e-12);
        let holds = (0.0..=greatest).contains(&ratio);
        RangeError::check("ratio", ratio, holds, "from 0 to that of a restitution of 0.01, 11.2")?;
        let beta = ratio / 5.0_f64.sqrt();
        let exponent = if beta < 1.0 {
            let psi = libm::acos(beta);
            psi * beta / libm::sin(psi)
        } else {
            let chi = libm::acosh(beta);
            if chi == 0.0 { 1.0 } else { chi / libm::tanh(chi) }
        };
        Ok(Self { restitution: libm::exp(-2.0 * exponent), ratio })
    }

    /// This damping for materials with a viscous relaxation time, s: both would count the same loss.
    ///
    /// # Errors
    /// [`RangeError`] of `relaxation` if it is not 0 and the restitution below 1.
    pub fn beside_relaxation(self, relaxation: f64) -> Result<Self, RangeError> {
        let holds = relaxation == 0.0 || self.ratio == 0.0;
        RangeError::check("relaxation", relaxation, holds, "0 beside a restitution below 1")?;
        Ok(self)
    }

    /// The restitution e.
    #[must_use]
    pub const fn restitution(&self) -> f64 {
        self.restitution
    }

    /// alpha: the damping force over `sqrt(m K) zeta^(1/4) dzeta/dt`.
    #[must_use]
    pub const fn ratio(&self) -> f64 {
        self.ratio
    }
}

/// The least restitution.
const LEAST: f64 = 0.01;

/// beta from e: cos psi with `psi cot psi = -ln(e)/2`, or cosh chi.
fn damping_ratio(restitution: f64) -> f64 {
    let wanted = -0.5 * libm::log(restitution);
    if wanted <= 0.0 {
        return 0.0;
    }
    // psi cot psi falls from 1 to 0, chi coth chi grows from 1 and lies between chi and chi + 1.
    if wanted < 1.0 {
        let ends = [0.0, std::f64::consts::FRAC_PI_2];
        let [psi, _] = bisect(ends, ALL_DIGITS, |psi| psi <= 0.0 || psi / libm::tan(psi) > wanted);
        return libm::cos(psi);
    }
    let [chi, _] =
        bisect([0.0, wanted + 1.0], ALL_DIGITS, |chi| chi <= 0.0 || chi / libm::tanh(chi) < wanted);
    libm::cosh(chi)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    /// The rebound by steps of a method that knows nothing of the transformation: Heun's with extrapolation, for
    /// any damping force.
    fn rebound(force: impl Fn(f64, f64) -> f64, steps: usize) -> f64 {
        let dt = 3.5 / steps as f64;
        let (mut x, mut v) = (0.0, 1.0);
        loop {
            // Classical Runge-Kutta.
            let at = |x: f64, v: f64| [v, -force(x, v)];
            let k1 = at(x, v);
            let k2 = at(x + 0.5 * dt * k1[0], v + 0.5 * dt * k1[1]);
            let k3 = at(x + 0.5 * dt * k2[0], v + 0.5 * dt * k2[1]);
            let k4 = at(x + dt * k3[0], v + dt * k3[1]);
            x += dt / 6.0 * (k1[0] + 2.0 * k2[0] + 2.0 * k3[0] + k4[0]);
            v += dt / 6.0 * (k1[1] + 2.0 * k2[1] + 2.0 * k3[1] + k4[1]);
            if v < 0.0 && force(x, v) <= 0.0 {
                return -v;
            }
        }
    }

    #[test]
    fn the_given_restitution_is_the_one_of_an_integration() {
        for restitution in [1.0, 0.98, 0.9, 0.7, 0.5, 0.3, 0.2, 0.14, 0.13, 0.1, 0.03, 0.01] {
            let ratio = HertzDamping::of_restitution(restitution).unwrap().ratio();
            let got = rebound(
                |x, v| {
                    let x = x.max(0.0);
                    (x.powf(1.5) + ratio * x.powf(0.25) * v).max(0.0)
                },
                200_000,
            );
            assert_abs_diff_eq!(got, restitution, epsilon = 2e-6);
        }
    }

    #[test]
    fn restitutions_out_of_range_are_refused() {
        for restitution in [0.0, 0.009, 1.01, -0.5, f64::NAN, f64::INFINITY] {
            assert_eq!(HertzDamping::of_restitution(restitution).unwrap_err().field, "restitution");
        }
    }

    #[test]
    fn a_ratio_has_the_restitution_that_it_came_from() {
        for k in 1..=100 {
            let damping = HertzDamping::of_restitution(0.01 * f64::from(k)).unwrap();
            let back = HertzDamping::of_ratio(damping.ratio()).unwrap();
            assert_abs_diff_eq!(back.restitution(), damping.restitution(), epsilon = 1e-13);
        }
        for ratio in [-1e-9, 11.7, f64::NAN] {
            assert_eq!(HertzDamping::of_ratio(ratio).unwrap_err().field, "ratio");
        }
    }

    /// The ratio falls as the restitution grows, without a jump where the motion is critically damped, e = exp(-2).
    #[test]
    fn the_ratio_is_continuous_and_falls() {
        let ratio = |e: f64| HertzDamping::of_restitution(e).unwrap().ratio();
        let critical = (-2.0_f64).exp();
        assert_abs_diff_eq!(ratio(critical), 5.0_f64.sqrt(), epsilon = 1e-6);
        let mut before = f64::INFINITY;
        for k in 1..=1000 {
            let next = ratio((0.001 * f64::from(k)).max(0.01));
            assert!(next <= before, "{k}");
            before = next;
        }
        // Close to 1 the losses of a period add up: 1 - e = pi beta.
        assert_abs_diff_eq!(
            ratio(1.0 - 1e-6),
            5.0_f64.sqrt() * 1e-6 / std::f64::consts::PI,
            epsilon = 1e-11
        );
    }
}
