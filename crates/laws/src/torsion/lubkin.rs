//! Partial slip of a twisted circular contact, by Lubkin (5.36)-(5.42).

use std::f64::consts::PI;
use std::sync::LazyLock;

use carom_special::elliptic::{Amplitude, complete, incomplete};
use carom_special::quadrature::FixedRule;
use carom_special::{AxisRatio, RangeError};

/// The normalised torque of complete sliding, `M_z/(f F_z a) = 3 pi/16`.
pub const SLIDING_TORQUE: f64 = 3.0 * PI / 16.0;

/// Below this stick radius the torque is computed from its deficit to sliding.
const SMALL_STICK: f64 = 0.4;

static RULE: FixedRule<16> = FixedRule::fixed();
static FINE: FixedRule<48> = FixedRule::fixed();

/// A circular contact under constant normal load, twisted once from zero.
///
/// Normalised by the contact: twist `G a^2 beta/(f F_z)`, torque `M_z/(f F_z a)`, traction
/// `sigma a^2/(f F_z)`, radii by a.
///
/// ```
/// use carom_laws::torsion::lubkin::{Lubkin, SLIDING_TORQUE};
/// let state = Lubkin::at_twist(0.1)?;
/// assert!((state.torque() - 0.361_861_948_0).abs() < 1e-10);
/// let back = Lubkin::at_torque(state.torque())?;
/// assert!((back.twist() - 0.1).abs() < 1e-15);
/// assert!(Lubkin::at_torque(SLIDING_TORQUE).is_err()); // sliding: any twist
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lubkin {
    /// k' = a*/a.
    stick: AxisRatio,
    /// k^2 = 1 - k'^2, stored separately for its accuracy.
    parameter: f64,
}

impl Lubkin {
    /// The state with a given stick radius a*/a in (0, 1].
    ///
    /// # Errors
    /// [`RangeError`] for a ratio outside that range.
    pub fn at_stick_radius(stick: f64) -> Result<Self, RangeError> {
        RangeError::check("stick_radius", stick, stick > 0.0 && stick <= 1.0, "in (0, 1]")?;
        let stick = AxisRatio::new(stick)?;
        Ok(Self { stick, parameter: stick.parameter() })
    }

    /// The state with a given modulus k = sqrt(1 - (a*/a)^2) in [0, 1).
    ///
    /// # Errors
    /// [`RangeError`] for a modulus outside that range.
    pub fn at_modulus(k: f64) -> Result<Self, RangeError> {
        RangeError::check("modulus", k, (0.0..1.0).contains(&k), "in [0, 1)")?;
        let stick = AxisRatio::new(((1.0 - k) * (1.0 + k)).sqrt())?;
        Ok(Self { stick, parameter: k * k })
    }

    /// The state at a given twist >= 0, the inverse of (5.39).
    ///
    /// # Errors
    /// [`RangeError`] unless the twist is finite, not negative, and below about 160, above which
    /// the stick radius underflows.
    pub fn at_twist(twist: f64) -> Result<Self, RangeError> {
        let holds = (0.0..160.0).contains(&twist);
        RangeError::check("twist", twist, holds, "in [0, 160)")?;
        Ok(Self::at_depth(depth_of_twist(4.0 * PI / 3.0 * twist)))
    }

    /// The state under a given torque, at least 0 and below [`SLIDING_TORQUE`].
    ///
    /// # Errors
    /// [`RangeError`] for a torque outside that range.
    pub fn at_torque(torque: f64) -> Result<Self, RangeError> {
        let holds = (0.0..SLIDING_TORQUE).contains(&torque);
        RangeError::check("torque", torque, holds, "in [0, 3 pi/16)")?;
        // With v = -ln k': dM/dv = (4/pi) k'^3 E. Near sliding the logarithm of the deficit is
        // nearly linear in v, elsewhere M itself; both are concave, so that Newton steps from the
        // left do not overshoot.
        let deficit = SLIDING_TORQUE - torque;
        let mut v = 0.0;
        for _ in 0..60 {
            let state = Self::at_depth(v);
            let kc = state.stick.get();
            let slope = 4.0 / PI * kc * kc * kc * complete::e(state.stick);
            let step = if deficit < 0.5 * SLIDING_TORQUE {
                let left = state.deficit();
                libm::log(left / deficit) * left / slope
            } else {
                (torque - state.torque()) / slope
            };
            v += step;
            if step.abs() <= 1e-16 * v {
                break;
            }
        }
        Ok(Self::at_depth(v.max(0.0)))
    }

    /// The state with -ln(a*/a) = v.
    pub(super) fn at_depth(v: f64) -> Self {
        let kc = libm::exp(-v).clamp(f64::MIN_POSITIVE, 1.0);
        // In (0, 1], so that the ratio is valid.
        let stick = AxisRatio::new(kc).unwrap_or(AxisRatio::CIRCLE);
        Self { stick, parameter: -libm::expm1(-2.0 * v) }
    }

    /// The stick radius a*/a = k'.
    #[must_use]
    pub const fn stick_radius(&self) -> f64 {
        self.stick.get()
    }

    /// The twist `G a^2 beta/(f F_z) = (3/(4 pi)) (K - E)` (5.39).
    #[must_use]
    pub fn twist(&self) -> f64 {
        0.75 / PI * self.parameter * complete::d(self.stick)
    }

    /// The torque `M_z/(f F_z a)`, (5.41) in the form `(4/pi) int_k'^1 t^2 E dt`.
    #[must_use]
    pub fn torque(&self) -> f64 {
        let kc = self.stick.get();
        if kc < SMALL_STICK {
            return SLIDING_TORQUE - self.deficit();
        }
        moment_above(kc, self.parameter)
    }

    /// The deficit of the torque to sliding, `3 pi/16 - M_z/(f F_z a)`, to full relative accuracy.
    #[must_use]
    pub fn deficit(&self) -> f64 {
        let kc = self.stick.get();
        if kc < SMALL_STICK { moment_below(kc) } else { SLIDING_TORQUE - self.torque() }
    }

    /// The tangent of the torque, `dM/dtwist = (16/3) k'^3`.
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        let kc = self.stick.get();
        16.0 / 3.0 * (kc * kc * kc)
    }

    /// The traction `sigma a^2/(f F_z)` at the radius rho/a (5.36), (5.37); it resists the twist.
    #[must_use]
    pub fn traction(&self, rho: f64) -> f64 {
        let kc = self.stick.get();
        if !(0.0..1.0).contains(&rho) {
            return 0.0;
        }
        let slip = 1.5 / PI * ((1.0 - rho) * (1.0 + rho)).sqrt();
        if rho >= kc {
            slip
        } else if kc >= SMALL_STICK {
            self.traction_of_large_stick(rho)
        } else if rho < 0.5 * kc {
            self.inner_traction(rho)
        } else {
            slip * self.bracket(rho)
        }
    }

    /// `(2/pi) [pi/2 + k^2 D F(k', theta_1) - K E(k', theta_1)]` of (5.37).
    fn bracket(&self, rho: f64) -> f64 {
        let kc = self.stick.get();
        let k = self.parameter.sqrt();
        // tan theta_1 = sqrt((k'^2 - rho^2)/(k^2 rho^2)) from (5.38).
        let opposite = ((kc - rho) * (kc + rho)).sqrt();
        let Ok(theta) = Amplitude::from_legs(opposite, k * rho) else { return 0.0 };
        let Ok(turned) = AxisRatio::new(k) else { return 0.0 };
        let difference = self.parameter * complete::d(self.stick);
        let bracket = difference * incomplete::f(turned, theta)
            - complete::k(self.stick) * incomplete::e(turned, theta);
        1.0 + 2.0 / PI * bracket
    }

    /// For little slip the traction is small and the bracket cancels. With s^2 = rho^2 + w^2 the
    /// superposition of adhesive twists is smooth: `rho int (2/pi) E/s^2 dw`.
    fn traction_of_large_stick(&self, rho: f64) -> f64 {
        let kc = self.stick.get();
        let lower = ((kc - rho) * (kc + rho)).sqrt();
        let upper = ((1.0 - rho) * (1.0 + rho)).sqrt();
        let length = self.parameter / (upper + lower);
        let sum: f64 = FINE
            .nodes()
            .iter()
            .map(|node| {
                let w = upper - 0.5 * length * (1.0 - node.position);
                let square = rho * rho + w * w;
                node.weight * AxisRatio::new(square.sqrt()).map_or(1.0, complete::e) / square
            })
            .sum();
        1.5 / PI * rho * (2.0 / PI) * 0.5 * length * sum
    }

    /// Well inside a small stick area the bracket cancels; the superposition of adhesive twists,
    /// `rho int bF ds/sqrt(s^2 - rho^2)` with `bF = (2/pi) E/s`, does not.
    fn inner_traction(&self, rho: f64) -> f64 {
        let lower = libm::log(self.stick.get());
        // In ln s the integrand decreases as 1/s: panels of a few e-foldings keep the Gauss rule
        // exact.
        let panels = (-lower / 4.0).ceil().max(1.0);
        let mut sum = 0.0;
        for panel in 0..panels as usize {
            let at = |i: usize| lower * (1.0 - i as f64 / panels);
            sum += FINE.integrate(at(panel), at(panel + 1), |u| {
                let s = libm::exp(u).min(1.0);
                let e = AxisRatio::new(s).map_or(1.0, complete::e);
                e / ((s - rho) * (s + rho)).sqrt()
            });
        }
        1.5 / PI * rho * (2.0 / PI) * sum
    }
}

/// The approximation (5.42), `(3 pi/16) [1 - exp(-256 beta/(9 pi))]`: at most 2.76 % of the
/// sliding torque, or 3.35 % of the torque itself, below Lubkin's.
#[must_use]
pub fn approximate_torque(twist: f64) -> f64 {
    -SLIDING_TORQUE * libm::expm1(-256.0 / (9.0 * PI) * twist)
}

/// v = -ln k' at which K - E has a given value. Since d(K - E)/dv = E, Newton steps from the left
/// stay there.
pub(crate) fn depth_of_twist(target: f64) -> f64 {
    // K - E < (pi/2) v, and for large v it is v + ln 4 - 1.
    let mut v = (target / (PI / 2.0)).max(target + 1.0 - 4.0_f64.ln());
    for _ in 0..40 {
        let state = Lubkin::at_depth(v);
        let value = state.parameter * complete::d(state.stick);
        let step = (target - value) / complete::e(state.stick);
        v += step;
        if step.abs() <= 4e-16 * v {
            break;
        }
    }
    v.max(0.0)
}

/// `(4/pi) int_k'^1 t^2 E(t) dt`, with the length of the interval computed from k^2.
fn moment_above(kc: f64, parameter: f64) -> f64 {
    let length = parameter / (1.0 + kc);
    let sum: f64 = RULE
        .nodes()
        .iter()
        .map(|node| {
            let t = 1.0 - 0.5 * length * (1.0 - node.position);
            node.weight * t * t * AxisRatio::new(t).map_or(0.0, complete::e)
        })
        .sum();
    2.0 / PI * length * sum
}

/// `(4/pi) int_0^k' t^2 E(t) dt`, integrated term by term from the series of E about k' = 0
/// (DLMF 19.12.2), for k' below [`SMALL_STICK`].
fn moment_below(kc: f64) -> f64 {
    let (square, logarithm) = (kc * kc, -libm::log(kc.max(f64::MIN_POSITIVE)));
    let series = BELOW
        .iter()
        .rev()
        .fold(0.0, |sum, term| sum * square + term.by_logarithm * logarithm + term.plain);
    4.0 / PI * (kc * square) * (1.0 / 3.0 + 0.5 * square * series)
}

/// A term of the series of [`moment_below`].
#[derive(Clone, Copy)]
struct Term {
    by_logarithm: f64,
    plain: f64,
}

/// Enough terms for k'^2 <= 0.16.
static BELOW: LazyLock<[Term; 22]> = LazyLock::new(|| {
    let mut terms = [Term { by_logarithm: 0.0, plain: 0.0 }; 22];
    let (mut factor, mut digamma) = (1.0, 2.0 * std::f64::consts::LN_2);
    let mut m = 0.0;
    for term in &mut terms {
        // int_0^k t^(2m+4) (-ln t + d) dt = k^(2m+5) [(-ln k + d)/(2m+5) + 1/(2m+5)^2]
        let power = 1.0 / (2.0 * m + 5.0);
        let pair = (2.0 * m + 1.0) * (2.0 * m + 2.0);
        let constant = digamma - 1.0 / pair;
        *term = Term { by_logarithm: factor * power, plain: factor * power * (constant + power) };
        digamma -= 2.0 / pair;
        factor *= (m + 0.5) * (m + 1.5) / ((m + 2.0) * (m + 1.0));
        m += 1.0;
    }
    terms
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways_to_the_torque_agree() {
        for i in 1..=600 {
            let kc = f64::from(i) / 600.0;
            let parameter = (1.0 - kc) * (1.0 + kc);
            if (0.3..0.6).contains(&kc) {
                // The series, still good to 1e-10 beyond its border, meets the quadrature.
                let sum = moment_below(kc) + moment_above(kc, parameter);
                let tolerance = if kc <= SMALL_STICK { 4e-16 } else { 1e-8 };
                assert!((sum - SLIDING_TORQUE).abs() < tolerance, "{kc}: {sum}");
            }
        }
    }
}
